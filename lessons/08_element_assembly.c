/*
 * 08_element_assembly.c - assemble A u = b element by element, and measure what
 * an answer costs with dense and with banded storage.
 *
 * Notes: Lecture 2, section 1.1, exercise (6).
 *
 * Problem.  The boundary value problem of lesson 07 [eq:poisson-bvp], but A and
 * b are filled by a loop over elements [alg:element-assembly].  Element e joins
 * nodes e and e + 1 and adds four numbers to A and two to b, whatever its
 * place: no entry is special at the ends, and any order of elements will do.
 *
 *     | K00 K01  .   . |   element 0     | r0     |
 *     | K10 K11+K00 K01|   elements 0, 1 | r1+r0  |   (superscripts left out:
 *     |  .  K10 K11+.. |   ...           | r1+..  |    each from its element)
 *
 * Run       make lesson-08; make lesson-08 ARGS=-h lists its options
 * PREDICT 1 by how many eps A changes with --order reversed: ...
 * PREDICT 2a flops of 256 elements in dense storage: ...
 * PREDICT 2b and in banded storage: ...
 * Plot: nodes x u
 */
#include "base/clock.h"
#include "linear/matrix.h"
#include "base/options.h"
#include "bar/poisson.h"
#include "linear/residual.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * Stiffness and load of the element (x0, x1), its nodes 0 and 1, by a
 * quadrature rule [eq:poisson-local] [eq:quadrature]:
 *
 *     K[a][c] = int beta e_a' e_c' dx,   r[a] = int f e_a dx,   a, c = 0, 1.
 *
 * At x0 + s h the hats are e_0 = 1 - s and e_1 = s; their slopes are -+ 1/h.
 *
 * rule   in   n points s[k] and weights w[k] on (0, 1)
 * K, r   out  all entries are set
 */
static void element(double x0, double x1, field *beta, field *f,
                    const struct quadrature *rule, double K[2][2],
                    double r[2])
{
    /* SLOT 8a(x0, x1, beta, f, rule, K, r): given the element, set the four
     * entries of K and the two of r [eq:poisson-local], integrals over it. */
    todo("8a", x0, x1, beta, f, rule, K, r);
    /* END 8a */
}

/*
 * A and b of all elements, no boundary condition yet [alg:element-assembly]:
 * eight parameters, a problem, a mesh and a rule in, a system out.
 *
 * x      in   nodes x[0..n]
 * order  in   the elements 0..n-1 in the order in which to visit them
 * A      out  order n + 1, dense or banded; whatever it held is forgotten
 * b      out  b[0..n]
 */
static void assemble(int n, const double x[], field *beta, field *f,
                     const struct quadrature *rule, const int order[],
                     struct matrix *A, double b[])
{
    /* SLOT 8b(n, x, beta, f, rule, order, A, b, element): given the nodes,
     * start from zero; visit the elements in the given order and add what each
     * contributes to A (with matrix_add) and to b. */
    todo("8b", n, x, beta, f, rule, order, A, b, element);
    /* END 8b */
}

/*
 * Flops (additions, multiplications, divisions, square roots, one each) of the
 * textbook factorisation A = L L^T and the two triangular solves
 * [eq:cholesky-flops], order N, half bandwidth p; dense is p = N - 1.  A double
 * holds these integers exactly (they stay below 2^53).
 */
static double cholesky_flops(int N, int p)
{
    /* SLOT 8c(N, p): given N and p, return the exact count, not the leading
     * order: column k of L has m entries below the diagonal. */
    todo("8c", N, p);
    /* END 8c */
}

/* A run is valid when its u solves a system that differs from A u = b by at
 * most this many eps, which Cholesky's method achieves whatever kappa is. */
static const double BACKWARD_EPS = 20.0;

/* One run of factor + solve, a point of a speed-accuracy chart. */
struct point {
    enum status status; /* of the factorisation */
    int valid;          /* 1, or 0: then there is no time */
    double seconds;     /* factor + solve, the best of the repeats; or 0 */
    double backward;    /* backward error in eps; or 0 */
};

/*
 * u := A^{-1} b, timed [eq:cholesky].  Valid: factored, and a backward error
 * of at most BACKWARD_EPS.  A and b are left alone.
 */
static struct point measure(const struct matrix *A, const double b[],
                            int repeats, double u[])
{
    struct point point = {.status = OK};
    /* SLOT 8d(A, b, repeats, u, &point, BACKWARD_EPS): given A and b, factor a
     * copy and solve, `repeats` times, with the clock around these two calls
     * only; keep the shortest time; free the copies.  Then judge by
     * matrix_backward_error(): what is not valid (NaN included) has no time and
     * no error, both are 0. */
    todo("8d", A, b, repeats, u, &point, BACKWARD_EPS);
    /* END 8d */
    return point;
}

/* A system on a grid; its memory is its own. */
struct system {
    int n;
    double *x, *b, *u;
    struct matrix *A;
};

static void system_free(struct system *s)
{
    free(s->x);
    free(s->b);
    free(s->u);
    matrix_free(s->A);
}

/* n elements on (0, 1), A and b assembled, the flux at x = 1 in b. */
static struct system system_make(enum storage storage, int n, double grading,
                                 const struct quadrature *rule, int reversed)
{
    const size_t N = (size_t)n + 1;
    const struct system s = {n, allocate(N, sizeof(double)),
                             allocate(N, sizeof(double)),
                             allocate(N, sizeof(double)),
                             matrix_alloc(storage, n + 1, 1)};
    int *order = allocate((size_t)n, sizeof *order);
    poisson_grid(0.0, 1.0, n, grading, s.x);
    for (int k = 0; k < n; k++) order[k] = reversed ? n - 1 - k : k;
    matrix_add(s.A, 0, 0, 2.385); /* assemble() must forget it */
    assemble(n, s.x, bvp_beta, bvp_f, rule, order, s.A, s.b);
    s.b[n] -= 0.5; /* the flux beta u' at x = 1 */
    free(order);
    return s;
}

/* u(0) = 1 [eq:dirichlet-correction], then one run. */
static struct point system_solve(struct system *s)
{
    matrix_dirichlet(s->A, s->b, 1, (const int[]){0}, (const double[]){1.0},
                     KEEP_DIAGONAL);
    return measure(s->A, s->b, 1, s->u);
}

/* What measure() says of the solved system, of one whose A is not symmetric,
 * and of one with a NaN in b, which stays there; the flops of both storages. */
static void print_runs(struct system *s)
{
    static const char *const name[] = {"correct", "not symmetric", "NaN in b"};
    table_begin("runs", "system status valid dense_flops banded_flops");
    for (int trial = 0; trial < 3; trial++) {
        if (trial == 1) matrix_add(s->A, 0, 1, s->A->a[0]);
        if (trial == 2) matrix_add(s->A, 0, 1, -s->A->a[0]);
        if (trial == 2) s->b[0] = (double)NAN;
        const struct point point = measure(s->A, s->b, 1, s->u);
        table_row(name[trial], status_name(point.status),
                  point.valid ? "yes" : "no", cholesky_flops(s->n + 1, s->n),
                  cholesky_flops(s->n + 1, 1));
    }
    table_end();
}

int main(int argc, char *argv[])
{
    int n = 5, reversed = 0, rule = 0;
    double grading = 3.0;
    const struct quadrature *const rules[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 1000,
         .help = "elements of the scene (A is printed up to 12)"},
        {"grading", .real = &grading, .min = 0.01, .max = 100.0,
         .help = "last element length over first, in the scene"},
        {"order", .choice = &reversed, .choices = "natural reversed",
         .help = "order of the elements"},
        {"rule", .choice = &rule, .choices = "midpoint trapezoid gauss2",
         .help = "quadrature rule"},
    };
    options_parse("08_element_assembly", options, COUNT(options), argc, argv);
    struct system s = system_make(DENSE, n, grading, rules[rule], reversed);
    if (n <= 12) matrix_table("A", s.A);
    table_vector("b", n + 1, s.b);
    const struct point point = system_solve(&s);
    if (!point.valid)
        die("u does not solve A u = b (%s)", status_name(point.status));
    table_begin("nodes", "x u exact");
    for (int i = 0; i <= n; i++) table_row(s.x[i], s.u[i], bvp_exact(s.x[i]));
    table_end();
    print_runs(&s);
    system_free(&s);
    return table_finish();
}
