/*
 * printed_tangent.c - what do the two slips of the notes' listing of dP/dF do
 * to Newton's method?
 *
 * The slips: see slips.c.  A free square, pulled to 1.2385 times its length,
 * upright or turned by 30 degrees, moves at (0.2, 0.1) m/s and is let go: one
 * step of backward Euler of 1/30 s, by a solver that needs no symmetry.
 * Tables: iterations, and residuals.
 */
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>

enum { NONE, COLUMN, HALF, SLIPS = 4, CAP = 40, DRAWN = 12, SIZE = 50 };
static const char *const name[] = {"none", "column for row", "half of mu",
                                   "both"};

/* The change of P with F by e_j (x) g: the right one, and what slips add. */
static mat2 change(const struct material *law, mat2 F, int slip, int j,
                   const double g[2])
{
    const mat2 cof = mat2_cofactor(F);
    const struct volumetric v = material_r(law, mat2_det(F));
    const double stress = law->lambda * v.r - law->mu;
    const double c1 = law->lambda * v.dr * v.dr + stress * v.ddr;
    const double skew = c1 * g[1 - j] * (cof.m[1 - j][j] - cof.m[j][1 - j]);
    mat2 dF = {{{0.0, 0.0}, {0.0, 0.0}}};
    for (int m = 0; m < 2; m++) dF.m[j][m] = g[m];
    mat2 dP = material2_dpk1(law, F, dF);
    if (slip & COLUMN) dP = mat2_add(dP, mat2_scale(skew, cof));
    if (slip & HALF) dP.m[j][1 - j] -= law->mu * g[1 - j];
    return dP;
}

/* Column (b, j) of what triangle e adds to K: dP is the change of P with
 * component j of its vertex b; rho = 1. */
static void add_column(const struct scene *s, int e, int b, int j, mat2 dP,
                       gsl_matrix *K)
{
    const int *t = &s->body->vertex[3 * e];
    const double *g = &s->body->gradient[6 * e], area = s->body->area[e];
    const double dt = s->set.dt;

    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++) {
            double *at = gsl_matrix_ptr(K, (size_t)(2 * t[a] + i),
                                        (size_t)(2 * t[b] + j));
            *at += dt * dt * area * (dP.m[i][0] * g[2 * a] +
                                     dP.m[i][1] * g[2 * a + 1]);
            if (i == j) *at += area / (a == b ? 6.0 : 12.0);
        }
}

/* The full K with slips. */
static void printed_tangent(const struct scene *s, int slip, gsl_matrix *K)
{
    gsl_matrix_set_zero(K);
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, s->u, e);
        for (int b = 0; b < 3; b++)
            for (int j = 0; j < 2; j++) {
                const double *g = &s->body->gradient[6 * e + 2 * b];
                add_column(s, e, b, j,
                           change(&s->body->material, F, slip, j, g), K);
            }
    }
}

/* residual[k]: max|q| before iteration k, while it is below 1e12.  How many
 * iterations; -1 when CAP are not enough. */
static int let_go(double angle, int slip, double residual[])
{
    const struct scene_setting set = scene_notes(SPIN, CUBIC, 4);
    const mat2 R = mat2_rotation(angle);
    const double velocity[2] = {0.2, 0.1};
    struct scene *s = scene_alloc(&set);
    double w[SIZE], q[SIZE], entries[SIZE * SIZE], move = INFINITY;
    gsl_matrix_view K = gsl_matrix_view_array(entries, SIZE, SIZE);
    gsl_vector_view du = gsl_vector_view_array(q, SIZE);
    int iterations = -1;

    for (int a = 0; a < s->mesh->n_vertex; a++)
        for (int i = 0; i < 2; i++) {
            const double *X = &s->mesh->X[2 * a], *row = R.m[i];
            const int r = 2 * a + i;
            s->u[r] = 1.2385 * row[0] * X[0] + row[1] * X[1] - X[i];
            w[r] = s->u[r] + set.dt * velocity[i];
        }
    const struct incremental Phi = {set.dt, w, NULL};
    for (int k = 0; k <= CAP && iterations < 0; k++) {
        body_assemble(s->body, Phi, s->u, NO_TANGENT, q);
        const double size = body_max_free(s->body, q);
        if (!(size < 1e12)) break;
        residual[k] = size;
        if (move <= 1e-10) iterations = k;
        printed_tangent(s, slip, &K.matrix);
        gsl_linalg_HH_svx(&K.matrix, &du.vector); /* q := K^-1 q */
        move = body_max_free(s->body, q);
        for (int r = 0; r < SIZE; r++) s->u[r] -= q[r];
    }
    scene_free(s);
    return iterations;
}

int main(void)
{
    double residual[2][SLIPS][CAP + 1] = {{{0.0}}};
    int n[2][SLIPS];

    table_begin("slip_iterations", "slip iterations iterations_turned");
    for (int i = NONE; i < SLIPS; i++) {
        for (int c = 0; c < 2; c++)
            n[c][i] = let_go(c * M_PI / 6.0, i, residual[c][i]);
        table_row(name[i], cell_if(n[0][i] >= 0, n[0][i]),
                  cell_if(n[1][i] >= 0, n[1][i]));
    }
    table_end();
    table_begin_note("slip_history", "body slip k residual",
                     "k <= %d; later ones depend on round-off", DRAWN);
    for (int c = 0; c < 2; c++)
        for (int i = NONE; i < SLIPS; i++)
            for (int k = 0; k <= DRAWN; k++) {
                if (!(residual[c][i][k] > 0.0)) break;
                table_row(c ? "turned" : "upright", name[i], k,
                          residual[c][i][k]);
            }
    table_end();

    claim(n[0][NONE] == 5 && n[1][NONE] == 5,
          "5 iterations with the right tangent (%d, %d)", n[0][NONE],
          n[1][NONE]);
    claim(n[0][COLUMN] == 6 && n[1][COLUMN] < 0,
          "with a column for a row 6, and no solution when turned");
    claim(n[0][HALF] < 0 && n[1][HALF] < 0, "with half of mu no solution");
    return table_finish();
}
