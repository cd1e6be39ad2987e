/* 10_neohookean_bar.c - what a right Newton method for the bar satisfies. */
#include "judge.h"

#define main program_main
#include PROGRAM
#undef main

#include "../oracle/10_neohookean_bar.h"

/* A bar without symmetry: h is not 1/n, no load is like another. */
enum { n_elem = 7, N_node = 8 };
static const double h_ = 0.2385;
static const double f_mid_[n_elem] = {371.4, -238.5, 61.3, 0.0,
                                      -124.7, 512.0, 83.1};
static const double pull_[2] = {37.14, -51.3};
static const double u_[N_node] = {0.02385, -0.0371, 0.0613,  0.0124,
                                  0.1247,  0.0731,  -0.0219, 0.0452};

/* Sums of a few products. */
static const double ROUND_OFF = 1e-13;
/* Forces are of the size of P ~ modulus times strain; K of modulus / h. */
static const double FORCE = 1346.0, STIFFNESS = 5644.0;

static struct bar a_bar(enum law law, int left, int right, double b[N_node])
{
    load_vector(n_elem, h_, f_mid_, pull_, b);
    return (struct bar){n_elem, h_, {left, right}, b, notes_material(law)};
}

static void loads_are_the_integrals(void)
{
    double b[N_node];
    load_vector(n_elem, h_, f_mid_, pull_, b);
    for (int i = 0; i < N_node; i++) {
        const double left = i > 0 ? f_mid_[i - 1] : 0.0;
        const double right = i < n_elem ? f_mid_[i] : 0.0;
        const double end = i == 0 ? pull_[0] : i == n_elem ? pull_[1] : 0.0;
        expect_close(b[i], 0.5 * h_ * (left + right) + end, ROUND_OFF, 100.0,
                     "b[%d], half of each element's load and the force on an "
                     "end", i);
    }
}

static void residual_of_a_shifted_bar_is_minus_b(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        double b[N_node], q[N_node], u[N_node];
        const struct bar bar = a_bar((enum law)law, 1, 0, b);
        for (int i = 0; i < N_node; i++) u[i] = 2.385;
        expect(residual(&bar, u, q) == OK, "a bar that is only shifted: the "
               "status is not OK, though F = 1");
        for (int i = 0; i < N_node; i++)
            expect_close(q[i], -b[i], ROUND_OFF, FORCE,
                         "q[%d] of a bar that is only shifted, F = 1 and P = "
                         "0, against -b", i);
    }
}

static void residual_agrees_with_common(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        double b[N_node], q[N_node], want[N_node], sum = 0.0;
        const struct bar bar = a_bar((enum law)law, 1, 1, b);
        expect(residual(&bar, u_, q) == OK, "residual() of a good state");
        bar_residual(&bar, u_, want);
        for (int i = 0; i < N_node; i++) {
            expect_close(q[i], want[i], ROUND_OFF, FORCE,
                         "q[%d], against bar_residual()", i);
            sum += q[i] + b[i];
        }
        expect_close(sum, 0.0, ROUND_OFF, FORCE, "sum of q + b");
    }
    double b[N_node], q[N_node], u[N_node];
    const struct bar bar = a_bar(LOG, 1, 0, b);
    for (int i = 0; i < N_node; i++) u[i] = -1.01 * h_ * i;
    expect(residual(&bar, u, q) == INVERTED,
           "log law, F = -0.01: the status must be INVERTED");
}

/* Central differences, step 1e-5: d^2 q'' / 6 and round-off / d, 1e-7 each. */
static void residual_is_the_slope_of_the_energy(void)
{
    double b[N_node], q[N_node], u[N_node], plus, minus;
    const struct bar bar = a_bar(CUBIC, 1, 0, b);
    const double d = 1e-5;
    expect(residual(&bar, u_, q) == OK, "residual() of a good state");
    memcpy(u, u_, sizeof u);
    for (int i = 0; i < N_node; i++) {
        u[i] = u_[i] + d;
        bar_energy(&bar, u, &plus);
        u[i] = u_[i] - d;
        bar_energy(&bar, u, &minus);
        u[i] = u_[i];
        expect_close(q[i], (plus - minus) / (2.0 * d), 1e-7, FORCE,
                     "q[%d], against the slope of the energy", i);
    }
}

static void tangent_at_rest_is_the_linear_bar(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        double b[N_node], u[N_node] = {0};
        const struct bar bar = a_bar((enum law)law, 1, 0, b);
        struct matrix *K = matrix_alloc(DENSE, N_node, 0);
        matrix_add(K, 1, 2, 2.385); /* what it held is forgotten */
        expect(tangent(&bar, u, K) == OK, "tangent() at rest");
        const double k = material_modulus(&bar.material) / h_;
        for (int i = 0; i < N_node; i++)
            for (int j = 0; j < N_node; j++)
                expect_close(matrix_get(K, i, j),
                             i == j ? (i == 0 || i == n_elem ? k : 2.0 * k)
                             : abs(i - j) == 1 ? -k
                                               : 0.0,
                             ROUND_OFF, STIFFNESS,
                             "K[%d][%d] at rest, against (2 mu + lambda)/h", i,
                             j);
        matrix_free(K);
    }
}

/* Central differences of q: the errors are d^2 P''' / h^3 = 1e-4 and
 * round-off / d = 1e-7. */
static void tangent_is_the_slope_of_the_residual(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        double b[N_node], plus[N_node], minus[N_node], u[N_node];
        const struct bar bar = a_bar((enum law)law, 1, 0, b);
        struct matrix *K = matrix_alloc(BANDED, N_node, 1);
        const double d = 1e-5;
        memcpy(u, u_, sizeof u);
        expect(tangent(&bar, u_, K) == OK, "tangent() of a good state");
        for (int j = 0; j < N_node; j++) {
            u[j] = u_[j] + d;
            bar_residual(&bar, u, plus);
            u[j] = u_[j] - d;
            bar_residual(&bar, u, minus);
            u[j] = u_[j];
            for (int i = 0; i < N_node; i++)
                expect_close(matrix_get(K, i, j),
                             (plus[i] - minus[i]) / (2.0 * d), 1e-6, STIFFNESS,
                             "K[%d][%d], against the slope of q", i, j);
        }
        matrix_free(K);
    }
}

/* Strike the held nodes out, and eliminate in the dense rest. */
static void increment_is_that_of_elimination(void)
{
    for (int ends = 1; ends < 4; ends++) {
        double b[N_node], q[N_node], du[N_node], r[N_node];
        const struct bar bar = a_bar(CUBIC, ends & 1, ends >> 1, b);
        const int first = bar.held[0], last = n_elem - bar.held[1];
        double A[N_node][N_node];
        struct matrix *K = matrix_alloc(BANDED, N_node, 1);
        bar_residual(&bar, u_, q);
        bar_tangent(&bar, u_, K);
        for (int i = 0; i < N_node; i++) {
            r[i] = -q[i];
            for (int j = 0; j < N_node; j++) A[i][j] = matrix_get(K, i, j);
        }
        const enum status status = increment(&bar, K, q, du);
        expect(status == OK, "increment() says %s for a tangent that is "
               "positive definite", status_name(status));
        matrix_free(K);
        for (int k = first; k < last; k++)
            for (int i = k + 1; i <= last; i++) {
                const double m = A[i][k] / A[k][k];
                for (int j = k; j <= last; j++) A[i][j] -= m * A[k][j];
                r[i] -= m * r[k];
            }
        for (int i = last; i >= first; i--) {
            for (int j = i + 1; j <= last; j++) r[i] -= A[i][j] * r[j];
            r[i] /= A[i][i];
        }
        if (bar.held[0]) r[0] = 0.0;
        if (bar.held[1]) r[n_elem] = 0.0;
        for (int i = 0; i < N_node; i++)
            expect_close(du[i], r[i], 1e-11, 1.0,
                         "du[%d] with the %s held, against elimination", i,
                         ends == 1 ? "left end" : ends == 2 ? "right end"
                                                            : "two ends");
    }
    double b[N_node], q[N_node], du[N_node], u[N_node] = {0};
    const struct bar bar = a_bar(CUBIC, 0, 0, b);
    struct matrix *K = matrix_alloc(BANDED, N_node, 1);
    bar_residual(&bar, u, q);
    bar_tangent(&bar, u, K);
    expect(increment(&bar, K, q, du) == NOT_SPD,
           "nothing is held: the status must be NOT_SPD");
    matrix_free(K);
}

static void newton_follows_the_oracles_iterates(void)
{
    for (int k = 0; k < COUNT(oracle_scalar); k++) {
        const struct oracle_scalar *o = &oracle_scalar[k];
        struct scene scene = weight_scene(o->log ? LOG : CUBIC, 5, 0.0);
        scene.pull[1] = o->p;
        const double F[] = {o->F1, o->F2, o->F3, o->F};
        for (int j = 0; j < 4; j++) {
            const struct newton_control control = {1e-12, j < 3 ? j + 1 : 100,
                                                   0, 0};
            struct state s = state_make(&scene);
            s.report = newton(&s.bar, &control, s.u);
            expect(s.report.status == (j < 3 ? MAX_ITERATIONS : OK),
                   "%s law, pulled by %g N, at most %d steps: the status is %s",
                   o->log ? "log" : "cubic", o->p, control.max_iterations,
                   status_name(s.report.status));
            /* the log law near F = 0 makes 1e4 times its rounding */
            for (int e = 1; e <= 5; e++)
                expect_close(stretch(&s, e), F[j], 1e-10,
                             fmax(1.0, fabs(F[j])),
                             "%s law, pulled by %g N: F of element %d after "
                             "%d steps", o->log ? "log" : "cubic", o->p, e,
                             s.report.iterations);
            if (j == 3)
                expect(abs(s.report.iterations - o->steps) <= 2,
                       "%s law, pulled by %g N: %d steps, the oracle made %d",
                       o->log ? "log" : "cubic", o->p, s.report.iterations,
                       o->steps);
            state_free(&s);
        }
    }
}

/* Where it must not stop, and where it must. */
static void newton_stops_at_solutions_only(void)
{
    struct scene scene = weight_scene(CUBIC, 10, 0.0);
    const struct newton_control control = {1e-12, 100, 0, 0};

    struct state s = state_make(&scene);
    s.report = newton(&s.bar, &control, s.u);
    expect(s.report.status == OK && s.report.iterations <= 1,
           "a bar at rest: %s after %d steps; it is solved before the first",
           status_name(s.report.status), s.report.iterations);
    state_free(&s);

    scene.g[0] = sin(0.5);
    s = state_make(&scene);
    s.report = newton(&s.bar, &control, s.u);
    expect(s.report.status == OK && s.report.iterations > 1,
           "left end moved by sin 0.5: %s after %d steps",
           status_name(s.report.status), s.report.iterations);
    for (int i = 0; i <= 10; i++)
        expect_close(s.u[i], sin(0.5), 1e-12, 1.0, "u[%d] of the moved bar", i);
    state_free(&s);

    /* here the first increment is 9.5e-10 or less, and P = -1.1e12 or more */
    for (int k = 0; k < COUNT(oracle_false); k++) {
        const struct newton_control loose = {1e-8, 100, 0, 0};
        scene.material = notes_material(LOG);
        scene.g[0] = 0.1 * (1.0 - oracle_false[k].F0);
        s = state_make(&scene);
        s.report = newton(&s.bar, &loose, s.u);
        expect(s.report.status == OK, "log law started at F = %g: %s",
               oracle_false[k].F0, status_name(s.report.status));
        expect_close(stretch(&s, 1), 1.0, 1e-7, 1.0,
                     "log law started at F = %g, tolerance 1e-8: F after %d "
                     "steps", oracle_false[k].F0, s.report.iterations);
        state_free(&s);
    }

    scene = weight_scene(LOG, 16, 0.0);
    scene.pull[1] = -1347.0;
    s = state_make(&scene);
    s.report = newton(&s.bar, &control, s.u);
    expect(s.report.status == INVERTED,
           "log law pressed with 1347 N from rest: the first step inverts it, "
           "but the status is %s", status_name(s.report.status));
    state_free(&s);
}

static void example_is_sin_t(void)
{
    struct output *out = run("--budget 0.0001");
    int rows;
    const double *t = column(out, "example", "t", &rows);
    expect(rows == 64, "table example must go from t = 0 to 6.3");
    for (int r = 0; r < rows; r++) {
        expect_close(cell(out, "example", "u_right", r), sin(t[r]), 1e-12, 1.0,
                     "u(1) at t = %g, against sin t", t[r]);
        expect_close(cell(out, "example", "error", r), 0.0, 1e-12, 1.0,
                     "max |u - sin t| at t = %g", t[r]);
    }
    for (int r = 0; r < COUNT(oracle_example); r++) {
        const struct oracle_example *o = &oracle_example[r];
        const double its = cell(out, "example_steps", "cubic_iterations", r);
        expect(cell(out, "example_steps", "cubic_status", r) == OK &&
                   fabs(its - o->cubic) <= 2,
               "n = %d, dt = %g, cubic: %g steps at most, the oracle has %d",
               o->n, o->dt, its, o->cubic);
        const double status = cell(out, "example_steps", "log_status", r);
        expect(status == (o->log < 0 ? INVERTED : OK) &&
                   (o->log < 0 ||
                    fabs(cell(out, "example_steps", "log_iterations", r) -
                         o->log) <= 2),
               "n = %d, dt = %g, log: status %g, %g steps; the oracle has %d",
               o->n, o->dt, status,
               cell(out, "example_steps", "log_iterations", r), o->log);
    }
    /* F0 is 1 - (1 - F0), rounded */
    for (int r = 0; r < COUNT(oracle_false); r++)
        expect_close(cell(out, "increment_loop", "P0", r), oracle_false[r].P,
                     1e-3, fabs(oracle_false[r].P), "P at F0 = %g",
                     oracle_false[r].F0);
    for (int r = 1; r < COUNT(oracle_false); r++)
        expect_close(cell(out, "increment_loop", "du", r), oracle_false[r].du,
                     1e-3, oracle_false[r].du, "the first increment at F0 = %g",
                     oracle_false[r].F0);
    expect_close(cell(out, "printed_loop", "error", 1), 0.0562, 1e-2, 0.0562,
                 "what the loop as printed leaves at t = 0.1");
    expect_close(cell(out, "printed_loop", "error", 2), 0.369, 1e-2, 0.369,
                 "what the loop as printed leaves at t = 0.5");
}

/* The nodal values with 4 elements to 1e-11; h^2 with its constant. */
static void bars_under_weight_are_the_oracles(void)
{
    struct output *out = run("--budget 0.0001");
    for (int k = 0; k < COUNT(oracle_weight); k++)
        for (int law = 0; law < 2; law++) {
            const struct oracle_weight *o = &oracle_weight[k];
            const struct scene scene =
                weight_scene(law ? LOG : CUBIC, 4, o->c);
            struct state s = solved(&scene);
            expect(s.report.status == OK, "c = %g, %s law, 4 elements: %s",
                   o->c, law ? "log" : "cubic", status_name(s.report.status));
            for (int i = 0; i < 4; i++)
                expect_close(s.u[i + 1], o->law[law].u4[i], 1e-11, 1.0,
                             "c = %g, %s law, 4 elements: u[%d]", o->c,
                             law ? "log" : "cubic", i + 1);
            expect_close(reaction(&s), -o->c, 1e-11, FORCE,
                         "c = %g: the force that holds the bar", o->c);
            state_free(&s);
            expect_close(cell(out, "weight", law ? "log_u1" : "cubic_u1", k),
                         o->law[law].u16, 1e-11, 1.0,
                         "c = %g, 16 elements: u(1)", o->c);
            expect_close(
                cell(out, "weight", law ? "log_exact" : "cubic_exact", k),
                o->law[law].u1, 1e-12, 1.0, "c = %g: the closed form", o->c);
            expect_close(
                cell(out, "weight", law ? "log_F_base" : "cubic_F_base", k),
                o->law[law].F_base, 1e-12, 1.0, "c = %g: F at the held end",
                o->c);
        }
    int rows;
    const double *n = column(out, "order", "n", &rows);
    for (int r = 0; r < rows; r++) {
        if (n[r] < 32.0) continue; /* the next term is h^2 smaller */
        expect_close(cell(out, "order", "order", r), 2.0, 2e-3, 1.0,
                     "order of u(1), n = %g", n[r]);
        expect_close(cell(out, "order", "constant", r) /
                         cell(out, "order", "predicted", r),
                     1.0, 2e-3, 1.0, "constant of h^2 over the predicted one");
    }
}

/* Richardson: (4 u_2n - u_n) / 3 leaves h^4. */
static void other_loads_are_the_oracles(void)
{
    struct output *out = run("--budget 0.0001");
    static const char *const name[] = {"cubic_u1", "log_u1", "cubic_u1_neg",
                                       "log_u1_neg"};
    for (int k = 0; k < 4; k++)
        expect_close((4.0 * cell(out, "cosine", name[k], 2) -
                      cell(out, "cosine", name[k], 1)) / 3.0,
                     oracle_cosine[k], 1e-7, 1.0, "cosine load, %s", name[k]);
    for (int k = 0; k < 2; k++) {
        expect_close((4.0 * cell(out, "both_fixed", "reaction", 3 * k + 2) -
                      cell(out, "both_fixed", "reaction", 3 * k + 1)) / 3.0,
                     oracle_both_fixed[k].R, 1e-5, oracle_both_fixed[k].R,
                     "both ends held, c = %g: P at the left end",
                     oracle_both_fixed[k].c);
        expect_close((4.0 * cell(out, "both_fixed", "u_half", 3 * k + 2) -
                      cell(out, "both_fixed", "u_half", 3 * k + 1)) / 3.0,
                     oracle_both_fixed[k].u_half, 1e-6, 1.0,
                     "both ends held, c = %g: u(1/2)", oracle_both_fixed[k].c);
    }
    expect_close(cell(out, "localised", "F_min", 1), oracle_localised[0], 1e-9,
                 1.0, "nu = 0.05, pulled by 1: smallest F");
    expect_close(cell(out, "localised", "F_max", 1), oracle_localised[1], 1e-9,
                 1.0, "nu = 0.05, pulled by 1: largest F");
    /* c = 540 on 16 elements: above the limit load / (1 - 1/32) of nu = 0 and
     * 0.02, below that of nu = 0.05 */
    for (int k = 0; k < 3; k++)
        expect((cell(out, "nu_sweep", "cubic_status", k) == OK) == (k == 2),
               "hanging bar, c = 540, nu = %g: equilibrium or not",
               cell(out, "nu_sweep", "nu", k));
    for (int k = 0; k < 2; k++)
        expect(oracle_limit[k].c / (1.0 - 1.0 / 32.0) < 540.0, "limit loads");
}

/* The same discrete equations, solved to n eps of the displacement. */
static void fast_and_common_agree(void)
{
    for (int n = 5; n < 400; n *= 9)
        for (int k = 0; k < 4; k++) {
            struct scene scene =
                weight_scene(CUBIC, n, k < 2 ? 500.0 : -1300.0);
            scene.held[1] = k & 1;
            struct state s = solved(&scene);
            expect(s.report.status == OK, "n = %d, c = %g: %s", n, scene.c,
                   status_name(s.report.status));
            const struct newton_control control = control_for(&scene);
            for (int how = 0; how < 3; how++) {
                struct state t = state_make(&scene);
                t.report = how == 2
                               ? bar_newton(&t.bar, &control, t.u, NULL)
                               : bar_fast_newton(&t.bar, &control,
                                                 (enum sweep)how, t.u);
                for (int i = 0; i <= n; i++)
                    expect_close(s.u[i], t.u[i], 1e-14 * n, 1.0,
                                 "n = %d, c = %g: u[%d], against %s", n,
                                 scene.c, i, how == 2 ? "bar_newton()"
                                                      : "bar_fast_newton()");
                expect(abs(s.report.iterations - t.report.iterations) <= 1,
                       "n = %d, c = %g: %d steps, %s made %d", n, scene.c,
                       s.report.iterations,
                       how == 2 ? "bar_newton()" : "bar_fast_newton()",
                       t.report.iterations);
                state_free(&t);
            }
            state_free(&s);
        }
}

static void energy_falls_and_ratio_is_predicted(void)
{
    struct output *out = run("--budget 0.0001");
    int rows;
    const double *search = column(out, "energy", "line_search", &rows);
    const double *energy = column(out, "energy", "energy", NULL);
    int rose[2] = {0, 0};
    for (int r = 1; r < rows; r++)
        if (search[r] == search[r - 1] &&
            energy[r] > energy[r - 1] + 1e-12 * fabs(energy[r - 1]))
            rose[(int)search[r]] = 1;
    expect(rose[0] && !rose[1],
           "table energy: full steps must raise the energy once, those of the "
           "line search never");
    const double *ratio = column(out, "newton", "ratio", &rows);
    for (int r = rows - 1; r > 0; r--)
        if (ratio[r] > 0.0) { /* error before: 2e-4, the next term */
            expect_close(ratio[r], cell(out, "newton", "predicted", r), 2e-3,
                         1.0, "error over the square of the error before");
            return;
        }
    wrong("table newton has no ratio");
}

static const struct claim claims[] = {
    {"loads_are_the_integrals", loads_are_the_integrals, "10a"},
    {"residual_of_a_shifted_bar_is_minus_b",
     residual_of_a_shifted_bar_is_minus_b, "10b"},
    {"residual_agrees_with_common", residual_agrees_with_common, "10b"},
    {"residual_is_the_slope_of_the_energy", residual_is_the_slope_of_the_energy,
     "10b"},
    {"tangent_at_rest_is_the_linear_bar", tangent_at_rest_is_the_linear_bar,
     "10c"},
    {"tangent_is_the_slope_of_the_residual",
     tangent_is_the_slope_of_the_residual, "10c"},
    {"increment_is_that_of_elimination", increment_is_that_of_elimination,
     "10d"},
    {"newton_follows_the_oracles_iterates",
     newton_follows_the_oracles_iterates, "10e"},
    {"newton_stops_at_solutions_only", newton_stops_at_solutions_only, "10e"},
    {"example_is_sin_t", example_is_sin_t, "10e"},
    {"bars_under_weight_are_the_oracles", bars_under_weight_are_the_oracles,
     "10a"},
    {"other_loads_are_the_oracles", other_loads_are_the_oracles, "10d"},
    {"fast_and_common_agree", fast_and_common_agree, "10e"},
    {"energy_falls_and_ratio_is_predicted", energy_falls_and_ratio_is_predicted,
     "10e"},
};

/* The chart is no one's to compare: a tiny budget keeps the runs short. */
static const char *const runs[] = {
    "--budget 0.0001",
    "--solve no --n 7 --law log --fixed right --c 371.4 --pull_left 2.385",
    "--solve scene --n 7 --fixed right --c 238.5 --pull_left -61.3",
    "--solve scene --n 9 --law log --shape cosine --c 613 --pull_right 371.4 "
    "--nu 0.2385",
    "--solve scene --n 5 --fixed both --g_left 0.02385 --g_right -0.0731 "
    "--c 124.7 --E 371.4",
    "--solve scene --n 1 --c 238.5",
};

#define SUMS "sums of two element values"
#define STEPS "steps: one more or less is round-off"
#define SOLVED "Newton to 1e-12, condition number below 1e5"
static const struct column_rule rules[] = {
    {"b", "*", 1e-13, SUMS, 0},
    {"q", "*", 1e-12, SUMS, 0},
    {"K", "*", 1e-12, SUMS, 0},
    {"du", "*", 1e-9, "direct solve, condition number below 1e3", 0},
    {"nodes", "*", 1e-9, SOLVED, 0},
    {"elements", "*", 1e-8, SOLVED, 0},
    {"newton", "k", 0, "a count", 0},
    {"newton", "ratio", 1e-3, "error over its square, errors above 1e-10", 0},
    {"newton", "predicted", 1e-5, "a difference quotient of P'", 0},
    {"newton", "*", 1e-9, "iterates of Newton; scale is the first ones", 0},
    {"example", "iterations", 1, STEPS, 1},
    {"example", "error", 1e-12, "round-off", 1},
    {"example", "*", 1e-12, "sin t to round-off", 1},
    {"example_steps", "cubic_iterations", 1, STEPS, 1},
    {"example_steps", "log_iterations", 1, STEPS, 1},
    {"example_steps", "*", 1e-12, "statuses; errors at round-off", 1},
    {"printed_loop", "steps_right", 1, STEPS, 1},
    {"printed_loop", "error_right", 1e-12, "round-off", 1},
    {"printed_loop", "*", 1e-10, "one step of Newton", 0},
    {"increment_loop", "F0", 1e-12, "given", 0},
    {"increment_loop", "P0", 1e-3, "F0 is 1 - (1 - F0), rounded", 0},
    {"increment_loop", "steps", 1, STEPS, 1},
    {"increment_loop", "steps_right", 1, STEPS, 1},
    {"increment_loop", "P", 1e-3, "F0 is 1 - (1 - F0), rounded", 0},
    {"increment_loop", "*", 1e-6, "F after the last step", 1},
    {"weight", "cubic_iterations", 1, STEPS, 1},
    {"weight", "log_iterations", 1, STEPS, 1},
    {"weight", "*", 1e-10, SOLVED, 0},
    {"weight_curve", "*", 1e-9, "closed form; c = 0.001 stands for 0", 0},
    {"order", "order", 1e-5, "logarithm of errors of 1e-7, known to 1e-14", 0},
    {"order", "*", 1e-6, "errors of 1e-7, known to 1e-14", 0},
    {"cosine", "*", 1e-10, SOLVED, 0},
    {"both_fixed", "iterations", 1, STEPS, 1},
    {"both_fixed", "*", 1e-9, SOLVED, 0},
    {"end_load", "cubic_iterations", 1, STEPS, 1},
    {"end_load", "log_iterations", 1, STEPS, 1},
    {"end_load", "*", 1e-9, SOLVED, 0},
    {"nu_sweep", "cubic_iterations", 1, STEPS, 1},
    {"nu_sweep", "log_iterations", 1, STEPS, 1},
    {"nu_sweep", "*", 1e-9, SOLVED, 0},
    {"localised", "*", 1e-9, "bar_newton() to 1e-12", 0},
    {"energy", "*", 1e-9, "bar_newton(), from rest", 0},
    {"large", "*", NOT_COMPARED, "seconds are the machine's", 0},
    {"chart_readable", "*", NOT_COMPARED, "seconds are the machine's", 0},
    {"chart_gsl", "*", NOT_COMPARED, "seconds are the machine's", 0},
    {"chart_fused", "*", NOT_COMPARED, "seconds are the machine's", 0},
    {"chart_both", "*", NOT_COMPARED, "seconds are the machine's", 0},
};

static const struct lesson lesson = {
    "10_neohookean_bar", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Column ratio of table `newton`: each step squares the error, and the "
    "factor is |P''/2P'|, known beforehand. And table `large`: the sweep that "
    "adds compliances is faster than the library, and keeps more digits.",
    "Table `increment_loop`, F0 = 1e-8: a loop that looks at max|du| alone is "
    "content after one step, with a stress of half a billion kN/m^2. Which "
    "number would have told it?"};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
