/*
 * map.c - where has dP/dF negative eigenvalues, and how many?
 *
 * Tables: their number over the two singular values, both laws; where twist and
 * flip change sign.  P' of uniaxial strain says nothing of it.
 */
#include "material/modes.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static int negative(const struct material *material, double s1, double s2)
{
    const mat2 S = {{{s1, 0.0}, {0.0, s2}}};
    const struct modes modes = modes_at(material, S);
    int count = 0;
    for (int m = 0; m < 4; m++) count += modes.value[m] < 0.0;
    return count;
}

/* The factor of a mode at S = diag(J, 1). */
struct factor {
    struct material material;
    enum mode mode;
};
static double factor(double J, void *context)
{
    const struct factor *f = context;
    const mat2 S = {{{J, 0.0}, {0.0, 1.0}}};
    return modes_at(&f->material, S).value[f->mode];
}

static double line_slope(double J, void *context)
{
    return material1_dpk1(&((struct factor *)context)->material, J);
}

/* A table of the law's name: at s1, from s2 = low to high, how many eigenvalues
 * are negative.  Returns the largest number. */
static int print_map(const struct material *material)
{
    const double step = 0.005;
    int most = 0;
    table_begin(material_law(material->law), "s1 low high negative");
    for (int i = 0; i < 200; i++) {
        const double s1 = 0.015 * (i + 0.5);
        int j = material->law == LOG ? 0 : -200;
        while (j < 600) {
            const int from = j;
            const int count = negative(material, s1, (j + 0.5) * step);
            while (j < 600 && negative(material, s1, (j + 0.5) * step) == count)
                j++;
            table_row(s1, from * step, j * step, count);
            if (count > most) most = count;
        }
    }
    table_end();
    return most;
}

int main(void)
{
    const struct material cubic = material_notes(CUBIC);
    const struct material log = material_notes(LOG);
    const int most[2] = {print_map(&log), print_map(&cubic)};

    struct factor twist[2] = {{log, MODE_TWIST}, {cubic, MODE_TWIST}};
    struct factor flip = {cubic, MODE_FLIP};
    const double zero[2] = {study_root(factor, &twist[0], 0.5, 1.5),
                            study_root(factor, &twist[1], 0.5, 1.5)};
    const double high = study_root(factor, &flip, 1.5, 3.0);
    table_begin("signs", "mode law J");
    table_row("twist", "log", zero[0]);
    table_row("twist", "cubic", zero[1]);
    table_row("flip", "cubic", high);
    table_end();

    double worst = -INFINITY, least[2] = {INFINITY, INFINITY};
    const double nu[] = {0.02, 0.1, 0.3, 0.45, 0.49};
    for (int k = 0; k < 5; k++) {
        struct factor of_log = {material_make(LOG, 1000.0, nu[k]),
                                MODE_TWIST};
        struct factor of_cubic = {material_make(CUBIC, 1000.0, nu[k]),
                                  MODE_TWIST};
        for (double J = 0.02; J < 0.999; J += 0.02) {
            worst = fmax(worst, factor(J, &of_log));
            worst = fmax(worst, factor(J, &of_cubic));
        }
    }
    for (int k = 0; k < 2; k++) {
        struct factor f = {material_make(CUBIC, 1000.0, k ? 0.0713 : 0.0711),
                           MODE_TWIST};
        for (double J = 0.0; J < 3.0; J += 1e-3)
            least[k] = fmin(least[k], line_slope(J, &f));
    }

    claim(fabs(zero[0] - 1.0) < 1e-12 && fabs(zero[1] - 1.0) < 1e-12,
          "the twist changes sign at J = 1 (%.15g, %.15g)", zero[0], zero[1]);
    claim(fabs(high - 2.2787454179357534) < 1e-12,
          "the flip of the cubic law changes sign at J = %.15g", high);
    claim(worst < 0.0, "the twist is negative for every J < 1, in both laws, "
          "for nu from 0.02 to 0.49 (largest %g)", worst);
    claim(least[0] < 0.0 && least[1] > 0.0, "P' of uniaxial strain is positive "
          "for nu > 0.0712: least %g at 0.0711, %g at 0.0713", least[0],
          least[1]);
    claim(most[0] == 1 && most[1] == 2, "at most %d negative with the log law, "
          "%d with the cubic one", most[0], most[1]);
    return table_finish();
}
