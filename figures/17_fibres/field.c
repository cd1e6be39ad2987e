/*
 * field.c - what does a bent muscle do when it is activated?
 *
 * A block (-1, 1) x (-1/2, 1/2) m of the cubic law, its fibres bent along X1 by
 * -45 degrees per metre, activated from 0 to 1 in ten steps; both ends held, or
 * the left one.  Tables: history (root mean square of the angle; force on the
 * right end, u of its middle), fibres (pieces in place, stretch), outline.
 */
#include "plane/fibre.h"
#include "plane/scene.h"
#include "../13_backward_euler_2d/corners.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

enum { CELLS = 24, SLENDER = 2, STEPS = 10 };

/* In table fibres: the centre of each second cell, and a piece of fibre. */
static void print_fibres(const char *block, const struct scene *s,
                         const struct fibres *fibres)
{
    for (int j = 0; j < s->mesh->rows; j++)
        for (int i = 0; i < CELLS; i++) {
            if ((i + j) % 2) continue;
            const int e = 2 * (j * CELLS + i);
            double x[6], angle;
            const double l = fibres_stretch(s->body, fibres, s->u, e, &angle);
            corners_of(s, e, x); /* its corners 0 and 2: a diagonal */
            table_row(block, (x[0] + x[4]) / 2.0, (x[1] + x[5]) / 2.0,
                      l * cos(angle), l * sin(angle), l);
        }
}

/* In table outline: the vertices of the boundary, once around. */
static void print_outline(const char *block, const struct scene *s)
{
    const int n = s->mesh->n, rows = s->mesh->rows;
    const int step[4] = {1, n + 1, -1, -(n + 1)};
    const int edges[4] = {n, rows, n, rows + 1}; /* and back to the first */
    for (int side = 0, a = 0; side < 4; side++)
        for (int k = 0; k < edges[side]; k++) {
            table_row(block, s->mesh->X[2 * a] + s->u[2 * a],
                      s->mesh->X[2 * a + 1] + s->u[2 * a + 1]);
            a += step[side];
        }
}

static double bend_of(const struct scene *s, const struct fibres *fibres)
{
    double sum = 0.0, angle;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        fibres_stretch(s->body, fibres, s->u, e, &angle);
        sum += angle * angle / s->mesh->n_triangle;
    }
    return sqrt(sum) * 45.0 / atan(1.0);
}

/* The force that the right end needs in order to stay, and its middle. */
static double end_force(const struct scene *s, double *move)
{
    double *q = allocate((size_t)s->n_dof, sizeof *q), sum = 0.0;
    const int n = s->mesh->n;
    if (body_force(s->body, s->u, q) != OK) die("no force");
    for (int j = 0; j <= s->mesh->rows; j++) sum += q[2 * (j * (n + 1) + n)];
    free(q);
    *move = s->u[2 * (s->mesh->rows / 2 * (n + 1) + n)];
    return sum;
}

int main(void)
{
    static const char *const name[] = {"rest", "both", "left"};
    const struct step_control newton = step_method("search");
    struct scene *block[3];
    struct fibres fibres = {fibre_muscle(0.0), NULL};
    double bend[3][STEPS + 1], force[3], move[3];
    int stable = 0;
    gsl_set_error_handler_off();
    table_begin("history", "held activation degrees force move iterations");
    for (int b = 0; b < 3; b++) {
        struct scene_setting set =
            scene_notes(b == 1 ? STRETCH : GRAVITY, CUBIC, CELLS);
        set.slender = SLENDER;
        set.rho = set.force = 0.0;
        struct scene *s = block[b] = scene_alloc(&set);
        if (!fibres.angle) fibres.angle = fibres_bent(s->mesh, 0.0, -45.0);
        fibres_attach(s->body, &fibres);
        if (b == 0) continue;
        for (int k = 0; k <= STEPS; k++) {
            fibres.fibre.activation = k / (double)STEPS;
            const struct step_report r =
                step_solve(s->body, &newton, at_rest(s->f), s->u);
            if (r.status != OK) die("no state: %s", status_name(r.status));
            bend[b][k] = bend_of(s, &fibres);
            force[b] = end_force(s, &move[b]);
            table_row(name[b], fibres.fibre.activation, bend[b][k], force[b],
                      move[b], r.iterations);
        }
        stable += step_certify(s->body, at_rest(NULL), s->u) == OK;
    }
    table_end();
    table_begin("fibres", "block x y dx dy l");
    for (int b = 0; b < 3; b++) print_fibres(name[b], block[b], &fibres);
    table_end();
    table_begin("outline", "block x y");
    for (int b = 0; b < 3; b++) print_outline(name[b], block[b]);
    table_end();
    for (int b = 0; b < 3; b++) scene_free(block[b]);
    free((void *)fibres.angle);
    claim(stable == 2, "both states are stable");
    claim(fabs(bend[1][0] - 26.0) < 0.1 && fabs(bend[1][STEPS] - 18.5) < 0.1 &&
              fabs(bend[2][STEPS] - 21.0) < 0.1,
          "the fibres, bent by 26.0 degrees (%.2f), straighten to 18.5 (%.2f) "
          "between held ends, to 21.0 (%.2f) with one end free", bend[1][0],
          bend[1][STEPS], bend[2][STEPS]);
    claim(force[1] < 0.8 * 300.0 && force[1] > 0.75 * 300.0,
          "they pull with less than 0.8 of the force of straight ones (%g)",
          force[1]);
    claim(move[2] < -0.31 && move[2] > -2.0 * (1.0 - 0.807570777793),
          "the block contracts, but less than a straight strip (%g)", move[2]);
    return table_finish();
}
