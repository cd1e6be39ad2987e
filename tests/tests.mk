# tests.mk - what `make test` and teachers need; included by the Makefile.
#
# Every test writes lines "ok WHAT" or "FAIL WHAT: why" to a .result file; only
# the last recipe fails.  A test runs again when anything it rests on changed.

T := $(BUILD)/test
VERIFY = BUILD='$(BUILD)' sh tests/tools/verify.sh
.PHONY: test starters workbook programs units studies memcheck

# ---- starters, workbook -------------------------------------

starters: ; @BUILD='$(BUILD)' sh tests/tools/student.sh starters $(LESSONS)

# Starters as the solutions give them, whatever the student has in lessons/.
$(BUILD)/starters/%.c: solutions/%.c tests/tools/starter.awk
	$(Q)$(HERE) && awk -f tests/tools/starter.awk $< > $@
$(BUILD)/starters/%.judge: $(BUILD)/starters/%.c $$(call judge_of,$$*) $(LIB)
	$(Q)$(PLAIN) -Werror -fsyntax-only $<
	$(Q)$(call build_judge,$<,$*,-Werror -O0 -g0)

# A class at once: DIR holds one folder per student.
GRADE = exec env BUILD='$(BUILD)' LESSONS='$(LESSONS)' sh tests/tools/grade.sh
.PHONY: grade
grade: ; @$(SHARED)$(GRADE) class
$(BUILD)/grade/%/judged: ; @$(SHARED)$(GRADE) one $(@D)

# The book is filled from the tables of the solutions and of the studies.
BOOK := $(wildcard workbook.md lessons/*.md solutions/*.md figures/*/README.md)
DATA := $(patsubst %,$(BUILD)/data/%.tsv,$(LESSONS) $(EXAMPLES:=/example) $(COUNTED) \
            many/many)
workbook: $(DATA)
	@BUILD='$(BUILD)' sh tests/tools/workbook.sh fill
# of one lesson: only the data that its two files show
pages = $(wildcard lessons/$1.md solutions/$1.md)
shown = $(patsubst %,$(BUILD)/data/%.tsv,$(sort $(shell grep -ohE \
    '<!-- (table|n) [0-9a-z_/]+' /dev/null $(call pages,$1) | awk '{ print $$3 }')))
define workbook_rule
.PHONY: workbook-$(call number,$1)
workbook-$(call number,$1): $(if $(filter workbook-$(call \
        number,$1),$(MAKECMDGOALS)),$$$$(call shown,$1))
	@BUILD='$(BUILD)' sh tests/tools/workbook.sh fill $(call pages,$1)
	@BUILD='$(BUILD)' sh tests/tools/workbook.sh lead
endef
$(foreach l,$(LESSONS),$(eval $(call workbook_rule,$l)))

# ---- each lesson ------------------------------------------------------------

$(T)/%.solution.result: $(BUILD)/solutions/%.judge $(BUILD)/solutions/% \
                        tests/tools/verify.sh
	$(call say,test,$* solution)
	$(Q)$(HERE) && $(VERIFY) solution $* > $@
$(T)/%.starter.result: $(BUILD)/starters/%.judge $(BUILD)/solutions/% \
                       lessons/%.c tests/tools/verify.sh
	$(call say,test,$* starter)
	$(Q)$(HERE) && $(VERIFY) starter $* > $@
# Each known mistake and equivalent program is judged.  What the programs that its
# judge compares with print, with each of the lesson's options, is found out once.
# Nothing that a student asks for reads it.
$(T)/%.mistakes.result: $(BUILD)/mistakes/%/all.judge $(BUILD)/solutions/% \
                        $(BUILD)/solutions/%.judge tests/tools/verify.sh \
                        tests/tools/verify.awk
	$(call say,test,$* mistakes)
	$(Q)$(HERE) && $(VERIFY) mistakes $* > $@

KINDS = solution starter mistakes names

# what a student does, in one lesson that computes for longer than the TRIED one
$(T)/behave.result: $(BUILD)/solutions/13_backward_euler_2d.judge \
        $(BUILD)/solutions/13_backward_euler_2d $(JUDGE) $(LIB) \
        tests/tools/student.sh tests/tools/verify.sh Makefile
	$(call say,test,what a student does)
	$(SHARED)$(Q)$(HERE) && $(VERIFY) behave 13_backward_euler_2d > $@

define verify_rules
$(T)/$1.names.result: $(BUILD)/solutions/$1 $(BUILD)/solutions/$1.judge \
        $(JUDGE) tests/cli/names.sh $(AS_PROGRAM)
	$$(call say,test,$1 names)
	$(SHARED)$(Q)$$(HERE) && BUILD='$(BUILD)' sh tests/cli/names.sh $1 > $$@
.PHONY: verify-$(call number,$1)
verify-$(call number,$1): $(foreach k,$(KINDS),$(T)/$1.$k.result)
	@{ cat $$^; sh tests/tools/lint.sh $1; } | sh tests/tools/count.sh
endef
$(foreach l,$(LESSONS),$(eval $(call verify_rules,$l)))
.PHONY: lint
lint: ; @sh tests/tools/lint.sh | sh tests/tools/count.sh
# ---- unit laws of common/, and deliberate mistakes that they must catch -----

UNITS := $(patsubst tests/unit/%.c,%,$(filter-out %/unit.c,\
             $(wildcard tests/unit/*.c)))
ask_check    = $(shell pkg-config --cflags --libs check 2>/dev/null || echo -lcheck)
CHECK_CFLAGS = $(filter -I% -D% -pthread,$(call once,check))
CHECK_LIBS   = $(filter-out -I% -D%,$(call once,check))
UNIT_FLAGS = -I. -Itests/unit $(CHECK_CFLAGS)
UNIT_LIBS  = $(LIB) $(CHECK_LIBS) $(LIBS)
$(BUILD)/unit/%.o: tests/unit/%.c $(RULES)
	$(call say,cc,$<)
	$(Q)$(HERE) && $(COMPILE) $(QUICK) $(UNIT_FLAGS) $< $(OBJECT)
$(BUILD)/unit/%: $(BUILD)/unit/%.o $(BUILD)/unit/unit.o $(LIB)
	$(Q)$(CC) $(CFLAGS) $< $(BUILD)/unit/unit.o -o $@ $(UNIT_LIBS)
$(T)/unit.%.result: $(BUILD)/unit/%
	$(call say,test,unit $*)
	$(Q)$(HERE) && { $< > $@ || true; }

# Of each file those in it are compiled at once, and of the unit programs the laws
# alone are run that must catch them.
UNIT_MISTAKES := $(sort $(shell awk '$$1 == "file:" { file = $$2 } \
    $$1 == "caught-by:" { sub(/:/, "", $$2); print file "," $$2 }' tests/unit/mistakes.txt))
MISTAKEN := $(sort $(foreach m,$(UNIT_MISTAKES),$(firstword $(subst $(comma), ,$m))))
units_of = $(patsubst $1$(comma)%,%,$(filter $1$(comma)%,$(UNIT_MISTAKES)))
UNIT_RESULTS := $(MISTAKEN:%.c=$(T)/mistakes/%.result)
$(UNIT_RESULTS): $(T)/mistakes/%.result: %.c tests/unit/mistakes.txt $(LIB) \
        $(BUILD)/unit/unit.o \
        $$(addsuffix .o,$$(addprefix $(BUILD)/unit/,$$(call units_of,$$*.c))) \
        tests/tools/unit_mistakes.sh tests/tools/variant.awk
	$(call say,test,mistakes in $<)
	$(Q)$(HERE) && BUILD='$(BUILD)' LIBS='$(UNIT_LIBS)' \
	    COMPILE='$(call unwarned,$(PLAIN)) -O0 $(HASTY) -I$(<D)' \
	    sh tests/tools/unit_mistakes.sh $< $(basename $@) > $@

# ---- the whole, in other builds, and the closing line -----------------------

programs: $(PROGRAMS)
units: $(UNITS:%=$(BUILD)/unit/%)
studies: $(COUNTED:%=$(BUILD)/figures/%)

# Does a compiler warn?  LOOK says how far it goes; nothing is linked.  What it has
# SEEN already, for another purpose, has left its words in a file OBJECT.said.
LOOK = -fsyntax-only
SEEN =
HEADERS := $(wildcard common/*/*.h figures/*/*.h tests/*/*.h)
LOOKED := $(OBJECTS:$(BUILD)/%.o=%) $(LESSONS:%=solutions/%) \
          $(STUDIES:%=figures/%) $(UNITS:%=tests/unit/%) tests/unit/unit \
          $(JUDGE:$(BUILD)/tests/%.o=tests/checks/%) \
          $(LESSONS:%=tests/checks/%) $(LESSONS:%=$(BUILD)/starters/%)
LOOK_AT = $(PLAIN) $(UNIT_FLAGS) -Itests/checks -I. -DBUILD_FLAGS='""' \
          -DNATIVE_FLAGS='""' -DLAPACK='""' -Werror
$(BUILD)/looked/%: %.c $(HEADERS) Makefile
	$(Q)$(HERE) && $(LOOK_AT) $(call native_for,$(notdir $*)) $(LOOK) $< && : > $@
$(LESSONS:%=$(BUILD)/looked/tests/checks/%): $(BUILD)/looked/tests/checks/%: \
        tests/checks/%.c $(CHECKS)/%.h $(HEADERS) Makefile
	$(Q)$(HERE) && $(LOOK_AT) -DPROGRAM='"$(word 2,$^)"' $(LOOK) $< && : > $@
.PHONY: look
look: $(patsubst %,$(BUILD)/looked/%,$(filter-out $(SEEN),$(LOOKED)))

# what any test may rest on
EVERYTHING := Makefile $(wildcard *.md) $(BOOK) $(wildcard common/*/* solutions/*.c \
              lessons/*.c tests/*.mk tests/*/* figures/map.* figures/*.gp \
              figures/*/*.gp figures/*/*.[ch] figures/many/*.t*)
$(T)/lint.result: $(EVERYTHING)
	$(call say,test,lint)
	$(Q)$(HERE) && sh tests/tools/lint.sh > $@
$(T)/workbook.result: $(DATA) $(BOOK) tests/tools/workbook.awk solutions/*.c \
                      common/*/*.c
	$(call say,test,the book is in step with the programs)
	$(Q)$(HERE) && if said=$$(BUILD='$(BUILD)' sh \
	        tests/tools/workbook.sh check); \
	    then echo 'ok the book is in step with the programs'; \
	    else echo "FAIL workbook: $$said"; fi > $@
# The book and what was said when it was made, for both tests of its pages.
MADE := $(T)/made
$(MADE)/said: $(BOOK) tests/tools/book.sh
	$(Q)rm -rf $(@D) && $(HERE) && $(WHOLE) \
	    { BUILD=$(@D) sh tests/tools/book.sh > $(PART) 2>&1; $(MOVED); }
# where pandoc was missing, it is tried again
$(shell grep -ls '^book: install' $(MADE)/said 2>/dev/null): always
# The commands, each by its script; what it rests on beside the tools stands below.
CLI := $(filter-out names,$(patsubst tests/cli/%.sh,%,$(wildcard tests/cli/*.sh)))
CLI_RESULTS := $(CLI:%=$(T)/%.result)
$(CLI_RESULTS): $(T)/%.result: tests/cli/%.sh $(wildcard tests/tools/* tests/*.mk) Makefile
	$(call say,test,$*)
	$(SHARED)$(Q)$(HERE) && BUILD='$(BUILD)' $(CLI_ENV) sh $< > $@
$(T)/book.result $(T)/wide.result: $(MADE)/said
$(T)/bench.result: figures/speed/README.md
$(T)/form.result $(T)/new.result: $(wildcard tests/tools/skeleton/*)
$(T)/drawn.result: $(BUILD)/data/10_neohookean_bar/newton.tsv \
        $(BUILD)/data/13_backward_euler_2d/motion.tsv
$(T)/cli.result: $(PROGRAMS:=.judge) $(DATA) $(EVERYTHING)
$(T)/pictures.result: $(LESSONS:%=$(BUILD)/data/%.tsv) README.md lessons/02_constitutive.md \
        $(wildcard figures/*.* figures/*/*.gp figures/*/*.awk)
$(T)/cli.result $(T)/options.result: $(PROGRAMS)
# all on one lesson, the cheapest to judge
TRIED := 03_dirichlet_correction
$(patsubst %,$(T)/%.result,hostile grade habits elsewhere json limits new diff update): \
        $(JUDGE) $(BUILD)/solutions/$(TRIED) $(BUILD)/solutions/$(TRIED).judge \
        $(BUILD)/mistakes/$(TRIED)/all.judge
# those that copy the workbook (copy.sh)
$(patsubst %,$(T)/%.result,hostile grade habits json limits new diff cli \
    elsewhere update): $(LIB)
# and on what each lesson's own judge says of its data
$(T)/diff.result: $(PROGRAMS:=.judge) $(LESSONS:%=$(BUILD)/data/%.tsv) \
        figures/overlay.gp
$(T)/elsewhere.result: .gitattributes $(BUILD)/data/$(TRIED).tsv
$(T)/new.result: figures/map.awk *.md $(T)/lint.result
$(T)/hand.result: $(LIB) $(wildcard figures/*/hand.c) $(SCENES:%=solutions/%.c) \
        $(SCENES:%=tests/mistakes/%.txt)
$(T)/hand.result: CLI_ENV = SCENES='$(SCENES)' COMPILE='$(PLAIN) -Werror -O1 -g0' \
        OBJECTS='$(LIB)' LIBS='$(LIBS)'
# Every study's claim holds, and every figure is drawn from its data or can be: those
# in figures/ are left as they are.
define figure_test
$(T)/figure.$(subst /,.,$1).result: $(call data_of,$1) figures/$1.gp \
        figures/style.gp tests/tools/figure.sh
	$(Q)$$(HERE) && cp $(call picture,$1) $(T)/$(subst /,.,$(call picture,$1)) && \
	    if said=$$$$(sh tests/tools/figure.sh \
	        figures/$1.gp $$< $(T)/$(subst /,.,$(call picture,$1)) 2>&1); \
	    then echo 'ok figure $1'; else echo "FAIL figure $1: $$$$said"; fi > $$@
endef
DRAWN := $(filter-out $(BENCHED),$(SCRIPTS))
$(foreach f,$(DRAWN),$(eval $(call figure_test,$f)))
# Objects that are the same without the flags for this machine, where the others
# are those of the Makefile.
NOT_NATIVE = $(foreach o,$(OBJECTS),$(if $(strip $(call native_for,$(basename \
                 $(notdir $o)))),,$o))
ask_gcc = $(if $(SANITIZED)$(filter-out file,$(origin CFLAGS))$(findstring \
              clang,$(shell $(CC) --version)),,yes)
IS_GCC = $(call once,gcc)
READY = $(if $(IS_GCC),$(NOT_NATIVE) $(PROGRAMS:=.o))
# What gcc says of the main build it need not be asked for again.
SEEN_gcc = $(if $(IS_GCC),$(OBJECTS:$(BUILD)/%.o=%) $(PARTS:$(BUILD)/%=%) \
               $(UNITS:%=tests/unit/%) tests/unit/unit \
               $(JUDGE:$(BUILD)/tests/%.o=tests/checks/%) \
               $(LESSONS:%=tests/checks/%) $(LESSONS:%=$(BUILD)/gcc/starters/%))
SAID_gcc = $(if $(IS_GCC),$(patsubst %,%.said,$(OBJECTS) $(PARTS:=.o) $(JUDGE) \
               $(patsubst %,$(BUILD)/unit/%.o,$(UNITS) unit) \
               $(LESSONS:%=$(CHECKS)/%.s)))
VARIANTS = BUILD='$(BUILD)' READY='$(READY)' SEEN='$(SEEN_$*)' SAID='$(SAID_$*)' \
           sh tests/tools/build_variants.sh
$(T)/build-%.result: $(EVERYTHING)
	$(call say,test,$* build)
	$(SHARED)$(Q)$(HERE) && $(VARIANTS) $* > $@
# what was left out is tried again
$(shell grep -ls '^skip' $(T)/build-mac.result): always
$(T)/build-valgrind.result: $$(READY)
$(T)/build-gcc.result: $$(basename $$(SAID_gcc))

include tests/same.mk
WEB_TESTS := web-write web-live web-choose web-pictures web-mistakes
RESULTS := $(UNITS:%=$(T)/unit.%.result) $(UNIT_RESULTS) $(CLI_RESULTS) $(SAME_RESULTS) \
           $(foreach k,$(KINDS),$(LESSONS:%=$(T)/%.$k.result)) \
           $(patsubst %,$(T)/%.result,lint workbook behave many web-small web-pages web \
               web-judge web-panel web-student $(WEB_TESTS)) \
           $(foreach f,$(DRAWN),$(T)/figure.$(subst /,.,$f).result) \
           $(patsubst %,$(T)/build-%.result,gcc clang mac sanitize valgrind)
# First what is long, one after the other, or waits, while the rest computes; then
# what rests on all studies of another compiler; the many short ones come last, so
# that no processor is without one before the end.
FIRST = $(patsubst %,$(T)/%.result,build-valgrind hostile build-sanitize limits \
            web-live habits new update grade wide) $(SAME_RESULTS) \
        $(patsubst %,$(T)/%.result,cli diff json pictures book lint)
test: $(FIRST) $(RESULTS)
	@sh tests/tools/budget.sh table
	@cat $^ | sh tests/tools/count.sh

# all that computes for long, too
memcheck: $$(READY)
	$(SHARED)@for kind in sanitize valgrind; do $(VARIANTS) $$kind whole; done | \
	    sh tests/tools/count.sh

include tests/web.mk
include tests/web_live.mk
include tests/web_student.mk
include tests/many.mk
include tests/mutants.mk
