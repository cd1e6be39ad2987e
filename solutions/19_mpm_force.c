/*
 * 19_mpm_force.c - what the particles of an elastic body do to their grid.
 *
 * Notes: the material point method, weak form to the semi-discrete equations.
 *
 * Problem.  Node a moves by u_a.  Each particle then has the gradient F_hat of
 * the motion since t^n, and F = F_hat F_n of all of it [eq:pull-back].  The
 * particles' energy sum V_p psi(F) [eq:particle-energy] gives the nodes forces
 * [eq:particle-force], and these a tangent [eq:particle-tangent].  V_p is the
 * volume at t = 0.
 *
 *     o -- o -- o -- o     component k of node a is u[2a + k], as in f, w; the
 *     |  . |    |.   |     nodes that particle p reaches and grad N_a there are
 *     o -- o -- o -- o     node[i] and gradient[i] of a struct support
 *     |    | .  |  . |     (particles.h)
 * Run       make lesson-19; make lesson-19 ARGS=-h lists its options
 * PREDICT 2a largest force on an inner node over stress, 8 cells, linear: ...
 * PREDICT 2b and with 64 cells: ...
 * PREDICT 3 and one step from rest: ...
 * Plot: taylor t force logx logy
 */
#include "base/options.h"
#include "particles/particle_force.h"
#include "particles/particle_scene.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

/* A particle whose nodes have moved. */
struct moved {
    struct support s;
    mat2 F_hat, F_n, F; /* F_n is its own, as at t^n */
};

/* Given the nodes at x + u, fill in *m for particle p.  Return the status of
 * grid_support(); NONFINITE; INVERTED: the material is not defined at F. */
static enum status move(const struct particle_body *body, int p,
                        const double u[], struct moved *m)
{
    const struct particles *all = body->particles;
    const enum status status = grid_support(body->grid, &all->x[2 * p], &m->s);
    if (status != OK) return status;
    m->F_n = m->F_hat = m->F = all->F[p];
    /* SLOT 19a(u, m): F_hat and F from u, F_n, and the m->s.n nodes of m->s. */
    /* F_hat = I + sum_a u_a grad N_a^T, where grad N_a is that of t^n */
    m->F_hat = mat2_identity();
    for (int i = 0; i < m->s.n; i++)
        for (int k = 0; k < 2; k++)
            for (int l = 0; l < 2; l++)
                m->F_hat.m[k][l] +=
                    u[2 * m->s.node[i] + k] * m->s.gradient[i][l];
    m->F = mat2_multiply(m->F_hat, m->F_n);
    /* END 19a */
    const double J = mat2_det(m->F);
    if (!isfinite(J)) return NONFINITE;
    return material_defined(&body->material, J) ? OK : INVERTED;
}

/* Given u, fill in the forces f on all nodes at x + u; statuses of move(). */
static enum status force(const struct particle_body *body, const double u[],
                         double f[])
{
    struct moved m;
    for (int r = 0; r < 2 * body->grid->n_node; r++) f[r] = 0.0;
    for (int p = 0; p < body->particles->n; p++) {
        const enum status status = move(body, p, u, &m);
        if (status != OK) return status;
        const double volume = body->particles->volume[p];
        /* SLOT 19b(body, volume, &m, f): what this particle adds to f, with
         * its stress material2_pk1(&body->material, m.F). */
        const mat2 P = material2_pk1(&body->material, m.F);
        /* f_a = -V P F_n^T grad N_a, as P is per area at t = 0 */
        const mat2 pull = mat2_multiply(P, mat2_transpose(m.F_n));
        for (int i = 0; i < m.s.n; i++)
            for (int k = 0; k < 2; k++)
                for (int l = 0; l < 2; l++)
                    f[2 * m.s.node[i] + k] -=
                        volume * pull.m[k][l] * m.s.gradient[i][l];
        /* END 19b */
    }
    return OK;
}

/* Given u and w, fill in out = K w, K = -df/du at x + u; statuses of move(). */
static enum status product(const struct particle_body *body, const double u[],
                           const double w[], double out[])
{
    struct moved m;
    for (int r = 0; r < 2 * body->grid->n_node; r++) out[r] = 0.0;
    for (int p = 0; p < body->particles->n; p++) {
        const enum status status = move(body, p, u, &m);
        if (status != OK) return status;
        const double volume = body->particles->volume[p];
        /* SLOT 19c(body, volume, &m, w, out): dF, its dP by material2_dpk1(),
         * and 19b once more. */
        /* Only F_hat depends on u: dF = (sum_a w_a grad N_a^T) F_n. */
        const mat2 dF = mat2_multiply(support_gradient(&m.s, w), m.F_n);
        const mat2 dP = material2_dpk1(&body->material, m.F, dF);
        const mat2 pull = mat2_multiply(dP, mat2_transpose(m.F_n));
        for (int i = 0; i < m.s.n; i++)
            for (int k = 0; k < 2; k++)
                for (int l = 0; l < 2; l++)
                    out[2 * m.s.node[i] + k] +=
                        volume * pull.m[k][l] * m.s.gradient[i][l];
        /* END 19c */
    }
    return OK;
}

static void check(enum status status)
{
    if (status != OK)
        die("the displaced particles are %s", status_name(status));
}

/* Errors of energy and force after one term of Taylor's series. */
static void print_taylor(const struct particle_body *body, const double u[],
                         const double f[])
{
    const int n = 2 * body->grid->n_node;
    double *w = allocate((size_t)n, sizeof *w);
    double *Kw = allocate((size_t)n, sizeof *Kw);
    struct taylor error, old = {0.0, 0.0};
    grid_shake(body->grid, 0.35 * body->grid->h, Kw);
    for (int r = 0; r < n; r++) w[r] = Kw[n - 1 - r];
    check(product(body, u, w, Kw));
    table_begin("taylor", "t energy force energy_order force_order");
    for (double t = 0.25; t > 0.002; t /= 2.0, old = error) {
        check(particle_taylor(body, u, w, t, f, Kw, &error));
        table_row(t, error.energy, error.force,
                  cell_if(t < 0.25, log2(old.energy / error.energy)),
                  cell_if(t < 0.25, log2(old.force / error.force)));
    }
    table_end();
    free(Kw);
    free(w);
}

/* Seven particles that are strained already, on a grid that is shaken. */
static void print_seven(int order, struct material material, double shake)
{
    struct cloud seven = cloud_seven(order, PIC);
    const struct particle_body body = {seven.grid, seven.p, material, NULL};
    const int n = 2 * seven.grid->n_node;
    const double h = seven.grid->h;
    double *u = allocate((size_t)n, sizeof *u);
    double *f = allocate((size_t)n, sizeof *f);
    double *cauchy = allocate((size_t)n, sizeof *cauchy);
    double *quotient = allocate((size_t)n, sizeof *quotient);
    grid_shake(seven.grid, shake * h, u);
    check(grid_p2g(seven.grid, seven.p));
    check(force(&body, u, f));
    check(particle_cauchy_force(&body, u, cauchy));
    check(particle_difference_force(&body, u, 1e-5 * h, quotient));
    table_begin("force", "node component force cauchy quotient");
    for (int a = 0; a < seven.grid->n_node; a++)
        for (int k = 0, r = 2 * a; k < 2; k++, r++)
            if (seven.grid->mass[a] > 0.0)
                table_row(a, k, f[r], cauchy[r], quotient[r]);
    table_end();
    table_begin("balance", "form force_x force_y torque torque_undisplaced");
    for (int k = 0; k < 2; k++) {
        const double *of = k ? cauchy : f;
        const struct balance sum = grid_balance(seven.grid, u, of);
        table_row(k ? "cauchy" : "force", sum.force[0], sum.force[1],
                  sum.torque, grid_balance(seven.grid, NULL, of).torque);
    }
    table_end();
    print_taylor(&body, u, f);
    free(quotient);
    free(cauchy);
    free(f);
    free(u);
    cloud_free(seven);
}

/* A bar under the stress of the stretch F.  Its particles are where that takes
 * them, F_n = F; or, from_rest, where they were, F_n = I, and the nodes move.
 */
static void print_bar(const char *name, struct material material, double F,
                      int ppc, double shift, int from_rest)
{
    static const char *const kernel[] = {"linear", "quadratic", "cubic"};
    const double stress = material1_pk1(&material, F), old = from_rest ? 1 : F;
    table_begin(name, "cells ppc kernel force_over_stress acceleration");
    for (int order = 1; order <= 3; order++)
        for (int cells = 8; cells <= 64; cells *= 2) {
            struct cloud bar = cloud_bar(order, cells, ppc, old, shift);
            const struct particle_body body = {bar.grid, bar.p, material, NULL};
            const size_t n_dof = 2 * (size_t)bar.grid->n_node;
            double *u = allocate(n_dof, sizeof *u);
            double *f = allocate(n_dof, sizeof *f);
            for (int a = 0; a < bar.grid->n_node; a++)
                u[2 * a] = (F / old - 1.0) * (a - 2) / cells;
            check(force(&body, u, f));
            const struct inner worst = cloud_bar_inner(bar, f);
            table_row(cells, ppc, kernel[order - 1],
                      cell_if(fabs(stress) > 0.0, worst.force / fabs(stress)),
                      worst.acceleration);
            free(f);
            free(u);
            cloud_free(bar);
        }
    table_end();
}

int main(int argc, char *argv[])
{
    int order = 2, law = 1, ppc = 2;
    double nu = 0.3, shake = 0.35, stretch = 1.385, shift = 0.0137;
    const struct option options[] = {
        {"order", .integer = &order, .min = 1, .max = 3, .help = "of kernels"},
        {"law", .choice = &law, .choices = "log cubic", .help = "material"},
        {"nu", .real = &nu, .max = 0.4999, .help = "Poisson's ratio"},
        {"shake", .real = &shake, .max = 4, .unit = "cells", .help = "nodes"},
        {"stretch", .real = &stretch, .min = 0.7, .max = 3, .help = "of bars"},
        {"ppc", .integer = &ppc, .min = 1, .max = 64, .help = "of bars"},
        {"shift", .real = &shift, .max = 1, .unit = "cells", .help = "of bars"},
    };
    options_parse("19_mpm_force", options, COUNT(options), argc, argv);
    const struct material material =
        material_make(law ? CUBIC : LOG, 1000.0, nu);
    print_seven(order, material, shake);
    print_bar("crossing", material, stretch, ppc, shift, 0);
    print_bar("rest", material, stretch, ppc, shift, 1);
    return table_finish();
}
