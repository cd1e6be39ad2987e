11_newton_failure.o: build/starters/11_newton_failure.c common/bar.h \
 common/material.h common/tensor.h common/matrix.h common/status.h \
 common/options.h common/table.h
common/bar.h:
common/material.h:
common/tensor.h:
common/matrix.h:
common/status.h:
common/options.h:
common/table.h:
