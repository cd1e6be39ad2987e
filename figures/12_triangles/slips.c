/*
 * slips.c - how wrong are the two slips of the notes' listing of dP/dF, and
 * where would a test of symmetry see them?
 *
 * The slips [eq:dP-dF]: cof(:,j) where cof(j,:) is meant; mu added to one
 * diagonal entry of each block, (i,i), in place of both.  The last row is no
 * slip of the notes: columns for rows in both factors.  Table: error and
 * asymmetry of dP/dF as a 4x4 matrix, relative to its norm; cubic law.
 */
#include "material/material.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { NONE, COLUMN, HALF, TWICE = 4, SLIPS };
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

int main(void)
{
    const mat2 states[4] = {mat2_identity(), {{{1.0, 0.5}, {0.0, 1.0}}},
                            mat2_rotation(M_PI / 6.0),
                            {{{1.2385, 0.3714}, {-0.2385, 0.8714}}}};
    double off[SLIPS][4], odd[SLIPS][4], most_odd = 0.0, twice_odd = 0.0;

    table_begin("slips", "slip rest shear rotated general asym_rest "
                         "asym_rotated");
    for (int i = NONE; i < SLIPS; i++) {
        for (int k = 0; k < 4; k++)
            slip_error(states[k], i, &off[i][k], &odd[i][k]);
        table_row(name[i], off[i][0], off[i][1], off[i][2], off[i][3],
                  odd[i][0], odd[i][2]);
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
    return table_finish();
}
