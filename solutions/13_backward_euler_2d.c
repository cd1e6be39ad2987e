/*
 * 13_backward_euler_2d.c - a square of rubber that moves: backward Euler in
 * time, triangles in space, Newton's method in each step.
 *
 * Notes: Lecture 2, 3.3.1 and 3.3.5; Lecture 1, time stepping.
 *
 * Problem.  rho u'' = div P + f on (-1, 1)^2, Neo-Hookean; some ends are held,
 * u = g(t), the others are free or loaded.  Backward Euler turns each time step
 * into one equation q = 0 for the new u, which Newton's method solves.
 *
 *     6---7---8     component i of vertex a is u[2a + i] [eq:flatten]; triangle
 *     | / | / |     e has the vertices t = &mesh->triangle[3e] and the area
 *     3---4---5     body->area[e].  Only the vertices that are not held have
 *     | / | / |     unknowns, in a numbering of their own (body.h); the forces
 *     0---1---2     come from the lesson before, as body_force()
 *
 * Run       make lesson-13; make lesson-13 ARGS=-h lists its options
 * PREDICT 1 fraction of the spin left at t = 1, --scene spin: ...
 * PREDICT 2 least n whose first step fails, --scene rigid: ...
 * PREDICT 3 times the steps, for a tenth of the error in the energy: ...
 * Plot: steps t elastic
 */
#include "plane/history.h"
#include "base/options.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CAP = 30 }; /* linear systems per time step */

/* out += M v over all vertices: a triangle adds rho int N_a N_b to M_ab or,
 * LUMPED, the row sums of that to the diagonal (2.20). */
static void add_mass(const struct body *body, const double v[], double out[])
{
    /* SLOT 13a(body, v, out): triangle by triangle; body->rho, body->area[e],
     * body->mass, and body->mesh->triangle for the three vertices. */
    /* consistent: [eq:overlap] */
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const int *t = &body->mesh->triangle[3 * e];
        const double m = body->rho * body->area[e];
        for (int a = 0; a < 3; a++)
            for (int c = 0; c < 3; c++) {
                /* M_ac = m (1 + delta_ac) / 12; a row has the sum m / 3 */
                double M_ac = a == c ? m / 6.0 : m / 12.0;
                if (body->mass == LUMPED) M_ac = a == c ? m / 3.0 : 0.0;
                for (int i = 0; i < 2; i++)
                    out[2 * t[a] + i] += M_ac * v[2 * t[c] + i];
            }
    }
    /* END 13a */
}

/*
 * Given the state u0, v0 before the step, return b (2.18b) at all vertices, for
 * the constant body force s->density (N/m^2) and the constant s->traction (N/m)
 * on the right end, whose edge j, 0 <= j < n, joins the vertices
 * j (n + 1) + n and (j + 1) (n + 1) + n.  The edges may be of any length and
 * lean, and what s->f holds does not count.
 */
static void right_hand_side(const struct scene *s, double dt,
                            const double u0[], const double v0[], double b[])
{
    double *w = allocate((size_t)s->n_dof, sizeof *w);
    /* SLOT 13b(s, dt, u0, v0, w, b, add_mass): what add_mass() is to multiply
     * goes into w; then triangle by triangle, then edge by edge. */
    /* [eq:body-b]: M (u0 + dt v0), where they go if nothing acts on them */
    for (int r = 0; r < s->n_dof; r++) {
        w[r] = u0[r] + dt * v0[r];
        b[r] = 0.0;
    }
    add_mass(s->body, w, b);
    /* dt^2 f int N_a: a third of the area is each vertex's */
    for (int e = 0; e < s->mesh->n_triangle; e++)
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++)
                b[2 * s->mesh->triangle[3 * e + a] + i] +=
                    dt * dt * s->body->area[e] / 3.0 * s->density[i];
    const double *X = s->mesh->X;
    const int n = s->mesh->n;
    for (int j = 0; j < n; j++) {
        const int A = 2 * (j * (n + 1) + n), B = A + 2 * (n + 1);
        /* dt^2 t int N_a ds: half of the edge is each end's */
        const double half = 0.5 * hypot(X[B] - X[A], X[B + 1] - X[A + 1]);
        for (int i = 0; i < 2; i++) {
            b[A + i] += dt * dt * half * s->traction[i];
            b[B + i] += dt * dt * half * s->traction[i];
        }
    }
    /* END 13b */
    free(w);
}

/* Given u and b, return q of all vertices (at a held one it is what holds it,
 * times dt^2) and A = dq/du of the free unknowns (2.23).  INVERTED where the
 * material is not defined; q and A are then incomplete. */
static enum status equation(const struct body *body, double dt,
                            const double u[], const double b[], double q[],
                            struct matrix *A)
{
    struct matrix *K = body_matrix(body);
    enum status status = OK;
    /* SLOT 13c(body, dt, u, b, q, A, K, &status): dPsi/du by body_force(), K by
     * body_stiffness(), M by body_mass_matrix(); then matrix_combine(). */
    /* q = M u + dt^2 dPsi/du - b */
    status = body_force(body, u, q);
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++)
        q[r] = dt * dt * q[r] - b[r];
    add_mass(body, u, q);
    /* A = M + dt^2 K */
    if (status == OK) status = body_stiffness(body, u, EXACT, K);
    body_mass_matrix(body, A);
    matrix_combine(A, dt * dt, K, A);
    /* END 13c */
    matrix_free(K);
    return status;
}

/*
 * One step of backward Euler [alg:step], by Newton's method from s->u (lifted:
 * [eq:lift-2d]) with s->g at the held vertices.  Done: max|q| of the
 * free vertices <= tolerance weight, and in the iteration before max|du| <=
 * tolerance (m); so there is at least one, even where q is 0 to begin with.
 * Then v = (u_new - u) / dt at every vertex, and u = u_new [eq:backward-euler].
 * NONFINITE: q or du is not finite; MAX_ITERATIONS: not done after cap systems.
 * Unless the status is OK, s->u, s->v and s->steps stay as they were.
 * New since 12e: b comes from the state before the step, and the end makes v.
 */
static struct history step(struct scene *s, double tolerance, int cap,
                           int lift)
{
    const double dt = s->set.dt, h = 2.0 / s->mesh->n;
    const double weight = /* of 1 m in q: the size of an entry of A */
        s->body->rho * h * h + dt * dt * material_modulus(&s->body->material);
    const size_t n_dof = (size_t)s->n_dof;
    struct history report = {.status = MAX_ITERATIONS};
    struct matrix *A = body_matrix(s->body);
    double *next = allocate(n_dof, sizeof *next);
    double *b = allocate(n_dof, sizeof *b);
    double *q = allocate(n_dof, sizeof *q);
    double *du = allocate(n_dof, sizeof *du);
    memcpy(next, s->u, n_dof * sizeof *next);
    if (lift) step_boundary(s->body, s->g, 1, next);
    /* SLOT 13d(s, tolerance, cap, dt, weight, &report, A, next, b, q, du,
     * right_hand_side, equation): write s->g into next; then the loop, which
     * fills report (history.h) on its way: body_increment() for du,
     * body_max_free() for the size of q and du; then s->v and s->u. */
    right_hand_side(s, dt, s->u, s->v, b);
    /* Held vertices jump to g at once; from there on their du is 0. */
    for (size_t r = 0; r < n_dof; r++)
        if (s->held[r / 2]) next[r] = s->g[r];
    for (;;) {
        const int k = report.iterations;
        /* The status is set before each test: a break leaves the reason. */
        report.status = equation(s->body, dt, next, b, q, A);
        if (report.status != OK) break;
        report.residual[k] = body_max_free(s->body, q);
        report.status = NONFINITE;
        if (!isfinite(report.residual[k])) break;
        report.status = OK;
        if (k > 0 && report.increment[k - 1] <= tolerance &&
            report.residual[k] <= tolerance * weight)
            break;
        report.status = MAX_ITERATIONS;
        if (k == cap) break;
        /* A du = -q at the free vertices */
        report.status = body_increment(s->body, A, q, du);
        if (report.status != OK) break;
        report.increment[k] = body_max_free(s->body, du);
        report.status = NONFINITE;
        if (!isfinite(report.increment[k])) break;
        for (size_t r = 0; r < n_dof; r++) next[r] += du[r];
        report.iterations++;
    }
    if (report.status == OK)
        for (size_t r = 0; r < n_dof; r++) {
            s->v[r] = (next[r] - s->u[r]) / dt;
            s->u[r] = next[r];
        }
    /* END 13d */
    s->steps += report.status == OK;
    matrix_free(A);
    free(du);
    free(q);
    free(b);
    free(next);
    return report;
}

/* A row of `steps`; the centre is the vertex at (0, 0), or at (-1/n, -1/n). */
static void print_state(const struct scene *s, int iterations)
{
    const struct scene_measures m = scene_measure(s);
    const int n = s->mesh->n, centre = n / 2 * (n + 1) + n / 2;
    table_row(s->steps * s->set.dt, iterations, m.kinetic, m.elastic,
              m.external, m.kinetic + m.elastic + m.external, m.momentum[0],
              m.momentum[1], m.angular, m.min_J, s->u[2 * centre],
              s->u[2 * centre + 1]);
}

int main(int argc, char *argv[])
{
    int reading = STRETCH, law = 1, mass = CONSISTENT, lift = 0, steps = 30;
    struct scene_setting set = scene_notes(STRETCH, CUBIC, 8);
    const struct option options[] = {
        {"scene", .choice = &reading, .choices = SCENES, .help = "see scene.h"},
        {"law", .choice = &law, .choices = "log cubic", .help = "r"},
        {"n", .integer = &set.n, .min = 2, .max = 60, .help = "n x n squares"},
        {"steps", .integer = &steps, .min = 1, .max = 1000, .help = "how many"},
        {"dt", .real = &set.dt, .min = 1e-6, .max = 10, .unit = "s",
         .help = "time step"},
        {"mass", .choice = &mass, .choices = "consistent lumped", .help = "M"},
        {"guess", .choice = &lift, .choices = "last lifted", .help = "start"},
        {"reach", .real = &set.reach, .min = -20, .max = 20, .unit = "m",
         .help = "amplitude of the moving ends"},
    };
    options_parse("13_backward_euler_2d", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();

    set.reading = (enum reading)reading;
    set.law = law ? CUBIC : LOG;
    set.mass = (enum mass)mass;
    struct scene *s = scene_alloc(&set);
    struct history report = {.status = OK}, shown = report;

    table_begin("steps", "t iterations kinetic elastic external total "
                "momentum_x momentum_y angular min_J centre_x centre_y");
    print_state(s, 0);
    while (report.status == OK && s->steps < steps) {
        scene_hold(s, (s->steps + 1) * set.dt);
        report = step(s, 1e-10, CAP, lift);
        if (s->steps <= 1 || report.status != OK) shown = report;
        if (report.status == OK) print_state(s, report.iterations);
    }
    table_end();
    history_table("newton", &shown);
    history_nodes(s, "v", s->v);
    if (report.status != OK)
        die("step %d, t = %g: Newton's method ends with %s after %d iterations",
            s->steps + 1, (s->steps + 1) * set.dt, status_name(report.status),
            report.iterations);
    scene_free(s);
    return table_finish();
}
