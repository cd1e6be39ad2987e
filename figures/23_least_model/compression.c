/* compression.c - see compression.h. */
#include "compression.h"

#include <math.h>
#include <stdlib.h>

/* On a square ||omega - its mean|| <= k ||e||: k^2 = 1 / sin(pi/8)^2 - 1/2. */
static const double k_squared = 3.5 + 2.0 * 1.4142135623730951;

/* a, b, c of a triangle [eq:compression], with the weight t > q + n of Young's
 * inequality; false: G'' < 0, or F is too far from the identity. */
static int coefficients(const struct material *m, mat2 F, double more,
                        double *a, double *b, double *c)
{
    const double f11 = F.m[0][0], f22 = F.m[1][1], half = 0.5 * (f11 + f22);
    const struct volume G = material_volume(m, mat2_det(F));
    const double delta = -m->mu - G.dG;
    const double q = 0.5 * hypot(f11 - f22, F.m[0][1] + F.m[1][0]);
    const double n = fabs(F.m[1][0] - F.m[0][1]);
    const double t = q + n + more, mixed = t > 0.0 ? (q + n) / t - q - n : 0.0;
    *a = m->mu + 0.5 * delta - G.ddG * mixed * q;
    *b = G.ddG * (1.0 - t) * half * half - 0.5 * delta;
    *c = 2.0 * delta + G.ddG * mixed * n;
    return G.ddG >= 0.0 && t < 1.0;
}

/* The largest ||omega||^2 on the first squares of the rectangle, as many as
 * this, over int a dev^2 + b tr^2. */
static double rotation(double a, double b, double squares)
{
    const double bending = 4.0 * a * b / (a + b), pi = 2.0 * acos(0.0);
    const double least = fmin(a, b);
    const double beam = 48.0 * squares * squares / (pi * pi * bending);
    return k_squared / (2.0 * least) +
           pow(sqrt(beam + 0.3 / a) + sqrt(k_squared / (10.0 * least)), 2.0);
}

/* The square of the rectangle that a triangle lies in, from the held end. */
static int square_of(const struct ladder_state *s, int e)
{
    double x = 0.0; /* of its middle, from -1 to 1 */
    for (int a = 0; a < 3; a++)
        x += s->mesh->X[2 * s->mesh->triangle[3 * e + a]] / 3.0;
    return (int)(0.5 * (x + 1.0) * s->scene->slender);
}

/* The bound with one choice of t; c: [slender], the largest of each square. */
static int certifies(const struct ladder_state *s, double more, double c[])
{
    const int squares = (int)s->scene->slender;
    double a = INFINITY, b = INFINITY, turned = 0.0;
    for (int k = 0; k < squares; k++) c[k] = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, s->u, e);
        const int k = square_of(s, e);
        double here[3];
        if (!material_defined(&s->body->material, mat2_det(F)) ||
            !coefficients(&s->body->material, F, more, &here[0], &here[1],
                          &here[2]))
            return 0;
        a = fmin(a, here[0]);
        b = fmin(b, here[1]);
        c[k] = fmax(c[k], here[2]);
    }
    if (!(a > 0.0 && b > 0.0)) return 0;
    for (int k = squares - 1; k >= 0; k--) { /* sums over the first squares */
        const double beyond = k + 1 < squares ? c[k + 1] : 0.0;
        c[k] = fmax(c[k], beyond);
        turned += (c[k] - beyond) * rotation(a, b, k + 1.0);
    }
    return turned < 1.0;
}

int compression_certifies(const struct ladder_state *s, double *flops)
{
    static const double more[] = {0.0, 0.02, 0.06, 0.18};
    enum { TRIES = sizeof more / sizeof *more };
    const int differ = s->model.rung == BAR ? 2 * s->mesh->n
                                            : s->mesh->n_triangle;
    int certified = 0;
    *flops = 0.0;
    if (s->scene->slender < 1.0 || fmod(s->scene->slender, 1.0) > 0.0) return 0;
    double *c = allocate((size_t)s->scene->slender, sizeof *c);
    for (int i = 0; i < TRIES && !certified; i++) {
        certified = certifies(s, more[i], c);
        *flops += 60.0 * differ;
    }
    free(c);
    return certified;
}

double compression_cholesky(const struct ladder_state *s)
{
    if (s->model.moving) return 0.0;
    return matrix_cost(BANDED, s->body->n_equation, s->body->K->p).flops +
           250.0 * s->mesh->n_triangle;
}
