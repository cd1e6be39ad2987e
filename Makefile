# Elasticity Workbook.  `make` alone says what there is.
#
# One file, not recursive; everything is compiled under build/.  Lessons are
# found by wildcard: solutions/NN_slug.c makes NN a lesson.
# V=1 shows the commands; CC, CFLAGS, LDFLAGS and NATIVE may be given.

CC      ?= cc
CFLAGS  ?= -O2 -g
STRICT  := -Wall -Wextra -Wpedantic -Wshadow -Wconversion \
           -Wstrict-prototypes -Wmissing-prototypes
STD     := -std=c17 -D_POSIX_C_SOURCE=200809L -ffp-contract=off
GSL_CFLAGS   = $(shell gsl-config --cflags 2>/dev/null)
GSL_LIBS     = $(shell gsl-config --libs 2>/dev/null || \
                       echo -lgsl -lgslcblas -lm)
CHECK_CFLAGS = $(shell pkg-config --cflags check 2>/dev/null)
CHECK_LIBS   = $(shell pkg-config --libs check 2>/dev/null || echo -lcheck)
# Flags for common/banded.c and body.c alone, where they count: those of the list
# that the compiler takes; body.c goes without the last, so that its digits are
# the same everywhere.  They make the build one for this machine; `make clean`
# and NATIVE= give one for any.
NATIVE ?= $(shell for flag in -O3 -march=native -mprefer-vector-width=512 \
              -ffp-contract=fast; do $(CC) -Werror $$flag -x c -c /dev/null \
              -o /dev/null 2>/dev/null && echo $$flag; done)
COMPILE = $(CC) $(STD) $(STRICT) $(CFLAGS) -Icommon $(GSL_CFLAGS) -MMD -MP
BUILD   ?= build
Q       := $(if $(V),,@)
say     = $(if $(V),,@printf '  %-8s %s\n' '$1' '$2')

LESSONS := $(sort $(basename $(notdir $(wildcard solutions/[0-9][0-9]_*.c))))
number  = $(firstword $(subst _, ,$1))
LIB     := $(BUILD)/libworkbook.a
PROGRAMS := $(LESSONS:%=$(BUILD)/solutions/%)
# studies: programs of tests/bench/ whose tables hold no seconds, with a chapter
STUDIES := robustness
# a script makes an SVG, or a GIF when it moves
SCRIPTS  := $(sort $(wildcard figures/[0-9][0-9]_*.gp \
                $(STUDIES:%=figures/%_*.gp)))
MOVING   := $(shell grep -l '^set terminal gif' /dev/null $(SCRIPTS))
FIGURES  := $(patsubst %.gp,%.svg,$(filter-out $(MOVING),$(SCRIPTS))) \
            $(MOVING:.gp=.gif)
# the lesson or study that a figure NN_slug_what belongs to
lesson_of = $(firstword $(foreach l,$(LESSONS) $(STUDIES),$(if \
                $(filter $l_%,$(notdir $1)),$l)))

# With `deps` among the goals nothing is compiled before it has finished.
DEPS := $(filter deps,$(MAKECMDGOALS))

ifeq ($(MAKELEVEL)$(filter -j%,$(MAKEFLAGS)),0)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
endif
MAKEFLAGS += --no-print-directory
export CC MAKE

.DELETE_ON_ERROR:
.SECONDARY:
.SUFFIXES:
.PHONY: help deps status figures course starters workbook test bench \
        programs memcheck clean
.DEFAULT_GOAL := help

help:
	@echo 'Elasticity Workbook: lessons in lessons/, the book is workbook.md'
	@echo
	@echo '  make deps         install what is missing'
	@echo '  make status       the lessons, and which of yours pass'
	@echo '  make lesson-07    build and run my lessons/07_*.c'
	@echo '  make check-07     judge it: one line a check, one verdict'
	@echo '  make hint-07      the next hint; there are three levels'
	@echo '  make plot-07      my numbers over the reference'
	@echo '  make solution-07  the reference solution (after a pass, or FORCE=1)'
	@echo '  make reset-07     put the starter back (my file is saved first)'
	@echo '  make watch-07     check again at each save'
	@echo '  make figures      draw every figure from the reference solutions'
	@echo '  make course       run and judge every solution, draw every figure'
	@echo '  make test         the tests of the workbook itself'
	@echo '  make bench        solvers and time steps against others, here'
	@echo
	@echo '  for teachers:     starters  workbook  verify-07  memcheck  clean'

deps:
	@sh tests/tools/deps.sh

# ---- library and programs ---------------------------------------------------

OBJECTS := $(patsubst common/%.c,$(BUILD)/common/%.o,$(wildcard common/*.c))
$(LIB): $(OBJECTS)
	$(call say,lib,$@)
	$(Q)rm -f $@ && ar rcs $@ $^

$(BUILD)/common/%.o: common/%.c Makefile | $(DEPS)
	$(call say,cc,$<)
	$(Q)mkdir -p $(@D) && $(COMPILE) -DBUILD_FLAGS='"$(CFLAGS)"' \
	    $(if $(filter banded,$*),$(NATIVE)) \
	    $(if $(filter body,$*),$(filter-out -ffp-contract=fast,$(NATIVE))) \
	    -c $< -o $@

$(BUILD)/solutions/%: solutions/%.c $(LIB)
	$(call say,cc,$<)
	$(Q)mkdir -p $(@D) && $(COMPILE) $< -o $@ $(LIB) $(LDFLAGS) $(GSL_LIBS)

$(BUILD)/mine/%: lessons/%.c $(LIB)
	$(call say,cc,$<)
	$(Q)mkdir -p $(@D) && $(COMPILE) $< -o $@ $(LIB) $(LDFLAGS) $(GSL_LIBS)

# A judge is a lesson's checks with the judged program compiled in.
JUDGE = $(BUILD)/tests/judge.o $(BUILD)/tests/output.o
$(JUDGE): $(BUILD)/tests/%.o: tests/checks/%.c Makefile | $(DEPS)
	$(call say,cc,$<)
	$(Q)mkdir -p $(@D) && $(COMPILE) -Itests/checks $(CHECK_CFLAGS) -c $< -o $@

# $(call build_judge,program to judge,NN_slug)
build_judge = $(COMPILE) -Itests/checks $(CHECK_CFLAGS) \
              -DPROGRAM='"$(abspath $1)"' tests/checks/$2.c -o $@ $(JUDGE) \
              $(LIB) $(LDFLAGS) $(CHECK_LIBS) $(GSL_LIBS)

$(BUILD)/solutions/%.judge: solutions/%.c tests/checks/%.c $(JUDGE) $(LIB)
	$(call say,judge,$<)
	$(Q)mkdir -p $(@D) && $(call build_judge,$<,$*)

$(BUILD)/mine/%.judge: lessons/%.c tests/checks/%.c $(JUDGE) $(LIB)
	$(call say,judge,$<)
	$(Q)mkdir -p $(@D) && $(call build_judge,$<,$*)

# ---- data, figures, course --------------------------------------------------

$(BUILD)/data/%.tsv: $(BUILD)/solutions/%
	$(call say,run,$<)
	$(Q)mkdir -p $(@D) && $< > $@.part && mv $@.part $@
$(STUDIES:%=$(BUILD)/data/%.tsv): $(BUILD)/data/%.tsv: $(BUILD)/bench/%
	$(call say,run,$<)
	$(Q)mkdir -p $(@D) && $< > $@.part && mv $@.part $@

# A script that warns has failed: gnuplot exits with 0 when its data is missing.
define figure_rule
$1: $(basename $1).gp figures/style.gp $(BUILD)/data/$(call lesson_of,$1).tsv
	$$(call say,plot,$$@)
	$(Q)sh tests/tools/figure.sh $$< $(BUILD)/data/$(call lesson_of,$1).tsv $$@
endef
$(foreach f,$(FIGURES),$(eval $(call figure_rule,$f)))
figures: $(FIGURES)

$(BUILD)/solutions/%.verdict: $(BUILD)/solutions/%.judge $(BUILD)/solutions/%
	$(call say,check,$*)
	$(Q)$< --file solutions/$*.c --reference $(BUILD)/solutions/$* \
	    > $@.part || { cat $@.part; exit 1; }
	$(Q)mv $@.part $@

course: $(LESSONS:%=$(BUILD)/solutions/%.verdict) $(FIGURES)
	@echo 'course: $(words $(LESSONS)) solutions run and judged OK,' \
	      '$(words $(FIGURES)) figures in figures/'

# ---- the student's commands -------------------------------------------------

STUDENT = BUILD=$(BUILD) FORCE=$(FORCE) TABLE=$(TABLE) sh tests/tools/student.sh
status: ; @$(STUDENT) status

define lesson_rules
.PHONY: $(addsuffix -$1,lesson check hint plot solution reset watch mistakes)
lesson-$1: $(BUILD)/mine/$2
	@$(STUDENT) run $2
check-$1: ; @+$(STUDENT) check $2
watch-$1: ; @+$(STUDENT) watch $2
plot-$1: $(BUILD)/mine/$2 $(BUILD)/data/$2.tsv
	@$(STUDENT) plot $2
hint-$1 solution-$1 reset-$1: ; @$(STUDENT) $$(@:-$1=) $2
endef
$(foreach l,$(LESSONS),$(eval $(call lesson_rules,$(call number,$l),$l)))

lesson-% check-% hint-% plot-% solution-% reset-% watch-%:
	@echo "There is no lesson $*. The lessons are:" >&2
	@for l in $(LESSONS); do echo "  $$l" >&2; done
	@exit 2

# ---- starters, known mistakes, workbook -------------------------------------

starters: ; @BUILD=$(BUILD) sh tests/tools/student.sh starters $(LESSONS)

# Starters as the solutions give them, whatever the student has in lessons/.
$(BUILD)/starters/%.c: solutions/%.c tests/tools/starter.awk
	$(Q)mkdir -p $(@D) && awk -f tests/tools/starter.awk $< > $@
$(BUILD)/starters/%.judge: $(BUILD)/starters/%.c tests/checks/%.c $(JUDGE) $(LIB)
	$(Q)$(call build_judge,$<,$*) -Werror

# Known mistakes and equivalent programs (tests/mistakes/NN_slug.txt), made from
# the solution: build/mistakes/NN_slug/NAME.c, the program NAME, what the student
# is told NAME.why, and the judge NAME.judge.
VARIANT = awk -f tests/tools/variant.awk
variants = $(foreach l,$(LESSONS),$(addprefix $l/,$(shell $(VARIANT) \
               -v list=$1 tests/mistakes/$l.txt 2>/dev/null)))
MISTAKES    := $(call variants,mistake)
EQUIVALENTS := $(call variants,equivalent)

define variant_rules
$(BUILD)/mistakes/$1.c: tests/mistakes/$(patsubst %/,%,$(dir $1)).txt \
        solutions/$(patsubst %/,%,$(dir $1)).c tests/tools/variant.awk
	$(Q)mkdir -p $$(@D)
	$(Q)$$(VARIANT) -v name=$(notdir $1) $$(filter-out %.awk,$$^) > $$@
	$(Q)$$(VARIANT) -v name=$(notdir $1) -v get=why $$< > $$(@:.c=.why)
$(BUILD)/mistakes/$1: $(BUILD)/mistakes/$1.c $(LIB)
	$(Q)$$(COMPILE) -w $$< -o $$@ $(LIB) $$(LDFLAGS) $$(GSL_LIBS)
$(BUILD)/mistakes/$1.judge: $(BUILD)/mistakes/$1.c $(JUDGE) $(LIB) \
        tests/checks/$(patsubst %/,%,$(dir $1)).c
	$(Q)$$(call build_judge,$$<,$(patsubst %/,%,$(dir $1))) -w
endef
$(foreach v,$(MISTAKES) $(EQUIVALENTS),$(eval $(call variant_rules,$v)))
# all known mistakes of a lesson; one that is no longer listed goes
define mistakes_rule
mistakes-$(call number,$1): $(patsubst %,$(BUILD)/mistakes/%,\
        $(filter $1/%,$(MISTAKES)))
	@for why in $(BUILD)/mistakes/$1/*.why; do name=$$$${why%.why}; \
	    case ' $$^ ' in *" $$$$name "*) ;; *) rm -f "$$$$name" "$$$$why" ;; \
	    esac; done
endef
$(foreach l,$(LESSONS),$(eval $(call mistakes_rule,$l)))

DATA := $(patsubst %,$(BUILD)/data/%.tsv,$(LESSONS) $(STUDIES))
workbook: $(DATA)
	@sh tests/tools/workbook.sh fill

# ---- tests ------------------------------------------------------------------

# Every test writes lines "ok WHAT" or "FAIL WHAT: why" to a .result file; only
# the last recipe fails.  A test runs again when anything it rests on changed.
VERIFY = BUILD=$(BUILD) sh tests/tools/verify.sh
T := $(BUILD)/test
$(T)/%.solution.result: $(BUILD)/solutions/%.judge $(BUILD)/solutions/% \
                        tests/tools/verify.sh
	$(call say,test,$* solution)
	$(Q)mkdir -p $(@D) && $(VERIFY) solution $* > $@
$(T)/%.starter.result: $(BUILD)/starters/%.judge $(BUILD)/solutions/% \
                       lessons/%.c tests/tools/verify.sh
	$(call say,test,$* starter)
	$(Q)mkdir -p $(@D) && $(VERIFY) starter $* > $@
# ---- unit laws of common/, and deliberate mistakes that they must catch
UNITS := $(patsubst tests/unit/%.c,%,$(filter-out %/unit.c,\
             $(wildcard tests/unit/*.c)))
UNIT_FLAGS = -Itests/unit $(CHECK_CFLAGS)
UNIT_LIBS  = $(LIB) $(LDFLAGS) $(CHECK_LIBS) $(GSL_LIBS)
$(BUILD)/unit/unit.o: tests/unit/unit.c Makefile | $(DEPS)
	$(Q)mkdir -p $(@D) && $(COMPILE) $(UNIT_FLAGS) -c $< -o $@
$(BUILD)/unit/%: tests/unit/%.c $(BUILD)/unit/unit.o $(LIB)
	$(call say,cc,$<)
	$(Q)$(COMPILE) $(UNIT_FLAGS) $< -o $@ $(BUILD)/unit/unit.o $(UNIT_LIBS)
$(T)/unit.%.result: $(BUILD)/unit/%
	$(call say,test,unit $*)
	$(Q)mkdir -p $(@D) && { $< > $@ || true; }

UNIT_MISTAKES := $(shell $(VARIANT) -v list=mistake tests/unit/mistakes.txt)
unit_field = $(shell $(VARIANT) -v name=$1 -v get=$2 tests/unit/mistakes.txt)
define unit_mistake
$(BUILD)/unit/$1.mistake: tests/unit/mistakes.txt $(call unit_field,$1,file) \
        tests/unit/$(call unit_field,$1,unit).c $(BUILD)/unit/unit.o $(LIB)
	$(Q)$$(VARIANT) -v name=$1 $$(wordlist 1,2,$$^) > $$@.c
	$(Q)$$(COMPILE) -w $$(UNIT_FLAGS) $$@.c $$(word 3,$$^) -o $$@ \
	    $$(word 4,$$^) $$(UNIT_LIBS)
$(T)/unit-mistake.$1.result: $(BUILD)/unit/$1.mistake
	$$(call say,test,common/ with $1)
	$(Q)mkdir -p $$(@D) && { $$< 2>&1 || true; } | awk '{ said = said $$$$0 "\n" } \
	    /^FAIL [a-z]*: $(call unit_field,$1,caught-by):/ { caught = 1 } \
	    END { if (caught) print "ok common/ with $1 is caught"; \
	          else print "FAIL common/ with $1 is not caught: " said }' > $$@
endef
$(foreach m,$(UNIT_MISTAKES),$(eval $(call unit_mistake,$m)))

# every program that a judge compares with, before any judge of the lesson runs
mistakes_of = $(patsubst %,$(BUILD)/mistakes/%,$(filter $1/%,$(MISTAKES)))
define verify_rules
$(T)/$1.behave.result: $(BUILD)/solutions/$1 $(JUDGE) $(call mistakes_of,$1) \
        tests/tools/student.sh tests/tools/verify.sh tests/checks/$1.c Makefile
	$$(call say,test,$1 behaviour)
	+$(Q)mkdir -p $$(@D) && $$(VERIFY) behave $1 > $$@
.PHONY: verify-$(call number,$1)
verify-$(call number,$1): $(patsubst %,$(T)/$1.%.result,solution starter behave) \
        $(patsubst %,$(T)/%.result,$(filter $1/%,$(MISTAKES) $(EQUIVALENTS)))
	@cat $$^ | sh tests/tools/count.sh
endef
$(foreach l,$(LESSONS),$(eval $(call verify_rules,$l)))
define variant_test
$(T)/$1.result: $(BUILD)/mistakes/$1.judge $(BUILD)/solutions/$(patsubst %/,%,$(dir $1)) \
        $(call mistakes_of,$(patsubst %/,%,$(dir $1))) tests/tools/verify.sh
	$$(call say,test,$1)
	$(Q)mkdir -p $$(@D) && $$(VERIFY) $2 $(patsubst %/,%,$(dir $1)) $(notdir $1) > $$@
endef
$(foreach v,$(MISTAKES),$(eval $(call variant_test,$v,mistake)))
$(foreach v,$(EQUIVALENTS),$(eval $(call variant_test,$v,equivalent)))

# ---- speed: measured, never asserted; tables on stdout
# LAPACK takes part where there is one; GSL keeps the BLAS of its own.
LAPACK = $(shell for l in -lopenblas -llapack; do \
             echo 'int dpbtrf_(void); int main(void) { return dpbtrf_(); }' | \
             $(CC) -w -x c - -o /dev/null $$l 2>/dev/null && echo $$l && break; \
         done)
BENCHES := solve step
BENCH = lapack='$(LAPACK)' && $(COMPILE) -Itests/bench \
        -DNATIVE_FLAGS='"$(strip $(NATIVE))"' \
        $${lapack:+-DLAPACK="\"$$lapack\""}
$(BUILD)/bench/bench.o: tests/bench/bench.c Makefile | $(DEPS)
	$(Q)mkdir -p $(@D) && $(BENCH) $(NATIVE) -c $< -o $@
$(BUILD)/bench/%: tests/bench/%.c $(BUILD)/bench/bench.o $(LIB)
	$(call say,cc,$<)
	$(Q)mkdir -p $(@D) && $(BENCH) $< -o $@ $(BUILD)/bench/bench.o \
	    $(LIB) $(LDFLAGS) $(GSL_LIBS) $$lapack
# One after the other, each time anew; the tables stay in build/data, and
# figures/bench_NAME_what.gp draws those of bench_NAME.tsv.
bench: $(BENCHES:%=$(BUILD)/bench/%)
	@mkdir -p $(BUILD)/data; for b in $(BENCHES); do \
	    data=$(BUILD)/data/bench_$$b.tsv; \
	    printf '  %-8s %s\n' bench "$$b, a minute or two" >&2; \
	    OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BUILD)/bench/$$b \
	        > $$data.part && mv $$data.part $$data && cat $$data || exit 1; \
	done
	@command -v gnuplot > /dev/null || exit 0; \
	for f in figures/bench_*.gp; do data=$${f%_*}.tsv; \
	    sh tests/tools/figure.sh $$f $(BUILD)/data/$${data#*/} \
	        $${f%.gp}.svg || exit 1; done

# ---- the whole, in other builds, and the closing line
.PHONY: all
programs: $(PROGRAMS) $(UNITS:%=$(BUILD)/unit/%)
all: programs $(PROGRAMS:=.judge) $(BENCHES:%=$(BUILD)/bench/%) \
     $(STUDIES:%=$(BUILD)/bench/%) \
     $(patsubst $(BUILD)/solutions/%,$(BUILD)/starters/%.judge,$(PROGRAMS))

# what any test may rest on
EVERYTHING := Makefile README.md workbook.md $(wildcard common/* solutions/* \
              lessons/* tests/*/* figures/*.gp)
$(T)/lint.result: $(EVERYTHING) | $(DEPS)
	$(call say,test,lint)
	$(Q)mkdir -p $(@D) && sh tests/tools/lint.sh > $@
$(T)/workbook.result: workbook.md $(DATA) tests/tools/workbook.awk solutions/*.c
	$(call say,test,workbook is in step with the programs)
	$(Q)mkdir -p $(@D) && if said=$$(sh tests/tools/workbook.sh check); \
	    then echo 'ok workbook is in step with the programs'; \
	    else echo "FAIL workbook: $$said"; fi > $@
# every figure can be drawn; those in figures/ are left as they are
$(T)/figures.result: $(DATA) $(wildcard figures/*.gp) tests/tools/figure.sh
	$(call say,test,figures)
	$(Q)mkdir -p $(@D) && for f in $(FIGURES); do \
	    name=$${f##*/}; slug=$$(ls $(BUILD)/data | sed 's/\.tsv$$//' | \
	        while read -r l; do case $$name in $${l}_*) echo $$l ;; esac; done); \
	    if said=$$(sh tests/tools/figure.sh $${f%.*}.gp $(BUILD)/data/$$slug.tsv \
	        $(@D)/$$name 2>&1); then echo "ok figure $$name"; \
	    else echo "FAIL figure $$name: $$said"; fi; done > $@
$(T)/cli.result: $(PROGRAMS) $(PROGRAMS:=.judge) $(DATA) $(EVERYTHING)
	$(call say,test,command lines)
	+$(Q)mkdir -p $(@D) && BUILD=$(BUILD) sh tests/cli/cli.sh > $@
$(T)/build-%.result: $(PROGRAMS) $(UNITS:%=$(BUILD)/unit/%) $(EVERYTHING)
	$(call say,test,$* build)
	+$(Q)mkdir -p $(@D) && BUILD=$(BUILD) \
	    sh tests/tools/build_variants.sh $* > $@

RESULTS := $(UNITS:%=$(T)/unit.%.result) \
           $(UNIT_MISTAKES:%=$(T)/unit-mistake.%.result) \
           $(foreach k,solution starter behave,$(LESSONS:%=$(T)/%.$k.result)) \
           $(patsubst %,$(T)/%.result,$(MISTAKES) $(EQUIVALENTS)) \
           $(T)/lint.result $(T)/workbook.result $(T)/figures.result \
           $(T)/cli.result \
           $(patsubst %,$(T)/build-%.result,gcc clang sanitize valgrind)
test: $(RESULTS)
	@cat $^ | sh tests/tools/count.sh

memcheck: $(T)/build-valgrind.result $(T)/build-sanitize.result
	@cat $^ | sh tests/tools/count.sh

# Progress and replaced files of the student stay.
clean:
	@for f in $(BUILD)/*; do case $$f in \
	    */progress|*/saved) ;; *) rm -rf "$$f" ;; esac; done

-include $(wildcard $(BUILD)/*/*.d $(BUILD)/mistakes/*/*.d)
