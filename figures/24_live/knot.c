/*
 * knot.c - what is not undone by letting go.
 *
 * A corner of the square, n = 8, is grabbed and dragged about at random for two
 * seconds, then let go; eight seconds later, or when it has been still for one,
 * the body is looked at.  40 times, the same for both laws.  Tables: after (how
 * many are at rest, knotted, or neither; knotted in per cent with the standard
 * error), kept (of all bodies with so many knots the range of their energy, J,
 * and of their least J), body (the triangles of the first body that is knotted,
 * with J, and its knots, with J = 0).
 */
#include "motion/live.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>

enum { TIMES = 40, HELD = 60, FRAMES = 300, MOST_KNOTS = 8 };

struct remains {
    int bodies;
    double low[2], high[2]; /* of energy (J), of least J */
};

/* The body after it was let go. */
static struct live *drag(enum law law, unsigned long seed)
{
    const struct live_setting set = {8, law, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* what is dragged about is chaotic */
    struct pointer pointer = {1.0, 1.0, 1, '.'};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    double to[2] = {1.0, 1.0}, fastest;
    gsl_rng_set(random, seed);
    int still = 0; /* frames in which nothing moves */
    for (int k = 0; k < FRAMES && still < 30; k++) {
        if (k % 10 == 1)
            for (int i = 0; i < 2; i++)
                to[i] = 4.0 * gsl_rng_uniform(random) - 2.0;
        if (k >= 1) {
            pointer.x = to[0];
            pointer.y = to[1];
        }
        pointer.down = k < HELD;
        double hand[2];
        live_input(live, &pointer);
        live_hand(live->hand, &pointer, hand);
        live_carry(live, hand);
        live_frame(live, hand);
        fastest = 0.0;
        for (int r = 0; r < live->n_dof; r++)
            fastest = fmax(fastest, fabs(live->now.v[r]));
        still = fastest > 1e-6 || k < HELD ? 0 : still + 1;
    }
    gsl_rng_free(random);
    return live;
}

static void print_body(const struct live *live)
{
    const struct mesh *mesh = live->mesh;
    const double *u = live->now.u;
    int *knot = allocate((size_t)mesh->n_vertex, sizeof *knot);
    live_knots(mesh, u, knot);
    table_begin("body", "kind J x0 y0 x1 y1 x2 y2");
    for (int e = 0; e < mesh->n_triangle; e++) {
        double x[6];
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++) {
                const int r = 2 * mesh->triangle[3 * e + a] + i;
                x[2 * a + i] = mesh->X[r] + u[r];
            }
        table_row("triangle", mat2_det(body_deformation(live->body, u, e)),
                  x[0], x[1], x[2], x[3], x[4], x[5]);
    }
    for (int a = 0; a < mesh->n_vertex; a++)
        if (knot[a])
            table_row("knot", 0.0, mesh->X[2 * a] + u[2 * a],
                      mesh->X[2 * a + 1] + u[2 * a + 1], MISSING, MISSING,
                      MISSING, MISSING);
    table_end();
    free(knot);
}

static void keep(struct remains *kept, const struct live *live)
{
    const double value[2] = {live_energy(live),
                             body_min_J(live->body, live->now.u)};
    for (int i = 0; i < 2; i++) {
        kept->low[i] = kept->bodies ? fmin(kept->low[i], value[i]) : value[i];
        kept->high[i] = fmax(kept->high[i], value[i]);
    }
    kept->bodies++;
}

static void print_kept(const struct remains kept[MOST_KNOTS + 1])
{
    table_begin("kept", "knots bodies least_energy most_energy least_J most_J");
    for (int knots = 1; knots <= MOST_KNOTS; knots++)
        if (kept[knots].bodies > 0)
            table_row(knots, kept[knots].bodies,
                      kept[knots].low[0], kept[knots].high[0],
                      kept[knots].low[1], kept[knots].high[1]);
    table_end();
}

int main(void)
{
    struct remains kept[MOST_KNOTS + 1] = {{0}};
    int rest[2] = {0}, knotted[2] = {0}, neither[2] = {0}, inverted[2] = {0};
    struct live *shown = NULL;
    gsl_set_error_handler_off();
    table_begin("after", "law times at_rest knotted neither inverted rate "
                         "standard_error");
    for (int l = 0; l < 2; l++) {
        for (unsigned long seed = 1; seed <= TIMES; seed++) {
            struct live *live = drag(l ? CUBIC : LOG, seed);
            double far = 0.0;
            for (int r = 0; r < live->n_dof; r++)
                far = fmax(far, fabs(live->now.u[r]));
            const int knots = live_knots(live->mesh, live->now.u, NULL);
            rest[l] += far < 1e-3;
            knotted[l] += knots > 0;
            neither[l] += far >= 1e-3 && knots == 0;
            inverted[l] += body_min_J(live->body, live->now.u) <= 0.0;
            if (knots > 0 && knots <= MOST_KNOTS) keep(&kept[knots], live);
            if (knots > 0 && !shown)
                shown = live;
            else
                live_free(live);
        }
        table_row(material_law(l ? CUBIC : LOG), (int)TIMES, rest[l],
                  knotted[l], neither[l], inverted[l],
                  100.0 * knotted[l] / TIMES,
                  100.0 * rate_error(knotted[l], TIMES));
    }
    table_end();
    print_kept(kept);
    if (shown) print_body(shown);
    live_free(shown);

    claim(rest[0] == TIMES, "under LOG the body is at rest every time (%d)",
          rest[0]);
    claim(neither[1] == 0 &&
              rate_apart(knotted[1], TIMES, knotted[0], TIMES) > RATE_SURE,
          "under the cubic law it is at rest or knotted (%d), never neither "
          "(%d)", knotted[1], neither[1]);
    const double *low = kept[1].low, *high = kept[1].high;
    claim(low[0] > 80 && high[0] < 150 && low[1] > 0.25 && high[1] < 0.55 &&
              kept[2].low[0] > high[0],
          "one knot keeps 90 to 140 J (%g to %g), two more, and a least J of "
          "0.3 to 0.5 (%g to %g)", low[0], high[0], low[1], high[1]);
    claim(inverted[1] == 0, "no body has an inverted triangle, knotted or not "
          "(%d)", inverted[1]);
    return table_finish();
}
