/*
 * slips.c - how wrong are the two slips of the notes' listing of dP/dF, and
 * where would a test of symmetry, or K at rest, reveal them?
 *
 * The slips [eq:dP-dF]: cof(:,j) where cof(j,:) is meant; mu added to one
 * diagonal entry of each block, (i,i), in place of both.  The last row is no
 * slip of the notes: columns for rows in both factors.  Tables, cubic law:
 * slips, error and asymmetry of dP/dF as a 4x4 matrix, relative to its norm;
 * held, the least eigenvalue of K over mu, right and with half of mu, n = 4, by
 * what is held.  At rest dP/dF with this slip has the eigenvalue -mu, and it is
 * a matter of the boundary whether K has a negative one, too.
 */
#include "linear/dense.h"
#include "plane/mesh.h"
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { NONE, COLUMN, HALF, TWICE = 4, SLIPS };
enum { N = 4, VERTICES = (N + 1) * (N + 1), MOST = 2 * VERTICES, HOLDS = 3 };
static const char *const name[] = {"none", "column for row", "half of mu",
                                   "both", "column for row, twice"};

/* D[2i + k][2j + m] = dP_ik/dF_jm, with slips. */
static void slopes(mat2 F, int slip, double D[4][4])
{
    const struct material law = material_notes(CUBIC);
    const struct volumetric v = material_r(&law, mat2_det(F));
    const double stress = law.lambda * v.r - law.mu, c2 = stress * v.dr;
    const double c1 = law.lambda * v.dr * v.dr + stress * v.ddr;
    const mat2 cof = mat2_cofactor(F);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            for (int j = 0; j < 2; j++)
                for (int m = 0; m < 2; m++)
                    D[2 * i + k][2 * j + m] =
                        c1 * (slip & TWICE ? cof.m[k][i] : cof.m[i][k]) *
                        (slip & (COLUMN | TWICE) ? cof.m[m][j] : cof.m[j][m]);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            double *row = D[2 * i + k];
            if (k == i || !(slip & HALF)) row[2 * i + k] += law.mu;
            row[2 * (1 - i) + 1 - k] += k == i ? c2 : -c2;
        }
}

/* Error and asymmetry of dP/dF, relative to its norm. */
static void slip_error(mat2 F, int slip, double *error, double *asymmetry)
{
    double D[4][4], right[4][4], norm = 0.0, off = 0.0, odd = 0.0;
    slopes(F, NONE, right);
    slopes(F, slip, D);
    for (int r = 0; r < 4; r++)
        for (int c = 0; c < 4; c++) {
            norm += gsl_pow_2(right[r][c]);
            off += gsl_pow_2(D[r][c] - right[r][c]);
            odd += gsl_pow_2(D[r][c] - D[c][r]);
        }
    *error = sqrt(off / norm);
    *asymmetry = sqrt(odd / norm);
}

static void print_slips(void)
{
    const mat2 states[4] = {mat2_identity(), {{{1.0, 0.5}, {0.0, 1.0}}},
                            mat2_rotation(M_PI / 6.0),
                            {{{1.2385, 0.3714}, {-0.2385, 0.8714}}}};
    double off[SLIPS][4], odd[SLIPS][4], most_odd = 0.0, twice_odd = 0.0;

    table_begin("slips", "slip rest shear rotated general asym_rotated");
    for (int i = NONE; i < SLIPS; i++) {
        for (int k = 0; k < 4; k++)
            slip_error(states[k], i, &off[i][k], &odd[i][k]);
        table_row(name[i], off[i][0], off[i][1], off[i][2], off[i][3],
                  odd[i][2]);
    }
    table_end();
    for (int k = 0; k < 4; k++) {
        most_odd = fmax(most_odd, odd[HALF][k]);
        twice_odd = fmax(twice_odd, odd[TWICE][k]);
    }
    claim(off[COLUMN][0] < 1e-15 && odd[COLUMN][0] < 1e-15,
          "a column for a row is right at rest (wrong by %g)", off[COLUMN][0]);
    claim(off[COLUMN][2] > 0.8 && odd[COLUMN][2] > 1.0,
          "turned by 30 degrees it is wrong by more than 0.8 (%g), and not "
          "symmetric (%g)", off[COLUMN][2], odd[COLUMN][2]);
    claim(most_odd < 1e-15 && off[HALF][0] > 0.2,
          "half of mu is symmetric in every state (%g) and wrong by more than "
          "0.2 at rest (%g)", most_odd, off[HALF][0]);
    claim(twice_odd < 1e-15 && off[TWICE][0] < 1e-15 && off[TWICE][2] > 1.0,
          "columns for rows in both factors are symmetric in every state (%g), "
          "right at rest (wrong by %g), and wrong by more than 1 when turned "
          "(%g)", twice_odd, off[TWICE][0], off[TWICE][2]);
}

/* ---- K ------------------------------------------------------------------- */

static int is_held(const double X[2], int hold)
{
    if (hold == 0) return X[0] < -0.99;
    return fabs(X[0]) > 0.99 || (hold == 2 && fabs(X[1]) > 0.99);
}

/* The least eigenvalue over mu of K at rest, at the vertices that are free. */
static double least(const struct mesh *mesh, int hold, int slip)
{
    double D[4][4], K[MOST][MOST] = {{0.0}}, free_K[MOST * MOST], value[MOST];
    int row[MOST], n = 0;
    slopes(mat2_identity(), slip, D);
    for (int e = 0; e < mesh->n_triangle; e++) {
        const int *t = &mesh->triangle[3 * e];
        double g[6];
        const double area = mesh_gradients(mesh, e, g);
        for (int b = 0; b < 3; b++)
            for (int j = 0; j < 2; j++) {
                /* vertex b moves by 1 along j: dF = e_j (x) grad N_b */
                double dP[4];
                for (int r = 0; r < 4; r++)
                    dP[r] = D[r][2 * j] * g[2 * b] +
                            D[r][2 * j + 1] * g[2 * b + 1];
                for (int a = 0; a < 3; a++)
                    for (int i = 0; i < 2; i++)
                        K[2 * t[a] + i][2 * t[b] + j] +=
                            area * (dP[2 * i] * g[2 * a] +
                                    dP[2 * i + 1] * g[2 * a + 1]);
            }
    }
    for (int r = 0; r < MOST; r++)
        if (!is_held(&mesh->X[2 * (r / 2)], hold)) row[n++] = r;
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++) free_K[r * n + c] = K[row[r]][row[c]];
    if (dense_eigenvalues(n, free_K, value) != OK) die("no eigenvalues");
    return value[0] / material_notes(CUBIC).mu;
}

static void print_held(void)
{
    static const char *const word[HOLDS] = {"left side", "left and right side",
                                            "whole boundary"};
    struct mesh *mesh = mesh_square(N);
    double right[HOLDS], slipped[HOLDS];

    table_begin("held", "held right half_of_mu");
    for (int hold = 0; hold < HOLDS; hold++) {
        right[hold] = least(mesh, hold, NONE);
        slipped[hold] = least(mesh, hold, HALF);
        table_row(word[hold], right[hold], slipped[hold]);
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
}

int main(void)
{
    print_slips();
    print_held();
    return table_finish();
}
