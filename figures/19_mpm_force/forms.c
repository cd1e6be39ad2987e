/*
 * forms.c - one force, written in two ways that agree and in four that do not;
 * and how one particle hands its stress to nine nodes.
 *
 * All are -V A grad N per particle and node.  Right is A = P F_n^T, which is
 * the slope of the energy, and J sigma F_hat^-T.
 */
#include "particles/particle_force.h"
#include "particles/particle_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum form { RIGHT, NO_F_N, ONE_F, OLD_STRESS, OLD_VOLUME, N_FORM };
enum { ONE = 1, DOF = 2 * 11 * 11 };
static const char *const FORM[] = {"right", "no F_n", "one F",
                                   "old P", "old V"};

static mat2 handed_out(enum form form, const struct material *law,
                       mat2 F_n, mat2 F)
{
    const mat2 P = material2_pk1(law, form == OLD_STRESS ? F_n : F);
    const mat2 back = mat2_transpose(form == ONE_F ? F : F_n);
    if (form == NO_F_N) return P;
    return mat2_scale(form == OLD_VOLUME ? mat2_det(F_n) : 1.0,
                      mat2_multiply(P, back));
}

/* What the particles from `first` to `last` add to f. */
static void add_forces(const struct particle_body *body, enum form form,
                       const double u[], int first, int last, double f[])
{
    for (int p = first; p <= last; p++) {
        struct support s;
        grid_support(body->grid, &body->particles->x[2 * p], &s);
        const mat2 F_n = body->particles->F[p];
        const double V = body->particles->volume[p];
        const mat2 hat = mat2_add(mat2_identity(), support_gradient(&s, u));
        const mat2 F = mat2_multiply(hat, F_n);
        const mat2 A = handed_out(form, &body->material, F_n, F);
        for (int i = 0; i < s.n; i++)
            for (int k = 0; k < 2; k++)
                for (int l = 0; l < 2; l++)
                    f[2 * s.node[i] + k] -=
                        V * A.m[k][l] * s.gradient[i][l];
    }
}

static double apart(const double a[], const double b[])
{
    double most = 0.0, size = 0.0;
    for (int r = 0; r < DOF; r++) most = fmax(most, fabs(a[r] - b[r]));
    for (int r = 0; r < DOF; r++) size = fmax(size, fabs(b[r]));
    return most / size;
}

static void compare(int order)
{
    struct cloud c = cloud_seven(order, PIC);
    const struct material law = material_notes(CUBIC);
    const struct particle_body body = {c.grid, c.p, law, NULL};
    double u[DOF], right[DOF], other[DOF], slope[DOF], f[DOF];
    grid_shake(c.grid, 0.35 * c.grid->h, u);
    claim(particle_force(&body, u, right) == OK, "nothing is inverted");
    particle_cauchy_force(&body, u, other);
    claim(apart(other, right) < 1e-13, "Cauchy's form agrees");
    claim(particle_difference_force(&body, u, 1e-5 * c.grid->h, slope) == OK &&
              apart(slope, right) < 1e-8,
          "so does the slope of the energy (%g)", apart(slope, right));
    for (int form = 0; form < N_FORM; form++) {
        for (int r = 0; r < DOF; r++) f[r] = 0.0;
        add_forces(&body, (enum form)form, u, 0, c.p->n - 1, f);
        const double error = apart(f, right);
        const double torque = fabs(grid_balance(c.grid, u, f).torque);
        table_row(FORM[form], order, error, torque);
        claim(form == RIGHT ? error < 1e-13 : error > 0.07, "wrong are wrong");
        claim(form == RIGHT ||
                  (apart(f, other) > 0.07 && apart(f, slope) > 0.07),
              "each comparison finds all four");
        claim((torque < 1e-12) == (form == RIGHT || form == OLD_VOLUME),
              "with wrong volumes forces balance");
    }
    cloud_free(c);
}

/* Particle ONE, the places of its nodes, and what it does to them. */
static void hand_out(void)
{
    struct cloud c = cloud_seven(2, PIC);
    const struct material law = material_notes(CUBIC);
    const struct particle_body body = {c.grid, c.p, law, NULL};
    double u[DOF], f[DOF] = {0.0}, x[2], half = 0.5 * sqrt(c.p->volume[ONE]);
    struct support s;
    grid_shake(c.grid, 0.35 * c.grid->h, u);
    add_forces(&body, RIGHT, u, ONE, ONE, f);
    grid_support(c.grid, &c.p->x[2 * ONE], &s);
    table_begin("nodes", "x y f_x f_y");
    for (int i = 0; i < s.n; i++) {
        const int r = 2 * s.node[i];
        grid_place(c.grid, s.node[i], x);
        table_row(x[0] + u[r], x[1] + u[r + 1], f[r], f[r + 1]);
    }
    table_end();
    support_pull_back(&s, c.p->F[ONE]);
    const mat2 F = mat2_add(c.p->F[ONE], support_gradient(&s, u));
    support_value(&s, u, x);
    for (int k = 0; k < 2; k++) x[k] += c.p->x[2 * ONE + k];
    table_begin("particle", "x y");
    for (int k = 0; k <= 4; k++) { /* its square, around */
        const double X = k == 1 || k == 2 ? half : -half;
        const double Y = k == 2 || k == 3 ? half : -half;
        table_row(x[0] + F.m[0][0] * X + F.m[0][1] * Y,
                  x[1] + F.m[1][0] * X + F.m[1][1] * Y);
    }
    table_end();
    cloud_free(c);
}

int main(void)
{
    table_begin("forms", "form order error torque");
    for (int order = 1; order <= ORDER_MAX; order++) compare(order);
    table_end();
    hand_out();
    return table_finish();
}
