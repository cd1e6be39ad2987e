/*
 * cat.c - which method keeps areas in the phase plane of one mode?
 *
 * Arnold's cat, a polygon of points (u, v / omega), which every step maps;
 * omega dt = 1/2.  Expected area over that of the start: 1, and
 * (1 + omega^2 dt^2)^-k for backward Euler.
 */
#include "motion/integrate.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { POINTS = 29, SHOWN = 9, EVERY = 3 };

static const double cat[POINTS][2] = {
    {-0.38, 0.56}, {-0.42, 0.90}, {-0.24, 0.76}, {-0.06, 0.76}, {0.12, 0.90},
    {0.08, 0.56},  {0.04, 0.42},  {0.20, 0.26},  {0.28, 0.02},  {0.28, -0.26},
    {0.44, -0.32}, {0.60, -0.28}, {0.70, -0.14}, {0.72, 0.06},  {0.64, 0.24},
    {0.74, 0.30},  {0.88, 0.08},  {0.84, -0.22}, {0.66, -0.44}, {0.40, -0.50},
    {0.10, -0.50}, {-0.10, -0.50}, {-0.42, -0.50}, {-0.46, -0.40},
    {-0.36, -0.24}, {-0.44, 0.04}, {-0.44, 0.26}, {-0.34, 0.42},
    {-0.40, 0.50}};

/* Of the polygon through the states. */
static double area(const struct state s[])
{
    double twice = 0.0;
    for (int i = 0; i < POINTS; i++) {
        const struct state *a = &s[i], *b = &s[(i + 1) % POINTS];
        twice += a->u[0] * b->v[0] - b->u[0] * a->v[0];
    }
    return 0.5 * fabs(twice);
}

/* The outline every three steps; what is left of the area at the end. */
static double map_cat(enum method method, double z)
{
    struct model *model = model_mode(1.0);
    struct state s[POINTS];
    double left = 1.0;
    for (int i = 0; i < POINTS; i++) {
        s[i] = state_make(1);
        s[i].u[0] = 0.95 + 0.5 * cat[i][0];
        s[i].v[0] = 0.5 * cat[i][1];
    }
    const double start = area(s);
    for (int k = 0; k <= SHOWN; k++) {
        left = area(s) / start;
        for (int i = 0; i <= POINTS && k % EVERY == 0; i++)
            table_row(method_name(method), k, s[i % POINTS].u[0],
                      s[i % POINTS].v[0], left);
        for (int i = 0; i < POINTS; i++)
            integrate_step(model, method, z, NULL, &s[i]);
    }
    for (int i = 0; i < POINTS; i++) state_free(&s[i]);
    model_free(model);
    return left;
}

int main(void)
{
    const double z = 0.5, due = pow(1.0 + z * z, -SHOWN);
    double left[N_METHOD];
    table_begin("cat", "method k u v area");
    for (int m = 0; m < N_METHOD; m++)
        left[m] = map_cat((enum method)m, z);
    table_end();

    const double flat = fmax(fabs(left[SYMPLECTIC_EULER] - 1.0),
                             fabs(left[IMPLICIT_MIDPOINT] - 1.0));
    claim(flat < 1e-12, "symplectic Euler and the midpoint rule keep the area "
          "of the cat (to %g)", flat);
    claim(fabs(left[BACKWARD_EULER] / due - 1.0) < 1e-12 && left[BDF2] < 0.9,
          "backward Euler leaves %g of it, as predicted, BDF2 %g", due,
          left[BDF2]);
    return table_finish();
}
