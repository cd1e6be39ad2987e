/* particle_price.c - see particle_price.h. */
#include "particle_price.h"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

double particle_price(const double e[], const double flops[], int sizes,
                      double wanted)
{
    for (int i = 1; i < sizes; i++)
        if (e[i - 1] >= wanted && e[i] < wanted)
            return flops[i] * pow(flops[i - 1] / flops[i],
                                  log(wanted / e[i]) / log(e[i - 1] / e[i]));
    return NAN;
}

void particle_prices(double e[4][3], double flops[4][3])
{
    static const double wanted[] = {0.04, 0.03, 0.02, 0.014, 0.01, 0.0075};
    double last = INFINITY;
    table_begin("price_sixteen", "wanted linear quadratic cubic");
    for (int i = 0; i < COUNT(wanted); i++) {
        const double base = particle_price(e[0], flops[0], 3, wanted[i]);
        const double linear =
            particle_price(e[1], flops[1], 3, wanted[i]) / base;
        const double quadratic =
            particle_price(e[2], flops[2], 3, wanted[i]) / base;
        const double cubic =
            particle_price(e[3], flops[3], 3, wanted[i]) / base;
        table_row(wanted[i], cell_if(isfinite(linear), linear), quadratic,
                  cubic);
        claim(wanted[i] < 0.02 ? isnan(linear)
                               : linear > 6.0 && linear < 10.5, "linear "
              "kernels cost 7 to 10 times as much down to 0.02, and reach "
              "nothing smaller (%g: %g)", wanted[i], linear);
        claim(fabs(quadratic - 36.5) < 2.0, "quadratic kernels cost 35 to 38 "
              "times as much at every error (%g: %g)", wanted[i], quadratic);
        claim(cubic < last, "cubic ones less and less (%g: %g)", wanted[i],
              cubic);
        last = cubic;
    }
    table_end();
    const double times = particle_price(e[1], flops[1], 3, 0.02) /
                         particle_price(e[0], flops[0], 3, 0.02);
    claim(fabs(times - 10.0) < 0.5, "for 0.02 linear kernels cost 10 times as "
          "much (%g)", times);
}
