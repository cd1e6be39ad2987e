/*
 * tissue.c - a strip of soft tissue with a cut, in the hand; on a page only.
 *
 * 10 cm by 3 cm, held by bone below, as soft as brain and as heavy as water.
 * The notes' material has the density 1 instead of 1000 kg/m^3, so the strip is
 * drawn SCALE times as large: then sound takes as long from end to end, and the
 * motion is the same in the same time.  The loop is that of lesson 24.
 */
#include "base/clock.h"
#include "base/table.h"
#include "motion/window.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* In cells: the cut is the column CUT above row DEEP. */
enum { WIDE = 51, HIGH = 15, CUT = 25, DEEP = 8 };
static const double SCALE = 31.6227766016838, RADIUS = 0.15;

static struct mesh *strip(void)
{
    struct mesh *mesh = mesh_rectangle(WIDE, HIGH, 0.05 * SCALE, 0.015 * SCALE);
    int left = 0;
    for (int j = 0; j < HIGH; j++)
        for (int i = 0; i < WIDE; i++) {
            const int *cell = &mesh->triangle[6 * (j * WIDE + i)];
            if (i == CUT && j >= DEEP) continue;
            memmove(&mesh->triangle[6 * left++], cell, 6 * sizeof *cell);
        }
    mesh->n_triangle = 2 * left;
    return mesh;
}

/* The vertex that is nearest to the hand; live->grip is set. */
static int nearest(const struct live *live)
{
    int best = 0;
    for (int a = 1; a < live->mesh->n_vertex; a++)
        if (hypot(live->grip[2 * a], live->grip[2 * a + 1]) <
            hypot(live->grip[2 * best], live->grip[2 * best + 1]))
            best = a;
    return best;
}

/* Make a new body: bone holds the lowest row and the hand, if it is down, the
 * vertices near it, beside the cut those of one lip alone.  Return whether it
 * holds any. */
static int hold(struct live *live, int down)
{
    const struct mesh *mesh = live->mesh;
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held), taken = 0;
    for (int r = 0; r < live->n_dof; r++)
        live->grip[r] = mesh->X[r] + live->now.u[r] - live->hand[r % 2];
    const int first = nearest(live), beside = first > DEEP * (WIDE + 1);
    for (int a = 0; a < mesh->n_vertex; a++) {
        const int near = down && a > WIDE &&
                         hypot(live->grip[2 * a], live->grip[2 * a + 1]) <=
                             RADIUS &&
                         !(beside && mesh->X[2 * a] * mesh->X[2 * first] < 0);
        held[a] = a <= WIDE || near;
        taken += near;
    }
    body_free(live->body);
    live->body = body_alloc(mesh, material_notes(live->set.law), 1.0,
                            CONSISTENT, held);
    free(held);
    return taken > 0;
}

static struct live *begin(void)
{
    struct live *live = allocate(1, sizeof *live);
    live->set = (struct live_setting){WIDE, LOG, BACKWARD_EULER, PATCH, ELASTIC,
                                      1, LINEAR_TRIANGLE};
    live->dt = 1.0 / 30.0;
    live->mesh = strip();
    live->n_dof = 2 * live->mesh->n_vertex;
    live->now = state_make(live->n_dof);
    live->grip = allocate((size_t)live->n_dof, sizeof *live->grip);
    live->g = allocate((size_t)live->n_dof, sizeof *live->g);
    hold(live, 0);
    return live;
}

/* What live_input() and live_carry() do for the square. */
static void input(struct live *live, const struct pointer *pointer)
{
    if (pointer->key == 'r') {
        memset(live->now.u, 0, (size_t)live->n_dof * sizeof *live->now.u);
        memset(live->now.v, 0, (size_t)live->n_dof * sizeof *live->now.v);
        live->trouble = 0;
    }
    if (pointer->down == live->holding && pointer->key != 'r') return;
    live->hand[0] = fmax(-LIVE_FAR, fmin(LIVE_FAR, pointer->x));
    live->hand[1] = fmax(-LIVE_FAR, fmin(LIVE_FAR, pointer->y));
    live->holding = hold(live, pointer->down);
}

static void carry(struct live *live, const double to[2])
{
    for (int r = 0; r < live->n_dof; r++)
        live->g[r] = live->body->equation[r] >= 0 || r < 2 * (WIDE + 1)
                         ? 0.0
                         : live->grip[r] + to[r % 2] - live->mesh->X[r];
}

int main(int argc, char *argv[])
{
    (void)argc;
    (void)argv; /* a page says nothing */
    struct window *window = window_open();
    struct pointers all = {0, NULL};
    if (!window) die("tissue: there is no page");
    gsl_set_error_handler_off();
    struct live *live = begin();
    table_begin("frames", "k rung status systems part min_J");
    for (int k = 0; window_next(window, &all, k, 1); k++) {
        double to[2];
        const double start = clock_seconds();
        input(live, &all.frame[k]);
        live_hand(live->hand, &all.frame[k], to);
        carry(live, to);
        const struct live_report report = live_frame(live, to);
        window_draw(window, live, &report, clock_seconds() - start, NULL);
        table_row(k + 1, report.rung, status_name(report.status),
                  report.systems, report.part,
                  body_min_J(live->body, live->now.u));
    }
    table_end();
    window_close(window);
    pointers_free(&all);
    live_free(live);
    return table_finish();
}
