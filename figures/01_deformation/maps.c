/*
 * maps.c - what does a mesh see of the two maps of the notes' Figure 4?
 *
 * X^2 and sin 2 pi X on n equal elements of (0, 1): F of an element is a mean
 * of phi' [eq:deformation-gradient].  sin 2 pi X inverts the elements whose
 * midpoint lies inside (1/4, 3/4) and collapses those with a midpoint at 1/4 or
 * 3/4.  X^2 inverts none, but its smallest F is 1/n, since phi'(0) = 0, and
 * near 0 the stress of a law with a logarithm (lesson 02) has no limit.
 */
#include "bar/poisson.h"
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <math.h>

static double square(double X) { return X * X; }
static double sine(double X) { return sin(2.0 * M_PI * X); }

/* Figure 4 has 10 elements. */
enum { N_MAX = 32, N_PICTURE = 10 };

struct element {
    double F;
    int sign; /* 1, -1, or 0: |F| h is what round-off can do */
};

/* Element e of n under phi. */
static struct element element_of(field *phi, int e, int n)
{
    double X[N_MAX + 1];
    poisson_grid(0.0, 1.0, n, 1.0, X);
    const double rise = phi(X[e + 1]) - phi(X[e]);
    const int collapsed = fabs(rise) <= 16.0 * DBL_EPSILON;
    return (struct element){rise / (X[e + 1] - X[e]),
                            collapsed ? 0 : rise > 0.0 ? 1 : -1};
}

static const char *word(int sign)
{
    return sign > 0 ? "upright" : sign < 0 ? "inverted" : "collapsed";
}

/* On n elements: smallest F of X^2, and the share that the sine inverts.
 * Returns how many elements break the two rules; the midpoint of element e is
 * (2 e + 1) / 2 n. */
static int print_refinement_row(int n)
{
    double min_F = INFINITY;
    int inverted = 0, collapsed = 0, broken = 0;
    for (int e = 0; e < n; e++) {
        const int sign = element_of(sine, e, n).sign, middle = 4 * e + 2;
        const int due = middle == n || middle == 3 * n ? 0
                        : middle > n && middle < 3 * n ? -1 : 1;
        broken += sign != due;
        inverted += sign < 0;
        collapsed += sign == 0;
        min_F = fmin(min_F, element_of(square, e, n).F);
    }
    table_row(n, min_F, inverted, collapsed, (double)inverted / n);
    return broken + !(fabs(min_F * n - 1.0) < 1e-12);
}

static void print_near_zero(void)
{
    const struct material log_law = material_notes(LOG);
    double before = 0.0;
    int steep = 1;
    table_begin("near_zero", "X log_stress");
    for (int k = 1; k <= 3; k++) {
        const double X = gsl_pow_int(10.0, -k);
        const double stress = material1_pk1(&log_law, 2.0 * X);
        table_row(X, stress);
        if (k > 1) steep &= stress < 10.0 * before;
        before = stress;
    }
    table_end();
    claim(steep, "with each tenth of X the log law's compression grows by more "
          "than 10");
}

int main(void)
{
    int broken = 0;

    table_begin("curve", "X square square_dX sine sine_dX");
    for (int k = 0; k <= 200; k++) {
        const double X = k / 200.0;
        table_row(X, square(X), 2.0 * X, sine(X),
                  2.0 * M_PI * cos(2.0 * M_PI * X));
    }
    table_end();
    table_begin("bar", "X0 X1 square_F square_sign sine_F sine_sign");
    for (int e = 0; e < N_PICTURE; e++) {
        const struct element a = element_of(square, e, N_PICTURE);
        const struct element b = element_of(sine, e, N_PICTURE);
        table_row((double)e / N_PICTURE, (e + 1.0) / N_PICTURE, a.F,
                  word(a.sign), b.F, word(b.sign));
    }
    table_end();
    table_begin("refine", "n square_min_F inverted collapsed share");
    for (int n = 2; n <= N_MAX; n++) broken += print_refinement_row(n);
    table_end();
    print_near_zero();

    claim(broken == 0, "the sine inverts by midpoints, and the smallest F of "
          "X^2 is 1/n (%d exceptions)", broken);
    return table_finish();
}
