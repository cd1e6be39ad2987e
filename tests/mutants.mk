# mutants.mk - how many small mistakes do the judges and the unit laws find?
#
#     make mutants            every lesson: minutes
#     make mutants-07         one lesson; SEED=2 takes others, N=100 more
#     make mutants-common     common/, by the unit programs
#
# Not part of `make test`.  The survivors are in build/mutants/NAME.txt.

SEED = 1
# mutants of a lesson, and of each file of common/
N = 60
N_COMMON = 12
MUTANTS = BUILD='$(BUILD)' SEED='$(SEED)' LINK='$(LINK)' JUDGE='$(JUDGE)' \
          CC_MUTANT='$(CC) $(STD) -O0 -w $(BOUNDS) -Icommon $(GSL_CFLAGS)' \
          sh tests/tools/mutants.sh

.PHONY: mutants mutants-head mutants-common
define mutants_rule
.PHONY: mutants-$(call number,$1)
mutants-$(call number,$1): $(BUILD)/solutions/$1 $(call judge_of,$1) $(LIB) mutants-head
	@N='$(N)' $$(MUTANTS) lesson $1
endef
$(foreach l,$(LESSONS),$(eval $(call mutants_rule,$l)))
mutants-head: ; @$(MUTANTS) head

# one after the other: each of them keeps two processors busy
mutants: $(LESSONS:%=$(BUILD)/solutions/%) $(foreach l,$(LESSONS),$(call \
        judge_of,$l)) $(LIB) mutants-head
	@for l in $(LESSONS); do N='$(N)' $(MUTANTS) lesson $$l || exit 1; done

# for the sanitizers; without them where there are none
$(BUILD)/mutants/unit/%.san.o: tests/unit/%.c Makefile
	$(Q)$(HERE) && for flags in -fsanitize=address,undefined ''; do \
	    $(COMPILE) $(UNIT_FLAGS) $$flags -c $< -o $@ && break; done
MUTANT_FILES = $(OBJECTS:$(BUILD)/%.o=%.c)
MUTANTS_COMMON = BUILD='$(BUILD)' SEED='$(SEED)' N='$(N_COMMON)' \
    UNITS='$(UNITS)' LINK='$(UNIT_LIBS)' NATIVE='$(NATIVE)' \
    NATIVE_BODY='$(call same_digits,$(NATIVE))' \
    CC_MUTANT='$(CC) $(STD) $(CFLAGS) -Werror=return-type -Icommon \
    $(GSL_CFLAGS) -DBUILD_FLAGS="\"\""' sh tests/tools/mutants.sh
mutants-common: $(UNITS:%=$(BUILD)/unit/%.o) $(BUILD)/unit/unit.o \
                $(UNITS:%=$(BUILD)/mutants/unit/%.san.o) $(LIB) mutants-head
	@$(MUTANTS_COMMON) common $(MUTANT_FILES)
