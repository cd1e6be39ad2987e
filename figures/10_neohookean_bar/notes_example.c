/*
 * notes_example.c - the notes' example, u(0, t) = sin t with a free right end.
 *
 * The bar moves as a whole, u = sin t.  Each step in time starts at the last u,
 * with the whole jump of the left end in the first element: the cubic law takes
 * any, the log law is inverted at once where the jump is longer than the
 * element.  Times are 0, dt, 2 dt, ... until 6.3.
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

struct follow {
    enum status status;  /* of the first time that failed, or OK */
    int most_iterations; /* at one time */
    double worst;        /* max over t and X of |u - sin t| */
    double longest;      /* largest jump of the end over h */
};

static struct follow follow_example(enum law law, int n, double dt, int print)
{
    struct bar_scene scene = bar_scene_notes(law, n);
    struct bar_state *s = bar_state_alloc(&scene);
    const struct newton_control control = bar_scene_control(&scene);
    struct follow follow = {OK, 0, 0.0, 0.0};

    for (int m = 0; m * dt <= 6.3 + 0.5 * dt; m++) {
        const double goal = sin(m * dt);
        double error = 0.0;
        follow.longest = fmax(follow.longest, fabs(goal - s->u[0]) * n);
        s->u[0] = goal;
        s->report = bar_newton(&s->bar, &control, s->u, NULL);
        follow.status = s->report.status;
        if (follow.status != OK) break;
        for (int i = 0; i <= n; i++) error = fmax(error, fabs(s->u[i] - goal));
        if (print)
            table_row(m * dt, s->u[0], s->u[n], error, s->report.iterations);
        follow.worst = fmax(follow.worst, error);
        if (s->report.iterations > follow.most_iterations)
            follow.most_iterations = s->report.iterations;
    }
    bar_state_free(s);
    return follow;
}

int main(void)
{
    static const double steps[] = {0.01, 0.1, 0.5};

    table_begin("example", "t u_left u_right error iterations");
    follow_example(CUBIC, 10, 0.1, 1);
    table_end();

    table_begin_note("example_steps",
                     "n dt cubic_status cubic_iterations cubic_error "
                     "log_status log_iterations log_error",
                     "the most iterations and the largest error of all times");
    for (int n = 10; n <= 100; n *= 10)
        for (int k = 0; k < COUNT(steps); k++) {
            const struct follow a = follow_example(CUBIC, n, steps[k], 0);
            const struct follow b = follow_example(LOG, n, steps[k], 0);
            const int ok = b.status == OK;
            table_row(n, steps[k], status_name(a.status), a.most_iterations,
                      a.worst, status_name(b.status),
                      cell_if(ok, b.most_iterations), cell_if(ok, b.worst));
            claim(a.status == OK && a.worst <= 1e-12,
                  "n = %d, dt = %g, cubic law: u = sin t to 1e-12 (%s, %g)", n,
                  steps[k], status_name(a.status), a.worst);
            claim(b.status == (b.longest < 1.0 ? OK : INVERTED) &&
                      (!ok || b.worst <= 1e-12),
                  "n = %d, dt = %g, log law: u = sin t to 1e-12, or INVERTED "
                  "where the jump is longer than the element (%s, %g, jump %g)",
                  n, steps[k], status_name(b.status), b.worst, b.longest);
        }
    table_end();
    return table_finish();
}
