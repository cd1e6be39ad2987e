# Elasticity Workbook.  `make` alone says what there is.
#
# Not recursive; everything is compiled under build/.  solutions/NN_slug.c makes
# NN a lesson, and figures/NN_slug/what.c makes what a study: both are found by
# wildcard.  tests/tests.mk has the rules that only `make test` needs.
# V=1 shows the commands; CC, CFLAGS, LDFLAGS and NATIVE may be given, and others
# than the last time build anew.

# Numbers have a decimal point, whatever the user's language is.
export LC_ALL := C
# Before GNU make 4.3 one within a function begins a comment.
hash := \#

# A job for each processor; of the tests several wait, for a loop's end or a
# sleeper, so they get two more.
ifeq ($(MAKELEVEL)$(filter -j%,$(MAKEFLAGS)),0)
JOBS := $(shell echo $$(($$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)$(if \
            $(filter test,$(MAKECMDGOALS)), + 2))))
MAKEFLAGS += -j$(JOBS)
endif
MAKEFLAGS += --no-print-directory

# What may be given with which goal; to any other it is an error.  It reaches
# student.sh in the environment and as it was typed: what looks like make's or
# the shell's to expand is neither's.
takes_lesson := TABLE ARGS
takes_diff   := TABLE ARGS
takes_plot   := TABLE X Y KEY ARGS
takes_live   := ARGS
takes_choose := SCENE ERROR WITHIN VERIFIED
takes_debug  := ARGS
takes_check  := JSON
takes_update := FROM DRY
takes_grade  := JSON
MAY_BE_GIVEN := TABLE X Y KEY ARGS JSON SCENE ERROR WITHIN VERIFIED FROM DRY
takes_deps   := $(MAY_BE_GIVEN)
given := $(foreach v,$(MAY_BE_GIVEN),$(if $(filter command,$(origin $v)),$v))
goal_ignores = $(filter-out $(takes_$(firstword $(subst -, ,$1))),$(given))
ifeq ($(MAKELEVEL),0)
$(foreach g,$(or $(MAKECMDGOALS),help),$(if $(call goal_ignores,$g),$(error \
    make $g ignores $(firstword $(call goal_ignores,$g)); that is for make \
    $(strip $(foreach t,lesson plot diff debug check live choose grade update,$(if \
    $(filter $(firstword $(call goal_ignores,$g)),$(takes_$t)),$t))))))
endif

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

CC      ?= cc
CFLAGS  ?= -O2 -g
STRICT  := -Wall -Wextra -Wpedantic -Wshadow -Wconversion \
           -Wstrict-prototypes -Wmissing-prototypes
STD     := -std=c17 -D_POSIX_C_SOURCE=200809L -ffp-contract=off
ask_gsl    = $(shell gsl-config --cflags --libs 2>/dev/null)
GSL_CFLAGS = $(filter -I% -D%,$(call once,gsl))
GSL_LIBS   = $(or $(filter-out -I% -D%,$(call once,gsl)),-lgsl -lgslcblas -lm)
# $(call once,NAME): $(ask_NAME), expanded when it is first needed.  make 3.81
# crashes where a variable is changed while it is expanded.
once = $(if $(filter undefined,$(origin said_$1)),$(eval \
           said_$1 := $$(ask_$1)))$(said_$1)
# A solver that may not see a NaN is told so in one line.
ifneq ($(filter -Ofast -ffast-math -ffinite-math-only -funsafe-math-%,$(CC) \
      $(CFLAGS) $(LDFLAGS) $(if $(filter file undefined,$(origin NATIVE)),, \
      $(NATIVE))),)
$(error no -ffast-math or -Ofast here: the programs find NaN and infinity by \
        comparing)
endif
# Flags for tiles.c, front.c, readable.c, and EXACT, where they count: of the list
# that the compiler takes; EXACT go without the last flag, so that their digits are
# the same everywhere, and without pairs made of lines that stand one after the
# other, which gcc 12 contracts all the same.  They make the build one for this
# machine; `make clean` and NATIVE= give one for any.
EXACT := body triangles lanes particles particle_force
ask_native = $(shell takes() { \
                 $(CC) -Werror "$$@" -fsyntax-only -x c /dev/null \
                 2>/dev/null && echo "$$@"; }; \
                 set -- -O3 -march=native -mprefer-vector-width=512 \
                 -ffp-contract=fast; \
                 takes "$$@" || for flag in "$$@"; do takes "$$flag"; done)
ALL_NATIVE = $(call once,native)
ifeq ($(origin NATIVE),undefined)
NATIVE = $(ALL_NATIVE)
endif
PLAIN   = $(CC) $(STD) $(STRICT) $(CFLAGS) -Icommon $(GSL_CFLAGS)
# What is made is moved to its place when it is whole: another make may be
# reading or running the old one.  A signal leaves no half of it.
PART    = $@.$$$$.part
WHOLE   = trap 'rm -f $(PART) $(PART).said' 0; trap 'exit 130' 1 2 15;
MOVED   = mv -f $(PART) $@ && trap - 0
HERE    = [ -d $(@D) ] || mkdir -p $(@D)
COMPILE = $(WHOLE) $(PLAIN) -MMD -MP -MF $@.d -MT $@
# What the compiler says of an object stays in OBJECT.said: a test reads it.
OBJECT  = -c $(SAID)
SAID    = -o $(PART) 2> $(PART).said; status=$$?; \
          [ ! -s $(PART).said ] || cat $(PART).said >&2; \
          [ $$status = 0 ] && mv -f $(PART).said $@.said && $(MOVED)
# Nobody steps through the library or a study: `make debug-NN` compiles its own.
BARE   := $(if $(filter file,$(origin CFLAGS)),-g0)
# What runs for a moment, or lets the library compute, is compiled with -O1.
QUICK  := $(if $(filter file,$(origin CFLAGS)),-O1 -g0)
# the linker that takes half as long, where there is one
ask_linker = $(if $(filter cc gcc% clang% ccache,$(notdir $(firstword $(CC)))), \
                 $(shell command -v ld.gold >/dev/null && echo -fuse-ld=gold))
FAST_LD = $(call once,linker)
LIBS    = $(LDFLAGS) $(FAST_LD) $(GSL_LIBS)
PLACED  = -o $(PART) $(filter %.o %.a,$^) $(LIBS) && $(MOVED)
LINK    = $(LIB) $(LIBS)
BUILD   ?= build
Q       := $(if $(V),,@)
say     = $(if $(V),,@printf '  %-8s %s\n' '$1' '$2')

LESSONS := $(sort $(basename $(notdir $(wildcard solutions/[0-9][0-9]_*.c))))
number  = $(firstword $(subst _, ,$1))
LIB     := $(BUILD)/libworkbook.a
PROGRAMS := $(LESSONS:%=$(BUILD)/solutions/%)
# Thousands of rules are for studies, pictures, tests and teachers; what a student
# asks for does without them, and answers at once.
NO_PROGRAM := help status update alone check check-% hint-% solution-% reset-% watch-% \
              debug-%
LINKED := $(filter-out $(NO_PROGRAM),$(MAKECMDGOALS))
JUDGED_BY := $(if $(INTO),$(INTO) $(BUILD)/solutions/$(SLUG) \
                 $(BUILD)/solutions/$(SLUG).judge)
FOR_STUDENT := $(if $(filter-out $(NO_PROGRAM) lesson-% plot-% diff-% mistakes-% \
                   live live-% choose $(JUDGED_BY),$(or $(MAKECMDGOALS),help)),,yes)
# Studies are named as NN_slug/what; speed/what, the fastest settings of
# work_precision, the fastest elements and the steps of particles are measured by
# `make bench`, many/many, which needs PETSc, by `make many`.
# A file there with a header of its name is what several studies share.
SHARED_BY_STUDIES := $(filter $(patsubst %.h,%.c,$(wildcard figures/*/*.h)), \
                         $(wildcard figures/*/*.c))
# What is in the hand, figures/NN_slug/hand.c, is no study.
STUDIES := $(if $(FOR_STUDENT),,$(filter-out many/% %/hand,$(patsubst \
               figures/%.c,%,$(sort $(filter-out $(SHARED_BY_STUDIES),$(wildcard \
               figures/*/*.c))))))
SPEED   := $(filter speed/% work_precision/fronts %/seconds, $(STUDIES))
COUNTED := $(filter-out $(SPEED),$(STUDIES))
# A script makes an SVG, or a GIF when it moves.  Its data come from the study
# of its name, or from the solution of its folder.  A picture with seconds in it
# names the machine: of this machine it is drawn under build/figures/.
SCRIPTS := $(if $(FOR_STUDENT),,$(patsubst figures/%.gp,%,$(sort $(wildcard \
               figures/*/*.gp))))
KINDS_OF_SCRIPT := $(if $(SCRIPTS),$(sort $(shell awk ' \
    /^set terminal gif/ { print "moving=" FILENAME } \
    /machine.data/ { print "timed=" FILENAME } \
    /square.gp"/ { print "square=" FILENAME } \
    /^. Yours  / { print "asking=" FILENAME }' figures/*/*.gp)))
scripts_that_are = $(patsubst $1=figures/%.gp,%,$(filter \
                       $1=%,$(KINDS_OF_SCRIPT)))
MOVING  := $(call scripts_that_are,moving)
BENCHED := $(filter $(SPEED) $(SPEED:=_all),$(SCRIPTS))
TIMED   := $(sort $(BENCHED) $(call scripts_that_are,timed))
SQUARES := $(call scripts_that_are,square)
picture = figures/$1.$(if $(filter $1,$(MOVING)),gif,svg)
# ..., which may need options to print it: the line "Yours" says which.
OPTIONS_OF = sed -n 's/^\# Yours *the lesson with //p'
ASKING  := $(filter-out $(STUDIES),$(call scripts_that_are,asking))
# What a study has more of than a chapter shows is drawn by NAME_all.gp.
data_of = $(BUILD)/data/$(or $(filter $1 $(1:_all=),$(STUDIES) $(ASKING)),$(patsubst \
              %/,%,$(dir $1))).tsv
FIGURES := $(foreach f,$(filter-out $(TIMED),$(SCRIPTS)),$(call picture,$f)) \
           figures/map.svg
TIMED_HERE := $(foreach f,$(filter-out $(BENCHED),$(TIMED)),$(BUILD)/$(call \
                  picture,$f))

# What all objects were compiled with: with other words they are compiled anew.
# A test with ANY_FLAGS=1 takes them as they are.
FLAGS := $(strip $(CC) $(STD) $(STRICT) $(CFLAGS) $(LDFLAGS) $(if $(filter \
             file undefined,$(origin NATIVE)),,NATIVE=$(NATIVE)))
ifeq ($(ANY_FLAGS),)
ifneq ($(FLAGS),$(strip $(if $(wildcard $(BUILD)/flags),$(shell cat $(BUILD)/flags))))
OTHER_FLAGS := always
endif
endif
RULES := Makefile $(BUILD)/flags

export CC MAKE
# A judged program with a sanitizer needs all addresses.
export SANITIZED := $(findstring -fsanitize=,$(CC) $(CFLAGS) $(LDFLAGS))
# A recipe that runs make shares its jobs; `make -n` prints it and no more.
SHARED := $(if $(findstring n,$(filter-out --%,$(firstword -$(MAKEFLAGS)))),,+)

.DELETE_ON_ERROR:
.SECONDARY:
.SUFFIXES:
.PHONY: help status check update figures course book bench clean gsl always
.DEFAULT_GOAL := help

help:
	@sed -e '/^---/,$$d' -e 's|BUILD|$(BUILD)|' -e 's|SCENES|$(foreach \
	    l,$(SCENES),$(call number,$l))|' tests/tools/goals.txt

gsl:
	@echo '#include <gsl/gsl_math.h>' | $(CC) -E - > /dev/null 2>&1 || { \
	    echo 'GSL is not found; it comes with: make deps' >&2; exit 1; }

# ---- library and programs ---------------------------------------------------

# Where gsl-config is missing, GSL is looked for before anything is compiled.
$(BUILD)/flags: $(OTHER_FLAGS) | $(if $(LINKED),$(if $(GSL_CFLAGS),,gsl))
	$(Q)$(HERE) && $(WHOLE) printf '%s\n' '$(subst ','\'',$(FLAGS))' \
	    > $(PART) && $(MOVED)

# A program is linked with the objects whose headers it reaches, so that the
# first lesson does not wait for all; tests are linked with the library, which
# has all but view_sdl.c, which needs SDL2, window_web.c, which is for a page, and
# the program of `make choose`.
# The goals of NO_PROGRAM link none, and for a judge INTO only its own count.
ASKED := $(if $(INTO),$(filter lessons/%,$(FILE)) tests/checks/$(SLUG).c \
             solutions/$(SLUG).c)
NEEDS := $(if $(LINKED),$(shell find -L \
             common figures solutions lessons tests -type f -name '*.[ch]' \
             -exec grep -H '^$(hash)include "' {} + | \
             awk -v asked='$(ASKED)' -f tests/tools/needs.awk))
comma := ,
needs = $(addprefix $(BUILD)/,$(subst $(comma), ,$(patsubst $1=%,%,$(filter \
            $1=%,$(NEEDS)))))
.SECONDEXPANSION:

OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(SHARED_BY_STUDIES) $(filter-out \
               common/motion/view_sdl.c common/motion/window_web.c \
               common/choice/choose.c,$(wildcard \
               common/*/*.c)))
# One of another make may have left out what has come since.
LEFT_OUT := $(if $(and $(LINKED),$(wildcard $(LIB))),$(filter-out $(shell \
                ar t $(LIB)),$(notdir $(OBJECTS))))
$(LIB): $(OBJECTS) $(if $(LEFT_OUT),always)
	$(call say,lib,$@)
	$(Q)$(WHOLE) ar rcs $(PART) $(OBJECTS) && $(MOVED)

# tiles.c and front.c are as fast with -O2 and these of gcc, have the same digits,
# and compile in two thirds of the time; banded.c has its digits with any flags.
ask_less = $(shell set -- -O2 -ftree-vectorize -fvect-cost-model=dynamic \
               -fpeel-loops; $(CC) -Werror "$$@" -fsyntax-only -x c /dev/null \
               2>/dev/null && echo "$$@" || echo -O3)
LESS_THAN_O3 = $(call once,less)
same_digits = $(filter-out -ffp-contract=fast,$1) -fno-tree-slp-vectorize
native_for = $(if $(filter readable,$1),$(NATIVE)) \
             $(if $(filter tiles front,$1),$(patsubst \
                 -O3,$(LESS_THAN_O3),$(NATIVE))) \
             $(if $(filter $(EXACT),$1),$(call same_digits,$(NATIVE))) \
             $(if $(filter banded,$1),$(if $(NATIVE),$(LESS_THAN_O3)))
# what a label of seconds says of these
FAST = $(if $(NATIVE),$(comma) kernels $(filter -O3 -march=native,$(NATIVE)))
$(OBJECTS): $(BUILD)/%.o: %.c $(RULES)
	$(call say,cc,$<)
	$(Q)$(HERE) && $(COMPILE) -DBUILD_FLAGS='"$(CFLAGS)$(FAST)"' \
	    $(BARE) $(call native_for,$(notdir $*)) $< $(OBJECT)

# Compiled and linked by themselves: `make test` links them with other libraries.
PARTS := $(PROGRAMS) $(COUNTED:%=$(BUILD)/figures/%)
$(PARTS:=.o): $(BUILD)/%.o: %.c $(RULES)
	$(call say,cc,$<)
	$(Q)$(HERE) && $(COMPILE) $(if $(filter figures/%,$<),$(QUICK),$(BARE)) $< $(OBJECT)
$(PARTS): $(BUILD)/%: $(BUILD)/%.o $$(call needs,$$*.c)
	$(Q)$(WHOLE) $(CC) $(CFLAGS) $(PLACED)

# A program that is built does not stand for a file that is not there.
MISSING := $(filter-out $(wildcard lessons/*.c),$(LESSONS:%=lessons/%.c))
.PHONY: $(MISSING)
$(MISSING):
	@echo '$@ is not there; it comes back with:' \
	    'make reset-$(call number,$(@F))' >&2; exit 1
$(BUILD)/mine/%: lessons/%.c $$(call needs,lessons/$$*.c)
	$(call say,cc,$<)
	@[ -f $< ] || { echo '$< is not a plain file.' >&2; exit 1; }
	$(Q)$(HERE) && $(COMPILE) $< $(PLACED)

# A judge is a lesson's checks with the judged program compiled in.
JUDGE = $(patsubst %,$(BUILD)/tests/%.o,judge diagnose report verdict \
          compare cells tables claims guard output predict child confine sight \
          kept)
$(JUDGE): $(BUILD)/tests/%.o: tests/checks/%.c $(RULES)
	$(call say,cc,$<)
	$(Q)$(HERE) && $(COMPILE) $(QUICK) -Itests/checks $< $(OBJECT)

# An index beyond an array whose length the compiler knows is a trap there, if it
# knows how; judge.h guards the arrays that the checks hand over.
ask_bounds = $(shell for flags in \
                 '-fsanitize=bounds -fsanitize-undefined-trap-on-error' \
                 '-fsanitize=bounds -fsanitize-trap=bounds'; do \
                 $(CC) -Werror $$flags -fsyntax-only -x c /dev/null 2>/dev/null && \
                 echo $$flags && break; done)
BOUNDS = $(call once,bounds)

# The checks of a lesson are compiled once, against the functions of its solution.
CHECKS := $(BUILD)/checks
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
	    nm -gP $(filter-out $(JUDGE),$^); } 2>/dev/null | awk 'BEGIN { \
	    print "-" } NF == 1 { theirs = theirs || $$1 == "library" } $$2 ~ /[A-TV-Z]/ { print $$1, \
	    theirs ? "library" : "judge" }' > $(PART) && $(MOVED)

# A judge is these, with the program, which is compiled alone.
# $(call build_judge,program to judge,NN_slug,more flags)
AS_PROGRAM = tests/tools/program.sh tests/tools/program.awk tests/tools/assembler.awk
judge_of = $(CHECKS)/$1.o $(CHECKS)/$1.calls $(CHECKS)/$1.words $(JUDGE) $(AS_PROGRAM)
build_judge = COMPILER='$(call $(or $4,quickly),$(PLAIN)) $(BOUNDS) $3' \
    BUILD='$(BUILD)' sh tests/tools/program.sh '$1' $2 $@ && $(WHOLE) $(CC) \
    $(CFLAGS) $3 $@.s $$([ -f $@.o ] && echo $@.o || echo $(CHECKS)/$2.o) -o $(PART) \
    $(filter-out $(CHECKS)/%,$(filter %.o %.a,$^)) $(LIBS) && $(MOVED)
quickly = $1 $(QUICK)

$(BUILD)/solutions/%.judge: solutions/%.c $$(call judge_of,$$*) \
        $$(call needs,solutions/$$*.c) $$(call needs,tests/checks/$$*.c)
	$(call say,judge,$<)
	$(Q)$(HERE) && $(call build_judge,$<,$*)

# Known mistakes and equivalent programs of a lesson (tests/mistakes/NN_slug.txt):
# all.judge has them all, for they differ in a few functions.  NAME is one of them
# as a program, NAME.judge its judge, NAME.why what the student is told, after the
# check that catches it.  They are compiled as quickly as can be, with -O1 where
# they compute for long, and without warnings.  Where an entry does not fit the
# solution any more, there is none, and lint says why.
LONG := 18_% 22_%
HASTY = -g0 -w -Wl,-S
unwarned = $(filter-out $(STRICT),$1)
VARIANT = awk -f tests/tools/variant.awk
$(LESSONS:%=$(BUILD)/mistakes/%/all.c): $(BUILD)/mistakes/%/all.c: \
        tests/mistakes/%.txt solutions/%.c tests/tools/variant.awk
	$(Q)mkdir -p $(@D) $(PART) && trap 'rm -rf $(PART)' 0; trap 'exit 130' 1 2 15; \
	    $(VARIANT) -v all=$(PART) $< solutions/$*.c > $(PART)/list && \
	    chmod +x $(PART)/* && rm -f $(@D)/*.why && mv -f $(PART)/* $(@D)
$(BUILD)/mistakes/%/all.judge: $(BUILD)/mistakes/%/all.c $$(call judge_of,$$*) \
        $$(call needs,solutions/$$*.c) $$(call needs,tests/checks/$$*.c)
	$(call say,judge,tests/mistakes/$*.txt)
	$(Q)$(call build_judge,$<,$*,$(if $(filter $(LONG),$*),-O1,-O0) \
	    $(HASTY),unwarned)

# For student.sh: a judge INTO of any FILE of lesson SLUG, and whether FILE
# compiles by itself.
.PHONY: alone
alone:
	$(Q)$(PLAIN) -fsyntax-only $(FILE)
ifneq ($(INTO),)
$(INTO): $(call judge_of,$(SLUG)) $(if $(filter lessons/%,$(FILE)),$(call \
         needs,$(FILE)) $(call needs,tests/checks/$(SLUG).c),$(LIB))
	$(Q)$(call build_judge,$(FILE),$(SLUG))
endif

# ---- data, figures, course --------------------------------------------------

# A study whose claim is false ends with status 1 and leaves no data.
$(LESSONS:%=$(BUILD)/data/%.tsv): $(BUILD)/data/%.tsv: $(BUILD)/solutions/%
	$(call say,run,$<)
	$(Q)$(HERE) && $(WHOLE) $< > $(PART) && $(MOVED)
$(COUNTED:%=$(BUILD)/data/%.tsv): $(BUILD)/data/%.tsv: $(BUILD)/figures/%
	$(call say,study,$*)
	$(Q)$(HERE) && $(WHOLE) $< > $(PART) && $(MOVED)

$(ASKING:%=$(BUILD)/data/%.tsv): $(BUILD)/data/%.tsv: figures/%.gp \
        $(BUILD)/solutions/$$(firstword $$(subst /, ,$$*))
	$(call say,run,$*)
	$(Q)$(HERE) && $(WHOLE) \
	    $(filter-out %.gp,$^) $$($(OPTIONS_OF) $<) > $(PART) && $(MOVED)

# The numbers of a chapter's Example: its lesson's, with the ARGS that stand there.
EXAMPLES := $(if $(SCRIPTS),$(patsubst lessons/%.md,%,$(shell grep -l \
                '^$(hash)$(hash) Example$$' /dev/null lessons/[0-9]*.md)))
ARGS_OF = sed -n '/^\#\# Example$$/,/^\#\# On paper$$/s/.*ARGS=.\([^`]*\).`.*/\1/p'
$(EXAMPLES:%=$(BUILD)/data/%/example.tsv): $(BUILD)/data/%/example.tsv: \
        $(BUILD)/solutions/% lessons/%.md
	$(call say,run,$* example)
	$(Q)$(HERE) && $(WHOLE) $< $$($(ARGS_OF) lessons/$*.md) > $(PART) && \
	    $(MOVED)

# A picture whose script, style and data are as they were is not drawn again.
DRAW = $(Q)SAY=$(if $(V),,yes) sh tests/tools/figure.sh
define figure_rule
$2: figures/$1.gp figures/style.gp $(call data_of,$1) \
        $(if $(filter $1,$(SQUARES)),$(wildcard figures/square.*))
	$$(DRAW) $$< $(call data_of,$1) $$@
endef
$(foreach f,$(SCRIPTS),$(eval $(call figure_rule,$f,$(if $(filter \
    $f,$(TIMED)),$(BUILD)/)$(call picture,$f))))
# What the study on many processes has counted is in the tree.
$(BUILD)/data/many.tsv: figures/many/many.tsv
	$(Q)$(HERE) && cp $< $@
# The map of the course is drawn from the heads of the chapters.
figures/map.svg: figures/map.awk $(wildcard lessons/[0-9]*.md figures/*/README.md)
	$(call say,map,$@)
	$(Q)$(WHOLE) awk -f $< $(filter %.md,$^) > $(PART) && $(MOVED)
figures: $(FIGURES) $(TIMED_HERE)
	@echo 'figures: $(words $(FIGURES)) in figures/;' \
	      '$(words $(TIMED_HERE)) with seconds of this machine in' \
	      '$(BUILD)/figures/'
	@echo '  left to make bench, which takes minutes:' \
	      '$(BENCHED)'

# One figure, figure-16-principal, or all of a folder: figure-16, figure-speed.
dashed = $(subst -, ,$1)
folder_of = $(or $(filter $(firstword $(dashed))_%,$(LESSONS)),$(firstword \
                $(dashed)))
asked_for = $(filter $(folder_of)/$(or $(word 2,$(dashed)),%),$(SCRIPTS))
figure-%: $$(foreach f,$$(filter-out $$(BENCHED),$$(call asked_for,$$*)),$$(if \
          $$(filter $$f,$$(TIMED)),$$(BUILD)/)$$(call picture,$$f))
	@for f in $^; do echo "  $$f"; done
	@for f in $(filter $(BENCHED),$(call asked_for,$*)); do \
	    echo "  figures/$$f.svg is left to make bench"; done
	@[ -n '$(call asked_for,$*)' ] || { echo 'There is no figure-$*; there are:' \
	    >&2; printf '  %s\n' $(or $(notdir $(filter $(call \
	    folder_of,$*)/%,$(SCRIPTS))),$(patsubst %/,%,$(sort $(dir \
	    $(SCRIPTS))))) >&2; exit 2; }

$(BUILD)/solutions/%.verdict: $(BUILD)/solutions/%.judge $(BUILD)/solutions/%
	$(call say,check,$*)
	$(Q)$(WHOLE) $< --file solutions/$*.c --reference $(BUILD)/solutions/$* \
	    > $(PART) || { cat $(PART); exit 1; }; $(MOVED)

# the longest first, so that no processor is without one at the end
LONGEST := $(filter %/rare %/push %/pull %/front %/kept %/held_out,$(COUNTED))
course: $(LONGEST:%=$(BUILD)/data/%.tsv) \
        $(LESSONS:%=$(BUILD)/solutions/%.verdict) figures \
        $(COUNTED:%=$(BUILD)/data/%.tsv)
	@echo 'course: $(words $(LESSONS)) solutions run and judged OK,' \
	      'the claims of $(words $(COUNTED)) studies hold'

# The book as HTML; pandoc is for this only, and make deps leaves it out.
book: ; @BUILD='$(BUILD)' sh tests/tools/book.sh

# ---- speed: measured, never asserted; tables on stdout
# LAPACK takes part where there is one; GSL keeps the BLAS of its own.
LAPACK = $(shell for l in -lopenblas -llapack; do \
             echo 'int dpbtrf_(void); int main(void) { return dpbtrf_(); }' | \
             $(CC) -w -x c - -o /dev/null $$l 2>/dev/null && echo $$l && break; \
         done)
# CHOLMOD, too, for the study that asks for it.
CHOLMOD = $(shell for f in "$$(pkg-config --cflags --libs cholmod \
              2>/dev/null)" -lcholmod '-I/usr/include/suitesparse -lcholmod'; do \
              echo 'int main(void) { return !cholmod_start; }' | $(CC) -w \
              -include cholmod.h -x c - -o /dev/null $$f 2>/dev/null && \
              echo $$f && break; done)
$(SPEED:%=$(BUILD)/figures/%): $(BUILD)/figures/%: figures/%.c \
        $$(call needs,figures/$$*.c)
	$(call say,cc,$<)
	$(Q)$(HERE) && lapack='$(LAPACK)' && \
	    rival='$(if $(filter %/solvers,$*),$(CHOLMOD))' && $(COMPILE) \
	    -DNATIVE_FLAGS='"$(strip $(NATIVE))"' $${rival:+-DCHOLMOD} \
	    $${lapack:+-DLAPACK="\"$$lapack\""} $(NATIVE) $< -o $(PART) \
	    $(filter %.o,$^) $(LDFLAGS) $(GSL_LIBS) $$rival $$lapack && $(MOVED)
bench: $(SPEED:%=$(BUILD)/figures/%) \
       $(patsubst %,$(BUILD)/figures/%,$(filter $(COUNTED),$(TIMED)))
	$(SHARED)@exec env BUILD='$(BUILD)' TIMED='$(TIMED)' sh tests/tools/bench.sh \
	    $(SPEED) $(filter $(COUNTED),$(TIMED))

# ---- the student's commands -------------------------------------------------

# exec: a signal to make's child is one to the script
STUDENT = exec env BUILD='$(BUILD)' FORCE='$(FORCE)' sh tests/tools/student.sh

override ARGS := $(if $(filter ARGS,$(given)),$(strip $(value ARGS)))
HANDED_ON := $(filter-out ARGS JSON,$(MAY_BE_GIVEN))
$(foreach v,$(HANDED_ON),$(eval override $v := $$(if $$(filter $v,$$(given)),$$(value $v))))
export ARGS $(HANDED_ON)

status: ; @$(STUDENT) status
check: ; @$(SHARED)$(STUDENT) check
# of the version before where one took tests/ away and was killed
update: ; @exec sh $(firstword $(wildcard tests/tools/update.sh \
            saved/*/old/tests/tools/update.sh))

define lesson_rules
.PHONY: $(addsuffix -$1,lesson check hint plot diff solution reset watch debug mistakes)
mistakes-$1: $(BUILD)/mistakes/$2/all.judge
lesson-$1: $(BUILD)/mine/$2
	@$(STUDENT) run $2
check-$1 watch-$1 debug-$1: ; @$(SHARED)$(STUDENT) $$(@:-$1=) $2
plot-$1 diff-$1: $(BUILD)/mine/$2 $(BUILD)/solutions/$2 \
        $(BUILD)/solutions/$2.judge $(if $(ARGS),,$(BUILD)/data/$2.tsv)
	@$(STUDENT) $$(@:-$1=) $2
hint-$1 solution-$1 reset-$1: ; @$(STUDENT) $$(@:-$1=) $2
endef
$(foreach l,$(LESSONS),$(eval $(call lesson_rules,$(call number,$l),$l)))

# Lesson 24 in a window; ARGS: its options.  Until all its slots are written it is
# the solution that runs.
LIVE = $(if $(FORCE)$(shell [ -f lessons/24_live.c ] && \
           ! grep 'todo."24[a-z]"' lessons/24_live.c || \
           echo none),solutions,lessons)/24_live.c
.PHONY: live
live: $(LIB)
	@pkg-config --exists sdl2 2> /dev/null || { echo 'make live needs SDL2:' \
	    'apt install libsdl2-dev, or brew install sdl2' >&2; exit 2; }
	@[ $(LIVE) = lessons/24_live.c ] || [ -n '$(FORCE)' ] || echo 'Lesson 24' \
	    'has slots that are not written yet: this is its solution.'
	@mkdir -p $(BUILD) && $(PLAIN) $$(pkg-config --cflags sdl2) $(LIVE) \
	    common/motion/view_sdl.c -o $(BUILD)/live $(LINK) \
	    $$(pkg-config --libs sdl2)
	@set -f; case " $$ARGS " in *' -h '*|*' --help '*) exec $(BUILD)/live -h ;; \
	esac; $(BUILD)/live $$ARGS > $(BUILD)/live.tsv && \
	echo 'The frames are in $(BUILD)/live.tsv'

# The student's slots of a lesson in a window, with the solution's for what is not
# written yet; a scene is figures/NN_slug/hand.c.
SCENES := $(patsubst figures/%/hand.c,%,$(wildcard figures/*/hand.c))
define hand_rule
.PHONY: live-$(call number,$1)
live-$(call number,$1): $(sort $(call needs,solutions/$1.c) \
        $(call needs,figures/$1/hand.c))
	@$$(HAND) $1
endef
HAND = exec env BUILD='$(BUILD)' COMPILE='$(PLAIN)' OBJECTS='$^' LIBS='$(LIBS)' \
       sh tests/tools/hand.sh
$(foreach l,$(SCENES),$(eval $(call hand_rule,$l)))
live-%:
	@echo 'There is no live-$*; what can be held in the hand:' \
	    $(foreach l,$(SCENES),live-$(call number,$l)) live >&2; exit 2

# The least model for a scene of one's own, by the library's ladder.
$(BUILD)/choose: common/choice/choose.c $(LIB)
	$(Q)$(COMPILE) $< $(PLACED)
.PHONY: choose
choose: $(BUILD)/choose
	$(if $(filter command,$(origin VERIFY)),$(error make choose takes VERIFIED=yes))
	@exec env BUILD='$(BUILD)' sh tests/tools/choose.sh

# The files of a new lesson: make new-27 NAME=spring
new-%:
	@sh tests/tools/new.sh '$*' '$(NAME)'
	@$(SHARED)$(MAKE) workbook-$* figures/$*_$(NAME)/order.svg
	@$(SHARED)$(MAKE) figures/map.svg

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

# Progress and replaced files of the student stay, and what was fetched.
clean:
	@for f in $(BUILD)/*; do case $$f in \
	    */progress|*/saved|*/source) ;; *) rm -rf "$$f" ;; esac; done

ifneq ($(FOR_STUDENT),)
ifneq ($(LINKED),)
-include $(wildcard $(BUILD)/*/*.d $(BUILD)/mistakes/*/*.d $(OBJECTS:=.d))
endif
else
-include $(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d)
include tests/tests.mk
endif
endif
