# course.mk - studies, pictures, the whole course; included by the Makefile.

T := $(BUILD)/test
.PHONY: figures course book bench

# Studies are named as NN_slug/what; speed/what, the fastest settings of
# work_precision, the fastest elements and the steps of particles are measured by
# `make bench`, many/many, which needs PETSc, by `make many`.  What is in the hand,
# figures/NN_slug/hand.c, is no study.
STUDIES := $(filter-out many/% %/hand,$(patsubst figures/%.c,%,$(sort $(filter-out \
               $(SHARED_BY_STUDIES),$(wildcard figures/*/*.c)))))
SPEED   := $(filter speed/% work_precision/fronts %/seconds,$(STUDIES))
COUNTED := $(filter-out $(SPEED),$(STUDIES))
HANDS   := $(SCENES:%=%/hand)

# ---- data -------------------------------------------------------------------------

OWN_PROGRAMS := $(addprefix $(BUILD)/figures/,$(COUNTED) $(HANDS))
$(OWN_PROGRAMS:=.o): OWN = $(or $(CHECKED),$(QUICK)) \
    $(if $(filter %/hand,$*),-I. -DPROGRAM='"solutions/$(notdir $(<D)).c"')
$(OWN_PROGRAMS:=.o): $(BUILD)/%.o: %.c $(RULES)
	$(COMPILED)
linked_with = $(if $(filter %/hand,$1),$(LIB),$(call needs,$1.c))
$(OWN_PROGRAMS): $(BUILD)/%: $(BUILD)/%.o $$(call linked_with,$$*)
	$(LINKED)
# A study whose claim is false ends with status 1 and leaves no data.  A scene that is
# made for the hand is replayed without a window.
$(patsubst %,$(BUILD)/data/%.tsv,$(COUNTED) $(HANDS)): $(BUILD)/data/%.tsv: $(BUILD)/figures/%
	$(call PRINTED,$< $(if $(filter %/hand,$*),--input hard))

# A script makes an SVG, or a GIF when it moves.  Its data come from the study of its
# name, or from the solution of its folder, with the options in its line "Yours".  What
# a study has more of than a chapter shows is drawn by NAME_all.gp.  A picture with
# seconds in it names the machine: of this machine it is drawn under build/figures/.
scripts_with = $(sort $(patsubst figures/%.gp,%,$(shell grep -l $1 figures/*/*.gp)))
SCRIPTS := $(sort $(patsubst figures/%.gp,%,$(wildcard figures/*/*.gp)))
MOVING  := $(call scripts_with,'^set terminal gif')
SQUARES := $(call scripts_with,'square.gp"')
ASKING  := $(filter-out $(STUDIES),$(call scripts_with,'^. Yours  '))
BENCHED := $(filter $(SPEED) $(SPEED:=_all),$(SCRIPTS))
TIMED   := $(sort $(BENCHED) $(call scripts_with,machine.data))
DRAWN   := $(filter-out $(BENCHED),$(SCRIPTS))
data_of = $(BUILD)/data/$(or $(filter $1 $(1:_all=),$(STUDIES) $(ASKING)),$(patsubst \
              %/,%,$(dir $1))).tsv
picture = figures/$1.$(if $(filter $1,$(MOVING)),gif,svg)
drawn   = $(if $(filter $1,$(TIMED)),$(BUILD)/)$(picture)

# The numbers of a chapter's Example are its lesson's, with the ARGS that stand there.
EXAMPLES := $(patsubst lessons/%.md,%,$(shell grep -l '^$(hash)$(hash) Example$$' \
                lessons/[0-9]*.md))
OPTIONS_OF = sed -n -e 's/^\# Yours *the lesson with //p' \
             -e '/^\#\# Example$$/,/^\#\# On paper$$/s/.*ARGS=.\([^`]*\).`.*/\1/p'
$(ASKING:%=$(BUILD)/data/%.tsv): $(BUILD)/data/%.tsv: figures/%.gp \
        $(BUILD)/solutions/$$(firstword $$(subst /, ,$$*))
	$(call PRINTED,$(lastword $^) $$($(OPTIONS_OF) $<))
$(EXAMPLES:%=$(BUILD)/data/%/example.tsv): $(BUILD)/data/%/example.tsv: lessons/%.md \
        $(BUILD)/solutions/%
	$(call PRINTED,$(lastword $^) $$($(OPTIONS_OF) $<))
# What the study on many processes has counted is in the tree.
$(BUILD)/data/many.tsv $(BUILD)/data/many/many.tsv: figures/many/many.tsv
	$(Q)$(HERE) && cp $< $@

# ---- pictures ---------------------------------------------------------------------

# One whose script, style and data are as they were is not drawn again.
define figure_rule
$(call drawn,$1): figures/$1.gp figures/style.gp $(call data_of,$1) \
        $(if $(filter $1,$(SQUARES)),$(wildcard figures/square.*))
	$$(Q)SAY=$$(if $$(V),,yes) sh tests/tools/figure.sh $$< $(call data_of,$1) $$@
endef
$(foreach f,$(SCRIPTS),$(eval $(call figure_rule,$f)))
# The map of the course is drawn from the heads of the chapters.
figures/map.svg: figures/map.awk $(wildcard lessons/[0-9]*.md figures/*/README.md)
	$(call say,map,$@)
	$(Q)$(WHOLE) awk -f $< $(filter %.md,$^) > $(PART) && $(MOVED)
FIGURES := figures/map.svg $(foreach f,$(DRAWN),$(call drawn,$f))
figures: $(FIGURES)
	@echo 'figures: $(words $(filter-out $(BUILD)/%,$^)) in figures/;' \
	      '$(words $(filter $(BUILD)/%,$^)) with seconds of this machine in $(BUILD)/figures/'
	@echo '  left to make bench, which takes minutes: $(BENCHED)'

# One figure, figure-16-principal, or all of a folder: figure-16, figure-speed.
dashed = $(subst -, ,$1)
folder_of = $(or $(filter $(firstword $(dashed))_%,$(LESSONS)),$(firstword $(dashed)))
asked_for = $(filter $(folder_of)/$(or $(word 2,$(dashed)),%),$(SCRIPTS))
figure-%: $$(foreach f,$$(filter $$(DRAWN),$$(call asked_for,$$*)),$$(call drawn,$$f))
	@[ -n '$(call asked_for,$*)' ] || { echo 'There is no figure-$*; there are:' \
	    >&2; printf '  %s\n' $(or $(notdir $(filter $(call folder_of,$*)/%,$(SCRIPTS))), \
	    $(patsubst %/,%,$(sort $(dir $(SCRIPTS))))) >&2; exit 2; }
	@printf '  %s\n' $^ $(patsubst %,'figures/%.svg is left to make bench',$(filter \
	    $(BENCHED),$(call asked_for,$*)))

# ---- course, book, speed ------------------------------------------------------------

# the longest first, so that no processor is without one at the end
LONGEST := $(filter 24_live/hard robustness/saddle %/pull %/front %/kept %/held_out,$(COUNTED))
course: $(LONGEST:%=$(BUILD)/data/%.tsv) $(LESSONS:%=$(T)/%.solution.result) figures \
        $(COUNTED:%=$(BUILD)/data/%.tsv)
	@cat $(filter %.solution.result,$^) | sh tests/tools/count.sh
	@echo 'course: $(words $(LESSONS)) solutions run and judged OK,' \
	      'the claims of $(words $(COUNTED)) studies hold'

# The book as HTML; pandoc is for this only, and make deps leaves it out.
book: ; @BUILD='$(BUILD)' sh tests/tools/book.sh

# Seconds are measured, never asserted.  LAPACK takes part where there is one, and
# CHOLMOD in the study that asks for it; GSL keeps the BLAS of its own.
RIVAL = $(if $(filter %/solvers,$*),$(call once,cholmod))
$(SPEED:%=$(BUILD)/figures/%): $(BUILD)/figures/%: figures/%.c $$(call needs,figures/$$*.c)
	$(call say,cc,$<)
	$(Q)$(HERE) && $(COMPILE) -DNATIVE_FLAGS='"$(strip $(NATIVE))"' \
	    $(if $(RIVAL),-DCHOLMOD) $(if $(call once,lapack),-DLAPACK='"$(call once,lapack)"') \
	    $(NATIVE) $< -o $(PART) $(filter %.o,$^) $(LDFLAGS) $(GSL_LIBS) $(RIVAL) \
	    $(call once,lapack) && $(MOVED)
TO_MEASURE := $(SPEED) $(filter $(COUNTED),$(TIMED))
bench: $(TO_MEASURE:%=$(BUILD)/figures/%)
	$(SHARED)@exec env BUILD='$(BUILD)' TIMED='$(TIMED)' sh tests/tools/bench.sh \
	    $(TO_MEASURE)
