/*
 * 09_linear_bar.c - the linearly elastic bar: its modulus, the signs of its
 * end loads, what has to hold it, and when it is enough.
 *
 * Notes: Lecture 1, 1D Elasticity; Lecture 2, (2.12b), for the end loads.
 *
 * Problem.  -P' = f on (0, L), P = (2 mu + lambda) u' [eq:bar-linear].  At each
 * end either u is given, or the traction h = P n with n the outward normal:
 *
 *        n = -1                                      n = +1
 *     h  <---|=========================================|--->  h
 *            0        body force f (N/m^3) -->         L
 *
 * A positive h pushes towards +X at either end, f does so inside, and each of
 * them enters b with a plus.  Linear elements on n equal lengths.  Then: how
 * wrong is this model at a given strain or load [eq:model-error], and what do
 * the nonlinear ones cost?  Unit cross-section, so that stresses are forces.
 *
 * Run       make lesson-09, or with options: -h lists them
 * Expect    E = 1000, nu = 0.3: modulus 1346.15; +100 at the end moves it by
 *           +0.0742857; linear elasticity is wrong by 1, 5, 10 % at a stretch
 *           of 1.08, 5.45, 11.0 %
 * Plot: nodes X u
 */
#include "bar.h"
#include "options.h"
#include "poisson.h"
#include "table.h"

#include <float.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdlib.h>

struct elastic {
    double mu, lambda; /* Lame parameters, N/m^2 */
    double modulus;    /* P / u' of a bar that cannot move sideways, N/m^2 */
};

enum end_kind { FREE, FIXED };
struct end {
    enum end_kind kind;
    double value; /* FIXED: the displacement u (m);
                   * FREE: the traction h = P n (N/m^2), often 0 */
};

enum shape { UNIFORM, COSINE };
struct scene {
    int n;           /* elements */
    double L;        /* length (m) */
    double modulus;  /* N/m^2 */
    enum shape shape;
    double c;        /* f = c or c cos(pi X / (2 L)), N/m^3 */
    struct end left, right;
};

/*
 * mu, lambda from Young's modulus E and Poisson's ratio nu [eq:lame], and the
 * modulus of uniaxial strain [eq:bar-linear].
 */
static struct elastic elastic_make(double E, double nu)
{
    struct elastic m = {0};
    /* SLOT 9a(E, nu, m): fill m.mu, m.lambda and m.modulus. */
    m.mu = E / (2.0 * (1.0 + nu));
    m.lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    m.modulus = 2.0 * m.mu + m.lambda;
    /* END 9a */
    return m;
}

/* The way back [eq:lame-inverse]. */
static void engineering_constants(const struct elastic *m, double *E,
                                  double *nu)
{
    *E = m->mu * (3.0 * m->lambda + 2.0 * m->mu) / (m->lambda + m->mu);
    *nu = m->lambda / (2.0 * (m->lambda + m->mu));
}

/* 2 mu - lambda, as the notes print it; what is only round-off is 0. */
static double printed_modulus(const struct elastic *m)
{
    const double value = 2.0 * m->mu - m->lambda;
    return fabs(value) <= 8.0 * DBL_EPSILON * (2.0 * m->mu + m->lambda)
               ? 0.0
               : value;
}

/* f(X), and its integrals from 0: F1 = int f, F2 = int F1. */
static double body_force(const struct scene *s, double X)
{
    return s->shape == UNIFORM ? s->c : s->c * cos(M_PI_2 * X / s->L);
}
static double body_force_1(const struct scene *s, double X)
{
    const double k = M_PI_2 / s->L;
    return s->shape == UNIFORM ? s->c * X : s->c * sin(k * X) / k;
}
static double body_force_2(const struct scene *s, double X)
{
    const double k = M_PI_2 / s->L, half = sin(0.5 * k * X);
    return s->shape == UNIFORM ? 0.5 * s->c * X * X
                               : 2.0 * s->c * half * half / (k * k);
}

/*
 * Stiffness matrix and loads, before any node is fixed [eq:bar-linear]:
 *
 *     K_ij = modulus int N_i' N_j' dX,
 *     b_i  = int f N_i dX + h N_i at the ends where h is given.
 *
 * K        out   order n + 1, half bandwidth 1
 * b        out   n + 1 nodal forces; int f N_i by the midpoint rule
 */
static void assemble(const struct scene *s, struct matrix *K, double b[])
{
    matrix_zero(K);
    for (int i = 0; i <= s->n; i++) b[i] = 0.0;
    /* SLOT 9b(s, K, b, body_force): add every element to K and to b, then the
     * tractions of the FREE ends to b. */
    const double h = s->L / s->n, k = s->modulus / h;
    for (int e = 0; e < s->n; e++) {
        const double half = 0.5 * h * body_force(s, (e + 0.5) * h);
        matrix_add(K, e, e, k);
        matrix_add(K, e, e + 1, -k);
        matrix_add(K, e + 1, e, -k);
        matrix_add(K, e + 1, e + 1, k);
        b[e] += half;
        b[e + 1] += half;
    }
    if (s->left.kind == FREE) b[0] += s->left.value;
    if (s->right.kind == FREE) b[s->n] += s->right.value;
    /* END 9b */
}

/*
 * Solve K u = b with the FIXED ends at their values; K and b are left alone.
 * With both ends FREE u is known up to a constant: the solution with u_0 = 0.
 *
 * OK            u is the solution
 * INCOMPATIBLE  both ends FREE and |sum b| > (n + 1) eps sum |b|: nothing
 *               holds the bar, and its loads do not balance; u is not set
 * NOT_SPD       the modulus is not positive; u is not set
 */
static enum status solve(const struct scene *s, const struct matrix *K,
                         const double b[], double u[])
{
    /* SLOT 9c(s, K, b, u): collect the FIXED ends; with none of them check the
     * balance of b and hold node 0 at 0.  Then matrix_copy, matrix_dirichlet,
     * matrix_factor, matrix_solve. */
    int node[2], n_fixed = 0;
    double value[2], sum = 0.0, scale = 0.0;

    if (s->left.kind == FIXED) {
        node[n_fixed] = 0;
        value[n_fixed++] = s->left.value;
    }
    if (s->right.kind == FIXED) {
        node[n_fixed] = s->n;
        value[n_fixed++] = s->right.value;
    }
    for (int i = 0; i <= s->n; i++) {
        sum += b[i];
        scale += fabs(b[i]);
    }
    if (n_fixed == 0) {
        if (!(fabs(sum) <= (s->n + 1) * DBL_EPSILON * scale))
            return INCOMPATIBLE;
        node[0] = 0;
        value[0] = 0.0;
        n_fixed = 1;
    }
    struct matrix *A = matrix_copy(K);
    double *x = allocate((size_t)s->n + 1, sizeof *x);
    for (int i = 0; i <= s->n; i++) x[i] = b[i];
    matrix_dirichlet(A, x, n_fixed, node, value, KEEP_DIAGONAL);
    const enum status status = matrix_factor(A);
    if (status == OK) matrix_solve(A, x);
    for (int i = 0; i <= s->n && status == OK; i++) u[i] = x[i];
    matrix_free(A);
    free(x);
    return status;
    /* END 9c */
}

/*
 * What the displacements say about forces.
 *
 * P         out  n stresses: P[e - 1] = modulus u' on element e = 1..n
 * reaction  out  the forces that the FIXED ends need, K u - b at node 0 and
 *                at node n [eq:reaction]; 0 at a FREE end
 */
static void stress_and_reactions(const struct scene *s, const double b[],
                                 const double u[], double P[],
                                 double reaction[2])
{
    /* SLOT 9d(s, b, u, P, reaction): the stresses first; the first and the
     * last row of K u are made of the first and the last of them. */
    const int n = s->n;
    for (int e = 1; e <= n; e++)
        P[e - 1] = s->modulus * (u[e] - u[e - 1]) * n / s->L;
    reaction[0] = -P[0] - b[0];
    reaction[1] = P[n - 1] - b[n];
    /* END 9d */
}

/* The exact P(X) = P0 - F1(X) and u(X) = u0 + (P0 X - F2(X)) / modulus. */
struct exact {
    double u0, P0;
};

static struct exact exact_make(const struct scene *s)
{
    const double F2 = body_force_2(s, s->L), M = s->modulus;
    struct exact x = {0.0, s->right.value + body_force_1(s, s->L)};

    if (s->left.kind == FIXED) x.u0 = s->left.value;
    if (s->left.kind == FREE) x.P0 = -s->left.value; /* n = -1 */
    if (s->right.kind == FIXED && s->left.kind == FIXED)
        x.P0 = (M * (s->right.value - x.u0) + F2) / s->L;
    else if (s->right.kind == FIXED)
        x.u0 = s->right.value - (x.P0 * s->L - F2) / M;
    return x;
}

static double exact_u(const struct scene *s, const struct exact *x, double X)
{
    return x->u0 + (x->P0 * X - body_force_2(s, X)) / s->modulus;
}

/* For the studies below, which all have a solution. */
static void must_be_ok(enum status status, const char *study)
{
    if (status != OK) die("%s: %s", status_name(status), study);
}

/* Assemble and solve: u[0..n]. */
static enum status displacements(const struct scene *s, double u[])
{
    struct matrix *K = matrix_alloc(BANDED, s->n + 1, 1);
    double *b = allocate((size_t)s->n + 1, sizeof *b);
    assemble(s, K, b);
    const enum status status = solve(s, K, b, u);
    matrix_free(K);
    free(b);
    return status;
}

/* The tables nodes, elements and balance of one scene; a scene without a
 * solution ends the program before anything is printed. */
static void print_scene(const struct scene *s)
{
    const int n = s->n;
    const size_t size = (size_t)n + 1;
    struct matrix *K = matrix_alloc(BANDED, n + 1, 1);
    double *b = allocate(size, sizeof *b), *u = allocate(size, sizeof *u);
    double *P = allocate(size, sizeof *P), reaction[2], sum = 0.0;

    assemble(s, K, b);
    const enum status status = solve(s, K, b, u);
    for (int i = 0; i <= n; i++) sum += b[i];
    if (status == INCOMPATIBLE)
        die("INCOMPATIBLE: no end is fixed and the loads add up to %g N, "
            "not 0", sum);
    if (status != OK)
        die("%s: the stiffness matrix is not positive definite, modulus %g",
            status_name(status), s->modulus);
    stress_and_reactions(s, b, u, P, reaction);

    const struct exact exact = exact_make(s);
    table_begin("nodes", "X b u exact");
    for (int i = 0; i <= n; i++) {
        const double X = s->L * i / n;
        table_row(X, b[i], u[i], exact_u(s, &exact, X));
    }
    table_end();
    table_begin("elements", "X P exact");
    for (int e = 1; e <= n; e++) {
        const double X = s->L * (e - 0.5) / n;
        table_row(X, P[e - 1], exact.P0 - body_force_1(s, X));
    }
    table_end();
    table_begin("balance", "loads reaction_left reaction_right");
    table_row(sum, reaction[0], reaction[1]);
    table_end();
    matrix_free(K);
    free(b);
    free(u);
    free(P);
}

/* The modulus over nu, in units of E, right and as printed. */
static void print_moduli(double E)
{
    table_begin("moduli", "nu mu lambda modulus printed E_back nu_back");
    for (int k = 0; k <= 49; k++) {
        const double nu = 0.01 * k;
        const struct elastic m = elastic_make(E, nu);
        double E_back, nu_back;
        engineering_constants(&m, &E_back, &nu_back);
        table_row(nu, m.mu / E, m.lambda / E, m.modulus / E,
                  printed_modulus(&m) / E, E_back / E, nu_back);
    }
    table_end();
}

/* A bar of length 1 with one end fixed and `load` at the other. */
static struct scene pulled(double modulus, int loaded_right, double load)
{
    struct scene s = {.n = 8, .L = 1.0, .modulus = modulus,
                      .left = {FIXED, 0.0}, .right = {FIXED, 0.0}};
    *(loaded_right ? &s.right : &s.left) = (struct end){FREE, load};
    return s;
}

/* What the printed modulus does to +load, for three nu [eq:bar-linear]. */
static void print_printed_modulus(double E, double load)
{
    const double nu[] = {0.3, 1.0 / 3.0, 0.4};
    double u[9];
    table_begin_note("printed_modulus",
                     "nu modulus printed u_end not_spd u_printed",
                     "u_printed is 0 where K is not positive definite");
    for (int k = 0; k < COUNT(nu); k++) {
        const struct elastic m = elastic_make(E, nu[k]);
        const struct scene right = pulled(m.modulus, 1, load);
        const struct scene printed = pulled(printed_modulus(&m), 1, load);
        must_be_ok(displacements(&right, u), "bar with the right modulus");
        const double u_end = u[8];
        const enum status status = displacements(&printed, u);
        table_row(nu[k], right.modulus, printed.modulus, u_end,
                  status == NOT_SPD, status == OK ? u[8] : 0.0);
    }
    table_end();
}

/* +load at either end, with its sign in b right and as printed. */
static void print_end_loads(double modulus, double load)
{
    double u[2][9];
    table_begin("end_loads", "end X u u_printed");
    for (int end = 0; end <= 1; end++) {
        for (int sign = 0; sign <= 1; sign++) {
            const struct scene s = pulled(modulus, end, sign ? -load : load);
            must_be_ok(displacements(&s, u[sign]), "bar with one end load");
        }
        for (int i = 0; i <= 8; i++)
            table_row(end, i / 8.0, u[0][i], u[1][i]);
    }
    table_end();
}

/* Rank of K with the rows and columns of the FIXED ends struck out. */
static int rank_of_free_block(const struct scene *s, const struct matrix *K)
{
    const int first = s->left.kind == FIXED;
    const size_t N = (size_t)(s->n + 1 - first - (s->right.kind == FIXED));
    gsl_matrix *A = gsl_matrix_alloc(N, N);
    gsl_vector *value = gsl_vector_alloc(N);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(N);
    int rank = 0;

    for (size_t i = 0; i < N; i++)
        for (size_t j = 0; j < N; j++)
            gsl_matrix_set(A, i, j,
                           matrix_get(K, first + (int)i, first + (int)j));
    gsl_eigen_symm(A, value, work);
    for (size_t i = 0; i < N; i++)
        rank += gsl_vector_get(value, i) >
                (double)N * DBL_EPSILON * gsl_vector_max(value);
    gsl_eigen_symm_free(work);
    gsl_vector_free(value);
    gsl_matrix_free(A);
    return rank;
}

/* Which end conditions leave K singular, and when that has a solution. */
static void print_end_conditions(double modulus)
{
    static const struct {
        enum end_kind left, right;
        double pull; /* at the right end, where it is free */
    } cases[] = {{FIXED, FIXED, 0},    {FIXED, FREE, 100}, {FREE, FIXED, 0},
                 {FREE, FREE, 100}, {FREE, FREE, -50}};
    enum { n = 8 };
    struct matrix *K = matrix_alloc(BANDED, n + 1, 1);
    table_begin_note("end_conditions",
                     "left_fixed right_fixed pull loads unknowns rank status",
                     "body force 50; status 0 OK, 1 NOT_SPD, 2 INCOMPATIBLE");
    for (int k = 0; k < COUNT(cases); k++) {
        const struct scene s = {
            .n = n, .L = 1.0, .modulus = modulus, .c = 50.0,
            .left = {cases[k].left, 0.0},
            .right = {cases[k].right, cases[k].pull}};
        double b[n + 1], u[n + 1], loads = 0.0;
        assemble(&s, K, b);
        for (int i = 0; i <= n; i++) loads += b[i];
        table_row(cases[k].left == FIXED, cases[k].right == FIXED,
                  cases[k].pull, loads,
                  n + 1 - (cases[k].left == FIXED) - (cases[k].right == FIXED),
                  rank_of_free_block(&s, K), solve(&s, K, b, u));
    }
    table_end();
    matrix_free(K);
}

/* The cosine load in units where modulus, load and length are 1. */
static double one(double x) { return 1.0 + 0.0 * x; }
static double cosine(double x) { return cos(M_PI_2 * x); }
static double cosine_u(double x)
{
    const double half = sin(0.25 * M_PI * x);
    return x / M_PI_2 - 2.0 * half * half / (M_PI_2 * M_PI_2);
}
static double cosine_u_dx(double x)
{
    return (1.0 - sin(M_PI_2 * x)) / M_PI_2;
}

/* b_i = int f N_i in closed form, by parts: F1 at the node, F2 beside it. */
static void exact_loads(const struct scene *s, double b[])
{
    const double h = s->L / s->n;
    for (int i = 0; i <= s->n; i++) b[i] = 0.0;
    for (int e = 0; e < s->n; e++) {
        const double X0 = e * h, X1 = (e + 1) * h;
        const double mean =
            (body_force_2(s, X1) - body_force_2(s, X0)) / h;
        b[e] += mean - body_force_1(s, X0);
        b[e + 1] += body_force_1(s, X1) - mean;
    }
}

/*
 * Errors of the cosine load on n elements: error[0..2] nodal, with the load
 * integrated by the midpoint rule of assemble(), by two-point Gauss, exactly;
 * error[3], error[4] in L2 and in energy, midpoint rule.
 */
static void cosine_errors(int n, double error[5])
{
    const struct scene s = {.n = n, .L = 1.0, .modulus = 1.0,
                            .shape = COSINE, .c = 1.0,
                            .left = {FIXED, 0.0}, .right = {FREE, 0.0}};
    const size_t size = (size_t)n + 1;
    struct matrix *K = matrix_alloc(BANDED, n + 1, 1);
    struct matrix *unused = matrix_alloc(BANDED, n + 1, 1);
    double *x = allocate(size, sizeof *x), *b = allocate(size, sizeof *b);
    double *u = allocate(size, sizeof *u);

    grid_make(0.0, 1.0, n, 1.0, x);
    for (int way = 2; way >= 0; way--) {
        assemble(&s, K, b);
        if (way == 1)
            poisson_assemble(n, x, one, cosine, &GAUSS2, unused, b);
        if (way == 2) exact_loads(&s, b);
        must_be_ok(solve(&s, K, b, u), "bar under a cosine load");
        const struct poisson_error e =
            poisson_errors(n, x, u, one, cosine_u, cosine_u_dx);
        error[way] = e.nodal;
        error[3] = e.L2;
        error[4] = e.energy;
    }
    matrix_free(K);
    matrix_free(unused);
    free(x);
    free(b);
    free(u);
}

/* Those errors on six meshes, and their orders [eq:order]. */
static void print_orders(void)
{
    double coarse[5] = {0}, fine[5] = {0};
    table_begin("orders", "n h midpoint gauss exact L2 energy");
    for (int n = 4; n <= 128; n *= 2) {
        for (int c = 0; c < 5; c++) coarse[c] = fine[c];
        cosine_errors(n, fine);
        table_row(n, 1.0 / n, fine[0], fine[1], fine[2], fine[3], fine[4]);
    }
    table_end();
    table_begin("orders_of", "midpoint gauss L2 energy");
    table_row(log2(coarse[0] / fine[0]), log2(coarse[1] / fine[1]),
              log2(coarse[3] / fine[3]), log2(coarse[4] / fine[4]));
    table_end();
}

/*
 * The model error [eq:model-error] at strain e = F - 1 != 0, against a
 * nonlinear law: of the stress at equal strain, |M e / P - 1|, or of the
 * strain at equal load, |P / (M e) - 1|.
 */
enum error_of { STRESS, STRAIN };
static double model_error(const struct material *law, enum error_of what,
                          double e)
{
    const double linear = material_modulus(law) * e;
    const double P = material1_pk1(law, 1.0 + e);
    return fabs((what == STRESS ? linear / P : P / linear) - 1.0);
}

struct level {
    const struct material *law;
    enum error_of what;
    double sign, error; /* tension +1, compression -1 */
};

static double above_level(double size, void *params)
{
    const struct level *l = params;
    return model_error(l->law, l->what, l->sign * size) - l->error;
}

/* The strain at which the model error reaches a level; the error grows with
 * |e| as far as 0.4, and is there beyond 10 % for every nu. */
static double strain_at(struct level level)
{
    gsl_function f = {above_level, &level};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    double low = 1e-5, high = 0.4;

    gsl_root_fsolver_set(solver, &f, low, high);
    for (int k = 0; k < 100 && high - low > 1e-15; k++) {
        gsl_root_fsolver_iterate(solver);
        low = gsl_root_fsolver_x_lower(solver);
        high = gsl_root_fsolver_x_upper(solver);
        if (above_level(gsl_root_fsolver_root(solver), &level) == 0.0) break;
    }
    const double root = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return level.sign * root;
}

/* Curves for the figure, and where they pass 1, 5, 10 %. */
static void print_model_error(double E, double nu)
{
    const struct material law[] = {material_make(LOG, E, nu),
                                   material_make(CUBIC, E, nu)};
    table_begin("model_error", "e stress_t stress_c cubic_t cubic_c load_t "
                               "strain_t load_c strain_c");
    for (int k = 0; k <= 24; k++) {
        const double e = 0.001 * pow(500.0, k / 24.0);
        table_row(e, model_error(&law[0], STRESS, e),
                  model_error(&law[0], STRESS, -e),
                  model_error(&law[1], STRESS, e),
                  model_error(&law[1], STRESS, -e),
                  material1_pk1(&law[0], 1.0 + e),
                  model_error(&law[0], STRAIN, e),
                  -material1_pk1(&law[0], 1.0 - e),
                  model_error(&law[0], STRAIN, -e));
    }
    table_end();

    table_begin_note("thresholds", "cubic percent strain_t strain_c load_t "
                                   "load_c",
                     "strain: stress error; load: strain error");
    for (int c = 0; c <= 1; c++)
        for (int k = 0; k < 3; k++) {
            const double error = (double[]){0.01, 0.05, 0.10}[k];
            double strain[2], load[2];
            for (int t = 0; t <= 1; t++) {
                const double sign = t ? -1.0 : 1.0;
                strain[t] =
                    strain_at((struct level){&law[c], STRESS, sign, error});
                load[t] = material1_pk1(
                    &law[c], 1.0 + strain_at((struct level){&law[c], STRAIN,
                                                            sign, error}));
            }
            table_row(c, 100.0 * error, strain[0], strain[1], load[0],
                      load[1]);
        }
    table_end();
}

enum { CAP = 60 }; /* iterations, and far from reached */

/* u at the free end of the hanging (c > 0) or standing bar after at most `cap`
 * steps of Newton's method from rest, or converged if cap is CAP; *solves
 * linear systems. */
static double newton_end(struct material material, double c, int cap,
                         int *solves)
{
    enum { n = 16 };
    const struct scene s = {.n = n, .L = 1.0, .c = c,
                            .modulus = material_modulus(&material),
                            .left = {FIXED, 0.0}, .right = {FREE, 0.0}};
    const struct newton_control control = {1e-12, cap, 0, 0};
    struct matrix *K = matrix_alloc(BANDED, n + 1, 1);
    double b[n + 1], u[n + 1] = {0};

    assemble(&s, K, b);
    matrix_free(K);
    const struct bar bar = {n, 1.0 / n, {1, 0}, b, material};
    const struct newton_report report = bar_newton(&bar, &control, u, NULL);
    if (report.status != OK && !(report.status == MAX_ITERATIONS && cap < CAP))
        die("%s: nonlinear bar under %g, residual %g",
            status_name(report.status), c, report.residual);
    *solves = report.iterations;
    return u[n];
}

/*
 * Model error against cost: the error of u(L) after k linear solves, against
 * the converged log law.  The first solve of Newton's method from rest is the
 * linear bar [alg:newton].  Loads c are in units of E.
 */
static void print_cost(double E, double nu)
{
    const double load[] = {0.01, 0.1, 0.5, -0.1, -0.5};
    enum { STEPS = 7 };
    const struct material log_law = material_make(LOG, E, nu);
    const struct material cubic = material_make(CUBIC, E, nu);
    double error[STEPS][COUNT(load)];
    int solves;

    table_begin("cost", "c linear_u linear_error cubic_solves cubic_error "
                        "log_solves log_u");
    for (int l = 0; l < COUNT(load); l++) {
        const double c = load[l] * E;
        int cubic_solves, unused;
        const double exact = newton_end(log_law, c, CAP, &solves);
        const double u_cubic = newton_end(cubic, c, CAP, &cubic_solves);
        const struct scene s = {.n = 16, .L = 1.0, .c = c,
                                .modulus = elastic_make(E, nu).modulus,
                                .left = {FIXED, 0.0}, .right = {FREE, 0.0}};
        double u[17];
        must_be_ok(displacements(&s, u), "bar under its own weight");
        table_row(c, u[16], fabs(u[16] / exact - 1.0), cubic_solves,
                  fabs(u_cubic / exact - 1.0), solves, exact);
        for (int k = 0; k < STEPS; k++)
            error[k][l] =
                fabs(newton_end(log_law, c, k + 1, &unused) / exact - 1.0);
    }
    table_end();
    table_begin_note("newton", "solves c1 c2 c3 c4 c5",
                     "c1 to c5: the loads of table cost, in its order");
    for (int k = 0; k < STEPS; k++)
        table_row(k + 1, error[k][0], error[k][1], error[k][2], error[k][3],
                  error[k][4]);
    table_end();
}

int main(int argc, char *argv[])
{
    struct scene s = {.n = 8, .L = 1.0, .c = 100.0, .right = {FREE, 100.0}};
    double E = 1000.0, nu = 0.3;
    int left = FIXED, right = FREE, shape = UNIFORM, printed = 0;
    const struct option options[] = {
        {"n", .integer = &s.n, .min = 1, .max = 20000, .help = "elements"},
        {"length", .real = &s.L, .min = 1e-3, .max = 1e3, .unit = "m",
         .help = "length of the bar"},
        {"E", .real = &E, .min = 1e-6, .max = 1e12, .unit = "N/m^2",
         .help = "Young's modulus",
         .why = "a material without stiffness carries nothing"},
        {"nu", .real = &nu, .min = 0.0, .max = 0.4999,
         .help = "Poisson's ratio",
         .why = "at 1/2 the material is incompressible and lambda infinite"},
        {"modulus", .choice = &printed, .choices = "right printed",
         .help = "2 mu + lambda, or 2 mu - lambda as the notes print it"},
        {"left", .choice = &left, .choices = "free fixed",
         .help = "condition at X = 0"},
        {"right", .choice = &right, .choices = "free fixed",
         .help = "condition at X = L"},
        {"at_left", .real = &s.left.value, .min = -1e9, .max = 1e9,
         .help = "traction (N/m^2) of a free, u (m) of a fixed left end"},
        {"at_right", .real = &s.right.value, .min = -1e9, .max = 1e9,
         .help = "the same at the right end"},
        {"body", .choice = &shape, .choices = "uniform cosine",
         .help = "shape of the body force"},
        {"c", .real = &s.c, .min = -1e9, .max = 1e9, .unit = "N/m^3",
         .help = "size of the body force"},
    };
    options_parse("09_linear_bar", options, COUNT(options), argc, argv);

    const struct elastic m = elastic_make(E, nu);
    s.modulus = printed ? printed_modulus(&m) : m.modulus;
    s.left.kind = (enum end_kind)left;
    s.right.kind = (enum end_kind)right;
    s.shape = (enum shape)shape;

    print_scene(&s);
    print_moduli(E);
    print_printed_modulus(E, 0.1 * E);
    print_end_loads(m.modulus, 0.1 * E);
    print_end_conditions(m.modulus);
    print_orders();
    print_model_error(E, nu);
    print_cost(E, nu);
    return table_finish();
}
