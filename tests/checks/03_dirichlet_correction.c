/* 03_dirichlet_correction.c - what a right correction satisfies. */
#include "program.h"

#include "judge.h"

#include "../oracle/poisson.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

/* Scenes with high entropy: prescribed nodes in no order.  In the first an end
 * is one of them, in the second they are the neighbours of free ends. */
enum { n_elem = 7, N_node = 8, NN = N_node * N_node, n_prescribed = 3 };
static const double beta_ = 2.385, load = 3.714;
static const int prescribed[] = {5, 0, 2}, inside[] = {6, 1, 4};
static const double given[] = {-0.731, 1.247, 0.613};

/* Round-off of a direct solve with condition number below 1e3. */
static const double ROUND_OFF = 1e-12;

struct scene {
    double *A0, *b0; /* as assembled */
    double *A, *b;   /* corrected */
    double *u;
};

/* A and b as assembled; nothing is corrected or solved yet. */
static struct scene fresh(void)
{
    const struct scene s = {guarded_alloc(NN), guarded_alloc(N_node),
                            guarded_alloc(NN), guarded_alloc(N_node),
                            guarded_alloc(N_node)};
    assemble(n_elem, beta_, load, s.A0, s.b0);
    assemble(n_elem, beta_, load, s.A, s.b);
    return s;
}

static struct scene solved(const int node[], const double g[],
                           enum diagonal diagonal)
{
    const struct scene s = fresh();
    const enum status status = solve_prescribed(
        N_node, s.A, s.b, n_prescribed, guarded_indices(n_prescribed, node),
        guarded_copy(n_prescribed, g), diagonal, s.u);
    expect(status == OK,
           "Cholesky says %s: the corrected matrix is not positive definite",
           status_name(status));
    return s;
}

static int is_among(const int node[], int i)
{
    return i == node[0] || i == node[1] || i == node[2];
}

static void matrix_stays_symmetric(void)
{
    for (int d = 0; d < 4; d++) {
        const struct scene s = fresh();
        const double *A = s.A, *g = guarded_copy(n_prescribed, given);
        const int *node =
            guarded_indices(n_prescribed, d / 2 ? inside : prescribed);
        move_known_values(N_node, s.A, s.b, n_prescribed, node, g);
        replace_equations(N_node, s.A, s.b, n_prescribed, node, g,
                          d % 2 ? UNIT_DIAGONAL : KEEP_DIAGONAL);
        for (int i = 0; i < N_node; i++)
            for (int j = 0; j < i; j++)
                expect(A[i * N_node + j] == A[j * N_node + i],
                       "A[%d][%d] = %g but A[%d][%d] = %g: row and column of a "
                       "prescribed node must both be cleared",
                       i, j, A[i * N_node + j], j, i, A[j * N_node + i]);
    }
}

static void prescribed_values_are_reproduced(void)
{
    for (int d = KEEP_DIAGONAL; d <= UNIT_DIAGONAL; d++) {
        const struct scene s = solved(prescribed, given, (enum diagonal)d);
        for (int k = 0; k < n_prescribed; k++)
            expect_close(s.u[prescribed[k]], given[k], ROUND_OFF, 1.247,
                         "u at prescribed node %d", prescribed[k]);
    }
}

/* Strike out the prescribed rows and columns and solve what is left by LU. */
static void eliminate_by_hand(const int held[])
{
    const struct scene s = solved(held, given, KEEP_DIAGONAL);
    enum { n_free = N_node - n_prescribed };
    int node[n_free], m = 0, sign;
    for (int i = 0; i < N_node; i++)
        if (!is_among(held, i)) node[m++] = i;

    gsl_matrix *K = gsl_matrix_alloc(n_free, n_free);
    gsl_vector *rhs = gsl_vector_alloc(n_free), *w = gsl_vector_alloc(n_free);
    gsl_permutation *p = gsl_permutation_alloc(n_free);
    for (size_t i = 0; i < n_free; i++) {
        double value = s.b0[node[i]];
        for (int k = 0; k < n_prescribed; k++)
            value -= s.A0[node[i] * N_node + held[k]] * given[k];
        gsl_vector_set(rhs, i, value);
        for (size_t j = 0; j < n_free; j++)
            gsl_matrix_set(K, i, j, s.A0[node[i] * N_node + node[j]]);
    }
    gsl_linalg_LU_decomp(K, p, &sign);
    gsl_linalg_LU_solve(K, p, rhs, w);
    for (size_t i = 0; i < n_free; i++)
        expect_close(s.u[node[i]], gsl_vector_get(w, i), ROUND_OFF, 1.247,
                     "u at free node %d, against elimination", node[i]);
    gsl_matrix_free(K);
    gsl_vector_free(rhs);
    gsl_vector_free(w);
    gsl_permutation_free(p);
}

static void same_as_elimination(void)
{
    eliminate_by_hand(prescribed);
    eliminate_by_hand(inside);
}

/* u = w + sum_k g_k e_k [eq:lift]: w has homogeneous conditions. */
static void same_as_homogeneous_lift(void)
{
    const struct scene s = solved(prescribed, given, KEEP_DIAGONAL);
    const struct scene w = fresh();
    double lift[N_node] = {0};
    const double zero[] = {0.0, 0.0, 0.0};

    for (int k = 0; k < n_prescribed; k++) lift[prescribed[k]] = given[k];
    for (int i = 0; i < N_node; i++)
        for (int j = 0; j < N_node; j++)
            w.b[i] -= w.A[i * N_node + j] * lift[j];
    expect(solve_prescribed(N_node, w.A, w.b, n_prescribed, prescribed, zero,
                            KEEP_DIAGONAL, w.u) == OK,
           "the system with all values 0 is not positive definite");
    for (int i = 0; i < N_node; i++)
        expect_close(s.u[i], w.u[i] + lift[i], ROUND_OFF, 1.247,
                     "u at node %d, against w + lift", i);
}

static void order_of_nodes_is_irrelevant(void)
{
    const struct scene s = solved(prescribed, given, KEEP_DIAGONAL);
    const int other[] = {prescribed[2], prescribed[0], prescribed[1]};
    const double values[] = {given[2], given[0], given[1]};
    const struct scene t = solved(other, values, KEEP_DIAGONAL);
    for (int i = 0; i < N_node; i++)
        expect_close(t.u[i], s.u[i], ROUND_OFF, 1.247,
                     "u at node %d after renumbering the prescribed nodes", i);
}

static void diagonal_is_kept_or_one(void)
{
    const struct scene keep = solved(prescribed, given, KEEP_DIAGONAL);
    const struct scene one = solved(prescribed, given, UNIT_DIAGONAL);
    for (int i = 0; i < N_node; i++) {
        const int ii = i * N_node + i;
        expect_close(keep.A[ii], keep.A0[ii], 1e-15, keep.A0[ii],
                     "A[%d][%d] with the diagonal kept", i, i);
        expect_close(one.A[ii], is_among(prescribed, i) ? 1.0 : one.A0[ii],
                     1e-15, one.A0[ii], "A[%d][%d] with unit diagonal", i, i);
        expect_close(one.u[i], keep.u[i], ROUND_OFF, 1.247,
                     "u at node %d, which may not depend on the diagonal", i);
    }
}

static void reactions_balance_the_loads(void)
{
    const struct scene s = solved(prescribed, given, KEEP_DIAGONAL);
    double *r = guarded_alloc(N_node), sum = 0.0, total_load = 0.0;

    reactions(N_node, s.A0, s.b0, s.u, r);
    for (int i = 0; i < N_node; i++) {
        if (!is_among(prescribed, i))
            expect_close(r[i], 0.0, ROUND_OFF, beta_ * n_elem,
                         "reaction at free node %d", i);
        sum += r[i];
        total_load += s.b0[i];
    }
    expect_close(sum, -total_load, ROUND_OFF, beta_ * n_elem,
                 "sum of the reactions, against minus the sum of the loads");
}

static void printed_reactions_balance_the_loads(void)
{
    struct output *output = run("--n 9 --f 3.714 --beta 2.385");
    int n;
    const double *r = column(output, "nodes", "reaction", &n);
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < n; i++) {
        sum += r[i];
        largest = fmax(largest, fabs(r[i]));
    }
    expect(largest > 0.1,
           "every reaction is 0: they need the A and b of before the "
           "correction");
    expect_close(sum, -3.714, ROUND_OFF, largest,
                 "sum of the printed reactions, against minus int f dx");
}

static void compare_with_banded_storage(const int node[])
{
    const struct scene s = solved(node, given, KEEP_DIAGONAL);
    struct matrix *A = matrix_alloc(BANDED, N_node, 1);
    double b[N_node];

    for (int i = 0; i < N_node; i++) {
        b[i] = s.b0[i];
        for (int j = 0; j < N_node; j++)
            if (abs(i - j) <= 1) matrix_add(A, i, j, s.A0[i * N_node + j]);
    }
    matrix_dirichlet(A, b, n_prescribed, node, given, KEEP_DIAGONAL);
    for (int i = 0; i < N_node; i++) {
        expect_close(s.b[i], b[i], ROUND_OFF, beta_ * n_elem,
                     "corrected b[%d], against the banded matrix", i);
        for (int j = 0; j < N_node; j++)
            expect_close(s.A[i * N_node + j], matrix_get(A, i, j), 1e-15,
                         beta_ * n_elem,
                         "corrected A[%d][%d], against the banded matrix", i,
                         j);
    }
    matrix_free(A);
}

static void banded_storage_agrees(void)
{
    compare_with_banded_storage(prescribed);
    compare_with_banded_storage(inside);
}

/* Left end given, beta = 1346.15; eigenvalues are good to eps times the
 * condition number [eq:condition-number]. */
static double condition_number(int n, enum diagonal diagonal)
{
    const int N = n + 1, left[] = {0};
    const double value[] = {2.385};
    double *A = allocate((size_t)(N * N), sizeof *A);
    double *b = allocate(2 * (size_t)N, sizeof *b);
    struct matrix *copy = matrix_alloc(DENSE, N, 0);

    assemble(n, 1346.153846153846, 0.0, A, b);
    move_known_values(N, A, b, 1, left, value);
    replace_equations(N, A, b, 1, left, value, diagonal);
    for (int ij = 0; ij < N * N; ij++) matrix_add(copy, ij / N, ij % N, A[ij]);
    expect(matrix_eigenvalues(copy, b) == OK, "the corrected A is not finite");
    const double condition = b[N - 1] / b[0];
    matrix_free(copy);
    free(A);
    free(b);
    return condition;
}

static void condition_numbers_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_condition); k++) {
        const int n = oracle_condition[k].N;
        expect_close(condition_number(n, KEEP_DIAGONAL), oracle_condition[k].DN,
                     1e-9, oracle_condition[k].DN,
                     "condition number, n = %d, diagonal kept", n);
        expect_close(condition_number(n, UNIT_DIAGONAL),
                     oracle_condition[k].one, 1e-9, oracle_condition[k].one,
                     "condition number, n = %d, diagonal 1", n);
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    int n;
    const double *r = column(run(""), "nodes", "reaction", &n);
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += r[i];
    measured("1", sum);
    measured("2a", condition_number(64, KEEP_DIAGONAL));
    measured("2b", condition_number(64, UNIT_DIAGONAL));
}

static const struct claim claims[] = {
    {"matrix_stays_symmetric", matrix_stays_symmetric, "3b"},
    {"prescribed_values_are_reproduced", prescribed_values_are_reproduced,
     "3b"},
    {"same_as_elimination", same_as_elimination, "3a"},
    {"same_as_homogeneous_lift", same_as_homogeneous_lift, "3a"},
    {"order_of_nodes_is_irrelevant", order_of_nodes_is_irrelevant, "3a"},
    {"diagonal_is_kept_or_one", diagonal_is_kept_or_one, "3b"},
    {"reactions_balance_the_loads", reactions_balance_the_loads, "3c"},
    {"printed_reactions_balance_the_loads", printed_reactions_balance_the_loads,
     "3c"},
    {"banded_storage_agrees", banded_storage_agrees, "3a"},
    {"condition_numbers_are_the_oracles", condition_numbers_are_the_oracles,
     "3b"},
};

static const char *const runs[] = {
    "",
    "--diagonal one",
    "--n 7 --fix left --left 2.385 --f -3.714",
    "--n 11 --fix right --right -0.613 --beta 2.385",
    "--n 2 --fix both --diagonal one",
};

#define SOLVE "direct solve, condition number below 1e6"
static const struct column_rule rules[] = {
    {"A", "*", 1e-14, "sums of two element entries", 0},
    {"A_corrected", "*", 1e-14, "sums of two element entries", 0},
    {"b", "*", 1e-13, "sums of two element loads", 0},
    {"b_corrected", "*", 1e-13, "one product more per entry", 0},
    {"nodes", "x", 1e-14, "i / n", 0},
    {"nodes", "*", 1e-9, SOLVE, 0},
};

static const struct lesson lesson = {
    "03_dirichlet_correction", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "The diagonal does not change u, but it changes the matrix: with modulus "
    "1346 and 16 elements a 1 on the diagonal makes the condition number 195 "
    "times larger (figures/03_dirichlet_correction/conditioning.svg). Keep the "
    "scale of the matrix.",
    "Clear only the rows, and leave out 3a: with the diagonal kept, Cholesky "
    "ends OK with an answer that is wrong by 0.75, because it never looks at "
    "the upper triangle. Which system did it solve?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
