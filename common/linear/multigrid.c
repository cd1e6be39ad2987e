/* multigrid.c - see multigrid.h. */
#include "linear/multigrid.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Vertex v of grid n has a quarter of each of the corners 0 to 3 of grid n/2,
 * of which some may be one and the same; -1: that one is held. */
static int corner(int n, int v, int c)
{
    const int i = v % (n - 1) + 1, j = v / (n - 1);
    const int I = (i + c % 2) / 2, J = (j + c / 2) / 2;
    return I == 0 || I == n / 2 ? -1 : J * (n / 2 - 1) + I - 1;
}

void multigrid_prolong(int n, const double coarse[], double fine[])
{
    for (int v = 0; v < (n - 1) * (n + 1); v++)
        for (int c = 0; c < 4; c++) {
            const int V = corner(n, v, c);
            for (int k = 0; k < 2 && V >= 0; k++)
                fine[2 * v + k] += 0.25 * coarse[2 * V + k];
        }
}

void multigrid_restrict(int n, const double fine[], double coarse[])
{
    for (int v = 0; v < (n - 1) * (n + 1); v++)
        for (int c = 0; c < 4; c++) {
            const int V = corner(n, v, c);
            for (int k = 0; k < 2 && V >= 0; k++)
                coarse[2 * V + k] += 0.25 * fine[2 * v + k];
        }
}

/* Zeros for a vertex and the eight around it, both components. */
static struct csr *pattern(int n)
{
    const int width = n - 1, height = n + 1, size = 2 * width * height;
    struct csr *A = csr_alloc(size, 18 * size);
    for (int row = 0, k = 0; row < size; row++) {
        const int i = row / 2 % width, j = row / 2 / width;
        for (int s = 0; s < 9; s++) {
            const int i1 = i + s % 3 - 1, j1 = j + s / 3 - 1;
            if (i1 < 0 || i1 >= width || j1 < 0 || j1 >= height) continue;
            A->index[k++] = 2 * (j1 * width + i1);
            A->index[k++] = 2 * (j1 * width + i1) + 1;
        }
        A->start[row + 1] = k;
    }
    return A;
}

struct csr *multigrid_coarse(const struct csr *K, int n)
{
    struct csr *A = pattern(n / 2);
    for (int row = 0; row < K->n; row++)
        for (int k = K->start[row]; k < K->start[row + 1]; k += 2)
            for (int c = 0; c < 16; c++) {
                const int V = corner(n, row / 2, c % 4);
                const int W = corner(n, K->index[k] / 2, c / 4);
                if (V < 0 || W < 0) continue;
                int q = A->start[2 * V + row % 2];
                while (A->index[q] != 2 * W) q += 2;
                A->value[q] += 0.0625 * K->value[k];
                A->value[q + 1] += 0.0625 * K->value[k + 1];
            }
    return A;
}

struct multigrid *multigrid_alloc(const struct csr *K, int n)
{
    struct multigrid *m = allocate(1, sizeof *m);
    assert(K->n == 2 * (n - 1) * (n + 1));
    m->K[0] = (struct csr *)K;
    for (int g = 0;; g++) {
        const int size = m->K[g]->n;
        m->grids = g + 1;
        m->n[g] = n;
        m->x[g] = allocate(3 * (size_t)size, sizeof *m->x[g]);
        m->b[g] = m->x[g] + size;
        m->r[g] = m->b[g] + size;
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
        x[i] += rest / diagonal;
    }
}

static void cycle(const struct multigrid *m, int g)
{
    const struct csr *K = m->K[g];
    double *x = m->x[g], *b = m->b[g], *r = m->r[g];
    const size_t bytes = (size_t)K->n * sizeof *x;
    if (g == m->grids - 1) {
        memcpy(x, b, bytes);
        matrix_solve(m->coarsest, x);
        return;
    }
    memset(x, 0, bytes);
    for (int s = 0; s < SWEEPS; s++) multigrid_sweep(K, b, 0, x);
    csr_multiply(K, x, r);
    for (int i = 0; i < K->n; i++) r[i] = b[i] - r[i];
    memset(m->b[g + 1], 0, (size_t)m->K[g + 1]->n * sizeof *b);
    multigrid_restrict(m->n[g], r, m->b[g + 1]);
    cycle(m, g + 1);
    multigrid_prolong(m->n[g], m->x[g + 1], x);
    for (int s = 0; s < SWEEPS; s++) multigrid_sweep(K, b, 1, x);
}

void multigrid_cycle(const void *multigrid, const double r[], double z[])
{
    const struct multigrid *m = multigrid;
    const size_t bytes = (size_t)m->K[0]->n * sizeof *z;
    memcpy(m->b[0], r, bytes);
    cycle(m, 0);
    memcpy(z, m->x[0], bytes);
}
