/*
 * scattered.c - which method brings the body back from random places?
 *
 * The free vertices of n = 4 are thrown to random places, each component within
 * an amplitude (in h) of its own, and equilibrium without load is asked for.
 * Tables: where the runs of each method end, with standard errors, how many of
 * the other minima have a knot, and systems solved by those that find an
 * equilibrium; one that is not at rest, and its knots.
 */
#include "first_step.h"
#include "motion/live.h"
#include "plane/scene.h"
#include "../13_backward_euler_2d/corners.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_cblas.h>
#include <stdlib.h>
#include <string.h>

/* Both ends are held in the first starts, then the left one. */
enum { SEEDS = 250, BOTH_ENDS = 3, STARTS = 5, METHODS = 5 };
static const char *const method[METHODS] = {
    "notes", "search", "demand", "demand+search", "always+search"};
static const double amplitude[STARTS] = {0.5, 1.0, 4.0, 1.0, 4.0};

static struct scene *unloaded(int start)
{
    struct scene_setting set = scene_notes(start < BOTH_ENDS ? RIGID : GRAVITY,
                                           CUBIC, 4);
    set.rho = 0.0;
    set.force = 0.0;
    return scene_alloc(&set);
}

enum end { REST, MINIMUM, NO_MINIMUM, STOPPED /* as not SPD */, FAILS, ENDS };
static enum end settle(struct scene *s, int start, int seed, const char *name,
                       struct times *systems)
{
    const struct step_control control = step_method(name);
    first_scatter(s, seed, amplitude[start] * 2.0 / s->set.n);
    memcpy(s->v, s->u, (size_t)s->n_dof * sizeof *s->u); /* is kept */
    const struct step_report to =
        step_solve(s->body, &control, at_rest(NULL), s->u);
    if (to.status == NOT_SPD && control.line_search) return STOPPED;
    if (to.status != OK) return FAILS;
    times_record(systems, to.iterations, 1);
    if (fabs(s->u[cblas_idamax(s->n_dof, s->u, 1)]) < 1e-6) return REST;
    body_assemble(s->body, at_rest(NULL), s->u, EXACT, s->g);
    return matrix_factor(s->body->K) == OK ? MINIMUM : NO_MINIMUM;
}

struct census {
    int end[ENDS];
    int knotted;              /* minima with a knot [eq:winding] */
    struct times systems;     /* of runs to an equilibrium, no seconds */
    double inverted, least_J; /* mean part of the starts; of the equilibria */
};

static struct census take_census(int start, const char *name)
{
    struct scene *s = unloaded(start), from = *s;
    struct census c = {.least_J = 1.0};
    double x[6];
    from.u = s->v;

    for (int seed = 1; seed <= SEEDS; seed++) {
        const enum end end = settle(s, start, seed, name, &c.systems);
        for (int e = 0; e < s->mesh->n_triangle; e++)
            c.inverted += !(corners_of(&from, e, x) > 0.0) /
                          (SEEDS * (double)s->mesh->n_triangle);
        c.end[end]++;
        c.knotted += end == MINIMUM && live_knots(s->mesh, s->u, NULL) > 0;
        if (end < STOPPED)
            c.least_J = fmin(c.least_J, body_min_J(s->body, s->u));
    }
    scene_free(s);
    return c;
}

static void print_knots(const struct mesh *mesh, const double u[])
{
    int *knot = allocate((size_t)mesh->n_vertex, sizeof *knot);
    live_knots(mesh, u, knot);
    table_begin("knots", "x y");
    for (int a = 0; a < mesh->n_vertex; a++)
        if (knot[a])
            table_row(mesh->X[2 * a] + u[2 * a],
                      mesh->X[2 * a + 1] + u[2 * a + 1]);
    table_end();
    free(knot);
}

static void print_tangled(void)
{
    struct scene *s = unloaded(4), from = *s;
    struct times systems = {0};
    int seed = 1;

    from.u = s->v;
    while (settle(s, 4, seed, method[3], &systems) != MINIMUM) {
        if (seed == SEEDS) die("no run ends at another minimum");
        seed++;
    }
    table_begin("tangled", "X0 Y0 X1 Y1 X2 Y2 J_start x0 y0 x1 y1 x2 y2 J");
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        double row[14];
        row[6] = corners_of(&from, e, row);
        row[13] = corners_of(s, e, row + 7);
        table_row_of(14, row);
    }
    table_end();
    print_knots(s->mesh, s->u);
    scene_free(s);
}

int main(void)
{
    static struct census c[STARTS][METHODS];

    table_begin("scattered", "held amplitude method seeds inverted rest stable "
                "saddle not_spd fails knotted median p90 least_J rest_part "
                "rest_error stable_part");
    for (int k = 0; k < STARTS; k++)
        for (int m = 0; m < METHODS; m++) {
            c[k][m] = take_census(k, method[m]);
            const int *end = c[k][m].end;
            const int some = c[k][m].systems.runs > 0;
            table_row(k < BOTH_ENDS ? "both" : "left", amplitude[k], method[m],
                      SEEDS, c[k][m].inverted, end[REST], end[MINIMUM],
                      end[NO_MINIMUM], end[STOPPED], end[FAILS],
                      c[k][m].knotted,
                      cell_if(some, times_median(&c[k][m].systems)),
                      cell_if(some, times_quantile(&c[k][m].systems, 0.9)),
                      cell_if(some, c[k][m].least_J), 1.0 * end[REST] / SEEDS,
                      rate_error(end[REST], SEEDS), 1.0 * end[MINIMUM] / SEEDS);
        }
    table_end();
    print_tangled();

    for (int k = 0; k < BOTH_ENDS; k++)
        claim(c[k][3].end[REST] == SEEDS, "demand+search brings all back");
    claim(c[2][1].end[STOPPED] == SEEDS && c[2][2].end[FAILS] > 0.9 * SEEDS,
          "from 4 h neither search nor projection alone does");
    claim(rate_apart(c[0][0].end[REST], SEEDS, c[0][1].end[REST], SEEDS) >
              RATE_SURE, "from h / 2 a line search alone makes it worse");
    const struct census *left = &c[4][3];
    claim(left->end[REST] + left->end[MINIMUM] == SEEDS && left->least_J > 0 &&
          left->end[MINIMUM] > 0.3 * SEEDS, "there are other stable answers");
    for (int m = 3; m < METHODS; m++)
        claim(c[4][m].knotted == c[4][m].end[MINIMUM], "%s: each of the %d has "
              "a knot (%d)", method[m], c[4][m].end[MINIMUM], c[4][m].knotted);
    return table_finish();
}
