06_quadrature.o: build/starters/06_quadrature.c common/matrix.h \
 common/status.h common/options.h common/poisson.h common/matrix.h \
 common/table.h
common/matrix.h:
common/status.h:
common/options.h:
common/poisson.h:
common/matrix.h:
common/table.h:
