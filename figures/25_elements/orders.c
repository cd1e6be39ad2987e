/*
 * orders.c - does the exponent of the corner predict how fast elements of
 * degree k on a mesh that is graded with m converge?
 *
 * 2 min(k, p m) with p of material_corner(), in six cases.  Tables: the error
 * at the vertices that all meshes have, against the limit; the prediction
 * beside the last order; and how quadratic triangles with a larger m go on, of
 * which nothing is proved.  The limit is extrapolated, since that of n = 128
 * alone hides up to a tenth of the smallest errors.
 */
#include "hang.h"

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"
#include "material/material.h"

#include <math.h>

static const char *const word[] = HANG_WORDS;
static const struct {
    enum hang_element element;
    double m;
    int last; /* n */
} kind[] = {{HANG_LINEAR, 1.0, 128}, {HANG_LINEAR, 1.5, 128},
            {HANG_QUADRATIC, 1.0, 32}, {HANG_QUADRATIC, 1.5, 32},
            {HANG_QUADRATIC, 2.0, 32}, {HANG_CROSSED, 1.0, 32}};
enum { KINDS = COUNT(kind) };

int main(void)
{
    const struct material material = material_make(CUBIC, 1000.0, 0.3);
    const double p = material_corner(&material);
    const struct hang limit = hang_limit(0.3);
    double order[KINDS], predicted[KINDS];

    table_begin("error", "element m n error order");
    for (int k = 0; k < KINDS; k++) {
        double before = NAN;
        for (int n = 8; n <= kind[k].last; n *= 2) {
            const struct hang hang =
                hang_of(kind[k].element, n, kind[k].m, 0.3);
            const double error = hang_apart(&hang, &limit);
            order[k] = study_order(before, error, 2.0);
            table_row(word[kind[k].element], kind[k].m, n,
                      cell_rounded(5, error),
                      n > 8 ? cell_rounded(4, order[k]) : cell_word(MISSING));
            before = error;
        }
    }
    table_end();
    table_begin("orders", "element m predicted observed n");
    for (int k = 0; k < KINDS; k++) {
        const int degree = kind[k].element == HANG_QUADRATIC ? 2 : 1;
        predicted[k] = 2.0 * fmin(degree, p * kind[k].m);
        table_row(word[kind[k].element], kind[k].m, predicted[k],
                  cell_rounded(4, order[k]), kind[k].last);
    }
    table_end();
    table_begin("steeper", "m predicted order_16 order_32 order_64");
    for (double m = 2.0; m <= 3.0; m += 0.5) {
        const double expected = 2.0 * fmin(2.0, p * m);
        double error[4], seen[4] = {NAN};
        for (int j = 0; j < 4; j++) {
            const struct hang hang = hang_of(HANG_QUADRATIC, 8 << j, m, 0.3);
            error[j] = hang_apart(&hang, &limit);
            if (j) seen[j] = study_order(error[j - 1], error[j], 2.0);
        }
        table_row(m, expected, cell_rounded(3, seen[1]),
                  cell_rounded(3, seen[2]), cell_rounded(3, seen[3]));
        claim(seen[1] < seen[2] && seen[2] < seen[3] &&
                  (m > 2.0 ? seen[3] > 3.0 && seen[3] < expected - 0.2
                           : fabs(seen[3] - expected) < 0.07),
              "quadratic triangles, m = %g: the orders rise, with m = 2 nearly "
              "to the prediction (%g), above it beyond 3, but not so far (%g)",
              m, expected, seen[3]);
    }
    table_end();
    for (int k = 0; k < KINDS; k++)
        claim(fabs(order[k] - predicted[k]) < 0.15,
              "%s triangles, m = %g: the order is within 0.15 of %g (%g)",
              word[kind[k].element], kind[k].m, predicted[k], order[k]);
    return table_finish();
}
