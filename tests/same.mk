# same.mk - the same numbers on every machine; included by tests.mk.
#
# All solutions, scenes in the hand and studies again, in two builds (same.sh): v8,
# vectors (vec.h) of eight numbers with contraction where the processor has it; and
# clang, all of it by that compiler, with vectors of two and no flag for this machine,
# or, where there is no clang, v2, so by CC.  In both the clock counts how often it is
# asked, so that no second need be excepted.  In the second the programs have the
# sanitizers, and what is reserved and not written has the bytes of NaN, so that a
# table shows who reads it.
#
# `make test` runs the solutions and scenes so; `make same`, as .ci/run does, the
# studies, too.

NARROW := $(if $(shell command -v clang 2>/dev/null),clang,v2)
STUDIED := $(if $(filter same,$(MAKECMDGOALS)),$(COUNTED))
RUNS := $(filter $(LONGEST),$(STUDIED)) $(LESSONS) $(EXAMPLES:=/example) $(HANDS) \
        $(filter-out $(LONGEST),$(STUDIED))
SAME = BUILD='$(BUILD)' READY='$(READY)' ALL_NATIVE='$(ALL_NATIVE)' RUNS='$(RUNS)' \
       SCRIPTS='$(filter-out $(TIMED),$(DRAWN))' sh tests/tools/same.sh
$(T)/same-v8.result $(T)/same-$(NARROW).result: $(T)/same-%.result: \
        $(RUNS:%=$(BUILD)/data/%.tsv) $(DATA) $(BOOK) $(DRAWN:%=$(T)/figures/%.result) \
        $(addprefix tests/tools/,same.sh same.awk clock.c workbook.awk) $$(READY)
	$(call RESULT,the same numbers: $*,$(SAME) $*)
$(T)/same-$(NARROW).result: $(T)/same-v8.result
# the figures in the tree are no prerequisites: they would be drawn
$(T)/same-here.result: $(DRAWN:%=$(T)/figures/%.result) tests/tools/same.sh always
	$(Q)$(SAME) here > $@
SAME_RESULTS := $(call results,same-here same-v8 same-$(NARROW))
.PHONY: same
$(if $(STUDIED),$(eval $(SAME_RESULTS): always))
same: $(SAME_RESULTS)
	@cat $^ | sh tests/tools/count.sh
