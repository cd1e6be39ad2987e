# mutants.mk - how many small mistakes do the judges and the unit laws find?
#
#     make mutants            every lesson: minutes
#     make mutants-07         one lesson; SEED=2 takes others, N=100 more
#     make mutants-common     common/, by the unit programs
#
# Not part of `make test`.  The survivors are in build/mutants/NAME.txt.

MUTANTS = BUILD='$(BUILD)' CC_MUTANT='$(CC) $(STD) $1 -Icommon $(GSL_CFLAGS)' \
          sh tests/tools/mutants.sh
.PHONY: mutants mutants-common $(call goals,mutants)
# one after the other: each of them keeps two processors busy
mutants $(call goals,mutants): $(LIB) $$(foreach l,$$(or $$(call lesson,$$@),$(LESSONS)),\
        $(BUILD)/solutions/$$l $$(call judge_of,$$l))
	@JUDGE='$(JUDGE)' LINK='$(LINK)' $(call MUTANTS,-O0 -w $(BOUNDS)) lesson \
	    $(or $(call lesson,$@),$(LESSONS))

# for the sanitizers; without them where there are none
$(BUILD)/mutants/unit/%.san.o: tests/unit/%.c Makefile
	$(Q)$(HERE) && for flags in -fsanitize=address,undefined ''; do \
	    $(COMPILE) $(UNIT_FLAGS) $$flags -c $< -o $@ && break; done
mutants-common: $(UNITS:%=$(BUILD)/unit/%.o) $(BUILD)/unit/unit.o \
                $(UNITS:%=$(BUILD)/mutants/unit/%.san.o) $(LIB) $(BUILD)/libchoose.a
	@UNITS='$(UNITS)' LINK='$(UNIT_LIBS)' NATIVE='$(NATIVE)' \
	    NATIVE_BODY='$(call same_digits,$(NATIVE))' $(call MUTANTS,$(CFLAGS) \
	    -Werror=return-type -DBUILD_FLAGS="\"\"") common $(patsubst $(BUILD)/%.o,%.c,$(OBJECTS) $(CHOOSE))
