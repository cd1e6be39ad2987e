/*
 * printed_tangent.c - what do the two slips of the notes' listing do to dP/dF,
 * and to Newton's method?
 *
 * The slips: cof(:,j) where cof(j,:) is meant; mu added to one entry of the
 * diagonal of a block, (i,i), in place of both [eq:dP-dF].  Tables: the error of
 * dP/dF in four states; Newton's history for a free square that was pulled to
 * 1.2385 times its length, upright or turned by 30 degrees, and is let go: one
 * step of backward Euler of 1/30 s from v = (0.2, 0.1), by LU.
 */
#include "scene.h"
#include "study.h"
#include "table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>
#include <math.h>

enum { NONE, COLUMN, HALF, SLIPS = 4, CAP = 40, DRAWN = 15, SIZE = 50 };
static const char *const name[] = {"none", "column for row", "half of mu",
                                   "both"};

/* dP_ik/dF_jm with slips, r = 8 i + 4 j + 2 k + m. */
static double slope(const struct material *material, mat2 F, int slip, int r)
{
    const int i = r / 8, j = r / 4 % 2, k = r / 2 % 2, m = r % 2;
    const double mu = material->mu, lambda = material->lambda;
    const struct volumetric v = material_r(material, mat2_det(F));
    const mat2 cof = mat2_cofactor(F);
    const double c1 = lambda * v.dr * v.dr + (lambda * v.r - mu) * v.ddr;
    const double c2 = (lambda * v.r - mu) * v.dr;
    double D = c1 * cof.m[i][k] * (slip & COLUMN ? cof.m[m][j] : cof.m[j][m]);
    if (i == j && k == m && (k == i || !(slip & HALF))) D += mu;
    if (i != j && k != m) D += k == i ? c2 : -c2;
    return D;
}

/* Error and asymmetry of dP/dF as a 4x4 matrix, relative to its norm. */
static void slip_error(mat2 F, int slip, double *error, double *asymmetry)
{
    const struct material material = material_notes(CUBIC);
    double norm = 0.0, off = 0.0, odd = 0.0;
    for (int r = 0; r < 16; r++) {
        const int other = r / 8 * 4 + r / 4 % 2 * 8 + r / 2 % 2 + r % 2 * 2;
        const double right = slope(&material, F, NONE, r);
        const double printed = slope(&material, F, slip, r);
        norm += right * right;
        off += gsl_pow_2(printed - right);
        odd += gsl_pow_2(printed - slope(&material, F, slip, other));
    }
    *error = sqrt(off / norm);
    *asymmetry = sqrt(odd / norm);
}

/* The full K with slips; it need not be symmetric. */
static void printed_tangent(const struct scene *s, int slip, gsl_matrix *K)
{
    const double dt = s->set.dt;
    double g[6];
    gsl_matrix_set_zero(K);
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const int *t = &s->mesh->triangle[3 * e];
        const double area = mesh_gradients(s->mesh, e, g);
        mat2 F = mat2_identity();
        for (int r = 0; r < 12; r++) /* vertex r / 4, entry r / 2 % 2, r % 2 */
            F.m[r / 2 % 2][r % 2] +=
                s->u[2 * t[r / 4] + r / 2 % 2] * g[r / 4 * 2 + r % 2];
        for (int ab = 0; ab < 9; ab++)
            for (int r = 0; r < 16; r++) { /* i j k m, as in slope() */
                const int a = ab / 3, b = ab % 3, i = r / 8, j = r / 4 % 2;
                double *at = gsl_matrix_ptr(K, (size_t)(2 * t[a] + i),
                                            (size_t)(2 * t[b] + j));
                *at += dt * dt * area * g[2 * a + r / 2 % 2] *
                       slope(&s->body->material, F, slip, r) * g[2 * b + r % 2];
                if (i == j && r % 4 == 0) *at += area / (a == b ? 6.0 : 12.0);
            }
    }
}

/* Newton's method with the printed tangent; residual[k] is max|q| before
 * iteration k, 0 where it is not below 1e12.  -1: none of CAP was the last. */
static int let_go(double angle, int slip, double residual[])
{
    struct scene_setting set = scene_notes(SPIN, CUBIC, 4);
    set.spin = 0.0;
    struct scene *s = scene_alloc(&set);
    const mat2 F = mat2_multiply(mat2_rotation(angle),
                                 (mat2){{{1.2385, 0.0}, {0.0, 1.0}}});
    double w[SIZE], q[SIZE], entries[SIZE * SIZE], move = INFINITY;
    gsl_matrix_view K = gsl_matrix_view_array(entries, SIZE, SIZE);
    gsl_vector_view du = gsl_vector_view_array(q, SIZE);
    gsl_permutation *order = gsl_permutation_alloc(SIZE);
    int last = -1, sign;
    for (int r = 0; r < SIZE; r++) {
        const double *X = &s->mesh->X[r / 2 * 2];
        s->u[r] = F.m[r % 2][0] * X[0] + F.m[r % 2][1] * X[1] - X[r % 2];
        w[r] = s->u[r] + set.dt * s->v[r];
    }
    for (int k = 0; k <= CAP && last < 0; k++) {
        double size = 0.0;
        if (body_assemble(s->body, set.dt, w, NULL, s->u, NO_TANGENT, q)) break;
        for (int r = 0; r < SIZE; r++) size = fmax(size, fabs(q[r]));
        if (!(size < 1e12)) break;
        residual[k] = size;
        if (move <= 1e-10) last = k;
        printed_tangent(s, slip, &K.matrix);
        if (gsl_linalg_LU_decomp(&K.matrix, order, &sign) ||
            gsl_linalg_LU_svx(&K.matrix, order, &du.vector))
            break;
        move = fmax(gsl_vector_max(&du.vector), -gsl_vector_min(&du.vector));
        for (int r = 0; r < SIZE; r++) s->u[r] -= q[r];
    }
    gsl_permutation_free(order);
    scene_free(s);
    return last;
}

int main(void)
{
    const mat2 states[4] = {mat2_identity(), {{{1.0, 0.5}, {0.0, 1.0}}},
                            mat2_rotation(M_PI / 6.0),
                            {{{1.2385, 0.3714}, {-0.2385, 0.8714}}}};
    double residual[2][SLIPS][CAP + 1] = {{{0.0}}}, off[SLIPS][4], odd[SLIPS][4];
    int last[2][SLIPS];

    gsl_set_error_handler_off();
    table_begin("slips", "slip rest shear rotated general asym_rest "
                         "asym_rotated iterations iterations_turned");
    for (int i = NONE; i < SLIPS; i++) {
        for (int k = 0; k < 4; k++)
            slip_error(states[k], i, &off[i][k], &odd[i][k]);
        for (int c = 0; c < 2; c++)
            last[c][i] = let_go(c * M_PI / 6.0, i, residual[c][i]);
        table_row(name[i], off[i][0], off[i][1], off[i][2], off[i][3],
                  odd[i][0], odd[i][2], cell_if(last[0][i] >= 0, last[0][i]),
                  cell_if(last[1][i] >= 0, last[1][i]));
    }
    table_end();
    table_begin_note("slip_history", "body slip k residual",
                     "before iteration k <= %d; later ones are round-off",
                     DRAWN);
    for (int r = 0; r < 2 * SLIPS * (DRAWN + 1); r++) {
        const int c = r / (DRAWN + 1) / SLIPS, i = r / (DRAWN + 1) % SLIPS;
        const int k = r % (DRAWN + 1);
        if (residual[c][i][k] > 0.0)
            table_row(c ? "turned" : "upright", name[i], k, residual[c][i][k]);
    }
    table_end();
    claim(off[COLUMN][0] < 1e-14 && off[COLUMN][2] > 0.8 && odd[COLUMN][2] > 1,
          "a column for a row is right at rest, wrong by %g turned", off[COLUMN][2]);
    claim(odd[HALF][0] + odd[HALF][2] < 1e-14 && off[HALF][0] > 0.2,
          "half of mu is symmetric, and wrong by %g at rest", off[HALF][0]);
    claim(last[0][NONE] == 5 && last[1][NONE] == 5 && last[0][COLUMN] == 6 &&
              last[1][COLUMN] + last[0][HALF] + last[1][HALF] == -3,
          "the right tangent takes 5 iterations; a column for a row 6, and no "
          "end when turned; half of mu has no end");
    return table_finish();
}
