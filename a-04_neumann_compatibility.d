04_neumann_compatibility.o: build/starters/04_neumann_compatibility.c \
 common/options.h common/poisson.h common/matrix.h common/status.h \
 common/table.h
common/options.h:
common/poisson.h:
common/matrix.h:
common/status.h:
common/table.h:
