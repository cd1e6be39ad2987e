/*
 * 10_neohookean_bar.c - what a right Newton method for the bar satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *     10a      n, h          7 and 1, h = 1.67 / 7; 4 to 45 with n h = 1
 *     10a      f_mid, pull   of no formula; uniform, cosine; 0
 *     10b, c   bar           both laws; nu 0.3, and 0.02 where P' < 0
 *     10b, c   u             shifted, any, inverted; K dense and banded
 *     10d      bar, K, q     each end held or free, none of them
 *     10e      bar           n h = 1; in it_measures_in_lengths 0.06 and 12
 *     10e      control       tolerance 1e-3 to 1e-12; 1 to 3, 100 steps
 *     10e      u             at rest, moved, pressed to 1e-8
 */
#include "program.h"

#include "judge.h"

#include "../oracle/10_neohookean_bar.h"

#include <string.h>

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

/* Its loads are the program's. */
static struct bar a_bar(enum law law, int left, int right)
{
    double *b = guarded_alloc(N_node);
    load_vector(n_elem, h_, guarded_copy(n_elem, f_mid_),
                guarded_copy(2, pull_), b);
    return (struct bar){n_elem, h_, {left, right}, b,
                        material_notes(law)};
}

static void loads_are_the_integrals(void)
{
    const double *b = a_bar(LOG, 1, 0).b;
    for (int i = 0; i < N_node; i++) {
        const double left = i > 0 ? f_mid_[i - 1] : 0.0;
        const double right = i < n_elem ? f_mid_[i] : 0.0;
        const double end = i == 0 ? pull_[0] : i == n_elem ? pull_[1] : 0.0;
        expect_close(b[i], 0.5 * h_ * (left + right) + end, ROUND_OFF, 100.0,
                     "b[%d], half of each element's load and the force on an "
                     "end", i);
    }
    double *two = guarded_alloc(2); /* one element has both ends */
    load_vector(1, h_, f_mid_, pull_, two);
    for (int i = 0; i < 2; i++)
        expect_close(two[i], 0.5 * h_ * f_mid_[0] + pull_[i], ROUND_OFF, 100.0,
                     "b[%d] of a bar of one element", i);
}

static void residual_of_a_shifted_bar_is_minus_b(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        double *q = guarded_alloc(N_node), *u = guarded_alloc(N_node);
        const struct bar bar = a_bar((enum law)law, 1, 0);
        for (int i = 0; i < N_node; i++) u[i] = 2.385;
        expect(residual(&bar, u, q) == OK, "a bar that is only shifted: the "
               "status is not OK, though F = 1");
        for (int i = 0; i < N_node; i++)
            expect_close(q[i], -bar.b[i], ROUND_OFF, FORCE,
                         "q[%d] of a bar that is only shifted, F = 1 and P = "
                         "0, against -b", i);
    }
}

/* F = -0.01 everywhere, where the log law is not defined, and the cubic is. */
static const double *an_inverted_bar(void)
{
    double *u = guarded_alloc(N_node);
    for (int i = 0; i < N_node; i++) u[i] = -1.01 * h_ * i;
    return u;
}

static void residual_agrees_with_common(void)
{
    for (int k = 0; k < 3; k++) {
        double *q = guarded_alloc(N_node), want[N_node], sum = 0.0, b[N_node];
        const struct bar bar = a_bar(k ? CUBIC : LOG, 1, 1);
        const double *u = k < 2 ? u_ : an_inverted_bar();
        memcpy(b, bar.b, sizeof b);
        expect(residual(&bar, guarded_copy(N_node, u), q) == OK,
               k < 2 ? "residual() of a good state"
                     : "residual(): the cubic law is defined at F = -0.01");
        expect(memcmp(b, bar.b, sizeof b) == 0, "residual() changes b");
        bar_residual(&bar, u, want);
        for (int i = 0; i < N_node; i++) {
            expect_close(q[i], want[i], ROUND_OFF, k < 2 ? FORCE : 1e4,
                         "q[%d], against bar_residual()", i);
            sum += q[i] + bar.b[i];
        }
        expect_close(sum, 0.0, ROUND_OFF, k < 2 ? FORCE : 1e4, "sum of q + b");
    }
    double q[N_node];
    const struct bar bar = a_bar(LOG, 1, 0);
    expect(residual(&bar, an_inverted_bar(), q) == INVERTED,
           "log law, F = -0.01: the status of residual() must be INVERTED");
}

static void tangent_at_rest_is_the_linear_bar(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        const double u[N_node] = {0};
        const struct bar bar = a_bar((enum law)law, 1, 0);
        struct matrix *K = matrix_alloc(DENSE, N_node, 0);
        matrix_add(K, 1, 2, 2.385); /* what it held is forgotten */
        expect(tangent(&bar, guarded_copy(N_node, u), K) == OK,
               "tangent() at rest");
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
 * round-off / d = 1e-7.  The last bar is pulled to F = 3, where P' < 0. */
static void tangent_is_the_slope_of_the_residual(void)
{
    for (int law = LOG; law <= CUBIC + 1; law++) {
        double plus[N_node], minus[N_node], u[N_node], at[N_node];
        struct bar bar = a_bar(law == LOG ? LOG : CUBIC, 1, 0);
        struct matrix *K = matrix_alloc(BANDED, N_node, 1);
        const double d = 1e-5;
        if (law > CUBIC) bar.material = material_make(CUBIC, 1000.0, 0.02);
        for (int i = 0; i < N_node; i++)
            u[i] = at[i] = u_[i] + (law > CUBIC ? 2.0 * h_ * i : 0.0);
        expect(tangent(&bar, at, K) == OK, "tangent() of a good state");
        expect(law != LOG || tangent(&bar, an_inverted_bar(), K) == INVERTED,
               "log law, F = -0.01: the status of tangent() must be INVERTED, "
               "as that of residual() is");
        tangent(&bar, at, K);
        for (int j = 0; j < N_node; j++) {
            u[j] = at[j] + d;
            bar_residual(&bar, u, plus);
            u[j] = at[j] - d;
            bar_residual(&bar, u, minus);
            u[j] = at[j];
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
        double *q = guarded_alloc(N_node), *du = guarded_alloc(N_node);
        double r[N_node], given[N_node];
        const struct bar bar = a_bar(CUBIC, ends & 1, ends >> 1);
        const int first = bar.held[0], last = n_elem - bar.held[1];
        double A[N_node][N_node];
        struct matrix *K = matrix_alloc(BANDED, N_node, 1);
        bar_residual(&bar, u_, q);
        bar_tangent(&bar, u_, K);
        for (int i = 0; i < N_node; i++) {
            r[i] = -q[i];
            given[i] = q[i];
            for (int j = 0; j < N_node; j++) A[i][j] = matrix_get(K, i, j);
        }
        const enum status status = increment(&bar, K, q, du);
        expect(status == OK, "increment() says %s for a tangent that is "
               "positive definite", status_name(status));
        matrix_free(K);
        expect(memcmp(q, given, sizeof given) == 0, "increment() changes q");
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
    double q[N_node], du[N_node], u[N_node] = {0};
    const struct bar bar = a_bar(CUBIC, 0, 0);
    struct matrix *K = matrix_alloc(BANDED, N_node, 1);
    bar_residual(&bar, u, q);
    bar_tangent(&bar, u, K);
    expect(increment(&bar, K, q, du) == NOT_SPD,
           "nothing is held: the status must be NOT_SPD");
    matrix_free(K);
}

/* The program's newton() on a scene, at most `steps` of it. */
static struct bar_state *solved(const struct bar_scene *scene, int steps)
{
    struct newton_control control = bar_scene_control(scene);
    struct bar_state *s = bar_state_by(load_vector, scene);
    control.max_iterations = steps;
    s->report = newton(&s->bar, &control, s->u);
    return s;
}

/* The same where there is a solution. */
static struct bar_state *answer(const struct bar_scene *scene)
{
    struct bar_state *s = solved(scene, 100);
    expect(s->report.status == OK, "%s law, c = %g, n = %d: the status is %s",
           material_law(scene->material.law), scene->c, scene->n,
           status_name(s->report.status));
    return s;
}

static void newton_follows_the_oracles_iterates(void)
{
    for (int k = 0; k < COUNT(oracle_scalar); k++) {
        const struct oracle_scalar *o = &oracle_scalar[k];
        struct bar_scene scene = bar_scene_notes(o->log ? LOG : CUBIC, 5);
        scene.pull[1] = o->p;
        const double F[] = {o->F1, o->F2, o->F3, o->F};
        for (int j = 0; j < 4; j++) {
            struct bar_state *s = solved(&scene, j < 3 ? j + 1 : 100);
            expect(s->report.status == (j < 3 ? MAX_ITERATIONS : OK),
                   "%s law, pulled by %g N, at most %d steps: the status is %s",
                   o->log ? "log" : "cubic", o->p, j < 3 ? j + 1 : 100,
                   status_name(s->report.status));
            /* the log law near F = 0 makes 1e4 times its rounding */
            for (int e = 1; e <= 5; e++)
                expect_close(bar_stretch(&s->bar, s->u, e), F[j], 1e-10,
                             fmax(1.0, fabs(F[j])),
                             "%s law, pulled by %g N: F of element %d after "
                             "%d steps", o->log ? "log" : "cubic", o->p, e,
                             s->report.iterations);
            if (j == 3)
                expect(abs(s->report.iterations - o->steps) <= 2,
                       "%s law, pulled by %g N: %d steps, the oracle made %d",
                       o->log ? "log" : "cubic", o->p, s->report.iterations,
                       o->steps);
            bar_state_free(s);
        }
    }
}

/* Just below the largest pull that there is, P' = 0: the steps halve the
 * distance e to F, and q falls with e^2.  At tolerance 1e-6 the residual is
 * small at e = 1e-3, and round-off is far away. */
static void it_goes_on_while_it_moves(void)
{
    struct bar_scene scene = bar_scene_notes(CUBIC, 4);
    const struct newton_control loose = {1e-6, 100, 0, 0};
    double low = 1.5, high = 2.5; /* P' > 0, P' < 0 */
    scene.material = material_make(CUBIC, 1000.0, 0.02);
    while (high - low > 1e-12) {
        const double F = 0.5 * (low + high);
        *(material1_dpk1(&scene.material, F) > 0.0 ? &low : &high) = F;
    }
    const double F = low - 1e-5;
    scene.pull[1] = material1_pk1(&scene.material, F);
    struct bar_state *s = bar_state_by(load_vector, &scene);
    s->report = newton(&s->bar, &loose, s->u);
    expect(s->report.status == OK, "pulled by %g N, where P' is nearly 0, "
           "tolerance 1e-6: the status is %s", scene.pull[1],
           status_name(s->report.status));
    for (int e = 1; e <= 4; e++)
        expect_close(bar_stretch(&s->bar, s->u, e), F, 2e-6, 1.0,
                     "pulled by %g N, where P' is nearly 0, tolerance 1e-6: F "
                     "of element %d after %d steps; the residual is small long "
                     "before the steps are", scene.pull[1], e,
                     s->report.iterations);
    bar_state_free(s);
}

/* What is left over is less than the tolerance allows, but not 0: one step. */
static void it_makes_the_first_step(void)
{
    const double pull[] = {1e-10, 1.0}; /* N */
    for (int k = 0; k < COUNT(pull); k++) {
        struct bar_scene scene = bar_scene_notes(CUBIC, 5);
        scene.pull[1] = pull[k];
        struct bar_state *s = answer(&scene);
        const double linear = pull[k] / material_modulus(&scene.material);
        expect_close(s->u[5], linear, 2e-3, linear,
                     "u(1) of a bar at rest that is pulled by %g N, after %d "
                     "steps; no step is needed only where q is 0", pull[k],
                     s->report.iterations);
        bar_state_free(s);
    }
}

/* A bar that is pulled by a strain: the first increment is that strain times
 * its length, and what it leaves over is the strain squared. */
static void it_measures_in_lengths(void)
{
    const double tolerance[] = {1e-3, 1e-6, 1e-9}, h[] = {0.03, 6.0};
    for (int c = 0; c < 12; c++) {
        const struct newton_control control = {tolerance[c / 4], 100, 0, 0};
        const struct material material = material_notes(CUBIC);
        const double strain = (c % 2 ? 2.0 : 0.5) * control.tolerance;
        const double b[] = {0.0, 0.0, strain * material_modulus(&material)};
        const struct bar bar = {2, h[c / 2 % 2], {1, 0}, guarded_copy(3, b),
                                material};
        double *u = guarded_copy(3, (const double[]){0, 0, 0});
        const struct newton_report report = newton(&bar, &control, u);
        expect(report.status == OK && report.iterations == (c % 2 ? 2 : 1),
               "n h = %g, tolerance %g: %s after %d steps, not OK after %d; "
               "the first max|du| is %g, and n h times the tolerance %g",
               2.0 * bar.h, control.tolerance, status_name(report.status),
               report.iterations, c % 2 ? 2 : 1, strain * 2.0 * bar.h,
               control.tolerance * 2.0 * bar.h);
    }
}

/* What a step is off by: P(F + step), where the tangent at F has said `p`. */
static double left_over(const struct material *m, double F, double step,
                        double *p)
{
    *p = material1_pk1(m, F) + material1_dpk1(m, F) * step;
    return fabs(material1_pk1(m, F + step) - *p);
}

/* A log law is pressed so far that the first step, shorter than the tolerance
 * allows, leaves over 0.9 or 1.1 times what it allows. */
static void it_measures_in_forces(void)
{
    const struct newton_control control = {1e-6, 100, 0, 0};
    for (int c = 0; c < 4; c++) {
        const struct material material =
            c / 2 ? material_make(LOG, 238.5, 0.42) : material_notes(LOG);
        const double step = 0.5 * control.tolerance, share = c % 2 ? 1.1 : 0.9;
        const double allowed = control.tolerance * material_modulus(&material);
        double low = 1e-3, high = 0.1, p;
        while (high - low > 1e-9) {
            const double F = 0.5 * (low + high);
            const double left = left_over(&material, F, step, &p);
            *(left > share * allowed ? &low : &high) = F;
        }
        left_over(&material, low, step, &p);
        const double b[] = {0.0, 0.0, p};
        const struct bar bar = {2, 0.5, {1, 0}, guarded_copy(3, b), material};
        const double start[] = {0.0, 0.5 * (low - 1.0), low - 1.0};
        const struct newton_report report =
            newton(&bar, &control, guarded_copy(3, start));
        expect(report.status == OK && report.iterations == 1 + c % 2,
               "log law, modulus %g, F = %g, tolerance 1e-6: %s after %d "
               "steps, not OK after %d; the first step, %g n h, leaves over "
               "%g times tolerance times modulus", material_modulus(&material),
               low, status_name(report.status), report.iterations, 1 + c % 2,
               step, share);
    }
}

/* Pulled to where P' < 0: the first system has no solution to count. */
static void it_counts_what_it_solves(void)
{
    const struct newton_control control = {1e-6, 100, 0, 0};
    const double b[] = {0.0, 371.4};
    const struct bar bar = {1, 1.0, {1, 0}, guarded_copy(2, b),
                            material_make(CUBIC, 1000.0, 0.02)};
    const struct newton_report report =
        newton(&bar, &control, guarded_copy(2, (const double[]){0.0, 2.0}));
    expect(report.status == NOT_SPD && report.iterations == 0,
           "from F = 3, where P' < 0: %s after %d steps, not NOT_SPD after 0; "
           "K is not positive definite, and no step is made",
           status_name(report.status), report.iterations);
}

static void it_says_nonfinite(void)
{
    for (int end = 0; end < 2; end++) {
        struct bar_scene scene = bar_scene_notes(CUBIC, 5);
        scene.pull[1] = end ? (double)NAN : 1e300; /* F^5 overflows */
        struct bar_state *s = solved(&scene, 100);
        expect(s->report.status == NONFINITE,
               "pulled by %g N: the status must be NONFINITE, not %s",
               scene.pull[1], status_name(s->report.status));
        bar_state_free(s);
    }
}

/* Where it must not stop, and where it must. */
static void newton_stops_at_solutions_only(void)
{
    it_goes_on_while_it_moves();
    it_makes_the_first_step();
    it_measures_in_lengths();
    it_measures_in_forces();
    it_says_nonfinite();
    it_counts_what_it_solves();
    struct bar_scene scene = bar_scene_notes(CUBIC, 10);
    struct bar_state *s = answer(&scene);
    expect(s->report.iterations == 0, "a bar at rest: solved after %d steps; "
           "q is 0, and no step is made", s->report.iterations);
    expect(s->report.increment == 0.0,
           "a bar at rest, solved without a step: the increment is %g, not 0, "
           "after other bars", s->report.increment);
    bar_state_free(s);

    scene.g[0] = sin(0.5);
    s = answer(&scene);
    expect(s->report.iterations > 1, "left end moved by sin 0.5: solved after "
           "%d steps", s->report.iterations);
    for (int i = 0; i <= 10; i++)
        expect_close(s->u[i], sin(0.5), 1e-12, 1.0, "u[%d] of the moved bar",
                     i);
    bar_state_free(s);

    /* here the first increment is 9.5e-10 or less, and P = -1.1e12 or more */
    for (int k = 0; k < COUNT(oracle_false); k++) {
        const struct newton_control loose = {1e-8, 100, 0, 0};
        scene = bar_scene_notes(LOG, 10);
        scene.g[0] = 0.1 * (1.0 - oracle_false[k].F0);
        s = bar_state_by(load_vector, &scene);
        s->report = newton(&s->bar, &loose, s->u);
        expect(s->report.status == OK, "log law started at F = %g: %s",
               oracle_false[k].F0, status_name(s->report.status));
        expect_close(bar_stretch(&s->bar, s->u, 1), 1.0, 1e-7, 1.0,
                     "log law started at F = %g, tolerance 1e-8: F after %d "
                     "steps", oracle_false[k].F0, s->report.iterations);
        bar_state_free(s);
    }

    /* the first element carries c (1 - 1/2n); P' = 2 mu + lambda at rest */
    scene = bar_scene_notes(LOG, 12);
    const double limit = -material_modulus(&scene.material) / (1 - 1.0 / 24);
    for (int beyond = 0; beyond < 2; beyond++) {
        scene.c = (beyond ? 1.0001 : 0.9999) * limit;
        s = solved(&scene, 100);
        expect(s->report.status == (beyond ? INVERTED : OK),
               "standing bar, log law, c = %g: the first step inverts it "
               "beyond c = %g, but the status is %s", scene.c, limit,
               status_name(s->report.status));
        bar_state_free(s);
    }
}

static void example_is_sin_t(void)
{
    for (int r = 0; r < 2 * COUNT(oracle_example); r++) {
        const struct oracle_example *o = &oracle_example[r / 2];
        const int want = r % 2 ? o->log : o->cubic;
        const struct bar_scene scene = bar_scene_notes(r % 2 ? LOG : CUBIC,
                                                       o->n);
        const struct newton_control control = bar_scene_control(&scene);
        struct bar_state *s = bar_state_by(load_vector, &scene);
        int most = 0;
        for (int m = 0; m * o->dt <= 6.3 + 0.5 * o->dt && most >= 0; m++) {
            s->u[0] = sin(m * o->dt);
            s->report = newton(&s->bar, &control, s->u);
            most = s->report.status != OK ? -1
                   : s->report.iterations > most ? s->report.iterations : most;
            for (int i = 0; i <= o->n && most >= 0; i++)
                expect_close(s->u[i], sin(m * o->dt), 1e-12, 1.0,
                             "notes' example, %s law, t = %g: u[%d]",
                             material_law(scene.material.law), m * o->dt, i);
        }
        expect(want < 0 ? s->report.status == INVERTED
                        : most >= 0 && abs(most - want) <= 2,
               "notes' example, n = %d, dt = %g, %s law: %s, at most %d steps; "
               "the oracle has %d (-1: INVERTED)", o->n, o->dt,
               material_law(scene.material.law),
               status_name(s->report.status), most, want);
        bar_state_free(s);
    }
}

static void bars_under_weight_are_the_oracles(void)
{
    for (int k = 0; k < 2 * COUNT(oracle_weight); k++) {
        const struct oracle_weight *o = &oracle_weight[k / 2];
        struct bar_scene scene = bar_scene_notes(k % 2 ? LOG : CUBIC, 4);
        scene.c = o->c;
        struct bar_state *s = answer(&scene);
        for (int i = 0; i < 4; i++)
            expect_close(s->u[i + 1], o->law[k % 2].u4[i], 1e-11, 1.0,
                         "c = %g, %s law, 4 elements: u[%d]", o->c,
                         material_law(scene.material.law), i + 1);
        expect_close(bar_state_reaction(s), -o->c, 1e-11, FORCE,
                     "c = %g: the force that holds the bar", o->c);
        bar_state_free(s);
    }
}

/* The same discrete equations, solved to n eps of the displacement.  Scene
 * 0 is beyond the limit load of nu = 0: both stop where K is indefinite. */
static void loads_and_newton_agree_with_common(void)
{
    for (int k = 0; k < 16; k++) {
        struct bar_scene scene = bar_scene_notes(k & 1 ? LOG : CUBIC,
                                                 k & 2 ? 45 : 5);
        scene.shape = k & 2 ? COSINE : UNIFORM;
        scene.c = k & 4 ? -1200.0 : 600.0;
        scene.held[1] = k >> 3;
        if (k == 0) scene.material = material_make(CUBIC, 1000.0, 0.0);
        struct newton_control control = bar_scene_control(&scene);
        control.definite = 1;
        struct bar_state *s = solved(&scene, 100);
        struct bar_state *t = bar_scene_solve(&scene, &control);
        expect(s->report.status == t->report.status &&
                   abs(s->report.iterations - t->report.iterations) <= 1,
               "scene %d, c = %g: %s after %d steps, bar_newton() says %s "
               "after %d", k, scene.c, status_name(s->report.status),
               s->report.iterations, status_name(t->report.status),
               t->report.iterations);
        for (int i = 0; i <= scene.n; i++) {
            expect_close(s->b[i], t->b[i], ROUND_OFF, 600.0,
                         "scene %d, c = %g: b[%d], against bar_scene_load()",
                         k, scene.c, i);
            if (t->report.status == OK)
                expect_close(s->u[i], t->u[i], 1e-12, 1.0,
                             "scene %d, c = %g: u[%d], against bar_newton()",
                             k, scene.c, i);
        }
        expect((t->report.status == NOT_SPD) == (k == 0),
               "scene %d: bar_newton() says %s", k,
               status_name(t->report.status));
        bar_state_free(s);
        bar_state_free(t);
    }
}

static double second_derivative(const struct material *m, double F)
{
    const double d = 1e-5;
    return (material1_dpk1(m, F + d) - material1_dpk1(m, F - d)) / (2.0 * d);
}

/* The first element, whose error is the largest; its error before step 5 is
 * 2e-4, which is the size of the next term. */
static void each_step_squares_the_error(void)
{
    struct bar_scene scene = bar_scene_notes(CUBIC, 12);
    scene.c = -1300.0;
    double F[3];
    for (int k = 0; k < 3; k++) {
        struct bar_state *s = solved(&scene, k < 2 ? 4 + k : 100);
        F[k] = bar_stretch(&s->bar, s->u, 1);
        bar_state_free(s);
    }
    const double before = F[0] - F[2], after = F[1] - F[2];
    expect_close(after / (before * before),
                 0.5 * second_derivative(&scene.material, F[2]) /
                     material1_dpk1(&scene.material, F[2]),
                 2e-3, 1.0, "step 5 of the standing bar: error over the square "
                 "of the error before, against P''/2P'");
}

static void history_shows_the_failure(void)
{
    struct output *failed =
        run_unsolved("--law log --c -2000 --n 8", "full steps: INVERTED");
    expect(row_count(failed, "history") == 2 &&
               is_missing(failed, "history", "residual", 1) &&
               cell(failed, "history", "min_F", 1) < 0.0,
           "log law, c = -2000: the history must end with the inverted state, "
           "which has no residual");
    expect(!has_table(failed, "nodes"), "a bar without a solution has nodes");
    run_unsolved("--nu 0 --c 540 --n 16", "full steps: NOT_SPD");
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("");
    const char *pressed = "--n 10 --law log --c 0 --left 0.099999999";
    measured("1", fabs(cell(output, "history", "min_F", 5) -
                       cell(output, "history", "min_F", -1)));
    measured("2", cell(run(pressed), "history", "increment", 1));
}

static const struct claim claims[] = {
    {"loads_are_the_integrals", loads_are_the_integrals, "10a"},
    {"residual_of_a_shifted_bar_is_minus_b",
     residual_of_a_shifted_bar_is_minus_b, "10b"},
    {"residual_agrees_with_common", residual_agrees_with_common, "10b"},
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
     "10e"},
    {"loads_and_newton_agree_with_common", loads_and_newton_agree_with_common,
     "10e"},
    {"each_step_squares_the_error", each_step_squares_the_error, "10e"},
    {"history_shows_the_failure", history_shows_the_failure, "10e"},
};

/* The last but one presses element 1 to F = 2^-40, where the first increment is
 * below the tolerance. */
static const char *const runs[] = {
    "",
    "--n 7 --law log --held right --c 371.4 --left 2.385",
    "--n 7 --held right --c 238.5 --left -61.3",
    "--n 9 --law log --c 613 --right 371.4 --nu 0.2385",
    "--n 5 --held both --left 0.02385 --right -0.0731 --c 124.7",
    "--n 1 --c 238.5",
    "--n 8 --law log --c 0 --left 0.12499999999988631",
};

#define SUMS "sums of two element values"
#define SOLVED "Newton to 1e-12, condition number below 1e5"
static const struct column_rule rules[] = {
    {"b", "*", 1e-13, SUMS, 0},
    {"q", "*", 1e-12, SUMS, 0},
    {"K", "*", 1e-12, SUMS, 0},
    {"du", "*", 1e-9, "direct solve, condition number below 1e3", 0},
    {"history", "k", 0, "a count", 0},
    {"history", "*", 1e-3, "a start at F = 1e-12 is known to 1e-4", 0},
    {"nodes", "*", 1e-9, SOLVED, 0},
};

static const struct lesson lesson = {
    "10_neohookean_bar", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Table `history`: each of the last steps squares the increment; the factor "
    "is known beforehand (figures/10_neohookean_bar/newton.svg). A step may "
    "still be worse than none: look at the residual of step 1.",
    "Stop on max|du| alone, and press the first element of a log law to 1e-8 "
    "of its length (--law log --c 0 --left 0.099999999 --n 10): which number "
    "would have told the loop that this is no solution?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
