/*
 * small_strain.c - what do the laws agree on, and where does the linear law
 * stop?
 *
 * Tables: the moduli that all share; (P_linear / P - 1) / e at F = 1 + e in one
 * dimension, which tends to (mu + 3/2 lambda) / (2 mu + lambda) for both curved
 * laws; and what a rotation by 30 degrees costs.
 */
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

/* By how much the linear law is off at F = 1 + e, over e. */
static double error_of_linear(enum law law, double e)
{
    const struct material bent = material_notes(law);
    const struct material straight = material_notes(LINEAR);
    return (material1_pk1(&straight, 1.0 + e) / material1_pk1(&bent, 1.0 + e) -
            1.0) / e;
}

/* psi and P11: of the rotation Q alone; objectivity: |P(Q F) - Q P(F)| and
 * asymmetry: |P12' - P21'| of P' = P F^T, at MATERIAL_STATE. */
struct rotation {
    double psi, P11, objectivity, asymmetry;
};
static struct rotation rotate(enum law law)
{
    const struct material m = material_notes(law);
    const mat2 Q = mat2_rotation(M_PI / 6.0), F = MATERIAL_STATE;
    const mat2 P = material2_pk1(&m, F);
    const mat2 turned = material2_pk1(&m, mat2_multiply(Q, F));
    const mat2 PFt = mat2_multiply(P, mat2_transpose(F));
    return (struct rotation){
        material2_psi(&m, Q), material2_pk1(&m, Q).m[0][0],
        mat2_norm(mat2_subtract(turned, mat2_multiply(Q, P))),
        fabs(PFt.m[0][1] - PFt.m[1][0])};
}

int main(void)
{
    const struct material m = material_notes(LINEAR);
    const double modulus = material_modulus(&m), cosine = sqrt(0.75) - 1.0;
    const double limit = (m.mu + 1.5 * m.lambda) / modulus;
    double ratio[2] = {0.0, 0.0};
    struct rotation r[CUBIC + 1];

    table_begin_note("moduli", "E nu mu lambda modulus",
                     "modulus = 2 mu + lambda, of a bar that cannot thin");
    table_row(1000.0, 0.3, m.mu, m.lambda, modulus);
    table_end();
    table_begin("small_strain", "e log cubic");
    for (int k = 1; k <= 4; k++) {
        const double e = gsl_pow_int(10.0, -k);
        for (int law = LOG; law <= CUBIC; law++)
            ratio[law - LOG] = error_of_linear((enum law)law, e);
        table_row(e, ratio[0], ratio[1]);
    }
    table_end();
    table_begin("rotation", "law psi P11 objectivity asymmetry");
    for (int law = LINEAR; law <= CUBIC; law++) {
        r[law] = rotate((enum law)law);
        table_row(material_law((enum law)law), r[law].psi, r[law].P11,
                  r[law].objectivity, r[law].asymmetry);
    }
    table_end();

    claim(fabs(ratio[0] / limit - 1.0) < 1e-3 &&
              fabs(ratio[1] / limit - 1.0) < 1e-3,
          "near rest the linear law is off by %g (F - 1), by %g and %g at "
          "F = 1.0001", limit, ratio[0], ratio[1]);
    for (int law = LOG; law <= CUBIC; law++)
        claim(fabs(r[law].psi) + fabs(r[law].P11) + r[law].objectivity +
                      r[law].asymmetry < 1e-11 * modulus,
              "a rotation costs the %s law nothing",
              material_law((enum law)law));
    claim(fabs(r[LINEAR].P11 / (2.0 * (m.mu + m.lambda) * cosine) - 1.0) <
                  1e-12 &&
              fabs(r[LINEAR].psi / (2.0 * (m.mu + m.lambda) * cosine * cosine) -
                   1.0) < 1e-12,
          "the linear law takes it for a strain of cos 30 - 1");
    return table_finish();
}
