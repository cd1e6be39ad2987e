/*
 * 23_least_model.c - what right estimates of the left-out satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *   23a F: geometry_sees_a_rotation, law_leaves_the_logarithm_as_tabulated;
 *       uneven: geometry_takes_the_largest, law_looks_at_both_ends; material:
 *       shape_agrees_with_the_library
 *   23b u: a_constant_strain_needs_no_finer_mesh, mesh_is_of_second_order;
 *       mesh: the same; nu: mesh_counts_what_half_the_cells_leave
 *   23c f, slender, nu: height_counts_by_its_cube,
 *       dimension_knows_bars_and_beams; f = 0, u = 0, T: inertia_is_rayleighs;
 *       u, Mu: inertia_is_rayleighs, loads_agree_with_the_library
 *   23d model, time: verdict_counts_what_is_left_out; part: verdict_names_each
 *       _part; tolerance: the_tolerance_is_enough; stable:
 *       what_is_unstable_is_never_enough
 */
#include "program.h"

#include "judge.h"

#include "../oracle/23_least_model.h"

#include "choice/estimate.c"

#include <stdio.h>
#include <string.h>

#define ROUND_OFF 1e-12 /* sums of some hundred products */
#define PAIR 1e-10      /* the same formula in another order, and pow() */

/* The hanging body, slender 4, on the mesh `level`, u = (F - I) X. */
static struct ladder_state *affine(int level, mat2 F)
{
    const struct ladder_model model = {LINEAR_PLANE, 0, level};
    struct ladder_state *s = ladder_alloc(&ladder_scene[0], model);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
        const double *X = &s->mesh->X[r / 2 * 2];
        s->u[r] = F.m[r % 2][0] * X[0] + F.m[r % 2][1] * X[1] - X[r % 2];
    }
    return s;
}

static mat2 uniaxial(double F)
{
    return (mat2){{{F, 0.0}, {0.0, 1.0}}};
}

static double affine_part(mat2 F, enum part which)
{
    struct ladder_state *s = affine(0, F);
    double part[N_PART] = {NAN, NAN, NAN, NAN, NAN};
    shape_parts(s, part);
    ladder_free(s);
    return part[which];
}

/* ---- 23a ----------------------------------------------------------------- */

/* A rotation by a: |H^T H| / 2 over |H| is sin(a / 2), and 1 - cos a, the
 * strain that linear elasticity sees, is 2 sin^2(a / 2). */
static void geometry_sees_a_rotation(void)
{
    for (int k = 0; k < COUNT(oracle_threshold); k++) {
        const double angle =
            oracle_threshold[k].degrees * acos(-1.0) / 180.0;
        const double got = affine_part(mat2_rotation(angle), GEOMETRY);
        expect_close(2.0 * got * got, oracle_threshold[k].off, PAIR, 1.0,
                     "turned by %g degrees, not stretched: 2 geometry^2, "
                     "against 1 - cos", oracle_threshold[k].degrees);
    }
}

/* Pulled by e it is e / 2; the true error is within a factor of 3. */
static void geometry_follows_a_stretch(void)
{
    for (int k = 0; k < 2 * COUNT(oracle_threshold); k++) {
        const double off = oracle_threshold[k / 2].off;
        const double e = k % 2 ? oracle_threshold[k / 2].tension
                               : oracle_threshold[k / 2].compression;
        const double got = affine_part(uniaxial(1.0 + e), GEOMETRY);
        expect_close(got, fabs(e) / 2.0, ROUND_OFF, 1.0,
                     "F = %g in uniaxial strain: geometry", 1.0 + e);
        expect(got > off / 3.0 && got < off * 3.0,
               "F = %g, where linear stress is wrong by %g: geometry is %g",
               1.0 + e, off, got);
    }
    expect_close(affine_part(mat2_identity(), GEOMETRY), 0.0, ROUND_OFF, 1.0,
                 "a body at rest: geometry");
}

/* One vertex is moved: its triangles decide, however many more are at rest. */
static void geometry_takes_the_largest(void)
{
    double small[N_PART], large[N_PART];
    struct ladder_state *s = affine(0, mat2_identity());
    const int a = s->mesh->n_vertex / 2;
    s->u[2 * a] = 0.02385;
    s->u[2 * a + 1] = -0.03714;
    shape_parts(s, small);
    expect_close(small[GEOMETRY], estimate_geometry(s), ROUND_OFF, 1.0,
                 "one vertex moved: geometry");
    s->u[2 * a] *= 2.0;
    s->u[2 * a + 1] *= 2.0;
    shape_parts(s, large);
    expect_close(large[GEOMETRY], 2.0 * small[GEOMETRY], ROUND_OFF, 1.0,
                 "one vertex moved twice as far: geometry");
    ladder_free(s);
}

static void law_leaves_the_logarithm_as_tabulated(void)
{
    for (int k = 0; k < 2 * COUNT(oracle_threshold); k++) {
        const double e = k % 2 ? oracle_threshold[k / 2].cubic_tension
                               : oracle_threshold[k / 2].cubic_pressed;
        expect_close(affine_part(uniaxial(1.0 + e), LAW),
                     oracle_threshold[k / 2].off, PAIR, 1.0,
                     "J = %g everywhere: law", 1.0 + e);
    }
    expect_close(affine_part(mat2_rotation(0.7371), LAW), 0.0, 1e-9, 1.0,
                 "turned, not stretched: law");
    expect_close(affine_part(mat2_identity(), LAW), 0.0, ROUND_OFF, 1.0,
                 "at rest, where no stress is to divide by: law");
    expect_close(affine_part(uniaxial(-0.2385), LAW), 1.0, ROUND_OFF, 1.0,
                 "turned inside out, where there is no logarithm: law");
    expect_close(affine_part(uniaxial(3.0), LAW), 1.0, ROUND_OFF, 1.0,
                 "J = 3, where the laws differ by more than the stress: law");
}

/* Uneven: one part pulled, another pressed. */
static void law_looks_at_both_ends(void)
{
    for (int side = 0; side < 2; side++) {
        double part[N_PART];
        struct ladder_state *s = affine(0, mat2_identity());
        for (int a = 0; a < s->mesh->n_vertex; a++)
            s->u[2 * a] = (side ? -0.1 : 0.1) * pow(1.0 + s->mesh->X[2 * a], 2);
        shape_parts(s, part);
        expect_close(part[LAW], estimate_law(s), PAIR, 1.0,
                     "%s more and more towards the end: law",
                     side ? "pressed" : "pulled");
        expect(part[LAW] > 0.01, "law must see the extreme J, not the mean");
        ladder_free(s);
    }
    /* the laws agree once more near J = 1.7, and at J = 1.45 they do not */
    double part[N_PART];
    struct ladder_state *s = affine(0, mat2_identity());
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        const double X = 1.0 + s->mesh->X[2 * a];
        s->u[2 * a] = 0.45 * X + 0.05 * X * X;
    }
    shape_parts(s, part);
    expect_close(part[LAW], estimate_law(s), PAIR, 1.0,
                 "J between 1.45 and 1.65, so that 1 is the least: law");
    ladder_free(s);
}

/* ---- 23b ----------------------------------------------------------------- */

static double mesh_of(const struct ladder_state *s)
{
    double part[N_PART] = {NAN, NAN, NAN, NAN, NAN};
    mesh_part(s, part);
    return part[MESH];
}

static void a_constant_strain_needs_no_finer_mesh(void)
{
    const mat2 F = {{{1.1238, 0.2385}, {-0.1371, 0.8714}}};
    for (int level = 0; level < 2; level++) {
        struct ladder_state *s = affine(level, F);
        expect_close(mesh_of(s), 0.0, 1e-25, 1.0, "F constant: mesh");
        for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->u[r] = 0.0;
        expect_close(mesh_of(s), 0.0, 1e-25, 1.0, "u = 0: mesh");
        ladder_free(s);
    }
}

/* u = small X1^2 / 2: the energy of what is missing is known, (h u'')^2 / 12 of
 * each cell, and the recovered strain knows it but beside the ends. */
static void mesh_is_of_second_order(void)
{
    double before = 0.0;
    for (int level = 0; level < 3; level++) {
        struct ladder_state *s = affine(level, mat2_identity());
        const double small = 1e-6, h = 2.0 / s->mesh->n;
        for (int a = 0; a < s->mesh->n_vertex; a++)
            s->u[2 * a] = 0.5 * small * pow(2.0 + s->mesh->X[2 * a], 2);
        const double got = mesh_of(s), want = h * h / 12.0 / (13.0 / 3.0);
        expect(got > want / 3.0 && got < 3.0 * want,
               "strain linear in X1, %d columns: mesh is %g, and the error in "
               "the energy is %g of it", s->mesh->n, got, want);
        if (level)
            expect(before / got > 3.2 && before / got < 4.8,
                   "cells of half the size: mesh must fall to a quarter, falls "
                   "from %g to %g", before, got);
        before = got;
        ladder_free(s);
    }
}

/* What the loops give is the same for every material, but that of nu = 0.49 has
 * a sharper corner, p = 1.1998 for 1.4223, of which cells of half the size see
 * less. */
static void mesh_counts_what_half_the_cells_leave(void)
{
    double got[2];
    for (int k = 0; k < 2; k++) {
        struct ladder_scene scene = ladder_scene[0];
        if (k) scene.nu = 0.49;
        struct ladder_state *s =
            ladder_alloc(&scene, (struct ladder_model){LINEAR_PLANE, 0, 3});
        /* a shear, of which psi has mu alone, linear in X1 */
        for (int a = 0; a < s->mesh->n_vertex; a++)
            s->u[2 * a + 1] = 0.5e-6 * pow(2.0 + s->mesh->X[2 * a], 2);
        got[k] = mesh_of(s);
        ladder_free(s);
    }
    const double p[] = {2.0 * 0.71117293297146607, 2.0 * 0.59989510759463660};
    expect_close(got[1] / got[0],
                 (1.0 - pow(0.5, p[0])) / (1.0 - pow(0.5, p[1])), 1e-5, 1.0,
                 "a shear, nu = 0.49 against nu = 0.3: ratio of the meshes' "
                 "parts, in which only p differs");
    const double h = 1.0 / 64.0, want = h * h / 12.0 / (13.0 / 3.0);
    expect_close(got[0] * (1.0 - pow(0.5, p[0])), want, 0.1, want,
                 "strain linear in X1, 128 columns: mesh times 1 - 2^-p");
}

/* Turned as a whole it is the same; a linear strain would see the turn. */
static void mesh_does_not_see_a_rotation(void)
{
    const mat2 Q = mat2_rotation(0.7371);
    double got[2];
    for (int turned = 0; turned < 2; turned++) {
        struct ladder_state *s = affine(0, mat2_identity());
        for (int a = 0; a < s->mesh->n_vertex; a++) {
            const double *X = &s->mesh->X[2 * a];
            const double x[2] = {X[0] + 0.1 * sin(2.385 * X[0] + X[1]),
                                 X[1] + 0.07 * cos(X[0] - 3.714 * X[1])};
            for (int i = 0; i < 2; i++)
                s->u[2 * a + i] =
                    turned ? Q.m[i][0] * x[0] + Q.m[i][1] * x[1] - X[i]
                           : x[i] - X[i];
        }
        got[turned] = mesh_of(s);
        expect_close(got[turned], estimate_mesh(s), PAIR, got[turned],
                     "an uneven strain: mesh");
        ladder_free(s);
    }
    expect_close(got[1], got[0], PAIR, got[0],
                 "the same body turned as a whole: mesh");
}

/* ---- 23c ----------------------------------------------------------------- */

static struct ladder_state *solved(int scene, enum rung rung, int level)
{
    return ladder_solve(&ladder_scene[scene],
                        (struct ladder_model){rung, 0, level});
}

static void loads_of(const struct ladder_state *s, double part[N_PART])
{
    double *Mu = ladder_momentum(s);
    load_parts(s, Mu, part);
    free(Mu);
}

/* part[DIMENSION] of a body that is pulled by (20, across) N/m on its right end
 * and bent by a couple, against the sums of a bar and a beam. */
static void expect_dimension(int slender, double nu, double across,
                             double couple)
{
    const struct ladder_scene scene = {.name = "pulled and bent",
        .slender = slender, .nu = nu, .pull = {20.0, across}, .couple = couple};
    struct ladder_state *s =
        ladder_alloc(&scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
    const double h = 2.0 / slender, side = nu / (1.0 - nu); /* plane strain */
    const double moment = 2.0 * across * h - couple * pow(h, 3) / 12.0;
    const double along = 20.0 * h * 2.0 / h;
    const double bent = 6.0 * fabs(moment) * 4.0 / pow(h, 3);
    /* lambda / (2 mu + lambda) is nu / (1 - nu) */
    const double missed = side * side * h / 4.0;
    double part[N_PART];
    loads_of(s, part);
    expect_close(part[DIMENSION], (bent + missed * along) / (bent + along),
                 PAIR, 1.0, "slender %d, nu = %g, pull (20, %g), couple %g: "
                 "dimension", slender, nu, across, couple);
    ladder_free(s);
}

static void height_counts_by_its_cube(void)
{
    for (int slender = 1; slender <= 8; slender *= 2)
        expect_dimension(slender, slender == 8 ? 0.2385 : 0.3, 0.0, -20.0);
}

static void dimension_knows_bars_and_beams(void)
{
    double part[N_PART];
    for (int slender = 1; slender <= 8; slender *= 2) /* bent twice */
        for (int sign = -1; sign <= 1; sign += 2)
            expect_dimension(slender, 0.3, 1.0 / slender,
                             sign * 6.0 * slender);
    struct ladder_state *s = solved(0, LINEAR_PLANE, 0); /* hangs */
    loads_of(s, part);
    expect_close(part[DIMENSION], 9.0 / 49.0 / 8.0, PAIR, 1.0,
                 "pulled along its axis, nu = 0.3, 4 times as long as high: "
                 "dimension, against (3/7)^2 / 8");
    for (int r = 1; r < 2 * s->mesh->n_vertex; r += 2)
        s->f[r] = -0.2385 * s->f[r - 1]; /* and pulled across */
    loads_of(s, part);
    const double along = 4.0, across = 6.0 * 0.2385 * 4.0 / 0.125;
    expect_close(part[DIMENSION],
                 (across + along * 9.0 / 49.0 / 8.0) / (across + along), PAIR,
                 1.0, "the same with 0.2385 of it across: dimension");
    ladder_free(s);
    s = solved(2, LINEAR_PLANE, 0);
    loads_of(s, part);
    expect_close(part[DIMENSION], 1.0, PAIR, 1.0,
                 "bent by a couple, no force along: dimension");
    ladder_free(s);
}

/* A uniform bar that hangs: omega = 1.5811 c / L by Rayleigh's quotient. */
static void inertia_is_rayleighs(void)
{
    double part[N_PART], once;
    struct ladder_scene scene = ladder_scene[0];
    const double E = 1000.0 / 0.91, omega = sqrt(2.5 * E) / 2.0;
    scene.T = 2.385;
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 0, 1});
    loads_of(s, part);
    once = part[INERTIA];
    expect(fabs(once * omega * 2.385 - 1.0) < 0.05,
           "a hanging body: inertia is %g, 1 / (omega T) of a hanging bar %g",
           once, 1.0 / (omega * 2.385));
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
        s->f[r] *= 3.0;
        s->u[r] *= 3.0;
    }
    loads_of(s, part);
    expect_close(part[INERTIA], once, PAIR, 1.0,
                 "three times the load, three times u: inertia");
    scene.T = 2.0 * 2.385;
    loads_of(s, part);
    expect_close(part[INERTIA], 0.5 * once, PAIR, 1.0,
                 "a load that rises twice as slowly: inertia");
    scene.T = 1e-6;
    loads_of(s, part);
    expect_close(part[INERTIA], 1.0, ROUND_OFF, 1.0, "a sudden load: inertia");
    scene.T = 2.385;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->u[r] = 0.0;
    loads_of(s, part);
    expect_close(part[INERTIA], 1.0, ROUND_OFF, 1.0, "u = 0: inertia");
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->f[r] = 0.0;
    loads_of(s, part);
    expect_close(part[DIMENSION], 0.0, ROUND_OFF, 1.0, "f = 0: dimension");
    ladder_free(s);
}

/* ---- 23d ----------------------------------------------------------------- */

/* What counts for each model, of the parts 0.01, 0.02, 0.04, 0.08, 0.16; the
 * sum of their squares in units of 0.0001. */
static void verdict_counts_what_is_left_out(void)
{
    static const struct {
        struct ladder_model model;
        enum ladder_time time;
        int squares;
        enum part add;
    } is[] = {
        {{BAR, 0, 0}, STANDS, 17, DIMENSION},
        {{BAR, 0, 0}, RISES, 81, INERTIA},
        {{LINEAR_PLANE, 0, 1}, STANDS, 257, MESH},
        {{LINEAR_PLANE, 0, 0}, SWINGS, 321, MESH},
        {{LINEAR_PLANE, 1, 0}, RISES, 257, MESH},
        {{CUBIC_PLANE, 0, 2}, STANDS, 260, MESH},
        {{CUBIC_PLANE, 1, 0}, SWINGS, 260, MESH},
        {{CUBIC_PLANE, 0, 0}, RISES, 324, MESH},
        {{LOG_PLANE, 0, 0}, STANDS, 256, MESH},
        {{LOG_PLANE, 0, 0}, RISES, 320, MESH},
        {{LOG_PLANE, 1, 3}, SWINGS, 256, MESH},
    };
    for (int k = 0; k < COUNT(is); k++)
        for (int below = 0; below < 2; below++) {
            const double parts[] = {0.01, 0.02, 0.04, 0.08, 0.16};
            const double want = 0.01 * sqrt(is[k].squares);
            double *part = guarded_copy(N_PART, parts), sum = NAN;
            enum part add = N_PART;
            const int got = verdict(is[k].model, is[k].time, 1,
                                    want + (below ? 0.001 : -0.001), part, &sum,
                                    &add);
            const char *of = ladder_rung(is[k].model.rung);
            expect_close(sum, want, ROUND_OFF, 1.0,
                         "%s, %s, load that %s: estimate", of,
                         is[k].model.moving ? "in motion" : "at rest",
                         is[k].time == STANDS ? "stands" : "moves");
            expect(add == is[k].add, "%s: to add is %s, not %s", of,
                   ladder_part(is[k].add),
                   add < N_PART ? ladder_part(add) : "nothing");
            expect((got != 0) == below, "%s: estimate %g, tolerance %g: must "
                   "%sbe enough", of, sum, sum + (below ? 0.001 : -0.001),
                   below ? "" : "not ");
        }
}

static void verdict_names_each_part(void)
{
    static const enum rung rung[] = {BAR, CUBIC_PLANE, BAR, CUBIC_PLANE,
                                     LOG_PLANE};
    for (int k = 0; k < N_PART; k++) {
        const double parts[] = {0.01, 0.01, 0.01, 0.01, 0.01};
        double *part = guarded_copy(N_PART, parts), sum;
        enum part add = N_PART;
        part[k] = 0.2385;
        verdict((struct ladder_model){rung[k], 0, 0}, RISES, 1, 0.1, part, &sum,
                &add);
        expect((int)add == k, "%s is the largest part: it is to be added",
               ladder_part((enum part)k));
    }
    for (int r = BAR; r < LOG_PLANE; r++) { /* two or three are alike */
        static const enum part first[] = {DIMENSION, GEOMETRY, LAW};
        const double parts[] = {r > BAR ? 0.25 : 0.1, 0.25, 0.25, 0.25, 0.25};
        const struct ladder_model model = {(enum rung)r, 0, 0};
        enum part add = N_PART;
        double sum;
        verdict(model, RISES, 1, 0.1, guarded_copy(N_PART, parts), &sum, &add);
        expect(add == first[r], "%s, the largest parts that count are equal: "
               "the first of them, %s, is to be added, not %s",
               ladder_rung((enum rung)r), ladder_part(first[r]),
               add < N_PART ? ladder_part(add) : "nothing");
    }
}

/* A part that is the tolerance to the last digit. */
static void the_tolerance_is_enough(void)
{
    const double parts[] = {0.25, 0.0, 0.0, 0.0, 0.0};
    const struct ladder_model model = {LINEAR_PLANE, 0, 0};
    enum part add;
    double sum;
    expect(verdict(model, STANDS, 1, 0.25, guarded_copy(N_PART, parts), &sum,
                   &add), "estimate %g, tolerance 0.25: that is enough", sum);
}

/* Buckling: every part is small, and no linear model is enough. */
static void what_is_unstable_is_never_enough(void)
{
    for (int r = BAR; r <= LOG_PLANE; r++) {
        const double parts[] = {1e-4, 1e-4, 2e-4, 1e-4, 2e-4};
        double *part = guarded_copy(N_PART, parts), sum;
        enum part add = N_PART;
        const struct ladder_model model = {(enum rung)r, 0, 0};
        expect(!verdict(model, STANDS, 0, 0.1, part, &sum, &add),
               "%s, K not positive definite: not enough, however small the "
               "estimate", ladder_rung((enum rung)r));
        expect(r > LINEAR_PLANE || add == GEOMETRY,
               "%s, K not positive definite: the geometry is to be added",
               ladder_rung((enum rung)r));
    }
}

/* ---- all together -------------------------------------------------------- */

/* Two parts of one slot in every scene, on the first rungs. */
static void agree(void (*slot)(const struct ladder_state *s, double part[]),
                  enum part one, enum part other)
{
    for (int k = 0; k < LADDER_SCENES; k++)
        for (int r = BAR; r <= CUBIC_PLANE; r++) {
            double part[N_PART], want[N_PART];
            struct ladder_state *s = solved(k, (enum rung)r, 0);
            slot(s, part);
            estimate_parts(s, want);
            for (int i = 0; i < 2; i++) {
                const enum part p = i ? other : one;
                expect_close(part[p], want[p], PAIR, fmax(1e-6, want[p]),
                             "%s, %s: %s", ladder_scene[k].name,
                             ladder_rung((enum rung)r), ladder_part(p));
            }
            ladder_free(s);
        }
}
static void shape_agrees_with_the_library(void)
{
    agree(shape_parts, GEOMETRY, LAW);
}
static void mesh_agrees_with_the_library(void)
{
    agree(mesh_part, MESH, MESH);
}
static void loads_agree_with_the_library(void)
{
    agree(loads_of, DIMENSION, INERTIA);
}

/* The estimate of the last rung is within a factor of 3 of the true error. */
static void estimates_meet_the_truth(void)
{
    static const char *const scenes[] = {"hanging --tolerance 0.02",
                                         "stout-column",
                                         "slender-column --tolerance 0.01",
                                         "shaken"};
    for (int k = 0; k < COUNT(scenes); k++) {
        char options[80];
        snprintf(options, sizeof options, "--truth yes --scene %s", scenes[k]);
        const struct output *out = run(options);
        const double ratio = cell(out, "ladder", "estimate", -1) /
                             cell(out, "ladder", "error", -1);
        expect(ratio > 1.0 / 3.0 && ratio < 3.0,
               "%s: estimate over true error is %g", options, ratio);
        expect(!strcmp(word(out, "ladder", "verdict", -1), "enough"),
               "%s: the last rung must be enough", options);
    }
}

static void what_is_too_strict_is_refused(void)
{
    run_unsolved("--scene shaken --tolerance 0.001", "the ladder ends");
    expect_refusal("--tolerance -1", 2, "tolerance");
    expect_refusal("--scene nowhere", 2, "scene");
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    double low = 0.01, high = 1.5; /* radians: less than 10 %, and more */
    while (high - low > 1e-9) {
        const double a = 0.5 * (low + high);
        /* |H| = 2 sqrt 2 sin(a / 2), and what is seen is |H^T H| / 2 sqrt 2 */
        const double seen =
            affine_part(mat2_rotation(a), GEOMETRY) * 2.0 * sin(0.5 * a);
        *(seen > 0.1 ? &high : &low) = a;
    }
    measured("1", high * 180.0 / acos(-1.0));
    measured("2", cell(run(""), "ladder", "inertia", 1));
}

static const struct claim claims[] = {
    {"geometry_sees_a_rotation", geometry_sees_a_rotation, "23a"},
    {"geometry_follows_a_stretch", geometry_follows_a_stretch, "23a"},
    {"geometry_takes_the_largest", geometry_takes_the_largest, "23a"},
    {"law_leaves_the_logarithm_as_tabulated",
     law_leaves_the_logarithm_as_tabulated, "23a"},
    {"law_looks_at_both_ends", law_looks_at_both_ends, "23a"},
    {"shape_agrees_with_the_library", shape_agrees_with_the_library, "23a"},
    {"a_constant_strain_needs_no_finer_mesh",
     a_constant_strain_needs_no_finer_mesh, "23b"},
    {"mesh_is_of_second_order", mesh_is_of_second_order, "23b"},
    {"mesh_counts_what_half_the_cells_leave",
     mesh_counts_what_half_the_cells_leave, "23b"},
    {"mesh_does_not_see_a_rotation", mesh_does_not_see_a_rotation, "23b"},
    {"mesh_agrees_with_the_library", mesh_agrees_with_the_library, "23b"},
    {"height_counts_by_its_cube", height_counts_by_its_cube, "23c"},
    {"dimension_knows_bars_and_beams", dimension_knows_bars_and_beams, "23c"},
    {"inertia_is_rayleighs", inertia_is_rayleighs, "23c"},
    {"loads_agree_with_the_library", loads_agree_with_the_library, "23c"},
    {"verdict_counts_what_is_left_out", verdict_counts_what_is_left_out, "23d"},
    {"verdict_names_each_part", verdict_names_each_part, "23d"},
    {"the_tolerance_is_enough", the_tolerance_is_enough, "23d"},
    {"what_is_unstable_is_never_enough", what_is_unstable_is_never_enough,
     "23d"},
    {"estimates_meet_the_truth", estimates_meet_the_truth, NULL},
    {"what_is_too_strict_is_refused", what_is_too_strict_is_refused, NULL},
};

static const char *const runs[] = {
    "",
    "--scene hanging --tolerance 0.005",
    "--scene cantilever",
    "--scene stout-column --tolerance 0.02 --truth yes",
    "--scene above-buckling",
    "--scene fast-pull --tolerance 0.01",
    "--scene incompressible --load 0.5",
    "--scene small-twist --tolerance 0.05 --load 2",
};

#define ITERATED "of a u that Newton's method gave to 1e-9 m"
static const struct column_rule rules[] = {
    {"ladder", "rung", 0, "a count", 0},
    {"ladder", "model", 0, "a word", 0},
    {"ladder", "state", 0, "a word", 0},
    {"ladder", "mesh", 0, "a level", 1},
    {"ladder", "stable", 0, "a word", 0},
    {"ladder", "verdict", 0, "a word", 0},
    {"ladder", "flops", 0.02, "Newton's method may take a step more", 0},
    {"ladder", "*", 1e-6, ITERATED, 1},
};

static const struct lesson lesson = {
    "23_least_model", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Run --scene above-buckling --truth yes: on the first rung every part is "
    "small, the estimate says 3 %, and the truth is 99 %. Only the sign of the "
    "lowest eigenvalue of K knows it (figures/23_least_model/twelve.svg).",
    "Let the verdict forget the mesh. Which six scenes then stop on a rung "
    "that is wrong by 17 % or more, and which do not change?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
