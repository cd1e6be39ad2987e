/*
 * robustness.c - where the implicit time step of step.h fails, and what helps.
 *
 * The body of the notes' example: the square (-1,1)^2 of linear triangles, E =
 * 1000, nu = 0.3, rho = 1, both ends X1 = -1, 1 prescribed, dt = 1/30.  Three
 * things are done to it: both ends are shaken, u = (sin t, 0); they are pushed
 * together, u = (-X1 sin t, 0); all free vertices are scattered at random.
 *
 * The tables hold counts, reasons (the numbers of enum status) and errors, no
 * seconds.  A reason is never hidden: a run that ends otherwise than OK has its
 * row.  What comes after a blow-up (which of NOT_SPD, NONFINITE, after how many
 * iterations) is round-off and may differ between machines; that it blows up
 * does not.
 *
 *     build/bench/robustness
 */
#include "options.h"
#include "step.h"
#include "table.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- methods and scenes -------------------------------------------------- */

/* Tolerance 1e-10 m; new factors in each iteration, so that counts compare. */
#define METHOD(cap, guess, lift, search, project) \
    {1e-10, cap, guess, lift, 0, search, project}

enum method { PLAIN, LIFTED, SEARCH, PROJECT, ON_NEED, ALL, METHODS };
static const char *const method_name[METHODS] = {
    "plain", "lift", "search", "always", "demand", "all"};
static const struct step_control method[METHODS] = {
    [PLAIN] = METHOD(30, FROM_LAST, 0, 0, NEVER), /* as the notes have it */
    [LIFTED] = METHOD(30, EXTRAPOLATED, 1, 0, NEVER),
    [SEARCH] = METHOD(30, EXTRAPOLATED, 1, 1, NEVER),
    [PROJECT] = METHOD(2000, FROM_LAST, 0, 1, ALWAYS),
    [ON_NEED] = METHOD(2000, FROM_LAST, 0, 1, ON_DEMAND),
    [ALL] = METHOD(300, EXTRAPOLATED, 1, 1, ON_DEMAND),
};

/* From a bad start, nothing lifted: plain; line search; projection on demand;
 * both; always projecting and line search.  Plain runs that have not converged
 * after 40 iterations hardly ever do. */
enum { WAYS = 5 };
static const struct step_control way[WAYS] = {
    METHOD(40, FROM_LAST, 0, 0, NEVER), METHOD(300, FROM_LAST, 0, 1, NEVER),
    METHOD(100, FROM_LAST, 0, 0, ON_DEMAND),
    METHOD(300, FROM_LAST, 0, 1, ON_DEMAND),
    METHOD(1000, FROM_LAST, 0, 1, ALWAYS)};

enum scene_kind { SHAKE, PRESS };

struct scene {
    struct mesh *mesh;
    struct body *body;
    int n_dof;
    double *u, *v, *v_before, *g, *w;
};

static struct scene scene_alloc(int n, enum law law, double nu, double rho,
                                int right_end_too)
{
    struct scene s = {.mesh = mesh_square(n)};
    int *fixed = allocate((size_t)s.mesh->n_vertex, sizeof *fixed);
    for (int j = 0; j <= n; j++) {
        fixed[j * (n + 1)] = 1;
        fixed[j * (n + 1) + n] = right_end_too;
    }
    s.n_dof = 2 * s.mesh->n_vertex;
    s.body = body_alloc(s.mesh, material_make(law, 1000.0, nu), rho, CONSISTENT,
                        fixed);
    s.u = allocate(5 * (size_t)s.n_dof, sizeof *s.u);
    s.v = s.u + s.n_dof;
    s.v_before = s.v + s.n_dof;
    s.g = s.v_before + s.n_dof;
    s.w = s.g + s.n_dof;
    free(fixed);
    return s;
}

static void scene_free(struct scene *s)
{
    free(s->u);
    body_free(s->body);
    mesh_free(s->mesh);
}

/* One step of length dt from t; the state stays when it fails. */
static struct step_report scene_step(struct scene *s, enum scene_kind kind,
                                     const struct step_control *control,
                                     double t, double dt)
{
    for (int a = 0; a < s->mesh->n_vertex; a++)
        s->g[2 * a] = sin(t + dt) * (kind == SHAKE ? 1.0 : -s->mesh->X[2 * a]);
    return step_backward_euler(s->body, control, dt, s->g, NULL, s->u, s->v,
                               s->v_before);
}

/* ---- the first step: a jump of the boundary of dg / h -------------------- */

/*
 * All from rest.  plain; lift; line search alone; projection on demand alone;
 * and all of them.  From rest the three guesses are the same.
 */
enum { CURES = 5 };
static const struct step_control cure[CURES] = {
    METHOD(20, FROM_LAST, 0, 0, NEVER), METHOD(30, FROM_LAST, 1, 0, NEVER),
    METHOD(30, FROM_LAST, 0, 1, NEVER), METHOD(30, FROM_LAST, 0, 0, ON_DEMAND),
    METHOD(30, FROM_LAST, 1, 1, ON_DEMAND)};

/* One step of the shake from rest. */
static struct step_report first_step(int n, enum law law, double dt,
                                     const struct step_control *control)
{
    struct scene s = scene_alloc(n, law, 0.3, 1.0, 1);
    const struct step_report report = scene_step(&s, SHAKE, control, 0.0, dt);
    scene_free(&s);
    return report;
}

static void print_first_step(const char *name, enum law law)
{
    const int size[] = {8, 16, 32, 40, 50, 54, 56, 60, 64};
    table_begin_note(name,
                     "n jump plain plain_iterations lift lift_iterations "
                     "search search_iterations demand demand_iterations "
                     "all all_iterations",
                     "dt = 1/30, both ends shifted by sin dt from rest; jump = "
                     "sin dt / h; reasons, and iterations where it is OK");
    for (int k = 0; k < COUNT(size); k++) {
        double row[2 + 2 * CURES] = {size[k], sin(1.0 / 30.0) * size[k] / 2.0};
        for (int c = 0; c < CURES; c++) {
            const struct step_report report =
                first_step(size[k], law, 1.0 / 30.0, &cure[c]);
            row[2 + 2 * c] = report.status;
            row[3 + 2 * c] = report.status == OK ? report.iterations : 0;
        }
        table_row_of(COUNT(row), row);
    }
    table_end();
}

/*
 * Newton's method of one step, iteration by iteration: it has no memory, and k
 * runs of one iteration are one of k.  Rows until it has converged or left the
 * numbers; increment 0: none yet.
 */
static void print_history(const char *name, int n,
                          const struct step_control *control)
{
    const double dt = 1.0 / 30.0;
    struct scene s = scene_alloc(n, CUBIC, 0.3, 1.0, 1);
    struct step_control one = *control;
    struct step_report report = {.increment = INFINITY};
    for (int a = 0; a < s.mesh->n_vertex; a++) s.g[2 * a] = sin(dt);
    step_boundary(s.body, s.g, control->lift, s.u);
    table_begin_note(name, "iteration increment residual min_J",
                     "n = %d, cubic law; residual: max|q| / max K_ii (m)", n);
    for (int k = 0; k <= 12; k++) {
        one.max_iterations = k > 0;
        report = step_solve(s.body, &one, dt, s.w, NULL, s.u);
        const double least = body_min_J(s.body, s.u);
        if (!isfinite(report.residual) || !isfinite(least)) break;
        if (report.status != MAX_ITERATIONS) break;
        table_row(k, k == 0 ? 0.0 : report.increment, report.residual, least);
        if (report.increment < one.tolerance) break;
    }
    table_end();
    scene_free(&s);
}

/* The triangles at the left end in three starts, in units of h from the
 * corner, and their J: a jump of 0.5 and 1.2 without lift, 1.2 with. */
static void print_starts(void)
{
    const struct {
        double jump;
        int lift;
    } start[] = {{0.5, 0}, {1.2, 0}, {1.2, 1}};
    const int n = 8;
    const double h = 2.0 / n;
    table_begin_note("starts", "start jump lift x0 y0 x1 y1 x2 y2 J",
                     "corner of n = %d at the start of Newton's method", n);
    for (int k = 0; k < COUNT(start); k++) {
        struct scene s = scene_alloc(n, CUBIC, 0.3, 1.0, 1);
        for (int r = 0; r < s.n_dof; r += 2) s.g[r] = start[k].jump * h;
        step_boundary(s.body, s.g, start[k].lift, s.u);
        for (int e = 0; e < s.mesh->n_triangle; e++) {
            if (e / 2 % n >= 3 || e / 2 / n >= 3) continue;
            double x[6];
            for (int r = 0; r < 6; r++) {
                const int dof = 2 * s.mesh->triangle[3 * e + r / 2] + r % 2;
                x[r] = (1.0 + s.mesh->X[dof] + s.u[dof]) / h;
            }
            table_row(k, start[k].jump, start[k].lift, x[0], x[1], x[2], x[3],
                      x[4], x[5],
                      (x[2] - x[0]) * (x[5] - x[1]) -
                          (x[4] - x[0]) * (x[3] - x[1]));
        }
        scene_free(&s);
    }
    table_end();
}

/* ---- maps over dt and n -------------------------------------------------- */

static void print_map(const char *name, enum law law,
                      const struct step_control *control)
{
    const int size[] = {4, 6, 8, 11, 16, 23, 32};
    enum { STEPS = 36 };
    table_begin_note(name, "n dt jump reason iterations",
                     "one step of the shake from rest, %s law",
                     law == CUBIC ? "cubic" : "log");
    for (int k = 0; k < COUNT(size); k++)
        for (int i = 0; i < STEPS; i++) {
            const double dt = pow(480.0, (double)i / (STEPS - 1) - 1.0);
            const struct step_report report =
                first_step(size[k], law, dt, control);
            table_row(size[k], dt, sin(dt) * size[k] / 2.0, report.status,
                      report.iterations);
        }
    table_end();
}

/* Whether the plain step from rest with this jump converges. */
static int step_converges(int n, enum law law, double jump)
{
    return first_step(n, law, asin(jump * 2.0 / n), &cure[0]).status == OK;
}

/* Whether K at its start is positive definite (and exists). */
static int start_is_spd(int n, enum law law, double jump)
{
    struct scene s = scene_alloc(n, law, 0.3, 1.0, 1);
    double *q = s.w;
    for (int r = 0; r < s.n_dof; r += 2) s.g[r] = jump * 2.0 / n;
    step_boundary(s.body, s.g, 0, s.u);
    const int spd = body_assemble(s.body, asin(jump * 2.0 / n), s.v, NULL, s.u,
                                  EXACT, q) == OK &&
                    matrix_factor(s.body->K) == OK;
    scene_free(&s);
    return spd;
}

/* The jump at which `holds` ends, by bisection between 0.5, where it does, and
 * 1.1, where it does not; near the end of convergence both alternate. */
static double threshold(int n, enum law law,
                        int (*holds)(int n, enum law law, double jump))
{
    double good = 0.5, bad = 1.1;
    while (bad - good > 0.002) {
        const double jump = 0.5 * (good + bad);
        if (holds(n, law, jump))
            good = jump;
        else
            bad = jump;
    }
    return good;
}

static void print_boundary_step(void)
{
    table_begin_note("boundary_step", "n cubic log cubic_spd log_spd",
                     "jump dg / h at which the plain step begins to fail; at "
                     "which K at its start is no longer SPD");
    for (int n = 8; n <= 32; n *= 2)
        table_row(n, threshold(n, CUBIC, step_converges),
                  threshold(n, LOG, step_converges),
                  threshold(n, CUBIC, start_is_spd),
                  threshold(n, LOG, start_is_spd));
    table_end();
}

/* ---- compression --------------------------------------------------------- */

/*
 * Whole run: 60 steps of dt = 1/30, or until a step fails.
 *
 * With halve a step that has failed is tried again in two halves, these in
 * quarters, and so on, to dt / 2^4: the last thing to try before giving up.
 */
struct run {
    double t;           /* reached (s) */
    double pressed;     /* the largest sin t reached */
    enum status reason; /* of the first step that failed for good, or OK */
    int steps, failed;  /* of dt or a part of it; attempts that failed */
    int iterations, most, projections;
    int useful;     /* iterations of the steps that did not fail */
    double least_J; /* of all states */
};

static void run_step(struct scene *s, const struct step_control *control,
                     int halve, double dt, struct run *run)
{
    const struct step_report report =
        scene_step(s, PRESS, control, run->t, dt);
    run->iterations += report.iterations;
    run->projections += report.projections;
    if (report.iterations > run->most) run->most = report.iterations;
    run->reason = report.status;
    if (report.status == OK) {
        run->t += dt;
        run->steps++;
        run->useful += report.iterations;
        run->pressed = fmax(run->pressed, sin(run->t));
        run->least_J = fmin(run->least_J, body_min_J(s->body, s->u));
        return;
    }
    run->failed++;
    for (int part = 0; part < 2 && halve > 0; part++) {
        run_step(s, control, halve - 1, dt / 2.0, run);
        if (run->reason != OK) return;
    }
}

enum { FRAMES = 60 };
static struct run press(int n, enum law law, const struct step_control *control,
                        int halve, double min_J[FRAMES], int cost[FRAMES])
{
    struct scene s = scene_alloc(n, law, 0.3, 1.0, 1);
    struct run run = {.least_J = 1.0};
    for (int k = 0; k < FRAMES; k++) cost[k] = 0;
    for (int k = 0; k < FRAMES && run.reason == OK; k++) {
        const int before = run.iterations;
        run_step(&s, control, halve, 1.0 / 30.0, &run);
        cost[k] = run.iterations - before;
        min_J[k] = body_min_J(s.body, s.u);
    }
    scene_free(&s);
    return run;
}

static void print_press(const char *name, enum law law)
{
    double min_J[FRAMES];
    int cost[FRAMES];
    table_begin_note(name,
                     "n method time pressed reason steps failed iterations "
                     "most projections least_J final_J per_step",
                     "methods: 0 plain, 1 lift, 2 + line search, 3 always "
                     "projecting, 4 on demand, 5 all, 6 all and halving; 3 not "
                     "run at n = 16");
    for (int n = 4; n <= 16; n *= 2)
        for (int m = 0; m <= METHODS; m++) {
            if (n == 16 && m == PROJECT) continue; /* seconds */
            const int halve = m == METHODS ? 4 : 0;
            const struct run run =
                press(n, law, &method[m == METHODS ? ALL : m], halve, min_J,
                      cost);
            int last = 0;
            while (last + 1 < FRAMES && cost[last + 1] > 0) last++;
            table_row(n, m, run.t, run.pressed, run.reason, run.steps,
                      run.failed, run.iterations, run.most, run.projections,
                      run.least_J, min_J[last],
                      (double)run.useful / run.steps);
        }
    table_end();
}

/* Step by step: iterations, and the least J after it; alive 0: the run ended
 * before or in this step. */
static void print_press_path(const char *name, enum law law, int n,
                             enum method m, int halve)
{
    double min_J[FRAMES] = {0.0};
    int cost[FRAMES];
    const struct run run = press(n, law, &method[m], halve, min_J, cost);
    table_begin_note(name, "t pressed iterations min_J reason",
                     "%s law, n = %d, %s%s",
                     law == CUBIC ? "cubic" : "log", n, method_name[m],
                     halve ? " and halving" : "");
    for (int k = 0; k < FRAMES && (k == 0 || cost[k - 1] > 0); k++) {
        const double t = (k + 1) / 30.0;
        const int alive = t < run.t + 1e-9;
        table_row(t, sin(t), cost[k], min_J[k], alive ? OK : run.reason);
        if (!alive) break;
    }
    table_end();
}

/* Phi [eq:incremental-potential] of a step of length dt to u from speed and
 * state in w = u0 + dt v0; work: [2 n_dof]. */
static double potential(const struct body *body, double dt, const double w[],
                        const double u[], int n_dof, double work[])
{
    double phi = 0.0, elastic;
    for (int r = 0; r < n_dof; r++) work[r] = u[r] - w[r];
    body_mass(body, work, work + n_dof);
    for (int r = 0; r < n_dof; r++) phi += 0.5 * work[r] * work[n_dof + r];
    if (body_energy(body, u, &elastic) != OK) elastic = 0.0;
    return phi + dt * dt * elastic;
}

/*
 * The last step that the plain run with n = 8 survives: its answer and that of
 * projection on demand, from the same state.  spd: is K there, the curvature of
 * Phi, positive definite?
 */
static void print_two_answers(void)
{
    const double dt = 1.0 / 30.0;
    const int n = 8, last = 22;
    struct scene s = scene_alloc(n, CUBIC, 0.3, 1.0, 1);
    double *state = allocate(4 * (size_t)s.n_dof, sizeof *state);
    double *work = state + 2 * s.n_dof;
    table_begin_note("two_answers",
                     "way reason iterations indefinite projections phi min_J "
                     "spd",
                     "n = %d, cubic law, step %d; ways: 0 plain, 1 on demand "
                     "and line search; phi in units of dt^2",
                     n, last);
    for (int k = 1; k < last; k++)
        scene_step(&s, PRESS, &method[PLAIN], (k - 1) * dt, dt);
    memcpy(state, s.u, 2 * (size_t)s.n_dof * sizeof *state); /* u and v */
    for (int m = 0; m < 2; m++) {
        memcpy(s.u, state, 2 * (size_t)s.n_dof * sizeof *state);
        const struct step_report report = scene_step(
            &s, PRESS, &method[m ? ON_NEED : PLAIN], (last - 1) * dt, dt);
        for (int r = 0; r < s.n_dof; r++)
            s.w[r] = state[r] + dt * state[s.n_dof + r];
        const double phi =
            potential(s.body, dt, s.w, s.u, s.n_dof, work) / (dt * dt);
        body_assemble(s.body, dt, s.w, NULL, s.u, EXACT, work);
        table_row(m, report.status, report.iterations, report.indefinite,
                  report.projections, phi, body_min_J(s.body, s.u),
                  matrix_factor(s.body->K) == OK);
    }
    table_end();
    free(state);
    scene_free(&s);
}

/* ---- locking: the first Newton increment is linear elasticity ------------ */

/* Vertical displacement of the vertex (1,0), clamped at X1 = -1, body force
 * (0,-1) per area: K at rest, one solve. */
static double droop(int n, double nu)
{
    struct scene s = scene_alloc(n, CUBIC, nu, 0.0, 0);
    double *f = s.g; /* not used otherwise */
    for (int e = 0; e < s.mesh->n_triangle; e++)
        for (int a = 0; a < 3; a++)
            f[2 * s.mesh->triangle[3 * e + a] + 1] -= s.body->area[e] / 3.0;
    const struct step_control one = METHOD(1, FROM_LAST, 0, 0, NEVER);
    step_solve(s.body, &one, 1.0, s.w, f, s.u);
    const double down = s.u[2 * (n / 2 * (n + 1) + n) + 1];
    scene_free(&s);
    return down;
}

static void print_locking(void)
{
    /* Source: an independent computation with bilinear quadrilaterals whose
     * volume change is integrated at one point, 64 x 64. */
    const double nu[3] = {0.3, 0.49, 0.4999};
    const double reference[3] = {-0.01117176656958354, -0.010553785978897308,
                                 -0.010491906134727268};
    table_begin_note("locking",
                     "n u_0.3 u_0.49 u_0.4999 error_0.3 error_0.49 "
                     "error_0.4999",
                     "u of the vertex (1,0) downwards (m); error: 1 - u / "
                     "reference");
    for (int n = 4; n <= 64; n *= 2) {
        double u[3];
        for (int k = 0; k < 3; k++) u[k] = droop(n, nu[k]);
        table_row(n, u[0], u[1], u[2], 1.0 - u[0] / reference[0],
                  1.0 - u[1] / reference[1], 1.0 - u[2] / reference[2]);
    }
    table_end();
}

/* ---- random starts ------------------------------------------------------- */

enum { SEEDS = 1000 };

struct start {
    int both_ends;    /* held, or the left one only */
    double amplitude; /* of every component of u, in units of h */
};

/* Where the runs of one way ended. */
struct census {
    int rest, stable, saddle;      /* OK: at u = 0; elsewhere, K SPD; not SPD */
    int ended[MAX_ITERATIONS + 1]; /* by reason */
    int n_ok;
    double iterations[SEEDS]; /* [n_ok] */
    double inverted, least_J; /* mean part of the starts; of all results */
};

static void scatter(struct scene *s, gsl_rng *rng, int seed, double amplitude)
{
    gsl_rng_set(rng, (unsigned long)seed);
    for (int r = 0; r < s->n_dof; r++)
        s->u[r] = s->body->equation[r] < 0
                      ? 0.0
                      : amplitude * (2.0 * gsl_rng_uniform(rng) - 1.0);
    memcpy(s->w, s->u, (size_t)s->n_dof * sizeof *s->u);
}

static double max_abs(const double v[], int n)
{
    double largest = 0.0;
    for (int i = 0; i < n; i++) largest = fmax(largest, fabs(v[i]));
    return largest;
}

/* Corners of triangle e after the deformation, and J. */
static double corners(const struct scene *s, int e, double x[6])
{
    for (int r = 0; r < 6; r++) {
        const int dof = 2 * s->mesh->triangle[3 * e + r / 2] + r % 2;
        x[r] = s->mesh->X[dof] + s->u[dof];
    }
    return ((x[2] - x[0]) * (x[5] - x[1]) - (x[4] - x[0]) * (x[3] - x[1])) /
           (2.0 * s->body->area[e]);
}

/* Part of the triangles that are inverted. */
static double inverted_part(const struct scene *s)
{
    double x[6], inverted = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++)
        inverted += !(corners(s, e, x) > 0.0);
    return inverted / s->mesh->n_triangle;
}

static void take_census(const struct start *start, int m,
                        struct census *census)
{
    const int n = 4;
    struct scene s = scene_alloc(n, CUBIC, 0.3, 0.0, start->both_ends);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    memset(census, 0, sizeof *census);
    census->least_J = 1.0;
    for (int seed = 1; seed <= SEEDS; seed++) {
        scatter(&s, rng, seed, start->amplitude * 2.0 / n);
        census->inverted += inverted_part(&s) / SEEDS;
        const struct step_report report =
            step_solve(s.body, &way[m], 1.0, s.w, NULL, s.u);
        census->ended[report.status]++;
        if (report.status != OK) continue;
        census->iterations[census->n_ok++] = report.iterations;
        census->least_J = fmin(census->least_J, body_min_J(s.body, s.u));
        body_assemble(s.body, 1.0, s.w, NULL, s.u, EXACT, s.g);
        if (max_abs(s.u, s.n_dof) < 1e-6)
            census->rest++;
        else if (matrix_factor(s.body->K) == OK)
            census->stable++;
        else
            census->saddle++;
    }
    gsl_sort(census->iterations, 1, (size_t)census->n_ok);
    gsl_rng_free(rng);
    scene_free(&s);
}

static double quantile(const struct census *census, double part)
{
    if (census->n_ok == 0) return 0.0;
    return gsl_stats_quantile_from_sorted_data(census->iterations, 1,
                                               (size_t)census->n_ok, part);
}

static void print_scattered(void)
{
    const struct start start[] = {{1, 0.5}, {1, 1.0}, {1, 4.0}, {0, 1.0},
                                  {0, 4.0}};
    static struct census c;
    table_begin_note(
        "scattered",
        "both_ends amplitude way seeds inverted rest stable saddle not_spd "
        "nonfinite stalled max_iterations median p90 most least_J rest_part "
        "stable_part",
        "n = 4, cubic law; ways: 0 plain, 1 line search, 2 on demand, 3 and "
        "line search, 4 always projecting and line search");
    for (int k = 0; k < COUNT(start); k++)
        for (int m = 0; m < WAYS; m++) {
            take_census(&start[k], m, &c);
            table_row(start[k].both_ends, start[k].amplitude, m, SEEDS,
                      c.inverted, c.rest, c.stable, c.saddle,
                      c.ended[NOT_SPD], c.ended[NONFINITE], c.ended[STALLED],
                      c.ended[MAX_ITERATIONS], quantile(&c, 0.5),
                      quantile(&c, 0.9), quantile(&c, 1.0), c.least_J,
                      (double)c.rest / SEEDS,
                      (double)c.stable / SEEDS);
        }
    table_end();
}

/* An equilibrium that is not rest, and the start that led there. */
static void print_tangled(void)
{
    const int n = 4;
    struct scene s = scene_alloc(n, CUBIC, 0.3, 0.0, 0);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    int seed = 0;
    double x[6], y[6];
    struct step_report report = {.status = MAX_ITERATIONS};
    while (++seed <= SEEDS &&
           !(report.status == OK && max_abs(s.u, s.n_dof) > 0.1)) {
        scatter(&s, rng, seed, 4.0 * 2.0 / n);
        report = step_solve(s.body, &way[3], 1.0, s.w, NULL, s.u);
    }
    table_begin_note("tangled",
                     "X0 Y0 X1 Y1 X2 Y2 J_start x0 y0 x1 y1 x2 y2 J",
                     "held at the left, seed %d: start and equilibrium",
                     seed - 1);
    for (int e = 0; e < s.mesh->n_triangle; e++) {
        const double J = corners(&s, e, x);
        memcpy(s.g, s.u, (size_t)s.n_dof * sizeof *s.u);
        memcpy(s.u, s.w, (size_t)s.n_dof * sizeof *s.u);
        const double J_start = corners(&s, e, y);
        memcpy(s.u, s.g, (size_t)s.n_dof * sizeof *s.u);
        table_row(y[0], y[1], y[2], y[3], y[4], y[5], J_start, x[0], x[1], x[2],
                  x[3], x[4], x[5], J);
    }
    table_end();
    gsl_rng_free(rng);
    scene_free(&s);
}

int main(int argc, char *argv[])
{
    options_parse("robustness", NULL, 0, argc, argv);
    gsl_set_error_handler_off();
    print_first_step("first_step_cubic", CUBIC);
    print_first_step("first_step_log", LOG);
    print_history("history_plain", 56, &cure[0]);
    print_history("history_lift", 56, &cure[1]);
    print_history("history_demand", 56, &cure[3]);
    print_starts();
    print_map("map_plain", CUBIC, &cure[0]);
    print_map("map_plain_log", LOG, &cure[0]);
    print_map("map_demand", CUBIC, &way[3]);
    print_map("map_lift_log", LOG, &cure[1]);
    print_boundary_step();
    print_press("press_cubic", CUBIC);
    print_press("press_log", LOG);
    print_press_path("path_plain", CUBIC, 8, PLAIN, 0);
    print_press_path("path_always", CUBIC, 8, PROJECT, 0);
    print_press_path("path_demand", CUBIC, 8, ON_NEED, 0);
    print_press_path("path_log_plain", LOG, 8, PLAIN, 0);
    print_press_path("path_log_halved", LOG, 8, ALL, 4);
    print_two_answers();
    print_locking();
    print_scattered();
    print_tangled();
    return table_finish();
}
