01_deformation.o: build/starters/01_deformation.c common/material.h \
 common/tensor.h common/options.h common/poisson.h common/matrix.h \
 common/status.h common/table.h common/tensor.h
common/material.h:
common/tensor.h:
common/options.h:
common/poisson.h:
common/matrix.h:
common/status.h:
common/table.h:
common/tensor.h:
