/*
 * order_in_space.c - how fast do displacement and gradient converge under
 * refinement, and with which constant?
 *
 * One step of backward Euler from rest under a force that was made for a given
 * u, smooth and 0 on the boundary [eq:manufactured]; cubic law.  Table: L2
 * norms of the errors of u, of its gradient, and of the interpolant's gradient.
 */
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>

/* Component i of a smooth u, u_1 = 0.1 sin(pi X1) cos(pi X2 / 2), u_2 the same
 * with X1 and X2 exchanged, differentiated d1 times along X1, d2 along X2. */
static double smooth(const double X[2], int i, int d1, int d2)
{
    const int fast = i ? d2 : d1, slow = i ? d1 : d2;
    return 0.1 * gsl_pow_int(M_PI, fast) * sin(M_PI * X[i] + fast * M_PI_2) *
           gsl_pow_int(M_PI_2, slow) * cos(M_PI_2 * (X[1 - i] + slow));
}

/* du_i / dX_k, differentiated d1 times along X1, d2 along X2. */
static mat2 gradient(const double X[2], int d1, int d2)
{
    mat2 H;
    for (int i = 0; i < 2; i++) {
        H.m[i][0] = smooth(X, i, d1 + 1, d2);
        H.m[i][1] = smooth(X, i, d1, d2 + 1);
    }
    return H;
}

/* The force density rho u / dt^2 - div P, div P_i = dP_ij / dX_j, rho = 1. */
static double density(const struct material *law, double dt, const double X[2],
                      int i)
{
    const mat2 F = mat2_add(mat2_identity(), gradient(X, 0, 0));
    double f = smooth(X, i, 0, 0) / (dt * dt);
    for (int j = 0; j < 2; j++)
        f -= material2_dpk1(law, F, gradient(X, j == 0, j == 1)).m[i][j];
    return f;
}

/* Add the squares of the errors of u_h and of its gradient at the point of
 * triangle e with the barycentric coordinates N, which stands for `size`. */
static void add_point(const struct body *body, const double u[], int e,
                      const double N[3], double size, double *L2, double *H1)
{
    const int *t = &body->vertex[3 * e];
    const double *g = &body->gradient[6 * e];
    double X[2] = {0.0, 0.0}, value[2] = {0.0, 0.0};
    mat2 H = {{{0.0, 0.0}, {0.0, 0.0}}};

    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++) {
            const double u_ai = u[2 * t[a] + i];
            X[i] += N[a] * body->mesh->X[2 * t[a] + i];
            value[i] += N[a] * u_ai;
            for (int m = 0; m < 2; m++) H.m[i][m] += u_ai * g[2 * a + m];
        }
    const mat2 miss = mat2_subtract(H, gradient(X, 0, 0));
    *H1 += size * mat2_dot(miss, miss);
    *L2 += size * (gsl_pow_2(value[0] - smooth(X, 0, 0, 0)) +
                   gsl_pow_2(value[1] - smooth(X, 1, 0, 0)));
}

/* L2 norms of u_h - u and of its gradient, by six points per triangle, two for
 * each corner, exact for degree 4 (Dunavant, Int. J. Numer. Meth. Engng 21
 * (1985), p. 1140). */
static void smooth_error(const struct body *body, const double u[], double *L2,
                         double *H1)
{
    const double near[2] = {0.445948490915965, 0.091576213509771};
    const double part[2] = {0.223381589678011, 0.109951743655322};

    *L2 = *H1 = 0.0;
    for (int e = 0; e < body->mesh->n_triangle; e++)
        for (int k = 0; k < 2; k++)
            for (int corner = 0; corner < 3; corner++) {
                double N[3] = {near[k], near[k], near[k]};
                N[corner] = 1.0 - 2.0 * near[k];
                add_point(body, u, e, N, part[k] * body->area[e], L2, H1);
            }
    *L2 = sqrt(*L2);
    *H1 = sqrt(*H1);
}

/* The errors of the solution and of the interpolant: {L2, gradient}. */
static void solve(int n, double error[2], double closest[2])
{
    const struct step_control control = step_method("notes");
    const struct scene_setting set = scene_notes(SPIN, CUBIC, n);
    struct scene *s = scene_alloc(&set);

    for (int a = 0; a < s->mesh->n_vertex; a++) {
        const double *X = &s->mesh->X[2 * a];
        if (fabs(X[0]) == 1.0 || fabs(X[1]) == 1.0) s->held[a] = 1;
        for (int i = 0; i < 2; i++)
            s->v[2 * a + i] = density(&s->body->material, set.dt, X, i);
    }
    body_mass(s->body, s->v, s->f); /* int of the interpolated density N_a */
    body_free(s->body);
    s->body =
        body_alloc(s->mesh, material_notes(CUBIC), 1.0, CONSISTENT, s->held);
    const struct incremental Phi = {set.dt, s->g, s->f};
    if (step_solve(s->body, &control, Phi, s->u).status != OK)
        die("the smooth step fails");
    smooth_error(s->body, s->u, &error[0], &error[1]);
    for (int a = 0; a < s->mesh->n_vertex; a++)
        for (int i = 0; i < 2; i++)
            s->u[2 * a + i] = smooth(&s->mesh->X[2 * a], i, 0, 0);
    smooth_error(s->body, s->u, &closest[0], &closest[1]);
    scene_free(s);
}

int main(void)
{
    double error[2], closest[2], before[2] = {0.0}, order[2] = {0.0}, part = 0;

    table_begin("orders_space", "n h L2 order_L2 constant_L2 gradient "
                                "order_gradient interpolation");
    for (int n = 4; n <= 32; n *= 2) {
        const double h = 2.0 / n;
        solve(n, error, closest);
        for (int k = 0; k < 2; k++) {
            order[k] = study_order(before[k], error[k], 2.0);
            before[k] = error[k];
        }
        part = error[1] / closest[1];
        table_row(n, h, error[0], cell_if(n > 4, order[0]), error[0] / (h * h),
                  error[1], cell_if(n > 4, order[1]), closest[1]);
    }
    table_end();

    claim(fabs(order[0] - 2.0) < 0.03 && fabs(order[1] - 1.0) < 0.01, "order "
          "two for u (%g), one for its gradient (%g)", order[0], order[1]);
    claim(part < 1.001, "the gradient is as good as the interpolant's, to one "
          "part in a thousand (its error is %g times that one)", part);
    return table_finish();
}
