/*
 * chart.c - speed against accuracy: what does an error of the bar cost?
 *
 * The hanging bar, cubic law, c = 500: relative error of u(1) against the
 * seconds of the whole solve; the same with five steps on a million elements,
 * and how far the first increment is from that of the sweep from both ends.
 * Four programs: bar_newton(); bar_gsl.h; the sweeps of bar_fast.h, from the
 * left and from both ends [alg:fused-sweep].  Free memory stays with the
 * process, so that none of them waits for the system's pages in each call.
 */
#include "bar_fast.h"
#include "bar_gsl.h"
#include "bar/bar_scene.h"
#include "base/clock.h"
#include "../study/study.h"
#include "base/table.h"

#include <limits.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <math.h>
#include <stdio.h>
#include <string.h>

enum solver { READABLE, GSL, FUSED, FUSED_BOTH, SOLVERS };
static const char *const name[] = {"readable", "gsl", "fused", "both"};

/* At most `steps` steps from the state. */
static struct newton_report run(struct bar_state *s, enum solver solver,
                                const struct newton_control *control)
{
    switch (solver) {
    case READABLE: return bar_newton(&s->bar, control, s->u, NULL);
    case GSL: return bar_gsl_newton(&s->bar, control, s->u);
    case FUSED: return bar_fast_newton(&s->bar, control, FROM_LEFT, s->u);
    default: return bar_fast_newton(&s->bar, control, FROM_BOTH_ENDS, s->u);
    }
}

/* At most `steps` steps from rest; the seconds of the best of the repeats. */
static double timed(struct bar_state *s, enum solver solver, int steps,
                    double tolerance, int repeats)
{
    const struct newton_control control = {tolerance, steps, 0, 0};
    struct times t = {.runs = 0};
    for (int k = 0; k < repeats; k++) {
        memset(s->u, 0, ((size_t)s->bar.n + 1) * sizeof *s->u);
        const double start = clock_seconds();
        s->report = run(s, solver, &control);
        times_record(&t, clock_seconds() - start, 1);
    }
    return times_best(&t);
}

static struct bar_state *hanging(int n, double *tolerance)
{
    struct bar_scene scene = bar_scene_notes(CUBIC, n);
    scene.c = 500.0;
    *tolerance = bar_scene_control(&scene).tolerance;
    return bar_state_alloc(&scene);
}

/* As in print_chart() the seconds of a step are those of a whole solve of five
 * steps, over five. */
static void print_large(int n)
{
    double tolerance, difference[SOLVERS];
    struct bar_state *s = hanging(n, &tolerance);
    struct bar_state *first = hanging(n, &tolerance);

    timed(first, FUSED_BOTH, 1, 0.0, 1);
    table_begin("large", "solver n ns_per_unknown difference");
    for (int k = 0; k < SOLVERS; k++) {
        timed(s, (enum solver)k, 1, 0.0, 1);
        difference[k] = 0.0;
        for (int i = 0; i <= n; i++)
            difference[k] = fmax(difference[k], fabs(s->u[i] - first->u[i]));
        difference[k] /= bar_max_free(&first->bar, first->u);
        const double step = timed(s, (enum solver)k, 5, 0.0, 3) / 5;
        table_row(name[k], n, 1e9 * step / n, difference[k]);
    }
    table_end();
    bar_state_free(s);
    bar_state_free(first);
    claim(fmin(difference[READABLE], difference[GSL]) > 100 * difference[FUSED],
          "textbook pivots lose two digits more than sums of compliances");
}

static double excess(double F, void *material)
{
    return material1_pk1(material, F) - 500.0;
}

/* n = 16, 64, ... to 4^8, or with a sweep to 4^9. */
static void print_chart(enum solver solver)
{
    struct material m = material_notes(CUBIC);
    const double F = study_root(excess, &m, 0.0, 6.0); /* [eq:bar-weight] */
    const double exact = F - material1_psi(&m, F) / 500.0 - 1.0;
    const int largest = solver < FUSED ? 1 << 16 : 1 << 18;
    double before = 0.0, tolerance;
    char title[20];

    snprintf(title, sizeof title, "chart_%s", name[solver]);
    table_begin(title, "n iterations error seconds ns_per_unknown");
    for (int n = 16; n <= largest; n *= 4) {
        struct bar_state *s = hanging(n, &tolerance);
        const double seconds = timed(s, solver, 100, tolerance, 3);
        const double error = fabs(s->u[n] - exact) / exact;
        table_row(n, s->report.iterations, error, seconds,
                  1e9 * seconds / n / s->report.iterations);
        const double order = study_order(before, error, 4.0);
        claim(n == 16 || n > 4096 || fabs(order - 2.0) < 0.01,
              "%s: the error falls with n^-2 (order %g at n = %d)", title,
              order, n);
        before = error;
        bar_state_free(s);
    }
    table_end();
}

int main(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
    study_machine();
    print_large(1000000);
    for (int k = 0; k < SOLVERS; k++) print_chart((enum solver)k);
    return table_finish();
}
