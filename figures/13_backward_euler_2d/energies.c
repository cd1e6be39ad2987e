/*
 * energies.c - what does backward Euler lose?
 *
 * Energy: of the square under gravity, n = 4, held on its left, with steps of
 * 1/30, 1/120 and 1/480 s; an exact motion would keep the total at 0.  Angular
 * momentum: of a free spin, n = 2, after one second; a rigid body that turns by
 * omega dt per step keeps 1 / sqrt(1 + 2 dt omega^2 t) of it [eq:spin-decay].
 * Tables: energies, spin.
 */
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <math.h>

enum { ROWS = 45 };

static void advance(struct scene *s, int n)
{
    const struct step_control newton = step_method("notes");
    for (int k = 0; k < n; k++)
        if (scene_step(s, &newton).status != OK)
            die("%s fails", scene_name(s->set.reading));
}

static double total(const struct scene_measures *m)
{
    return m->kinetic + m->elastic + m->external;
}

int main(void)
{
    struct scene_measures m[3][ROWS + 1];
    double gain = -INFINITY, total_left[3], miss = 0.0, momentum = 0.0;

    gsl_set_error_handler_off();
    for (int k = 0; k < 3; k++) {
        const int each = 1 << 2 * k; /* steps per row */
        struct scene_setting set = scene_notes(GRAVITY, CUBIC, 4);
        set.dt /= each;
        struct scene *s = scene_alloc(&set);
        m[k][0] = scene_measure(s);
        for (int row = 1; row <= ROWS; row++) {
            advance(s, each);
            m[k][row] = scene_measure(s);
            gain = fmax(gain, total(&m[k][row]) - total(&m[k][row - 1]));
        }
        total_left[k] = total(&m[k][ROWS]);
        scene_free(s);
    }
    table_begin("energies", "t kinetic elastic external total total_120 "
                            "total_480");
    for (int row = 0; row <= ROWS; row++)
        table_row(row / 30.0, m[0][row].kinetic, m[0][row].elastic,
                  m[0][row].external, total(&m[0][row]), total(&m[1][row]),
                  total(&m[2][row]));
    table_end();

    table_begin("spin", "dt angular predicted momentum_error");
    for (int rate = 30; rate <= 480; rate *= 2) {
        struct scene_setting set = scene_notes(SPIN, CUBIC, 2);
        set.dt = 1.0 / rate;
        struct scene *s = scene_alloc(&set);
        const struct scene_measures start = scene_measure(s);
        advance(s, rate);
        const struct scene_measures end = scene_measure(s);
        const double error = hypot(end.momentum[0] - start.momentum[0],
                                   end.momentum[1] - start.momentum[1]);
        /* that of the motion of the centre of mass, from the origin, is 0 */
        const double left = end.angular / start.angular;
        const double rigid =
            1.0 / sqrt(1.0 + 2.0 * set.dt * gsl_pow_2(set.spin));
        table_row(set.dt, left, rigid, error);
        momentum = fmax(momentum, error);
        miss = fmax(miss, fabs(left / rigid - 1.0));
        scene_free(s);
    }
    table_end();

    claim(gain < 1e-9, "the energy under gravity never grows (by %g J)", gain);
    claim(total_left[0] < total_left[1] && total_left[1] < total_left[2] &&
              total_left[2] < -1.0,
          "smaller steps eat the swing later (%g, %g, %g J)", total_left[0],
          total_left[1], total_left[2]);
    claim(miss < 0.01, "the spin decays as that of a rigid body, to 1 %% (%g)",
          miss);
    claim(momentum < 1e-8, "linear momentum is kept to round-off (%g)",
          momentum);
    return table_finish();
}
