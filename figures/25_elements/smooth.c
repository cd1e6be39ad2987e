/*
 * smooth.c - do quadratic triangles keep their order near nu = 1/2 where u is
 * smooth, so that no corner can be the reason?
 *
 * The square (-1, 1)^2, held on its whole boundary, n x n squares, linear
 * elasticity.  u is the curl of ((1 - X1^2)(1 - X2^2))^2: it is 0 on the
 * boundary, div u = 0, and so it is the same for every nu, under the force
 * -mu Laplace u.  Table: the L2 norm of the error of the strain, relative, and
 * its order, even meshes.
 */
#include "base/study.h"
#include "base/table.h"
#include "plane/body.h"
#include "plane/quadratic.h"

#include <math.h>
#include <stdlib.h>

/* (1 - x^2)^2, differentiated d times. */
static double hump(double x, int d)
{
    const double of[4] = {(1.0 - x * x) * (1.0 - x * x),
                          4.0 * x * (x * x - 1.0), 12.0 * x * x - 4.0,
                          24.0 * x};
    return of[d];
}

/* u_1 = hump(X1) hump'(X2), u_2 = -hump'(X1) hump(X2), differentiated d1 times
 * along X1, d2 along X2. */
static double smooth(const double X[2], int i, int d1, int d2)
{
    return i ? -hump(X[0], d1 + 1) * hump(X[1], d2)
             : hump(X[0], d1) * hump(X[1], d2 + 1);
}

/* A point of a triangle: its nodes, their functions and gradients at the point,
 * where this is, and the area that it stands for. */
struct point {
    int node[QUADRATIC_NODES];
    double N[QUADRATIC_NODES], gradient[2 * QUADRATIC_NODES], X[2], size;
};

/* Six points per triangle, two for each corner, exact for degree 4 (Dunavant,
 * Int. J. Numer. Meth. Engng 21 (1985), p. 1140). */
enum { POINTS = 6 };
static struct point point(const struct mesh *mesh, int e, int k)
{
    const int outer = k >= 3;
    const double near = outer ? 0.091576213509771 : 0.445948490915965;
    const double part = outer ? 0.109951743655322 : 0.223381589678011;
    double l[3] = {near, near, near}, of_l[6];
    struct point p = {.X = {0.0, 0.0}};
    l[outer ? k - 3 : k] = 1.0 - 2.0 * near;
    quadratic_nodes(mesh, e, p.node);
    p.size = part * mesh_gradients_of(mesh, p.node, of_l);
    quadratic_shape(l, of_l, p.N, p.gradient);
    for (int a = 0; a < 3; a++)
        for (int j = 0; j < 2; j++)
            p.X[j] += l[a] * mesh->X[2 * p.node[a] + j];
    return p;
}

static double strain_squared(double H[2][2])
{
    const double shear = H[0][1] + H[1][0];
    return H[0][0] * H[0][0] + H[1][1] * H[1][1] + 0.5 * shear * shear;
}

/* Add the squares at a point: of the error of the strain, and of the strain. */
static void add_point(const struct point *p, const double u[], double *miss,
                      double *all)
{
    double H[2][2], G[2][2];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            G[i][j] = smooth(p->X, i, j == 0, j == 1);
            H[i][j] = -G[i][j];
            for (int a = 0; a < QUADRATIC_NODES; a++)
                H[i][j] += p->gradient[2 * a + j] * u[2 * p->node[a] + i];
        }
    *miss += p->size * strain_squared(H);
    *all += p->size * strain_squared(G);
}

/* f += the nodal forces of -mu Laplace u at a point. */
static void add_force(const struct point *p, double mu, double f[])
{
    for (int i = 0; i < 2; i++) {
        const double density =
            -mu * (smooth(p->X, i, 2, 0) + smooth(p->X, i, 0, 2));
        for (int a = 0; a < QUADRATIC_NODES; a++)
            f[2 * p->node[a] + i] += p->size * density * p->N[a];
    }
}

/* The norm of the error of the strain, over that of the strain. */
static double solve(int n, double nu)
{
    const struct material material = material_make(CUBIC, 1000.0, nu);
    struct mesh *mesh = mesh_square(2 * n);
    const size_t n_dof = 2 * (size_t)mesh->n_vertex;
    double *u = allocate(n_dof, sizeof *u), *q = allocate(n_dof, sizeof *q);
    double *f = allocate(n_dof, sizeof *f);
    double miss = 0.0, all = 0.0;
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = fabs(mesh->X[2 * a]) == 1.0 ||
                  fabs(mesh->X[2 * a + 1]) == 1.0;
    struct body *body = body_alloc_of(QUADRATIC_TRIANGLE, mesh, material, 0.0,
                                      CONSISTENT, held);
    body_store(body, SPARSE);
    for (int e = 0; e < body->n_element; e++)
        for (int k = 0; k < POINTS; k++) {
            const struct point p = point(mesh, e, k);
            add_force(&p, material.mu, f);
        }
    if (body_assemble(body, at_rest(f), u, EXACT, q) != OK ||
        body_increment(body, body->K, q, u) != OK)
        die("n = %d", n);
    for (int e = 0; e < body->n_element; e++)
        for (int k = 0; k < POINTS; k++) {
            const struct point p = point(mesh, e, k);
            add_point(&p, u, &miss, &all);
        }
    body_free(body);
    mesh_free(mesh);
    free(u), free(q), free(f), free(held);
    return sqrt(miss / all);
}

int main(void)
{
    static const double nu[] = {0.3, 0.4999};
    enum { MESHES = 5 };
    double order[2][MESHES];

    table_begin("smooth", "nu n strain order");
    for (int r = 0; r < 2; r++) {
        double before = NAN;
        for (int j = 0; j < MESHES; j++) {
            const double miss = solve(4 << j, nu[r]);
            order[r][j] = study_order(before, miss, 2.0);
            table_row(nu[r], 4 << j, cell_rounded(3, miss),
                      j > 0 ? cell_rounded(3, order[r][j])
                            : cell_word(MISSING));
            before = miss;
        }
    }
    table_end();
    claim(fabs(order[0][4] - 2.0) < 0.01,
          "nu = 0.3: the strain has the order two (%g)", order[0][4]);
    for (int j = 1; j < 4; j++)
        claim(order[1][j] > 1.06 && order[1][j] < 1.26, "nu = 0.4999, up to n "
              "= 32: about one power of h less, 1.07 to 1.25 (n = %d: %g)",
              4 << j, order[1][j]);
    claim(fabs(order[1][4] - 1.63) < 0.03,
          "from n = 32 to 64 the order comes back as far as 1.63 (%g)",
          order[1][4]);
    return table_finish();
}
