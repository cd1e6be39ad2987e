/* banded.c - see banded.h. */
#include "linear/banded.h"

#include <float.h>
#include <math.h>

/* p = 1, Thomas' algorithm: A = L D L^T, L with ones on its diagonal; a keeps
 * D_jj and L_j+1,j.  One division per column, and no square root. */
static enum status thomas_factor(int n, double a[])
{
    double lift = 0.0; /* L_j,j-1^2 D_j-1,j-1 */
    for (int j = 0; j < n; j++) {
        const double A_jj = a[2 * j], below = a[2 * j + 1];
        a[2 * j] = A_jj - lift;
        if (!(a[2 * j] > n * DBL_EPSILON * A_jj)) return NOT_SPD; /* NaN too */
        a[2 * j + 1] = below / a[2 * j];
        lift = a[2 * j + 1] * below;
    }
    return OK;
}

static void thomas_solve(int n, const double l[], double b[])
{
    for (int j = 1; j < n; j++) b[j] -= l[2 * j - 1] * b[j - 1]; /* L y = b */
    b[n - 1] /= l[2 * n - 2];
    for (int j = n - 2; j >= 0; j--) /* D L^T x = y */
        b[j] = b[j] / l[2 * j] - l[2 * j + 1] * b[j + 1];
}

enum status banded_factor(int n, int p, double a[])
{
    if (p == 1) return thomas_factor(n, a);
    for (int j = 0; j < n; j++) {
        double *column = &a[j * (p + 1)]; /* A_jj, A_j+1,j, ..., A_j+p,j */
        const double A_jj = column[0];
        for (int k = j > p ? j - p : 0; k < j; k++) {
            /* L_jk and the entries below it: A_ij -= L_jk L_ik */
            const double *L_k = &a[k * (p + 1) + j - k];
            for (int d = 0; d <= p - (j - k); d++) column[d] -= L_k[0] * L_k[d];
        }
        if (!(column[0] > n * DBL_EPSILON * A_jj)) return NOT_SPD; /* NaN too */
        column[0] = sqrt(column[0]);
        const double inverse = 1.0 / column[0];
        for (int d = 1; d <= p; d++) column[d] *= inverse;
    }
    return OK;
}

void banded_solve(int n, int p, const double l[], double b[])
{
    if (p == 1) {
        thomas_solve(n, l, b);
        return;
    }
    for (int j = 0; j < n; j++) { /* L y = b */
        const double *column = &l[j * (p + 1)];
        const int last = n - 1 - j < p ? n - 1 - j : p;
        b[j] /= column[0];
        for (int d = 1; d <= last; d++) b[j + d] -= column[d] * b[j];
    }
    for (int j = n - 1; j >= 0; j--) { /* L^T x = y */
        const double *column = &l[j * (p + 1)];
        const int last = n - 1 - j < p ? n - 1 - j : p;
        for (int d = 1; d <= last; d++) b[j] -= column[d] * b[j + d];
        b[j] /= column[0];
    }
}
