/* relax.c - see relax.h. */
#include "choice/relax.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS = 2 }; /* of a part */

static struct material law_of(const struct ladder_state *s)
{
    struct material material = s->body->material;
    if (s->model.rung <= LINEAR_PLANE) material.law = LINEAR;
    return material;
}

/* Where K and dP/dF are taken: at u, or of a linear model at rest. */
static int at_u(const struct ladder_state *s)
{
    return s->model.rung > LINEAR_PLANE;
}

mat2 relax_stress(const struct ladder_state *s, int e)
{
    const struct material law = law_of(s);
    return material2_pk1(&law, body_deformation(s->body, s->u, e));
}

void relax_push(const struct ladder_state *s, int e, mat2 T, double g[])
{
    const double area = s->body->area[e], *gradient = &s->body->gradient[6 * e];
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
            g[2 * s->body->vertex[3 * e + k] + i] +=
                area * (T.m[i][0] * gradient[2 * k] +
                        T.m[i][1] * gradient[2 * k + 1]);
}

struct matrix *relax_factors(const struct ladder_state *s)
{
    double *zero = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *zero);
    struct matrix *K = body_matrix(s->body);
    enum status status =
        body_stiffness(s->body, at_u(s) ? s->u : zero, EXACT, K);
    free(zero);
    if (status == OK) status = matrix_factor(K);
    if (status == OK) return K;
    matrix_free(K);
    return NULL;
}

/* d := K^-1 g, 0 at what is held. */
static void solve(const struct ladder_state *s, const struct matrix *factors,
                  const double g[], double d[])
{
    double *some = allocate((size_t)s->body->n_equation, sizeof *some);
    body_gather(s->body, g, some);
    matrix_solve(factors, some);
    body_scatter(s->body, some, d);
    free(some);
}

/* g := D w, 0 at what is held. */
static void product(const struct ladder_state *s, relax_forces *forces,
                    const double w[], double g[])
{
    const size_t triangles = (size_t)s->mesh->n_triangle;
    const struct material law = law_of(s);
    mat2 *H = allocate(triangles, sizeof *H);
    mat2 *P = allocate(triangles, sizeof *P);
    double *p = allocate(triangles, sizeof *p);
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = at_u(s) ? body_deformation(s->body, s->u, e)
                               : mat2_identity();
        H[e] = mat2_subtract(body_deformation(s->body, w, e), mat2_identity());
        P[e] = w == s->u ? relax_stress(s, e) : material2_dpk1(&law, F, H[e]);
        p[e] = s->scene->nu * mat2_trace(P[e]);
        P[e] = mat2_subtract(P[e], mat2_scale(p[e], mat2_identity()));
    }
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) g[r] = 0.0;
    forces(s, &(struct relax_field){H, P, p}, g);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++)
        if (s->body->equation[r] < 0) g[r] = 0.0;
    free(H);
    free(P);
    free(p);
}

static double dot(const struct ladder_state *s, const double a[],
                  const double b[])
{
    double sum = 0.0;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) sum += a[r] * b[r];
    return sum;
}

/* e := of (K - D) e = D w, w = u or any other. */
static int follow(const struct ladder_state *s, const struct matrix *factors,
                  relax_forces *forces, const double w[], int steps, double e[])
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    double *r = allocate(n, sizeof *r), *z = allocate(n, sizeof *z);
    double *p = allocate(n, sizeof *p), *Kp = allocate(n, sizeof *Kp);
    double *Dp = allocate(n, sizeof *Dp), first = 0.0, before = 1.0;
    int stands = 1;
    for (size_t i = 0; i < n; i++) e[i] = 0.0;
    product(s, forces, w, r);
    for (int k = 0; k < steps; k++) {
        solve(s, factors, r, z);
        const double rz = dot(s, r, z), beta = rz / before;
        if (k == 0) first = rz;
        stands = isfinite(rz);
        if (!stands || rz <= 1e-20 * first) break; /* solved, to round-off */
        for (size_t i = 0; i < n; i++) { /* K z = r, so K p goes with p */
            p[i] = z[i] + beta * p[i];
            Kp[i] = r[i] + beta * Kp[i];
        }
        product(s, forces, p, Dp);
        const double energy = dot(s, p, Kp) - dot(s, p, Dp);
        stands = energy > 0.0;
        if (!stands) break;
        for (size_t i = 0; i < n; i++) {
            e[i] += rz / energy * p[i];
            r[i] -= rz / energy * (Kp[i] - Dp[i]);
        }
        before = rz;
    }
    free(r);
    free(z);
    free(p);
    free(Kp);
    free(Dp);
    return stands;
}

int relax_follow(const struct ladder_state *s, const struct matrix *factors,
                 relax_forces *forces, int steps, double e[])
{
    return follow(s, factors, forces, s->u, steps, e);
}

double relax_yields(const struct ladder_state *s)
{
    double *z = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *z);
    struct matrix *K = relax_factors(s);
    if (K) solve(s, K, s->hand, z);
    const double yields = K ? dot(s, s->hand, z) : (double)NAN;
    matrix_free(K);
    free(z);
    return yields;
}

/* K w: int (P + p I) grad N. */
static void stiffness(const struct ladder_state *s,
                      const struct relax_field *of, double g[])
{
    for (int e = 0; e < s->mesh->n_triangle; e++)
        relax_push(s, e, mat2_add(of->P[e], mat2_scale(of->p[e],
                                                       mat2_identity())), g);
}

/* The forces of the strain H^T H / 2 that a linear law forgets. */
static void squares(const struct ladder_state *s, const struct relax_field *of,
                    double g[])
{
    const struct material *m = &s->body->material;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 HtH = mat2_multiply(mat2_transpose(of->H[e]), of->H[e]);
        const double p = 0.5 * m->lambda * mat2_trace(HtH);
        relax_push(s, e, mat2_scale(-1.0, mat2_add(
            mat2_scale(m->mu, HtH), mat2_scale(p, mat2_identity()))), g);
    }
}

/* What the forces change of the force in the hand; of a linear law, `squares`
 * at u + e besides [eq:left-hand]. */
static double hand_part(const struct ladder_state *s,
                        const struct matrix *factors, relax_forces *forces,
                        relax_forces *besides)
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    double *z = allocate(n, sizeof *z), *e = allocate(n, sizeof *e);
    double *g = allocate(n, sizeof *g), part = 1.0;
    solve(s, factors, s->hand, z);
    int stands = follow(s, factors, forces, z, STEPS, e);
    for (size_t r = 0; r < n; r++) z[r] += e[r];
    product(s, forces, s->u, g);
    double off = dot(s, z, g);
    if (besides && stands) {
        stands = relax_follow(s, factors, forces, STEPS, e);
        for (size_t r = 0; r < n; r++) e[r] += s->u[r];
        product(s, besides, e, g);
        off += dot(s, z, g);
    }
    const double whole = s->model.moving ? dot(s, s->hand, s->u) + off
                                         : dot(s, s->hand, z);
    if (stands) part = off != 0.0 ? fabs(off / whole) : 0.0;
    free(z);
    free(e);
    free(g);
    return part;
}

double relax_part(const struct ladder_state *s, const struct matrix *factors,
                  relax_forces *forces)
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    if (factors && s->scene->quantity == LADDER_HAND)
        return hand_part(s, factors, forces, NULL);
    double *e = allocate(n, sizeof *e), part = 1.0;
    if (factors && relax_follow(s, factors, forces, STEPS, e)) {
        const double off = ladder_measure(s, e);
        for (size_t r = 0; r < n; r++) e[r] += s->u[r];
        part = off > 0.0 ? off / ladder_measure(s, e) : 0.0;
    }
    free(e);
    return part;
}

/* How far the answer is off, for it is late [eq:left-phase]. */
static double late(const struct ladder_state *s, const struct matrix *factors,
                   relax_forces *mesh)
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    struct body heavy = *s->body;
    double *Kv = allocate(n, sizeof *Kv), *Mv = allocate(n, sizeof *Mv);
    double *Dv = allocate(n, sizeof *Dv), *d = allocate(n, sizeof *d);
    heavy.rho = 1.0;
    product(s, stiffness, s->v, Kv);
    product(s, mesh, s->v, Dv);
    solve(s, factors, Dv, d);
    body_mass(&heavy, s->v, Mv);
    const double kinetic = dot(s, s->v, Mv), speed = ladder_size(s, s->v);
    const double square = fmax(0.0, dot(s, s->v, Kv)) / kinetic;
    const double stiffer = ladder_size(s, d) / speed;
    free(Kv);
    free(Mv);
    free(Dv);
    free(d);
    if (!(kinetic > 0.0 && square > 0.0)) return 0.0;
    const double angle = sqrt(square) * s->t *
                         (0.5 * stiffer +
                          square * pow(ladder_step(s), 2) / 12.0);
    return speed / sqrt(square) * fmin(2.0, angle) / ladder_size(s, s->u);
}

double relax_mesh(const struct ladder_state *s, const struct matrix *factors,
                  relax_forces *mesh)
{
    double part = relax_part(s, factors, mesh);
    if (!s->model.moving || !factors) return part;
    part = hypot(part, late(s, factors, mesh));
    if (s->scene->quantity == LADDER_HAND) return part; /* alike in it */
    /* works are off by as much as u each, so that either may be the higher */
    if (s->rival > 1.0 - 2.0 * part)
        part = hypot(part, s->apart / ladder_size(s, s->u));
    return part;
}

double relax_inertia(const struct ladder_state *s, const struct matrix *factors)
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    double *Mu = ladder_momentum(s), *w = allocate(n, sizeof *w);
    solve(s, factors, Mu, w);
    const double moves = dot(s, Mu, w), size = dot(s, Mu, s->u);
    free(Mu);
    free(w);
    if (!(size > 0.0)) return 1.0;
    return fmin(1.0, sqrt(moves / size) / s->scene->T);
}

/* Where the body is pressed along its axis by P < P_cr, P / P_cr of what bends:
 * of `dimension` without what a held end keeps wide [eq:left-dimension].  For
 * more no beam has a share to name, and ladder_stable() must tell. */
static double pressed(const struct ladder_state *s, double dimension)
{
    const struct material *m = &s->body->material;
    const double lateral = m->lambda / (2.0 * m->mu + m->lambda);
    const double missed = lateral * lateral / (2.0 * s->scene->slender);
    double N = 0.0;
    if (s->scene->held == LADDER_ENDS) return 0.0;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r += 2) N += s->f[r];
    const double share = -N / ladder_buckles(s->scene);
    if (!(share > 0.0 && share < 1.0)) return 0.0;
    return share * fmax(0.0, (dimension - missed) / (1.0 - missed));
}

void relax_parts(const struct ladder_state *s, relax_forces *mesh,
                 relax_forces *stress, double part[N_PART])
{
    struct matrix *K = relax_factors(s);
    part[MESH] = relax_mesh(s, K, mesh);
    part[STRESS] = relax_part(s, K, stress);
    const int hand = s->scene->quantity == LADDER_HAND;
    if (s->model.rung == LINEAR_PLANE && hand && K)
        part[STRESS] = hand_part(s, K, stress, squares);
    else if (s->model.rung == LINEAR_PLANE && !hand)
        part[STRESS] = fmax(part[STRESS], pressed(s, part[DIMENSION]));
    if (K && s->model.rung != BAR && !s->model.moving &&
        s->scene->time != STANDS)
        part[INERTIA] = fmax(part[INERTIA], relax_inertia(s, K));
    matrix_free(K);
}
