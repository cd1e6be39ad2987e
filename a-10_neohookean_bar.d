10_neohookean_bar.o: build/starters/10_neohookean_bar.c \
 common/bar_scene.h common/bar.h common/material.h common/tensor.h \
 common/matrix.h common/status.h common/options.h common/table.h
common/bar_scene.h:
common/bar.h:
common/material.h:
common/tensor.h:
common/matrix.h:
common/status.h:
common/options.h:
common/table.h:
