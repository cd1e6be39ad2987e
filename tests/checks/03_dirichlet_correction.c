/*
 * 03_dirichlet_correction.c - what a right correction satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *     3a, 3b  N            8, 5, and 5 to 65 in condition_numbers_...
 *     3a, 3b  A            known_values_..., equations_...: full; others: bar's
 *     3a, 3b  n_fixed      known_values_..., equations_...: 1 to 4; others: 3
 *     3a, 3b  node, g      in no order; an end, or beside it; a value of 0
 *     3a      b            any numbers, and the loads
 *     3b      b, diagonal  equations_..., diagonal_is_kept_or_one
 *     3c      N, A, b, u   reactions_...: full A and any u; the bar's solution
 */
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

/* A full symmetric matrix of order 5 without a pattern; its diagonal rules. */
enum { full = 5 };
static const int full_node[] = {3, 0, 4, 2};
static const double full_g[] = {0.613, -1.247, 0.0, 2.385};

static double full_entry(int i, int j)
{
    return i == j ? (i == 3 ? -1.0 : 1.0) * (6.0 + 0.371 * i)
                  : sin(2.385 * (i + j) + 0.613 * i * j);
}

static double *full_matrix(void)
{
    double *A = guarded_alloc(full * full);
    for (int ij = 0; ij < full * full; ij++)
        A[ij] = full_entry(ij / full, ij % full);
    return A;
}

static double *full_load(void)
{
    return guarded_copy(full, (const double[]){0.731, -2.385, 3.714, 1.0, 0.3});
}

/* The place of node i among the first n_fixed of full_node, or -1. */
static int place_of(int i, int n_fixed)
{
    for (int k = 0; k < n_fixed; k++)
        if (full_node[k] == i) return k;
    return -1;
}

/* 3a by itself: b where the equation stays, whatever A is. */
static void known_values_move_to_the_right(void)
{
    for (int n_fixed = 1; n_fixed <= COUNT(full_node); n_fixed++) {
        double *b = full_load();
        const double *b0 = full_load(), *A = full_matrix();
        const double *g = guarded_copy(n_fixed, full_g);
        move_known_values(full, A, b, n_fixed,
                          guarded_indices(n_fixed, full_node), g);
        for (int k = 0; k < n_fixed; k++)
            expect(g[k] == full_g[k], "g[%d] is const and has changed", k);
        for (int i = 0; i < full; i++) {
            double want = b0[i];
            expect(A[i * full + full - 1] == full_entry(i, full - 1),
                   "A[%d][%d] is const and has changed", i, full - 1);
            if (place_of(i, n_fixed) >= 0) continue;
            for (int k = 0; k < n_fixed; k++)
                want -= full_entry(i, full_node[k]) * full_g[k];
            expect_close(b[i], want, ROUND_OFF, 10.0,
                         "full matrix of order 5, %d prescribed: b[%d], less "
                         "A_ik g_k of each prescribed node k", n_fixed, i);
        }
    }
}

/* 3b by itself, on any b. */
static void equations_are_replaced(void)
{
    for (int c = 0; c < 2 * COUNT(full_node); c++) {
        const int n_fixed = c / 2 + 1;
        double *A = full_matrix(), *b = full_load();
        const double *b0 = full_load(), *g = guarded_copy(n_fixed, full_g);
        replace_equations(full, A, b, n_fixed,
                          guarded_indices(n_fixed, full_node), g,
                          c % 2 ? UNIT_DIAGONAL : KEEP_DIAGONAL);
        for (int k = 0; k < n_fixed; k++)
            expect(g[k] == full_g[k], "g[%d] is const and has changed", k);
        for (int i = 0; i < full; i++) {
            const int at = place_of(i, n_fixed);
            const double d = c % 2 ? 1.0 : full_entry(i, i);
            expect_close(b[i], at < 0 ? b0[i] : d * full_g[at], ROUND_OFF, 10.0,
                         "full matrix of order 5, diagonal %s: b[%d], node %s",
                         c % 2 ? "1" : "kept", i,
                         at < 0 ? "not prescribed" : "prescribed, d g");
            for (int j = 0; j < full; j++) {
                const int left = at < 0 && place_of(j, n_fixed) < 0;
                expect_close(A[i * full + j],
                             i == j && at >= 0 ? d
                             : left            ? full_entry(i, j)
                                               : 0.0,
                             1e-15, 10.0,
                             "full matrix of order 5, %d prescribed, diagonal "
                             "%s: A[%d][%d]", n_fixed, c % 2 ? "1" : "kept", i,
                             j);
            }
        }
    }
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

/* A u - b, row by row, for a full A and a u that solves nothing. */
static void reactions_of_a_full_matrix(void)
{
    const double u[full] = {2.385, -0.731, 0.512, 1.247, -3.714};
    double *r = guarded_alloc(full);
    const double *b = full_load();
    reactions(full, full_matrix(), b, guarded_copy(full, u), r);
    for (int i = 0; i < full; i++) {
        double want = -b[i];
        for (int j = 0; j < full; j++) want += full_entry(i, j) * u[j];
        expect_close(r[i], want, ROUND_OFF, 30.0,
                     "r[%d], (A u - b)_i of a full matrix of order 5", i);
    }
}

static void reactions_balance_the_loads(void)
{
    reactions_of_a_full_matrix();
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
    {"known_values_move_to_the_right", known_values_move_to_the_right, "3a"},
    {"equations_are_replaced", equations_are_replaced, "3b"},
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
