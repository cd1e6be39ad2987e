/* ladder.c - laws of common/choice/ladder.h and common/choice/estimate.h. */
#include "choice/climb.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HANGING, ABOVE = 5, FAST = 7, SHAKEN = 11 };

static struct ladder_state *solved(int k, enum rung rung, int moving, int level)
{
    struct ladder_state *s = ladder_solve(
        &ladder_scene[k], (struct ladder_model){rung, moving, level});
    ck_assert_int_eq(s->status, OK);
    return s;
}

/* Resultants of weight, pull, couple and push; doubled loads are doubled. */
static void loads_add_up(void)
{
    for (int k = 0; k < LADDER_SCENES; k++)
        for (int level = 0; level < 2; level++) {
            struct ladder_scene own = ladder_scene[k];
            own.push[0] = 0.2385;
            own.push[1] = -0.3714;
            const struct ladder_scene scene = ladder_loaded(&own, 2.0);
            const struct ladder_scene *one = &own;
            struct ladder_state *s = ladder_alloc(
                &scene, (struct ladder_model){LINEAR_PLANE, 0, level});
            const double height = 2.0 / scene.slender;
            double sum[2] = {0.0, 0.0}, moment = 0.0;
            for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
                sum[r % 2] += s->f[r];
                moment += r % 2 ? 0.0 : s->mesh->X[r + 1] * s->f[r];
            }
            for (int i = 0; i < 2; i++)
                close_to(sum[i],
                         2.0 * height * (2.0 * one->weight[i] + one->pull[i]) +
                             2.0 * 2.0 * one->push[i],
                         1e-10);
            /* the mesh is its own mirror image, and so are the nodal forces;
             * linear along each edge, the couple is exact */
            close_to(moment, 2.0 * one->couple * pow(height, 3) / 12.0 +
                     2.0 * 2.0 * one->push[0] * 0.5 * height, 1e-10);
            ladder_free(s);
        }
}

/* Four rows of cells, as square as an even number of columns lets them be, and
 * two columns at least; the first model is that of these. */
static void cells_are_nearly_square(void)
{
    static const double slender[] = {0.3, 0.8, 1.1, 1.9, 2.1, 7.85};
    static const int columns[] = {2, 4, 4, 8, 8, 32};
    for (int k = 0; k < COUNT(columns); k++) {
        const struct ladder_scene scene = {.slender = slender[k],
            .held = k % 2 ? LADDER_ENDS : LADDER_LEFT};
        const struct ladder_model first = ladder_first(&scene);
        struct ladder_state *s = ladder_alloc(&scene, first);
        ck_assert_int_eq(s->mesh->n, columns[k]);
        ck_assert_int_eq(s->mesh->rows, 4);
        ck_assert_int_eq(first.rung, k % 2 ? LINEAR_PLANE : BAR);
        ck_assert(!first.moving);
        ladder_free(s);
    }
}

/* Flops per triangle: 60 for a look, 150 for its tangent, 20 for its mass;
 * a factorisation, and per step in time a solution. */
static void linear_work_is_counted(void)
{
    const struct ladder_scene *scene = &ladder_scene[FAST];
    for (int moving = 0; moving < 2; moving++) {
        struct ladder_state *s = solved(FAST, LINEAR_PLANE, moving, 0);
        const struct matrix_cost cost =
            matrix_cost(BANDED, s->body->n_equation, s->body->K->p);
        const double triangles = s->mesh->n_triangle;
        const double step = cost.solve + (moving ? 20.0 * triangles : 0.0);
        const double steps = (s->flops - cost.flops - 210.0 * triangles) / step;
        close_to(steps, moving ? floor(scene->end / scene->dt + 0.5) : 1.0,
                 1e-9);
        ladder_free(s);
    }
}

static void adding_makes_a_model_richer(void)
{
    const struct ladder_scene *scene = &ladder_scene[FAST];
    struct ladder_model m = {BAR, 0, 0};
    ck_assert(ladder_add(scene, INERTIA, &m));
    ck_assert(m.rung == LINEAR_PLANE && m.moving && !m.level);
    ck_assert(!ladder_add(scene, INERTIA, &m));
    ck_assert(ladder_add(scene, STRESS, &m) && m.rung == CUBIC_PLANE);
    m.rung = LINEAR_PLANE;
    ck_assert(ladder_add(scene, GEOMETRY, &m) && m.rung == CUBIC_PLANE);
    ck_assert(ladder_add(scene, LAW, &m) && m.rung == LOG_PLANE);
    ck_assert(!ladder_add(scene, GEOMETRY, &m) && m.rung == LOG_PLANE);
    for (int level = 1; level <= scene->finest; level++)
        ck_assert(ladder_add(scene, MESH, &m) && m.level == level);
    ck_assert(!ladder_add(scene, MESH, &m) && m.level == scene->finest);
    const struct ladder_model truth = ladder_truth(scene);
    ck_assert(truth.moving && truth.rung == LOG_PLANE &&
              truth.level == scene->finest + 1);
    ck_assert(!ladder_truth(&ladder_scene[HANGING]).moving);
    m = (struct ladder_model){BAR, 0, 0};
    ck_assert(ladder_add(scene, DIMENSION, &m) && m.rung == LINEAR_PLANE);
    ck_assert_str_eq(ladder_rung(LOG_PLANE), "log");
    ck_assert_str_eq(ladder_part(DIMENSION), "dimension");
}

/* A rotation by a is sin(a / 2) of geometry, no strain, and no law. */
static void estimates_of_a_rotation(void)
{
    struct ladder_state *s = ladder_alloc(
        &ladder_scene[HANGING], (struct ladder_model){LINEAR_PLANE, 0, 0});
    const mat2 Q = mat2_rotation(0.7371);
    close_to(estimate_geometry(s), 0.0, 1e-15);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
        const double *X = &s->mesh->X[r / 2 * 2];
        s->u[r] = Q.m[r % 2][0] * X[0] + Q.m[r % 2][1] * X[1] - X[r % 2];
    }
    close_to(estimate_geometry(s), sin(0.7371 / 2.0), 1e-13);
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        s->u[2 * a] = 0.24630053397813262 * s->mesh->X[2 * a];
        s->u[2 * a + 1] = 0.0;
    }
    close_to(estimate_law(s), 0.01, 1e-10);
    for (int a = 0; a < s->mesh->n_vertex; a++) /* inside out: F11 = -0.1 */
        s->u[2 * a] = -1.1 * s->mesh->X[2 * a];
    close_to(estimate_law(s), 1.0, 1e-15);
    for (int a = 0; a < s->mesh->n_vertex; a++)
        s->u[2 * a] = 0.24630053397813262 * s->mesh->X[2 * a];
    const double P = 1346.1538461538462 * 0.24630053397813262;
    close_to(relax_stress(s, 3).m[0][0], P, 1e-9); /* of the linear law */
    double *Mu = ladder_momentum(s), sum = 0.0;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r += 2)
        sum += Mu[r] * s->mesh->X[r]; /* int X1^2 = 1/3 of 2 */
    close_to(sum, 0.24630053397813262 / 3.0, 1e-12);
    free(Mu);
    ladder_free(s);
}

/* What the forces move, as a part of the displacement. */
static double moved(const struct ladder_state *s, relax_forces *forces)
{
    struct matrix *K = relax_factors(s);
    const double part = relax_part(s, K, forces);
    matrix_free(K);
    return part;
}

/* Pulled or pressed, and bent: two steps say what a nonlinear law would change,
 * one step is d / (1 - t) and says less; above the buckling load it gives way.
 * Nothing is moved where nothing is loaded. */
static void stress_turns_with_a_body(void)
{
    static const double pull[] = {30.0, -8.0, -10.0, -14.5};
    for (int k = 0; k < 4; k++) {
        const struct ladder_scene scene = {.slender = 4, .nu = 0.3,
            .pull = {pull[k], 0.001 * pull[k]}};
        const struct ladder_model linear = {LINEAR_PLANE, 0, 1};
        const struct ladder_model law = {LOG_PLANE, 0, 1};
        struct ladder_state *s = ladder_solve(&scene, linear);
        struct ladder_state *t = ladder_solve(&scene, law);
        const double got = moved(s, estimate_stress);
        for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->u[r] -= t->u[r];
        const double want = ladder_size(s, s->u) / ladder_size(t, t->u);
        if (pull[k] < -14.0)
            ck_assert_double_gt(got, 0.5);
        else
            close_to(got, want, 0.2 * want);
        ladder_free(s);
        ladder_free(t);
    }
    const struct ladder_scene above = {
        .slender = 4, .nu = 0.3, .pull = {-20.0, -0.2}};
    const struct ladder_scene none = {.slender = 4};
    struct ladder_state *s =
        ladder_solve(&above, (struct ladder_model){LINEAR_PLANE, 0, 1});
    close_to(moved(s, estimate_stress), 1.0, 1e-15);
    close_to(relax_part(s, NULL, estimate_mesh), 1.0, 1e-15);
    ladder_free(s);
    s = ladder_solve(&none, (struct ladder_model){LINEAR_PLANE, 0, 0});
    close_to(moved(s, estimate_stress), 0.0, 1e-15);
    close_to(moved(s, estimate_mesh), 0.0, 1e-15);
    ladder_free(s);
}

/* Forces that nobody can compute. */
static void no_forces(const struct ladder_state *s,
                      const struct relax_field *of, double g[])
{
    (void)of;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) g[r] = NAN;
}

/* A step of implicit midpoint may end inside out, where LOG has no stress: then
 * nobody knows what the mesh would move, and that is not 0; nor is NaN. */
static void what_is_not_known_is_no_small_part(void)
{
    const struct ladder_scene scene = {.slender = 4, .nu = 0.3, .T = 1.0,
                                       .time = RISES};
    struct ladder_state *s =
        ladder_alloc(&scene, (struct ladder_model){LOG_PLANE, 1, 0});
    for (int a = 0; a < s->mesh->n_vertex; a++)
        s->u[2 * a] = 0.1 * (s->mesh->X[2 * a] + 1.0);
    ck_assert_double_lt(moved(s, estimate_mesh), 0.1);
    close_to(moved(s, no_forces), 1.0, 1e-15);
    for (int a = 0; a < s->mesh->n_vertex; a++)
        s->u[2 * a] = -2.0 * (s->mesh->X[2 * a] + 1.0);
    close_to(body_min_J(s->body, s->u), -1.0, 1e-12);
    close_to(moved(s, estimate_mesh), 1.0, 1e-15);
    ladder_free(s);
}

/* A bar that is pressed: what bends it counts 1 / (1 - P / P_cr). */
static void a_bar_knows_its_buckling_load(void)
{
    const struct ladder_scene scene = {
        .slender = 4, .nu = 0.3, .pull = {-7.0, -0.01}};
    const double P_cr = 7.0612, P = 3.5, across = 6.0 * 0.01 * 4.0 / 0.125;
    const double bent = across / 2.0 * 2.0 / (1.0 - P / P_cr), along = 14.0;
    close_to(ladder_buckles(&scene), P_cr, 1e-3);
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){BAR, 0, 0});
    close_to(estimate_dimension(s),
             (bent + along * 9.0 / 49.0 / 8.0) / (bent + along), 1e-3);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->f[r] *= 3.0;
    close_to(estimate_dimension(s), 1.0, 1e-15);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->f[r] /= -3.0;
    const double string = across / (1.0 + P / P_cr);
    close_to(estimate_dimension(s),
             (string + along * 9.0 / 49.0 / 8.0) / (string + along), 1e-3);
    ladder_free(s);
}

/* A body that is made to swing as a whole, v = c (0, X1 + 1), and has been
 * swinging for the time t: late by the angle of [eq:left-phase]. */
static void a_motion_is_late(void)
{
    struct ladder_scene scene = {
        .slender = 4, .nu = 0.3, .weight = {0.0, -1e-3}, .time = RISES,
        .T = 1.0, .dt = 0.1, .end = 1.5, .finest = 1};
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 1, 0});
    const int n = 2 * s->mesh->n_vertex;
    struct ladder_state *rest =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
    struct matrix *K = relax_factors(s);
    const double mesh = relax_part(rest, K, estimate_mesh);
    const double stiffer = mesh / (1.0 + mesh); /* |D u| of |K u|, nearly */
    const double omega = estimate_frequency(rest);
    /* at the state of rest, with a velocity of the same form */
    for (int r = 0; r < n; r++) {
        s->u[r] = rest->u[r];
        s->v[r] = 0.1 * omega * rest->u[r];
    }
    s->rival = 0.0;
    scene.dt = 1.0 / omega;
    for (int k = 1; k <= 2; k++) {
        s->t = 5.0 * k / omega;
        const double angle =
            omega * s->t * (0.5 * stiffer + pow(omega * scene.dt, 2) / 12.0);
        const double late = 0.1 * fmin(2.0, angle);
        const double got = relax_mesh(s, K, estimate_mesh);
        close_to(sqrt(got * got - mesh * mesh), late, 0.2 * late);
    }
    s->t = 1e6; /* nobody knows where it is: anywhere, twice its amplitude */
    const double got = relax_mesh(s, K, estimate_mesh);
    close_to(sqrt(got * got - mesh * mesh), 0.2, 1e-3);
    s->t = 0.0; /* two peaks that are hardly apart, or far */
    s->apart = 0.3 * ladder_size(s, s->u);
    s->rival = 1.0 - 0.48 * mesh;
    close_to(relax_mesh(s, K, estimate_mesh), hypot(mesh, 0.3), 1e-9);
    s->rival = 1.0 - 0.52 * mesh;
    close_to(relax_mesh(s, K, estimate_mesh), mesh, 1e-9);
    matrix_free(K);
    ladder_free(s);
    ladder_free(rest);
}

/* A load that swings has its work's peaks alike; the highest two are kept, each
 * at the moment between two steps at which f.v is 0. */
static void a_swing_has_a_rival(void)
{
    struct ladder_scene scene = {.slender = 2, .nu = 0.3,
        .weight = {0.0, 1e-3}, .time = SWINGS, .T = 3.0, .dt = 0.1,
        .end = 30.0, .finest = 1};
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 1, 0});
    double power = 0.0, size = 0.0;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
        power += s->f[r] * s->v[r];
        size += s->f[r] * s->u[r];
    }
    close_to(power, 0.0, 1e-12 * size);
    ck_assert(s->rival > 0.9 && s->rival <= 1.0);
    ck_assert_double_lt(s->apart, 0.2 * ladder_size(s, s->u));
    ck_assert(s->t > 4.0 && s->t <= 30.0);
    /* a swing of |u| / T at least */
    ck_assert_double_gt(s->fastest, 0.9 * ladder_size(s, s->u) / 3.0);
    ck_assert_double_lt(s->fastest, 2.0 * ladder_size(s, s->u) / 3.0);
    scene.end = 5.0; /* one peak, at 3 pi / 2 */
    struct ladder_state *once =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 1, 0});
    ck_assert_double_lt(once->rival, s->rival); /* a ripple */
    close_to(once->t, 1.5 * acos(-1.0), 0.5);
    ladder_free(s);
    ladder_free(once);
}

/* Beyond an edge lies the triangle that has its two ends, and there lies e; at
 * the boundary, 2 (n + rows) edges, e itself. */
static void triangles_know_what_is_beyond_their_edges(void)
{
    struct mesh *mesh = mesh_rectangle(5, 3, 1.0, 0.5);
    int *across = mesh_across(mesh), outer = 0;
    for (int e = 0; e < mesh->n_triangle; e++)
        for (int k = 0; k < 3; k++) {
            const int b = across[3 * e + k];
            int ends = 0, back = 0;
            outer += b == e;
            if (b == e) continue;
            for (int i = 0; i < 3; i++) {
                const int a = mesh->triangle[3 * b + i];
                ends += a == mesh->triangle[3 * e + (k + 1) % 3] ||
                        a == mesh->triangle[3 * e + (k + 2) % 3];
                back += across[3 * b + i] == e;
            }
            ck_assert_int_eq(ends, 2);
            ck_assert_int_eq(back, 1);
        }
    ck_assert_int_eq(outer, 2 * (5 + 3));
    free(across);
    mesh_free(mesh);
}

/* Root mean squares and works, from their definitions; a hand is what is
 * pulled, bent or pushed, and in motion is alone. */
static void quantities_are_measured(void)
{
    struct ladder_scene scene = {.slender = 4, .nu = 0.3,
        .pull = {0.1, -0.02}, .weight = {0.0, -0.01}};
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 0, 1});
    const int n = s->mesh->n, columns = n / 2 + 1;
    double squares = 0.0, work = 0.0, half = 0.0;
    for (int j = 0; j < 5; j++)
        for (int i = 0; i < columns; i++)
            for (int k = 0; k < 2; k++)
                squares += pow(s->u[2 * (2 * j * (n + 1) + 2 * i) + k], 2);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
        const int end = r / 2 % (n + 1) == n;
        ck_assert(end || s->hand[r] == 0.0);
        half += r % 2 ? 0.0 : s->hand[r];
        work += s->hand[r] * s->u[r];
    }
    close_to(half, 0.1 * 0.5, 1e-14);
    scene.quantity = LADDER_RMS;
    close_to(ladder_measure(s, s->u), sqrt(squares / (5 * columns)), 1e-14);
    scene.quantity = LADDER_HAND;
    close_to(ladder_measure(s, s->u), fabs(work), 1e-14);
    scene.quantity = LADDER_LARGEST;
    close_to(ladder_measure(s, s->u), ladder_size(s, s->u), 1e-16);
    ck_assert(ladder_has_hand(&scene));
    scene.time = RISES;
    ck_assert(!ladder_has_hand(&scene));
    scene.weight[1] = 0.0;
    ck_assert(ladder_has_hand(&scene));
    scene.pull[0] = scene.pull[1] = 0.0;
    ck_assert(!ladder_has_hand(&scene));
    scene.push[1] = 1.0;
    ck_assert(ladder_has_hand(&scene));
    ladder_free(s);
}

/* Pressed by 0.87 of its buckling load and hardly bent, on a mesh that locks:
 * the beam knows more than the mesh.  Pulled it is the mesh that does. */
static void a_stiff_mesh_hides_no_buckling(void)
{
    struct ladder_scene scene = {.slender = 5.28, .nu = 0.456, .couple = 0.17,
                                 .pull = {-8.13, 0.0}};
    for (int k = 0; k < 2; k++) {
        double part[N_PART];
        struct ladder_state *s =
            ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
        const double share = ladder_pressed(&scene);
        const double relaxed = moved(s, estimate_stress);
        const double s2 = pow(0.456 / 0.544, 2), missed = s2 / (2.0 * 5.28);
        const double most = fmax(estimate_dimension(s), relax_dimension(s));
        const double bends = (most - missed) / (1.0 - missed);
        estimate_parts(s, part);
        ck_assert(k || share > 0.85);
        ck_assert(!k || (part[STRESS] <= relaxed &&
                         part[STRESS] > 0.8 * relaxed));
        if (!k) close_to(part[STRESS], share * bends, 1e-10);
        ck_assert(k || part[STRESS] > 5.0 * relaxed);
        ladder_free(s);
        scene.pull[0] *= -1.0;
    }
}

static void what_nobody_may_rely_on_is_named(void)
{
    struct ladder_scene scene = ladder_scene[FAST];
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 1, 0});
    ck_assert_int_eq(estimate_doubt(s), NO_DOUBT);
    scene.dt = 1.01 / estimate_frequency(s);
    ck_assert_int_eq(estimate_doubt(s), LONG_STEPS);
    scene.dt = 0.99 / estimate_frequency(s);
    ck_assert_int_eq(estimate_doubt(s), NO_DOUBT);
    for (int k = 0; k < 2; k++) { /* G11 = e + e^2 / 2, 4 at e = 2 */
        for (int a = 0; a < s->mesh->n_vertex; a++) {
            s->u[2 * a] = (k ? 2.01 : 1.99) * s->mesh->X[2 * a];
            s->u[2 * a + 1] = 0.0;
        }
        ck_assert_int_eq(estimate_doubt(s), k ? TORN : NO_DOUBT);
    }
    ladder_free(s);
}

/* P_cr = pi^2 E' I / 4 L^2 of an end load, 7.8373 E' I / L^2 of a weight, and
 * 1.2 / (mu height) of the force more for the shear (Timoshenko and Gere, 2.1,
 * 2.11 and 2.17); a pull is negative. */
static void a_load_is_known_by_the_one_that_buckles(void)
{
    struct ladder_scene scene = {.slender = 10, .nu = 0.3};
    const double mu = 1000.0 / 2.6, height = 0.2, E = 1000.0 / 0.91;
    const double buckles = E * pow(height, 3) / 12.0 / 4.0;
    for (int k = -1; k <= 1; k += 2) {
        scene.pull[0] = -0.7 * k * pow(acos(-1.0), 2) * buckles / 4.0 / height;
        close_to(ladder_pressed(&scene), k > 0 ? 0.7 - scene.pull[0] * 1.2 / mu
                                               : -0.7, 1e-10);
    }
    scene.pull[0] = 0.0;
    for (int k = 0; k < 2; k++) { /* to the side, it is half a height away */
        const double weight = -0.6 * 7.8373 * buckles / 2.0;
        scene.weight[0] = k ? 0.0 : weight / height;
        scene.push[0] = k ? weight : 0.0;
        close_to(ladder_pressed(&scene), 0.6 - weight * 2.0 *
                 (0.5 - 2.0 / pow(acos(-1.0), 2)) * 1.2 / (mu * height), 2e-4);
        ck_assert_int_eq(ladder_symmetric(&scene), !k);
    }
    scene.held = LADDER_ENDS;
    ck_assert_double_eq(ladder_pressed(&scene), 0.0);
    for (int k = 0; k < 4; k++) {
        const struct ladder_scene leans = {.slender = 2, .nu = 0.3,
            .weight = {-1.0, k == 0}, .pull = {-1.0, k == 1},
            .couple = k == 2, .push = {0.0, k == 3}};
        ck_assert(!ladder_symmetric(&leans));
    }
}

/* A straight column is doubted from its buckling load on, a linear one that
 * leans as well, and a cubic one that leans only where its mesh locks. */
static void a_column_does_not_stay_straight(void)
{
    static const struct {
        double pressed, nu, leans;
        enum rung rung;
        int moving, level;
        enum doubt doubt;
    } of[] = {{0.98, 0.3, 0.0, LINEAR_PLANE, 0, 0, NO_DOUBT},
              {0.98, 0.49, 0.0, BAR, 0, 0, NO_DOUBT},
              {1.01, 0.3, 0.0, LINEAR_PLANE, 0, 0, BUCKLES},
              {1.01, 0.49, 0.0, BAR, 0, 0, BUCKLES},
              {1.01, 0.45, 0.0, CUBIC_PLANE, 0, 0, BUCKLES},
              {6.0, 0.3, 0.0, CUBIC_PLANE, 0, 1, BUCKLES},
              {1.2, 0.3, 0.0, CUBIC_PLANE, 1, 0, BUCKLES},
              {1.2, 0.3, 1e-2, LINEAR_PLANE, 0, 0, BUCKLES},
              {1.77, 0.3, 1e-2, CUBIC_PLANE, 0, 1, NO_DOUBT},
              {1.77, 0.49, 1e-4, CUBIC_PLANE, 0, 0, TOO_STIFF}};
    for (int k = 0; k < COUNT(of); k++) {
        struct ladder_scene scene = {.slender = 4, .nu = of[k].nu, .finest = 2,
            .pull = {-1.0, 0.0}, .time = RISES, .T = 1.0, .dt = 0.02,
            .end = 1.2};
        scene.pull[0] = -of[k].pressed / ladder_pressed(&scene);
        scene.pull[1] = of[k].leans * scene.pull[0];
        struct ladder_state *s = ladder_solve(&scene, (struct ladder_model){
            of[k].rung, of[k].moving, of[k].level});
        ck_assert_int_eq(s->status, OK);
        ck_assert_msg((int)estimate_doubt(s) == (int)of[k].doubt,
                      "column %d: doubt %d, not %d", k,
                      (int)estimate_doubt(s), (int)of[k].doubt);
        ladder_free(s);
    }
}

/* A slow load on a column that is pressed by p of its buckling load leaves it
 * swinging by r / (1 - p) of what it is moved by, and by far more than r: the
 * error of the cubic law at rest against that in motion. */
static void a_pressed_body_swings_the_more(void)
{
    static const double share[] = {0.5, 0.8}, slow[] = {0.08, 0.05};
    for (int k = 0; k < 2; k++) {
        struct ladder_scene scene = {.slender = 5, .nu = 0.3, .time = RISES,
            .pull = {-1.0, 0.0}, .dt = 0.05};
        const double omega = 3.4 * sqrt(1.0 - share[k]);
        scene.pull[0] = -share[k] / ladder_pressed(&scene);
        scene.pull[1] = 0.01 * scene.pull[0];
        scene.T = 1.0 / (omega * slow[k]);
        scene.end = scene.T + 6.3 / omega;
        double part[N_PART];
        struct ladder_state *s =
            ladder_solve(&scene, (struct ladder_model){CUBIC_PLANE, 0, 1});
        struct ladder_state *t =
            ladder_solve(&scene, (struct ladder_model){CUBIC_PLANE, 1, 1});
        const double error = ladder_error(s, t);
        estimate_parts(s, part);
        ck_assert_msg(part[INERTIA] > 0.8 * error &&
                      part[INERTIA] < 1.6 * error &&
                      error > 1.3 * estimate_inertia(s),
                      "pressed by %g: %g and %g, the error %g", share[k],
                      part[INERTIA], estimate_inertia(s), error);
        ladder_free(s);
        ladder_free(t);
    }
}

/* Where nothing is loaded nothing is left out; what does not move says nothing
 * about its inertia. */
static void what_rests_has_its_parts(void)
{
    struct ladder_state *s =
        ladder_alloc(&ladder_scene[FAST], (struct ladder_model){BAR, 0, 0});
    close_to(estimate_inertia(s), 1.0, 1e-15);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->f[r] = 0.0;
    close_to(estimate_inertia(s), 1.0, 1e-15);
    close_to(estimate_dimension(s), 0.0, 1e-15);
    ladder_free(s);
}

/* The estimate is the root of the squares of what a model leaves out. */
static void verdicts_add_squares(void)
{
    double part[N_PART] = {0.03, 0.5, 0.04, 0.7, 0.9, 0.8}, estimate;
    enum part add;
    ck_assert(estimate_verdict((struct ladder_model){BAR, 0, 0}, STANDS, 1,
                               0.051, part, &estimate, &add));
    close_to(estimate, 0.05, 1e-15);
    ck_assert_int_eq(add, DIMENSION);
    /* the first of two */
    double alike[N_PART] = {0.0, 0.0, 0.03, 0.03, 0.0, 0.0};
    estimate_verdict((struct ladder_model){BAR, 0, 0}, RISES, 1, 0.1, alike,
                     &estimate, &add);
    ck_assert_int_eq(add, DIMENSION);
    ck_assert(!estimate_verdict((struct ladder_model){LINEAR_PLANE, 0, 0},
                                STANDS, 0, 10.0, alike, &estimate, &add));
    ck_assert_int_eq(add, GEOMETRY); /* not stable */
}

static void a_climb_ends_with_enough(void)
{
    struct climb_rung tried[CLIMB_MOST];
    int n;
    struct ladder_state *s =
        climb_ladder(&ladder_scene[SHAKEN], 0.1, tried, &n);
    const struct climb_rung *last = &tried[n - 1];
    ck_assert(s->model.rung == CUBIC_PLANE && s->model.moving &&
              s->model.level == 1 && last->estimate < 0.1);
    ck_assert(last->model.level == 1 && tried[0].model.rung == BAR &&
              tried[0].estimate > 0.1);
    ladder_free(s);
    s = climb_ladder(&ladder_scene[ABOVE], 0.35, tried, &n);
    ck_assert(tried[n - 1].estimate <= 0.35 && s->model.rung == CUBIC_PLANE &&
              s->model.level == 1);
    ladder_free(s);
    s = climb_ladder(&ladder_scene[SHAKEN], 1e-3, tried, &n);
    ck_assert(tried[n - 1].estimate > 1e-3 && s->model.level == 1);
    ladder_free(s);
}

/* At rest, where no finer mesh is left, other triangles may do with the law. */
static void a_climb_leaves_a_mesh_to_others(void)
{
    struct climb_rung tried[CLIMB_MOST];
    int n;
    const struct ladder_scene held = {"held", 4, 0.3, .weight = {0.0, -0.02},
                                      .held = LADDER_ENDS, .finest = 0};
    struct ladder_state *s = climb_ladder(&held, 1e-4, tried, &n);
    ck_assert(n == 2 && tried[0].add == MESH && tried[0].doubt == NO_DOUBT);
    ck_assert(tried[0].model.rung == LINEAR_PLANE &&
              s->model.rung == CUBIC_PLANE);
    ladder_free(s);
}

UNIT_MAIN("ladder",
    LAW(loads_add_up),
    LAW(cells_are_nearly_square),
    LAW(linear_work_is_counted),
    LAW(what_rests_has_its_parts),
    LAW(adding_makes_a_model_richer),
    LAW(estimates_of_a_rotation),
    LAW(stress_turns_with_a_body),
    LAW(what_is_not_known_is_no_small_part),
    LAW(a_bar_knows_its_buckling_load),
    LAW(verdicts_add_squares),
    LAW(a_climb_leaves_a_mesh_to_others),
    LAW(a_climb_ends_with_enough),
    LAW(a_motion_is_late),
    LAW(triangles_know_what_is_beyond_their_edges),
    LAW(a_swing_has_a_rival),
    LAW(a_stiff_mesh_hides_no_buckling),
    LAW(quantities_are_measured),
    LAW(what_nobody_may_rely_on_is_named),
    LAW(a_load_is_known_by_the_one_that_buckles),
    LAW(a_column_does_not_stay_straight),
    LAW(a_pressed_body_swings_the_more))
