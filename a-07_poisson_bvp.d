07_poisson_bvp.o: build/starters/07_poisson_bvp.c common/options.h \
 common/poisson.h common/matrix.h common/status.h common/table.h
common/options.h:
common/poisson.h:
common/matrix.h:
common/status.h:
common/table.h:
