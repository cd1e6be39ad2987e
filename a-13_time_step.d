13_time_step.o: build/starters/13_time_step.c common/body.h \
 common/material.h common/tensor.h common/matrix.h common/status.h \
 common/mesh.h common/clock.h common/options.h common/step.h \
 common/body.h common/table.h
common/body.h:
common/material.h:
common/tensor.h:
common/matrix.h:
common/status.h:
common/mesh.h:
common/clock.h:
common/options.h:
common/step.h:
common/body.h:
common/table.h:
