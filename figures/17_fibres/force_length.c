/*
 * force_length.c - how short does a muscle get, and how much of the model does
 * that take?
 *
 * A strip along its fibres, free to contract: P = 0 in F = diag(l, w).  Four
 * models: the material linear or cubic, the fibre a cord whose tension is that
 * of l = 1, or a muscle with its force-length curve.  Tables: the lengths
 * against activation, and the activation up to which each model is within one
 * per cent of the fullest; errors at full activation, of length and shortening.
 */
#include "plane/fibre.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { LINEAR_CORD, CUBIC_CORD, LINEAR_MUSCLE, CUBIC_MUSCLE, MODELS };
static const char *const name[] = {"linear cord", "cubic cord", "linear muscle",
                                   "cubic muscle"};

struct strip {
    struct material material;
    struct fibre fibre;
    double l;
};

static mat2 stress(const struct strip *s, double w)
{
    const double along[2] = {1.0, 0.0};
    const mat2 F = {{{s->l, 0.0}, {0.0, w}}};
    return mat2_add(material2_pk1(&s->material, F),
                    fibre_pk1(&s->fibre, along, F));
}

static double P22(double w, void *context)
{
    return stress(context, w).m[1][1];
}

/* P11 of the length l, with the width that P22 = 0 asks for. */
static double P11(double l, void *context)
{
    struct strip *s = context;
    s->l = l;
    return stress(s, study_root(P22, s, 0.5, 2.0)).m[0][0];
}

static struct strip strip_of(int model, double activation)
{
    struct strip s = {material_notes(model % 2 ? CUBIC : LINEAR),
                      fibre_muscle(activation), 1.0};
    if (model < LINEAR_MUSCLE) {
        s.fibre.law = CORD;
        s.fibre.k = 0.0; /* T' at l = 1 */
    }
    return s;
}

static double length(int model, double activation)
{
    struct strip s = strip_of(model, activation);
    return activation > 0.0 ? study_root(P11, &s, 0.6, 1.0) : 1.0;
}

/* How far a model is off, minus one per cent. */
static double beyond(double activation, void *context)
{
    const int model = *(const int *)context;
    return fabs(length(model, activation) / length(CUBIC_MUSCLE, activation) -
                1.0) - 0.01;
}

int main(void)
{
    double limit[MODELS] = {0.0}, shorter[MODELS];
    table_begin("length", "activation linear_cord cubic_cord linear_muscle "
                          "cubic_muscle");
    for (int i = 0; i <= 40; i++)
        table_row(i / 40.0, length(LINEAR_CORD, i / 40.0),
                  length(CUBIC_CORD, i / 40.0), length(LINEAR_MUSCLE, i / 40.0),
                  length(CUBIC_MUSCLE, i / 40.0));
    table_end();
    table_begin("least", "model activation length error_at_1 shortening_at_1");
    for (int m = 0; m < MODELS; m++) {
        const double one = 1.0, truth = length(CUBIC_MUSCLE, one);
        const double error = length(m, one) / truth - 1.0;
        const int crosses = fabs(error) > 0.01;
        if (crosses) limit[m] = study_root(beyond, &m, 0.01, one);
        shorter[m] = (1.0 - length(m, one)) / (1.0 - truth) - 1.0;
        table_row(name[m], cell_if(crosses, limit[m]),
                  cell_if(crosses, length(CUBIC_MUSCLE, limit[m])), error,
                  shorter[m]);
    }
    table_end();
    claim(fabs(length(CUBIC_MUSCLE, 1.0) - 0.807570777793) < 1e-11,
          "at full activation the strip has 0.8076 of its length (%.12f)",
          length(CUBIC_MUSCLE, 1.0));
    claim(fabs(limit[LINEAR_CORD] - 0.34) < 0.01 &&
              fabs(limit[LINEAR_MUSCLE] - 0.42) < 0.01 &&
              fabs(limit[CUBIC_CORD] - 0.59) < 0.01,
          "one per cent: the linear model up to an activation of 0.34 (%.4f), "
          "with the curve alone 0.42 (%.4f), with the cubic law alone 0.59 "
          "(%.4f)", limit[LINEAR_CORD], limit[LINEAR_MUSCLE],
          limit[CUBIC_CORD]);
    claim(fabs(shorter[LINEAR_CORD] - 0.42) < 0.005 &&
              fabs(shorter[CUBIC_CORD] - 0.14) < 0.005 &&
              fabs(shorter[LINEAR_MUSCLE] - 0.14) < 0.005,
          "of the shortening that is 42 (%.4f), 14 (%.4f) and 14 %% (%.4f)",
          shorter[LINEAR_CORD], shorter[CUBIC_CORD], shorter[LINEAR_MUSCLE]);
    return table_finish();
}
