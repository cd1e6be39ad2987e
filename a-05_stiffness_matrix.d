05_stiffness_matrix.o: build/starters/05_stiffness_matrix.c \
 common/clock.h common/options.h common/poisson.h common/matrix.h \
 common/status.h common/table.h
common/clock.h:
common/options.h:
common/poisson.h:
common/matrix.h:
common/status.h:
common/table.h:
