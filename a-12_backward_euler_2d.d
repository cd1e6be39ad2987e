12_backward_euler_2d.o: build/starters/12_backward_euler_2d.c \
 common/material.h common/tensor.h common/matrix.h common/status.h \
 common/options.h common/table.h common/matrix.h
common/material.h:
common/tensor.h:
common/matrix.h:
common/status.h:
common/options.h:
common/table.h:
common/matrix.h:
