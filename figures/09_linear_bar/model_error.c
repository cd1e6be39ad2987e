/*
 * model_error.c - at which strain, and at which load, is linear elasticity
 * enough?
 *
 * The relative error of the linear stress at a given strain e = F - 1, and of
 * the linear strain under a given load P [eq:model-error], against the log and
 * the cubic law at E = 1000, nu = 0.3; where they reach 1, 5 and 10 %; and the
 * slope (mu + 3/2 lambda) / (2 mu + lambda) of both for small strains.
 */
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

/* |M e / P - 1| or |P / (M e) - 1|, M = 2 mu + lambda, of a law at e != 0. */
enum error_of { STRESS, STRAIN };
static double model_error(const struct material *law, enum error_of what,
                          double e)
{
    const double linear = material_modulus(law) * e;
    const double P = material1_pk1(law, 1.0 + e);
    return fabs((what == STRESS ? linear / P : P / linear) - 1.0);
}

struct level {
    const struct material *law;
    enum error_of what;
    double sign, error; /* tension +1, compression -1 */
};

static double above_level(double size, void *context)
{
    const struct level *l = context;
    return model_error(l->law, l->what, l->sign * size) - l->error;
}

/* The strain at which an error is reached; it grows with |e| as far as 0.4, and
 * is beyond 10 % there. */
static double strain_at(const struct material *law, enum error_of what,
                        double sign, double error)
{
    struct level level = {law, what, sign, error};
    return sign * study_root(above_level, &level, 1e-5, 0.4);
}

/* Both errors of both laws, log and cubic; returned is how far the stress
 * errors of the smallest strain are from slope |e|. */
static double print_errors(const struct material law[2], double slope)
{
    double off = 0.0;

    table_begin("model_error", "e stress_t stress_c cubic_t cubic_c load_t "
                               "strain_t load_c strain_c cubic_load_t "
                               "cubic_strain_t cubic_load_c cubic_strain_c");
    for (int k = 0; k <= 24; k++) {
        const double e = 0.001 * pow(500.0, k / 24.0);
        double error[2][2]; /* [log, cubic][tension, compression] */
        for (int l = 0; l < 2; l++)
            for (int t = 0; t < 2; t++) {
                error[l][t] = model_error(&law[l], STRESS, t ? -e : e);
                if (k == 0)
                    off = fmax(off, fabs(error[l][t] / (slope * e) - 1.0));
            }
        table_row(e, error[0][0], error[0][1], error[1][0], error[1][1],
                  material1_pk1(&law[0], 1.0 + e),
                  model_error(&law[0], STRAIN, e),
                  -material1_pk1(&law[0], 1.0 - e),
                  model_error(&law[0], STRAIN, -e),
                  material1_pk1(&law[1], 1.0 + e),
                  model_error(&law[1], STRAIN, e),
                  -material1_pk1(&law[1], 1.0 - e),
                  model_error(&law[1], STRAIN, -e));
    }
    table_end();
    return off;
}

int main(void)
{
    const struct material law[] = {material_notes(LOG), material_notes(CUBIC)};
    const double modulus = material_modulus(&law[0]);
    const double slope = (law[0].mu + 1.5 * law[0].lambda) / modulus;
    const double errors[] = {0.01, 0.05, 0.10};
    int farther[2] = {1, 1};

    const double off = print_errors(law, slope);
    table_begin_note("thresholds",
                     "law percent strain_t strain_c load_t load_c",
                     "strain: stress error; load: strain error");
    for (int l = 0; l < 2; l++)
        for (int k = 0; k < 3; k++) {
            const double error = errors[k];
            double strain[2], load[2];
            for (int t = 0; t < 2; t++) {
                const double sign = t ? -1.0 : 1.0;
                strain[t] = strain_at(&law[l], STRESS, sign, error);
                load[t] = material1_pk1(
                    &law[l], 1.0 + strain_at(&law[l], STRAIN, sign, error));
            }
            table_row(material_law(law[l].law), 100.0 * error, strain[0],
                      strain[1], load[0], load[1]);
            farther[l] &= (strain[0] > -strain[1]) == (l == 0) &&
                          (load[0] > -load[1]) == (l == 0) &&
                          (strain[0] - error / slope) *
                                  (-strain[1] - error / slope) < 0.0;
        }
    table_end();
    table_begin("leading", "slope modulus");
    table_row(slope, modulus);
    table_end();

    claim(off < 2e-3, "at e = 0.001 all four errors are %g e (to %g)", slope,
          off);
    claim(farther[0] && farther[1], "of each pair of thresholds one lies above "
          "the leading estimate and one below: tension may go further against "
          "the log law, compression against the cubic one");
    return table_finish();
}
