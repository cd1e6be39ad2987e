/*
 * cost.c - how large may n be?
 *
 * The square under gravity at rest, left side held, cubic law, solved from
 * u = 0.  Table: the Newton steps; what the next mesh, of half the elements'
 * length, still changes in the displacement of the vertex (1, 0), relative to
 * it; and the flops of the whole solve, with K in a band as in the lesson
 * [eq:band-cost] and in the order of nested dissection (lesson 21): each step
 * has ELEMENT flops per triangle, a factorisation, and two triangular solves.
 * Table fits: the largest n for which a band's whole solve, at so many flops
 * per second, ends within 1/30 s.
 */
#include "linear/sparse.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { ELEMENT = 250 }; /* of the closed form, as in the chapter on speed */

/* Flops of a step of the lesson on n x n squares. */
static double banded(int n)
{
    const struct matrix_cost band =
        matrix_cost(BANDED, 2 * (n + 1) * (n + 1), 2 * n + 5);
    return 2.0 * ELEMENT * n * n + band.flops + band.solve;
}

struct solved {
    int steps;
    double sag, banded, dissected; /* m; flops of a step */
};

static struct solved solve(int n)
{
    const struct scene_setting set = scene_notes(GRAVITY, CUBIC, n);
    const struct step_control newton = step_method("notes");
    struct scene *s = scene_alloc(&set);

    body_store(s->body, SPARSE);
    const struct step_report report =
        step_solve(s->body, &newton, at_rest(s->f), s->u);
    if (report.status != OK) die("n = %d: %s", n, status_name(report.status));
    const int vertex = n / 2 * (n + 1) + n; /* at (1, 0) */
    const struct solved result = {
        report.iterations, s->u[2 * vertex + 1],
        banded(n),
        2.0 * ELEMENT * n * n + s->body->pattern->flops +
            s->body->pattern->solve};
    scene_free(s);
    return result;
}

int main(void)
{
    struct solved here = solve(4);
    double order = 0.0, before = 0.0, change = 0.0, growth = 0.0;
    int most = 0;

    table_begin("cost", "n steps change banded dissected");
    for (int n = 4; n <= 64; n *= 2) {
        const struct solved next = solve(2 * n);
        change = fabs(here.sag / next.sag - 1.0);
        order = study_order(before, change, 2.0);
        before = change;
        growth = log2(next.banded / here.banded);
        if (here.steps > most) most = here.steps;
        table_row(n, here.steps, cell_rounded(5, change),
                  here.steps * here.banded, here.steps * here.dissected);
        here = next;
    }
    table_end();
    table_begin("fits", "rate n");
    for (int k = 0; k < 2; k++) {
        const double rate[] = {3e9, 40e9}; /* flops per second */
        int n = 1;
        while (most * banded(n + 1) <= rate[k] / 30.0) n++;
        table_row(rate[k], n);
    }
    table_end();
    claim(most <= 6, "at most six Newton steps on every mesh (%d)", most);
    /* 1.42: twice the exponent of the corner where the held side ends */
    claim(fabs(order - 1.42) < 0.1 && fabs(growth - 4.0) < 0.15,
          "the error falls with n^-1.42 (%g), and a step in a band costs n^4 "
          "(%g)", order, growth);
    return table_finish();
}
