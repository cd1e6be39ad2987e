/* relax.c - see relax.h. */
#include "choice/relax.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 2 }; /* of a part */

static struct material law_of(const struct ladder_state *s)
{
    struct material material = s->body->material;
    if (s->model.rung <= LINEAR_PLANE) material.law = LINEAR;
    return material;
}

/* Return whether K and dP/dF are taken at u; those of a linear model are at
 * rest. */
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
    for (int k = 0; k < 3; k++) /* grad N_k is constant in e */
        for (int i = 0; i < 2; i++)
            g[2 * s->body->vertex[3 * e + k] + i] +=
                area * (T.m[i][0] * gradient[2 * k] +
                        T.m[i][1] * gradient[2 * k + 1]);
}

static struct matrix *factors_at(const struct ladder_state *s, const double u[])
{
    struct matrix *K = body_matrix(s->body);
    enum status status = body_stiffness(s->body, u, EXACT, K);
    if (status == OK) status = matrix_factor(K);
    if (status == OK) return K;
    matrix_free(K);
    return NULL;
}

static struct matrix *factors_at_rest(const struct ladder_state *s)
{
    double *zero = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *zero);
    struct matrix *K = factors_at(s, zero);
    free(zero);
    return K;
}

struct matrix *relax_factors(const struct ladder_state *s)
{
    return at_u(s) ? factors_at(s, s->u) : factors_at_rest(s);
}

/* d := K^-1 g, 0 at held vertices. */
static void solve(const struct ladder_state *s, const struct matrix *factors,
                  const double g[], double d[])
{
    double *some = allocate((size_t)s->body->n_equation, sizeof *some);
    body_gather(s->body, g, some);
    matrix_solve(factors, some);
    body_scatter(s->body, some, d);
    free(some);
}

/* g := D w, 0 at held vertices. */
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
        /* H = grad w; P + p I = dP/dF : H, or P(u) where w = u */
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

/* e := of (K - D) e = r, of which what remains is left; forces NULL: D = 0. */
static int follow(const struct ladder_state *s, const struct matrix *factors,
                  relax_forces *forces, int steps, double r[], double e[])
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    double *z = allocate(n, sizeof *z);
    double *p = allocate(n, sizeof *p), *Kp = allocate(n, sizeof *Kp);
    double *Dp = allocate(n, sizeof *Dp), first = 0.0, before = 1.0;
    int stands = 1;
    for (size_t i = 0; i < n; i++) e[i] = 0.0;
    for (int k = 0; k < steps; k++) {
        solve(s, factors, r, z);
        const double rz = dot(s, r, z), beta = rz / before; /* p = 0 at k = 0 */
        if (k == 0) first = rz;
        stands = isfinite(rz);
        if (!stands || rz <= 1e-20 * first) break; /* solved, to round-off */
        for (size_t i = 0; i < n; i++) { /* K z = r, so K p goes with p */
            p[i] = z[i] + beta * p[i];
            Kp[i] = r[i] + beta * Kp[i];
        }
        if (forces) product(s, forces, p, Dp);
        const double energy = dot(s, p, Kp) - dot(s, p, Dp); /* p.(K - D) p */
        stands = energy > 0.0;
        if (!stands) break;
        for (size_t i = 0; i < n; i++) {
            e[i] += rz / energy * p[i]; /* alpha = r.z / p.(K - D) p */
            r[i] -= rz / energy * (Kp[i] - Dp[i]);
        }
        before = rz;
    }
    free(z);
    free(p);
    free(Kp);
    free(Dp);
    return stands;
}

int relax_follow(const struct ladder_state *s, const struct matrix *factors,
                 relax_forces *forces, int steps, double e[])
{
    double *r = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *r);
    product(s, forces, s->u, r); /* r = D u */
    const int stands = follow(s, factors, forces, steps, r, e);
    free(r);
    return stands;
}

/* Return hand.K^-1 hand (J): what a hand of the full force would move by
 * itself, times that; NAN where there are no factors. */
static double plane_yields(const struct ladder_state *s)
{
    double *z = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *z);
    struct matrix *K = relax_factors(s);
    if (K) solve(s, K, s->hand, z);
    const double yields = K ? dot(s, s->hand, z) : (double)NAN;
    matrix_free(K);
    free(z);
    return yields;
}

double ladder_error(const struct ladder_state *s,
                    const struct ladder_state *truth)
{
    const int hand = truth->scene->quantity == LADDER_HAND;
    return ladder_apart(s, truth) / (hand && !truth->model.moving
                                         ? plane_yields(truth)
                                         : ladder_measure(truth, truth->u));
}

/* K w: int (P + p I) grad N. */
static void stiffness(const struct ladder_state *s,
                      const struct relax_field *field, double g[])
{
    for (int e = 0; e < s->mesh->n_triangle; e++)
        relax_push(s, e, mat2_add(field->P[e], mat2_scale(field->p[e],
                                                       mat2_identity())), g);
}

/* Return |e| over |w + e| for (K - D) e = g; of the force in the hand |z.g| for
 * (K - D) z = hand, over hand.z, or over hand.w + z.g in motion
 * [eq:left-hand].  1: it gives way. */
static double lacks(const struct ladder_state *s, const struct matrix *factors,
                    relax_forces *forces, const double w[], double g[])
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    const int hand = s->scene->quantity == LADDER_HAND;
    double *e = allocate(n, sizeof *e), *r = allocate(n, sizeof *r);
    memcpy(r, hand ? s->hand : g, n * sizeof *r);
    for (size_t k = 0; k < n; k++)
        if (s->body->equation[k] < 0) r[k] = 0.0; /* held */
    double part = 1.0, off, whole;
    if (follow(s, factors, forces, hand ? STEPS + 1 : STEPS, r, e)) {
        if (hand) {
            /* e is z: z.g over hand.w + z.g, or over hand.z */
            off = dot(s, e, g);
            whole = s->model.moving ? dot(s, s->hand, w) + off
                                    : dot(s, s->hand, e);
        } else {
            off = ladder_measure(s, e);
            for (size_t k = 0; k < n; k++) e[k] += w[k];
            whole = ladder_measure(s, e); /* |w + e| */
        }
        part = off != 0.0 ? fabs(off / whole) : 0.0; /* not 0 / 0 */
    }
    free(e);
    free(r);
    return part;
}

double relax_part(const struct ladder_state *s, const struct matrix *factors,
                  relax_forces *forces)
{
    double *g = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *g), part = 1.0;
    if (factors) {
        product(s, forces, s->u, g);
        part = lacks(s, factors, forces, s->u, g);
    }
    free(g);
    return part;
}

/* g += int (P_a - P_b) grad N of two laws at w, 0 where held.  false: b is
 * the logarithm, of which J says nothing there. */
static int push_laws(const struct ladder_state *s, enum law a, enum law b,
                     const double w[], double g[])
{
    struct material material[2] = {s->body->material, s->body->material};
    material[0].law = a;
    material[1].law = b;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, w, e);
        const double J = mat2_det(F);
        if (b == LOG && !(J > 0.0 && J <= RELAX_SERIES)) return 0;
        relax_push(s, e, mat2_subtract(material2_pk1(&material[0], F),
                                       material2_pk1(&material[1], F)), g);
    }
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++)
        if (s->body->equation[r] < 0) g[r] = 0.0;
    return 1;
}

double relax_law(const struct ladder_state *s, const struct matrix *factors)
{
    double *g = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *g), part = 1.0;
    if (factors && push_laws(s, CUBIC, LOG, s->u, g))
        part = lacks(s, factors, NULL, s->u, g);
    free(g);
    return part;
}

double relax_geometry(const struct ladder_state *s,
                      const struct matrix *factors, relax_forces *stress,
                      double *together)
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    double *w = allocate(n, sizeof *w), *g = allocate(n, sizeof *g);
    double *all = allocate(n, sizeof *all), part = 1.0;
    *together = 1.0;
    if (factors && relax_follow(s, factors, stress, STEPS, w)) {
        for (size_t r = 0; r < n; r++) w[r] += s->u[r]; /* w = u + e */
        product(s, stress, w, g);
        for (size_t r = 0; r < n; r++) g[r] = -g[r];
        push_laws(s, LINEAR, CUBIC, w, g); /* g = N(w) - D w */
        product(s, stress, s->u, all);
        for (size_t r = 0; r < n; r++) all[r] += g[r]; /* D u + g */
        part = lacks(s, factors, stress, w, g);
        *together = lacks(s, factors, stress, s->u, all);
    }
    free(w);
    free(g);
    free(all);
    return part;
}

/* Return how far the answer is off, for it is late [eq:left-phase]. */
static double late(const struct ladder_state *s, const struct matrix *factors,
                   relax_forces *mesh)
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    double *Kv = allocate(n, sizeof *Kv), *Mv = ladder_mass(s, s->v);
    double *Dv = allocate(n, sizeof *Dv), *d = allocate(n, sizeof *d);
    product(s, stiffness, s->v, Kv);
    product(s, mesh, s->v, Dv);
    solve(s, factors, Dv, d);
    /* omega^2 = v.K v / v.M v; stiffer = |K^-1 D v| / |v| */
    const double kinetic = dot(s, s->v, Mv), speed = ladder_size(s, s->v);
    const double square = fmax(0.0, dot(s, s->v, Kv)) / kinetic;
    const double stiffer = ladder_size(s, d) / speed;
    free(Kv);
    free(Mv);
    free(Dv);
    free(d);
    if (!(kinetic > 0.0 && square > 0.0)) return 0.0;
    /* omega t (stiffer / 2 + (omega dt)^2 / 12) */
    const double angle = sqrt(square) * s->t *
                         (0.5 * stiffer +
                          square * pow(ladder_step(s), 2) / 12.0);
    /* the amplitude |v| / omega times the angle, over |u| */
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
    if (s->rival > 1.0 - 0.5 * part)
        part = hypot(part, s->apart / ladder_size(s, s->u));
    return part;
}

/* Return the root of w.M K^-1 M w, w = K^-1 f, the rate at which u would follow
 * the load: each mode swings by that, over its frequency and T. */
static double swing(const struct ladder_state *s, const struct matrix *K)
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    double *w = allocate(n, sizeof *w);
    solve(s, K, s->f, w);
    double *Mw = ladder_mass(s, w);
    solve(s, K, Mw, w); /* w is now K^-1 M w */
    const double square = dot(s, Mw, w);
    free(w);
    free(Mw);
    return sqrt(square);
}

/*
 * Return the part that swings about rest [eq:left-slowest], <= 1; 1 for u = 0.
 * Let w = K^-1 f be the rate at which u follows: a load that begins to rise in
 * T, and one that ceases to, makes each mode swing by its part of w over its
 * omega T, of which A = |w|_(M K^-1 M) / |u|_M / T is the root mean square. A_0
 * is that of K at u = 0, and A of K at u: of one mode that is pressed by p of
 * its buckling load, r / (1 - p) with r = 1 / (omega T).  As nobody knows the
 * phases, u goes beyond rest by h = hypot(A_0, A), and the part is h / (1 + h);
 * of a load that swings it is (A_0 + A^2) / (1 + A_0).
 */
static double swings(const struct ladder_state *s, const struct matrix *factors)
{
    double *Mu = ladder_momentum(s);
    const double size = sqrt(dot(s, Mu, s->u)) * s->scene->T; /* |u|_M T */
    free(Mu);
    if (!(size > 0.0)) return 1.0;
    const double at_end = swing(s, factors) / size;
    double begins = at_end; /* A_0 = A where K is that of rest */
    if (at_u(s)) {
        struct matrix *K = factors_at_rest(s);
        begins = swing(s, K) / size; /* A_0 */
        matrix_free(K);
    }
    const double both = hypot(begins, at_end);
    if (s->scene->time == RISES) return both / (1.0 + both);
    return fmin(1.0, (begins + at_end * at_end) / (1.0 + begins));
}

/* Add up the axial force and the moment of the nodal forces f beyond each
 * section. */
static void sections(const struct ladder_state *s, const double f[], double N[],
                     double M[])
{
    const int n = s->mesh->n;
    double sideways = 0.0;
    for (int i = n; i >= 0; i--) {
        N[i] = i < n ? N[i + 1] : 0.0;
        /* M_i = M_i+1 + Q h - sum Y f_x, h = 2 / n, Q all f_y beyond */
        M[i] = i < n ? M[i + 1] + sideways * 2.0 / n : 0.0;
        for (int j = 0; j <= s->mesh->rows; j++) {
            const int a = 2 * (j * (n + 1) + i);
            N[i] += f[a];
            M[i] -= s->mesh->X[a + 1] * f[a];
            sideways += f[a + 1]; /* after M_i: f_y here has no lever */
        }
    }
}

/* Return hand.K^-1 hand of a bar (J). */
static double yields(const struct ladder_state *s)
{
    const size_t n = (size_t)s->mesh->n;
    const double height = 2.0 / s->scene->slender;
    double *N = allocate(n + 1, sizeof *N), *M = allocate(n + 1, sizeof *M);
    double sum = 0.0;
    sections(s, s->hand, N, M);
    for (size_t i = 1; i <= n; i++)
        /* int N^2 / height + M^2 / I, I = height^3 / 12; E' comes last */
        sum += 2.0 / s->mesh->n * (N[i] * N[i] / height +
                                   12.0 * M[i] * M[i] / pow(height, 3));
    free(N);
    free(M);
    return sum / ladder_modulus(&s->body->material);
}

double relax_dimension(const struct ladder_state *s)
{
    const struct material *m = &s->body->material;
    const size_t n = (size_t)s->mesh->n;
    const double lateral = ladder_narrows(m), missed = 0.5 * lateral * lateral;
    const double height = 2.0 / s->scene->slender, step = 2.0 / s->mesh->n;
    double *N = allocate(n + 1, sizeof *N), *M = allocate(n + 1, sizeof *M);
    double *force = allocate(n + 1, sizeof *force), off, whole;
    double *moment = allocate(n + 1, sizeof *moment);
    double turn = 0.0, w = 0.0, u = 0.0, sideways = 0.0, along = 0.0;
    double bent = 0.0, pulled = 0.0, both = 0.0, shorter = 0.0;
    sections(s, s->f, N, M);
    sections(s, s->hand, force, moment);
    const double I = pow(height, 3) / 12.0;
    const double E = ladder_modulus(m), shear = 1.2 * E / (m->mu * height);
    const double gain = 1.0 / (1.0 - ladder_pressed(s->scene));
    /* From the held end on, times E': w'' = M / I, and the shear force M' adds
     * 1.2 E' M' / (mu height) to w' (Timoshenko and Gere, 2.17); u' is N over
     * height, an edge goes along by height w' / 2.  By virtual work a hand that
     * bends by m moves by int m M / I + 1.2 E' m' M' / (mu height), of itself
     * by that with m for M; a bend shortens the axis by int w'^2 / 2. */
    for (size_t i = 0; i < n; i++) {
        const double middle = 0.5 * (M[i] + M[i + 1]);
        const double mean = 0.5 * (moment[i] + moment[i + 1]);
        /* the shear forces, times the step */
        const double Q = M[i] - M[i + 1], q = moment[i] - moment[i + 1];
        /* w + step w' + step^2 w'' / 2, M constant in an element; and shear */
        w += step * (turn + 0.5 * step * middle / I) + shear * Q;
        turn += step * middle / I;
        u += step * N[i + 1] / height;
        sideways = fmax(sideways, hypot(w, 0.5 * height * turn));
        along = fmax(along, fabs(u));
        both += step * mean * middle / I + shear * q * Q / step;
        bent += step * mean * mean / I + shear * q * q / step;
        pulled += step * pow(force[i + 1], 2) / height;
        /* E' int |force| w'^2 / 2, for turn is E' w' */
        shorter += step * 0.5 * fabs(force[i + 1]) * pow(gain * turn, 2) / E;
    }
    if (s->scene->quantity == LADDER_HAND) {
        /* as relax.h has it: its m is moment, n force, s lateral here */
        off = gain * fabs(both) + missed * fabs(force[0] * N[0]) + shorter;
        whole = bent + pulled;
    } else {
        off = gain * sideways + missed * fabs(N[0]);
        whole = gain * sideways + along;
    }
    free(N);
    free(M);
    free(force);
    free(moment);
    return gain > 0.0 && whole > 0.0 ? fmin(1.0, off / whole) : 1.0;
}

/* Return P / P_cr of the bending part where P < P_cr presses the body along: of
 * `dimension` without what a held end keeps wide [eq:left-dimension].  For more
 * there is nothing that it is near to: 1. */
static double pressed(const struct ladder_state *s, double dimension)
{
    const double bends = fmax(dimension, relax_dimension(s));
    const double lateral = ladder_narrows(&s->body->material);
    const double missed = lateral * lateral / (2.0 * s->scene->slender);
    const double share = ladder_pressed(s->scene);
    if (share >= 1.0) return 1.0;
    if (!(share > 0.0) || ladder_symmetric(s->scene)) return 0.0;
    /* bends = x + missed (1 - x), x the part that bends: solved for x */
    return share * fmax(0.0, (bends - missed) / (1.0 - missed));
}

/* Estimate geometry and stress of a linear model [eq:left-together]. */
static void linear_parts(const struct ladder_state *s, const struct matrix *K,
                         relax_forces *stress, double part[N_PART])
{
    const int hand = s->scene->quantity == LADDER_HAND;
    double together;
    const double moved = relax_geometry(s, K, stress, &together);
    part[GEOMETRY] = hand ? moved : fmin(part[GEOMETRY], moved);
    const double parts = hypot(part[GEOMETRY], part[STRESS]); /* h */
    const double both = hypot(together, 2.0 * parts * parts);
    if (both < parts) {
        part[GEOMETRY] *= both / parts;
        part[STRESS] *= both / parts;
    }
    if (!hand) part[STRESS] = fmax(part[STRESS], pressed(s, part[DIMENSION]));
}

void relax_parts(const struct ladder_state *s, relax_forces *mesh,
                 relax_forces *stress, double part[N_PART])
{
    part[MESH] = part[STRESS] = 0.0;
    if (s->model.rung == BAR) { /* which needs no factors of K */
        part[DIMENSION] = relax_dimension(s);
        if (s->scene->quantity == LADDER_HAND)
            part[GEOMETRY] *= fmax(1.0, ladder_measure(s, s->u) / yields(s));
        return;
    }
    struct matrix *K = relax_factors(s);
    part[MESH] = relax_mesh(s, K, mesh);
    part[STRESS] = relax_part(s, K, stress);
    if (s->model.rung == CUBIC_PLANE)
        part[LAW] = fmin(part[LAW], relax_law(s, K));
    if (s->model.rung == LINEAR_PLANE) linear_parts(s, K, stress, part);
    if (K && !s->model.moving && s->scene->time != STANDS)
        part[INERTIA] = fmax(part[INERTIA], swings(s, K));
    matrix_free(K);
}
