/*
 * orders.c - does the exponent of the corner predict how fast elements of
 * degree k on a mesh that is graded with m converge?
 *
 * 2 min(k, p m) with p of material_corner(), in six cases at nu = 0.3, and for
 * quadratic triangles near 1/2, where graded ones fall short of it.  Tables:
 * the error at the vertices that all meshes have, against the limit; and the
 * prediction beside the last order.  With a larger m quadratic triangles go on
 * at nu = 0.3, at the vertices, of which nothing is proved, and in the mean of
 * u_y over the square, which has the order predicted in the end.  The limit is
 * extrapolated, since that of n = 128 alone hides up to a tenth of the smallest
 * errors.
 */
#include "hang.h"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "material/material.h"
#include "plane/quadratic.h"

#include <math.h>
#include <stdlib.h>

static const char *const word[] = HANG_WORDS;
static const struct {
    enum hang_element element;
    double m; /* 0: the least with p m >= k */
    int last; /* n */
    double nu;
} kind[] = {{HANG_LINEAR, 1.0, 128, 0.3},    {HANG_LINEAR, 1.5, 128, 0.3},
            {HANG_QUADRATIC, 1.0, 32, 0.3},  {HANG_QUADRATIC, 1.5, 32, 0.3},
            {HANG_QUADRATIC, 2.0, 32, 0.3},  {HANG_CROSSED, 1.0, 32, 0.3},
            {HANG_QUADRATIC, 1.0, 32, 0.4999},
            {HANG_QUADRATIC, 2.0, 32, 0.4999},
            {HANG_QUADRATIC, 0.0, 32, 0.4999}};
enum { KINDS = COUNT(kind), SOFT = 6 }; /* the first of nu = 0.4999 */

static double corner(double nu)
{
    const struct material material = material_make(CUBIC, 1000.0, nu);
    return material_corner(&material);
}

/* The error at the vertices, and the mean of u_y over the square. */
static double quadratic(int n, double m, const struct hang *limit, double *mean)
{
    struct mesh *mesh;
    double *u, g[6];
    const struct hang hang =
        hang_whole(HANG_QUADRATIC, n, m, 0.3, &mesh, &u);
    *mean = 0.0;
    for (int e = 0; e < 2 * n * n; e++) {
        int node[6];
        quadratic_nodes(mesh, e, node);
        const double area = mesh_gradients_of(mesh, node, g);
        for (int a = 3; a < 6; a++) /* int N_a is 0 at a corner */
            *mean += area / 3.0 * u[2 * node[a] + 1] / 4.0;
    }
    free(u);
    mesh_free(mesh);
    return hang_apart(&hang, limit);
}

/* The mean in the limit, as hang_limit() takes it. */
static double limit_of_mean(const struct hang *limit)
{
    double mean[3];
    for (int j = 0; j < 3; j++) quadratic(32 << j, 3.0, limit, &mean[j]);
    const double last = mean[2] - mean[1];
    return mean[2] + last / ((mean[1] - mean[0]) / last - 1.0);
}

/* At nu = 0.3, up to n = 64. */
static void claim_steeper(const struct hang *limit)
{
    const double truth = limit_of_mean(limit);
    for (double m = 2.0; m <= 3.0; m += 0.5) {
        const double expected = 2.0 * fmin(2.0, corner(0.3) * m);
        double error[4], mean[4], seen[4] = {NAN};
        for (int j = 0; j < 4; j++) {
            error[j] = quadratic(8 << j, m, limit, &mean[j]);
            if (j) seen[j] = study_order(error[j - 1], error[j], 2.0);
        }
        const double of_mean =
            study_order(fabs(mean[2] - truth), fabs(mean[3] - truth), 2.0);
        claim(seen[1] < seen[2] && seen[2] < seen[3] &&
                  (m > 2.0 ? seen[3] > 3.0 && seen[3] < expected - 0.2
                           : fabs(seen[3] - expected) < 0.07),
              "quadratic triangles, m = %g: the orders rise, with m = 2 nearly "
              "to the prediction (%g), above it beyond 3, but not so far (%g)",
              m, expected, seen[3]);
        claim(of_mean > seen[3] && of_mean < seen[3] + 0.15,
              "m = %g: the order of the mean has come at most 0.15 farther "
              "than that of the vertices (%g, %g)", m, of_mean, seen[3]);
    }
}

/* Near 1/2 only even quadratic triangles have the order predicted. */
static void claim_soft(const double order[], const double predicted[])
{
    claim(fabs(order[0] - predicted[0]) < 0.03,
          "nu = 0.4999: even quadratic triangles have the order of the corner, "
          "%g (%g)", predicted[0], order[0]);
    claim(fabs(predicted[1] - 2.38) < 0.005 && fabs(order[1] - 1.99) < 0.05,
          "graded with m = 2 they have 2.0, not %g (%g)", predicted[1],
          order[1]);
    claim(predicted[2] > 3.99 && fabs(order[2] - 2.40) < 0.05,
          "and with the least m that should do 2.4, not %g (%g)", predicted[2],
          order[2]);
}

int main(void)
{
    const struct hang limit = hang_limit(0.3), soft = hang_limit(0.4999);
    double order[KINDS], predicted[KINDS], m_of[KINDS];

    /* near nu = 1/2 the condition of K takes digits */
    table_begin("error", "element nu m n error order");
    for (int k = 0; k < KINDS; k++) {
        const int degree = kind[k].element == HANG_QUADRATIC ? 2 : 1;
        const double p = corner(kind[k].nu);
        double before = NAN;
        m_of[k] = kind[k].m > 0.0 ? kind[k].m : degree / p;
        predicted[k] = 2.0 * fmin(degree, p * m_of[k]);
        for (int n = 8; n <= kind[k].last; n *= 2) {
            const struct hang hang =
                hang_of(kind[k].element, n, m_of[k], kind[k].nu);
            const double error = hang_apart(&hang, k < SOFT ? &limit : &soft);
            order[k] = study_order(before, error, 2.0);
            table_row(word[kind[k].element], kind[k].nu, m_of[k], n,
                      cell_rounded(k < SOFT ? 5 : 2, error),
                      n > 8 ? cell_rounded(k < SOFT ? 4 : 3, order[k])
                            : cell_word(MISSING));
            before = error;
        }
    }
    table_end();
    table_begin("orders", "element nu m predicted observed n");
    for (int k = 0; k < KINDS; k++)
        table_row(word[kind[k].element], kind[k].nu, m_of[k], predicted[k],
                  cell_rounded(k < SOFT ? 4 : 3, order[k]), kind[k].last);
    table_end();
    claim_steeper(&limit);
    for (int k = 0; k < SOFT; k++)
        claim(fabs(order[k] - predicted[k]) < 0.15,
              "%s triangles, nu = 0.3, m = %g: the order is within 0.15 of %g "
              "(%g)", word[kind[k].element], m_of[k], predicted[k], order[k]);
    claim_soft(&order[SOFT], &predicted[SOFT]);
    return table_finish();
}
