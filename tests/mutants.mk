# mutants.mk - how many small mistakes do the judges find, in all lessons or in one, and
# the unit laws, in common/?  SEED=2 takes others, N=100 more (mutants.sh).

MUTANTS = BUILD='$(BUILD)' CC_MUTANT='$(CC) $(STD) $1 -Icommon $(GSL_CFLAGS)' \
          sh tests/tools/mutants.sh
.PHONY: mutants mutants-common $(call goals,mutants)
# one after the other: each of them keeps two processors busy
mutants $(call goals,mutants): $(LIB) $$(foreach l,$$(or $$(call lesson,$$@),$(LESSONS)),\
        $(BUILD)/solutions/$$l $$(call judge_of,$$l))
	@JUDGE='$(JUDGE)' LINK='$(LINK)' $(call MUTANTS,-O0 -w $(BOUNDS)) lesson \
	    $(or $(call lesson,$@),$(LESSONS))

mutants-common: $(patsubst %,$(BUILD)/unit/%.o,$(UNITS) unit) $(LIB) $(BUILD)/libchoose.a
	@UNITS='$(UNITS)' UNIT_FLAGS='$(UNIT_FLAGS)' LINK='$(UNIT_LIBS)' NATIVE='$(NATIVE)' \
	    NATIVE_BODY='$(call same_digits,$(NATIVE))' $(call MUTANTS,$(CFLAGS) \
	    -Werror=return-type -DBUILD_FLAGS="\"\"") common $(patsubst $(BUILD)/%.o,%.c,$(OBJECTS) $(CHOOSE))
