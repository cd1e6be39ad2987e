/*
 * particles.c - what do particles win, and what do finite elements?
 *
 * `bar`: hung by its end; x(1) against the exact one [eq:hanging-bar].  All of
 * the load on one grid, or ten loads, each with a new one.  `block`: let go
 * under its weight; u against the limit of elements; four steps per cell when
 * explicit, else one.  `per_cell`: four, eight and sixteen; the flops of a step
 * over those of elements; how well the limit is known.  `steps`: on eight
 * cells, as few as go.  `price`: flops of an error, by lines between the
 * logarithms, over those of elements; `price_sixteen`: with 16 steps per cell.
 */
#include "particle_price.h"
#include "particle_work.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static const struct curve {
    const char *name;
    int order, per_cell, steps, implicit; /* order 0: finite elements */
    enum transfer transfer;
    int first, last, base; /* cells; which elements it competes with */
} curve[2][7] = {{{"elements", 0, 0, 1, 1, PIC, 4, 256, 0},
                  {"linear", 1, 2, 1, 1, PIC, 8, 128, 0},
                  {"quadratic", 2, 2, 1, 1, PIC, 8, 128, 0},
                  {"cubic", 3, 2, 1, 1, PIC, 8, 128, 0},
                  {"ten_linear", 1, 4, 10, 1, PIC, 8, 64, 0},
                  {"ten_quadratic", 2, 4, 10, 1, PIC, 8, 64, 0},
                  {"ten_cubic", 3, 4, 10, 1, PIC, 8, 64, 0}},
                 {{"elements", 0, 0, 4, 0, PIC, 4, 32, 0},
                  {"linear", 1, 2, 4, 0, APIC, 4, 16, 0},
                  {"quadratic", 2, 2, 4, 0, APIC, 4, 16, 0},
                  {"cubic", 3, 2, 4, 0, APIC, 4, 16, 0},
                  {"FLIP", 2, 2, 4, 0, FLIP, 4, 16, 0},
                  {"implicit_elements", 0, 0, 1, 1, PIC, 4, 32, 5},
                  {"implicit", 2, 2, 1, 1, APIC, 4, 16, 5}}};
enum { CURVES = 7, SIZES = 7 };
static const char *const body[] = {"bar", "block", "steps", "per_cell"};
/* Of each curve, size by size; of the block the first four again, on 4, 8 and
 * 16 cells with 4, 8 and 16 steps per cell. */
static double error[2][CURVES][SIZES], work[2][CURVES][SIZES];
static double more[4][3][3], of_step[4]; /* flops of a step on four cells */
static double sixteen[4][3], work_sixteen[4][3]; /* with 16 */

/* A row for body[b]; the error, relative to the truth, INFINITY if not OK. */
static double print(const struct curve *c, int b, int cells, int steps,
                    const struct work *truth, double *flops)
{
    const int let_go = b > 0;
    const struct work_setting elements = {
        WEIGHT, LOG, 1, cells, steps,
        c->implicit ? BACKWARD_EULER : SYMPLECTIC_EULER, 1e-9,
        LINEAR_TRIANGLE, 1.0};
    const struct particle_setting particles = {
        let_go ? LET_GO : HUNG, c->order, c->per_cell, cells, steps,
        c->implicit, c->transfer};
    const struct work w = c->order ? particle_work(&particles)
                          : let_go ? work_run(&elements)
                                   : element_bar_work(cells);
    const double e = work_distance(&w, truth) / work_distance(truth, NULL);
    const int ok = w.status == OK;
    table_row(body[b], c->name, cells, steps, w.systems, cell_if(ok, e),
              cell_if(ok, w.flops), status_name(w.status));
    *flops = w.flops;
    return e;
}

static void print_curves(const struct work truth[2])
{
    double used;
    for (int b = 0; b < 2; b++)
        for (int k = 0; k < CURVES; k++) {
            const struct curve *c = &curve[b][k];
            for (int i = 0, n = c->first; n <= c->last; i++, n *= 2)
                error[b][k][i] = print(c, b, n, c->steps * (b ? n : 1),
                                       &truth[b], &work[b][k][i]);
        }
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            for (int m = 0; m < 3; m++) {
                more[k][i][m] = print(&curve[1][k], 3, 4 << i, 16 << i << m,
                                      &truth[1], &used);
                if (i == 0) of_step[k] = used / (16 << m);
                if (m < 2) continue;
                sixteen[k][i] = more[k][i][m];
                work_sixteen[k][i] = used;
            }
}

static void print_per_cell(double floor)
{
    table_begin("per_cell", "curve cells times four eight sixteen floor");
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) {
            const double *m = more[k][i];
            table_row(curve[1][k].name, 4 << i, of_step[k] / of_step[0],
                      cell_if(isfinite(m[0]), m[0]),
                      cell_if(isfinite(m[1]), m[1]),
                      cell_if(isfinite(m[2]), m[2]), floor);
            const int on_16 = k == 1 && i == 2;
            claim(isfinite(m[0]) == (k != 1) && isfinite(m[2]) == !on_16 &&
                      (on_16 || m[2] < 1.95 * more[0][i][2]) &&
                      (k < 2 || m[2] > 1.4 * more[0][i][2]), "linear kernels "
                  "need small steps, with which others are not better");
        }
    table_end();
    claim(more[0][0][2] > 1.9 * more[0][0][0], "with four steps per cell "
          "errors cancel in the coarsest elements");
}

/* The row of a curve, and what it says. */
static double print_price(int b, int k, double wanted)
{
    const int i = curve[b][k].base;
    const double times =
        particle_price(error[b][k], work[b][k], SIZES, wanted) /
        particle_price(error[b][i], work[b][i], SIZES, wanted);
    table_row(body[b], curve[b][k].name, wanted,
              cell_if(isfinite(times), times));
    claim(i == k || !(times < (b ? 10.0 : 3.0)), "elements win");
    return times;
}

int main(void)
{
    const struct work_setting model = {WEIGHT, LOG, .dynamic = 1};
    struct work truth[2] = {{.n_shared = 2, .u = {0.24096766839}}};
    static const int steps[] = {128, 64, 48, 32, 24, 20, 16, 12, 8};
    double floor, used;
    int few[4] = {0};
    truth[1] = work_limit(&model, &floor);
    floor /= work_distance(&truth[1], NULL);
    table_begin("runs", "body curve cells steps systems error flops reason");
    print_curves(truth);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 9; i++)
            if (isfinite(print(&curve[1][k], 2, 8, steps[i], &truth[1], &used)))
                few[k] = steps[i];
    table_end();
    print_per_cell(floor);
    table_begin("price", "body curve wanted times");
    for (int b = 0; b < 2; b++)
        for (int k = 1; k < CURVES; k++)
            print_price(b, k, !b ? 1e-4 : curve[b][k].base ? 0.03 : 0.02);
    const double dear = print_price(1, 3, 0.022);
    claim(dear > 4.0 * print_price(1, 3, 0.014), "it depends on the error");
    table_end();
    particle_prices(sixteen, work_sixteen);
    claim(error[0][3][1] < 0.6 * error[0][0][2] && few[3] < 0.6 * few[0] &&
              few[1] == 2 * few[0], "cell by cell the cubic kernel has half "
          "the error, and half the steps, the linear one twice the steps");
    claim(error[0][4][3] > 0.1 && error[0][5][3] > 5e-4 &&
              isfinite(error[0][4][3]) && error[1][3][2] < 0.012 &&
              floor < 0.002, "new grids spoil the bar; both methods agree");
    return table_finish();
}
