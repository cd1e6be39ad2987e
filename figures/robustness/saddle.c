/*
 * saddle.c - is an answer of Newton's method the one that is looked for, and
 * which push leads away from one that is not?
 *
 * The ends are pushed together (compress, cubic law).  Tables: two_answers,
 * the last step that the notes' method survives with n = 8, and the same step
 * projected on demand, from the same state: Phi [eq:incremental-potential] of
 * both.  push: from this saddle and three others the same step is solved again,
 * projected on demand and with a line search, after a push of 1e-3 m of one
 * vertex, of ten in turn, or of all free vertices at random by up to 1e-2 m, 10
 * times: how many of these solves end at a minimum.
 */
#include "first_step.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <stdlib.h>
#include <string.h>

enum { SADDLES = 4, SINGLE = 10, RANDOM = 10, LAST = 22 };
static const struct {
    const char *method;
    int n, step; /* the one that ends at the saddle */
} way[SADDLES] = {{"demand+search", 4, 32}, {"notes", 8, LAST},
                  {"notes", 16, 19}, {"all", 16, 41}};

/* A step of the square, and the Phi that it has made stationary. */
struct squeezed {
    struct scene *s;
    struct step_report report;
    double *w;
    struct incremental Phi;
};

/* All steps by one method but the last. */
static struct squeezed squeeze(int n, int steps, const char *method,
                               const char *last)
{
    const struct scene_setting set = scene_notes(COMPRESS, CUBIC, n);
    struct squeezed a = {.s = scene_alloc(&set)};
    struct scene *s = a.s;
    a.w = allocate((size_t)s->n_dof, sizeof *a.w);
    body_store(s->body, PLAIN); /* as in compression.c */
    while (s->steps < steps) {
        const struct step_control control =
            step_method(s->steps == steps - 1 ? last : method);
        for (int r = 0; r < s->n_dof; r++) a.w[r] = s->u[r] + set.dt * s->v[r];
        a.report = scene_step(s, &control);
        if (a.report.status != OK) die("no step");
    }
    a.Phi = (struct incremental){set.dt, a.w, NULL};
    return a;
}

static void squeezed_free(struct squeezed a)
{
    free(a.w);
    scene_free(a.s);
}

static void print_two_answers(void)
{
    const char *const method[] = {"notes", "demand+search"};
    double phi[2], min_J[2], unused;
    int definite[2], indefinite = 0;
    table_begin_note("two_answers", "method phi",
                     "step %d from the same state; phi in units of dt^2 (J/m)",
                     LAST);
    for (int m = 0; m < 2; m++) {
        const struct squeezed a = squeeze(8, LAST, "notes", method[m]);
        struct scene *s = a.s;
        double *room = allocate(2 * (size_t)s->n_dof, sizeof *room);
        if (step_potential(s->body, a.Phi, s->u, room, &phi[m], &unused) != OK)
            die("no energy");
        definite[m] = step_certify(s->body, a.Phi, s->u) == OK;
        min_J[m] = body_min_J(s->body, s->u);
        if (m == 0) indefinite = a.report.indefinite;
        table_row(m ? "on demand, line search" : method[m],
                  phi[m] * 30.0 * 30.0);
        free(room);
        squeezed_free(a);
    }
    table_end();
    claim(!definite[0] && min_J[0] < 0.0 && indefinite > 0,
          "the notes' answer is a saddle, and its report counts indefinite "
          "systems (%d)", indefinite);
    claim(definite[1] && min_J[1] > 0.0 && phi[1] < 0.95 * phi[0],
          "the other is a minimum with a smaller Phi (by %.2g of it)",
          1.0 - phi[1] / phi[0]);
}

/* Does the step of Phi come to a minimum, from u? */
static int descends(struct body *body, struct incremental Phi, double u[])
{
    const struct step_control control = step_method("demand+search");
    return step_solve(body, &control, Phi, u).status == OK &&
           step_certify(body, Phi, u) == OK;
}

/* From a saddle: hits of pushes of one vertex, and of all. */
static void push(const struct squeezed *end, int hits[2])
{
    struct scene *s = end->s;
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
        hits[0] += descends(s->body, end->Phi, u);
    }
    for (int seed = 1; seed <= RANDOM; seed++) {
        first_scatter(s, seed, 1e-2);
        for (int r = 0; r < s->n_dof; r++) u[r] = saddle[r] + s->u[r];
        hits[1] += descends(s->body, end->Phi, u);
    }
    free(u);
    free(saddle);
}

static void print_pushes(void)
{
    int hits[SADDLES][2] = {{0}};
    table_begin_note("push", "n method tried one tried_all all",
                     "solves that end at a minimum");
    for (int k = 0; k < SADDLES; k++) {
        const struct squeezed a =
            squeeze(way[k].n, way[k].step, way[k].method, way[k].method);
        claim(step_certify(a.s->body, a.Phi, a.s->u) == SADDLE,
              "the step ends at a saddle (n = %d, %s)", way[k].n,
              way[k].method);
        push(&a, hits[k]);
        table_row(way[k].n, way[k].method, SINGLE, hits[k][0], RANDOM,
                  hits[k][1]);
        squeezed_free(a);
    }
    table_end();
    for (int k = 0; k < SADDLES - 1; k++)
        claim(hits[k][0] == SINGLE && hits[k][1] == RANDOM,
              "each push leaves it (n = %d, %s)", way[k].n, way[k].method);
    claim(hits[SADDLES - 1][0] == 0 && hits[SADDLES - 1][1] >= RANDOM * 3 / 4,
          "one vertex never leaves the saddle of \"all\", n = 16, while all at "
          "random mostly do (%d of %d)", hits[SADDLES - 1][1], RANDOM);
}

int main(void)
{
    print_two_answers();
    print_pushes();
    return table_finish();
}
