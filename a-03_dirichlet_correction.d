03_dirichlet_correction.o: build/starters/03_dirichlet_correction.c \
 common/matrix.h common/status.h common/options.h common/table.h \
 common/matrix.h
common/matrix.h:
common/status.h:
common/options.h:
common/table.h:
common/matrix.h:
