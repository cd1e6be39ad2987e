# Elasticity Workbook.  `make` alone says what there is (tests/tools/goals.txt).
#
# Not recursive; everything is compiled under build/.  solutions/NN_slug.c makes NN a
# lesson, and figures/NN_slug/what.c makes what a study: both are found by wildcard.
# tests/course.mk has studies and pictures, tests/tests.mk what only `make test` needs.
# V=1 shows the commands; CC, CFLAGS, LDFLAGS and NATIVE may be given, and others than
# the last time build anew.

# Numbers have a decimal point, whatever the user's language is.
export LC_ALL := C
BUILD ?= build

# Goals that install come first, and then another make for the others, which asks
# anew what there is: of the rest of this file the first reads nothing.
INSTALL := $(sort $(filter deps deps-web deps-many,$(MAKECMDGOALS)))
ifneq ($(INSTALL),)
THEN := $(filter-out $(INSTALL),$(MAKECMDGOALS))
.NOTPARALLEL:
.PHONY: then $(INSTALL) $(THEN)
$(INSTALL): ; @sh tests/tools/$(subst -,_,$@).sh
then: $(INSTALL)
	@exec "$(MAKE)" $(THEN)
$(sort $(THEN)): then ; @:
else

# ---- a lesson -------------------------------------------------------------------

LESSONS := $(sort $(basename $(notdir $(wildcard solutions/[0-9][0-9]_*.c))))
number   = $(firstword $(subst _, ,$1))
NUMBERS := $(foreach l,$(LESSONS),$(call number,$l))
# $(call goals,check hint): check-01 hint-01 check-02 ...; of one its verb and lesson
goals    = $(foreach n,$(NUMBERS),$(1:=-$n))
verb     = $(firstword $(subst -, ,$1))
lesson   = $(filter $(lastword $(subst -, ,$1))_%,$(LESSONS))
# exec: a signal to make's child is one to the script
STUDENT  = exec env BUILD='$(BUILD)' FORCE='$(FORCE)' sh tests/tools/student.sh

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SECONDARY:
.SECONDEXPANSION:
.SUFFIXES:
.PHONY: help status check update clean gsl always live choose $(call goals,lesson check \
        hint plot diff solution reset watch debug mistakes)

# make lesson-07: the student's program, with what it needs of the library
$(call goals,lesson): $(BUILD)/mine/$$(call lesson,$$@)
	@$(STUDENT) run $(call lesson,$@)
$(BUILD)/mine/%: lessons/%.c $$(call needs,lessons/$$*.c)
	$(call say,cc,$<)
	@[ -f $< ] || { echo '$< is not a plain file.' >&2; exit 1; }
	$(Q)$(HERE) && $(COMPILE) $< $(PLACED)
# A program that is built does not stand for a file that is not there.
MISSING := $(filter-out $(wildcard lessons/*.c),$(LESSONS:%=lessons/%.c))
.PHONY: $(MISSING)
$(MISSING):
	@echo '$@ is not there; it comes back with: make reset-$(call number,$(@F))' >&2; exit 1

$(call goals,check watch debug hint solution reset):
	@$(SHARED)$(STUDENT) $(call verb,$@) $(call lesson,$@)
$(call goals,plot diff): $$(foreach l,$$(call lesson,$$@),$(BUILD)/mine/$$l \
        $(BUILD)/solutions/$$l $(BUILD)/solutions/$$l.judge $$(if \
        $$(ARGS),,$(BUILD)/data/$$l.tsv))
	@$(STUDENT) $(call verb,$@) $(call lesson,$@)
$(call goals,mistakes): $(BUILD)/mistakes/$$(call lesson,$$@)/all.judge
status check: ; @$(SHARED)$(STUDENT) $@
# of the version before where one took tests/ away and was killed
update: ; @exec sh $(firstword $(wildcard tests/tools/update.sh \
            saved/*/old/tests/tools/update.sh))
help:
	@sed -e '/^---/,$$d' -e 's|BUILD|$(BUILD)|' -e 's|SCENES|$(foreach \
	    l,$(SCENES),$(call number,$l))|' tests/tools/goals.txt

# Lesson 24 in a window; then a lesson's own slots, in the scene figures/NN_slug/hand.c.
SCENES := $(patsubst figures/%/hand.c,%,$(wildcard figures/*/hand.c))
HELD   := $(foreach l,$(SCENES),live-$(call number,$l))
HAND    = exec env BUILD='$(BUILD)' COMPILE='$(PLAIN)' OBJECTS='$^' LIBS='$(LIBS)' \
          FORCE='$(FORCE)' sh tests/tools/hand.sh
.PHONY: $(HELD)
live: $$(LIB)
	@$(HAND) live
$(HELD): $$(sort $$(foreach f,solutions/$$(call lesson,$$@).c figures/$$(call \
        lesson,$$@)/hand.c,$$(call needs,$$f)))
	@$(HAND) $(call lesson,$@)
live-%:
	@echo 'There is no live-$*; what can be held in the hand: $(HELD) live' >&2; exit 2
# The least model for a scene of one's own, by the library's ladder.
choose: $(BUILD)/choose
	$(if $(filter command,$(origin VERIFY)),$(error make choose takes VERIFIED=yes))
	@exec env BUILD='$(BUILD)' sh tests/tools/choose.sh

# ---- flags ----------------------------------------------------------------------

# $(call once,WHAT): what ask.sh says, asked when it is first needed.  make 3.81
# crashes where a variable is changed while it is expanded.
once = $(if $(filter undefined,$(origin said_$1)),$(eval \
           said_$1 := $$(shell CC='$$(CC)' sh tests/tools/ask.sh $1)))$(said_$1)
CFLAGS  ?= -O2 -g
STRICT  := -Wall -Wextra -Wpedantic -Wshadow -Wconversion \
           -Wstrict-prototypes -Wmissing-prototypes
STD     := -std=c17 -D_POSIX_C_SOURCE=200809L -ffp-contract=off
GSL_CFLAGS = $(filter -I% -D%,$(call once,gsl))
GSL_LIBS   = $(or $(filter-out -I% -D%,$(call once,gsl)),-lgsl -lgslcblas -lm)
# Flags for tiles.c, front.c, readable.c, and EXACT, where they count.  They make the
# build one for this machine; `make clean` and NATIVE= give one for any.
ALL_NATIVE = $(call once,native)
ifeq ($(origin NATIVE),undefined)
NATIVE = $(ALL_NATIVE)
endif
# A solver that may not see a NaN is told so in one line.
GIVEN_NATIVE = $(if $(filter file undefined,$(origin NATIVE)),,NATIVE=$(NATIVE))
ifneq ($(filter -Ofast -ffast-math -ffinite-math-only -funsafe-math-%,$(CC) \
      $(CFLAGS) $(LDFLAGS) $(subst NATIVE=,,$(GIVEN_NATIVE))),)
$(error no -ffast-math or -Ofast here: the programs find NaN and infinity by comparing)
endif
# EXACT go without the last flag, so that their digits are the same everywhere, and
# without pairs made of lines that stand one after the other, which gcc 12 contracts
# all the same.  tiles.c and front.c are as fast with less than -O3, have the same
# digits, and compile in two thirds of the time; banded.c has its digits with any.
EXACT := body triangles lanes particles particle_force
same_digits = $(filter-out -ffp-contract=fast,$1) -fno-tree-slp-vectorize
native_for = $(if $(filter readable,$1),$(NATIVE)) \
             $(if $(filter tiles front,$1),$(patsubst -O3,$(call once,less),$(NATIVE))) \
             $(if $(filter $(EXACT),$1),$(call same_digits,$(NATIVE))) \
             $(if $(filter banded,$1),$(if $(NATIVE),$(call once,less)))
comma := ,
# what a label of seconds says of these
FAST = $(if $(NATIVE),$(comma) kernels $(filter -O3 -march=native,$(NATIVE)))
# Nobody steps through the library or a study: `make debug-NN` compiles its own.  What
# runs for a moment, or lets the library compute, is compiled with -O1.
BARE   := $(if $(filter file,$(origin CFLAGS)),-g0)
QUICK  := $(if $(BARE),-O1 -g0)
PLAIN   = $(CC) $(STD) $(STRICT) $(CFLAGS) -Icommon $(GSL_CFLAGS)
FAST_LD = $(call once,linker)
LIBS    = $(LDFLAGS) $(FAST_LD) $(GSL_LIBS)
LINK    = $(LIB) $(LIBS)

# What is made is moved to its place when it is whole: another make may be
# reading or running the old one.  A signal leaves no half of it.
PART    = $@.$$$$.part
WHOLE   = trap 'rm -f $(PART) $(PART).said' 0; trap 'exit 130' 1 2 15;
MOVED   = mv -f $(PART) $@ && trap - 0
HERE    = [ -d $(@D) ] || mkdir -p $(@D)
COMPILE = $(WHOLE) $(PLAIN) -MMD -MP -MF $@.d -MT $@
PLACED  = -o $(PART) $(filter %.o %.a,$^) $(LIBS) && $(MOVED)
# What the compiler says of an object stays in OBJECT.said: a test reads it.
SAID    = -o $(PART) 2> $(PART).said; status=$$?; \
          [ ! -s $(PART).said ] || cat $(PART).said >&2; \
          [ $$status = 0 ] && mv -f $(PART).said $@.said && $(MOVED)
Q      := $(if $(V),,@)
say     = $(if $(V),,@printf '  %-8s %s\n' '$1' '$2')
# the recipes of objects, of programs, and of what a program prints
define COMPILED
$(call say,cc,$<)
$(Q)$(HERE) && $(COMPILE) $(OWN) $< -c $(SAID)
endef
LINKED = $(Q)$(WHOLE) $(CC) $(CFLAGS) $(CHECKED) $(PLACED)
define PRINTED
$(call say,run,$(@:$(BUILD)/data/%.tsv=%))
$(Q)$(HERE) && $(WHOLE) $1 > $(PART) && $(MOVED)
endef

# Thousands of rules are for studies, pictures, tests and teachers; what a student
# asks for does without them, and answers at once.
NO_PROGRAM := help status update alone check check-% hint-% solution-% reset-% watch-% \
              debug-%
LINKS := $(filter-out $(NO_PROGRAM),$(MAKECMDGOALS))
FOR_STUDENT := $(if $(filter-out lesson-% plot-% diff-% mistakes-% live live-% choose \
                   $(if $(INTO),$(INTO) $(BUILD)/solutions/$(SLUG)%),$(LINKS)),,yes)

# What all objects were compiled with: with other words they are compiled anew.
# A test with ANY_FLAGS=1 takes them as they are.
FLAGS := $(strip $(CC) $(STD) $(STRICT) $(CFLAGS) $(LDFLAGS) $(GIVEN_NATIVE))
ifeq ($(ANY_FLAGS),)
ifneq ($(FLAGS),$(strip $(if $(wildcard $(BUILD)/flags),$(shell cat $(BUILD)/flags))))
OTHER_FLAGS := always
endif
endif
RULES := Makefile $(BUILD)/flags
# Where gsl-config is missing, GSL is looked for before anything is compiled.
$(BUILD)/flags: $(OTHER_FLAGS) | $(if $(LINKS),$(if $(GSL_CFLAGS),,gsl))
	$(Q)$(HERE) && $(WHOLE) printf '%s\n' '$(subst ','\'',$(FLAGS))' > $(PART) && $(MOVED)
gsl:
	@echo '#include <gsl/gsl_math.h>' | $(CC) -E - > /dev/null 2>&1 || { \
	    echo 'GSL is not found; it comes with: make deps' >&2; exit 1; }

# ---- library and programs ---------------------------------------------------------

# A program is linked with the objects whose headers it reaches (needs.awk), so that the
# first lesson does not wait for all; tests are linked with the library, which has all
# but what needs SDL2 or a page, and with what `make choose` is made of.  In figures/ a
# file with a header of its name is what several studies share.  Before GNU make 4.3 a #
# within a function begins a comment.
hash := \#
NEEDS := $(if $(LINKS),$(shell find -L common figures solutions lessons tests -type f \
             -name '*.[ch]' -exec grep -H '^$(hash)include "' {} + | awk \
             -v asked='$(if $(INTO),$(filter lessons/%,$(FILE)) tests/checks/$(SLUG).c \
             solutions/$(SLUG).c)' -f tests/tools/needs.awk))
needs = $(addprefix $(BUILD)/,$(subst $(comma), ,$(patsubst $1=%,%,$(filter \
            $1=%,$(NEEDS)))))
SHARED_BY_STUDIES := $(filter $(patsubst %.h,%.c,$(wildcard figures/*/*.h)), \
                         $(wildcard figures/*/*.c))
LIB     := $(BUILD)/libworkbook.a
OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(SHARED_BY_STUDIES) $(filter-out %/view_sdl.c \
               %/window_web.c,$(wildcard common/*/*.c)))
CHOOSE  := $(patsubst %.h,$(BUILD)/%.o,$(wildcard lessons/choose/*.h))
PROGRAMS := $(LESSONS:%=$(BUILD)/solutions/%)
# A judge is a lesson's checks with the judged program compiled in.
JUDGE := $(patsubst %,$(BUILD)/tests/checks/%.o,judge diagnose report verdict compare \
             cells tables claims guard output predict child confine sight kept)
$(LIB): $(OBJECTS)
$(BUILD)/libchoose.a: $(CHOOSE)
$(LIB) $(BUILD)/libchoose.a:
	$(call say,lib,$@)
	$(Q)$(WHOLE) ar rcs $(PART) $^ && $(MOVED)

# Solutions are compiled and linked by themselves: `make test` links them with other
# libraries, and with sanitizers, CHECKED.
$(OBJECTS): OWN = -DBUILD_FLAGS='"$(CFLAGS)$(FAST)"' $(BARE) $(call native_for,$(notdir $*))
$(JUDGE): OWN = $(QUICK) -Itests/checks
$(CHOOSE) $(PROGRAMS:=.o): OWN = $(or $(CHECKED),$(BARE))
$(OBJECTS) $(CHOOSE) $(JUDGE) $(PROGRAMS:=.o): $(BUILD)/%.o: %.c $(RULES)
	$(COMPILED)
$(PROGRAMS): $(BUILD)/%: $(BUILD)/%.o $$(call needs,$$*.c)
	$(LINKED)
$(BUILD)/choose: lessons/choose/choose.c $$(call needs,lessons/choose/choose.c)
	$(Q)$(COMPILE) $< $(PLACED)
$(LESSONS:%=$(BUILD)/data/%.tsv): $(BUILD)/data/%.tsv: $(BUILD)/solutions/%
	$(call PRINTED,$<)

# The checks of a lesson are compiled once, against the functions of its solution.
# judge.h guards the arrays that the checks hand over; BOUNDS are the compiler's own.
CHECKS := $(BUILD)/checks
BOUNDS  = $(call once,bounds)
CONTRACT = awk -f tests/tools/contract.awk
$(CHECKS)/%.h: solutions/%.c tests/tools/contract.awk
	$(Q)$(HERE) && $(WHOLE) $(CONTRACT) $< > $(PART) && $(MOVED)
$(CHECKS)/%.s: tests/checks/%.c $(CHECKS)/%.h $(RULES)
	$(call say,cc,$<)
	$(Q)$(COMPILE) $(QUICK) $(BOUNDS) -fno-lto -I. -Itests/checks \
	    -DPROGRAM='"$(word 2,$^)"' $< -S $(SAID)
$(CHECKS)/%.calls: $(CHECKS)/%.s solutions/%.c tests/tools/contract.awk
	$(Q)$(WHOLE) $(CONTRACT) calls=1 $< solutions/$*.c > $(PART) && $(MOVED)
$(CHECKS)/%.o: $(CHECKS)/%.s
	$(Q)$(WHOLE) $(CC) $(CFLAGS) -c $< -o $(PART) && $(MOVED)
# what is the linker's already, where nm says so
$(CHECKS)/%.words: $(JUDGE) $$(call needs,solutions/$$*.c)
	$(Q)$(HERE) && $(WHOLE) { nm -gP $(JUDGE) && echo library && \
	    nm -gP $(filter-out $(JUDGE),$^); } 2>/dev/null | \
	    awk -f tests/tools/words.awk > $(PART) && $(MOVED)

# A judge is these, with the program, which is compiled alone.
# $(call build_judge,program to judge,NN_slug,more flags)
judge_of = $(CHECKS)/$1.o $(CHECKS)/$1.calls $(CHECKS)/$1.words $(JUDGE) \
           $(addprefix tests/tools/,program.sh program.awk assembler.awk)
build_judge = COMPILER='$(PLAIN) $(BOUNDS) $3' \
    BUILD='$(BUILD)' sh tests/tools/program.sh '$1' $2 $@ && $(WHOLE) $(CC) \
    $(CFLAGS) $3 $@.s $$([ -f $@.o ] && echo $@.o || echo $(CHECKS)/$2.o) -o $(PART) \
    $(filter-out $(CHECKS)/%,$(filter %.o %.a,$^)) $(LIBS) && $(MOVED)
$(BUILD)/solutions/%.judge: solutions/%.c $$(call judge_of,$$*) \
        $$(call needs,solutions/$$*.c) $$(call needs,tests/checks/$$*.c)
	$(call say,judge,$<)
	$(Q)$(HERE) && $(call build_judge,$<,$*,$(QUICK))

# Known mistakes and equivalent programs of a lesson (tests/mistakes/NN_slug.txt):
# all.judge has them all, for they differ in a few functions.  NAME is one of them
# as a program, NAME.judge its judge, NAME.why what the student is told, after the
# check that catches it.  They are compiled as quickly as can be, with -O1 where
# they compute for long, and without warnings.  Where an entry does not fit the
# solution any more, there is none, and lint says why.
LONG := 18_% 22_%
HASTY = -g0 -w -Wl,-S
$(LESSONS:%=$(BUILD)/mistakes/%/all.c): $(BUILD)/mistakes/%/all.c: \
        tests/mistakes/%.txt solutions/%.c tests/tools/variant.awk
	$(Q)mkdir -p $(@D) $(PART) && trap 'rm -rf $(PART)' 0; trap 'exit 130' 1 2 15; \
	    awk -f tests/tools/variant.awk -v all=$(PART) $< solutions/$*.c > $(PART)/list && \
	    chmod +x $(PART)/* && rm -f $(@D)/*.why && mv -f $(PART)/* $(@D)
$(BUILD)/mistakes/%/all.judge: $(BUILD)/mistakes/%/all.c $$(call judge_of,$$*) \
        $$(call needs,solutions/$$*.c) $$(call needs,tests/checks/$$*.c)
	$(call say,judge,tests/mistakes/$*.txt)
	$(Q)$(call build_judge,$<,$*,$(if $(filter $(LONG),$*),-O1,-O0) $(HASTY))

# For student.sh: a judge INTO of any FILE of lesson SLUG, and whether FILE
# compiles by itself.
.PHONY: alone
alone:
	$(Q)$(PLAIN) -fsyntax-only $(FILE)
ifneq ($(INTO),)
$(INTO): $(call judge_of,$(SLUG)) $(if $(filter lessons/%,$(FILE)),$(call \
         needs,$(FILE)) $(call needs,tests/checks/$(SLUG).c),$(LIB))
	$(Q)$(call build_judge,$(FILE),$(SLUG),$(QUICK))
endif

# Progress and replaced files of the student stay, and what was fetched.
clean:
	@for f in $(BUILD)/*; do case $$f in \
	    */progress|*/saved|*/source) ;; *) rm -rf "$$f" ;; esac; done

# A goal that there is not: what may have been meant.  A file that is missing is
# make's to name; .DEFAULT would hide by whom it is needed, so it is there only
# when a goal is none of these.
GOALS := $(if $(MAKECMDGOALS),$(shell sed -n -e 's/^  make \([^ ]*\).*/\1/p' \
             -e '1,/^---/d' -e p tests/tools/goals.txt | sed 's/-[0-9][0-9]*/-%/g'))
WANT = @awk -v goal='$@' -v lessons='$(LESSONS)' -f tests/tools/goal.awk \
       tests/tools/goals.txt >&2; exit 2
$(sort $(filter-out figure-% new-% live-%,$(filter %-%,$(GOALS)))): ; $(WANT)
ifneq ($(filter-out $(GOALS),$(foreach g,$(MAKECMDGOALS),$(if $(findstring \
      /,$g)$(findstring .,$g),,$g))),)
.DEFAULT: ; $(WANT)
endif

export CC MAKE
# A judged program with a sanitizer needs all addresses.
export SANITIZED := $(findstring -fsanitize=,$(CC) $(CFLAGS) $(LDFLAGS))
# A recipe that runs make shares its jobs; `make -n` prints it and no more.
SHARED := $(if $(findstring n,$(filter-out --%,$(firstword -$(MAKEFLAGS)))),,+)
ifneq ($(FOR_STUDENT),)
ifneq ($(LINKS),)
-include $(wildcard $(BUILD)/*/*.d $(BUILD)/mistakes/*/*.d $(OBJECTS:=.d) $(CHOOSE:=.d))
endif
else
-include $(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d $(BUILD)/was[im]/*/*/*.d)
include tests/course.mk
include tests/tests.mk
endif
endif

# ---- how make is called -------------------------------------------------------------

# A job for each processor; of the tests several wait, for a loop's end or a
# sleeper, so they get two more.
ifeq ($(MAKELEVEL)$(filter -j%,$(MAKEFLAGS)),0)
JOBS := $(shell echo $$(($$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)$(if \
            $(filter test,$(MAKECMDGOALS)), + 2))))
MAKEFLAGS += -j$(JOBS)
endif
MAKEFLAGS += --no-print-directory

# What may be given, with which goals; with any other it is an error.  It reaches the
# scripts in the environment and as it was typed: what looks like make's or the shell's
# to expand is neither's.
TAKEN := TABLE-lesson-plot-diff ARGS-lesson-plot-diff-debug-live JSON-check-grade \
         X-plot Y-plot KEY-plot SCENE-choose ERROR-choose WITHIN-choose VERIFIED-choose \
         FROM-update DRY-update
OPTIONS := $(foreach o,$(TAKEN),$(firstword $(subst -, ,$o)))
given := $(foreach v,$(OPTIONS),$(if $(filter command,$(origin $v)),$v))
takers = $(wordlist 2,9,$(subst -, ,$(filter $1-%,$(TAKEN))))
ifeq ($(MAKELEVEL),0)
$(foreach v,$(given),$(foreach g,$(or $(MAKECMDGOALS),help),$(if $(filter deps \
    $(call takers,$v),$(firstword $(subst -, ,$g))),,$(error make $g ignores $v; that is \
    for make $(call takers,$v)))))
endif
$(foreach v,$(OPTIONS),$(eval override $v := $$(if $$(filter $v,$$(given)),$$(value $v))))
export $(OPTIONS)
