/*
 * taylor.c - does a Taylor test tell a wrong stress from a wrong tangent?
 *
 * Remainders of Taylor's theorem along F + t D, and their slopes in t when P
 * and dP are the derivatives:
 *
 *     e[0] = |psi(t) - psi(0) - t P:D|                     2
 *     e[1] = |psi(t) - psi(0) - t P:D - t^2/2 D:dP(D)|     3
 *     e[2] = |P(t) - P(0) - t dP(D)|                       2
 *
 * for every law, and for the cubic law with a wrong stress (the adjugate where
 * the cofactor is due) and with a wrong tangent (that of rest).
 */
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static const mat2 direction = {{{0.613, -0.731}, {0.512, 0.8247}}};

enum slip { NONE, WRONG_STRESS, WRONG_TANGENT, N_SLIP };
#define COLUMNS "P dP pair wrongP_P wrongP_dP wrongP_pair " \
                "wrongdP_P wrongdP_dP wrongdP_pair"

struct triple {
    double psi;
    mat2 P, dP; /* one dimension: entry 11 */
};

static struct triple evaluate(int dimension, const struct material *m,
                              enum slip slip, double t)
{
    const double F1 = 0.7385 + t;
    const mat2 F = mat2_add(MATERIAL_STATE, mat2_scale(t, direction));
    if (dimension == 1)
        return (struct triple){material1_psi(m, F1),
                               {{{material1_pk1(m, F1), 0}, {0, 0}}},
                               {{{material1_dpk1(m, F1), 0}, {0, 0}}}};
    struct triple out = {material2_psi(m, F), material2_pk1(m, F), F};
    out.dP = material2_dpk1(m, slip == WRONG_TANGENT ? mat2_identity() :
                              F, direction);
    if (slip == WRONG_STRESS) { /* transpose all but mu F */
        const mat2 shear = mat2_scale(m->mu, F);
        out.P = mat2_add(shear, mat2_transpose(mat2_subtract(out.P, shear)));
    }
    return out;
}

static void remainders(int dimension, const struct material *m,
                       enum slip slip, double t, double e[3])
{
    const mat2 E = {{{1.0, 0.0}, {0.0, 0.0}}};
    const mat2 D = dimension == 1 ? E : direction;
    const struct triple here = evaluate(dimension, m, slip, 0.0);
    const struct triple there = evaluate(dimension, m, slip, t);
    const double first = there.psi - here.psi - t * mat2_dot(here.P, D);
    e[0] = fabs(first);
    e[1] = fabs(first - 0.5 * t * t * mat2_dot(D, here.dP));
    e[2] = mat2_norm(mat2_subtract(mat2_subtract(there.P, here.P),
                                   mat2_scale(t, here.dP)));
}

/* t = 2^-2 ... 2^-10, slopes between the last two: NAN where there is nothing
 * but round-off, below 1e-9 t of the modulus. */
enum { COARSE = 2, FINE = 10 };
static void slopes(int dimension, const struct material *m, enum slip slip,
                   double slope[])
{
    const double t = ldexp(1.0, -FINE);
    double coarse[3], fine[3];
    remainders(dimension, m, slip, 2.0 * t, coarse);
    remainders(dimension, m, slip, t, fine);
    const double round_off = 1e-9 * t * material_modulus(m);
    for (int k = 0; k < 3; k++)
        slope[k] = fine[k] > round_off ? study_order(coarse[k], fine[k], 2.0)
                                       : (double)NAN;
}

int main(void)
{
    static const double due[] = {2, 3, 2, 1, 1, 1, 2, 2, 1};
    const struct material cubic = material_notes(CUBIC);
    double e[1 + 3 * N_SLIP], slope[3 * N_SLIP], worst = 0.0;
    int exact = 0;

    table_begin("slopes", "dimension law P dP pair");
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int law = LINEAR; law <= CUBIC; law++) {
            const struct material m = material_notes((enum law)law);
            slopes(dimension, &m, NONE, slope);
            for (int k = 0; k < 3; k++) {
                exact += isnan(slope[k]);
                if (!isnan(slope[k]))
                    worst = fmax(worst, fabs(slope[k] - due[k]));
            }
            table_row(dimension, material_law(m.law),
                      cell_if(slope[0] > 0.0, slope[0]),
                      cell_if(slope[1] > 0.0, slope[1]),
                      cell_if(slope[2] > 0.0, slope[2]));
        }
    table_end();
    table_begin("taylor", "t " COLUMNS);
    for (int k = COARSE; k <= FINE; k++) {
        e[0] = ldexp(1.0, -k);
        for (int slip = NONE; slip < N_SLIP; slip++)
            remainders(2, &cubic, (enum slip)slip, e[0], e + 1 + 3 * slip);
        table_row_of(1 + 3 * N_SLIP, e);
    }
    table_end();
    table_begin("taylor_slopes", COLUMNS);
    for (int slip = NONE; slip < N_SLIP; slip++)
        slopes(2, &cubic, (enum slip)slip, slope + 3 * slip);
    table_row_of(3 * N_SLIP, slope);
    table_end();

    for (int k = 0; k < 3 * N_SLIP; k++)
        worst = fmax(worst, fabs(slope[k] - due[k]));
    claim(worst < 0.02 && exact == 4, "slopes 2 3 2, 1 1 1 with a wrong stress,"
          " 2 2 1 with a wrong tangent (to %g); 4 (%d) are round-off", worst,
          exact);
    return table_finish();
}
