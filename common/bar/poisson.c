/* poisson.c - see poisson.h. */
#include "bar/poisson.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_log.h>
#include <math.h>

const struct poisson_held POISSON_HELD = {238.5, {0.2385, -0.137, 0.512}};

double smooth_beta(double x)
{
    return exp(x);
}

double smooth_f(double x)
{
    return 2.0 * exp(x) * (2.0 * sin(2.0 * x) - cos(2.0 * x));
}

double smooth_exact(double x)
{
    return sin(2.0 * x);
}

double smooth_exact_dx(double x)
{
    return 2.0 * cos(2.0 * x);
}

double field_one(double x)
{
    (void)x;
    return 1.0;
}

double field_zero(double x)
{
    (void)x;
    return 0.0;
}

double bvp_beta(double x)
{
    return 1.0 + x;
}

double bvp_f(double x)
{
    return 1.0 / ((1.0 + x) * (1.0 + x));
}

double bvp_exact(double x)
{
    return 2.0 - 1.0 / (1.0 + x) - log1p(x);
}

double bvp_exact_dx(double x)
{
    return -x / ((1.0 + x) * (1.0 + x));
}

const struct quadrature MIDPOINT = {1, {0.5}, {1.0}};
const struct quadrature TRAPEZOID = {2, {0.0, 1.0}, {0.5, 0.5}};
/* at 1/2 -+ 1 / (2 sqrt(3)) */
const struct quadrature GAUSS2 = {
    2, {0.21132486540518711775, 0.78867513459481288225}, {0.5, 0.5}};

void poisson_grid(double a, double b, int n, double grading, double x[])
{
    /* h_j = h_1 g^(j-1) with g^(n-1) = grading; expm1 keeps g near 1 exact */
    const double log_g = n > 1 ? log(grading) / (n - 1) : 0.0;
    for (int j = 0; j <= n; j++)
        x[j] = log_g == 0.0
                   ? a + (b - a) * j / n
                   : a + (b - a) * expm1(j * log_g) / expm1(n * log_g);
    x[n] = b;
}

void poisson_element(double x0, double x1, field *beta, field *f,
                     const struct quadrature *rule, double K[2][2],
                     double r[2])
{
    const double h = x1 - x0;
    double beta_mean = 0.0;

    r[0] = r[1] = 0.0;
    for (int k = 0; k < rule->n; k++) {
        const double s = rule->s[k];
        const double x = x0 + s * h;
        const double load = rule->w[k] * h * f(x);
        beta_mean += rule->w[k] * beta(x); /* int beta / h */
        r[0] += load * (1.0 - s); /* int f e_a, where the hats are 1 - s, s */
        r[1] += load * s;
    }
    K[0][0] = K[1][1] = beta_mean / h; /* int beta e_a' e_c', slopes -+1/h */
    K[0][1] = K[1][0] = -beta_mean / h;
}

void poisson_assemble(int n, const double x[], field *beta, field *f,
                      const struct quadrature *rule, struct matrix *A,
                      double b[])
{
    matrix_zero(A);
    for (int i = 0; i <= n; i++) b[i] = 0.0;

    for (int e = 0; e < n; e++) {
        double K[2][2], r[2];
        poisson_element(x[e], x[e + 1], beta, f, rule, K, r);
        for (int a = 0; a < 2; a++) {
            b[e + a] += r[a]; /* element e, from 0, has nodes e and e + 1 */
            for (int c = 0; c < 2; c++) matrix_add(A, e + a, e + c, K[a][c]);
        }
    }
}

/* With t = 1 + x the load of the right node is (ln(t1/t0) - h/t1)/h: two
 * numbers that agree in all but O(h^2), so the difference is taken by a
 * function made for it, y -> ln(1+y) - y. */
void bvp_exact_load(int n, const double x[], double b[])
{
    for (int i = 0; i <= n; i++) b[i] = 0.0;
    for (int e = 0; e < n; e++) {
        const double h = x[e + 1] - x[e];
        b[e] -= gsl_sf_log_1plusx_mx(h / (1.0 + x[e])) / h;
        b[e + 1] -= gsl_sf_log_1plusx_mx(-h / (1.0 + x[e + 1])) / h;
    }
}

struct poisson_error poisson_errors(int n, const double x[], const double u[],
                                    field *beta, field *exact, field *exact_dx)
{
    struct poisson_error error = {0};
    gsl_integration_glfixed_table *gauss =
        gsl_integration_glfixed_table_alloc(5);

    for (int j = 0; j <= n; j++) {
        const double size = fabs(exact(x[j]) - u[j]);
        if (isnan(size) || size > error.nodal) error.nodal = size;
    }
    for (int e = 0; e < n; e++) {
        const double slope = (u[e + 1] - u[e]) / (x[e + 1] - x[e]); /* u_h' */
        for (size_t k = 0; k < 5; k++) {
            double point, w;
            gsl_integration_glfixed_point(x[e], x[e + 1], k, &point, &w, gauss);
            const double d = exact(point) - (u[e] + slope * (point - x[e]));
            const double d_dx = exact_dx(point) - slope;
            error.L2 += w * d * d; /* int (u - u_h)^2 */
            error.energy += w * beta(point) * d_dx * d_dx; /* int beta d'^2 */
        }
    }
    gsl_integration_glfixed_table_free(gauss);
    error.L2 = sqrt(error.L2);
    error.energy = sqrt(error.energy);
    return error;
}
