# same.mk - the same numbers on every machine; included by tests.mk.
#
# All solutions and studies again, in two builds: v8, vectors (vec.h) of eight
# numbers with contraction where the processor has it, for which only what has a
# vec is compiled anew; and clang, all of it by that compiler, with vectors of two
# and no contraction, or, where there is no clang, v2, the same by CC.  In both
# the clock counts how often it is asked, so that no second need be excepted.
# tests/tools/same.sh compares their tables, and what becomes of them.

WITH_VEC := $(filter %/tiles.o %/front.o %/readable.o,$(OBJECTS:$(BUILD)/%=%))
NARROW := $(if $(shell command -v clang 2>/dev/null),clang,v2)
vec_flags = $(if $(filter v8,$1),$(ALL_NATIVE) -DVEC_WIDTH=8,-DVEC_WIDTH=2)
$(T)/clang/%: override CC := clang
$(T)/clang/%: override CFLAGS := -O1

# $(call same_rules,BUILD,folder of all other objects)
define same_rules
$(WITH_VEC:%=$(T)/$1/%): $(T)/$1/%.o: %.c Makefile
	$(Q)mkdir -p $$(@D) && $$(COMPILE) $$(call vec_flags,$1) $$< $$(OBJECT)
$(T)/$1/clock.o: tests/tools/clock.c common/base/clock.h Makefile
	$(Q)mkdir -p $$(@D) && $$(COMPILE) $$< $$(OBJECT)
$(T)/$1/libworkbook.a: $(T)/$1/clock.o $(WITH_VEC:%=$(T)/$1/%) \
        $(addprefix $2/,$(filter-out %/clock.o $(WITH_VEC),$(OBJECTS:$(BUILD)/%=%)))
	$(Q)rm -f $$@ && ar rcs $$@ $$^
$(PARTS:$(BUILD)/%=$(T)/$1/%): $(T)/$1/%: $2/%.o $(T)/$1/libworkbook.a
	$(Q)mkdir -p $$(@D) && $$(CC) $$(CFLAGS) $$^ -o $$@ $$(LIBS)
$(LESSONS:%=$(T)/$1/data/%.tsv): $(T)/$1/data/%.tsv: $(T)/$1/solutions/%
	$(call say,run,$1 $$*)
	$(Q)$$(SAME_RUN)
$(COUNTED:%=$(T)/$1/data/%.tsv): $(T)/$1/data/%.tsv: $(T)/$1/figures/%
	$(call say,study,$1 $$*)
	$(Q)$$(SAME_RUN)
$(T)/same-$1.result: $(LESSONS:%=$(T)/$1/data/%.tsv) $(COUNTED:%=$(T)/$1/data/%.tsv) \
        $(if $(filter-out v8,$1),$(LESSONS:%=$(T)/v8/data/%.tsv) \
        $(COUNTED:%=$(T)/v8/data/%.tsv)) $(DATA) $(BOOK) \
        $(foreach f,$(DRAWN),$(T)/figure.$(subst /,.,$f).result) \
        tests/tools/same.sh tests/tools/same.awk tests/tools/workbook.awk
	$(call say,test,the same numbers: $1)
	$(Q)BUILD='$(BUILD)' SCRIPTS='$(filter-out $(TIMED),$(DRAWN))' \
	    sh tests/tools/same.sh $1 > $$@
endef
# a claim that does not hold there leaves no table, and its words
SAME_RUN = mkdir -p $(@D) && { $< > $@.part 2> $@.said || : > $@.part; } && \
           mv $@.part $@
$(foreach s,v2 v8,$(eval $(call same_rules,$s,$(BUILD))))
$(eval $(call same_rules,clang,$(T)/clang))
$(patsubst $(BUILD)/%.o,$(T)/clang/%.o,$(filter-out $(WITH_VEC:%=$(BUILD)/%), \
    $(OBJECTS)) $(PARTS:=.o)): $(T)/clang/%.o: %.c Makefile
	$(Q)mkdir -p $(@D) && $(COMPILE) -DBUILD_FLAGS='""' $< $(OBJECT)
-include $(wildcard $(T)/*/common/*/*.d $(T)/*/solutions/*.d $(T)/*/figures/*/*.d)
# the figures in the tree are no prerequisites: they would be drawn
.PHONY: always
$(T)/same-here.result: $(foreach f,$(DRAWN),$(T)/figure.$(subst /,.,$f).result) \
        tests/tools/same.sh always
	$(Q)BUILD='$(BUILD)' SCRIPTS='$(filter-out $(TIMED),$(DRAWN))' \
	    sh tests/tools/same.sh here > $@
SAME_RESULTS := $(T)/same-here.result $(T)/same-v8.result $(T)/same-$(NARROW).result \
                $(T)/same.result
$(T)/same.result: tests/cli/same.sh tests/tools/same.awk
	$(Q)mkdir -p $(@D) && sh $< > $@
