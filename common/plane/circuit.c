/* circuit.c - see circuit.h. */
#include "plane/circuit.h"

#include "base/status.h"

#include <gsl/gsl_integration.h>

double circuit_work(circuit_field *field, void *context, int n,
                    const double corner[])
{
    enum { POINTS = 24 };
    gsl_integration_glfixed_table *rule =
        gsl_integration_glfixed_table_alloc(POINTS);
    double sum = 0.0, s, weight, value[2];
    if (!rule) die("out of memory");
    for (int edge = 0; edge < n; edge++)
        for (size_t k = 0; k < POINTS; k++) {
            const double *a = &corner[2 * edge];
            const double *b = &corner[2 * ((edge + 1) % n)];
            const double step[2] = {b[0] - a[0], b[1] - a[1]};
            gsl_integration_glfixed_point(0.0, 1.0, k, &s, &weight, rule);
            field((const double[]){a[0] + s * step[0], a[1] + s * step[1]},
                  context, value);
            sum += weight * (value[0] * step[0] + value[1] * step[1]);
        }
    gsl_integration_glfixed_table_free(rule);
    return sum;
}
