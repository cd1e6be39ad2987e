02_constitutive.o: build/starters/02_constitutive.c common/material.h \
 common/tensor.h common/options.h common/status.h common/table.h \
 common/matrix.h common/status.h common/tensor.h
common/material.h:
common/tensor.h:
common/options.h:
common/status.h:
common/table.h:
common/matrix.h:
common/status.h:
common/tensor.h:
