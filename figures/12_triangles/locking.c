/*
 * locking.c - what do linear triangles do to a material that hardly changes its
 * volume?
 *
 * Linear elasticity, which is Newton's first increment from rest: the square is
 * held on its left side and hangs under a force of 1 N per area.  Table: the
 * displacement of the vertex (1, 0) and how much of it is missing, against n,
 * for three of Poisson's ratios.
 */
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { RATIOS = 3 };
static const double nu[RATIOS] = {0.3, 0.49, 0.4999};

/* Source: an independent computation with quadratic triangles on 80 x 80
 * squares, graded towards the corners with m = 3.  Lesson 25's study of the sag
 * has the same, but for the last digit. */
static const double reference[RATIOS] = {-0.0111804, -0.010584, -0.010523};

/* Vertical displacement of the vertex (1, 0): K at rest, one linear system. */
static double droop(int n, double ratio)
{
    struct scene_setting set = scene_notes(GRAVITY, CUBIC, n);
    set.nu = ratio;
    set.force = 1.0;
    struct scene *s = scene_alloc(&set);
    struct matrix *K = body_matrix(s->body);
    for (int r = 0; r < s->n_dof; r++) s->g[r] = -s->f[r]; /* q at rest */
    if (body_stiffness(s->body, s->u, EXACT, K) != OK ||
        body_increment(s->body, K, s->g, s->u) != OK)
        die("no increment, n = %d, nu = %g", n, ratio);
    const int row = n / 2, vertex = row * (n + 1) + n; /* at (1, 0) */
    const double down = s->u[2 * vertex + 1];
    matrix_free(K);
    scene_free(s);
    return down;
}

int main(void)
{
    double u[RATIOS], order[RATIOS], missing[RATIOS];
    double change[RATIOS] = {0.0}, before[RATIOS] = {0.0};

    table_begin_note("locking",
                     "n u_0.3 u_0.49 u_0.4999 error_0.3 error_0.49 "
                     "error_0.4999",
                     "u of the vertex (1,0) downwards (m); error: 1 - u / "
                     "reference");
    for (int n = 4; n <= 64; n *= 2) {
        for (int k = 0; k < RATIOS; k++) {
            u[k] = droop(n, nu[k]);
            order[k] =
                study_order(fabs(change[k]), fabs(u[k] - before[k]), 2.0);
            change[k] = n > 4 ? u[k] - before[k] : 0.0;
            before[k] = u[k];
            missing[k] = 1.0 - u[k] / reference[k];
        }
        table_row(n, u[0], u[1], cell_rounded(6, u[2]), missing[0], missing[1],
                  cell_rounded(6, missing[2]));
    }
    table_end();
    claim(fabs(missing[0]) < 0.005 && missing[2] > 0.2,
          "with n = 64 less than 0.5 %% is missing at nu = 0.3 (%g), and more "
          "than a fifth at 0.4999 (%g)", missing[0], missing[2]);
    claim(fabs(order[0] - 1.5) < 0.2, "the displacements at nu = 0.3 converge "
          "among themselves with an order near 1.5 (%g)", order[0]);
    return table_finish();
}
