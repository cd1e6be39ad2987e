/*
 * dissected.h - K of the stretch, both ends held, by nested dissection.
 */
#ifndef FIGURES_DISSECTED_H
#define FIGURES_DISSECTED_H

#include "linear/sparse.h"

/* Return its analysis on n x n cells, for the caller to free. */
struct sparse *dissected(int n);

#endif
