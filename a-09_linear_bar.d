09_linear_bar.o: build/starters/09_linear_bar.c common/bar.h \
 common/material.h common/tensor.h common/matrix.h common/status.h \
 common/options.h common/poisson.h common/table.h
common/bar.h:
common/material.h:
common/tensor.h:
common/matrix.h:
common/status.h:
common/options.h:
common/poisson.h:
common/table.h:
