/* fibre.c - laws of common/plane/fibre.h, and of what a body adds (body.h). */
#include "plane/fibre.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct fibre muscle = {MUSCLE, 213.7, 371.4, 0.4238, 0.6137};
static const struct fibre cord = {CORD, 213.7, 371.4, 0.4238, 0.2385};

static void the_muscle_has_its_limbs(void)
{
    const struct fibre full = fibre_muscle(1.0), none = fibre_muscle(0.0);
    const double l[] = {0.4, 0.75, 1.0, 1.25, 1.6};
    const double T[] = {0.0, 225.0, 300.0, 237.5, 72.0};
    const double taut[] = {0.0, 0.0, 0.0, 12.5, 72.0};
    for (int k = 0; k < COUNT(l); k++) {
        close_to(fibre_tension(&full, l[k]).T, T[k], 1e-10);
        close_to(fibre_tension(&none, l[k]).T, taut[k], 1e-10);
    }
    close_to(fibre_tension(&cord, 1.0).T, 0.2385 * 371.4, 1e-12);
    close_to(fibre_tension(&cord, 1.25).T, 0.2385 * 371.4 + 0.25 * 213.7,
             1e-12);
}

static void tension_is_the_slope_of_its_energy(void)
{
    const struct fibre *const of[] = {&muscle, &cord};
    const double l[] = {0.3371, 0.6137, 0.9714, 1.0371, 1.3714, 1.6137};
    const double h = 1e-5;
    for (int c = 0; c < 2 * COUNT(l); c++) {
        const struct fibre *fibre = of[c % 2];
        const double at = l[c / 2];
        const struct tension t = fibre_tension(fibre, at);
        const struct tension a = fibre_tension(fibre, at - h);
        const struct tension b = fibre_tension(fibre, at + h);
        close_to(t.T, (b.W - a.W) / (2.0 * h), 1e-6);
        close_to(t.dT, (b.T - a.T) / (2.0 * h), 1e-5);
    }
    /* nothing jumps at the kinks, and there is no energy at rest */
    const double kink[] = {1.0 - muscle.width, 1.0, 1.0 + muscle.width};
    for (int k = 0; k < COUNT(kink); k++) {
        const struct tension a = fibre_tension(&muscle, kink[k] - 1e-9);
        const struct tension b = fibre_tension(&muscle, kink[k] + 1e-9);
        close_to(a.W, b.W, 1e-6);
        close_to(a.T, b.T, 1e-4);
    }
    close_to(fibre_tension(&muscle, 1.0).W, 0.0, 1e-15);
    close_to(fibre_tension(&cord, 1.0).W, 0.0, 1e-15);
}

static const mat2 state[] = {{{{0.82, -0.19}, {0.27, 0.93}}},
                             {{{1.17, 0.23}, {-0.31, 0.98}}},
                             {{{1.71, 0.38}, {-0.62, 1.13}}}};
static const double g[2] = {0.6, 0.8};

/* The energy for the direction d. */
static double psi(const struct fibre *fibre, const double d[2], mat2 F)
{
    return fibre_tension(fibre, hypot(F.m[0][0] * d[0] + F.m[0][1] * d[1],
                                      F.m[1][0] * d[0] + F.m[1][1] * d[1])).W;
}

static void stress_and_tangent_are_slopes(void)
{
    const struct fibre *const of[] = {&muscle, &cord};
    const mat2 dF = {{{0.613, -0.371}, {0.238, 0.714}}};
    const double h = 1e-5;
    for (int c = 0; c < 2 * COUNT(state); c++) {
        const struct fibre *fibre = of[c % 2];
        const mat2 F = state[c / 2];
        const mat2 less = mat2_subtract(F, mat2_scale(h, dF));
        const mat2 more = mat2_add(F, mat2_scale(h, dF));
        close_to(mat2_dot(fibre_pk1(fibre, g, F), dF),
                 (psi(fibre, g, more) - psi(fibre, g, less)) / (2.0 * h),
                 1e-6);
        const mat2 dP = fibre_dpk1(fibre, g, F, dF, EXACT);
        const mat2 slope =
            mat2_scale(0.5 / h, mat2_subtract(fibre_pk1(fibre, g, more),
                                              fibre_pk1(fibre, g, less)));
        close_to(mat2_norm(mat2_subtract(dP, slope)), 0.0, 1e-5);
    }
}

/* A compressed cord and a muscle on its descending limb: T/l, T' negative. */
static void projection_clamps_two_eigenvalues(void)
{
    const struct fibre *const of[] = {&muscle, &cord};
    const mat2 F[] = {state[1], {{{0.31, 0.07}, {-0.11, 0.42}}}};
    for (int c = 0; c < 4; c++) {
        const struct fibre *fibre = of[c / 2];
        const enum tangent kind = c % 2 ? PROJECTED : EXACT;
        const mat2 at = F[c / 2];
        const double n[2] = {at.m[0][0] * g[0] + at.m[0][1] * g[1],
                             at.m[1][0] * g[0] + at.m[1][1] * g[1]};
        const double l = hypot(n[0], n[1]);
        const struct tension t = fibre_tension(fibre, l);
        double along = t.dT, across = t.T / l;
        ck_assert(c / 2 ? across < 0.0 : along < 0.0);
        if (kind == PROJECTED) {
            along = fmax(along, 0.0);
            across = fmax(across, 0.0);
        }
        for (int k = 0; k < 2; k++) { /* eigenvectors n g^T, n' g^T, n g'^T */
            const double m[2] = {k ? -n[1] / l : n[0] / l,
                                 k ? n[0] / l : n[1] / l};
            const mat2 E = {{{m[0] * g[0], m[0] * g[1]},
                             {m[1] * g[0], m[1] * g[1]}}};
            const mat2 off = {{{-m[0] * g[1], m[0] * g[0]},
                               {-m[1] * g[1], m[1] * g[0]}}};
            const mat2 want = mat2_scale(k ? across : along, E);
            close_to(mat2_norm(mat2_subtract(
                         fibre_dpk1(fibre, g, at, E, kind), want)), 0.0, 1e-10);
            close_to(mat2_norm(fibre_dpk1(fibre, g, at, off, kind)), 0.0,
                     1e-10);
        }
    }
}

static void a_fibre_without_length_does_nothing(void)
{
    const mat2 flat = {{{0.8, -0.6}, {-0.4, 0.3}}}; /* F g = 0 */
    for (int c = 0; c < 2; c++) {
        const enum tangent kind = c ? PROJECTED : EXACT;
        close_to(mat2_norm(fibre_pk1(&cord, g, flat)), 0.0, 1e-15);
        close_to(mat2_norm(fibre_dpk1(&cord, g, flat, state[0], kind)), 0.0,
                 1e-15);
    }
}

enum { N = 3, N_DOF = 32, N_TRIANGLE = 18 };

/* Numbers without a pattern, in (-1, 1). */
static double entropy(int i)
{
    return sin(2.385 * i * i + 3.714 * i + 0.7);
}

/* Energy, force and stiffness of the fibres, element by element. */
struct sums {
    double energy, force[N_DOF], stiff[N_DOF][N_DOF];
};
static void sum_up(const struct body *body, const struct fibres *fibres,
                   const double u[], enum tangent kind, struct sums *sum)
{
    *sum = (struct sums){.energy = 0.0};
    for (int s = 0; s < 36 * N_TRIANGLE; s++) {
        const int e = s / 36, c[2] = {s / 6 % 6, s % 6};
        const double d[2] = {cos(fibres->angle[e]), sin(fibres->angle[e])};
        const mat2 F = body_deformation(body, u, e);
        const double area = body->area[e];
        mat2 dF[2] = {{{{0.0}}}, {{{0.0}}}};
        int at[2];
        for (int k = 0; k < 2; k++) { /* dF/du of unknown c[k] */
            at[k] = 2 * body->vertex[3 * e + c[k] / 2] + c[k] % 2;
            for (int m = 0; m < 2; m++)
                dF[k].m[c[k] % 2][m] =
                    body->gradient[6 * e + c[k] / 2 * 2 + m];
        }
        if (s % 36 == 0) {
            sum->energy += area * psi(&fibres->fibre, d, F);
            close_to(fibres_stretch(body, fibres, u, e, NULL),
                     hypot(F.m[0][0] * d[0] + F.m[0][1] * d[1],
                           F.m[1][0] * d[0] + F.m[1][1] * d[1]), 1e-14);
        }
        if (c[1] == 0)
            sum->force[at[0]] +=
                area * mat2_dot(dF[0], fibre_pk1(&fibres->fibre, d, F));
        if (kind != NO_TANGENT)
            sum->stiff[at[0]][at[1]] +=
                area * mat2_dot(dF[0], fibre_dpk1(&fibres->fibre, d, F, dF[1],
                                                  kind));
    }
}

/* What a body with fibres has more than the body without is their sum; dt^2
 * multiplies q and K. */
static void a_body_gets_energy_force_and_stiffness(void)
{
    int held[16] = {1, 0, 0, 0, 1, 0, 0, 1}; /* some */
    struct mesh *mesh = mesh_square(N);
    double angle[N_TRIANGLE], u[N_DOF], q[2][N_DOF], energy[2];
    const double dt = 0.7371;
    for (int e = 0; e < N_TRIANGLE; e++) angle[e] = 1.3 * entropy(e);
    for (int r = 0; r < N_DOF; r++) u[r] = 0.1 * entropy(r + 37);
    const struct fibres fibres = {muscle, angle};
    struct body *body = body_alloc(mesh, material_notes(CUBIC), 0.0,
                                   CONSISTENT, held);
    const enum tangent kinds[] = {NO_TANGENT, PROJECTED, EXACT};
    for (int c = 0; c < COUNT(kinds); c++) {
        struct matrix *K = NULL;
        struct sums want;
        for (int with = 0; with < 2; with++) {
            body->add = NULL;
            if (with) fibres_attach(body, &fibres);
            ck_assert(body_energy(body, u, &energy[with]) == OK);
            const struct incremental Phi = {dt, u, NULL};
            ck_assert(body_assemble(body, Phi, u, kinds[c], q[with]) == OK);
            if (!with) K = matrix_copy(body->K);
        }
        sum_up(body, &fibres, u, kinds[c], &want);
        close_to(energy[1] - energy[0], want.energy, 1e-10);
        for (int r = 0; r < N_DOF; r++) {
            close_to(q[1][r] - q[0][r], dt * dt * want.force[r], 1e-10);
            for (int z = 0; z < N_DOF; z++) {
                const int i = body->equation[r], j = body->equation[z];
                if (i < 0 || j < 0) continue;
                close_to(matrix_get(body->K, i, j) - matrix_get(K, i, j),
                         dt * dt * want.stiff[r][z], 1e-9);
            }
        }
        matrix_free(K);
    }
    body_free(body);
    mesh_free(mesh);
}

/* A rotation turns fibres by its angle and stretches none. */
static void a_bent_field_turns_with_the_body(void)
{
    struct mesh *mesh = mesh_square(N);
    int held[16] = {1};
    double u[N_DOF], now;
    double *angle = fibres_bent(mesh, 10.0, -45.0);
    const struct fibres fibres = {muscle, angle};
    struct body *body = body_alloc(mesh, material_notes(CUBIC), 0.0,
                                   CONSISTENT, held);
    const mat2 Q = mat2_rotation(0.37);
    for (int r = 0; r < N_DOF; r++)
        u[r] = Q.m[r % 2][0] * mesh->X[r / 2 * 2] +
               Q.m[r % 2][1] * mesh->X[r / 2 * 2 + 1] - mesh->X[r];
    /* the first triangle has the corners X1 = -1, -1/3, -1/3 */
    close_to(angle[0], (10.0 + 45.0 * 5.0 / 9.0) * acos(-1.0) / 180.0, 1e-13);
    for (int e = 0; e < N_TRIANGLE; e++) {
        close_to(fibres_stretch(body, &fibres, u, e, &now), 1.0, 1e-13);
        close_to(now, angle[e] + 0.37, 1e-13);
    }
    free(angle);
    body_free(body);
    mesh_free(mesh);
}

UNIT_MAIN("fibre",
    LAW(the_muscle_has_its_limbs),
    LAW(tension_is_the_slope_of_its_energy),
    LAW(stress_and_tangent_are_slopes),
    LAW(projection_clamps_two_eigenvalues),
    LAW(a_fibre_without_length_does_nothing),
    LAW(a_body_gets_energy_force_and_stiffness),
    LAW(a_bent_field_turns_with_the_body))
