/*
 * push.c - which push leaves a saddle?
 *
 * The squeezed square (compress, cubic law) is stepped to a saddle by the
 * method that ends there.  From it the same step is solved again, projected on
 * demand and with a line search, after a push of 1e-3 m of one vertex, of ten
 * in turn, or of all free vertices at random by up to 1e-2 m, 10 times.  Table:
 * how many of these solves end at a minimum.
 */
#include "first_step.h"
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <stdlib.h>
#include <string.h>

enum { SADDLES = 4, SINGLE = 10, RANDOM = 10 };
static const struct {
    const char *method;
    int n, step; /* the one that ends at the saddle */
} way[SADDLES] = {{"demand+search", 4, 32}, {"notes", 8, 22},
                  {"notes", 16, 19}, {"all", 16, 41}};

/* Does the step of Phi come to a minimum, from u? */
static int descends(struct body *body, struct incremental Phi, double u[])
{
    const struct step_control control = step_method("demand+search");
    return step_solve(body, &control, Phi, u).status == OK &&
           step_certify(body, Phi, u) == OK;
}

/* From the saddle in s: hits of pushes of one vertex, and of all. */
static void push(struct scene *s, struct incremental Phi, int hits[2])
{
    const int n = s->set.n;
    const size_t size = (size_t)s->n_dof * sizeof(double);
    double *u = allocate((size_t)s->n_dof, sizeof *u);
    double *saddle = allocate((size_t)s->n_dof, sizeof *saddle);
    memcpy(saddle, s->u, size);
    for (int k = 0; k < SINGLE; k++) {
        /* inner columns and all rows, spread over the body */
        const int column = 1 + k % (n - 1), row = k * n / (SINGLE - 1);
        const int a = row * (n + 1) + column;
        if (s->held[a]) die("vertex %d is held", a);
        memcpy(u, saddle, size);
        u[2 * a] += 1e-3;
        hits[0] += descends(s->body, Phi, u);
    }
    for (int seed = 1; seed <= RANDOM; seed++) {
        first_scatter(s, seed, 1e-2);
        for (int r = 0; r < s->n_dof; r++) u[r] = saddle[r] + s->u[r];
        hits[1] += descends(s->body, Phi, u);
    }
    free(u);
    free(saddle);
}

int main(void)
{
    int hits[SADDLES][2] = {{0}};

    table_begin_note("push", "n method step tried one tried_all all",
                     "solves that end at a minimum");
    for (int k = 0; k < SADDLES; k++) {
        const struct scene_setting set =
            scene_notes(COMPRESS, CUBIC, way[k].n);
        const struct step_control control = step_method(way[k].method);
        struct scene *s = scene_alloc(&set);
        double *w = allocate((size_t)s->n_dof, sizeof *w);
        body_store(s->body, PLAIN); /* as in compression.c */
        while (s->steps < way[k].step) {
            for (int r = 0; r < s->n_dof; r++)
                w[r] = s->u[r] + set.dt * s->v[r];
            if (scene_step(s, &control).status != OK) die("no step");
        }
        const struct incremental Phi = {set.dt, w, NULL};
        claim(step_certify(s->body, Phi, s->u) == SADDLE,
              "the step ends at a saddle (n = %d, %s)", set.n, way[k].method);
        push(s, Phi, hits[k]);
        table_row(set.n, way[k].method, way[k].step, SINGLE, hits[k][0],
                  RANDOM, hits[k][1]);
        free(w);
        scene_free(s);
    }
    table_end();

    for (int k = 0; k < SADDLES - 1; k++)
        claim(hits[k][0] == SINGLE && hits[k][1] == RANDOM,
              "each push leaves it (n = %d, %s)", way[k].n, way[k].method);
    claim(hits[SADDLES - 1][0] == 0 && hits[SADDLES - 1][1] >= RANDOM * 3 / 4,
          "one vertex never leaves the saddle of \"all\", n = 16, while all at "
          "random mostly do (%d of %d)", hits[SADDLES - 1][1], RANDOM);
    return table_finish();
}
