# tests.mk - what `make test` and teachers need; included by the Makefile.
#
# Every test writes lines "ok WHAT" or "FAIL WHAT: why" to a .result file; only
# the last recipe fails.  A test runs again when anything it rests on changed.

VERIFY = BUILD='$(BUILD)' sh tests/tools/verify.sh
.PHONY: test starters workbook programs units studies memcheck grade lint look \
        $(call goals,workbook verify)
# $(call RESULT,what is tested,command)
define RESULT
$(call say,test,$1)
$(SHARED)$(Q)$(HERE) && $2 > $@
endef

# ---- starters, workbook -------------------------------------

# The files of a new lesson: make new-27 NAME=spring
new-%:
	@sh tests/tools/new.sh '$*' '$(NAME)'
	@$(SHARED)$(MAKE) workbook-$* figures/$*_$(NAME)/order.svg
	@$(SHARED)$(MAKE) figures/map.svg
starters: ; @BUILD='$(BUILD)' sh tests/tools/student.sh starters $(LESSONS)
# Starters as the solutions give them, whatever the student has in lessons/.
$(BUILD)/starters/%.c: solutions/%.c tests/tools/starter.awk
	$(Q)$(HERE) && awk -f tests/tools/starter.awk $< > $@
$(BUILD)/starters/%.judge: $(BUILD)/starters/%.c $$(call judge_of,$$*) $(LIB)
	$(Q)$(PLAIN) -Werror -fsyntax-only $<
	$(Q)$(call build_judge,$<,$*,-Werror -O0 -g0)

# A class at once: DIR holds one folder per student.
GRADE = exec env BUILD='$(BUILD)' LESSONS='$(LESSONS)' sh tests/tools/grade.sh
grade: ; @$(SHARED)$(GRADE) class
$(BUILD)/grade/%/judged: ; @$(SHARED)$(GRADE) one $(@D)

# The book is filled from the tables of the solutions and of the studies.
BOOK := $(wildcard workbook.md lessons/*.md solutions/*.md figures/*/README.md)
DATA := $(patsubst %,$(BUILD)/data/%.tsv,$(LESSONS) $(EXAMPLES:=/example) $(COUNTED) \
            many/many)
FILL  = BUILD='$(BUILD)' sh tests/tools/workbook.sh
workbook: $(DATA)
	@$(FILL) fill
# of one lesson: only the data that its two files show
pages = $(wildcard lessons/$1.md solutions/$1.md)
shown = $(patsubst %,$(BUILD)/data/%.tsv,$(sort $(shell grep -ohE \
    '<!-- (table|n) [0-9a-z_/]+' /dev/null $(call pages,$1) | awk '{ print $$3 }')))
$(call goals,workbook): $$(call shown,$$(call lesson,$$@))
	@$(FILL) fill $(call pages,$(call lesson,$@))
	@$(FILL) lead

# ---- each lesson ------------------------------------------------------------

KINDS := solution starter mistakes names
$(T)/%.solution.result: $(BUILD)/solutions/%.judge $(BUILD)/solutions/% tests/tools/verify.sh
	$(call RESULT,$* solution,$(VERIFY) solution $*)
$(T)/%.starter.result: $(BUILD)/starters/%.judge $(BUILD)/solutions/% lessons/%.c \
        tests/tools/verify.sh
	$(call RESULT,$* starter,$(VERIFY) starter $*)
# Each known mistake and equivalent program is judged.  What the programs that its
# judge compares with print, with each of the lesson's options, is found out once.
$(T)/%.mistakes.result: $(BUILD)/mistakes/%/all.judge $(BUILD)/solutions/% \
        $(BUILD)/solutions/%.judge tests/tools/verify.sh tests/tools/verify.awk
	$(call RESULT,$* mistakes,$(VERIFY) mistakes $*)
$(T)/%.names.result: $(BUILD)/solutions/%.judge $(BUILD)/solutions/% tests/cli/names.sh \
        $$(call judge_of,$$*)
	$(call RESULT,$* names,BUILD='$(BUILD)' sh tests/cli/names.sh $*)
$(call goals,verify): $$(addprefix $(T)/$$(call lesson,$$@),$(KINDS:%=.%.result))
	@{ cat $^; sh tests/tools/lint.sh $(call lesson,$@); } | sh tests/tools/count.sh
lint: ; @sh tests/tools/lint.sh | sh tests/tools/count.sh
# what a student does, in one lesson that computes for longer than the TRIED one
$(T)/behave.result: $(BUILD)/solutions/13_backward_euler_2d.judge $(JUDGE) $(LIB) \
        $(BUILD)/solutions/13_backward_euler_2d tests/tools/student.sh \
        tests/tools/verify.sh Makefile
	$(call RESULT,what a student does,$(VERIFY) behave 13_backward_euler_2d)

# ---- unit laws of common/, and deliberate mistakes that they must catch -----

UNITS := $(filter-out unit,$(patsubst tests/unit/%.c,%,$(wildcard tests/unit/*.c)))
UNIT_FLAGS = -I. -Itests/unit $(CHECK_CFLAGS)
UNIT_LIBS  = $(BUILD)/libchoose.a $(LIB) $(filter-out -I% -D%,$(call once,check)) $(LIBS)
CHECK_CFLAGS = $(filter -I% -D% -pthread,$(call once,check))
$(BUILD)/unit/%.o: OWN = $(QUICK) $(UNIT_FLAGS)
$(BUILD)/unit/%.o: tests/unit/%.c $(RULES)
	$(COMPILED)
$(BUILD)/unit/%: $(BUILD)/unit/%.o $(BUILD)/unit/unit.o $(LIB) $(BUILD)/libchoose.a
	$(Q)$(CC) $(CFLAGS) $< $(BUILD)/unit/unit.o -o $@ $(UNIT_LIBS)
$(T)/unit.%.result: $(BUILD)/unit/%
	$(call RESULT,unit $*,{ $< || true; })

# Of each file those in it are compiled at once, and of the unit programs the laws
# alone are run that must catch them.
UNIT_RESULTS := $(patsubst %.c,$(T)/mistakes/%.result,$(sort $(shell sed -n 's/^file: *//p' \
                    tests/unit/mistakes.txt)))
$(UNIT_RESULTS): $(T)/mistakes/%.result: %.c tests/unit/mistakes.txt $(LIB) $(BUILD)/libchoose.a \
        $(patsubst %,$(BUILD)/unit/%.o,$(UNITS) unit) tests/tools/unit_mistakes.sh \
        tests/tools/variant.awk
	$(call RESULT,mistakes in $<,BUILD='$(BUILD)' LIBS='$(UNIT_LIBS)' \
	    COMPILE='$(PLAIN) -O0 $(HASTY) -I$(<D)' \
	    sh tests/tools/unit_mistakes.sh $< $(basename $@))

# ---- the tree, the book, the commands -----------------------------------------------

# what any test may rest on
EVERYTHING := Makefile $(wildcard *.md) $(BOOK) $(wildcard common/*/* solutions/*.c \
              lessons/*.c lessons/choose/* tests/*.mk tests/*/* figures/*.* \
              figures/*/*.gp figures/*/*.awk figures/*/*.[ch] figures/many/*.t*)
$(T)/lint.result: $(EVERYTHING)
	$(call RESULT,lint,sh tests/tools/lint.sh)
$(T)/workbook.result: $(DATA) $(BOOK) tests/tools/workbook.awk solutions/*.c common/*/*.c
	$(call RESULT,the book is in step with the programs,$(VERIFY) book)
# The book and what was said when it was made, for both tests of its pages; where
# pandoc was missing, it is tried again.
MADE := $(T)/made
$(MADE)/said: $(BOOK) tests/tools/book.sh
	$(Q)rm -rf $(@D) && $(HERE) && $(WHOLE) \
	    { BUILD=$(@D) sh tests/tools/book.sh > $(PART) 2>&1; $(MOVED); }
$(shell grep -ls '^book: install' $(MADE)/said 2>/dev/null): always
# Every figure is drawn from its data or can be: those in figures/ are left as they are.
$(DRAWN:%=$(T)/figures/%.result): $(T)/figures/%.result: figures/%.gp $$(call data_of,$$*) \
        figures/style.gp tests/tools/figure.sh
	$(Q)$(HERE) && $(VERIFY) figure $(call picture,$*) $(word 2,$^) > $@

# The commands, each by its script, most of them on one lesson, the cheapest to judge,
# in a copy of the workbook (copy.sh).  What others rest on stands below.
results = $(patsubst %,$(T)/%.result,$1)
CLI := $(filter-out names,$(patsubst tests/cli/%.sh,%,$(wildcard tests/cli/*.sh)))
TRIED := 03_dirichlet_correction
$(call results,$(CLI)): $(T)/%.result: tests/cli/%.sh $(wildcard tests/tools/* tests/*.mk \
        tests/tools/skeleton/*) Makefile $(LIB) $(JUDGE) $(BUILD)/data/$(TRIED).tsv \
        $(BUILD)/solutions/$(TRIED).judge $(BUILD)/mistakes/$(TRIED)/all.judge
	$(call RESULT,$*,BUILD='$(BUILD)' $(CLI_ENV) sh $<)
$(call results,book wide): $(MADE)/said
$(call results,cli diff options pictures): $(PROGRAMS:=.judge) $(LESSONS:%=$(BUILD)/data/%.tsv)
$(call results,cli bench diff elsewhere hand new pictures): $(EVERYTHING) .gitattributes
$(call results,cli drawn): $(DATA)
$(T)/new.result: $(T)/lint.result
$(T)/hand.result: CLI_ENV = SCENES='$(SCENES)' COMPILE='$(PLAIN) -Werror -O1 -g0' \
        OBJECTS='$(LIB)' LIBS='$(LIBS)'

# ---- the whole, in other builds, and the closing line -----------------------

programs: $(PROGRAMS)
units: $(UNITS:%=$(BUILD)/unit/%)
studies: $(COUNTED:%=$(BUILD)/figures/%)

# Does another compiler warn?  LOOK says how far it goes; nothing is linked.
LOOK = -fsyntax-only
HEADERS := $(wildcard common/*/*.h lessons/choose/*.h figures/*/*.h tests/*/*.h)
LOOKED = $(patsubst $(BUILD)/%.o,%,$(OBJECTS) $(CHOOSE)) $(LESSONS:%=solutions/%) \
         $(STUDIES:%=figures/%) $(UNITS:%=tests/unit/%) tests/unit/unit \
         $(JUDGE:$(BUILD)/%.o=%) $(LESSONS:%=tests/checks/%) \
         $(LESSONS:%=$(BUILD)/starters/%)
$(LESSONS:%=$(BUILD)/looked/tests/checks/%): $(BUILD)/looked/tests/checks/%: $(CHECKS)/%.h
$(BUILD)/looked/%: %.c $(HEADERS) Makefile
	$(Q)$(HERE) && $(PLAIN) $(UNIT_FLAGS) -Itests/checks -DBUILD_FLAGS='""' \
	    -DNATIVE_FLAGS='""' -DLAPACK='""' -Werror \
	    $(if $(filter tests/checks/%,$*),-DPROGRAM='"$(CHECKS)/$(notdir $*).h"') \
	    $(call native_for,$(notdir $*)) $(LOOK) $< && : > $@
look: $$(addprefix $(BUILD)/looked/,$$(LOOKED))

# READY are the objects without flags for this machine, which other builds need not
# compile again, SAID what the compiler has said of the main build.
READY = $(foreach o,$(OBJECTS),$(if $(strip $(call native_for,$(basename $(notdir $o)))),,$o)) \
        $(CHOOSE) $(PROGRAMS:=.o) $(OWN_PROGRAMS:=.o)
HEARD := $(OBJECTS) $(CHOOSE) $(PROGRAMS:=.o) $(OWN_PROGRAMS:=.o) $(JUDGE) $(LESSONS:%=$(CHECKS)/%.s) \
         $(patsubst %,$(BUILD)/unit/%.o,$(UNITS) unit)
VARIANTS = BUILD='$(BUILD)' READY='$(READY)' SAID='$(HEARD:=.said)' \
           REST='$(SPEED:%=figures/%)' sh tests/tools/build_variants.sh
$(T)/build-%.result: $(EVERYTHING)
	$(call RESULT,$* build,$(VARIANTS) $*)
$(T)/build-main.result: $(HEARD)
$(T)/build-valgrind.result: $$(READY)

include tests/same.mk
include tests/web.mk
include tests/many.mk
# What has failed is tried again, and what was left out: its tools may be there now.
$(shell grep -lsE '^(FAIL |skip (mac|web|many: no))' $(T)/*.result): always
RESULTS := $(UNITS:%=$(T)/unit.%.result) $(UNIT_RESULTS) $(SAME_RESULTS) \
           $(foreach k,$(KINDS),$(LESSONS:%=$(T)/%.$k.result)) \
           $(DRAWN:%=$(T)/figures/%.result) \
           $(call results,$(CLI) lint workbook behave many $(addprefix build-,main \
               clang mac sanitize valgrind)) $(WEB_RESULTS)
# First what is long, one after the other, or waits, while the rest computes; then
# what rests on all studies of another compiler; the many short ones come last, so
# that no processor is without one before the end.
FIRST = $(call results,build-valgrind hostile build-sanitize limits web-live habits new \
            update grade wide) $(SAME_RESULTS) $(call results,cli diff json pictures book lint)
test: $(FIRST) $(RESULTS)
	@sh tests/tools/budget.sh table
	@cat $^ | sh tests/tools/count.sh

# all that computes for long, too
memcheck: $$(READY)
	$(SHARED)@for kind in sanitize valgrind; do $(VARIANTS) $$kind whole; done | \
	    sh tests/tools/count.sh

include tests/mutants.mk
