10_neohookean_bar.o: build/starters/10_neohookean_bar.c common/bar.h \
 common/material.h common/tensor.h common/matrix.h common/status.h \
 common/bar_fast.h common/bar.h common/clock.h common/options.h \
 common/poisson.h common/table.h
common/bar.h:
common/material.h:
common/tensor.h:
common/matrix.h:
common/status.h:
common/bar_fast.h:
common/bar.h:
common/clock.h:
common/options.h:
common/poisson.h:
common/table.h:
