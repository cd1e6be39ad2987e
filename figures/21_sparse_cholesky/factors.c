/*
 * factors.c - what does a second right-hand side cost, and how many digits must
 * a factor have?
 *
 * Tables: second, K of the stretch, both ends held, in a band of half bandwidth
 * 2 n - 1 and by nested dissection with the fronts of sparse.h: flops of a
 * factorisation over those of a solve, and megabytes of the band and of K with
 * L, counted.  precision, K of system.h and its right-hand side by fronts, with
 * factors in double and in single precision: how many solves refining needs to
 * 1e-12 of max K_ii max|x| + max|b| [eq:refine]; and how many systems the first
 * steps of the stretch take with factors kept within a step [alg:chord],
 * rounded, and by the band, which is not.
 */
#include "dissected.h"
#include "refine.h"
#include "linear/residual.h"
#include "plane/system.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 256, STEPS = 6 };

static void print_second(void)
{
    double most = 0.0; /* megabytes with the room to work */
    table_begin_note("second", "n band dissection band_megabytes megabytes",
                     "flops of a factorisation over those of a solve");
    for (int n = 32; n <= LARGEST; n *= 2) {
        const struct matrix_cost band =
            matrix_cost(BANDED, 2 * (n - 1) * (n + 1), 2 * n - 1);
        struct sparse *s = dissected(n);
        const double entries = 4.0 * s->start[s->n_vertex]; /* of K */
        table_row(n, band.flops / band.solve, s->flops / s->solve,
                  8e-6 * band.numbers, 8e-6 * (entries + s->numbers));
        most = 8e-6 * (entries + (double)sparse_size(s, 0));
        sparse_free(s);
    }
    table_end();
    claim(most < 220.0, "n = %d in 220 megabytes (%g)", LARGEST, most);
}

struct found {
    double residual;
    int solves;
};

static struct found solve(struct system *system, int single)
{
    struct matrix *K = system->scene->body->K;
    const size_t bytes = (size_t)K->n * sizeof(double);
    double *b = allocate((size_t)K->n, sizeof *b);
    double *x = allocate((size_t)K->n, sizeof *x);
    double size = 0.0, most = 0.0;
    struct found found;
    body_gather(system->scene->body, system->b, b);
    for (int i = 0; i < K->n; i++) size = fmax(size, fabs(b[i]));
    matrix_keep_single(K, single);
    claim(matrix_factor(K) == OK, "K is positive definite");
    memcpy(x, b, bytes);
    matrix_solve(K, x);
    for (int i = 0; i < K->n; i++) most = fmax(most, fabs(x[i]));
    found.residual = matrix_residual(K, x, b) /
                     (matrix_max_diagonal(K) * most + size);
    memcpy(x, b, bytes);
    claim(refine_solve(K, 1e-12, x, &found.solves) == OK, "refined");
    free(b);
    free(x);
    return found;
}

/* Systems of some steps from rest; a band is not rounded. */
static int walk(struct scene *s, int single)
{
    struct step_control control = step_method("lift");
    int systems = 0;
    control.chord = 1;
    body_store(s->body, single ? SPARSE : BANDED);
    for (int k = 0; k < STEPS; k++) {
        s->body->kept.usable = 0; /* nor kept across steps */
        const struct step_report report = scene_step(s, &control);
        claim(report.status == OK, "step %d", k);
        systems += report.iterations;
    }
    return systems;
}

static void print_precision(void)
{
    table_begin("precision", "factors n solves systems");
    for (int n = 16; n <= 128; n *= 2) {
        struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
        struct system *system = system_alloc(n);
        set.reach = 0.5;
        struct scene *s[2] = {scene_alloc(&set), scene_alloc(&set)};
        system_store(system, SPARSE);
        int systems[2];
        double apart = 0.0;
        struct found f[2];
        for (int single = 0; single < 2; single++) {
            f[single] = solve(system, single);
            systems[single] = walk(s[single], single);
        }
        for (int r = 0; r < s[0]->n_dof; r++)
            apart = fmax(apart, fabs(s[0]->u[r] - s[1]->u[r]));
        for (int k = 0; k < 2; k++)
            table_row(k ? "single" : "double", n, f[k].solves, systems[k]);
        claim(f[0].solves == 1 && f[0].residual <= 1e-12, "double: no need");
        claim(f[1].residual < 1e-6 && f[1].residual > 1e-9 && f[1].solves == 2,
              "single: some seven digits, and twelve after a solve more");
        claim(systems[0] == systems[1] && apart < 1e-13,
              "the steps are the same");
        for (int k = 0; k < 2; k++) scene_free(s[k]);
        system_free(system);
    }
    table_end();
}

int main(void)
{
    print_second();
    print_precision();
    return table_finish();
}
