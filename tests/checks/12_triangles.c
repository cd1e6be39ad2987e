/*
 * 12_triangles.c - what a right static solve in the plane satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *     12a      t, g, u        edges_become_edges: unequal triangles, any u
 *     12b      s->f           force_is_the_gradient_...: any; others: 0
 *     12b, c   s->mesh        unequal triangles; in the_books_are_right a strip
 *     12b, c   material       both laws, each with moduli of its own
 *     12b, c   u              turned, sheared, squeezed, inside out
 *     12c      K              dense, banded; not 0 before
 *     12d      held, q, K     left side; right side but for a corner; not SPD
 *     12e      tolerance, cap 1 to 1e-3 and 1e-10, cap 2 in failures_are_named,
 *                    0 to 3 in the_books_are_right, 1 where it is enough
 *     12e      s, u           all scenes of scene.h; vertex 0 held, and free
 */
#include "program.h"

#include "judge.h"

#include "../oracle/02_constitutive.h"
#include "../oracle/12_triangles.h"

#include <gsl/gsl_math.h>
#include <string.h>

#define ROUND_OFF 1e-12 /* sums of some hundred products */
#define DERIVATIVE 1e-7 /* central differences, the best of a sweep of steps */
#define CONVERGED 1e-9  /* quadratic: far beyond the tolerance 1e-10 */

/* ---- a body that no formula is made for ---------------------------------- */

enum { N = 4, N_VERTEX = 25, N_DOF = 50, BAND = 2 * N + 5 };

/* A smooth, irregular number in (-1, 1) for each r. */
static double odd_number(int r)
{
    return sin(2.385 * r + 0.613) * cos(0.3714 * r * r + 0.2385);
}

/* The body of the scene again, after its mesh or held[] has changed. */
static void remake_body(struct scene *s)
{
    const struct material material = s->body->material;
    body_free(s->body);
    expect(mesh_clockwise(s->mesh) < 0, "the mesh is not the one intended");
    s->body = body_alloc(s->mesh, material, 0.0, CONSISTENT, s->held);
}

/* Interior vertices displaced, edges of the right side unequal; no forces; the
 * left side and one more vertex held. */
static struct scene *skew_scene(enum law law)
{
    struct scene_setting set = scene_notes(GRAVITY, law, N);
    set.E = law == LOG ? 371.4 : 238.5;
    set.nu = law == LOG ? 0.2385 : 0.3137;
    struct scene *s = scene_alloc(&set);
    for (int a = 0; a < N_VERTEX; a++) {
        const int inside_x = a % (N + 1) > 0 && a % (N + 1) < N;
        const int inside_y = a / (N + 1) > 0 && a / (N + 1) < N;
        if (inside_x) s->mesh->X[2 * a] += 0.11 * odd_number(2 * a);
        if (inside_y) s->mesh->X[2 * a + 1] += 0.11 * odd_number(2 * a + 1);
    }
    for (int r = 0; r < N_DOF; r++) s->f[r] = 0.0;
    s->held[N_VERTEX - 1] = 1;
    remake_body(s);
    return s;
}

/* The right side held in place of the left one, but for its upper corner: the
 * first vertex and the last one are free. */
static void hold_the_right_side(struct scene *s)
{
    for (int a = 0; a < N_VERTEX; a++)
        s->held[a] = a % (N + 1) == N && a < N_VERTEX - 1;
    remake_body(s);
}

/* u of the affine map x = F X + (0.3, -0.2), plus something irregular. */
static void deform(const struct scene *s, mat2 F, double amount, double u[])
{
    for (int r = 0; r < s->n_dof; r++) {
        const double *X = &s->mesh->X[r / 2 * 2];
        u[r] = F.m[r % 2][0] * X[0] + F.m[r % 2][1] * X[1] - X[r % 2] +
               (r % 2 ? -0.2 : 0.3) + amount * odd_number(r);
    }
}

static const mat2 squeezed = {{{0.8714, 0.2385}, {-0.1371, 1.1238}}};

static void force_of(const struct scene *s, const double u[], double q[])
{
    expect(residual(s, u, q) == OK,
           "residual() does not return OK where the material is defined");
}

static const char *name_of(enum law law)
{
    return material_law(law);
}

/* ---- 12a ----------------------------------------------------------------- */

/* F D_m = D_s: edges at rest become edges now [eq:triangle-gradient]. */
static void edges_become_edges(void)
{
    struct scene *s = skew_scene(CUBIC);
    double u[N_DOF], g[6];
    deform(s, squeezed, 0.04, u);
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const int *t = &s->mesh->triangle[3 * e];
        mesh_gradients(s->mesh, e, g);
        const mat2 F = deformation(t, g, u);
        for (int a = 1; a < 3; a++)
            for (int i = 0; i < 2; i++) {
                const double *X = s->mesh->X;
                const double before[2] = {X[2 * t[a]] - X[2 * t[0]],
                                          X[2 * t[a] + 1] - X[2 * t[0] + 1]};
                expect_close(F.m[i][0] * before[0] + F.m[i][1] * before[1],
                             before[i] + u[2 * t[a] + i] - u[2 * t[0] + i],
                             ROUND_OFF, 1.0,
                             "triangle %d: component %d of F times the edge "
                             "from vertex %d to %d, against the deformed edge",
                             e, i, t[0], t[a]);
            }
    }
    scene_free(s);
}

/* ---- 12b ----------------------------------------------------------------- */

static void rigid_motion_gives_no_force(void)
{
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = skew_scene(law);
        const double *X = s->mesh->X;
        double u[N_DOF], turned[N_DOF], force[N_DOF], force_turned[N_DOF];
        deform(s, mat2_rotation(0.6137), 0.0, u);
        force_of(s, u, force);
        for (int r = 0; r < N_DOF; r++)
            expect_close(force[r], 0.0, ROUND_OFF, 371.4,
                         "internal force at vertex %d after a rotation", r / 2);

        /* a turned body has turned forces */
        const mat2 Q = mat2_rotation(1.238);
        deform(s, squeezed, 0.03, u);
        for (int r = 0; r < N_DOF; r++) {
            const int x = r / 2 * 2;
            turned[r] = Q.m[r % 2][0] * (X[x] + u[x]) +
                        Q.m[r % 2][1] * (X[x + 1] + u[x + 1]) - X[r];
        }
        force_of(s, u, force);
        force_of(s, turned, force_turned);
        for (int r = 0; r < N_DOF; r++)
            expect_close(force_turned[r],
                         Q.m[r % 2][0] * force[r / 2 * 2] +
                             Q.m[r % 2][1] * force[r / 2 * 2 + 1],
                         ROUND_OFF, 371.4,
                         "force at vertex %d of the turned body, against the "
                         "turned force", r / 2);
        scene_free(s);
    }
}

static void forces_and_torques_balance(void)
{
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = skew_scene(law);
        const double *X = s->mesh->X;
        double u[N_DOF], force[N_DOF], sum[2] = {0.0, 0.0}, torque = 0.0;
        double largest = 0.0;
        deform(s, squeezed, 0.04, u);
        force_of(s, u, force);
        for (int x = 0, y = 1; x < N_DOF; x += 2, y += 2) {
            sum[0] += force[x];
            sum[1] += force[y];
            torque += (X[x] + u[x]) * force[y] - (X[y] + u[y]) * force[x];
            largest = fmax(largest, hypot(force[x], force[y]));
        }
        expect(largest > 1.0, "the internal forces are all 0");
        for (int i = 0; i < 2; i++)
            expect_close(sum[i], 0.0, ROUND_OFF, 10.0 * largest,
                         "sum of the internal forces, component %d", i);
        expect_close(torque, 0.0, ROUND_OFF, 10.0 * largest,
                     "sum of the internal torques about deformed positions");
        scene_free(s);
    }
}

/* F the same everywhere: nothing is left over inside, P N length on a side. */
static void patch_test(void)
{
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = skew_scene(law);
        double u[N_DOF], force[N_DOF];
        const mat2 stress = material2_pk1(&s->body->material, squeezed);
        deform(s, squeezed, 0.0, u);
        force_of(s, u, force);
        for (int a = 0; a < N_VERTEX; a++) {
            const int i = a % (N + 1), j = a / (N + 1);
            if (i == 0 || j == 0 || j == N) continue;
            const double *above = &s->mesh->X[2 * (a + N + 1)];
            const double *below = &s->mesh->X[2 * (a - N - 1)];
            const double length = i == N ? 0.5 * (above[1] - below[1]) : 0.0;
            for (int k = 0; k < 2; k++)
                expect_close(force[2 * a + k], stress.m[k][0] * length,
                             ROUND_OFF, 371.4,
                             "affine map, irregular mesh: force at %s vertex "
                             "%d, component %d",
                             i == N ? "boundary" : "interior", a, k);
        }
        scene_free(s);
    }
}

/* Psi - f.u [eq:body-energy] */
static double potential(const struct scene *s, const double u[])
{
    double energy;
    expect(body_energy(s->body, u, &energy) == OK, "no energy");
    for (int r = 0; r < N_DOF; r++) energy -= s->f[r] * u[r];
    return energy;
}

/* Inside out: a state of every law that is defined there. */
static void ask_inside_out(enum law law, enum status status, const char *who)
{
    const enum status due = law == CUBIC ? OK : INVERTED;
    expect(status == due, "a body turned inside out, J = -0.5, with the %s "
           "law: %s: got %s, want %s", material_law(law), who,
           status_name(status), status_name(due));
}

/* Another derivation, see body.h; also where the log law ends. */
static void force_agrees_with_body_h(void)
{
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = skew_scene(law);
        double *u = guarded_alloc(N_DOF), *q = guarded_alloc(N_DOF);
        double want[N_DOF];
        deform(s, squeezed, 0.04, u);
        expect(body_force(s->body, u, want) == OK, "body.h fails");
        force_of(s, u, q);
        for (int r = 0; r < N_DOF; r++)
            expect_close(q[r], want[r], ROUND_OFF, 371.4,
                         "q of vertex %d, component %d, against body.h", r / 2,
                         r % 2);
        deform(s, (mat2){{{-0.5, 0.0}, {0.0, 1.0}}}, 0.0, u);
        ask_inside_out(law, residual(s, u, q), "residual()");
        scene_free(s);
    }
}

static void force_is_the_gradient_of_the_energy(void)
{
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = skew_scene(law);
        double u[N_DOF], q[N_DOF], plus[N_DOF], minus[N_DOF];
        double slope = 0.0, size = 0.0, best = INFINITY, found = 0.0;
        deform(s, squeezed, 0.03, u);
        for (int r = 0; r < N_DOF; r++) s->f[r] = 71.37 * odd_number(r + 37);
        force_of(s, u, q);
        for (int r = 0; r < N_DOF; r++) {
            slope += q[r] * odd_number(r + 91);
            size += fabs(q[r] * odd_number(r + 91));
        }
        for (double h = 1e-2; h > 1e-6; h *= 0.1) {
            for (int r = 0; r < N_DOF; r++) {
                plus[r] = u[r] + h * odd_number(r + 91);
                minus[r] = u[r] - h * odd_number(r + 91);
            }
            const double difference =
                (potential(s, plus) - potential(s, minus)) / (2.0 * h);
            if (fabs(difference - slope) < best) {
                best = fabs(difference - slope);
                found = difference;
            }
        }
        expect_close(slope, found, DERIVATIVE, size,
                     "%s law: q along a direction, against the change of "
                     "Psi - f.u", name_of(law));
        scene_free(s);
    }
    force_agrees_with_body_h();
}

/* ---- 12c ----------------------------------------------------------------- */

/* The change of q for a small change of u, by differences: the step of the
 * sweep that fits `got` best. */
static double slope_of_q(const struct scene *s, const double u[],
                         const double along[], const double got[],
                         double want[])
{
    double plus[N_DOF], minus[N_DOF], moved[N_DOF];
    double best = INFINITY, size = 0.0;
    for (double h = 1e-2; h > 1e-7; h *= 0.1) {
        double off = 0.0;
        for (int r = 0; r < N_DOF; r++) moved[r] = u[r] + h * along[r];
        force_of(s, moved, plus);
        for (int r = 0; r < N_DOF; r++) moved[r] = u[r] - h * along[r];
        force_of(s, moved, minus);
        for (int r = 0; r < N_DOF; r++) {
            moved[r] = (plus[r] - minus[r]) / (2.0 * h);
            off = fmax(off, fabs(moved[r] - got[r]));
            size = fmax(size, fabs(moved[r]));
        }
        if (off < best) memcpy(want, moved, sizeof moved);
        best = fmin(best, off);
    }
    return size;
}

static void tangent_is_the_derivative_of_the_force(void)
{
    const mat2 shear = {{{1.0, 0.5}, {0.0, 1.0}}};
    const mat2 states[] = {mat2_identity(), mat2_rotation(M_PI / 6.0), shear,
                           squeezed};
    const char *const names[] = {"at rest", "turned by 30 degrees", "sheared",
                                 "squeezed and irregular"};
    for (int c = 0; c < 8; c++) {
        const enum law law = c % 2 ? CUBIC : LOG;
        struct scene *s = skew_scene(law);
        struct matrix *K = matrix_alloc(DENSE, N_DOF, 0);
        double u[N_DOF], along[N_DOF], got[N_DOF], want[N_DOF] = {0.0};
        deform(s, states[c / 2], c / 2 == 3 ? 0.03 : 0.0, u);
        for (int r = 0; r < N_DOF; r++) along[r] = odd_number(r + 53);
        expect(tangent(s, u, K) == OK, "tangent() does not return OK");
        matrix_multiply(K, along, got);
        const double size = slope_of_q(s, u, along, got, want);
        for (int r = 0; r < N_DOF; r++)
            expect_close(got[r], want[r], DERIVATIVE, size,
                         "%s, %s law: K times a direction, row %d, against the "
                         "change of q", names[c / 2], name_of(law), r);
        for (int r = 0; r < N_DOF; r++)
            for (int z = 0; z < r; z++)
                expect_close(matrix_get(K, r, z), matrix_get(K, z, r),
                             ROUND_OFF, size, "%s: K[%d][%d] against K[%d][%d]",
                             names[c / 2], r, z, z, r);
        matrix_free(K);
        scene_free(s);
    }
}

/* Another derivation, see body.h; also where the log law ends. */
static void agrees_with_the_fast_body(void)
{
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = skew_scene(law);
        struct matrix *K = matrix_alloc(BANDED, N_DOF, BAND);
        struct matrix *fast = body_matrix(s->body);
        double *u = guarded_alloc(N_DOF);
        deform(s, squeezed, 0.04, u);
        matrix_add(K, 24, 24, 2.385); /* tangent() has to forget it */
        expect(body_stiffness(s->body, u, EXACT, fast) == OK &&
                   tangent(s, u, K) == OK, "tangent() does not return OK");
        for (int r = 0; r < N_DOF; r++)
            for (int z = 0; z <= r; z++) {
                const int *number = s->body->equation;
                if (number[r] < 0 || number[z] < 0 || r - z > BAND) continue;
                expect_close(matrix_get(K, r, z),
                             matrix_get(fast, number[r], number[z]), ROUND_OFF,
                             371.4, "K[%d][%d], against body.h", r, z);
            }
        deform(s, (mat2){{{-0.5, 0.0}, {0.0, 1.0}}}, 0.0, u);
        ask_inside_out(law, tangent(s, u, K), "tangent()");
        matrix_free(K);
        matrix_free(fast);
        scene_free(s);
    }
}

/* ---- 12d ----------------------------------------------------------------- */

/* One increment near a rigid motion; the caller frees K. */
static void one_increment(struct scene *s, struct matrix *K, const char *held)
{
    struct matrix *copy = matrix_alloc(BANDED, N_DOF, BAND);
    struct matrix *fast = body_matrix(s->body);
    double *q = guarded_alloc(N_DOF), *du = guarded_alloc(N_DOF);
    double u[N_DOF], Kdu[N_DOF], also[N_DOF], largest = 0.0;
    deform(s, mat2_rotation(0.3714), 0.01, u);
    for (int r = 0; r < N_DOF; r++) q[r] = odd_number(r + 17);
    expect(tangent(s, u, K) == OK && tangent(s, u, copy) == OK,
           "tangent() does not return OK");
    expect(body_stiffness(s->body, u, EXACT, fast) == OK &&
               body_increment(s->body, fast, q, also) == OK, "body.h fails");
    int *is_held = s->held; /* beside it: numbers that are not 0 */
    s->held = guarded_indices(N_VERTEX, is_held);
    const enum status status = increment(s, K, q, du);
    s->held = is_held;
    expect(status == OK, "K is %s near a rigid motion, with the %s side held",
           status_name(status), held);
    matrix_multiply(copy, du, Kdu);
    for (int r = 0; r < N_DOF; r++) largest = fmax(largest, fabs(du[r]));
    expect(largest > 0.0, "du is 0 at every vertex");
    for (int r = 0; r < N_DOF; r++) {
        if (s->held[r / 2])
            expect_close(du[r], 0.0, ROUND_OFF, largest,
                         "du of held vertex %d, component %d", r / 2, r % 2);
        else
            expect_close(Kdu[r], -q[r], 1e-11, 1.0,
                         "%s side held: row %d of K du, against -q", held, r);
        expect_close(du[r], also[r], 1e-11, largest,
                     "%s side held: du of vertex %d, component %d, against "
                     "body.h", held, r / 2, r % 2);
    }
    matrix_free(copy);
    matrix_free(fast);
}

static void increment_solves_the_held_system(void)
{
    struct scene *s = skew_scene(CUBIC);
    struct matrix *K = matrix_alloc(BANDED, N_DOF, BAND);
    double q[N_DOF], du[N_DOF], u[N_DOF];
    one_increment(s, K, "left");
    hold_the_right_side(s);
    one_increment(s, K, "right");
    /* squeezed to a tenth, the body buckles: K has a negative eigenvalue */
    deform(s, (mat2){{{0.1, 0.0}, {0.0, 1.0}}}, 0.0, u);
    for (int r = 0; r < N_DOF; r++) q[r] = odd_number(r + 17);
    expect(tangent(s, u, K) == OK, "tangent() does not return OK");
    expect(increment(s, K, q, du) == NOT_SPD,
           "K is not positive definite in a body squeezed to a tenth of its "
           "length: increment() must return NOT_SPD");
    matrix_free(K);
    scene_free(s);
}

/* ---- 12e ----------------------------------------------------------------- */

/* A body that is pressed to a thousandth: from an interior that is off by two
 * hundredths of the rest, a step is far below the tolerance, and leaves forces
 * of the size of the modulus.  The unit of force does not matter. */
static void small_steps_are_no_solution(void)
{
    const double eps = 1e-3, tolerance = 1e-3;
    const mat2 pressed = {{{eps, 0.0}, {0.0, eps}}};
    for (int k = 0; k < 2; k++) {
        struct scene *s = skew_scene(LOG);
        double u[N_DOF], want[N_DOF];
        s->body->material.mu *= k ? 1e-9 : 1.0;
        s->body->material.lambda *= k ? 1e-9 : 1.0;
        for (int a = 0; a < N_VERTEX; a++) {
            const int i = a % (N + 1), j = a / (N + 1);
            s->held[a] = i == 0 || i == N || j == 0 || j == N;
        }
        remake_body(s);
        deform(s, pressed, 0.0, want);
        for (int r = 0; r < N_DOF; r++)
            u[r] = want[r] + (s->held[r / 2] ? 0.0 : 0.01 * eps *
                                                         odd_number(r));
        const struct history report = equilibrium(s, tolerance, HISTORY_CAP, u);
        expect(report.status == OK, "a body pressed to a thousandth: %s",
               status_name(report.status));
        for (int r = 0; r < N_DOF; r++)
            expect_close(u[r], want[r], 3e-6, eps,
                         "a body pressed to a thousandth, modulus %.3g, "
                         "tolerance 1e-3: u of vertex %d, component %d, after "
                         "%d iterations; q has to be small as well",
                         material_modulus(&s->body->material), r / 2, r % 2,
                         report.iterations);
        scene_free(s);
    }
}

/* q is below the tolerance, and u is off by more than the tolerance: the first
 * increment is not small, and only the second one is. */
static void small_forces_are_no_solution(void)
{
    struct scene *s = skew_scene(CUBIC);
    double u[N_DOF];
    for (int r = 0; r < N_DOF; r++) {
        const double *X = &s->mesh->X[r / 2 * 2];
        u[r] = s->held[r / 2] || r % 2 == 0
                   ? 0.0 : 5e-6 * 0.25 * gsl_pow_2(X[0] + 1.0) * (1.0 - X[0]);
    }
    const struct history report = equilibrium(s, 1e-6, HISTORY_CAP, u);
    expect(report.status == OK && report.iterations == 2,
           "a body that is bent by 5e-6, tolerance 1e-6: %s after %d "
           "iterations, not OK after 2; the increment of the last one has to "
           "be small as well", status_name(report.status), report.iterations);
    for (int r = 0; r < N_DOF; r++)
        expect_close(u[r], 0.0, 1e-8, 1.0,
                     "a body that was bent by 5e-6 and is at rest: u of vertex "
                     "%d, component %d", r / 2, r % 2);
    scene_free(s);
}

static void a_nan_is_nonfinite(void)
{
    struct scene *s = skew_scene(CUBIC);
    double u[N_DOF] = {0.0};
    s->f[2 * (N_VERTEX / 2)] = (double)NAN;
    const enum status status = equilibrium(s, 1e-10, HISTORY_CAP, u).status;
    expect(status == NONFINITE, "a force that is NaN: the status must be "
           "NONFINITE, not %s", status_name(status));
    scene_free(s);
}

/* At rest q and du are 0, after one iteration; and the way back to it where
 * the first unknowns and the last ones are free. */
static void rest_is_found_from_everywhere(void)
{
    for (int away = 0; away < 2; away++) {
        struct scene *s = skew_scene(CUBIC);
        double *u = guarded_alloc(N_DOF);
        hold_the_right_side(s);
        for (int r = 0; r < N_DOF; r++)
            u[r] = away && !s->held[r / 2] ? 0.03 * odd_number(r) : 0.0;
        const struct history report =
            equilibrium(s, 1e-10, away ? HISTORY_CAP : 1, u);
        expect(report.status == OK && (away || report.iterations == 1),
               "right side held, %s: %s after %d iterations, not OK%s",
               away ? "off by 0.03" : "at rest, and a cap of 1",
               status_name(report.status), report.iterations,
               away ? "" : " after 1");
        for (int r = 0; r < N_DOF; r++)
            expect_close(u[r], 0.0, CONVERGED, 1.0,
                         "right side held, no force: u of vertex %d, component "
                         "%d", r / 2, r % 2);
        scene_free(s);
    }
}

/* Newton's method by body.h, one system at a time: what the report and u have
 * to be after each of them.  A strip: its rows are longer than its columns. */
static void the_books_are_right(void)
{
    struct scene_setting set = scene_notes(TRACTION, CUBIC, 10);
    set.slender = 2;
    struct scene *s = scene_alloc(&set);
    double *u = allocate(4 * (size_t)s->n_dof, sizeof *u);
    double *mine = u + s->n_dof;
    double *q = mine + s->n_dof, *du = q + s->n_dof;
    struct matrix *K = body_matrix(s->body);
    double residuals[4], increments[4];
    for (int cap = 0; cap < 4; cap++) {
        for (int r = 0; r < s->n_dof; r++) mine[r] = 0.0;
        const struct history report = equilibrium(s, 1e-10, cap, mine);
        expect(report.status == MAX_ITERATIONS && report.iterations == cap,
               "a cap of %d systems: %s after %d, not MAX_ITERATIONS after %d",
               cap, status_name(report.status), report.iterations, cap);
        expect(body_force(s->body, u, q) == OK, "body.h fails");
        for (int r = 0; r < s->n_dof; r++) {
            q[r] -= s->f[r];
            expect_close(mine[r], u[r], CONVERGED, 1.0,
                         "u of vertex %d, component %d, after %d systems",
                         r / 2, r % 2, cap);
        }
        residuals[cap] = body_max_free(s->body, q);
        for (int k = 0; k <= cap; k++) {
            expect_close(report.residual[k], residuals[k], CONVERGED,
                         set.E, "report.residual[%d], max|q| before system %d",
                         k, k);
            if (k < cap)
                expect_close(report.increment[k], increments[k], CONVERGED, 1.0,
                             "report.increment[%d], max|du| of system %d", k,
                             k);
        }
        expect(body_stiffness(s->body, u, EXACT, K) == OK &&
                   body_increment(s->body, K, q, du) == OK, "body.h fails");
        increments[cap] = body_max_free(s->body, du);
        for (int r = 0; r < s->n_dof; r++) u[r] += du[r];
    }
    matrix_free(K);
    free(u);
    scene_free(s);
}

/* The whole boundary moved by an affine map: inside, it is the solution. */
static void affine_boundary_gives_the_affine_solution(void)
{
    small_steps_are_no_solution();
    small_forces_are_no_solution();
    rest_is_found_from_everywhere();
    a_nan_is_nonfinite();
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = skew_scene(law);
        double u[N_DOF], want[N_DOF];
        for (int a = 0; a < N_VERTEX; a++) {
            const int i = a % (N + 1), j = a / (N + 1);
            s->held[a] = i == 0 || i == N || j == 0 || j == N;
        }
        remake_body(s);
        deform(s, squeezed, 0.0, want);
        for (int r = 0; r < N_DOF; r++)
            u[r] = want[r] + (s->held[r / 2] ? 0.0 : 0.03 * odd_number(r));
        const struct history report = equilibrium(s, 1e-10, HISTORY_CAP, u);
        expect(report.status == OK, "%s law, affine boundary values: %s",
               name_of(law), status_name(report.status));
        for (int r = 0; r < N_DOF; r++)
            expect_close(u[r], want[r], ROUND_OFF, 1.0,
                         "%s law, affine boundary values, irregular mesh: u of "
                         "vertex %d, component %d", name_of(law), r / 2, r % 2);
        scene_free(s);
    }
}

/* The digits double: |du| of a step is at most C times that before, squared. */
static void newton_doubles_the_digits(void)
{
    the_books_are_right();
    for (int c = 0; c < 6; c++) {
        const enum reading reading[] = {STRETCH, COMPRESS, GRAVITY};
        struct scene_setting set =
            scene_notes(reading[c / 2], c % 2 ? CUBIC : LOG, 6);
        set.reach = 0.3714;
        struct scene *s = scene_alloc(&set);
        scene_hold(s, 1.0);
        step_boundary(s->body, s->g, 1, s->u);
        const struct history report = equilibrium(s, 1e-10, HISTORY_CAP, s->u);
        const double *du = report.increment;
        expect(report.status == OK, "%s, %s law: %s", scene_name(set.reading),
               name_of(set.law), status_name(report.status));
        expect(report.iterations >= 4 && report.iterations <= 7,
               "%s, %s law: %d iterations; a right tangent needs 4 to 7",
               scene_name(set.reading), name_of(set.law), report.iterations);
        for (int k = 1; k < report.iterations; k++)
            expect(du[k - 1] > 0.02 || du[k] < 10.0 * du[k - 1] * du[k - 1] +
                                                   1e-13,
                   "%s, %s law: max|du| %.2g is followed by %.2g, which is not "
                   "quadratic", scene_name(set.reading), name_of(set.law),
                   du[k - 1], du[k]);
        expect(report.residual[report.iterations] < 1e-7,
               "%s, %s law: max|q| is %.2g at the end",
               scene_name(set.reading), name_of(set.law),
               report.residual[report.iterations]);
        scene_free(s);
    }
}

/* Statics of step.h: dt = 1 and rho = 0. */
static void agrees_with_the_fast_solver(void)
{
    for (int c = 0; c < 2 * SPIN; c++) {
        struct scene_setting set =
            scene_notes((enum reading)(c / 2), c % 2 ? CUBIC : LOG, 5);
        set.E = 371.4;
        set.rho = 0.0;
        set.reach = 0.3714;
        set.force = 13.71;
        struct scene *s = scene_alloc(&set);
        const struct step_control control = {
            .tolerance = 1e-12, .max_iterations = 50};
        double u[72];
        scene_hold(s, 1.238);
        step_boundary(s->body, s->g, 1, s->u);
        memcpy(u, s->u, sizeof u);
        expect(step_solve(s->body, &control, at_rest(s->f), u).status == OK,
               "step.h fails");
        const struct history report = equilibrium(s, 1e-10, HISTORY_CAP, s->u);
        expect(report.status == OK, "%s, %s law: %s", scene_name(set.reading),
               name_of(set.law), status_name(report.status));
        for (int r = 0; r < 72; r++)
            expect_close(s->u[r], u[r], CONVERGED, 1.0,
                         "%s, %s law: u of vertex %d, component %d, against "
                         "step.h", scene_name(set.reading), name_of(set.law),
                         r / 2, r % 2);
        scene_free(s);
    }
}

/* Of its own history: it is done in the end, and was not before. */
static void it_stops_where_it_is_told(void)
{
    for (int c = 0; c < 24; c++) {
        const double tolerance = pow(10.0, -0.25 * (c / 2));
        struct scene_setting set =
            scene_notes(c % 2 ? COMPRESS : STRETCH, CUBIC, 4);
        set.reach = 0.5;
        struct scene *s = scene_alloc(&set);
        const double weight = material_modulus(&s->body->material);
        scene_hold(s, 1.0);
        step_boundary(s->body, s->g, 1, s->u);
        const struct history report =
            equilibrium(s, tolerance, HISTORY_CAP, s->u);
        expect(report.status == OK, "%s, tolerance %.2g: %s",
               scene_name(set.reading), tolerance, status_name(report.status));
        for (int k = 1; k <= report.iterations; k++) {
            const double du = report.increment[k - 1];
            const double q = report.residual[k] / weight;
            const int done = du <= tolerance && q <= tolerance;
            expect(done == (k == report.iterations),
                   "%s, tolerance %.2g: max|du| is %.2g m and then max|q| %.2g "
                   "(2 mu + lambda): %s", scene_name(set.reading), tolerance,
                   du, q, done ? "it is done, and goes on"
                               : "it is not done, and ends");
        }
        scene_free(s);
    }
}

/* Ends that have been pushed through each other: u stays as it is, which is the
 * last state reached. */
static void an_inverted_start_stays(void)
{
    const struct scene_setting set = scene_notes(COMPRESS, LOG, 4);
    struct scene *s = scene_alloc(&set);
    scene_hold(s, 1.238);
    step_boundary(s->body, s->g, 0, s->u);
    const double *u = guarded_copy(s->n_dof, s->u);
    const enum status status = equilibrium(s, 1e-10, HISTORY_CAP, s->u).status;
    expect(status == INVERTED, "a start that is inverted: INVERTED, not %s",
           status_name(status));
    for (int r = 0; r < s->n_dof; r++)
        expect(s->u[r] == u[r], "a start that is inverted: u[%d] is %g, not %g "
               "as before", r, s->u[r], u[r]);
    scene_free(s);
}

static void failures_are_named(void)
{
    it_stops_where_it_is_told();
    an_inverted_start_stays();
    struct scene_setting set = scene_notes(STRETCH, CUBIC, 4);
    set.reach = 0.5;
    struct scene *s = scene_alloc(&set);
    scene_hold(s, 1.0);
    step_boundary(s->body, s->g, 1, s->u);
    struct history report = equilibrium(s, 1e-10, 2, s->u);
    expect(report.status == MAX_ITERATIONS && report.iterations == 2,
           "a cap of 2 systems: MAX_ITERATIONS after 2, not %s after %d",
           status_name(report.status), report.iterations);
    s->f[2 * 12] = INFINITY; /* the vertex in the middle */
    report = equilibrium(s, 1e-10, HISTORY_CAP, s->u);
    expect(report.status == NONFINITE,
           "an infinite force: the method ends with %s, not NONFINITE",
           status_name(report.status));
    scene_free(s);

    s = scene_alloc(&set); /* so soft that q and K are finite, and du is not */
    s->body->material.mu = s->body->material.lambda = 1e-300;
    s->f[2 * 12] = 1e10;
    report = equilibrium(s, 1e-10, HISTORY_CAP, s->u);
    expect(report.status == NONFINITE,
           "du is not finite: the method ends with %s, not NONFINITE",
           status_name(report.status));
    for (int r = 0; r < s->n_dof; r++)
        expect(isfinite(s->u[r]), "du is not finite: u[%d] has taken it; the "
               "last state reached is the one before", r);
    scene_free(s);

    struct output *out = run_unsolved("--scene gravity --force 500", "NOT_SPD");
    expect(row_count(out, "history") > 1 &&
               strcmp(word(out, "history", "status", -1), "NOT_SPD") == 0 &&
               cell(out, "history", "residual", -1) > 1.0,
           "--scene gravity --force 500: the history up to the failure ends "
           "with NOT_SPD and the residual that was not solved for");
    out = run_unsolved("--scene compress --start rest --law log", "INVERTED");
    expect(is_missing(out, "history", "residual", -1),
           "a start that is inside out has no residual");
}

/* At an affine u K contains dP/dF: v.K w = area V:(dP/dF):W for the affine
 * displacements v = V X, w = W X, here of one entry each. */
static void tangent_is_the_oracles(void)
{
    for (int c = 0; c < 2 * COUNT(oracle_plane); c++) {
        const struct oracle_plane *at = &oracle_plane[c / 2];
        const struct oracle_tangent *want = c % 2 ? &at->cubic : &at->log;
        if (c % 2 == 0 && !(at->J > 0.0)) continue;
        const struct scene_setting set =
            scene_notes(GRAVITY, c % 2 ? CUBIC : LOG, N);
        struct scene *s = scene_alloc(&set);
        struct matrix *K = matrix_alloc(DENSE, N_DOF, 0);
        const mat2 F = {{{at->F[0], at->F[1]}, {at->F[2], at->F[3]}}};
        double u[N_DOF], change[2][N_DOF], out[N_DOF];
        deform(s, F, 0.0, u);
        expect(tangent(s, u, K) == OK, "tangent() does not return OK");
        for (int ab = 0; ab < 16; ab++) {
            double got = 0.0;
            for (int r = 0; r < N_DOF; r++)
                for (int k = 0; k < 2; k++) {
                    const int entry = k ? ab % 4 : ab / 4;
                    change[k][r] = r % 2 == entry / 2
                                       ? s->mesh->X[r / 2 * 2 + entry % 2]
                                       : 0.0;
                }
            matrix_multiply(K, change[1], out);
            for (int r = 0; r < N_DOF; r++) got += change[0][r] * out[r];
            expect_close(got, 4.0 * want->dP[ab / 4][ab % 4], ROUND_OFF,
                         4e3 + 4.0 * fabs(want->dP[3][3]),
                         "%s law, F %s: dP%d%d/dF%d%d, which K must contain",
                         name_of(set.law), at->name, ab / 8 + 1, ab / 4 % 2 + 1,
                         ab % 4 / 2 + 1, ab % 2 + 1);
        }
        matrix_free(K);
        scene_free(s);
    }
}

static void numbers_are_the_oracles(void)
{
    tangent_is_the_oracles();
    for (int k = 0; k < COUNT(oracle_rest); k++) {
        const char *of = oracle_rest[k].options;
        struct output *out = run(of);
        const int at[] = {12, 22, 18}; /* (0,0), (0,1), (0.5,0.5) */
        for (int i = 0; i < 2; i++) {
            const double want[] = {oracle_rest[k].centre[i],
                                   oracle_rest[k].top[i],
                                   oracle_rest[k].inner[i]};
            for (int p = 0; p < 3; p++)
                expect_close(cell(out, "nodes", i ? "u_y" : "u_x", at[p]),
                             want[p], CONVERGED, 1.0,
                             "%s: component %d of u, vertex %d", of, i, at[p]);
            expect_close(cell(out, "result", i ? "hold_y" : "hold_x", 0),
                         oracle_rest[k].hold[i], CONVERGED, 1000.0,
                         "%s: what holds the left side, component %d", of, i);
        }
        expect_close(cell(out, "result", "elastic", 0), oracle_rest[k].elastic,
                     CONVERGED, oracle_rest[k].elastic, "%s: elastic energy",
                     of);
        expect_close(cell(out, "result", "min_J", 0), oracle_rest[k].min_J,
                     CONVERGED, 1.0, "%s: least J", of);
    }
}

/* How much of the sag of the vertex (1, 0) n squares per side miss, linear
 * elasticity, nu = 0.4999: K at rest, one linear system. */
static double missing_sag(int n)
{
    struct scene_setting set = scene_notes(GRAVITY, CUBIC, n);
    set.nu = 0.4999;
    set.force = 1.0;
    struct scene *s = scene_alloc(&set);
    struct matrix *K = body_matrix(s->body);
    for (int r = 0; r < s->n_dof; r++) s->g[r] = -s->f[r]; /* q at rest */
    expect(body_stiffness(s->body, s->u, EXACT, K) == OK &&
           body_increment(s->body, K, s->g, s->u) == OK, "an increment");
    const double down = s->u[2 * (n / 2 * (n + 1) + n) + 1];
    matrix_free(K);
    scene_free(s);
    return 1.0 - down / -0.010523; /* the sag: figures/12_triangles/locking.c */
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    measured("1", cell(run("--scene gravity"), "result", "hold_y", 0));
    measured("2", cell(run(""), "history", "residual", 4));
    measured("3", missing_sag(8) / missing_sag(4));
}

static const struct claim claims[] = {
    {"edges_become_edges", edges_become_edges, "12a"},
    {"rigid_motion_gives_no_force", rigid_motion_gives_no_force, "12b"},
    {"forces_and_torques_balance", forces_and_torques_balance, "12b"},
    {"patch_test", patch_test, "12b"},
    {"force_is_the_gradient_of_the_energy",
     force_is_the_gradient_of_the_energy, "12b"},
    {"tangent_is_the_derivative_of_the_force",
     tangent_is_the_derivative_of_the_force, "12c"},
    {"agrees_with_the_fast_body", agrees_with_the_fast_body, "12c"},
    {"increment_solves_the_held_system", increment_solves_the_held_system,
     "12d"},
    {"affine_boundary_gives_the_affine_solution",
     affine_boundary_gives_the_affine_solution, "12e"},
    {"newton_doubles_the_digits", newton_doubles_the_digits, "12e"},
    {"agrees_with_the_fast_solver", agrees_with_the_fast_solver, "12e"},
    {"failures_are_named", failures_are_named, "12e"},
    {"numbers_are_the_oracles", numbers_are_the_oracles, "12e"},
};

/* The last moves so little that a wrong tangent converges as well: slowly. */
static const char *const runs[] = {
    "",
    "--n 3 --scene gravity --force 37.14",
    "--n 4 --scene compress --law log --nu 0.2385",
    "--n 3 --scene traction --law log",
    "--n 2 --scene stretch --reach 0.02385",
};

#define STATE "Newton's method to 1e-10, beyond which it is quadratic"
static const struct column_rule rules[] = {
    {"history", "k", 0, "a count", 0},
    {"history", "status", 0, "a reason", 0},
    {"history", "*", 1e-7, "differences of the iterates", 0},
    {"nodes", "X", 1e-14, "the mesh", 0},
    {"nodes", "Y", 1e-14, "the mesh", 0},
    {"nodes", "held", 0, "a word", 0},
    {"nodes", "u_x", 1e-9, STATE, 1},
    {"nodes", "u_y", 1e-9, STATE, 1},
    {"nodes", "*", 1e-8, STATE, 1000},
    {"result", "scene", 0, "a word", 0},
    {"result", "law", 0, "a word", 0},
    {"result", "min_J", 1e-9, STATE, 1},
    {"result", "*", 1e-8, STATE, 1000},
};

static const struct lesson lesson = {
    "12_triangles", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "A symmetric K can be wrong, and a K that is right at rest can be wrong: "
    "each slip of the notes' listing passes one of these two tests "
    "(figures/12_triangles/printed_tangent.svg). Compare K times a direction "
    "with the change of q, at a state that is neither at rest nor symmetric.",
    "In slot 12c give mu to one diagonal entry of each block only, as the "
    "notes print it: K stays symmetric, and what happens to the history? Then "
    "undo it and turn cof(j, m) into cof(m, j) instead: which state does "
    "tangent_is_the_derivative_of_the_force name, and why not the one at rest?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
