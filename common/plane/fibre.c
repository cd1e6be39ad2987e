/* fibre.c - see fibre.h. */
#include "plane/fibre.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

struct fibre fibre_muscle(double activation)
{
    return (struct fibre){MUSCLE, 200.0, 300.0, 0.5, activation};
}

struct tension fibre_tension(const struct fibre *fibre, double l)
{
    const double k = fibre->k, w = fibre->width, e = l - 1.0;
    const double active = fibre->activation * fibre->sigma;
    if (fibre->law == CORD)
        return (struct tension){0.5 * k * e * e + active * e, k * e + active,
                                k};
    const double taut = GSL_MAX_DBL(e, 0.0);
    const double x = GSL_MAX_DBL(-w, GSL_MIN_DBL(e, w)) / w; /* in [-1, 1] */
    struct tension t = {k * taut * taut * taut / 3.0, k * taut * taut,
                        2.0 * k * taut};
    /* active part: beyond the limbs x = -1 or 1, so T = 0, W constant */
    t.W += active * w * (x - x * x * x / 3.0);
    t.T += active * (1.0 - x * x);
    if (fabs(e) < w) t.dT -= active * 2.0 * x / w;
    return t;
}

/* Return the stretch of F g; n := its direction, 0 if it has none. */
static double stretch(const double g[2], mat2 F, double n[2])
{
    for (int i = 0; i < 2; i++) n[i] = F.m[i][0] * g[0] + F.m[i][1] * g[1];
    const double l = hypot(n[0], n[1]);
    if (l > 0.0)
        for (int i = 0; i < 2; i++) n[i] /= l;
    return l;
}

mat2 fibre_pk1(const struct fibre *fibre, const double g[2], mat2 F)
{
    double n[2];
    const double T = fibre_tension(fibre, stretch(g, F, n)).T;
    return (mat2){{{T * n[0] * g[0], T * n[0] * g[1]},
                   {T * n[1] * g[0], T * n[1] * g[1]}}};
}

/* B := T' n n^T + T/l (I - n n^T), the two factors clamped at 0 or not. */
static mat2 stiffness(const struct fibre *fibre, double l, const double n[2],
                      enum tangent tangent)
{
    const struct tension t = fibre_tension(fibre, l);
    double along = t.dT, transverse = l > 0.0 ? t.T / l : 0.0;
    if (l <= 0.0) along = 0.0;
    if (tangent == PROJECTED) {
        along = GSL_MAX_DBL(along, 0.0);
        transverse = GSL_MAX_DBL(transverse, 0.0);
    }
    const double excess = along - transverse; /* B = T/l I + (T' - T/l) n n^T */
    return (mat2){{{transverse + excess * n[0] * n[0], excess * n[0] * n[1]},
                   {excess * n[1] * n[0], transverse + excess * n[1] * n[1]}}};
}

mat2 fibre_dpk1(const struct fibre *fibre, const double g[2], mat2 F, mat2 dF,
                enum tangent tangent)
{
    double n[2];
    const double l = stretch(g, F, n);
    const mat2 gg = {{{g[0] * g[0], g[0] * g[1]}, {g[1] * g[0], g[1] * g[1]}}};
    /* dP = B dF g g^T */
    return mat2_multiply(stiffness(fibre, l, n, tangent),
                         mat2_multiply(dF, gg));
}

/* Add scale s_a s_b B to block (a, b) of K, where t[a] and t[b] are free. */
static void add_stiffness(const struct body *body, const int t[3],
                          double scale, const double s[3], mat2 B)
{
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            const int *rows = &body->equation[2 * t[a]];
            const int *columns = &body->equation[2 * t[b]];
            if (rows[0] < 0 || columns[0] < 0) continue;
            for (int i = 0; i < 2; i++)
                for (int k = 0; k < 2; k++)
                    matrix_add(body->K, rows[i], columns[k],
                               scale * s[a] * s[b] * B.m[i][k]);
        }
}

/* Add for triangle e with s_a = g . grad N_a area T s_a n to the force of
 * vertex a and area s_a s_b B to block (a, b) of K, B of stiffness(). */
static void add(const struct body *body, double dt, const double u[],
                enum tangent tangent, double *energy, double q[])
{
    const struct fibres *fibres = body->added;
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const double g[2] = {cos(fibres->angle[e]), sin(fibres->angle[e])};
        const double *G = &body->gradient[6 * e], area = body->area[e];
        const int *t = &body->vertex[3 * e];
        double n[2];
        const double l = stretch(g, body_deformation(body, u, e), n);
        const struct tension pull = fibre_tension(&fibres->fibre, l);
        if (energy) {
            *energy += area * pull.W;
            continue;
        }
        double s[3];
        for (int a = 0; a < 3; a++) {
            /* P grad N_a = T s_a n */
            s[a] = g[0] * G[2 * a] + g[1] * G[2 * a + 1];
            for (int i = 0; i < 2; i++)
                q[2 * t[a] + i] += dt * dt * area * s[a] * pull.T * n[i];
        }
        if (tangent == NO_TANGENT) continue;
        const mat2 B = stiffness(&fibres->fibre, l, n, tangent);
        add_stiffness(body, t, dt * dt * area, s, B);
    }
}

double *fibres_bent(const struct mesh *mesh, double tilt, double bend)
{
    double *angle = allocate((size_t)mesh->n_triangle, sizeof *angle);
    for (int r = 0; r < 3 * mesh->n_triangle; r++)
        /* the mean of the three vertices is the value at the centre */
        angle[r / 3] += (tilt + bend * mesh->X[2 * mesh->triangle[r]]) / 3.0 *
                        (M_PI / 180.0);
    return angle;
}

void fibres_attach(struct body *body, const struct fibres *fibres)
{
    body->add = add;
    body->added = fibres;
}

double fibres_stretch(const struct body *body, const struct fibres *fibres,
                      const double u[], int e, double *angle)
{
    const double g[2] = {cos(fibres->angle[e]), sin(fibres->angle[e])};
    double n[2];
    const double l = stretch(g, body_deformation(body, u, e), n);
    if (angle) *angle = atan2(n[1], n[0]);
    return l;
}
