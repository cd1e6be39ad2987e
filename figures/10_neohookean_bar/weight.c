/*
 * weight.c - bars under their own weight: how well do linear elements do?
 *
 * Held at 0, free at 1, body force c: hanging (c > 0) or standing (c < 0).  The
 * continuum has P(F(X)) = c (1 - X), so F_c at the held end is a root and u(1)
 * an integral in closed form; linear elements with midpoint load have an error
 * h^2 C with a C known beforehand [eq:bar-weight].
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

struct target {
    const struct material *material;
    double P;
};
static double stress_excess(double F, void *target)
{
    const struct target *t = target;
    return material1_pk1(t->material, F) - t->P;
}

/* [eq:bar-weight]; P' > 0 from F = -3 (LOG: 0) to 6. */
struct exact {
    double u1, F_c, C;
};
static struct exact weight_exact(const struct bar_scene *scene)
{
    const struct material *m = &scene->material;
    const double c = scene->c;
    struct target target = {m, c};
    const double F = study_root(stress_excess, &target,
                             m->law == LOG ? 0.02 : -3.0, 6.0);
    const double C = c / 24.0 * (1.0 / material1_dpk1(m, 1.0) -
                                 1.0 / material1_dpk1(m, F));
    return (struct exact){
        F - (material1_psi(m, F) - material1_psi(m, 1.0)) / c - 1.0, F, C};
}

static struct bar_scene weighing(enum law law, int n, double c)
{
    struct bar_scene scene = bar_scene_notes(law, n);
    scene.c = c;
    return scene;
}

/* Sixteen elements; LOG from rest cannot carry every load. */
static void print_weight(void)
{
    static const double load[] = {10.0,   500.0,   2000.0, -10.0,
                                  -500.0, -1300.0, -4000.0};
    table_begin("weight", "c linear cubic_u1 cubic_exact cubic_F_base "
                          "cubic_iterations log_status log_u1 log_exact "
                          "log_F_base log_iterations");
    for (int k = 0; k < COUNT(load); k++) {
        const double c = load[k];
        const struct bar_scene a = weighing(CUBIC, 16, c);
        const struct bar_scene b = weighing(LOG, 16, c);
        struct bar_state *s = bar_scene_solve(&a, NULL);
        struct bar_state *t = bar_scene_solve(&b, NULL);
        const struct exact x = weight_exact(&a), y = weight_exact(&b);
        const int ok = t->report.status == OK;
        if (s->report.status != OK) die("cubic law, c = %g", c);
        table_row(c, 0.5 * c / material_modulus(&a.material), s->u[16], x.u1,
                  x.F_c, s->report.iterations, status_name(t->report.status),
                  cell_if(ok, t->u[16]), y.u1, y.F_c,
                  cell_if(ok, t->report.iterations));
        claim(ok == (c > -4000.0), "the log law is inverted at c = -4000 only "
              "(c = %g: %s)", c, status_name(t->report.status));
        bar_state_free(s);
        bar_state_free(t);
    }
    table_end();
}

/* Closed forms. */
static void print_curve(void)
{
    table_begin("weight_curve", "c linear cubic log");
    for (int k = -16; k <= 8; k++) {
        const double c = k == 0 ? 1e-3 : 250.0 * k; /* 0/0 at 0 */
        const struct bar_scene a = weighing(CUBIC, 1, c);
        const struct bar_scene b = weighing(LOG, 1, c);
        table_row(c, 0.5 * c / material_modulus(&a.material),
                  weight_exact(&a).u1, weight_exact(&b).u1);
    }
    table_end();
}

/* Under refinement: error = u_h(1) - u(1); constant = error / h^2. */
static void print_order(enum law law, double c)
{
    double before = 0.0;
    for (int n = 4; n <= 256; n *= 2) {
        const struct bar_scene scene = weighing(law, n, c);
        const struct exact exact = weight_exact(&scene);
        struct bar_state *s = bar_scene_solve(&scene, NULL);
        const double error = s->u[n] - exact.u1;
        const double order = study_order(fabs(before), fabs(error), 2.0);
        const double constant = error * n * n;
        table_row(c, material_law(law), n, 1.0 / n, error,
                  cell_if(n > 4, order), constant, exact.C);
        before = error;
        bar_state_free(s);
        claim(n < 32 || (fabs(order - 2.0) < 2e-3 &&
                         fabs(constant / exact.C - 1.0) < 2e-3),
              "c = %g, %s law, n = %d: error h^2 C to 0.2 %% (order %g, "
              "constant %g, predicted %g)", c, material_law(law), n, order,
              constant, exact.C);
    }
}

int main(void)
{
    print_weight();
    print_curve();
    table_begin("order", "c law n h error order constant predicted");
    print_order(LOG, 500.0);
    print_order(CUBIC, 500.0);
    print_order(LOG, -500.0);
    print_order(CUBIC, -500.0);
    table_end();
    return table_finish();
}
