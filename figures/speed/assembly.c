/*
 * assembly.c - what do the residual and the tangent of one element cost?
 *
 * The square with both ends held, consistent mass, cubic law.  readable: a loop
 * that asks for dP/dF in six directions (readable.h); both: the closed form of
 * body.h, residual and tangent of many at once (lanes.h); residual: without
 * the tangent; projected: with the negative eigenvalues of dP/dF clamped, which
 * about half of the elements have; clear: zeros into the band, which are part
 * of the others.
 *
 * They take turns; medians, in ns per element.  An answer that is not that of
 * the others has none.
 */
#include "base/clock.h"
#include "readable.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum assembly {
    READABLE, RESIDUAL, CLOSED, CLAMPED, CLEAR, ASSEMBLIES
};

static double seconds_of(int kind, const struct scene *s, struct readable *r,
                         double q[])
{
    const double start = clock_seconds();
    const struct incremental Phi = {s->set.dt, s->v, NULL};
    const enum tangent tangent[] = {[RESIDUAL] = NO_TANGENT, [CLOSED] = EXACT,
                                    [CLAMPED] = PROJECTED};
    if (kind == READABLE)
        readable_assemble(r, s->v, s->u);
    else if (kind == CLEAR)
        matrix_zero(s->body->K);
    else
        body_assemble(s->body, Phi, s->u, tangent[kind], q);
    return clock_seconds() - start;
}

/* Of q and K by the two programs, where nothing is held; relative. */
static double difference(const struct scene *s, struct readable *r, double q[])
{
    const int *equation = s->body->equation;
    double K = 0.0, K_apart = 0.0, force = 0.0, force_apart = 0.0;
    seconds_of(CLOSED, s, r, q);
    seconds_of(READABLE, s, r, q);
    for (int j = 0; j < s->n_dof; j++) {
        if (equation[j] < 0) continue;
        force = fmax(force, fabs(q[j]));
        force_apart = fmax(force_apart, fabs(q[j] - r->q[j]));
        for (int d = 0; d < r->width && j + d < s->n_dof; d++) {
            if (equation[j + d] < 0) continue;
            const double k = r->K[(size_t)j * (size_t)r->width + (size_t)d];
            K = fmax(K, fabs(k));
            K_apart = fmax(K_apart,
                           fabs(k - matrix_get(s->body->K, equation[j + d],
                                               equation[j])));
        }
    }
    return fmax(K_apart / K, force_apart / force);
}

int main(void)
{
    double worst = 0.0;
    study_machine();
    table_begin_note("assembly",
                     "n readable_over_both readable residual both projected "
                     "clear",
                     "ns per element");
    for (int n = 16; n <= 64; n *= 2) {
        const struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
        struct scene *s = scene_alloc(&set);
        struct readable *r = readable_alloc(s->body, set.dt);
        body_store(s->body, BANDED);
        double *q = allocate((size_t)s->n_dof, sizeof *q), ns[ASSEMBLIES];
        static struct times t[ASSEMBLIES];
        for (int i = 0; i < s->n_dof; i++)
            s->u[i] = 0.238 / n * sin(2.385 * i);
        const double apart = difference(s, r, q);
        for (int kind = 0; kind < ASSEMBLIES; kind++) t[kind].runs = 0;
        for (int i = 0; i < 4096 / n / n * 30 + 30; i++)
            for (int kind = 0; kind < ASSEMBLIES; kind++) {
                double seconds = 0.0;
                for (int warm = 0; warm < 2; warm++) /* the second counts */
                    seconds = seconds_of(kind, s, r, q);
                times_record(&t[kind], 1e9 * seconds / s->mesh->n_triangle, 1);
            }
        for (int kind = 0; kind < ASSEMBLIES; kind++)
            ns[kind] = times_median(&t[kind]);
        const int valid = apart < 1e-12;
        table_row(n, cell_if(valid, ns[READABLE] / ns[CLOSED]),
                  cell_if(valid, ns[READABLE]),
                  cell_if(valid, ns[RESIDUAL]), cell_if(valid, ns[CLOSED]),
                  cell_if(valid, ns[CLAMPED]), cell_if(valid, ns[CLEAR]));
        worst = fmax(worst, apart);
        free(q);
        readable_free(r);
        scene_free(s);
    }
    table_end();
    claim(worst < 1e-12, "both programs assemble the same system (to %g)",
          worst);
    return table_finish();
}
