08_element_assembly.o: build/starters/08_element_assembly.c \
 common/clock.h common/matrix.h common/status.h common/options.h \
 common/poisson.h common/matrix.h common/table.h
common/clock.h:
common/matrix.h:
common/status.h:
common/options.h:
common/poisson.h:
common/matrix.h:
common/table.h:
