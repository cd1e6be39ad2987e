/*
 * ends.c - what has to hold a bar?
 *
 * Eight elements under a body force of 50, each end held or free, with a
 * traction at the right end where it is free: the sum of the loads, the rank of
 * K for the unknowns, and the answer.  Where nothing holds the bar node 0 is
 * held, and the force that it needs tells whether there is a solution.
 */
#include "bar/bar_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>

enum { N = 8 };

/* Rank of K with the rows and columns of the held ends struck out. */
static int rank(const struct bar_state *state, int unknowns)
{
    const int first = state->bar.held[0];
    struct matrix *K = matrix_alloc(BANDED, N + 1, 1);
    double value[N + 1];
    int count = 0;

    if (bar_tangent(&state->bar, state->u, K) != OK) die("K is not finite");
    struct matrix *block = matrix_block(K, first, unknowns);
    if (matrix_eigenvalues(block, value) != OK) die("K is not finite");
    for (int i = 0; i < unknowns; i++)
        count += value[i] > unknowns * DBL_EPSILON * value[unknowns - 1];
    matrix_free(block);
    matrix_free(K);
    return count;
}

/* INCOMPATIBLE: no end is held, and node 0 would need a force. */
static enum status solve(struct bar_scene scene)
{
    const int nothing = !scene.held[0] && !scene.held[1];
    if (nothing) scene.held[0] = 1;
    struct bar_state *state = bar_scene_solve(&scene, NULL);
    enum status status = state->report.status;
    if (nothing && !(fabs(bar_state_reaction(state)) <= 1e-12 * scene.c))
        status = INCOMPATIBLE;
    bar_state_free(state);
    return status;
}

int main(void)
{
    static const struct {
        int left, right;
        double pull; /* at the right end, where it is free */
        enum status expected;
    } cases[] = {{1, 1, 0, OK}, {1, 0, 100, OK}, {0, 1, 0, OK},
                 {0, 0, 100, INCOMPATIBLE}, {0, 0, -50, OK}};
    int as_expected = 1;

    table_begin_note("end_conditions",
                     "left right pull loads unknowns rank status",
                     "body force 50");
    for (int k = 0; k < 5; k++) {
        const int left = cases[k].left, right = cases[k].right;
        struct bar_scene scene = bar_scene_notes(LINEAR, N);
        scene.held[0] = left;
        scene.held[1] = right;
        scene.c = 50.0;
        scene.pull[1] = cases[k].pull;
        struct bar_state *state = bar_state_alloc(&scene);
        const int unknowns = N + 1 - left - right;
        const int full = rank(state, unknowns);
        const enum status status = solve(scene);
        double loads = 0.0;
        for (int i = 0; i <= N; i++) loads += state->b[i];
        table_row(left ? "held" : "free", right ? "held" : "free",
                  cases[k].pull, loads, unknowns, full, status_name(status));
        as_expected &= status == cases[k].expected &&
                       full == unknowns - (!left && !right);
        bar_state_free(state);
    }
    table_end();

    claim(as_expected, "K is singular, of rank %d of %d, only where no end is "
          "held, and then a solution exists only for loads that balance", N,
          N + 1);
    return table_finish();
}
