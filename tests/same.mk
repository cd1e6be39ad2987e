# same.mk - the same numbers on every machine; included by tests.mk.
#
# All solutions, scenes in the hand and studies again, in two builds: v8, vectors
# (vec.h) of eight numbers with contraction where the processor has it, and what is
# EXACT with all flags for this machine but that, for which only these are compiled
# anew;
# and clang, all of it by that compiler, with vectors of two and no flag for this
# machine, or, where there is no clang, v2, these files so by CC.  In both the
# clock counts how often it is asked, so that no second need be excepted.
# tests/tools/same.sh compares their tables, and what becomes of them.
#
# In the second the programs themselves have the sanitizers, and what is reserved
# and not written has the bytes of NaN, so that a table shows who reads it.
#
# `make test` runs the solutions and scenes so; `make same`, as .ci/run does, the studies, too.

ANEW := $(filter %/tiles.o %/front.o %/readable.o $(addprefix %/,$(EXACT:=.o)), \
            $(OBJECTS:$(BUILD)/%=%))
NARROW := $(if $(shell command -v clang 2>/dev/null),clang,v2)
# $(call anew_flags,BUILD,name of the file)
anew_flags = $(if $(filter v8,$1),$(if $(filter $(EXACT),$2),$(call \
                 same_digits,$(ALL_NATIVE)),$(ALL_NATIVE) -DVEC_WIDTH=8), \
                 -DVEC_WIDTH=2)
$(T)/clang/%: override CC := clang
$(T)/clang/%: override CFLAGS := -O2
# whatever CC can, which takes flags of clang's only where it is clang
ask_checked = $(shell for f in '-ftrivial-auto-var-init=pattern' ''; do \
                  set -- -fsanitize=address,undefined -fno-sanitize-recover=all $$f; \
                  mkdir -p $(T) && echo 'int main(void) { return 0; }' | $(or \
                  $(filter clang,$(NARROW)),$(CC)) "$$@" -x c - -o $(T)/checked.out \
                  2>/dev/null && $(T)/checked.out && echo "$$@" && break; done)
CHECKED = $(call once,checked)

# Scenes, replayed without a window (figures/NN_slug/hand.c).
HANDS := $(SCENES:%=%/hand)
HELD = -I. -DPROGRAM='"solutions/$(notdir $(<D)).c"'
STUDIED := $(if $(filter same,$(MAKECMDGOALS)),$(COUNTED))
# the longest first
RUNS := $(filter work_precision/% 23_least_model/% 25_elements/% 24_live/%, \
            $(STUDIED)) $(LESSONS) $(EXAMPLES:=/example) $(HANDS) $(STUDIED)
# $(call same_rules,BUILD,folder of all other objects,folder of the programs)
define same_rules
$(ANEW:%=$(T)/$1/%): $(T)/$1/%.o: %.c $(RULES)
	$(Q)$$(HERE) && $$(COMPILE) $$(call \
	    anew_flags,$1,$$(notdir $$*)) $$< $$(OBJECT)
$(T)/$1/clock.o: tests/tools/clock.c common/base/clock.h $(RULES)
	$(Q)$$(HERE) && $$(COMPILE) $$< $$(OBJECT)
$(T)/$1/libworkbook.a: $(T)/$1/clock.o $(ANEW:%=$(T)/$1/%) \
        $(addprefix $2/,$(filter-out %/clock.o $(ANEW),$(OBJECTS:$(BUILD)/%=%)))
	$(Q)rm -f $$@ && ar rcs $$@ $$^
$(LESSONS:%=$(T)/$1/data/%.tsv): $(T)/$1/data/%.tsv: $3/solutions/%.o \
        $(T)/$1/libworkbook.a $(if $(filter v8,$1),$(BUILD)/data/%.tsv)
	$(call say,run,$1 $$*)
	$(Q)$$(call SAME_RUN,$1)
$(EXAMPLES:%=$(T)/$1/data/%/example.tsv): $(T)/$1/data/%/example.tsv: \
        $3/solutions/%.o $(T)/$1/libworkbook.a lessons/%.md \
        $(if $(filter v8,$1),$(BUILD)/data/%/example.tsv)
	$(call say,run,$1 $$* example)
	$(Q)$$(call SAME_RUN,$1,$$$$($$(ARGS_OF) lessons/$$*.md),/example)
$(COUNTED:%=$(T)/$1/data/%.tsv): $(T)/$1/data/%.tsv: $3/figures/%.o \
        $(T)/$1/libworkbook.a $(if $(filter v8,$1),$(BUILD)/data/%.tsv)
	$(call say,study,$1 $$*)
	$(Q)$$(call SAME_RUN,$1)
$(HANDS:%=$(T)/$1/data/%.tsv): $(T)/$1/data/%.tsv: $3/figures/%.o \
        $(T)/$1/libworkbook.a $(if $(filter v8,$1),$(BUILD)/data/%.tsv)
	$(call say,run,$1 $$*)
	$(Q)$$(call SAME_RUN,$1,--input hard)
$(T)/same-$1.result: $(RUNS:%=$(T)/$1/data/%.tsv) \
        $(if $(filter-out v8,$1),$(RUNS:%=$(T)/v8/data/%.tsv)) $(DATA) $(BOOK) \
        $(foreach f,$(DRAWN),$(T)/figure.$(subst /,.,$f).result) \
        tests/tools/same.sh tests/tools/same.awk tests/tools/workbook.awk
	$(call say,test,the same numbers: $1)
	$(Q)BUILD='$(BUILD)' SCRIPTS='$(filter-out $(TIMED),$(DRAWN))' \
	    RUNS='$(sort $(RUNS))' sh tests/tools/same.sh $1 > $$@
endef
# A program is linked to be run once.  A claim that does not hold there leaves no
# table, and its words.  Where the main build has the flags and the vectors of v8,
# hence its code, the tables are those of the main build already, but for those
# with seconds, which name the machine.
ask_v8 = $(shell [ '$(strip $(NATIVE))' = '$(strip $(ALL_NATIVE))' ] && $(CC) \
             $(NATIVE) -Icommon -dM -E -include linear/vec.h -x c /dev/null | \
             grep 'VEC_WIDTH 8$$' > /dev/null && echo yes)
V8_HERE = $(call once,v8)
# $(call SAME_RUN,BUILD,options,/example where it is one)
MAIN = $(BUILD)/data/$*$3.tsv
SAME_RUN = $(HERE) && $(if $(and $(filter v8,$1),$(V8_HERE)),if ! grep -q \
           '^. machine: ' $(MAIN); then : > $@.said; cp $(MAIN) $@.part; else) \
           { $(CC) $(CFLAGS) $(if $(filter $(NARROW),$1),$(CHECKED)) $(filter \
           %.o %.a,$^) -Wl,-S -o $@.program $(if $(filter \
           v8,$1),$(LIBS),$(filter-out $(FAST_LD),$(LIBS))) && \
           { $(FILLED) $@.program $2 > $@.part 2> $@.said || : > $@.part; } && rm $@.program; } \
           $(if $(and $(filter v8,$1),$(V8_HERE)),; fi) && mv $@.part $@
FILLED = ASAN_OPTIONS=malloc_fill_byte=255:max_malloc_fill_size=1000000000
$(eval $(call same_rules,v8,$(BUILD),$(BUILD)))
$(eval $(call same_rules,v2,$(BUILD),$(T)/v2))
$(eval $(call same_rules,clang,$(T)/clang,$(T)/clang))
$(patsubst $(BUILD)/%.o,$(T)/clang/%.o,$(filter-out $(ANEW:%=$(BUILD)/%), \
    $(OBJECTS))): $(T)/clang/%.o: %.c $(RULES)
	$(Q)$(HERE) && $(COMPILE) -DBUILD_FLAGS='""' $(filter -ftrivial%,$(CHECKED)) \
	    $< $(OBJECT)
$(PARTS:$(BUILD)/%=$(T)/$(NARROW)/%.o): $(T)/$(NARROW)/%.o: %.c $(RULES)
	$(Q)$(HERE) && $(COMPILE) -O0 -g1 $(CHECKED) $< $(OBJECT)
$(HANDS:%=$(BUILD)/figures/%.o): $(BUILD)/%.o: %.c $(RULES)
	$(Q)$(HERE) && $(COMPILE) $(QUICK) $(HELD) $< $(OBJECT)
$(HANDS:%=$(T)/$(NARROW)/figures/%.o): $(T)/$(NARROW)/%.o: %.c $(RULES)
	$(Q)$(HERE) && $(COMPILE) -O0 -g1 $(CHECKED) $(HELD) $< $(OBJECT)
$(HANDS:%=$(BUILD)/data/%.tsv): $(BUILD)/data/%.tsv: $(BUILD)/figures/%.o $(LIB)
	$(Q)$(HERE) && $(WHOLE) $(CC) $(CFLAGS) $^ $(LIBS) -o $@.program && \
	    $@.program --input hard > $(PART) && rm $@.program && $(MOVED)
# What clang says of these it need not be asked for again.
SEEN_clang = $(if $(filter clang,$(NARROW)),$(filter-out $(ANEW:.o=), \
                 $(patsubst $(BUILD)/%.o,%,$(NOT_NATIVE)) \
                 $(LESSONS:%=solutions/%) $(STUDIED:%=figures/%)))
SAID_clang = $(SEEN_clang:%=$(T)/clang/%.o.said)
$(T)/build-clang.result: $$(basename $$(SAID_clang))
-include $(wildcard $(T)/*/common/*/*.d $(T)/*/solutions/*.d $(T)/*/figures/*/*.d)
# the figures in the tree are no prerequisites: they would be drawn
.PHONY: always
$(T)/same-here.result: $(foreach f,$(DRAWN),$(T)/figure.$(subst /,.,$f).result) \
        tests/tools/same.sh always
	$(Q)BUILD='$(BUILD)' SCRIPTS='$(filter-out $(TIMED),$(DRAWN))' \
	    sh tests/tools/same.sh here > $@
SAME_RESULTS := $(patsubst %,$(T)/same-%.result,here v8 $(NARROW))
# Tables that are missing are made for a result that is to be made alone.
.PHONY: same
SAME_ALL := $(patsubst %,$(T)/same-%.result,v8 $(NARROW))
$(if $(filter same,$(MAKECMDGOALS)),$(eval $(SAME_ALL): always))
same: $(SAME_ALL)
	@cat $^ | sh tests/tools/count.sh
