/*
 * plane.c - when is a plane enough?
 *
 * Linear elasticity in a block of 2 m by 2 m and of any depth, which is held on
 * its left side and hangs under a force of 1 N per volume: lesson 12's square
 * with a third dimension.  The block is cut into cubes, and each cube into the
 * six tetrahedra that go from one of its corners to the opposite one along its
 * edges (Kuhn's); seen along the depth they are the triangles of mesh.h.  So a
 * plane is a member of the same family: all layers move alike, and what is left
 * of the cube is a square.  Plane stress is plane strain of another material,
 *
 *     E (1 + 2 nu) / (1 + nu)^2   for E,   nu / (1 + nu)   for nu.
 *
 * Tables: how much less or more than the block each plane sags, and what the
 * planes and the block cost.
 *
 * Source: Kuhn, IBM J. Res. Dev. 4 (1960); Timoshenko and
 *         Goodier, Theory of Elasticity, sec. 16 to 18.
 */
#include "../study/study.h"
#include "base/table.h"
#include "../22_multigrid/conjugate.h"
#include "material/material.h"
#include "plane/scene.h"

#include <math.h>
#include <stdlib.h>

/* n x n x layers cubes of side 2 / n; no layers: the plane, one cube deep. */
struct block {
    int n, layers;
    double K[8][8][3][3]; /* of a cube: corner 1 of X, 2 of Y, 4 of Z (N/m) */
    double load[8];       /* force down on its corners (N) */
};

/* The tetrahedron from corner 0 along axis[0], [1], [2] to corner 7 of a cube
 * of side h.  Along each of its three edges, from a to a + 1, N_a falls to 0
 * and N_(a + 1) rises to 1. */
static void add_tetrahedron(struct block *B, const int axis[3], double h,
                            double mu, double lambda)
{
    double gradient[4][3] = {{0.0}};
    int corner[4] = {0};
    const double volume = h * h * h / 6.0;
    for (int a = 0; a < 3; a++) {
        corner[a + 1] = corner[a] + (1 << axis[a]);
        gradient[a][axis[a]] = -1.0 / h;
        gradient[a + 1][axis[a]] = 1.0 / h;
    }
    for (int a = 0; a < 4; a++) {
        B->load[corner[a]] += volume / 4.0;
        for (int b = 0; b < 4; b++) {
            const double *g = gradient[a], *k = gradient[b];
            const double gk = g[0] * k[0] + g[1] * k[1] + g[2] * k[2];
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    B->K[corner[a]][corner[b]][i][j] +=
                        volume * (lambda * g[i] * k[j] + mu * g[j] * k[i] +
                                  (i == j ? mu * gk : 0.0));
        }
    }
}

static struct block block_of(int n, int layers, double E, double nu)
{
    static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    struct block B = {.n = n, .layers = layers};
    const struct material m = material_make(CUBIC, E, nu);
    for (int t = 0; t < 6; t++)
        add_tetrahedron(&B, axes[t], 2.0 / n, m.mu, m.lambda);
    if (layers == 0) /* corners that lie behind each other move alike */
        for (int a = 0; a < 8; a++) {
            if (a > 3) B.load[a & 3] += B.load[a];
            for (int b = 0; b < 8; b++)
                for (int ij = 0; ij < 9 && (a > 3 || b > 3); ij++)
                    B.K[a & 3][b & 3][ij / 3][ij % 3] +=
                        B.K[a][b][ij / 3][ij % 3];
        }
    return B;
}

/* The number of a free vertex, 0 <= i < n, for those of the left side are held,
 * or -1: there is none. */
static int vertex(const struct block *B, int i, int j, int k)
{
    if (i < 0 || i >= B->n || j < 0 || j > B->n || k < 0 || k > B->layers)
        return -1;
    return (k * (B->n + 1) + j) * B->n + i;
}

/* K of the block, d components to a vertex, and its load f. */
static struct csr *assemble(const struct block *B, int d, double f[])
{
    const int vertices = B->n * (B->n + 1) * (B->layers + 1);
    struct csr *A = csr_alloc(d * vertices, 15 * d * d * vertices);
    int entries = 0;
    for (int row = 0; row < d * vertices; row++) {
        const int i = row / d % B->n, j = row / d / B->n % (B->n + 1);
        const int k = row / d / B->n / (B->n + 1);
        f[row] = 0.0;
        for (int o = 0; o < 27; o++) { /* neighbours, in ascending order */
            const int di = o % 3 - 1, dj = o / 3 % 3 - 1, dk = o / 9 - 1;
            const int w = vertex(B, i + di, j + dj, k + dk);
            const int up = di > 0 || dj > 0 || dk > 0;
            const int down = di < 0 || dj < 0 || dk < 0;
            if (w < 0 || (up && down)) continue; /* no edge joins the two */
            double sum[3] = {0.0};
            for (int a = 0; a < (B->layers ? 8 : 4); a++) {
                const int p = a & 1, q = a >> 1 & 1, r = a >> 2;
                const int inside = i - p >= -1 && i - p < B->n - 1 &&
                                   j - q >= 0 && j - q < B->n && k - r >= 0 &&
                                   k - r <= B->layers - (B->layers > 0);
                const int x = p + di, y = q + dj, z = r + dk;
                if (!inside || (x | y | z) & ~1) continue;
                for (int c = 0; c < d; c++)
                    sum[c] += B->K[a][x + 2 * y + 4 * z][row % d][c];
                if (o == 13 && row % d == 1) f[row] -= B->load[a];
            }
            for (int c = 0; c < d; c++) {
                A->index[entries] = d * w + c;
                A->value[entries++] = sum[c];
            }
        }
        A->start[row + 1] = entries;
    }
    return A;
}

struct answer {
    double middle, face; /* sag of (1, 0) half way through, and in front (m) */
    double unknowns, band; /* order, half bandwidth */
    double iterations, flops; /* of conjugate gradients */
};

/* 2 flops for an entry, and 13 for an unknown in the rest of an iteration. */
static struct answer solve(int n, int layers, double E, double nu)
{
    const int d = layers ? 3 : 2, order = d * n * (n + 1) * (layers + 1);
    const struct block B = block_of(n, layers, E, nu);
    double *f = allocate((size_t)order, sizeof *f);
    double *u = allocate((size_t)order, sizeof *u);
    struct csr *A = assemble(&B, d, f);
    const struct cg_report r = cg_solve(A, cg_jacobi, A, 1e-8, 9999, f, u);
    if (r.status != OK)
        die("n = %d, %d layers: %s", n, layers, status_name(r.status));
    const int tip = vertex(&B, n - 1, n / 2, 0), behind = order / (layers + 1);
    const struct answer answer = {
        .middle = -(u[d * tip + 1 + layers / 2 * behind] +
                    u[d * tip + 1 + (layers + 1) / 2 * behind]) / 2.0,
        .face = -u[d * tip + 1],
        .unknowns = order,
        .band = d * vertex(&B, 1, 1, layers > 0) + d - 1,
        .iterations = r.iterations,
        .flops = r.iterations * (2.0 * A->start[order] + 13.0 * order)};
    csr_free(A);
    free(f);
    free(u);
    return answer;
}

/* The middle's sag in the limit of ever finer meshes, from n and 2 n: the
 * corners of the held side give the error the order 2 p. */
static double limit(int n, int layers, double E, double nu)
{
    const struct material m = material_make(CUBIC, E, nu);
    const double ratio = pow(2.0, 2.0 * material_corner(&m));
    const double coarse = solve(n, layers, E, nu).middle;
    return (ratio * solve(2 * n, 2 * layers, E, nu).middle - coarse) /
           (ratio - 1.0);
}

/* How much more than a block each of the planes sags (%). */
struct off {
    double strain, stress;
};

static struct off compare(int n, int layers, double nu)
{
    const double E = 1000.0, q = 1.0 + nu, block = limit(n, layers, E, nu);
    const double thin = E * (1.0 + 2.0 * nu) / (q * q);
    return (struct off){100.0 * (limit(n, 0, E, nu) / block - 1.0),
                        100.0 * (limit(n, 0, thin, nu / q) / block - 1.0)};
}

/* Lesson 12's own K and load give the plane another time. */
static double lesson_12(int n)
{
    struct scene_setting set = scene_notes(GRAVITY, CUBIC, n);
    set.force = 1.0;
    struct scene *s = scene_alloc(&set);
    struct matrix *K = body_matrix(s->body);
    for (int r = 0; r < s->n_dof; r++) s->g[r] = -s->f[r];
    if (body_stiffness(s->body, s->u, EXACT, K) != OK ||
        body_increment(s->body, K, s->g, s->u) != OK)
        die("no increment, n = %d", n);
    const double sag = -s->u[2 * (n / 2 * (n + 1) + n) + 1];
    matrix_free(K);
    scene_free(s);
    return sag;
}

/* Conjugate gradients and a band on squares, or cubes, of up to so many cells
 * a side.  Returns the exponent of the flops of the last doubling. */
static double cost(int d, int most)
{
    double flops = 0.0, exponent = 0.0;
    for (int n = 4; n <= most; n *= 2) {
        const struct answer a = solve(n, d == 2 ? 0 : n, 1000.0, 0.3);
        table_row(d, n, a.unknowns, a.band, cell_rounded(2, a.iterations),
                  cell_rounded(2, a.flops),
                  matrix_cost(BANDED, (int)a.unknowns, (int)a.band).flops);
        exponent = log2(a.flops / flops);
        flops = a.flops;
    }
    return exponent;
}

int main(void)
{
    enum { N = 6, DEPTHS = 5 };
    static const int layers[DEPTHS] = {1, 3, 6, 12, 24};
    struct off o[DEPTHS];
    double worst = 0.0;
    table_begin_note("plane", "depth strain stress",
                     "depth over height; how much more than the block each "
                     "plane sags (%%)");
    for (int k = 0; k < DEPTHS; k++) {
        o[k] = compare(N, layers[k], 0.3);
        table_row((double)layers[k] / N, cell_rounded(4, o[k].strain),
                  cell_rounded(4, o[k].stress));
        worst = fmax(worst, fmin(fabs(o[k].strain), fabs(o[k].stress)));
    }
    table_end();

    const struct off wet = compare(N, N, 0.45), coarse = compare(4, 4, 0.3);
    const struct answer deep = solve(N, 2 * N, 1000.0, 0.3);
    const double bulge = 100.0 * (deep.middle / deep.face - 1.0);
    table_begin_note("others", "nu_0.45 coarser_strain coarser_stress bulge",
                     "depth = height: strain; both from n = 4 and 8; depth = 2 "
                     "heights: the middle against the face (%%)");
    table_row(cell_rounded(4, wet.strain), cell_rounded(4, coarse.strain),
              cell_rounded(4, coarse.stress), cell_rounded(4, bulge));
    table_end();

    table_begin_note("cost", "components n unknowns band iterations cg_flops "
                     "band_flops", "a square or a cube, |r| <= 1e-8 |f|");
    const double square = cost(2, 64), cube = cost(3, 16);
    table_end();
    int fits = 1; /* a square's band within 33 ms at 1e9 flops per second */
    for (double flops = 0.0; flops <= 3.3e7; fits++)
        flops = matrix_cost(BANDED, 2 * (fits + 1) * (fits + 2),
                            2 * (fits + 2) + 1).flops;
    fits--;
    table_begin("fits", "n");
    table_row(fits);
    table_end();

    claim(fabs(solve(N, 0, 1000.0, 0.3).middle / lesson_12(N) - 1.0) < 1e-6,
          "the plane is the square of lesson 12");
    claim(o[0].stress < 2.0 && o[DEPTHS - 1].strain > -2.0,
          "a thin block is in plane stress (off by %g %%), a deep one in plane "
          "strain (%g %%)", o[0].stress, o[DEPTHS - 1].strain);
    for (int k = 1; k < DEPTHS; k++)
        claim(o[k].strain > o[k - 1].strain && o[k].stress > o[k - 1].stress,
              "the deeper, the nearer to plane strain (row %d)", k);
    claim(worst < 3.0, "one of the planes is within 3 %% (%g)", worst);
    claim(fabs(coarse.strain - o[2].strain) < 0.5 &&
          fabs(coarse.stress - o[2].stress) < 0.5,
          "coarser meshes say the same to half a per cent: %g and %g",
          coarse.strain, coarse.stress);
    claim(-wet.strain > 2.0 * -o[2].strain, "at nu = 0.45 plane strain is off "
          "by more than twice as much (%g)", wet.strain);
    claim(fabs(square - 3.0) < 0.15 && fabs(cube - 4.0) < 0.15,
          "conjugate gradients cost n^3 in the plane (%g) and n^4 in space "
          "(%g)", square, cube);
    return table_finish();
}
