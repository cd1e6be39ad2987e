/* swing.c - see swing.h. */
#include "swing.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

struct state swing_start(const struct body *body, double size)
{
    struct state s = state_make(2 * body->mesh->n_vertex);
    for (int a = 0; a < body->mesh->n_vertex; a++) {
        const double X = body->mesh->X[2 * a];
        if (body->equation[2 * a] < 0) continue;
        s.u[2 * a] = 0.4 * size * sin(M_PI * X);
        s.u[2 * a + 1] = size * cos(M_PI_2 * X);
    }
    return s;
}

double swing_norm(const struct model *model, const double v[])
{
    double *out = allocate((size_t)model->n_dof, sizeof *out), sum = 0.0;
    model_mass(model, v, out);
    for (int i = 0; i < model->n_dof; i++) sum += v[i] * out[i];
    free(out);
    return sqrt(sum);
}
