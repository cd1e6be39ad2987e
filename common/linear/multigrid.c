/* multigrid.c - see multigrid.h. */
#include "linear/multigrid.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Vertex v of grid n has a quarter of each of the four corners of grid n/2, of
 * which some may be one and the same; -1: that one is held. */
static void find_corners(int n, int v, int corner[4])
{
    const int i = v % (n - 1) + 1, j = v / (n - 1);
    for (int up = 0; up < 2; up++) /* (i / 2, j / 2), rounded down and up */
        for (int right = 0; right < 2; right++) {
            const int I = (i + right) / 2, J = (j + up) / 2;
            *corner++ = I == 0 || I == n / 2 ? -1 : J * (n / 2 - 1) + I - 1;
        }
}

void multigrid_prolong(int n, const double coarse[], double fine[])
{
    for (int v = 0; v < (n - 1) * (n + 1); v++) {
        int V[4];
        find_corners(n, v, V);
        for (int c = 0; c < 4; c++) {
            if (V[c] < 0) continue;
            for (int k = 0; k < 2; k++)
                fine[2 * v + k] += 0.25 * coarse[2 * V[c] + k]; /* P coarse */
        }
    }
}

void multigrid_restrict(int n, const double fine[], double coarse[])
{
    for (int v = 0; v < (n - 1) * (n + 1); v++) {
        int V[4];
        find_corners(n, v, V);
        for (int c = 0; c < 4; c++) {
            if (V[c] < 0) continue;
            for (int k = 0; k < 2; k++)
                coarse[2 * V[c] + k] += 0.25 * fine[2 * v + k]; /* P^T fine */
        }
    }
}

/* index[k], ... := both components of vertex (i, j) and of the eight around
 * it; returns the new k. */
static int add_neighbours(int width, int height, int i, int j, int k,
                          int index[])
{
    for (int j1 = j - 1; j1 <= j + 1; j1++)
        for (int i1 = i - 1; i1 <= i + 1; i1++) {
            if (i1 < 0 || i1 >= width || j1 < 0 || j1 >= height) continue;
            index[k++] = 2 * (j1 * width + i1);
            index[k++] = 2 * (j1 * width + i1) + 1;
        }
    return k;
}

/* Return zeros for a vertex and the eight around it, both components. */
static struct csr *pattern(int n)
{
    const int width = n - 1, height = n + 1, size = 2 * width * height;
    struct csr *A = csr_alloc(size, 18 * size);
    int *end = A->start, k = 0;
    for (int j = 0; j < height; j++)
        for (int i = 0; i < width; i++)
            for (int component = 0; component < 2; component++) {
                k = add_neighbours(width, height, i, j, k, A->index);
                *++end = k;
            }
    return A;
}

/* Spread row i of the block of a vertex with corners V and of vertex w. */
static void spread(const double value[2], int n, int w, const int V[4], int i,
                   struct csr *A)
{
    int W[4];
    find_corners(n, w, W);
    /* (P^T K P)_VW += P_vV K_vw P_wW, a quarter of P for each corner */
    for (int d = 0; d < 4; d++)
        for (int c = 0; c < 4; c++) {
            if (V[c] < 0 || W[d] < 0) continue;
            int q = A->start[2 * V[c] + i];
            while (A->index[q] != 2 * W[d]) q += 2;
            A->value[q] += 0.0625 * value[0];
            A->value[q + 1] += 0.0625 * value[1];
        }
}

struct csr *multigrid_coarse(const struct csr *K, int n)
{
    struct csr *A = pattern(n / 2);
    for (int v = 0; v < K->n / 2; v++) {
        int V[4];
        find_corners(n, v, V);
        for (int i = 0; i < 2; i++) {
            const int row = 2 * v + i;
            for (int k = K->start[row]; k < K->start[row + 1]; k += 2)
                spread(&K->value[k], n, K->index[k] / 2, V, i, A);
        }
    }
    return A;
}

struct multigrid *multigrid_alloc(const struct csr *K, int n)
{
    struct multigrid *m = allocate(1, sizeof *m);
    assert(K->n == 2 * (n - 1) * (n + 1));
    m->K[0] = (struct csr *)K;
    for (int g = 0;; g++) {
        const size_t size = (size_t)m->K[g]->n;
        m->grids = g + 1;
        m->n[g] = n;
        m->x[g] = allocate(size, sizeof *m->x[g]);
        m->b[g] = allocate(size, sizeof *m->b[g]);
        m->r[g] = allocate(size, sizeof *m->r[g]);
        if (n % 2 || n < 8 || m->grids == GRIDS) break;
        m->K[g + 1] = multigrid_coarse(m->K[g], n);
        n /= 2;
    }
    const struct csr *last = m->K[m->grids - 1];
    m->coarsest = matrix_alloc(BANDED, last->n, 2 * n + 1);
    for (int i = 0; i < last->n; i++)
        for (int k = last->start[i]; k < last->start[i + 1]; k++)
            matrix_add(m->coarsest, i, last->index[k], last->value[k]);
    m->status = matrix_factor(m->coarsest);
    return m;
}

void multigrid_free(struct multigrid *m)
{
    if (!m) return;
    for (int g = 0; g < m->grids; g++) {
        if (g > 0) csr_free(m->K[g]);
        free(m->x[g]);
        free(m->b[g]);
        free(m->r[g]);
    }
    matrix_free(m->coarsest);
    free(m);
}

void multigrid_sweep(const struct csr *K, const double b[], int backward,
                     double x[])
{
    for (int s = 0; s < K->n; s++) {
        const int i = backward ? K->n - 1 - s : s;
        double rest = b[i], diagonal = 0.0;
        for (int k = K->start[i]; k < K->start[i + 1]; k++) {
            rest -= K->value[k] * x[K->index[k]];
            if (K->index[k] == i) diagonal = K->value[k];
        }
        x[i] += rest / diagonal; /* row i now holds: sum_j K_ij x_j = b_i */
    }
}

static void cycle(const struct multigrid *m, int g)
{
    const struct csr *K = m->K[g];
    double *x = m->x[g], *b = m->b[g], *r = m->r[g];
    const size_t bytes = (size_t)K->n * sizeof *x;
    if (g == m->grids - 1) {
        memcpy(x, b, bytes);
        matrix_solve(m->coarsest, x); /* x = K^-1 b */
        return;
    }
    memset(x, 0, bytes);
    for (int s = 0; s < SWEEPS; s++) multigrid_sweep(K, b, 0, x);
    csr_multiply(K, x, r);
    for (int i = 0; i < K->n; i++) r[i] = b[i] - r[i]; /* b - K x */
    memset(m->b[g + 1], 0, (size_t)m->K[g + 1]->n * sizeof *b);
    multigrid_restrict(m->n[g], r, m->b[g + 1]); /* P^T (b - K x) */
    cycle(m, g + 1);
    multigrid_prolong(m->n[g], m->x[g + 1], x);
    /* backward, so that the cycle is symmetric, as CG needs it */
    for (int s = 0; s < SWEEPS; s++) multigrid_sweep(K, b, 1, x);
}

void multigrid_cycle(const void *multigrid, const double r[], double z[])
{
    const struct multigrid *m = multigrid;
    const size_t bytes = (size_t)m->K[0]->n * sizeof *z;
    memcpy(m->b[0], r, bytes);
    cycle(m, 0); /* x = B b, B about K^-1 */
    memcpy(z, m->x[0], bytes);
}
