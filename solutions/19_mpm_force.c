/*
 * 19_mpm_force.c - what the particles of an elastic body do to their grid.
 *
 * Notes: the material point method, weak form to the semi-discrete equations.
 *
 * Problem.  Node a moves by u_a.  Each particle has then the gradients F_hat,
 * since t^n, and F = F_hat F_p, since ever [eq:pull-back]; their energy sum V_p
 * psi(F) [eq:particle-energy] gives the nodes forces [eq:particle-force], and
 * these a tangent [eq:particle-tangent].  V_p is the volume at t = 0.
 *
 *     o -- o -- o -- o     component k of node a is u[2a + k], as in f, w; the
 *     |  . |    |.   |     nodes that particle p reaches and grad N_a there are
 *     o -- o -- o -- o     node[i] and gradient[i] of a struct support
 *     |    | .  |  . |     (particles.h)
 * Run       make lesson-19, or with options: -h lists them
 * Expect    seven particles: torque 0, and 2.816223533 about the old places
 * Plot: taylor t force
 */
#include "options.h"
#include "particle_force.h"
#include "particle_scene.h"
#include "table.h"

#include <math.h>
#include <stdlib.h>

/* A particle whose nodes have moved. */
struct moved {
    struct support s;
    mat2 F_n, F_hat, F; /* F_n is its own, as at t^n */
};
static enum status move(const struct particle_body *body, int p,
                        const double u[], struct moved *m);
static enum status force(const struct particle_body *body, const double u[],
                         double f[]);
static enum status product(const struct particle_body *body, const double u[],
                           const double w[], double out[]);

static void check(enum status status)
{
    if (status != OK)
        die("the displaced particles are %s", status_name(status));
}

static double energy(const struct particle_body *body, const double u[])
{
    double sum = 0.0;
    struct moved m;
    for (int p = 0; p < body->particles->n; p++) {
        check(move(body, p, u, &m));
        sum += body->particles->volume[p] * material2_psi(&body->material, m.F);
    }
    return sum;
}

/* The other form: sigma, volumes now, and the gradients of the nodes where they
 * are now, F_hat^-T grad N. */
static void cauchy_force(const struct particle_body *body, const double u[],
                         double f[])
{
    struct moved m;
    for (int r = 0; r < 2 * body->grid->n_node; r++) f[r] = 0.0;
    for (int p = 0; p < body->particles->n; p++) {
        check(move(body, p, u, &m));
        const double J = mat2_det(m.F), now = J * body->particles->volume[p];
        const mat2 P = material2_pk1(&body->material, m.F);
        const mat2 sigma =
            mat2_scale(1.0 / J, mat2_multiply(P, mat2_transpose(m.F)));
        const mat2 push =
            mat2_scale(now / mat2_det(m.F_hat),
                       mat2_multiply(sigma, mat2_cofactor(m.F_hat)));
        for (int i = 0; i < m.s.n; i++)
            for (int r = 0; r < 4; r++)
                f[2 * m.s.node[i] + r / 2] -=
                    push.m[r / 2][r % 2] * m.s.gradient[i][r % 2];
    }
}

static double dot(int n, const double a[], const double b[])
{
    double sum = 0.0;
    for (int r = 0; r < n; r++) sum += a[r] * b[r];
    return sum;
}

/* What forces on the nodes do to the body as a whole. */
static void print_balance(const struct grid *grid, const double u[],
                          const char *form, const double f[])
{
    double sum[2] = {0.0, 0.0}, before = 0.0, now = 0.0;
    for (int a = 0; a < grid->n_node; a++) {
        double x[2];
        grid_place(grid, a, x);
        for (int k = 0; k < 2; k++) sum[k] += f[2 * a + k];
        before += x[0] * f[2 * a + 1] - x[1] * f[2 * a];
        now +=
            (x[0] + u[2 * a]) * f[2 * a + 1] - (x[1] + u[2 * a + 1]) * f[2 * a];
    }
    table_row(form, sum[0], sum[1], now, before);
}

/* What is left over of energy and force after one term of Taylor's series. */
static void print_taylor(const struct particle_body *body, const double u[],
                         const double f[])
{
    const int n = 2 * body->grid->n_node;
    double *w = allocate(4 * (size_t)n, sizeof *w), before[2] = {0.0, 0.0};
    double *Kw = w + n, *at = Kw + n, *g = at + n;
    const double E = energy(body, u);
    for (int r = 0; r < n; r++) w[r] = u[n - 1 - r];
    check(product(body, u, w, Kw));
    table_begin("taylor", "t energy force energy_order force_order");
    for (double t = 0.25; t > 0.002; t /= 2.0) {
        double rest[2] = {0.0, 0.0}, order[2];
        for (int r = 0; r < n; r++) at[r] = u[r] + t * w[r];
        check(force(body, at, g));
        rest[0] = fabs(energy(body, at) - E + t * dot(n, f, w));
        for (int r = 0; r < n; r++)
            rest[1] = fmax(rest[1], fabs(g[r] - f[r] + t * Kw[r]));
        for (int k = 0; k < 2; k++) order[k] = log2(before[k] / rest[k]);
        table_row(t, rest[0], rest[1], cell_if(before[0] > 0.0, order[0]),
                  cell_if(before[1] > 0.0, order[1]));
        for (int k = 0; k < 2; k++) before[k] = rest[k];
    }
    table_end();
    free(w);
}

/* Seven particles that are strained already, on a grid that is shaken. */
static void print_seven(int order, struct material material, double shake)
{
    const double h = 0.385, low[2] = {-2.0 * h, -2.0 * h}, step = 1e-5 * h;
    struct grid *grid = grid_alloc(order, low, h, (int[]){11, 11});
    struct particles *seven = particles_seven(NULL);
    const struct particle_body body = {grid, seven, material, NULL};
    const int n = 2 * grid->n_node;
    double *u = allocate(3 * (size_t)n, sizeof *u), *f = u + n, *g = f + n;
    grid_shake(grid, shake * h, u);
    check(grid_p2g(grid, seven));
    check(force(&body, u, f));
    cauchy_force(&body, u, g);
    table_begin("force", "node component force cauchy quotient");
    for (int r = 0; r < n; r++) {
        const double old = u[r];
        if (!(grid->mass[r / 2] > 0.0)) continue;
        u[r] = old + step;
        const double more = energy(&body, u);
        u[r] = old - step;
        const double less = energy(&body, u);
        u[r] = old;
        table_row(r / 2, r % 2, f[r], g[r], (less - more) / (2.0 * step));
    }
    table_end();
    table_begin("balance", "form force_x force_y torque torque_undisplaced");
    print_balance(grid, u, "force", f);
    print_balance(grid, u, "cauchy", g);
    table_end();
    print_taylor(&body, u, f);
    free(u);
    particles_free(seven);
    grid_free(grid);
}

/*
 * A bar of length 1 and density 1 under one stress, that of the stretch F: the
 * particles are where it takes them and F_n is F; or, from_rest, they are where
 * they were, F_n = I, and the nodes move.  No node should feel a force that is
 * two cells or more away from both ends.
 */
static void print_bar(const char *name, struct material material, double F,
                      int ppc, double shift, int from_rest)
{
    static const char *const kernel[] = {"linear", "quadratic", "cubic"};
    const double stress = material1_pk1(&material, F), old = from_rest ? 1 : F;
    table_begin(name, "cells ppc kernel force_over_stress acceleration");
    for (int row = 0; row < 12; row++) {
        const int order = 1 + row / 4, cells = 8 << row % 4;
        const double h = 1.0 / cells, low[2] = {-2.0 * h, -0.5};
        const int nodes[2] = {(int)(old * cells) + 7, 1};
        struct grid *grid = grid_alloc(order, low, h, nodes);
        struct particles *bar =
            particles_box((double[]){0.0, -0.5}, (double[]){1.0, 0.5},
                          (int[]){cells * ppc, 1}, 1.0);
        const struct particle_body body = {grid, bar, material, NULL};
        double *u = allocate(4 * (size_t)nodes[0], sizeof *u), worst = 0.0;
        double *f = u + 2 * nodes[0], acceleration = 0.0;
        for (int p = 0; p < bar->n; p++) {
            bar->x[2 * p] = old * bar->x[2 * p] + shift * h;
            bar->F[p].m[0][0] = old;
        }
        for (int a = 0; a < nodes[0]; a++)
            u[2 * a] = (F / old - 1.0) * (low[0] + h * a);
        check(grid_p2g(grid, bar));
        check(force(&body, u, f));
        for (int a = 0; a < nodes[0]; a++) {
            const double from_end = low[0] + h * a - shift * h;
            if (from_end < 2.0 * h || from_end > old - 2.0 * h) continue;
            worst = fmax(worst, fabs(f[2 * a]));
            acceleration = fmax(acceleration, fabs(f[2 * a]) / grid->mass[a]);
        }
        table_row(cells, ppc, kernel[order - 1],
                  cell_if(F != 1.0, worst / fabs(stress)), acceleration);
        free(u);
        particles_free(bar);
        grid_free(grid);
    }
    table_end();
}

/* Particle p while the nodes are at x + u.  Statuses of grid_support();
 * NONFINITE; INVERTED: the material is not defined at F. */
static enum status move(const struct particle_body *body, int p,
                        const double u[], struct moved *m)
{
    const struct particles *all = body->particles;
    const enum status status = grid_support(body->grid, &all->x[2 * p], &m->s);
    if (status != OK) return status;
    m->F_n = m->F_hat = m->F = all->F[p];
    /* SLOT 19a(u, m): F_hat and F from u, F_n, and the m->s.n nodes of m->s. */
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

/* The forces f on all nodes at x + u; statuses of move(). */
static enum status force(const struct particle_body *body, const double u[],
                         double f[])
{
    struct moved m;
    for (int r = 0; r < 2 * body->grid->n_node; r++) f[r] = 0.0;
    for (int p = 0; p < body->particles->n; p++) {
        const enum status status = move(body, p, u, &m);
        if (status != OK) return status;
        const double volume = body->particles->volume[p];
        /* SLOT 19b(body, volume, &m, f): what this particle adds to f. */
        const mat2 P = material2_pk1(&body->material, m.F);
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

/* out := K w for the tangent K = -df/du at x + u; statuses of move(). */
static enum status product(const struct particle_body *body, const double u[],
                           const double w[], double out[])
{
    struct moved m;
    for (int r = 0; r < 2 * body->grid->n_node; r++) out[r] = 0.0;
    for (int p = 0; p < body->particles->n; p++) {
        const enum status status = move(body, p, u, &m);
        if (status != OK) return status;
        const double volume = body->particles->volume[p];
        /* SLOT 19c(body, volume, &m, w, out): dF, dP, and 19b once more. */
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
