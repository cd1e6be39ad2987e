/* cells.c - see cells.h. */
#include "cells.h"

#include "choice/relax.h"
#include "choice/rung.h"

#include <math.h>

static const double order = 1.42; /* at a held corner [eq:corner] */

const char *cells_name(enum element element)
{
    return element == LINEAR_TRIANGLE ? "linear" : "quadratic";
}

int cells_compare(const struct ladder_scene *scene, enum rung rung,
                  struct cells cells[CELLS])
{
    struct ladder_scene still = *scene;
    struct ladder_state *s[CELLS];
    static const struct cells kind[CELLS_KINDS] = {
        {.element = LINEAR_TRIANGLE, .grade = 1.0},
        {.element = LINEAR_TRIANGLE, .grade = 2.0},
        {.element = QUADRATIC_TRIANGLE, .grade = 1.0},
        {.element = QUADRATIC_TRIANGLE, .grade = 2.0}};
    const int best = CELLS - 1, before = best - 1;
    int n = 0;
    still.time = STANDS;
    for (int i = 0; i < CELLS_KINDS; i++)
        for (int level = 0; level < CELLS_LEVELS; level++, n++) {
            struct cells *c = &cells[n];
            *c = kind[i];
            c->level = level;
            s[n] = ladder_solve_of(c->element, c->grade, &still,
                                   (struct ladder_model){rung, 0, level});
            c->solved = s[n]->status == OK && ladder_stable(s[n]);
            c->flops = s[n]->flops;
        }
    const int known = cells[best].solved && cells[before].solved;
    const double own = known ? ladder_error(s[before], s[best]) /
                                   (pow(2.0, order) - 1.0) : INFINITY;
    for (int k = 0; k < CELLS; k++)
        cells[k].error = own + (known ? ladder_error(s[k], s[best]) : 0.0);
    for (int k = 0; k < CELLS; k++) ladder_free(s[k]);
    return known;
}

const struct cells *cells_cheapest(const struct cells cells[CELLS],
                                   double room)
{
    const struct cells *best = NULL;
    for (int k = 0; k < CELLS; k++)
        if (cells[k].solved && cells[k].error <= room &&
            (!best || cells[k].flops < best->flops))
            best = &cells[k];
    return best;
}
