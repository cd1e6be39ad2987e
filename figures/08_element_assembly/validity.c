/*
 * validity.c - can a status be trusted?
 *
 * Four systems on 64 elements, factored and solved; a run is valid if u solves
 * a system that differs from A u = b by at most 20 eps, whatever the status of
 * the factorisation says.
 */
#include "exercise.h"
#include "bar/poisson.h"
#include "linear/residual.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum trial { AS_IT_MUST_BE, NOTHING_HELD, ROW_ONLY, NAN_IN_LOAD };
static const char *const name[] = {"correct", "nothing held", "row only",
                                   "NaN in the load"};
enum { n = 64 };

/* Of trial `t`: A, b and the nodes. */
static struct matrix *system_of(enum trial t, double x[], double b[])
{
    struct matrix *A = exercise_system(DENSE, n, x, b);
    if (t == NAN_IN_LOAD) b[n / 2] = (double)NAN;
    if (t == NOTHING_HELD || t == ROW_ONLY) {
        poisson_assemble(n, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
        b[n] -= 0.5;
    }
    if (t == ROW_ONLY) { /* the column stays, nothing moves into b */
        matrix_add(A, n, n - 1, -matrix_get(A, n, n - 1));
        b[n] = matrix_get(A, n, n) * bvp_exact(1.0);
    }
    return A;
}

int main(void)
{
    double x[n + 1], b[n + 1], u[n + 1], off[4];
    enum status status[4];
    int valid[4];

    table_begin("validity", "trial factored valid wrong_by");
    for (int t = AS_IT_MUST_BE; t <= NAN_IN_LOAD; t++) {
        struct matrix *A = system_of((enum trial)t, x, b);
        struct matrix *L = matrix_copy(A);
        for (int i = 0; i <= n; i++) u[i] = b[i];
        status[t] = matrix_factor(L);
        if (status[t] == OK) matrix_solve(L, u);
        off[t] = 0.0;
        for (int i = 0; i <= n; i++)
            off[t] = fmax(off[t], fabs(u[i] - bvp_exact(x[i])));
        valid[t] = status[t] == OK && matrix_backward_error(A, u, b) <= 20.0;
        table_row(name[t], status_name(status[t]), valid[t] ? "yes" : "no",
                  cell_if(status[t] == OK && t != NAN_IN_LOAD, off[t]));
        matrix_free(A);
        matrix_free(L);
    }
    table_end();
    claim(valid[0] && !valid[1] && !valid[2] && !valid[3],
          "only the correct system is valid");
    claim(status[ROW_ONLY] == OK && off[ROW_ONLY] > 0.8,
          "with the row alone Cholesky says OK, and u is wrong by 0.8 (%g)",
          off[ROW_ONLY]);
    claim(status[NOTHING_HELD] == NOT_SPD, "a singular matrix is NOT_SPD");
    return table_finish();
}
