/*
 * chart.c - speed against accuracy: how far is each cure after k linear solves?
 *
 * One element of the log law from rest under p = -1.5 (2 mu + lambda), beyond
 * the limit of plain Newton: the error of F when a cure may solve k linear
 * systems and no more.  Load stepping is measured at its last equilibrium.
 */
#include "element.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

struct load {
    struct material material;
    double p;
};

static double unbalanced(double F, void *context)
{
    const struct load *load = context;
    return material1_pk1(&load->material, F) - load->p;
}

int main(void)
{
    enum { MOST = 24 };
    const struct material m = material_notes(LOG);
    struct load load = {m, -1.5 * material_modulus(&m)};
    const double exact = study_root(unbalanced, &load, 1e-6, 1.0);
    double error[MOST + 1][N_CURE];
    const char *reason[N_CURE];

    table_begin_note("chart", "solves " CURES, "relative error of F");
    for (int k = 0; k <= MOST; k++) {
        struct newton_control control = {1e-10, k, 0, 0};
        double row[N_CURE + 1] = {k};
        for (int c = 0; c < N_CURE; c++) {
            const struct element_report end =
                element_cured((enum cure)c, m, load.p, 0.0, 1, control);
            error[k][c] = fabs(end.F - exact) / exact;
            row[c + 1] = error[k][c];
            reason[c] = status_name(end.status);
        }
        table_row_of(N_CURE + 1, row);
    }
    table_end();
    table_begin_note("chart_reasons", "linear " CURES,
                     "linear: the error of 1 + p / (2 mu + lambda)");
    table_row(fabs(1.0 + load.p / material_modulus(&m) - exact) / exact,
              reason[0], reason[1], reason[2], reason[3], reason[4]);
    table_end();

    /* quadratic: after three solves each doubles the digits, up to 1e-12 */
    for (int c = CURE_SEARCH; c <= CURE_START; c++)
        for (int k = 3; error[k][c] > 1e-12; k++)
            claim(error[k + 1][c] < 2.0 * error[k][c] * error[k][c] + 1e-15,
                  "after %d solves one more squares the error, of %g (it is "
                  "%g)", k, error[k][c], error[k + 1][c]);
    claim(error[MOST][CURE_STEPPING] < 1e-9, "load stepping arrives within %d "
          "solves (its error is %g)", MOST, error[MOST][CURE_STEPPING]);
    claim(fabs(error[MOST][CURE_CUBIC] - 0.25) < 0.01,
          "the cubic law converges to an answer that is 25 %% off (%g)",
          error[MOST][CURE_CUBIC]);
    return table_finish();
}
