/*
 * precision.c - how many digits must a factor have?
 *
 * K of system.h and its right-hand side, by fronts, with factors in double and
 * in single precision: digits of the residual after one solve (12: or more), of
 * max K_ii max|x| + max|b|, and how many solves refining needs to 1e-12 of that
 * [eq:refine].  The first steps of the stretch, with factors kept within a step
 * [alg:chord]: how many systems, rounded and by the band, which is not, and how
 * far apart they end.  Megabytes: entries of K and L.
 */
#include "linear/refine.h"
#include "linear/residual.h"
#include "linear/sparse.h"
#include "base/study.h"
#include "plane/system.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 6 };

struct found {
    double residual, megabytes;
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
    found.megabytes = 1e-6 * (8.0 * (double)K->size +
                              (single ? 4.0 : 8.0) * K->pattern->numbers);
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

int main(void)
{
    table_begin("precision", "factors n digits solves systems apart "
                "megabytes");
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
            table_row(k ? "single" : "double", n,
                      fmin(12.0, floor(-log10(f[k].residual))), f[k].solves,
                      systems[k], cell_if(k, apart), f[k].megabytes);
        claim(f[0].solves == 1 && f[0].residual <= 1e-12, "double: no need");
        claim(f[1].residual < 1e-6 && f[1].residual > 1e-9 && f[1].solves == 2,
              "single: some seven digits, and twelve after a solve more");
        claim(systems[0] == systems[1] && apart < 1e-13,
              "the steps are the same");
        for (int k = 0; k < 2; k++) scene_free(s[k]);
        system_free(system);
    }
    table_end();
    return table_finish();
}
