/*
 * 15_definiteness.c - what right modes, projections, directions satisfy.
 *
 * Arguments: slot, argument: varied by
 *   15a  F         f_is_u_s_vt: upright, mirrored, rank one and 0, s1 = |s2|
 *   15b  mu, J, G  every_mode_has_its_factor (laws, states), and the oracles'
 *                  other material
 *        s1, s2    the same
 *   15c  svd, F    unclamped_is_the_derivative_of_the_stress (laws, states)
 *        floor     the same (-INFINITY), negative_eigenvalues_become_the_floor
 *                  (0, 23.85)
 *        dF        negative_eigenvalues_become_the_floor (each entry)
 *   15d  body      direction_solves_the_system (laws), failures_are_named (a
 *                  modulus below 0), runs (other meshes)
 *        projection each check of 15d
 *        u         pulled, straight, bent: direction_solves_the_system to
 *                  newton_leaves_the_saddle; NaN and inside out:
 *                  failures_are_named
 *        q, du     guarded and NaN before: direction_solves_the_system
 */
#include "program.h"

#include "judge.h"

#include "../oracle/15_definiteness.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_math.h>
#include <string.h>

#define ROUND_OFF 1e-12 /* relative to the largest eigenvalue */
#define DERIVATIVE 1e-7 /* central differences, the best of a sweep of steps */

/* ---- states and 4x4 matrices --------------------------------------------- */

static const struct {
    const char *name;
    mat2 F;
} cases[] = {
    {"generic", {{{1.17, 0.23}, {-0.31, 0.88}}}},
    {"at rest", {{{1.0, 0.0}, {0.0, 1.0}}}},
    {"turned by 180 degrees", {{{-1.0, 0.0}, {0.0, -1.0}}}},
    {"turned by 30 degrees", {{{0.8660254037844386, -0.5},
                               {0.5, 0.8660254037844386}}}},
    {"pressed", {{{0.61, 0.17}, {-0.09, 0.83}}}},
    {"stretched", {{{2.31, 0.19}, {-0.27, 1.43}}}},
    {"mirrored, s1 = -s2", {{{0.6, 0.8}, {0.8, -0.6}}}},
    {"inverted", {{{0.9, 0.4}, {0.35, -0.6}}}},
    {"pressed to a line", {{{1.1, 0.5}, {0.44, 0.2}}}},
    {"pressed to a point", {{{0.0, 0.0}, {0.0, 0.0}}}},
};

/* Cases of the cubic law, then those of the log law where it is defined. */
enum { CASES = 2 * COUNT(cases) };
static int case_of(int k, struct material *material, mat2 *F, const char **name)
{
    *material = material_make(k < COUNT(cases) ? CUBIC : LOG, 371.4, 0.2385);
    *F = cases[k % COUNT(cases)].F;
    *name = cases[k % COUNT(cases)].name;
    return material->law == CUBIC || mat2_det(*F) > 1e-9;
}

static mat2 unit(int c)
{
    mat2 D = {0};
    D.m[c / 2][c % 2] = 1.0;
    return D;
}

/* value: ascending eigenvalues of dP/dF by GSL; C: the matrix again, what is
 * below floor lifted to it.  Returns the largest |value|. */
static double by_gsl(const struct material *material, mat2 F, double floor,
                     double value[4], double C[4][4])
{
    gsl_matrix *A = gsl_matrix_alloc(4, 4), *V = gsl_matrix_alloc(4, 4);
    gsl_vector *d = gsl_vector_alloc(4);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(4);
    for (size_t c = 0; c < 4; c++) {
        const mat2 dP = material2_dpk1(material, F, unit((int)c));
        for (size_t r = 0; r < 4; r++)
            gsl_matrix_set(A, r, c, dP.m[r / 2][r % 2]);
    }
    gsl_eigen_symmv(A, d, V, work);
    gsl_eigen_symmv_sort(d, V, GSL_EIGEN_SORT_VAL_ASC);
    for (size_t m = 0; m < 4; m++) value[m] = gsl_vector_get(d, m);
    for (size_t r = 0; r < 4; r++)
        for (size_t c = 0; c < 4; c++) {
            C[r][c] = 0.0;
            for (size_t m = 0; m < 4; m++)
                C[r][c] += fmax(value[m], floor) * gsl_matrix_get(V, r, m) *
                           gsl_matrix_get(V, c, m);
        }
    gsl_eigen_symmv_free(work);
    gsl_vector_free(d);
    gsl_matrix_free(A);
    gsl_matrix_free(V);
    return fmax(fabs(value[0]), fabs(value[3]));
}

/* U E V^T with the student's U and V. */
static mat2 placed(const struct svd *svd, mat2 E)
{
    return mat2_multiply(svd->U, mat2_multiply(E, mat2_transpose(svd->V)));
}

/* ---- 15a ----------------------------------------------------------------- */

static void f_is_u_s_vt(void)
{
    for (int k = 0; k < COUNT(cases); k++) {
        const mat2 F = cases[k].F;
        const struct svd svd = signed_svd(F);
        const mat2 back = placed(&svd, (mat2){{{svd.s1, 0.0}, {0.0, svd.s2}}});
        for (int i = 0; i < 4; i++)
            expect_close(back.m[i / 2][i % 2], F.m[i / 2][i % 2], 1e-14, 4.0,
                         "%s: U S V^T, entry %d%d", cases[k].name, i / 2 + 1,
                         i % 2 + 1);
        expect(svd.s1 >= fabs(svd.s2) - 1e-14, "%s: s1 = %g is less than "
               "|s2|, s2 = %g", cases[k].name, svd.s1, svd.s2);
    }
}

static void u_and_v_are_rotations(void)
{
    for (int k = 0; k < COUNT(cases); k++) {
        const struct svd svd = signed_svd(cases[k].F);
        for (int which = 0; which < 2; which++) {
            const mat2 R = which ? svd.V : svd.U;
            const mat2 product = mat2_multiply(R, mat2_transpose(R));
            const char letter = which ? 'V' : 'U';
            expect_close(mat2_norm(mat2_subtract(product, mat2_identity())),
                         0.0, 1e-14, 1.0, "%s: size of %c %c^T - I",
                         cases[k].name, letter, letter);
            expect_close(mat2_det(R), 1.0, 1e-14, 1.0, "%s: det %c",
                         cases[k].name, letter);
        }
        expect_close(svd.s1 * svd.s2, mat2_det(cases[k].F), 1e-14, 4.0,
                     "%s: s1 s2, against det F", cases[k].name);
    }
}

/* ---- 15b ----------------------------------------------------------------- */

/* The factor of a mode is the D:dP(D) of its D. */
static void every_mode_has_its_factor(void)
{
    const double half = sqrt(0.5);
    const mat2 E[2] = {{{{0.0, -half}, {half, 0.0}}},
                       {{{0.0, half}, {half, 0.0}}}};
    for (int k = 0; k < CASES; k++) {
        struct material material;
        mat2 F;
        const char *name;
        double C[4][4], gsl[4], *value = guarded_alloc(4);
        if (!case_of(k, &material, &F, &name)) continue;
        const double scale = by_gsl(&material, F, -INFINITY, gsl, C);
        const struct svd svd = modes_svd(F);
        eigenvalues(&material, svd.s1, svd.s2, value);
        for (int m = MODE_TWIST; m <= MODE_FLIP; m++) {
            const mat2 D = placed(&svd, E[m]);
            expect_close(value[m],
                         mat2_dot(D, material2_dpk1(&material, F, D)),
                         ROUND_OFF, scale, "%s, %s law: factor of %s, against "
                         "D:dP(D)", name, material_law(material.law),
                         m == MODE_TWIST ? "MODE_TWIST" : "MODE_FLIP");
        }
    }
}

static void eigenvalues_are_those_of_gsl(void)
{
    for (int k = 0; k < CASES; k++) {
        struct material material;
        mat2 F;
        const char *name;
        double C[4][4], gsl[4], *value = guarded_alloc(4);
        if (!case_of(k, &material, &F, &name)) continue;
        const double scale = by_gsl(&material, F, -INFINITY, gsl, C);
        const struct svd svd = modes_svd(F);
        eigenvalues(&material, svd.s1, svd.s2, value);
        expect(value[MODE_LOW] <= value[MODE_HIGH],
               "%s: MODE_LOW %g is above MODE_HIGH %g", name,
               value[MODE_LOW], value[MODE_HIGH]);
        for (int a = 0; a < 4; a++) /* sort */
            for (int b = 0; b < 3; b++)
                if (value[b] > value[b + 1]) {
                    const double keep = value[b];
                    value[b] = value[b + 1];
                    value[b + 1] = keep;
                }
        for (int m = 0; m < 4; m++)
            expect_close(value[m], gsl[m], 1e-11, scale,
                         "%s, %s law: eigenvalue %d of dP/dF in ascending "
                         "order, against GSL", name, material_law(material.law),
                         m);
    }
}

/* ---- 15c ----------------------------------------------------------------- */

/* Without a floor it is the derivative of the stress. */
static void unclamped_is_the_derivative_of_the_stress(void)
{
    const mat2 dF = {{{0.37, -0.61}, {0.83, 0.29}}};
    for (int k = 0; k < CASES; k++) {
        struct material material;
        mat2 F;
        const char *name;
        double best = INFINITY, size = 100.0;
        mat2 want = {0};
        if (!case_of(k, &material, &F, &name)) continue;
        const mat2 got = projected_dpk1(&material, F, -INFINITY, dF);
        for (double h = 1e-2; h > 1e-7; h *= 0.1) {
            const mat2 step = mat2_scale(h, dF);
            const mat2 up = material2_pk1(&material, mat2_add(F, step));
            const mat2 down = material2_pk1(&material, mat2_subtract(F, step));
            const mat2 slope =
                mat2_scale(0.5 / h, mat2_subtract(up, down));
            const double off = mat2_norm(mat2_subtract(slope, got));
            if (off < best) want = slope;
            best = fmin(best, off);
            size = fmax(size, mat2_norm(slope));
        }
        for (int i = 0; i < 4; i++)
            expect_close(got.m[i / 2][i % 2], want.m[i / 2][i % 2], DERIVATIVE,
                         size, "%s, %s law, no floor: dP%d%d, against the "
                         "change of P", name, material_law(material.law),
                         i / 2 + 1, i % 2 + 1);
    }
}

/* Also where all are positive: there it is dP/dF itself. */
static void negative_eigenvalues_become_the_floor(void)
{
    const double floors[] = {0.0, 23.85, 1e6}; /* the last is above all */
    for (int k = 0; k < 3 * CASES; k++) {
        struct material material;
        mat2 F;
        const char *name;
        double C[4][4], gsl[4];
        if (!case_of(k % CASES, &material, &F, &name)) continue;
        const double floor = floors[k / CASES];
        const double scale = by_gsl(&material, F, floor, gsl, C);
        for (int c = 0; c < 4; c++) {
            const mat2 dP = projected_dpk1(&material, F, floor, unit(c));
            for (int r = 0; r < 4; r++)
                expect_close(dP.m[r / 2][r % 2], C[r][c], 1e-11, scale,
                             "%s, %s law, floor %g: row %d, column %d of the "
                             "projected matrix, against GSL's eigenvectors "
                             "with the eigenvalues clamped", name,
                             material_law(material.law), floor, r, c);
        }
    }
}

static void projection_turns_with_the_body(void)
{
    const mat2 Q = mat2_rotation(0.6137), R = mat2_rotation(-1.238);
    const mat2 dF = {{{0.37, -0.61}, {0.83, 0.29}}};
    for (int k = 0; k < CASES; k++) {
        struct material material;
        mat2 F;
        const char *name;
        double C[4][4], gsl[4];
        if (!case_of(k, &material, &F, &name)) continue;
        const double scale = by_gsl(&material, F, 0.0, gsl, C);
        const mat2 dP = projected_dpk1(&material, F, 0.0, dF);
        const mat2 want = mat2_multiply(Q, mat2_multiply(dP, R));
        const mat2 got = projected_dpk1(
            &material, mat2_multiply(Q, mat2_multiply(F, R)), 0.0,
            mat2_multiply(Q, mat2_multiply(dF, R)));
        expect_close(mat2_norm(mat2_subtract(got, want)), 0.0, 1e-11, scale,
                     "%s, %s law: dP of Q F R, against Q dP R", name,
                     material_law(material.law));
    }
}

static void agrees_with_the_common_modes(void)
{
    const mat2 dF = {{{-0.53, 0.41}, {0.23, 0.71}}};
    for (int k = 0; k < CASES; k++) {
        struct material material;
        mat2 F;
        const char *name;
        if (!case_of(k, &material, &F, &name)) continue;
        const struct modes modes = modes_at(&material, F);
        const mat2 want = modes_dpk1(&modes, dF);
        const mat2 got = projected_dpk1(&material, F, 0.0, dF);
        expect_close(mat2_norm(mat2_subtract(got, want)), 0.0, 1e-11,
                     1e3 + fabs(modes.value[MODE_HIGH]), "%s: against modes.h",
                     name);
    }
}

/* ---- 15d ----------------------------------------------------------------- */

enum { N = 40, N_DOF = 2 * (N + 1) * 5 };
static const char *const how[] = {"NEVER", "ON_DEMAND", "ALWAYS"};

/* The column with u = its ends moved by e, and something irregular inside. */
static struct scene *column_at(enum law law, double e, double amount)
{
    const struct scene_setting set = scene_column(law, N, e);
    struct scene *s = scene_alloc(&set);
    scene_hold(s, M_PI_2);
    step_boundary(s->body, s->g, 1, s->u);
    for (int r = 0; r < s->n_dof; r++)
        if (!s->held[r / 2])
            s->u[r] += amount * sin(2.385 * r + 0.613) * cos(0.37 * r * r);
    return s;
}

/* Straight and in balance at e, then bent by `amount` as it buckles: towards
 * one of the two buckled columns at 0.05, away from the other. */
static struct scene *bent_column(double e, double amount)
{
    struct step_control control = step_method("notes");
    struct scene *s = column_at(CUBIC, e, 0.0), *out[2];
    step_solve(s->body, &control, at_rest(NULL), s->u);
    control = step_method("demand+search");
    for (int side = 0; side < 2; side++) {
        out[side] = column_at(CUBIC, 0.05, 0.0);
        for (int y = 1; y < N_DOF; y += 2)
            if (!s->held[y / 2])
                out[side]->u[y] += (side ? -0.01 : 0.01) *
                                   (1.0 + cos(M_PI * s->mesh->X[y - 1]));
        step_solve(out[side]->body, &control, at_rest(NULL), out[side]->u);
    }
    for (int r = 0; r < N_DOF; r++)
        s->u[r] += 0.5 * amount * (out[0]->u[r] - out[1]->u[r]);
    scene_free(out[0]);
    scene_free(out[1]);
    return s;
}

struct found {
    enum status status;
    int definite;
    double *q, *du, slope;
};
static struct found find(struct scene *s, enum projection projection)
{
    struct found found = {.definite = -1, .q = guarded_alloc(N_DOF),
                          .du = guarded_alloc(N_DOF)};
    found.status = direction(s->body, projection, s->u, found.q, found.du,
                             &found.definite);
    for (int r = 0; r < N_DOF; r++)
        if (!s->held[r / 2]) found.slope += found.q[r] * found.du[r];
    return found;
}

/* K du = -q at the free unknowns with the K meant, du = 0 at the held ones. */
static void expect_solved(struct scene *s, enum tangent tangent,
                          const struct found *found, const char *what)
{
    double want[N_DOF], some[N_DOF], Kdu[N_DOF], largest = 0.0, size = 0.0;
    expect(found->status == OK, "%s: direction() says %s", what,
           status_name(found->status));
    expect(body_assemble(s->body, at_rest(NULL), s->u, tangent, want) == OK,
           "%s: no K", what);
    for (int r = 0; r < N_DOF; r++) {
        expect_close(found->q[r], want[r], 1e-10, 1.0, "%s: q of vertex %d, "
                     "component %d", what, r / 2, r % 2);
        if (s->held[r / 2])
            expect_close(found->du[r], 0.0, 1e-14, 1.0,
                         "%s: du of held vertex %d", what, r / 2);
    }
    body_gather(s->body, found->du, some);
    matrix_multiply(s->body->K, some, Kdu);
    for (int k = 0; k < s->body->n_equation; k++)
        largest = fmax(largest, fabs(some[k]));
    body_gather(s->body, want, some);
    for (int k = 0; k < s->body->n_equation; k++)
        size = fmax(size, fabs(some[k]));
    for (int k = 0; k < s->body->n_equation; k++)
        expect_close(Kdu[k], -some[k], 1e-10, size + 1e3 * largest,
                     "%s: row %d of K du, against -q", what, k);
}

static void direction_solves_the_system(void)
{
    for (enum law law = LOG; law <= CUBIC; law++) {
        struct scene *s = column_at(law, -0.07, 1e-3); /* pulled */
        for (int m = NEVER; m <= ALWAYS; m++) {
            const struct found found = find(s, (enum projection)m);
            expect_solved(s, m == ALWAYS ? PROJECTED : EXACT, &found, how[m]);
            expect(found.definite == 1, "%s: K of a pulled column is positive "
                   "definite", how[m]);
            expect(found.slope < 0.0, "%s: du.q = %g, uphill", how[m],
                   found.slope);
        }
        scene_free(s);
    }
}

/* Every element has a negative eigenvalue, the body has none. */
static void on_demand_projects_on_demand_only(void)
{
    struct scene *s = bent_column(0.02, 0.01);
    for (int m = NEVER; m <= ALWAYS; m++) {
        const struct found found = find(s, (enum projection)m);
        expect_solved(s, m == ALWAYS ? PROJECTED : EXACT, &found, how[m]);
        expect(found.definite == 1, "%s: K of a column at e = 0.02 is positive "
               "definite, though no element's is", how[m]);
    }
    scene_free(s);
}

/* Beyond the bifurcation: K has one negative eigenvalue, and bent along it the
 * column's Newton direction as it is leads back up. */
static void projected_directions_lead_downhill(void)
{
    struct scene *s = bent_column(0.05, 0.02);
    for (int m = NEVER; m <= ALWAYS; m++) {
        const struct found found = find(s, (enum projection)m);
        expect_solved(s, m == NEVER ? EXACT : PROJECTED, &found, how[m]);
        expect(found.definite == 0, "%s: K of the straight column at e = 0.05 "
               "is not positive definite, *definite says it is", how[m]);
        expect(step_certify(s->body, at_rest(NULL), s->u) == SADDLE,
               "step.h disagrees");
        expect((found.slope > 0.0) == (m == NEVER), "%s: du.q = %g", how[m],
               found.slope);
    }
    scene_free(s);
}

/* A Newton's method that goes by direction(): it passes states where K is not
 * positive definite, and ends in a minimum. */
static void newton_leaves_the_saddle(void)
{
    struct scene *s = bent_column(0.05, 0.1);
    const double at_start[] = {0.57020043128699, 0.54636743325717};
    double energy, *q = guarded_alloc(N_DOF), *du = guarded_alloc(N_DOF);
    int definite = -1, systems = 0, passed = 0;
    for (; systems < 200; systems++) {
        const enum status status =
            direction(s->body, ON_DEMAND, s->u, q, du, &definite);
        expect(status == OK, "system %d of ON_DEMAND ends with %s", systems,
               status_name(status));
        passed += !definite;
        if (body_max_free(s->body, q) <= 1e-9) break;
        expect(step_search(s->body, at_rest(NULL), q, du, s->u) == OK,
               "system %d of ON_DEMAND: no length of du decreases the energy",
               systems);
    }
    expect(systems < 200 && passed > 0 && definite == 1,
           "ON_DEMAND from a bent column: %d systems, K was not positive "
           "definite %d times, at the end it is %s", systems, passed,
           definite ? "so" : "not so");
    expect(step_certify(s->body, at_rest(NULL), s->u) == OK, "step.h does not "
           "call the buckled column a minimum");
    body_energy(s->body, s->u, &energy);
    expect_close(energy, at_start[1], 1e-9, 1.0, "energy of the buckled column "
                 "(straight: %g)", at_start[0]);
    scene_free(s);
}

static void failures_are_named(void)
{
    struct scene *s = column_at(LOG, 0.02, 0.0);
    for (int m = NEVER; m <= ALWAYS; m++) {
        double *mid = &s->u[N_DOF / 2 + 3], keep = *mid;
        *mid = NAN;
        expect(find(s, (enum projection)m).status == NONFINITE,
               "%s, u with a NaN: NONFINITE", how[m]);
        *mid = 0.2;
        expect(find(s, (enum projection)m).status == INVERTED,
               "%s, log law, a triangle inside out: INVERTED", how[m]);
        *mid = keep;
    }
    /* a modulus below 0: K has no factors, projected neither */
    s->body->material.mu *= -1.0;
    s->body->material.lambda *= -1.0;
    for (int m = ON_DEMAND; m <= ALWAYS; m++) {
        const struct found found = find(s, (enum projection)m);
        expect(found.status == NOT_SPD && !found.definite,
               "%s, a modulus below 0: NOT_SPD and not definite, not %s and %d",
               how[m], status_name(found.status), found.definite);
    }
    scene_free(s);
}

static void converged_is_not_stable(void)
{
    struct output *out = run("--e 0.05");
    for (int k = 0; k < 6; k++) {
        const int buckled = k == 3 || k == 5;
        expect(strcmp(word(out, "column", "status", k),
                      buckled ? "OK" : "SADDLE") == 0 &&
                   strcmp(word(out, "column", "end", k),
                          buckled ? "yes" : "no") == 0,
               "e = 0.05, %s, push %g: status %s, K at the solution positive "
               "definite: %s", word(out, "column", "method", k),
               cell(out, "column", "push", k), word(out, "column", "status", k),
               word(out, "column", "end", k));
    }
    out = run("--e 0.03");
    for (int k = 0; k < 6; k++)
        expect(strcmp(word(out, "column", "status", k), "OK") == 0 &&
                   strcmp(word(out, "column", "start", k), "no") == 0,
               "e = 0.03, %s: the guess is not positive definite, the solution "
               "is; status %s, start %s", word(out, "column", "method", k),
               word(out, "column", "status", k),
               word(out, "column", "start", k));
}

static void numbers_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_modes); k++) {
        const struct material material = material_notes(oracle_modes[k].law);
        const struct svd svd = signed_svd(oracle_modes[k].F);
        const double want[] = {oracle_modes[k].twist, oracle_modes[k].flip,
                               oracle_modes[k].low, oracle_modes[k].high};
        double *value = guarded_alloc(4);
        expect_close(svd.s1, oracle_modes[k].s1, 1e-14, 2.0, "%s: s1",
                     oracle_modes[k].name);
        expect_close(svd.s2, oracle_modes[k].s2, 1e-14, 2.0, "%s: s2",
                     oracle_modes[k].name);
        eigenvalues(&material, svd.s1, svd.s2, value);
        for (int m = 0; m < 4; m++)
            expect_close(value[m], want[m], ROUND_OFF, want[3],
                         "%s, %s law: factor %d", oracle_modes[k].name,
                         material_law(material.law), m);
    }
    const struct material cubic = material_notes(CUBIC);
    for (int rc = 0; rc < 16; rc++)
        expect_close(projected_dpk1(&cubic, oracle_modes[4].F, 0.0,
                                    unit(rc % 4)).m[rc / 8][rc / 4 % 2],
                     oracle_projected[rc], ROUND_OFF, 61586.92,
                     "inverted, projected: row %d, column %d", rc / 4, rc % 4);
    for (int k = 0; k < COUNT(oracle_column); k++) {
        char options[64];
        snprintf(options, sizeof options, "--half 4 --e %g",
                 oracle_column[k].e);
        struct output *out = run(options);
        const char *want = oracle_column[k].stable ? "OK" : "SADDLE";
        expect(strcmp(word(out, "column", "status", 0), want) == 0,
               "80 x 8, e = %g, notes: %s", oracle_column[k].e, want);
        expect_close(cell(out, "column", "energy", 0),
                     oracle_column[k].straight, 1e-11, 1.0,
                     "80 x 8, e = %g, straight: energy", oracle_column[k].e);
        expect_close(cell(out, "column", "energy", 3),
                     oracle_column[k].buckled, 1e-11, 1.0,
                     "80 x 8, e = %g, pushed: energy", oracle_column[k].e);
        if (oracle_column[k].out >= 0.0)
            expect_close(cell(out, "column", "deflection", 3),
                         oracle_column[k].out, 1e-6, 1.0,
                         "80 x 8, e = %g, pushed: deflection",
                         oracle_column[k].e);
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("");
    int r = 0;
    while (cell(output, "where", "least", r + 1) <= 0.0) r++;
    measured("1", cell(output, "where", "s", r));
    measured("3", fabs(cell(output, "column", "deflection", 3)));
}

static const struct claim claims[] = {
    {"f_is_u_s_vt", f_is_u_s_vt, "15a"},
    {"u_and_v_are_rotations", u_and_v_are_rotations, "15a"},
    {"every_mode_has_its_factor", every_mode_has_its_factor, "15b"},
    {"eigenvalues_are_those_of_gsl", eigenvalues_are_those_of_gsl, "15b"},
    {"unclamped_is_the_derivative_of_the_stress",
     unclamped_is_the_derivative_of_the_stress, "15c"},
    {"negative_eigenvalues_become_the_floor",
     negative_eigenvalues_become_the_floor, "15c"},
    {"projection_turns_with_the_body", projection_turns_with_the_body, "15c"},
    {"agrees_with_the_common_modes", agrees_with_the_common_modes, "15c"},
    {"direction_solves_the_system", direction_solves_the_system, "15d"},
    {"on_demand_projects_on_demand_only", on_demand_projects_on_demand_only,
     "15d"},
    {"projected_directions_lead_downhill", projected_directions_lead_downhill,
     "15d"},
    {"newton_leaves_the_saddle", newton_leaves_the_saddle, "15d"},
    {"failures_are_named", failures_are_named, "15d"},
    {"converged_is_not_stable", converged_is_not_stable, "15d"},
    {"numbers_are_the_oracles", numbers_are_the_oracles, NULL},
};

/* Near the bifurcation of none of the three meshes. */
static const char *const runs[] = {
    "",
    "--half 1 --e 0.0371 --law log",
    "--half 3 --e 0.06",
};

#define CLOSED "closed forms"
static const struct column_rule rules[] = {
    {"modes", "state", 0, "a word", 0},
    {"modes", "*", 1e-12, CLOSED, 0},
    {"where", "*", 1e-12, CLOSED, 1e3},
    {"descent", "state", 0, "a word", 0},
    {"descent", "definite", 0, "a word", 0},
    {"descent", "*", 1e-9, "the states are iterates", 0},
    {"column", "load", 0, "given", 0},
    {"column", "method", 0, "a word", 0},
    {"column", "push", 0, "given", 0},
    {"column", "systems", NOT_COMPARED, "round-off decides near a bifurcation",
     0},
    {"column", "deflection", 1e-6, "soft near a bifurcation", 1},
    {"column", "energy", 1e-10, "Newton's method to 1e-10", 1},
    {"column", "*", 0, "a word", 0},
    {"nodes", "u_x", 1e-6, "soft near a bifurcation", 1},
    {"nodes", "u_y", 1e-6, "soft near a bifurcation", 1},
    {"nodes", "*", 1e-14, "given", 1e3},
};

static const struct lesson lesson = {
    "15_definiteness", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Every element of the pressed column has a negative eigenvalue, and still "
    "K of the body is positive definite up to the load at which it buckles "
    "(figures/15_definiteness/bifurcation.svg). And where it is not, Newton's "
    "method converges all the same, and says nothing.",
    "Let direction() say that K is positive definite whenever the projected "
    "one is. Which rows of table `column` change, and which of them would you "
    "have believed?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
