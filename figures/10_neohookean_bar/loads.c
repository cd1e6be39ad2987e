/*
 * loads.c - the same program under other loads.
 *
 * A cosine for a body force; both ends held under a uniform one; and an end
 * force without a body force, where every element has the same F and the log
 * law is inverted by the first step from rest when p <= -(2 mu + lambda).
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

static struct bar_state *solved(const struct bar_scene *scene)
{
    struct bar_state *s = bar_scene_solve(scene, NULL);
    if (s->report.status != OK)
        die("%s law, c = %g, n = %d: %s", material_law(scene->material.law),
            scene->c, scene->n, status_name(s->report.status));
    return s;
}

static void print_cosine(void)
{
    double u1[3][2][2]; /* [n][pushed or pulled][law] */
    const enum law law[] = {CUBIC, LOG};
    const double c[] = {1e3, -1e3};

    table_begin("cosine", "n cubic_u1 log_u1 cubic_u1_neg log_u1_neg");
    for (int j = 0; j < 3; j++) {
        const int n = 16 << j;
        for (int i = 0; i < 2; i++)
            for (int l = 0; l < 2; l++) {
                struct bar_scene scene = bar_scene_notes(law[l], n);
                scene.shape = COSINE;
                scene.c = c[i];
                struct bar_state *s = solved(&scene);
                u1[j][i][l] = s->u[n];
                bar_state_free(s);
            }
        table_row(n, u1[j][0][0], u1[j][0][1], u1[j][1][0], u1[j][1][1]);
    }
    table_end();
    for (int i = 0; i < 2; i++)
        for (int l = 0; l < 2; l++) {
            const double order = study_order(fabs(u1[1][i][l] - u1[0][i][l]),
                                          fabs(u1[2][i][l] - u1[1][i][l]), 2.0);
            claim(fabs(order - 2.0) < 0.05, "u(1) under the cosine load "
                  "converges with order 2 (%g)", order);
        }
}

static void print_both_held(void)
{
    table_begin("both_held", "c n reaction u_half F_first F_last iterations");
    for (double c = 1e3; c <= 4e3; c *= 4.0)
        for (int n = 16; n <= 64; n *= 2) {
            struct bar_scene scene = bar_scene_notes(CUBIC, n);
            scene.c = c;
            scene.held[1] = 1;
            struct bar_state *s = solved(&scene);
            const double left = bar_state_reaction(s);
            const double F = bar_stretch(&s->bar, s->u, n);
            const double right = material1_pk1(&scene.material, F) - s->b[n];
            table_row(c, n, -left, s->u[n / 2], bar_stretch(&s->bar, s->u, 1),
                      F, s->report.iterations);
            claim(fabs(left + right + c) < 1e-10 * c,
                  "the two ends carry the load c = %g (they carry %g)", c,
                  -left - right);
            bar_state_free(s);
        }
    table_end();
}

int main(void)
{
    static const double pull[] = {1000.0,  100.0,   -100.0,
                                  -1346.0, -4000.0, -1e5};
    print_cosine();
    print_both_held();
    table_begin("end_load", "p cubic_iterations cubic_F log_status "
                            "log_iterations log_F");
    for (int k = 0; k < COUNT(pull); k++) {
        struct bar_scene a = bar_scene_notes(CUBIC, 16);
        a.pull[1] = pull[k];
        struct bar_scene b = a;
        b.material.law = LOG;
        struct bar_state *s = solved(&a), *t = bar_scene_solve(&b, NULL);
        const enum status status = t->report.status;
        table_row(pull[k], s->report.iterations, 1.0 + s->u[16],
                  status_name(status),
                  cell_if(status == OK, t->report.iterations),
                  cell_if(status == OK, 1.0 + t->u[16]));
        claim(status == (pull[k] > -material_modulus(&b.material) ? OK
                                                                 : INVERTED),
              "the log law is inverted from rest beyond 2 mu + lambda (p = %g: "
              "%s)", pull[k], status_name(status));
        bar_state_free(s);
        bar_state_free(t);
    }
    table_end();
    return table_finish();
}
