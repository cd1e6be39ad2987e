# many.mk - the study on many processes, which alone needs PETSc and MPI.
#
# Without them `make many` and `make test-many` say so in one line, and the book
# is filled from the counts that figures/many/many.tsv keeps.

.PHONY: many test-many many-programs

MANY := $(BUILD)/figures/many
MANY_FILES := $(wildcard figures/many/*.[ch])
have_many = pkg-config --exists petsc 2>/dev/null && \
            command -v mpicc > /dev/null && command -v mpirun > /dev/null
no_many = no PETSc with MPI here; make deps-many installs it

# The headers of PETSc are not ours to warn about.
MANY_CC = OMPI_CC='$(CC)' mpicc $(STD) $(STRICT) $(CFLAGS) -Icommon \
          $(GSL_CFLAGS) $$(pkg-config --cflags petsc | sed 's/-I */-isystem /g')
# -rdynamic: a library that starts threads finds our own start of them (peer.c)
MANY_LIBS = $(LINK) -rdynamic $$(pkg-config --libs petsc)
$(MANY)/many $(MANY)/peer: $(MANY)/%: $(MANY_FILES) $(LIB) Makefile tests/many.mk
	$(call say,mpicc,figures/many/$*.c)
	$(Q)$(HERE) && $(WHOLE) $(MANY_CC) figures/many/$*.c -o $(PART) \
	    $(MANY_LIBS) && $(MOVED)
MANY_WRONG := $(shell $(VARIANT) -v list=mistake tests/many/mistakes.txt)
$(MANY_WRONG:%=$(MANY)/%/many): $(MANY)/%/many: tests/many/mistakes.txt \
        $(MANY_FILES) $(LIB) tests/tools/variant.awk
	$(call say,mpicc,figures/many/ with $*)
	$(Q)$(HERE) && cp $(MANY_FILES) $(@D)
	$(Q)file=$$($(VARIANT) -v name=$* -v get=file $<) && $(VARIANT) \
	    -v name=$* $< figures/many/$$file > $(@D)/$$file
	$(Q)$(MANY_CC) $(@D)/many.c -o $@ $(MANY_LIBS)
many-programs: $(MANY)/many $(MANY_WRONG:%=$(MANY)/%/many)

many:
	$(SHARED)@if $(have_many); then "$$MAKE" many-programs && \
	    BUILD='$(BUILD)' sh tests/tools/many.sh measure; \
	else echo 'many: $(no_many)'; fi
test-many: $(T)/many.result
	@if grep '^skip many: no' $<; then :; else sh tests/tools/count.sh < $<; fi

# what was left out is tried again: PETSc may be there now
.PHONY: many-again
many-again: ;
$(T)/many.result: $(shell grep -qs '^skip many: no' $(T)/many.result && \
        echo many-again) $(MANY_FILES) $(LIB) figures/many/many.tsv \
        tests/many.mk tests/many/mistakes.txt tests/tools/many.sh tests/tools/many.awk \
        tests/tools/mpirun.sh
	$(call say,test,many processes)
	$(SHARED)$(Q)$(HERE) && if $(have_many); then \
	    "$$MAKE" many-programs > $@.log 2>&1 && \
	    BUILD='$(BUILD)' sh tests/tools/many.sh test > $@ || \
	    { echo 'FAIL many:'; cat $@.log; } > $@; \
	else echo 'skip many: $(no_many)' > $@; fi

# What a step takes beside PETSc: measured by `make bench`, where there is one;
# else the numbers of the machine that they name.
.PHONY: peer
peer:
	$(SHARED)@mkdir -p $(BUILD)/data/many; to=$(BUILD)/data/many/peer.tsv; \
	if $(have_many); then "$$MAKE" $(MANY)/peer && \
	    printf '  %-8s %s\n' bench many/peer >&2 && \
	    OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 OMP_THREAD_LIMIT=1 \
	        $(MANY)/peer > $$to.part && mv $$to.part $$to && \
	    cp $$to figures/many/peer.tsv; \
	else cp figures/many/peer.tsv $$to; fi

$(BUILD)/data/many/many.tsv: figures/many/many.tsv
	$(Q)$(HERE) && cp $< $@
