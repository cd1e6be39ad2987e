/*
 * damping.c - how fast does a method take the energy out of a linear bar?
 *
 * The bar of 16 elements in its first mode, frame by frame of 1/30 s; the
 * number behind a method is its steps per frame.  Expected of backward Euler:
 * 1 / (1 + omega^2 dt^2) per step, omega of the continuous bar
 * [eq:amplification].
 */
#include "motion/integrate.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { N_RUN = 7, N = 16, FRAMES = 20 };

static const struct {
    enum method method;
    int per_frame;
} kind[N_RUN] = {{BACKWARD_EULER, 1},    {BACKWARD_EULER, 16},
                 {BACKWARD_EULER, 256},  {BDF2, 1},
                 {BDF2, 16},             {IMPLICIT_MIDPOINT, 1},
                 {SYMPLECTIC_EULER, 64}};

int main(void)
{
    const struct material material = material_notes(LINEAR);
    const double omega = M_PI_2 * sqrt(material_modulus(&material));
    struct model *model[N_RUN];
    struct state s[N_RUN];
    double start = 0.0, E[1 + N_RUN], drift = 0.0, wrong = 0.0;

    for (int r = 0; r < N_RUN; r++) {
        model[r] = model_bar(N, CONSISTENT);
        s[r] = state_make(N);
        for (int i = 0; i < N; i++) s[r].u[i] = sin(M_PI_2 * (i + 1) / N);
        start = model_energy(model[r], s[r].u, s[r].v);
    }
    table_begin("first_mode", "omega");
    table_row(omega);
    table_end();
    table_begin("damping", "t backward_1 backward_16 backward_256 bdf2_1 "
                           "bdf2_16 midpoint_1 symplectic_64");
    for (int k = 0; k <= FRAMES; k++) {
        E[0] = k / 30.0;
        for (int r = 0; r < N_RUN; r++) {
            E[1 + r] = model_energy(model[r], s[r].u, s[r].v) / start;
            for (int j = 0; j < kind[r].per_frame; j++)
                integrate_step(model[r], kind[r].method,
                               1.0 / 30.0 / kind[r].per_frame, NULL, &s[r]);
        }
        table_row_of(1 + N_RUN, E);
        drift = fmax(drift, fabs(E[6] - 1.0));
    }
    table_end();
    for (int r = 0; r < N_RUN; r++) {
        state_free(&s[r]);
        model_free(model[r]);
    }

    for (int r = 0; r < 3; r++) {
        const int per_frame = kind[r].per_frame;
        const double z = omega / 30.0 / per_frame;
        const double due = -FRAMES * per_frame * log1p(z * z);
        wrong = fmax(wrong, fabs(log(E[1 + r]) / due - 1.0));
    }
    claim(wrong < 2e-3, "the logarithm of what backward Euler leaves is that "
          "of (1 + omega^2 dt^2)^-k to 0.2 %% (it is off by %g)", wrong);
    claim(drift < 1e-10, "the midpoint rule keeps the energy (it drifts by %g)",
          drift);
    claim(E[4] > E[1] && E[4] < 0.1, "with a step per frame BDF2 takes less "
          "than backward Euler, and yet most of it (%g and %g are left)", E[4],
          E[1]);
    return table_finish();
}
