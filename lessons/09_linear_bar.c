/*
 * 09_linear_bar.c - a linear bar: its modulus, its end loads, what holds it.
 *
 * Notes: Lecture 1, 1D Elasticity; Lecture 2, (2.12b), for the end loads.
 *
 * Problem.  -P' = f on (0, 1), P = modulus u'.  Each end is held, u = g given,
 * or free, and then pulled by the traction t = P n, n the outward normal:
 *
 *        n = -1                                      n = +1
 *     t  <---|=========================================|--->  t
 *            0        body force f (N/m^3) -->         1
 *
 * A positive t or f pushes towards +X.  Linear elements on n equal lengths;
 * unit cross-section, so that stresses are forces.
 *
 * Run       make lesson-09; make lesson-09 ARGS=-h lists its options
 * PREDICT 1 the printed modulus at nu = 0.33 is too soft by the factor: ...
 * PREDICT 2 strain in tension at which linear is 5 % off the log law: ...
 * PREDICT 3 linear solves for the end of a bar with c = 100, to 1 %: ...
 * Plot: nodes X u
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "base/table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* struct bar_scene of bar_scene.h has n elements and, of each end (0 left, 1
 * right): held[], g[] (u of a held end), pull[] (traction t of a free end). */

struct elastic {
    double mu, lambda; /* Lame parameters, N/m^2 */
    double modulus;    /* P / u' of a bar that cannot move sideways, N/m^2 */
};

/* Given Young's modulus E and Poisson's ratio nu [eq:lame], return all of m. */
static struct elastic elastic_make(double E, double nu)
{
    struct elastic m = {0};
    /* SLOT 9a(E, nu, m): given E and nu, fill m.mu, m.lambda and m.modulus. */
    todo("9a", E, nu, m);
    /* END 9a */
    return m;
}

/*
 * Given f at the middles, return matrix and loads before any node is held:
 *
 *     K_ij = modulus int N_i' N_j' dX,   b from f, and from t where it is given
 *
 * f_mid    in    f at the middle of element e = 0..n-1, for the midpoint rule
 * K, b     out   order n + 1, half bandwidth 1
 */
static void assemble(const struct bar_scene *s, double modulus,
                     const double f_mid[], struct matrix *K, double b[])
{
    matrix_zero(K);
    for (int i = 0; i <= s->n; i++) b[i] = 0.0;
    /* SLOT 9b(s, modulus, f_mid, K, b): given f_mid, add each element, between
     * nodes e and e + 1, to K and b, then the tractions of free ends to b. */
    todo("9b", s, modulus, f_mid, K, b);
    /* END 9b */
}

/*
 * Given K and b, return u with the held ends at their values, and a status; K
 * and b are left alone.  With no end held u is known up to a constant: return
 * the solution with u_0 = 0.
 *
 * OK            u is the solution
 * INCOMPATIBLE  no end is held and |sum b| > (n + 1) eps sum |b|: nothing
 *               holds the bar, and its loads do not balance; u stays as it is
 * NOT_SPD       the modulus is not positive; u stays as it is
 */
static enum status solve(const struct bar_scene *s, const struct matrix *K,
                         const double b[], double u[])
{
    /* SLOT 9c(s, K, b, u): given K and b, collect the held ends; with none of
     * them check the balance of b and hold node 0 at 0.  Then matrix_copy,
     * matrix_dirichlet, matrix_factor, matrix_solve, matrix_free. */
    todo("9c", s, K, b, u);
    /* END 9c */
}

/*
 * Given the loads b and the displacements u, return the forces.
 *
 * P         out  P[e - 1] = modulus u' on element e = 1..n
 * reaction  out  the force on a held end, K u - b there [eq:reaction], else 0
 */
static void stress_and_reactions(const struct bar_scene *s, double modulus,
                                 const double b[], const double u[],
                                 double P[], double reaction[2])
{
    /* SLOT 9d(s, modulus, b, u, P, reaction): given u and b, set P first; the
     * first and the last row of K u are made of two of its entries. */
    todo("9d", s, modulus, b, u, P, reaction);
    /* END 9d */
}

static struct bar_scene scene_of_options(int argc, char *argv[], double *nu)
{
    struct bar_scene s = {.n = 8, .c = 100.0};
    int held[2] = {1, 0}, shape = UNIFORM;
    double end[2] = {0.0, 100.0};
    const struct option options[] = {
        {"n", .integer = &s.n, .min = 1, .max = 20000, .help = "elements"},
        {"nu", .real = nu, .min = 0.0, .max = 0.4999,
         .help = "Poisson's ratio", .why = "at 1/2 lambda is infinite"},
        {"left", .choice = &held[0], .choices = "free held",
         .help = "condition at X = 0"},
        {"right", .choice = &held[1], .choices = "free held",
         .help = "condition at X = 1"},
        {"at_left", .real = &end[0], .min = -1e9, .max = 1e9,
         .help = "traction (N/m^2) of a free, u (m) of a held left end"},
        {"at_right", .real = &end[1], .min = -1e9, .max = 1e9,
         .help = "the same at the right end"},
        {"body", .choice = &shape, .choices = "uniform cosine",
         .help = "f = c, or c cos(pi X / 2)"},
        {"c", .real = &s.c, .min = -1e9, .max = 1e9, .unit = "N/m^3",
         .help = "size of the body force"},
    };
    options_parse("09_linear_bar", options, COUNT(options), argc, argv);
    s.material = material_make(LINEAR, 1000.0, *nu);
    s.shape = (enum shape)shape;
    bar_scene_ends(&s, held[0], held[1], end);
    return s;
}

/* The tables; without a solution (solved = 0) only the loads are there. */
static void print_bar(const struct bar_scene *s, const double b[], int solved,
                      const double u[], const double P[],
                      const double reaction[2])
{
    double sum = 0.0, P_exact;
    table_begin("nodes", "X b u exact");
    for (int i = 0; i <= s->n; i++) {
        const double X = (double)i / s->n;
        const double u_exact = bar_scene_exact(s, X, &P_exact);
        table_row(X, b[i], cell_if(solved, u[i]), cell_if(solved, u_exact));
        sum += b[i];
    }
    table_end();
    table_begin("elements", "X P exact");
    for (int e = 1; e <= s->n; e++) {
        const double X = (e - 0.5) / s->n;
        bar_scene_exact(s, X, &P_exact);
        table_row(X, cell_if(solved, P[e - 1]), cell_if(solved, P_exact));
    }
    table_end();
    table_begin("balance", "loads reaction_left reaction_right");
    table_row(sum, cell_if(solved, reaction[0]), cell_if(solved, reaction[1]));
    table_end();
}

int main(int argc, char *argv[])
{
    double nu = 0.3, reaction[2] = {0.0, 0.0};
    const struct bar_scene s = scene_of_options(argc, argv, &nu);
    const size_t size = (size_t)s.n + 1;
    struct matrix *K = matrix_alloc(BANDED, s.n + 1, 1);
    double *b = allocate(size, sizeof *b), *u = allocate(size, sizeof *u);
    double *P = allocate(size, sizeof *P);
    double *f_mid = allocate(size, sizeof *f_mid);

    bar_scene_force(&s, f_mid);
    const struct elastic m = elastic_make(1000.0, nu);
    assemble(&s, m.modulus, f_mid, K, b);
    const enum status status = solve(&s, K, b, u);
    if (status == OK) stress_and_reactions(&s, m.modulus, b, u, P, reaction);
    print_bar(&s, b, status == OK, u, P, reaction);
    if (status != OK) die("%s: the bar has no solution", status_name(status));
    matrix_free(K);
    free(b);
    free(u);
    free(P);
    free(f_mid);
    return table_finish();
}
