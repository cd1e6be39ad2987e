/*
 * printed_tangent.c - what do the two slips of the notes' listing of dP/dF do
 * to Newton's method?
 *
 * The slips: see slips.c.  The default scene of lesson 12, upright, and all of
 * it turned by 30 degrees.  K is eliminated as it is, symmetric or not; but if
 * "Cholesky", its lower triangle alone is read, as in the lesson's program.
 * A pivot that is not positive ends it.  Table: residuals, free vertices (N/m).
 */
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

enum { NONE, COLUMN, HALF, LOWER = 4, RUNS = 6 };
enum { CAP = 40, DRAWN = 12, SIZE = 162 };
static const char *const name[RUNS] = {
    "none", "column for row", "half of mu", "both", "none, Cholesky",
    "column for row, Cholesky"};
static double K[SIZE][SIZE];

/* The change of P with F by e_j (x) g: the right one, and what slips add. */
static mat2 change(const struct material *law, mat2 F, int slip, int j,
                   const double g[2], double area)
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
    return mat2_scale(area, dP);
}

/* What triangle e adds to K: column (b, j) answers to component j of u_b. */
static void add_triangle(const struct scene *s, int e, int slip)
{
    const int *t = &s->mesh->triangle[3 * e];
    const mat2 F = body_deformation(s->body, s->u, e);
    double g[6];
    const double area = mesh_gradients(s->mesh, e, g);

    for (int b = 0; b < 3; b++)
        for (int j = 0; j < 2; j++) {
            const mat2 dP = change(&s->body->material, F, slip, j,
                                   &g[2 * b], area);
            for (int a = 0; a < 3; a++)
                for (int i = 0; i < 2; i++)
                    K[2 * t[a] + i][2 * t[b] + j] +=
                        dP.m[i][0] * g[2 * a] + dP.m[i][1] * g[2 * a + 1];
        }
}

/* q := K^-1 q by elimination, row by row; rows of held vertices stay out.
 * 0: a pivot is not positive, as it is if K is positive definite. */
static int solve(const struct scene *s, int slip, double q[])
{
    memset(K, 0, sizeof K);
    for (int e = 0; e < s->mesh->n_triangle; e++) add_triangle(s, e, slip);
    for (int r = 0; r < SIZE; r++) {
        if (s->held[r / 2]) q[r] = 0.0;
        for (int c = 0; c < SIZE; c++)
            if (s->held[r / 2] || s->held[c / 2]) K[r][c] = r == c;
            else if (slip & LOWER && r < c) K[r][c] = K[c][r];
    }
    for (int p = 0; p < SIZE; p++) {
        if (!(K[p][p] > 0.0)) return 0;
        for (int r = p + 1; r < SIZE; r++) {
            const double factor = K[r][p] / K[p][p];
            for (int c = p; c < SIZE; c++) K[r][c] -= factor * K[p][c];
            q[r] -= factor * q[p];
        }
    }
    for (int p = SIZE - 1; p >= 0; p--) {
        for (int c = p + 1; c < SIZE; c++) q[p] -= K[p][c] * q[c];
        q[p] /= K[p][p];
    }
    return 1;
}

/* max|q| over the free vertices, in the directions of the turned scene. */
static double largest(const struct scene *s, mat2 R, const double q[])
{
    double size = 0.0;
    for (int a = 0; a < s->mesh->n_vertex; a++)
        for (int i = 0; i < 2; i++) {
            const double p = R.m[0][i] * q[2 * a] + R.m[1][i] * q[2 * a + 1];
            if (!s->held[a] && !(fabs(p) <= size)) size = fabs(p);
        }
    return size;
}

/* The start: stretched evenly, as the ends are, and then turned. */
static void start(struct scene *s, mat2 R)
{
    const double stretch = 1.0 + s->set.reach * sin(1.0);
    for (int a = 0; a < s->mesh->n_vertex; a++)
        for (int i = 0; i < 2; i++) {
            const double *X = &s->mesh->X[2 * a], *row = R.m[i];
            s->u[2 * a + i] = row[0] * stretch * X[0] + row[1] * X[1] - X[i];
        }
}

/* residual[k]: max|q| before iteration k, *last the last k; is that the
 * solution?  Otherwise a pivot is not positive, or *last is CAP. */
static int converges(double angle, int slip, double residual[], int *last)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, 8);
    set.reach = 0.5;
    struct scene *s = scene_alloc(&set);
    const mat2 R = mat2_rotation(angle);
    double q[SIZE], move = INFINITY;

    start(s, R);
    for (*last = 0; *last <= CAP; ++*last) {
        body_assemble(s->body, at_rest(NULL), s->u, NO_TANGENT, q);
        residual[*last] = largest(s, R, q);
        if (move <= 1e-10 || *last == CAP || !solve(s, slip, q)) break;
        move = body_max_free(s->body, q);
        for (int r = 0; r < SIZE; r++) s->u[r] -= q[r];
    }
    scene_free(s);
    return move <= 1e-10;
}

int main(void)
{
    double residual[CAP + 1];
    int ends[2][RUNS], last[2][RUNS];

    table_begin_note("slip_history", "body slip k residual", "k <= %d", DRAWN);
    for (int c = 0; c < 2; c++)
        for (int i = NONE; i < RUNS; i++) {
            ends[c][i] = converges(c * M_PI / 6.0, i, residual, &last[c][i]);
            for (int k = 0; k <= last[c][i] && k <= DRAWN; k++)
                table_row(c ? "turned" : "upright", name[i], k, residual[k]);
        }
    table_end();

    const int *up = last[0], *turned = last[1], lower = COLUMN | LOWER;
    claim(ends[0][NONE] && ends[1][NONE] && up[NONE] == 5 && turned[NONE] == 5,
          "5 with the correct tangent (%d, %d)", up[NONE], turned[NONE]);
    claim(ends[0][COLUMN] && up[COLUMN] == 10 && turned[COLUMN] == CAP,
          "with a column for a row 10 (%d), and not in %d when turned (%d)",
          up[COLUMN], CAP, turned[COLUMN]);
    claim(!ends[0][lower] && up[lower] == 8 && turned[lower] == 0,
          "by Cholesky a pivot is not positive (%d), at once when turned (%d)",
          up[lower], turned[lower]);
    claim(up[HALF] == 0 && turned[HALF] == 1,
          "with half of mu a pivot is not positive, at once (%d), or after a "
          "step when turned (%d)", up[HALF], turned[HALF]);
    return table_finish();
}
