/*
 * 12_backward_euler_2d.c - a square of rubber that moves: backward Euler in
 * time, triangles in space, five steps to one time step.
 *
 * Notes: Lecture 2, section 3; Lecture 1, time stepping.
 *
 * Problem.  A body (-1, 1)^2 of Neo-Hookean material, density rho, some sides
 * held (u = g(t)), the others free or loaded: rho u'' = div P + f.  Backward
 * Euler turns every time step into one equation for the new u,
 *
 *     M (u - u0 - dt v0) + dt^2 (internal - external forces) = 0 [eq:body-q]
 *
 * which Newton's method solves [alg:body-newton]; then v = (u - u0) / dt.
 *
 *     6---7---8     vertex a at X_a, its displacement at u[2a], u[2a+1];
 *     | / | / |     each square is cut from its lower left to its upper
 *     3---4---5     right corner, each triangle lists its three vertices
 *     | / | / |     counter-clockwise: the one below the cut first
 *     0---1---2
 *
 * Then the experiments: every scene of the notes and some more, orders in time
 * and space, the tangent as printed, and a first step that fails.
 *
 * Run       make lesson-12, or with options: -h lists them
 * Expect    --scene stretch --reach 0.5: elastic energy 339.307937720 at t = 1
 *           after 30 steps of 4 Newton iterations; orders 1 in time, 2 in space
 * Plot: steps t elastic
 */
#include "material.h"
#include "matrix.h"
#include "options.h"
#include "table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the body ----------------------------------------------------------- */

struct sheet {
    int n, n_vertex, n_triangle;
    double *X;        /* [2 n_vertex] vertices at rest (m) */
    int *triangle;    /* [3 n_triangle] their vertices */
    int *held;        /* [n_vertex] is u of this vertex given? */
    double *area;     /* [n_triangle] (m^2) */
    double *gradient; /* [6 n_triangle] dN_a/dX_j at [6e + 2a + j] (1/m) */
    double rho;       /* density (kg/m^2) */
    int lumped;       /* mass as row sums on the diagonal */
    struct material material;
};

/*
 * Area and shape-function gradients of the triangle t [eq:shape-gradient].
 * N_a(X) is the barycentric coordinate of X: 1 at vertex a, 0 on the opposite
 * edge, so its gradient is that edge turned by 90 degrees, over twice the area.
 * The area is negative if the vertices run clockwise.
 */
static double shape_gradients(const double X[], const int t[3],
                              double gradient[6])
{
    const double *A = &X[2 * t[0]], *B = &X[2 * t[1]], *C = &X[2 * t[2]];
    const double twice =
        (B[0] - A[0]) * (C[1] - A[1]) - (C[0] - A[0]) * (B[1] - A[1]);
    for (int a = 0; a < 3; a++) {
        const double *from = &X[2 * t[(a + 1) % 3]];
        const double *to = &X[2 * t[(a + 2) % 3]];
        gradient[2 * a] = (from[1] - to[1]) / twice;
        gradient[2 * a + 1] = (to[0] - from[0]) / twice;
    }
    return 0.5 * twice;
}

/* Fill area and gradient.  The first triangle that is flat or clockwise, whose
 * mass and stiffness would be negative, or -1. */
static int sheet_geometry(struct sheet *s)
{
    for (int e = 0; e < s->n_triangle; e++) {
        s->area[e] =
            shape_gradients(s->X, &s->triangle[3 * e], &s->gradient[6 * e]);
        if (!(s->area[e] > 0.0)) return e;
    }
    return -1;
}

/* The square of n x n squares; no vertex is held, cubic law, rho = 1. */
static struct sheet *sheet_alloc(int n)
{
    struct sheet *s = allocate(1, sizeof *s);
    *s = (struct sheet){.n = n, .n_vertex = (n + 1) * (n + 1),
                        .n_triangle = 2 * n * n, .rho = 1.0,
                        .material = material_make(CUBIC, 1000.0, 0.3)};
    s->X = allocate(2 * (size_t)s->n_vertex, sizeof *s->X);
    s->held = allocate((size_t)s->n_vertex, sizeof *s->held);
    s->triangle = allocate(3 * (size_t)s->n_triangle, sizeof *s->triangle);
    s->area = allocate((size_t)s->n_triangle, sizeof *s->area);
    s->gradient = allocate(6 * (size_t)s->n_triangle, sizeof *s->gradient);
    for (int a = 0; a < s->n_vertex; a++) {
        s->X[2 * a] = -1.0 + 2.0 * (a % (n + 1)) / n;
        s->X[2 * a + 1] = -1.0 + 2.0 * (a / (n + 1)) / n;
    }
    for (int e = 0; e < s->n_triangle; e++) {
        const int a = e / 2 / n * (n + 1) + e / 2 % n; /* lower left corner */
        const int right = e % 2 ? a + n + 2 : a + 1;
        const int left = e % 2 ? a + n + 1 : a + n + 2;
        s->triangle[3 * e] = a;
        s->triangle[3 * e + 1] = right;
        s->triangle[3 * e + 2] = left;
    }
    sheet_geometry(s);
    return s;
}

static void sheet_free(struct sheet *s)
{
    free(s->X);
    free(s->held);
    free(s->triangle);
    free(s->area);
    free(s->gradient);
    free(s);
}

/* int N_a N_b over triangle e: area / 6 if a = b, else area / 12
 * [eq:overlap]; a, b = 0, 1, 2. */
static double overlap(const struct sheet *s, int e, int a, int b)
{
    return s->area[e] / (a == b ? 6.0 : 12.0);
}

/* What triangle e adds to M_ab: rho int N_a N_b, or lumped [eq:mass]. */
static double mass(const struct sheet *s, int e, int a, int b)
{
    if (!s->lumped) return s->rho * overlap(s, e, a, b);
    return a == b ? s->rho * s->area[e] / 3.0 : 0.0;
}

/* F = I + sum_a u_a (x) grad N_a, constant on triangle e
 * [eq:deformation-gradient]. */
static mat2 deformation(const struct sheet *s, const double u[], int e)
{
    const int *t = &s->triangle[3 * e];
    const double *g = &s->gradient[6 * e];
    mat2 F = mat2_identity();
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 2; k++)
                F.m[i][k] += u[2 * t[a] + i] * g[2 * a + k];
    return F;
}

/* ---- one time step ------------------------------------------------------ */

/* What pulls: a force per area, given at the vertices, and a constant traction
 * on n_edge edges of the boundary; edge k joins edge[2k] and edge[2k + 1]. */
struct load {
    const double *f; /* [2 n_vertex] (N/m^2) */
    int n_edge;
    const int *edge;
    double traction[2]; /* (N/m) */
};

/*
 * b_a = sum_b M_ab (u0_b + dt v0_b)
 *       + dt^2 (sum_b f_b int N_a N_b + int_edges traction N_a) [eq:body-b]
 *
 * u0, v0   in    displacement and velocity before the step [2 n_vertex]
 * b        out   [2 n_vertex], all vertices, held ones as well
 */
static void right_hand_side(const struct sheet *s, const struct load *load,
                            double dt, const double u0[], const double v0[],
                            double b[])
{
    /* SLOT 12a(s, load, dt, u0, v0, b): triangle by triangle with mass() and
     * overlap(), then edge by edge. */
    todo("12a", s, load, dt, u0, v0, b);
    /* END 12a */
}

/*
 * q_a = sum_b M_ab u_b + dt^2 sum_e area_e P(F_e) grad N_a - b_a [eq:body-q],
 * at all vertices; at a held one it is what holds it, times dt^2.
 * INVERTED where the material is not defined; q is then incomplete.
 */
static enum status residual(const struct sheet *s, double dt, const double u[],
                            const double b[], double q[])
{
    /* SLOT 12b(s, dt, u, b, q): deformation() gives F, material_defined() and
     * material2_pk1() of material.h take &s->material. */
    todo("12b", s, dt, u, b, q);
    /* END 12b */
    return OK;
}

/*
 * K = dq/du, before anything is held [eq:body-tangent]: row 2a + i, column
 * 2b + j gets from triangle e
 *
 *     delta_ij M_ab + dt^2 area_e sum_km (dP_ik/dF_jm) dN_a/dX_k dN_b/dX_m
 *
 *     dP_ik/dF_jm = mu delta_ij delta_km + c1 cof_ik cof_jm
 *                   + c2 d2J/(dF_ik dF_jm)                      [eq:dP-dF]
 *
 * with cof = dJ/dF, c1 = lambda r'^2 + (lambda r - mu) r'', c2 = (lambda r -
 * mu) r'.  Of d2J/(dF_ik dF_jm) only four are not 0: i != j and k != m; it is
 * 1 where k = i, -1 where k = j.
 *
 * K is banded or dense; what it held is forgotten.  INVERTED as in residual().
 */
static enum status tangent(const struct sheet *s, double dt, const double u[],
                           struct matrix *K)
{
    /* SLOT 12c(s, dt, u, K): for each i, j the 2x2 block dP_ik/dF_jm, rows k,
     * columns m; material_r() gives r, r' = dr, r'' = ddr; matrix_add(). */
    todo("12c", s, dt, u, K);
    /* END 12c */
    return OK;
}

/*
 * The Newton increment: K du = -q, du = 0 at the held vertices [eq:newton]
 * [eq:dirichlet-correction].  Component i of vertex a is unknown number 2a + i
 * [eq:flatten].
 *
 * K    in/out  from tangent(); it may be overwritten
 * q    in      from residual()
 * du   out     [2 n_vertex]
 *
 * NOT_SPD: K is not positive definite, as u is far from every minimum of the
 * incremental potential.  du is then meaningless.
 */
static enum status increment(const struct sheet *s, struct matrix *K,
                             const double q[], double du[])
{
    enum status status = OK;
    int *row = allocate(2 * (size_t)s->n_vertex, sizeof *row);
    double *zero = allocate(2 * (size_t)s->n_vertex, sizeof *zero);
    /* SLOT 12d(s, K, q, du, row, zero, &status): collect the unknowns of held
     * vertices in row[], then matrix_dirichlet() with the values zero[],
     * matrix_factor() and matrix_solve() of matrix.h. */
    todo("12d", s, K, q, du, row, zero, &status);
    /* END 12d */
    free(row);
    free(zero);
    return status;
}

/* max |v| over all or the free vertices; INFINITY if one is not finite. */
static double max_abs(const struct sheet *s, const double v[], int free_only)
{
    double largest = 0.0;
    for (int r = 0; r < 2 * s->n_vertex; r++) {
        if (free_only && s->held[r / 2]) continue;
        if (!isfinite(v[r])) return INFINITY;
        largest = fmax(largest, fabs(v[r]));
    }
    return largest;
}

/*
 * A better start than u0 when the boundary jumps: carry the jump g - u of the
 * two ends of each row into the body, linearly in X1 between them, as it is if
 * one end is held alone [eq:lift-2d].
 */
static void spread_jump(const struct sheet *s, const double g[], double u[])
{
    const int n = s->n;
    for (int j = 0; j <= n; j++) {
        const int left = j * (n + 1), right = left + n;
        if (!s->held[left] && !s->held[right]) continue;
        for (int k = 0; k < 2; k++) {
            double at_left = g[2 * left + k] - u[2 * left + k];
            double at_right = g[2 * right + k] - u[2 * right + k];
            if (!s->held[left]) at_left = at_right;
            if (!s->held[right]) at_right = at_left;
            for (int i = 0; i <= n; i++)
                u[2 * (left + i) + k] +=
                    at_left + (at_right - at_left) * i / n;
        }
    }
}

struct control {
    double tolerance;   /* of max|du| (m), and of max|q_free| / weight */
    int max_iterations; /* cap on linear systems solved */
    int lifted;         /* start from spread_jump() instead of u0 */
};

struct report {
    enum status status; /* OK, INVERTED, NOT_SPD, NONFINITE, MAX_ITERATIONS */
    int iterations;     /* linear systems solved */
    double residual;    /* the last max|q| over free vertices */
    double increment;   /* the last max|du| (m) */
};

/* One line of Newton's history: before step k, and the step (0: none made). */
struct line {
    double residual, increment;
};

/* What a displacement of 1 m of one vertex is worth in q: the size of an entry
 * of K, rho h^2 + dt^2 (2 mu + lambda). */
static double weight(const struct sheet *s, double dt)
{
    return s->rho * 4.0 / (s->n * s->n) +
           dt * dt * material_modulus(&s->material);
}

/*
 * One step of backward Euler by Newton's method [alg:body-newton].
 *
 * Start: u (or spread_jump() of it) with g written in at the held vertices.
 * Done: max|q| <= tolerance weight() over the free vertices, and max|du| <=
 * tolerance in the iteration before; there is at least one iteration.  Then
 * v = (u_new - u) / dt at every vertex, and u = u_new [eq:backward-euler].
 *
 * g        in      [2 n_vertex] read at held vertices only
 * u, v     in/out  state; unchanged when the status is not OK
 * history  out     max_iterations + 1 lines, or NULL; report.iterations + 1 of
 *                  them are set
 *
 * NONFINITE: q or du is not finite; MAX_ITERATIONS: the cap is reached.
 */
static struct report step(const struct sheet *s, const struct load *load,
                          const struct control *control, double dt,
                          const double g[], double u[], double v[],
                          struct line history[])
{
    const size_t size = 2 * (size_t)s->n_vertex;
    struct report report = {MAX_ITERATIONS, 0, 0.0, INFINITY};
    struct matrix *K = matrix_alloc(BANDED, (int)size, 2 * s->n + 5);
    double *b = allocate(size, sizeof *b), *q = allocate(size, sizeof *q);
    double *du = allocate(size, sizeof *du);
    double *next = allocate(size, sizeof *next);

    for (size_t r = 0; r < size; r++) next[r] = u[r];
    if (control->lifted) spread_jump(s, g, next);
    /* SLOT 12e(load, dt, v, &report, history, tangent, increment, weight):
     * write g into next, the start; then the loop, with report and history
     * filled on the way; then v and u.  K, b, q, du are there to be used. */
    todo("12e", load, dt, v, &report, history, tangent, increment, weight);
    /* END 12e */
    matrix_free(K);
    free(b);
    free(q);
    free(du);
    free(next);
    return report;
}

/* ---- what to measure ---------------------------------------------------- */

/* out := M v */
static void mass_times(const struct sheet *s, const double v[], double out[])
{
    for (int r = 0; r < 2 * s->n_vertex; r++) out[r] = 0.0;
    for (int e = 0; e < s->n_triangle; e++) {
        const int *t = &s->triangle[3 * e];
        for (int a = 0; a < 3; a++)
            for (int c = 0; c < 3; c++)
                for (int i = 0; i < 2; i++)
                    out[2 * t[a] + i] += mass(s, e, a, c) * v[2 * t[c] + i];
    }
}

struct measures {
    double kinetic, elastic, external; /* energies (J); external: -f.u */
    double momentum[2], angular;       /* sum M v, sum x cross M v */
    double min_J;
};

/* Energies and momenta of a state that the material allows. */
static struct measures measure(const struct sheet *s, const struct load *load,
                               const double u[], const double v[])
{
    const size_t size = 2 * (size_t)s->n_vertex;
    struct measures m = {.min_J = INFINITY};
    double *p = allocate(size, sizeof *p), *f = allocate(size, sizeof *f);
    double *zero = allocate(size, sizeof *zero);

    mass_times(s, v, p);
    right_hand_side(s, load, 1.0, zero, zero, f); /* the nodal forces */
    for (size_t r = 0; r < size; r++) {
        m.kinetic += 0.5 * v[r] * p[r];
        m.external -= f[r] * u[r];
        m.momentum[r % 2] += p[r];
        m.angular += r % 2 ? (s->X[r - 1] + u[r - 1]) * p[r]
                           : -(s->X[r + 1] + u[r + 1]) * p[r];
    }
    for (int e = 0; e < s->n_triangle; e++) {
        const mat2 F = deformation(s, u, e);
        m.elastic += s->area[e] * material2_psi(&s->material, F);
        m.min_J = fmin(m.min_J, mat2_det(F));
    }
    free(p);
    free(f);
    free(zero);
    return m;
}

/* ---- scenes ------------------------------------------------------------- */

enum scene {
    RIGID,    /* both ends X1 = -1, 1 moved by reach (sin t, 0) */
    BOTH,     /* ... by reach (sin t, sin t) */
    STRETCH,  /* ... by reach (X1 sin t, 0) */
    COMPRESS, /* ... by reach (-X1 sin t, 0) */
    STEADY,   /* ... by reach (t sin 1, 0) */
    GRAVITY,  /* left end held, body force (0, -force) */
    TRACTION, /* left end held, traction force (0.8, -0.6) on the right */
    SPIN      /* free; starts turning, and moving at (0.2, 0.1) m/s */
};

struct setting {
    enum scene scene;
    enum law law;
    int n, lumped, lifted;
    double E, nu, rho, dt, tolerance;
    double reach; /* of the held ends (m) */
    double force; /* GRAVITY (N/m^2), TRACTION (N/m) */
    double spin;  /* angular velocity at the start of SPIN (rad/s) */
};

/* A body in motion; all pointers are owned. */
struct state {
    struct sheet *sheet;
    struct load load;
    double *f, *g, *u, *v;
    int *edge;
    int m; /* steps done */
};

static struct state state_alloc(const struct setting *set)
{
    const int n = set->n;
    struct sheet *s = sheet_alloc(n);
    const size_t size = 2 * (size_t)s->n_vertex;
    struct state state = {.sheet = s};

    s->rho = set->rho;
    s->lumped = set->lumped;
    s->material = material_make(set->law, set->E, set->nu);
    state.f = allocate(size, sizeof(double));
    state.g = allocate(size, sizeof(double));
    state.u = allocate(size, sizeof(double));
    state.v = allocate(size, sizeof(double));
    state.edge = allocate(2 * (size_t)n, sizeof(int));
    for (int a = 0; a < s->n_vertex; a++) {
        const double *X = &s->X[2 * a];
        const int left = a % (n + 1) == 0, right = a % (n + 1) == n;
        s->held[a] = set->scene != SPIN &&
                     (left || (right && set->scene < GRAVITY));
        if (set->scene == GRAVITY) state.f[2 * a + 1] = -set->force;
        if (set->scene != SPIN) continue;
        state.v[2 * a] = 0.2 - set->spin * X[1];
        state.v[2 * a + 1] = 0.1 + set->spin * X[0];
    }
    for (int k = 0; k < n; k++) {
        state.edge[2 * k] = k * (n + 1) + n;
        state.edge[2 * k + 1] = (k + 1) * (n + 1) + n;
    }
    state.load = (struct load){state.f, set->scene == TRACTION ? n : 0,
                               state.edge,
                               {0.8 * set->force, -0.6 * set->force}};
    return state;
}

static void state_free(struct state *state)
{
    sheet_free(state->sheet);
    free(state->f);
    free(state->g);
    free(state->u);
    free(state->v);
    free(state->edge);
}

/* g(t, X) of a scene's held vertices. */
static void boundary_value(const struct setting *set, double t, double X1,
                           double g[2])
{
    const double s = set->reach * sin(t);
    g[0] = g[1] = 0.0;
    if (set->scene == RIGID || set->scene == BOTH) g[0] = s;
    if (set->scene == BOTH) g[1] = s;
    if (set->scene == STRETCH) g[0] = X1 * s;
    if (set->scene == COMPRESS) g[0] = -X1 * s;
    if (set->scene == STEADY) g[0] = set->reach * t * sin(1.0);
}

enum { CAP = 30 }; /* Newton iterations a step */

/* The next time step of a scene; history as in step(). */
static struct report state_step(struct state *state, const struct setting *set,
                                struct line history[])
{
    const struct sheet *s = state->sheet;
    const struct control control = {set->tolerance, CAP, set->lifted};
    const double t = (state->m + 1) * set->dt;
    for (int a = 0; a < s->n_vertex; a++)
        boundary_value(set, t, s->X[2 * a], &state->g[2 * a]);
    const struct report report =
        step(s, &state->load, &control, set->dt, state->g, state->u, state->v,
             history);
    if (report.status == OK) state->m++;
    return report;
}

/* Make up to n steps; the report of the last, its iterations summed up. */
static struct report advance(struct state *state, const struct setting *set,
                             int n)
{
    struct report report = {OK, 0, 0.0, 0.0};
    int iterations = 0;
    for (int m = 0; m < n && report.status == OK; m++) {
        report = state_step(state, set, NULL);
        iterations += report.iterations;
    }
    report.iterations = iterations;
    return report;
}

/* ---- tables of the scene ------------------------------------------------ */

enum { MAX_STEPS = 1000 };

/* Everything that is printed of the scene, computed before it is printed. */
struct record {
    struct report report[MAX_STEPS + 1];
    struct measures measures[MAX_STEPS + 1];
    double centre[MAX_STEPS + 1][2]; /* u of the vertex in the middle */
    struct line history[CAP + 1];    /* of the step to watch */
};

/* The vertex at (0, 0); for odd n the one at (-1/n, -1/n). */
static int middle(const struct sheet *s)
{
    return s->n / 2 * (s->n + 1) + s->n / 2;
}

static void record_state(struct record *record, const struct state *state)
{
    const int m = state->m, c = middle(state->sheet);
    record->measures[m] =
        measure(state->sheet, &state->load, state->u, state->v);
    record->centre[m][0] = state->u[2 * c];
    record->centre[m][1] = state->u[2 * c + 1];
}

static void print_steps(const struct setting *set, int steps,
                        const struct record *record)
{
    table_begin("steps", "t iterations kinetic elastic external total "
                         "momentum_x momentum_y angular min_J centre_x "
                         "centre_y");
    for (int m = 0; m <= steps; m++) {
        const struct measures *e = &record->measures[m];
        table_row(m * set->dt, record->report[m].iterations, e->kinetic,
                  e->elastic, e->external,
                  e->kinetic + e->elastic + e->external, e->momentum[0],
                  e->momentum[1], e->angular, e->min_J, record->centre[m][0],
                  record->centre[m][1]);
    }
    table_end();
}

static void print_newton(const struct record *record, int watch)
{
    table_begin_note("newton", "k residual increment", "step %d of the scene",
                     watch);
    for (int k = 0; k < record->report[watch].iterations; k++)
        table_row(k, record->history[k].residual,
                  record->history[k].increment);
    table_end();
}

static void print_nodes(const struct state *state)
{
    const struct sheet *s = state->sheet;
    table_begin("nodes", "X Y u_x u_y v_x v_y held");
    for (int a = 0; a < s->n_vertex; a++)
        table_row(s->X[2 * a], s->X[2 * a + 1], state->u[2 * a],
                  state->u[2 * a + 1], state->v[2 * a], state->v[2 * a + 1],
                  s->held[a]);
    table_end();
}

/* The forces of the load at all vertices, added up: with unit traction the side
 * of length 2 must carry 2, whatever n is. */
static void print_loads(const struct state *state)
{
    const struct sheet *s = state->sheet;
    const size_t size = 2 * (size_t)s->n_vertex;
    double *zero = allocate(size, sizeof *zero);
    double *force = allocate(size, sizeof *force);
    double sum[2] = {0.0, 0.0};

    right_hand_side(s, &state->load, 1.0, zero, zero, force);
    for (size_t r = 0; r < size; r++) sum[r % 2] += force[r];
    table_begin("loads", "force_x force_y");
    table_row(sum[0], sum[1]);
    table_end();
    free(zero);
    free(force);
}

/* b, and q at the start, of the step that follows; n <= 4. */
static void print_b_q(const struct state *state, const struct setting *set)
{
    const struct sheet *s = state->sheet;
    const size_t size = 2 * (size_t)s->n_vertex;
    double *b = allocate(size, sizeof *b), *q = allocate(size, sizeof *q);

    right_hand_side(s, &state->load, set->dt, state->u, state->v, b);
    if (residual(s, set->dt, state->u, b, q) != OK) die("q is not defined");
    table_begin("b_q", "vertex b_x b_y q_x q_y");
    for (int a = 0; a < s->n_vertex; a++)
        table_row(a, b[2 * a], b[2 * a + 1], q[2 * a], q[2 * a + 1]);
    table_end();
    free(b);
    free(q);
}

/* The scene itself; a step that fails ends the program before it prints. */
static void run_scene(const struct setting *set, int steps, int watch)
{
    struct state state = state_alloc(set);
    struct record *record = allocate(1, sizeof *record);

    record_state(record, &state);
    while (state.m < steps) {
        const int m = state.m + 1;
        const struct report report =
            state_step(&state, set, m == watch ? record->history : NULL);
        if (report.status != OK) {
            state_free(&state);
            free(record);
            die("step %d, t = %g: Newton's method ends with %s after %d "
                "iterations", m, m * set->dt, status_name(report.status),
                report.iterations);
        }
        record->report[m] = report;
        record_state(record, &state);
    }
    print_steps(set, steps, record);
    print_newton(record, watch);
    print_loads(&state);
    print_nodes(&state);
    if (set->n <= 4) print_b_q(&state, set);
    state_free(&state);
    free(record);
}

/* ---- every scene -------------------------------------------------------- */

/* The settings of the studies: the notes' E, nu, rho, 30 steps a second. */
static struct setting notes_setting(enum scene scene, enum law law, int n)
{
    return (struct setting){.scene = scene, .law = law, .n = n, .E = 1000.0,
                            .nu = 0.3, .rho = 1.0, .dt = 1.0 / 30.0,
                            .tolerance = 1e-10, .reach = 1.0, .force = 50.0,
                            .spin = 6.0};
}

/* One second of every scene; where a step fails the row is the state before. */
static void print_readings(void)
{
    table_begin_note("readings", "scene law steps iterations reason centre_x "
                     "centre_y top_x top_y elastic kinetic momentum_x min_J",
                     "n = 4; scenes in the order of --scene, law 1 log, 2 "
                     "cubic; top: the vertex at (0, 1)");
    for (int scene = RIGID; scene <= SPIN; scene++)
        for (int law = LOG; law <= CUBIC; law++) {
            const struct setting set =
                notes_setting((enum scene)scene, (enum law)law, 4);
            struct state state = state_alloc(&set);
            const struct report report = advance(&state, &set, 30);
            const struct measures e =
                measure(state.sheet, &state.load, state.u, state.v);
            const double *u = state.u;
            table_row(scene, law, state.m, report.iterations, report.status,
                      u[2 * 12], u[2 * 12 + 1], u[2 * 22], u[2 * 22 + 1],
                      e.elastic, e.kinetic, e.momentum[0], e.min_J);
            state_free(&state);
        }
    table_end();
}

/* The triangles of a state in their places, with J. */
static void print_triangles(const struct sheet *s, const double u[], int scene,
                            double t)
{
    for (int e = 0; e < s->n_triangle; e++) {
        const int *p = &s->triangle[3 * e];
        double x[6];
        for (int r = 0; r < 6; r++)
            x[r] = s->X[2 * p[r / 2] + r % 2] + u[2 * p[r / 2] + r % 2];
        table_row(scene, t, mat2_det(deformation(s, u, e)), x[0], x[1], x[2],
                  x[3], x[4], x[5]);
    }
}

static const char triangle_columns[] = "scene t J x0 y0 x1 y1 x2 y2";

static void print_gallery(void)
{
    const enum scene scenes[] = {STRETCH, COMPRESS, GRAVITY, SPIN};
    table_begin("gallery", triangle_columns);
    for (int k = 0; k < COUNT(scenes); k++) {
        struct setting set = notes_setting(scenes[k], CUBIC, 6);
        set.reach = 0.6;
        struct state state = state_alloc(&set);
        for (int frame = 0; frame < 3; frame++) {
            if (advance(&state, &set, 10).status != OK) break;
            print_triangles(state.sheet, state.u, (int)set.scene,
                            state.m * set.dt);
        }
        state_free(&state);
    }
    table_end();
}

/* A free square for the eye: each step of SPIN, coarse. */
static void print_motion(void)
{
    const struct setting set = notes_setting(SPIN, CUBIC, 4);
    struct state state = state_alloc(&set);
    table_begin("motion", triangle_columns);
    do print_triangles(state.sheet, state.u, SPIN, state.m * set.dt);
    while (state.m < 45 && advance(&state, &set, 1).status == OK);
    table_end();
    state_free(&state);
}

/* The energy of the body under gravity, which an exact motion would keep at 0,
 * with steps of 1/30, 1/120 and 1/480 s. */
static void print_energies(void)
{
    enum { STEPS = 45 };
    struct measures m[3][STEPS + 1];
    for (int k = 0; k < 3; k++) {
        const int each = 1 << 2 * k; /* steps a row */
        struct setting set = notes_setting(GRAVITY, CUBIC, 4);
        set.dt /= each;
        struct state state = state_alloc(&set);
        for (int row = 0; row <= STEPS; row++) {
            m[k][row] = measure(state.sheet, &state.load, state.u, state.v);
            if (advance(&state, &set, each).status != OK) die("gravity fails");
        }
        state_free(&state);
    }
    table_begin("energies", "t kinetic elastic external total total_120 "
                            "total_480");
    for (int row = 0; row <= STEPS; row++) {
        double total[3];
        for (int k = 0; k < 3; k++)
            total[k] = m[k][row].kinetic + m[k][row].elastic +
                       m[k][row].external;
        table_row(row / 30.0, m[0][row].kinetic, m[0][row].elastic,
                  m[0][row].external, total[0], total[1], total[2]);
    }
    table_end();
}

/*
 * What the method does to a spin: the momentum is kept, but a rigid body that
 * turns by omega dt a step loses dt omega^2 of its omega each second, so that
 * after the time t its angular momentum is 1 / sqrt(1 + 2 dt omega^2 t) of what
 * it was [eq:spin-decay].
 */
static void print_spin(void)
{
    table_begin("spin", "dt angular predicted momentum_error");
    for (int rate = 30; rate <= 480; rate *= 2) {
        struct setting set = notes_setting(SPIN, CUBIC, 2);
        set.dt = 1.0 / rate;
        struct state state = state_alloc(&set);
        const struct measures start =
            measure(state.sheet, &state.load, state.u, state.v);
        if (advance(&state, &set, rate).status != OK) die("the spin fails");
        const struct measures end =
            measure(state.sheet, &state.load, state.u, state.v);
        const double omega = set.spin;
        /* that of the motion of the centre of mass, from the origin, is 0 */
        table_row(set.dt, end.angular / start.angular,
                  1.0 / sqrt(1.0 + 2.0 * set.dt * omega * omega),
                  hypot(end.momentum[0] - start.momentum[0],
                        end.momentum[1] - start.momentum[1]));
        state_free(&state);
    }
    table_end();
}

/* ---- orders ------------------------------------------------------------- */

/* u of a free square, E = 100, n = 4, that was hit at t = 0, v = (3 sin(pi
 * X1 / 2), 0), after 0.05 s in `steps` steps. */
static void hit_square(int steps, double u[])
{
    struct setting set = notes_setting(SPIN, CUBIC, 4);
    set.spin = 0.0;
    set.E = 100.0;
    set.dt = 0.05 / steps;
    struct state state = state_alloc(&set);
    for (int a = 0; a < state.sheet->n_vertex; a++) {
        state.v[2 * a] = 3.0 * sin(M_PI_2 * state.sheet->X[2 * a]);
        state.v[2 * a + 1] = 0.0;
    }
    if (advance(&state, &set, steps).status != OK) die("the hit fails");
    for (int r = 0; r < 50; r++) u[r] = state.u[r];
    state_free(&state);
}

/* Order one in time: the error against the limit dt -> 0 on the same mesh, from
 * the three finest runs by Richardson's extrapolation. */
static void print_orders_time(void)
{
    enum { RUNS = 7 };
    double u[RUNS][50], before = 0.0;
    for (int k = 0; k < RUNS; k++) hit_square(4 << k, u[k]);
    table_begin("orders_time", "dt error order constant");
    for (int k = 0; k < RUNS - 2; k++) {
        double error = 0.0;
        for (int r = 0; r < 50; r++) {
            const double limit = (8.0 * u[RUNS - 1][r] - 6.0 * u[RUNS - 2][r] +
                                  u[RUNS - 3][r]) / 3.0;
            error = fmax(error, fabs(u[k][r] - limit));
        }
        const double dt = 0.05 / (4 << k);
        table_row(dt, error, k > 0 ? log2(before / error) : 0.0, error / dt);
        before = error;
    }
    table_end();
}

/* A smooth u that vanishes on the boundary, and its derivatives. */
struct smooth {
    double u[2];
    mat2 H;     /* du_i / dX_k */
    mat2 dH[2]; /* derivative of H along X1, along X2 */
};

static struct smooth smooth_at(const double X[2])
{
    const double a = 0.1, p = M_PI, h = M_PI_2;
    const double sx = sin(p * X[0]), cx = cos(p * X[0]);
    const double sy = sin(p * X[1]), cy = cos(p * X[1]);
    const double shx = sin(h * X[0]), chx = cos(h * X[0]);
    const double shy = sin(h * X[1]), chy = cos(h * X[1]);
    const double u1_12 = -a * p * h * cx * shy, u2_12 = -a * p * h * shx * cy;
    return (struct smooth){
        {a * sx * chy, a * chx * sy},
        {{{a * p * cx * chy, -a * h * sx * shy},
          {-a * h * shx * sy, a * p * chx * cy}}},
        {{{{-a * p * p * sx * chy, u1_12}, {-a * h * h * chx * sy, u2_12}}},
         {{{u1_12, -a * h * h * sx * chy}, {u2_12, -a * p * p * chx * sy}}}}};
}

/* The body force under which one step from rest ends at smooth_at()
 * [eq:manufactured]: f = rho u / dt^2 - div P, div P_i = dP_ij / dX_j. */
static void manufactured_force(const struct sheet *s, double dt, double f[])
{
    for (int a = 0; a < s->n_vertex; a++) {
        const struct smooth w = smooth_at(&s->X[2 * a]);
        const mat2 F = mat2_add(mat2_identity(), w.H);
        const mat2 along1 = material2_dpk1(&s->material, F, w.dH[0]);
        const mat2 along2 = material2_dpk1(&s->material, F, w.dH[1]);
        for (int i = 0; i < 2; i++)
            f[2 * a + i] = s->rho * w.u[i] / (dt * dt) - along1.m[i][0] -
                           along2.m[i][1];
    }
}

/* L2 norms of u_h - u and of its gradient, by six points a triangle, exact for
 * degree 4 (Dunavant, Int. J. Numer. Meth. Engng 21 (1985), p. 1140). */
static void smooth_error(const struct sheet *s, const double u[], double *L2,
                         double *H1)
{
    const double near[2] = {0.445948490915965, 0.091576213509771};
    const double part[2] = {0.223381589678011, 0.109951743655322};
    *L2 = *H1 = 0.0;
    for (int e = 0; e < s->n_triangle; e++) {
        const int *t = &s->triangle[3 * e];
        const mat2 F = deformation(s, u, e);
        for (int k = 0; k < 6; k++) {
            double X[2] = {0.0, 0.0}, value[2] = {0.0, 0.0};
            for (int a = 0; a < 3; a++)
                for (int i = 0; i < 2; i++) {
                    const double xi = near[k / 3], N =
                        a == k % 3 ? 1.0 - 2.0 * xi : xi;
                    X[i] += N * s->X[2 * t[a] + i];
                    value[i] += N * u[2 * t[a] + i];
                }
            const struct smooth w = smooth_at(X);
            const double size = part[k / 3] * s->area[e];
            const mat2 miss =
                mat2_subtract(mat2_subtract(F, mat2_identity()), w.H);
            for (int i = 0; i < 2; i++)
                *L2 += size * gsl_pow_2(value[i] - w.u[i]);
            *H1 += size * mat2_dot(miss, miss);
        }
    }
    *L2 = sqrt(*L2);
    *H1 = sqrt(*H1);
}

/* Order two in space for u, one for its gradient, in a step without corners
 * and edges to disturb it: all of the boundary held, smooth force. */
static void print_orders_space(enum law law)
{
    double before[2] = {0.0, 0.0};
    table_begin("orders_space", "n h L2 order_L2 constant_L2 gradient "
                                "order_gradient interpolation");
    for (int n = 4; n <= 32; n *= 2) {
        const struct setting set = notes_setting(SPIN, law, n);
        struct state state = state_alloc(&set);
        struct sheet *s = state.sheet;
        const size_t size = 2 * (size_t)s->n_vertex;
        const double h = 2.0 / n;
        double error[2], closest[2];

        for (int a = 0; a < s->n_vertex; a++)
            s->held[a] = fabs(s->X[2 * a]) == 1.0 ||
                         fabs(s->X[2 * a + 1]) == 1.0;
        for (size_t r = 0; r < size; r++) state.v[r] = 0.0;
        manufactured_force(s, set.dt, state.f);
        if (advance(&state, &set, 1).status != OK) die("the smooth step fails");
        smooth_error(s, state.u, &error[0], &error[1]);
        for (size_t r = 0; r < size; r++)
            state.u[r] = smooth_at(&s->X[r / 2 * 2]).u[r % 2];
        smooth_error(s, state.u, &closest[0], &closest[1]);
        table_row(n, h, error[0], n > 4 ? log2(before[0] / error[0]) : 0.0,
                  error[0] / (h * h), error[1],
                  n > 4 ? log2(before[1] / error[1]) : 0.0, closest[1]);
        before[0] = error[0];
        before[1] = error[1];
        state_free(&state);
    }
    table_end();
}

/* ---- the tangent as printed --------------------------------------------- */

/* The two slips of the notes' listing, one bit each: cof(:,j) where cof(j,:) is
 * meant, and mu added to one entry of the diagonal, (i,i), in place of both. */
enum slip { NO_SLIP, COLUMN_FOR_ROW, HALF_OF_MU, BOTH_SLIPS };

/* dP_ik/dF_jm, rows k, columns m, with slips. */
static mat2 printed_block(const struct material *material, mat2 F,
                          enum slip slip, int i, int j)
{
    const double mu = material->mu, lambda = material->lambda;
    const struct volumetric v = material_r(material, mat2_det(F));
    const mat2 cof = mat2_cofactor(F);
    const double c1 = lambda * v.dr * v.dr + (lambda * v.r - mu) * v.ddr;
    const double c2 = (lambda * v.r - mu) * v.dr;
    mat2 D;
    for (int k = 0; k < 2; k++)
        for (int m = 0; m < 2; m++)
            D.m[k][m] = c1 * cof.m[i][k] *
                        (slip & COLUMN_FOR_ROW ? cof.m[m][j] : cof.m[j][m]);
    if (i == j) {
        D.m[i][i] += mu;
        if (!(slip & HALF_OF_MU)) D.m[1 - i][1 - i] += mu;
    } else {
        D.m[i][j] += c2;
        D.m[j][i] -= c2;
    }
    return D;
}

/* Of dP/dF as a 4x4 matrix: its error and its asymmetry, relative to its
 * Frobenius norm. */
static void slip_error(mat2 F, enum slip slip, double *error, double *asymmetry)
{
    const struct material material = material_make(CUBIC, 1000.0, 0.3);
    double norm = 0.0, off = 0.0, odd = 0.0;
    for (int r = 0; r < 16; r++) {
        const int i = r / 8, j = r / 4 % 2, k = r / 2 % 2, m = r % 2;
        const double exact =
            printed_block(&material, F, NO_SLIP, i, j).m[k][m];
        const double wrong_ = printed_block(&material, F, slip, i, j).m[k][m];
        norm += exact * exact;
        off += gsl_pow_2(wrong_ - exact);
        odd += gsl_pow_2(
            wrong_ - printed_block(&material, F, slip, j, i).m[m][k]);
    }
    *error = sqrt(off / norm);
    *asymmetry = sqrt(odd / norm);
}

/* K of a free sheet with slips, as a full matrix; it need not be symmetric. */
static void printed_tangent(const struct sheet *s, double dt, const double u[],
                            enum slip slip, gsl_matrix *K)
{
    gsl_matrix_set_zero(K);
    for (int e = 0; e < s->n_triangle; e++) {
        const int *t = &s->triangle[3 * e];
        const double *g = &s->gradient[6 * e];
        const mat2 F = deformation(s, u, e);
        for (int ij = 0; ij < 4; ij++) {
            const int i = ij / 2, j = ij % 2;
            const mat2 D = printed_block(&s->material, F, slip, i, j);
            for (int ac = 0; ac < 9; ac++) {
                const int a = ac / 3, c = ac % 3;
                double *entry =
                    gsl_matrix_ptr(K, (size_t)(2 * t[a] + i),
                                   (size_t)(2 * t[c] + j));
                if (i == j) *entry += mass(s, e, a, c);
                for (int km = 0; km < 4; km++)
                    *entry += dt * dt * s->area[e] * g[2 * a + km / 2] *
                              D.m[km / 2][km % 2] * g[2 * c + km % 2];
            }
        }
    }
}

enum { SLIP_CAP = 40, SLIP_N = 4 };

/* Newton's method with the printed tangent for one step, by LU, which minds no
 * asymmetry.  residual_[k], k = 0..iterations, is max|q| before step k. */
static struct report slip_newton(struct state *state, const struct setting *set,
                                 enum slip slip, double residual_[])
{
    const struct sheet *s = state->sheet;
    const size_t size = 2 * (size_t)s->n_vertex;
    struct report report = {MAX_ITERATIONS, 0, 0.0, INFINITY};
    gsl_matrix *K = gsl_matrix_alloc(size, size);
    gsl_vector *du = gsl_vector_alloc(size);
    gsl_permutation *order = gsl_permutation_alloc(size);
    double *b = allocate(size, sizeof *b), *q = allocate(size, sizeof *q);

    right_hand_side(s, &state->load, set->dt, state->u, state->v, b);
    for (;;) {
        int sign;
        report.status = residual(s, set->dt, state->u, b, q);
        report.residual = max_abs(s, q, 0);
        if (report.status == OK && !(report.residual < 1e12))
            report.status = NONFINITE;
        if (report.status != OK) break;
        residual_[report.iterations] = report.residual;
        if (report.increment <= set->tolerance) break;
        report.status = MAX_ITERATIONS;
        if (report.iterations == SLIP_CAP) break;
        printed_tangent(s, set->dt, state->u, slip, K);
        for (size_t r = 0; r < size; r++) gsl_vector_set(du, r, -q[r]);
        report.status = NONFINITE;
        if (gsl_linalg_LU_decomp(K, order, &sign) ||
            gsl_linalg_LU_svx(K, order, du))
            break;
        report.increment = max_abs(s, du->data, 0);
        for (size_t r = 0; r < size; r++) state->u[r] += du->data[r];
        report.iterations++;
    }
    gsl_matrix_free(K);
    gsl_vector_free(du);
    gsl_permutation_free(order);
    free(b);
    free(q);
    return report;
}

/*
 * A free square, turned by `angle` and pulled to 1.2385 times its length along
 * its own X1, is let go: what the slips do to one time step.
 */
static struct report let_go(double angle, enum slip slip, double residual_[])
{
    struct setting set = notes_setting(SPIN, CUBIC, SLIP_N);
    set.spin = 0.0;
    struct state state = state_alloc(&set);
    const mat2 F = mat2_multiply(mat2_rotation(angle),
                                 (mat2){{{1.2385, 0.0}, {0.0, 1.0}}});
    for (int r = 0; r < 2 * state.sheet->n_vertex; r++) {
        const double *X = &state.sheet->X[r / 2 * 2];
        state.u[r] = F.m[r % 2][0] * X[0] + F.m[r % 2][1] * X[1] - X[r % 2];
    }
    const struct report report = slip_newton(&state, &set, slip, residual_);
    state_free(&state);
    return report;
}

static void print_slips(void)
{
    const double angle = M_PI / 6.0;
    const mat2 shear = {{{1.0, 0.5}, {0.0, 1.0}}};
    const mat2 general = {{{1.2385, 0.3714}, {-0.2385, 0.8714}}};
    const mat2 states[4] = {mat2_identity(), shear, mat2_rotation(angle),
                            general};
    double residual_[2][4][SLIP_CAP + 1] = {{{0.0}}};
    int reached[2][4];
    table_begin_note("slips", "slip rest shear rotated general asym_rest "
                     "asym_rotated iterations iterations_turned",
                     "slip: 1 column for row, 2 half of mu, 3 both; iterations "
                     "-1: none of %d was the last", SLIP_CAP);
    for (int slip = NO_SLIP; slip <= BOTH_SLIPS; slip++) {
        double error[4], asymmetry[4];
        int iterations[2];
        for (int k = 0; k < 4; k++)
            slip_error(states[k], (enum slip)slip, &error[k], &asymmetry[k]);
        for (int turned = 0; turned < 2; turned++) {
            const struct report report =
                let_go(turned * angle, (enum slip)slip,
                       residual_[turned][slip]);
            reached[turned][slip] = report.iterations;
            iterations[turned] = report.status == OK ? report.iterations : -1;
        }
        table_row(slip, error[0], error[1], error[2], error[3], asymmetry[0],
                  asymmetry[2], iterations[0], iterations[1]);
    }
    table_end();
    table_begin_note("slip_history", "turned slip k residual",
                     "residual before iteration k");
    for (int turned = 0; turned < 2; turned++)
        for (int slip = NO_SLIP; slip <= BOTH_SLIPS; slip++)
            for (int k = 0; k <= reached[turned][slip]; k++)
                if (residual_[turned][slip][k] > 0.0)
                    table_row(turned, slip, k, residual_[turned][slip][k]);
    table_end();
}

/* ---- the first step ----------------------------------------------------- */

/* One step from rest after both ends have jumped by jump h along X1. */
static struct report jump_step(struct state *state, const struct setting *set,
                               double jump)
{
    const struct sheet *s = state->sheet;
    const struct control control = {set->tolerance, CAP, set->lifted};
    for (int a = 0; a < s->n_vertex; a++)
        state->g[2 * a] = s->held[a] ? jump * 2.0 / s->n : 0.0;
    return step(s, &state->load, &control, set->dt, state->g, state->u,
                state->v, NULL);
}

/* Iterations, -1 where the step fails, and why it fails. */
static void print_jumps(void)
{
    const double jumps[] = {0.25, 0.5,  0.6,  0.7, 0.75, 0.8, 0.85,
                            0.9,  0.95, 1.05, 1.5, 3.0};
    table_begin_note("jump", "jump log reason_log cubic reason_cubic "
                     "log_lifted cubic_lifted min_J",
                     "n = 8; iterations, -1: no solution; min_J of the "
                     "solution, cubic");
    for (int k = 0; k < COUNT(jumps); k++) {
        int iterations[4], reason[4];
        double min_J = 0.0;
        for (int c = 0; c < 4; c++) {
            struct setting set = notes_setting(RIGID, c % 2 ? CUBIC : LOG, 8);
            set.lifted = c / 2;
            struct state state = state_alloc(&set);
            const struct report report = jump_step(&state, &set, jumps[k]);
            iterations[c] = report.status == OK ? report.iterations : -1;
            reason[c] = (int)report.status;
            min_J = measure(state.sheet, &state.load, state.u, state.v).min_J;
            state_free(&state);
        }
        table_row(jumps[k], iterations[0], reason[0], iterations[1], reason[1],
                  iterations[2], iterations[3], min_J);
    }
    table_end();
}

/* The start that the notes take, after a jump of 0.85 h, and the solution. */
static void print_guess(void)
{
    struct setting set = notes_setting(RIGID, CUBIC, 8);
    struct state state = state_alloc(&set);
    const double jump = 0.85;
    table_begin_note("guess", triangle_columns,
                     "t = 0: u0 and boundary values; t = dt: the solution");
    for (int a = 0; a < state.sheet->n_vertex; a++)
        if (state.sheet->held[a]) state.u[2 * a] = jump * 2.0 / 8;
    print_triangles(state.sheet, state.u, RIGID, 0.0);
    for (int r = 0; r < 2 * state.sheet->n_vertex; r++) state.u[r] = 0.0;
    set.lifted = 1;
    if (jump_step(&state, &set, jump).status != OK)
        die("the lifted step fails");
    print_triangles(state.sheet, state.u, RIGID, set.dt);
    table_end();
    state_free(&state);
}

/* The notes' example, first step at 30 a second, refined. */
static void print_first_step(int finest)
{
    const int sizes[] = {8, 16, 40, 50, 54, 56, 60};
    table_begin_note("first_step", "n jump log reason_log cubic reason_cubic "
                     "log_lifted cubic_lifted",
                     "jump = sin(dt) / h; iterations, -1: the step fails");
    for (int k = 0; k < COUNT(sizes) && sizes[k] <= finest; k++) {
        int iterations[4], reason[4];
        for (int c = 0; c < 4; c++) {
            struct setting set =
                notes_setting(RIGID, c % 2 ? CUBIC : LOG, sizes[k]);
            set.lifted = c / 2;
            struct state state = state_alloc(&set);
            const struct report report = state_step(&state, &set, NULL);
            iterations[c] = report.status == OK ? report.iterations : -1;
            reason[c] = (int)report.status;
            state_free(&state);
        }
        table_row(sizes[k], sin(1.0 / 30.0) * sizes[k] / 2.0, iterations[0],
                  reason[0], iterations[1], reason[1], iterations[2],
                  iterations[3]);
    }
    table_end();
}

/* With --clockwise e: turn triangle e around and see what the mesh says. */
static void refuse_clockwise(int n, int e)
{
    struct sheet *s = sheet_alloc(n);
    if (e >= s->n_triangle)
        die("--clockwise %d: there are triangles 0 to %d", e,
            s->n_triangle - 1);
    const int second = s->triangle[3 * e + 1];
    s->triangle[3 * e + 1] = s->triangle[3 * e + 2];
    s->triangle[3 * e + 2] = second;
    const int found = sheet_geometry(s);
    if (found >= 0)
        die("triangle %d is clockwise: its area is %g", found, s->area[found]);
    sheet_free(s);
}

int main(int argc, char *argv[])
{
    int scene = STRETCH, law = 1, mass_ = 0, guess = 0, study = 1;
    int n = 8, steps = 30, watch = 1, finest = 60, clockwise = -1;
    struct setting set = notes_setting(STRETCH, CUBIC, 8);
    const struct option options[] = {
        {"scene", .choice = &scene,
         .choices = "rigid both stretch compress steady gravity traction spin",
         .help = "what holds and pulls the square"},
        {"law", .choice = &law, .choices = "log cubic", .help = "r"},
        {"n", .integer = &n, .min = 1, .max = 60, .help = "squares a side"},
        {"steps", .integer = &steps, .min = 1, .max = MAX_STEPS,
         .help = "time steps"},
        {"dt", .real = &set.dt, .min = 1e-6, .max = 10, .unit = "s",
         .help = "time step"},
        {"mass", .choice = &mass_, .choices = "consistent lumped",
         .help = "mass matrix"},
        {"guess", .choice = &guess, .choices = "last lifted",
         .help = "where Newton's method starts"},
        {"tolerance", .real = &set.tolerance, .min = 1e-12, .max = 1e-3,
         .unit = "m", .help = "of Newton's method"},
        {"E", .real = &set.E, .min = 1e-3, .max = 1e6, .unit = "N/m^2",
         .help = "Young's modulus"},
        {"nu", .real = &set.nu, .min = 0, .max = 0.49,
         .help = "Poisson's ratio"},
        {"rho", .real = &set.rho, .min = 1e-3, .max = 1e3, .unit = "kg/m^2",
         .help = "density"},
        {"reach", .real = &set.reach, .min = -20, .max = 20, .unit = "m",
         .help = "amplitude of the moving ends"},
        {"force", .real = &set.force, .min = -1e4, .max = 1e4,
         .unit = "N/m^2 or N/m", .help = "of gravity, traction"},
        {"spin", .real = &set.spin, .min = -60, .max = 60, .unit = "rad/s",
         .help = "at the start of spin"},
        {"watch", .integer = &watch, .min = 1, .max = MAX_STEPS,
         .help = "step whose iterations are printed"},
        {"study", .choice = &study, .choices = "off on",
         .help = "the tables that do not depend on the scene"},
        {"finest", .integer = &finest, .min = 8, .max = 60,
         .help = "last n of table first_step"},
        {"clockwise", .integer = &clockwise, .min = 0, .max = 7199,
         .help = "turn this triangle around, to see it refused"},
    };
    options_parse("12_backward_euler_2d", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();

    if (clockwise >= 0) refuse_clockwise(n, clockwise);
    if (n * n * steps > 120000)
        die("--n %d --steps %d is too long: n^2 steps may be 120000", n, steps);
    if (watch > steps) die("--watch %d: there are %d steps", watch, steps);
    set.scene = (enum scene)scene;
    set.law = law ? CUBIC : LOG;
    set.n = n;
    set.lumped = mass_;
    set.lifted = guess;

    run_scene(&set, steps, watch);
    if (study) {
        print_readings();
        print_gallery();
        print_motion();
        print_energies();
        print_spin();
        print_orders_time();
        print_orders_space(set.law);
        print_slips();
        print_jumps();
        print_guess();
        print_first_step(finest);
    }
    return table_finish();
}
