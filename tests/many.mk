# many.mk - the study on many processes, which alone needs PETSc and MPI.
#
# Without them `make many` and `make test-many` say so in one line, and the book
# is filled from the counts that figures/many/many.tsv keeps.

.PHONY: many test-many peer
MANY = BUILD='$(BUILD)' OMPI_CC='$(CC)' LINK='$(LINK)' FLAGS='$(STD) $(STRICT) $(CFLAGS) \
       -Icommon $(GSL_CFLAGS)' sh tests/tools/many.sh
# peer, what a step takes beside PETSc, is measured by `make bench`, where there is one;
# else the numbers are those of the machine that they name.
many peer: $(LIB)
	@$(MANY) $@
test-many: $(T)/many.result
	@if grep '^skip many: no' $<; then :; else sh tests/tools/count.sh < $<; fi
$(T)/many.result: $(wildcard figures/many/*.[ch]) $(LIB) figures/many/many.tsv \
        tests/many/mistakes.txt tests/tools/many.sh tests/tools/many.awk tests/tools/mpirun.sh
	$(call RESULT,many processes,$(MANY) test)
