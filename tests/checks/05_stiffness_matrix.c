/*
 * 05_stiffness_matrix.c - what a right stiffness matrix satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *     5a   n, x            1 to 7 unequal elements, 0 inside; equal: 4 to 64
 *     5a   A               dense; half bandwidth 1, and 2 in entries_are_...
 *     5b   ends, n, h, k   all eigenvalues of both checks; two lengths n h
 *     5c   storage, N, p   numbers_..., flops_..., same_as_common_cost
 */
#include "program.h"

#include "judge.h"

#include "../oracle/poisson.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_sort_vector.h>

/* Unequal elements of high entropy; the first k + 1 nodes are a grid, too. */
enum { n_elem = 7 };
static const double nodes[n_elem + 1] = {-0.731, -0.448, 0.613, 0.7035,
                                         1.247,  2.385,  2.517, 3.714};

/* A handful of divisions and sums: some eps of the largest entry. */
static const double ROUND_OFF = 1e-14;

static struct matrix *assembled(enum storage storage, int n)
{
    struct matrix *A = matrix_alloc(storage, n + 1, 1);
    stiffness_matrix(n, nodes, A);
    return A;
}

/* 1 / h of the shortest of the first n elements: the scale of A. */
static double scale(int n)
{
    double largest = 0.0;
    for (int j = 1; j <= n; j++)
        largest = fmax(largest, 1.0 / (nodes[j] - nodes[j - 1]));
    return largest;
}

static void rows_sum_to_zero(void)
{
    for (int n = 1; n <= n_elem; n++) {
        struct matrix *A = assembled(DENSE, n);
        for (int i = 0; i <= n; i++) {
            double sum = 0.0;
            for (int j = 0; j <= n; j++) sum += matrix_get(A, i, j);
            expect_close(sum, 0.0, ROUND_OFF, scale(n),
                         "sum of row %d, n = %d", i, n);
        }
        matrix_free(A);
    }
}

static void matrix_is_symmetric_and_tridiagonal(void)
{
    for (int n = 1; n <= n_elem; n++) {
        struct matrix *A = assembled(DENSE, n);
        int nonzeros = 0;
        for (int i = 0; i <= n; i++)
            for (int j = 0; j <= n; j++) {
                const double a = matrix_get(A, i, j);
                nonzeros += a != 0.0;
                expect(abs(i - j) <= 1 || a == 0.0,
                       "A[%d][%d] = %g, but hats %d and %d do not overlap", i,
                       j, a, i, j);
                expect_close(a, matrix_get(A, j, i), ROUND_OFF, scale(n),
                             "A[%d][%d], against A[%d][%d]", i, j, j, i);
            }
        expect(nonzeros == 3 * n + 1, "%d numbers are not zero, not %d",
               nonzeros, 3 * n + 1);
        matrix_free(A);
    }
}

/* u = x has slope 1: it needs a pull of 1 at either end and nothing else. */
static void linear_function_needs_forces_at_the_ends_only(void)
{
    for (int n = 1; n <= n_elem; n++) {
        struct matrix *A = assembled(DENSE, n);
        double force[n_elem + 1];
        matrix_multiply(A, nodes, force);
        for (int j = 0; j <= n; j++)
            expect_close(force[j], j == 0 ? -1.0 : j == n ? 1.0 : 0.0,
                         ROUND_OFF, scale(n) * 3.714,
                         "(A x)_%d for u = x, n = %d", j, n);
        matrix_free(A);
    }
}

/* Slope of hat i on element e, nodes e and e + 1, by its values there. */
static double hat_slope(int i, int e)
{
    return ((i == e + 1) - (i == e)) / (nodes[e + 1] - nodes[e]);
}

static void entries_are_integrals_of_hat_slopes(void)
{
    for (int n = 1; n <= n_elem; n++)
        for (int s = DENSE; s <= BANDED; s++) {
            struct matrix *A =
                matrix_alloc((enum storage)s, n + 1, n > 1 ? 2 : 1);
            stiffness_matrix(n, nodes, A);
            for (int i = 0; i <= n; i++)
                for (int j = 0; j <= n; j++) {
                    double integral = 0.0;
                    for (int e = 0; e < n; e++)
                        integral += hat_slope(i, e) * hat_slope(j, e) *
                                    (nodes[e + 1] - nodes[e]);
                    expect_close(matrix_get(A, i, j), integral, ROUND_OFF,
                                 scale(n), "A[%d][%d] (%s), n = %d", i, j,
                                 s == DENSE ? "dense" : "banded", n);
                }
            matrix_free(A);
        }
}

static void same_as_common_assembly(void)
{
    struct matrix *A = assembled(BANDED, n_elem);
    struct matrix *B = matrix_alloc(BANDED, n_elem + 1, 1);
    double b[n_elem + 1];

    poisson_assemble(n_elem, nodes, field_one, field_one, &MIDPOINT, B, b);
    for (int i = 0; i <= n_elem; i++)
        for (int j = 0; j <= n_elem; j++)
            expect_close(matrix_get(A, i, j), matrix_get(B, i, j), ROUND_OFF,
                         scale(n_elem),
                         "A[%d][%d], against poisson_assemble()", i, j);
    matrix_free(A);
    matrix_free(B);
}

static const char *const ends_name[] = {"no end fixed", "one end fixed",
                                        "both ends fixed"};

/* The sum of the eigenvalues is the sum of the diagonal, which is 2 / h for a
 * node between two elements and 1 / h for a free end. */
static void eigenvalues_add_up_to_the_trace(void)
{
    for (int s = NONE_FIXED; s <= BOTH_FIXED; s++)
        for (int n = 1; n <= 200; n += n < 9 ? 1 : 191) {
            const double h = 2.385 / n;
            const double trace = (2.0 * (n - 1) + 2.0 - s) / h;
            double sum = 0.0;
            for (int k = 1; k <= n + 1 - s; k++)
                sum += eigenvalue_exact((enum ends)s, n, h, k);
            expect_close(sum, trace, 1e-13, 4.0 * n / h,
                         "sum of the eigenvalues, %s, n = %d",
                         ends_name[s], n);
        }
}

/* Against GSL and a matrix that is written down here. */
static void eigenvalues_are_those_of_the_matrix(void)
{
    static const int n_list[] = {1, 2, 3, 7, 24};
    for (int s = NONE_FIXED; s <= BOTH_FIXED; s++)
        for (int i = 0; i < COUNT(n_list); i++) {
            const int n = n_list[i], order = n + 1 - s;
            const double h = 3.714 / n;
            if (order == 0) continue;
            gsl_matrix *T = gsl_matrix_calloc((size_t)order, (size_t)order);
            gsl_vector *lambda = gsl_vector_alloc((size_t)order);
            gsl_eigen_symm_workspace *work =
                gsl_eigen_symm_alloc((size_t)order);
            for (size_t r = 0; r < T->size1; r++) {
                gsl_matrix_set(T, r, r, 2.0 / h);
                if (r > 0) gsl_matrix_set(T, r, r - 1, -1.0 / h);
                if (r > 0) gsl_matrix_set(T, r - 1, r, -1.0 / h);
            }
            if (s == NONE_FIXED) gsl_matrix_set(T, 0, 0, 1.0 / h);
            if (s != BOTH_FIXED)
                gsl_matrix_set(T, T->size1 - 1, T->size1 - 1, 1.0 / h);
            gsl_eigen_symm(T, lambda, work);
            gsl_sort_vector(lambda);
            for (int k = 1; k <= order; k++)
                expect_close(eigenvalue_exact((enum ends)s, n, h, k),
                             gsl_vector_get(lambda, (size_t)k - 1), 1e-13,
                             4.0 / h, "eigenvalue %d, %s, n = %d", k,
                             ends_name[s], n);
            gsl_eigen_symm_free(work);
            gsl_vector_free(lambda);
            gsl_matrix_free(T);
        }
}

/*
 * The oracle's numbers, and what they grow to: kappa / n^2 -> 4 / pi^2 and
 * 16 / pi^2.  What is left of 4 n^2 / pi^2 is constant, about 2/3; of
 * 16 n^2 / pi^2 it is 1/n, for the angle is pi / (2n + 1) and not pi / (2n): at
 * n = 64 less than 0.001 and 0.02.
 */
static double condition_number(enum ends ends, int n)
{
    double x[65], lambda[65];
    const int order = n + 1 - (int)ends;
    struct matrix *A = matrix_alloc(DENSE, n + 1, 0);
    poisson_grid(0.0, 1.0, n, 1.0, x);
    stiffness_matrix(n, x, A);
    struct matrix *free_part = matrix_block(A, 1, order);
    expect(matrix_eigenvalues(free_part, lambda) == OK, "A is not finite");
    matrix_free(free_part);
    matrix_free(A);
    return lambda[order - 1] / lambda[0];
}

static void condition_numbers_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_condition); k++) {
        const int n = oracle_condition[k].N; /* 4, 16, 64 */
        expect_close(condition_number(BOTH_FIXED, n), oracle_condition[k].DD,
                     1e-9, oracle_condition[k].DD,
                     "condition number, n = %d, both ends fixed", n);
        expect_close(condition_number(ONE_FIXED, n), oracle_condition[k].DN,
                     1e-9, oracle_condition[k].DN,
                     "condition number, n = %d, one end fixed", n);
    }
    const double leading = 4.0 * 64.0 * 64.0 / (M_PI * M_PI);
    expect_close(condition_number(BOTH_FIXED, 64), leading, 1e-3, leading,
                 "condition number, n = 64, against 4 n^2 / pi^2");
    expect_close(condition_number(ONE_FIXED, 64), 4.0 * leading, 0.02,
                 4.0 * leading,
                 "condition number, n = 64, against 16 n^2 / pi^2");
}

/* Counts: whole numbers, up to the round-off of a formula with thirds. */
static void numbers_are_what_the_storage_holds(void)
{
    for (int N = 1; N <= 11; N++)
        for (int p = 0; p < N; p++)
            for (int s = DENSE; s <= BANDED; s++) {
                const enum storage storage = (enum storage)s;
                struct matrix *A = matrix_alloc(storage, N, p);
                const double held = (double)(matrix_bytes(A) / sizeof(double));
                expect_close(cholesky_cost(storage, N, p).numbers, held, 1e-13,
                             100.0, "numbers kept, N = %d, %s, p = %d", N,
                             s == DENSE ? "dense" : "banded", p);
                matrix_free(A);
            }
    expect_close(cholesky_cost(DENSE, 100001, 1).numbers, 10000200001.0, 1e-14,
                 1e10, "numbers kept, N = 100001, dense");
    expect_close(cholesky_cost(BANDED, 100001, 30000).numbers, 3000130001.0,
                 1e-14, 1e10, "numbers kept, N = 100001, banded, p = 30000");
}

/* The textbook loop with a counter, on a diagonally dominant matrix: 2N + 1 on
 * the diagonal, -1 in the rest of the band. */
static double counted_flops(int N, int p)
{
    double A[12][12] = {{0}}, flops = 0.0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j <= i; j++)
            A[i][j] = i == j ? 2.0 * N + 1.0 : i - j <= p ? -1.0 : 0.0;
    for (int k = 0; k < N; k++) {
        const int last = k + p < N - 1 ? k + p : N - 1;
        A[k][k] = sqrt(A[k][k]), flops++;
        for (int i = k + 1; i <= last; i++) A[i][k] /= A[k][k], flops++;
        for (int j = k + 1; j <= last; j++)
            for (int i = j; i <= last; i++)
                A[i][j] -= A[i][k] * A[j][k], flops += 2.0;
    }
    return flops;
}

static void flops_are_those_of_the_textbook_loop(void)
{
    for (int N = 1; N <= 12; N++)
        for (int p = 0; p < N; p++) {
            expect_close(cholesky_cost(BANDED, N, p).flops,
                         counted_flops(N, p), 1e-13, 1000.0,
                         "flops, N = %d, banded, p = %d", N, p);
            expect_close(cholesky_cost(DENSE, N, p).flops,
                         counted_flops(N, N - 1), 1e-13, 1000.0,
                         "flops, N = %d, dense", N);
        }
    /* N^3 / 3 and N p^2 to leading order: what is left is 3/(2N) and, with
     * N >> p >> 1, 2/p of it */
    expect_close(cholesky_cost(DENSE, 30000, 0).flops, 9e12, 1e-4, 9e12,
                 "flops, N = 30000, dense, against N^3 / 3");
    expect_close(cholesky_cost(BANDED, 1000000, 1000).flops, 1e12, 3e-3, 1e12,
                 "flops, N = 10^6, banded, p = 1000, against N p^2");
}

static void same_as_common_cost(void)
{
    for (int s = DENSE; s <= BANDED; s++)
        for (int N = 3; N < 100000; N = 7 * N + 2) {
            const int p = N / 3;
            const struct cost mine = cholesky_cost((enum storage)s, N, p);
            const struct matrix_cost cost =
                matrix_cost((enum storage)s, N, p);
            expect_close(mine.numbers, cost.numbers, 1e-13, cost.numbers,
                         "numbers kept, against matrix_cost(), N = %d", N);
            expect_close(mine.flops, cost.flops, 1e-13, cost.flops,
                         "flops, against matrix_cost(), N = %d", N);
        }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("--n 64"), *more = run("--unknowns 262144");
    const char *const key[] = {"2a", "2b"};
    const char *const table[] = {"eigenvalues_both", "eigenvalues_one"};
    measured("1", cell(output, "cost", "numbers", 0));
    for (int k = 0; k < 2; k++)
        measured(key[k], cell(output, table[k], "exact", -1) /
                             cell(output, table[k], "exact", 0));
    measured("3", cell(more, "cost", "flops", -1) /
                      cell(output, "cost", "flops", -1));
}

static const struct claim claims[] = {
    {"rows_sum_to_zero", rows_sum_to_zero, "5a"},
    {"matrix_is_symmetric_and_tridiagonal", matrix_is_symmetric_and_tridiagonal,
     "5a"},
    {"linear_function_needs_forces_at_the_ends_only",
     linear_function_needs_forces_at_the_ends_only, "5a"},
    {"entries_are_integrals_of_hat_slopes", entries_are_integrals_of_hat_slopes,
     "5a"},
    {"same_as_common_assembly", same_as_common_assembly, "5a"},
    {"eigenvalues_add_up_to_the_trace", eigenvalues_add_up_to_the_trace, "5b"},
    {"eigenvalues_are_those_of_the_matrix", eigenvalues_are_those_of_the_matrix,
     "5b"},
    {"numbers_are_what_the_storage_holds", numbers_are_what_the_storage_holds,
     "5c"},
    {"flops_are_those_of_the_textbook_loop",
     flops_are_those_of_the_textbook_loop, "5c"},
    {"condition_numbers_are_the_oracles", condition_numbers_are_the_oracles,
     "5a"},
    {"same_as_common_cost", same_as_common_cost, "5c"},
};

static const char *const runs[] = {
    "",
    "--n 1 --grading 2.385 --unknowns 100000",
    "--n 2 --grading 0.37 --unknowns 4",
    "--n 23 --grading 7.43 --unknowns 2385",
    "--n 40 --grading 0.0613",
};

#define ENTRY "one or two divisions per entry"
#define EIGEN "eigenvalues to some eps of the largest"
static const struct column_rule rules[] = {
    {"rows_equal", "j", 0, "a count", 0},
    {"rows_equal", "sum", 1e-12, "0 but for round-off", 100},
    {"rows_equal", "*", 1e-13, ENTRY, 0},
    {"rows_graded", "j", 0, "a count", 0},
    {"rows_graded", "sum", 1e-12, "0 but for round-off", 100},
    {"rows_graded", "*", 1e-13, ENTRY, 0},
    {"eigenvalues_none", "k", 0, "a count", 0},
    {"eigenvalues_none", "*", 1e-12, EIGEN, 0},
    {"eigenvalues_one", "k", 0, "a count", 0},
    {"eigenvalues_one", "*", 1e-12, EIGEN, 0},
    {"eigenvalues_both", "k", 0, "a count", 0},
    {"eigenvalues_both", "*", 1e-12, EIGEN, 0},
    {"cost", "numbers", 1e-12, "a count, in real arithmetic", 0},
    {"cost", "flops", 1e-12, "a count, in real arithmetic", 0},
    {"cost", "*", 0, "a word or a count", 0},
};

static const struct lesson lesson = {
    "05_stiffness_matrix", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "With both ends fixed the largest eigenvalue is near 4/h and the smallest "
    "near h pi^2: their ratio, the condition number, grows like 4 n^2 / pi^2, "
    "and round-off with it (figures/05_stiffness_matrix/roundoff.svg: the "
    "residual stays, the error grows).",
    "Run with --n 64 --grading 1000: the largest diagonal entry of rows_graded "
    "is 143 times that of rows_equal, and the largest eigenvalue is at least "
    "every A_jj. What does one short element do to the condition number?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
