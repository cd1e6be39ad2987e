/*
 * indefinite.c - does conjugate gradients notice that K is not positive
 * definite?
 *
 * The body of system.h, n = 8, pressed evenly, u = (-squeeze X1, 0): K of the
 * next step, the b of the stretch.  Tables: squeeze (the least eigenvalue over
 * the diagonal; Cholesky's word; how CG ends to three tolerances, and after how
 * many iterations), limits (the least squeeze that each of them refuses).
 */
#include "conjugate.h"
#include "base/options.h"
#include "../study/study.h"
#include "plane/system.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>

enum { N = 8, STEPS = 121, WAYS = 4 }; /* Cholesky, and three tolerances */
static const char *const name[] = {"cholesky", "rough", "middle", "fine"};
static const double tolerance[] = {0.0, 1e-1, 1e-4, 1e-10};

static void print_limits(double singular, const double first[WAYS])
{
    table_begin("limits", "who squeeze blind");
    table_row("eigenvalue", singular, 0.0);
    for (int w = 0; w < WAYS; w++)
        table_row(name[w], first[w], first[w] - first[0]);
    table_end();
}

int main(void)
{
    struct system *s = system_alloc(N);
    const size_t n_dof = (size_t)s->scene->n_dof;
    double *b = allocate(n_dof, sizeof *b), *x = allocate(n_dof, sizeof *x);
    double *value = allocate(n_dof, sizeof *value);
    double first[WAYS] = {0.0}, singular = 0.0, before = 0.0;
    int blind = 0, wrong = 0, most = 0;

    gsl_set_error_handler_off();
    system_right_side(s, NULL, b);
    table_begin_note("squeeze", "squeeze least cholesky rough rough_iterations "
                     "middle middle_iterations fine fine_iterations",
                     "n = %d, jacobi", N);
    for (int k = 0; k < STEPS; k++) {
        const double squeeze = 0.56 + 0.12 * k / (STEPS - 1);
        struct cg_report r[WAYS];
        system_press(s, squeeze);
        struct csr *K = system_matrix(s, NULL);
        struct matrix *A = matrix_copy(s->scene->body->K);
        if (matrix_eigenvalues(A, value) != OK) die("no eigenvalues");
        const double least = value[0] / matrix_max_diagonal(A);
        if (least <= 0.0 && singular == 0.0)
            singular = squeeze + 0.12 / (STEPS - 1) * least / (before - least);
        before = least;
        r[0].status = matrix_factor(A);
        for (int w = 1; w < WAYS; w++)
            r[w] = cg_solve(K, cg_jacobi, K, tolerance[w], 1000, b, x);
        for (int w = 0; w < WAYS; w++) {
            if (r[w].status != OK && first[w] == 0.0) first[w] = squeeze;
            wrong += r[w].status == NOT_SPD && least > 0.0;
        }
        wrong += r[0].status == OK && least <= 0.0;
        blind += least <= 0.0 && r[1].status == OK;
        most = r[3].iterations > most ? r[3].iterations : most;
        table_row(squeeze, least, status_name(r[0].status),
                  status_name(r[1].status), r[1].iterations,
                  status_name(r[2].status), r[2].iterations,
                  status_name(r[3].status), r[3].iterations);
        matrix_free(A);
        csr_free(K);
    }
    table_end();
    print_limits(singular, first);
    free(b);
    free(x);
    free(value);
    system_free(s);

    claim(wrong == 0, "Cholesky refuses K if and only if an eigenvalue is "
          "negative, and CG never refuses another one (%d)", wrong);
    claim(blind > 0 && first[1] > first[0],
          "with a tolerance of 0.1 CG solves %d systems whose K is indefinite",
          blind);
    claim(first[3] == first[0], "to 1e-10 it refuses what Cholesky does");
    return table_finish();
}
