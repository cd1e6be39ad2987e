/*
 * sag.c - which elements do not lock, and what do they say about the volume?
 *
 * The square of lesson 12's study of locking, at three of Poisson's ratios.
 * Tables: how much of the sag of (1, 0) is missing, against the limit of graded
 * quadratic triangles, and the size of div u, of that of the limit; linear
 * triangles on far finer meshes; and the limit.
 */
#include "hang.h"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

static const char *const word[] = HANG_WORDS;
static const double nu[] = {0.3, 0.49, 0.4999};
static const struct {
    enum hang_element element;
    double m;
} kind[] = {{HANG_LINEAR, 1.0}, {HANG_LINEAR, 1.5}, {HANG_AVERAGED, 1.0},
            {HANG_CROSSED, 1.0}, {HANG_QUADRATIC, 1.0}, {HANG_QUADRATIC, 2.0}};
enum { RATIOS = COUNT(nu), KINDS = COUNT(kind), SIZES = 3, MOST = 32 };
static double missing[KINDS][SIZES][RATIOS], div_u[KINDS][SIZES][RATIOS];

/* Both components of the vertices that are not held. */
static int unknowns(enum hang_element element, int n)
{
    const int cells = element == HANG_QUADRATIC ? 2 * n : n;
    const int middles = element == HANG_CROSSED ? n * n : 0;
    return 2 * (cells * (cells + 1) + middles);
}

static void print_sag(void)
{
    table_begin("sag", "element m n unknowns missing_0.3 missing_0.49 "
                       "missing_0.4999 div_0.3 div_0.49 div_0.4999");
    for (int k = 0; k < KINDS; k++)
        for (int j = 0; j < SIZES; j++) {
            /* differences, of which the condition of K takes digits */
            struct cell row[10] = {cell_word(word[kind[k].element]),
                                   cell_number(kind[k].m), cell_number(8 << j),
                                   cell_number(unknowns(kind[k].element,
                                                        8 << j))};
            for (int r = 0; r < RATIOS; r++) {
                row[4 + r] = cell_rounded(3, missing[k][j][r]);
                row[7 + r] = cell_rounded(4, div_u[k][j][r]);
            }
            table_row_of(10, row);
        }
    table_end();
}

/* Linear triangles, even and graded, nu = 0.4999, from n = 32 on. */
static void finer(const struct hang *limit)
{
    table_begin("finer", "element m n missing_0.4999 div_0.4999");
    for (int k = 0; k < 2; k++) {
        double lacks[4];
        for (int j = 0; j < 4; j++) {
            const struct hang hang =
                hang_of(HANG_LINEAR, 32 << j, kind[k].m, nu[RATIOS - 1]);
            lacks[j] = 1.0 - hang.sag / limit->sag;
            table_row(word[HANG_LINEAR], kind[k].m, 32 << j,
                      cell_rounded(3, lacks[j]),
                      cell_rounded(4, hang.div / limit->div));
        }
        claim(lacks[1] > 0.2 && lacks[3] < 0.1 && lacks[3] < 0.6 * lacks[2],
              "linear triangles, m = %g: n = 64 lacks a fifth still, n = 256 "
              "less than a tenth (%g, %g)", kind[k].m, lacks[1], lacks[3]);
    }
    table_end();
}

/* The means of div u over the squares of averaged triangles [eq:averaged] at
 * nu = 0.4999: their size, and that of what alternates in two by two of them.
 */
static void squares(int n, const struct hang *limit)
{
    struct mesh *mesh;
    double *u, of[MOST * MOST] = {0.0}, size = 0.0, part = 0.0;
    hang_whole(HANG_AVERAGED, n, 1.0, nu[RATIOS - 1], &mesh, &u);
    for (int e = 0; e < mesh->n_triangle; e++) { /* two and two of a square */
        const int *t = &mesh->triangle[3 * e];
        double g[6];
        mesh_gradients(mesh, e, g);
        for (int a = 0; a < 3; a++)
            for (int k = 0; k < 2; k++)
                of[e / 2] += 0.5 * g[2 * a + k] * u[2 * t[a] + k];
    }
    for (int cell = 0; cell < n * n; cell++) size += of[cell] * of[cell];
    for (int j = 0; j < n - 1; j++)
        for (int i = 0; i < n - 1; i++) {
            const double *low = &of[j * n + i];
            part += pow((low[0] - low[1] - low[n] + low[n + 1]) / 4.0, 2.0);
        }
    size = sqrt(size) / n / limit->div;
    part = sqrt(part) / (n - 1) / limit->div;
    claim(fabs(size - 1.1) < 0.1 &&
              fabs(part - (n == 8 ? 0.43 : 0.22)) < 0.02,
          "averaged, n = %d: the mean of div u over a square has the right "
          "size (%g), but alternates (%g)", n, size, part);
    free(u);
    mesh_free(mesh);
}

int main(void)
{
    struct hang limit[RATIOS];
    double last[KINDS], of_div[KINDS]; /* n = 32, nu = 0.4999 */

    for (int r = 0; r < RATIOS; r++)
        limit[r] = hang_limit(nu[r]);
    for (int k = 0; k < KINDS; k++) {
        for (int j = 0; j < SIZES; j++)
            for (int r = 0; r < RATIOS; r++) {
                const struct hang hang =
                    hang_of(kind[k].element, 8 << j, kind[k].m, nu[r]);
                missing[k][j][r] = 1.0 - hang.sag / limit[r].sag;
                div_u[k][j][r] = hang.div / limit[r].div;
            }
        last[k] = missing[k][SIZES - 1][RATIOS - 1];
        of_div[k] = div_u[k][SIZES - 1][RATIOS - 1];
    }
    print_sag();
    finer(&limit[RATIOS - 1]);
    table_begin("limit", "nu sag");
    for (int r = 0; r < RATIOS; r++)
        table_row(nu[r], cell_rounded(6, limit[r].sag));
    table_end();
    claim(fabs(limit[RATIOS - 1].sag + 0.010525) < 2e-7 &&
          fabs(limit[RATIOS - 1].div / 5.8e-7 - 1.0) < 0.02, "nu = 0.4999: "
          "extrapolated from n = 64, 128 and 256, the sag is 0.010525, and "
          "div u 5.8e-7 (%g, %g)", limit[RATIOS - 1].sag,
          limit[RATIOS - 1].div);
    claim(last[0] > 0.3 && last[1] > 0.3,
          "n = 32, nu = 0.4999: linear triangles lack a third, graded or not "
          "(%g, %g)", last[0], last[1]);
    claim(last[2] < 0.02 && last[3] < 0.02,
          "averaged and criss-cross triangles lack less than 2 %% (%g, %g)",
          last[2], last[3]);
    claim(last[4] < 0.01 && fabs(last[5] - 0.0014) < 1e-4,
          "quadratic lack less than 1 %%, and graded ones 0.14 %% (%g, %g)",
          last[4], last[5]);
    claim(of_div[2] > 300.0 && fabs(of_div[3] - 1.1) < 0.1 &&
          fabs(of_div[4] - 1.2) < 0.1,
          "div u per triangle is a multiple of its size when it is averaged "
          "(%g), but comes down to it in criss-cross and quadratic triangles "
          "(%g, %g)",
          of_div[2], of_div[3], of_div[4]);
    for (int n = 8; n <= MOST; n *= 4) squares(n, &limit[RATIOS - 1]);
    return table_finish();
}
