/*
 * growth.c - how do fill, flops and memory grow with n, and when does an order
 * pay?
 *
 * K of the stretch, both ends held: 2 (n - 1) (n + 1) unknowns.  Full; in a
 * band of half bandwidth 2 n - 1; by nested dissection with the fronts of
 * sparse.h.  Counted, not timed: numbers stored of L, flops to factor and to
 * solve [eq:cholesky-flops].  Tables: growth, with exponents from n / 2 to n;
 * compare, the last two side by side; crossovers, the least n from which
 * dissection has less than the band.
 */
#include "dissected.h"
#include "linear/matrix.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { SIZES = 8 }; /* n = 2, 4, ..., 256 */
enum kind { FULL, BAND, DISSECTION, KINDS };
static const char *const name[] = {"full", "band", "dissection"};

static struct matrix_cost cost_of(enum kind kind, int n)
{
    const int order = 2 * (n - 1) * (n + 1);
    if (kind == DISSECTION) {
        struct sparse *s = dissected(n);
        const struct matrix_cost cost = {s->numbers, s->flops, s->solve};
        sparse_free(s);
        return cost;
    }
    return matrix_cost(kind == FULL ? DENSE : BANDED, order,
                       2 * n - 1 < order ? 2 * n - 1 : order - 1);
}

static double part(struct matrix_cost c, int k)
{
    return k == 0 ? c.numbers : k == 1 ? c.flops : c.solve;
}

static void print_costs(struct matrix_cost cost[SIZES][KINDS])
{
    table_begin("growth", "storage n unknowns entries flops solve");
    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < SIZES; i++) {
            const int n = 2 << i;
            const struct matrix_cost c = cost_of((enum kind)kind, n);
            cost[i][kind] = c;
            table_row(name[kind], n, 2 * (n - 1) * (n + 1), c.numbers, c.flops,
                      c.solve);
        }
    table_end();
    table_begin("compare", "n band_entries entries entries_exponent band_flops "
                           "flops flops_exponent ratio");
    for (int i = 2; i < SIZES; i++) {
        const struct matrix_cost b = cost[i][BAND], d = cost[i][DISSECTION];
        const struct matrix_cost before = cost[i - 1][DISSECTION];
        table_row(2 << i, b.numbers, d.numbers,
                  log2(d.numbers / before.numbers), b.flops, d.flops,
                  log2(d.flops / before.flops), b.flops / d.flops);
    }
    table_end();
}

int main(void)
{
    struct matrix_cost cost[SIZES][KINDS];
    int crossover[3] = {0, 0, 0};
    print_costs(cost);
    for (int n = 64; n >= 2; n--) {
        const struct matrix_cost d = cost_of(DISSECTION, n);
        const struct matrix_cost b = cost_of(BAND, n);
        for (int k = 0; k < 3; k++)
            if (crossover[k] == 0 && part(d, k) >= part(b, k))
                crossover[k] = n + 1;
    }
    table_begin("crossovers", "entries flops solve");
    table_row(crossover[0], crossover[1], crossover[2]);
    table_end();

    const struct matrix_cost *end = cost[SIZES - 1], *half = cost[SIZES - 2];
    const double flops = log2(end[DISSECTION].flops / half[DISSECTION].flops);
    const double fill =
        log2(end[DISSECTION].numbers / half[DISSECTION].numbers);
    claim(fabs(log2(end[FULL].flops / half[FULL].flops) - 6.0) < 0.05 &&
              fabs(log2(end[BAND].flops / half[BAND].flops) - 4.0) < 0.05,
          "full n^6, band n^4");
    claim(fabs(flops - 3.0) < 0.15, "dissection n^3 (exponent %g)", flops);
    /* n^2 log n from 128 to 256: 2 + log2(8/7) = 2.19 */
    claim(fill > 2.0 && fill < 2.3, "entries n^2 log n (exponent %g)", fill);
    claim(crossover[1] > 15 && crossover[1] < 30,
          "fewer flops than the band from n = %d on", crossover[1]);
    return table_finish();
}
