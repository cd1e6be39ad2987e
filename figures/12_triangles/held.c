/*
 * held.c - does K at rest tell that mu is missing on half of the diagonal?
 *
 * "Half of mu" is the second slip of slips.c: mu on one diagonal entry of each
 * block of dP/dF, (i, i), in place of both [eq:dP-dF].  Table: the least
 * eigenvalue of K over mu, right and with the slip, n = 4, cubic law, by what
 * is held.  Expected: at rest dP/dF with the slip has the eigenvalue -mu, and
 * it is a matter of the boundary whether K has a negative one, too.
 */
#include "linear/dense.h"
#include "plane/mesh.h"
#include "material/material.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum { N = 4, VERTICES = (N + 1) * (N + 1), MOST = 2 * VERTICES, HOLDS = 3 };
static const char *const name[HOLDS] = {"left side", "left and right side",
                                        "whole boundary"};

static int is_held(const double X[2], int hold)
{
    if (hold == 0) return X[0] < -0.99;
    return fabs(X[0]) > 0.99 || (hold == 2 && fabs(X[1]) > 0.99);
}

/* The least eigenvalue over mu of K at rest, at the vertices that are free. */
static double least(const struct mesh *mesh, const struct material *law,
                    int hold, int slip)
{
    double K[MOST][MOST], free_K[MOST * MOST], value[MOST];
    int row[MOST], n = 0;
    for (int r = 0; r < MOST; r++)
        for (int c = 0; c < MOST; c++) K[r][c] = 0.0;
    for (int e = 0; e < mesh->n_triangle; e++) {
        const int *t = &mesh->triangle[3 * e];
        double g[6];
        const double area = mesh_gradients(mesh, e, g);
        for (int b = 0; b < 3; b++)
            for (int j = 0; j < 2; j++) {
                /* vertex b moves by 1 along j: dF = e_j (x) grad N_b */
                mat2 dF = {{{0.0, 0.0}, {0.0, 0.0}}};
                dF.m[j][0] = g[2 * b];
                dF.m[j][1] = g[2 * b + 1];
                mat2 dP = material2_dpk1(law, mat2_identity(), dF);
                if (slip) dP.m[j][1 - j] -= law->mu * dF.m[j][1 - j];
                for (int a = 0; a < 3; a++)
                    for (int i = 0; i < 2; i++)
                        K[2 * t[a] + i][2 * t[b] + j] +=
                            area * (dP.m[i][0] * g[2 * a] +
                                    dP.m[i][1] * g[2 * a + 1]);
            }
    }
    for (int r = 0; r < MOST; r++)
        if (!is_held(&mesh->X[2 * (r / 2)], hold)) row[n++] = r;
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++) free_K[r * n + c] = K[row[r]][row[c]];
    if (dense_eigenvalues(n, free_K, value) != OK) die("no eigenvalues");
    return value[0] / law->mu;
}

int main(void)
{
    const struct material law = material_notes(CUBIC);
    struct mesh *mesh = mesh_square(N);
    double right[HOLDS], slipped[HOLDS];

    table_begin("held", "held right half_of_mu");
    for (int hold = 0; hold < HOLDS; hold++) {
        right[hold] = least(mesh, &law, hold, 0);
        slipped[hold] = least(mesh, &law, hold, 1);
        table_row(name[hold], right[hold], slipped[hold]);
    }
    table_end();
    mesh_free(mesh);

    claim(right[0] > 0.0 && right[1] > 0.0 && right[2] > 0.0,
          "the right K is positive definite whatever is held (least over mu: "
          "%g, %g, %g)", right[0], right[1], right[2]);
    claim(slipped[0] < -0.1 && slipped[1] < -0.1,
          "with the slip it is not where a side is free (%g, %g)", slipped[0],
          slipped[1]);
    claim(slipped[2] > 1.0, "but it is where the whole boundary is held (%g)",
          slipped[2]);
    return table_finish();
}
