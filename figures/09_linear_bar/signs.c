/*
 * signs.c - what do the printed signs do to a bar?
 *
 * The modulus over nu, 2 mu + lambda [eq:bar-linear] and 2 mu - lambda as the
 * notes print it, in units of E, with E and nu back from mu and lambda
 * [eq:lame-inverse]; a bar of eight elements, one end held, pulled by +100 at
 * the other, with the printed modulus and with the printed sign of that load.
 */
#include "bar/bar_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>

enum { N = 8 };
static const double E = 1000.0, LOAD = 100.0;

/* 2 mu - lambda; what is only round-off is 0. */
static double printed_modulus(const struct material *m)
{
    const double value = 2.0 * m->mu - m->lambda;
    return fabs(value) <= 8.0 * DBL_EPSILON * material_modulus(m) ? 0.0 : value;
}

/* u[0..N] of the bar of this modulus, pulled at one end. */
static enum status pulled(double modulus, int end, double load, double u[])
{
    struct bar_scene scene = {.n = N, .material = {LINEAR, 0.5 * modulus, 0.0}};
    scene.held[!end] = 1;
    scene.pull[end] = load;
    struct newton_control control = bar_scene_control(&scene);
    control.definite = 1; /* as Cholesky, stop where K is not */
    struct bar_state *state = bar_scene_solve(&scene, &control);
    const enum status status = state->report.status;
    for (int i = 0; i <= N; i++) u[i] = state->u[i];
    bar_state_free(state);
    return status;
}

int main(void)
{
    const double nu[] = {0.3, 1.0 / 3.0, 0.4};
    const struct material notes = material_notes(LINEAR);
    double u[N + 1], u_printed[N + 1], back = 0.0, soft = 0.0, least = INFINITY;
    double pulled_by = 0.0;
    int not_spd = 1;

    table_begin("moduli", "nu mu lambda modulus printed E_back nu_back");
    for (int k = 0; k <= 49; k++) {
        const struct material m = material_make(LINEAR, E, 0.01 * k);
        const double sum = m.lambda + m.mu, modulus = material_modulus(&m);
        const double E_back = m.mu * (3.0 * m.lambda + 2.0 * m.mu) / sum;
        const double nu_back = 0.5 * m.lambda / sum;
        table_row(0.01 * k, m.mu / E, m.lambda / E, modulus / E,
                  printed_modulus(&m) / E, E_back / E, nu_back);
        least = fmin(least, modulus / E);
        back = fmax(back, fabs(E_back / E - 1.0) + fabs(nu_back - 0.01 * k));
    }
    table_end();

    table_begin("printed_modulus",
                "nu modulus printed u_end status u_printed");
    for (int k = 0; k < 3; k++) {
        const struct material m = material_make(LINEAR, E, nu[k]);
        const double right = material_modulus(&m), wrong = printed_modulus(&m);
        if (pulled(right, 1, LOAD, u) != OK) die("the right bar has no answer");
        const enum status status = pulled(wrong, 1, LOAD, u_printed);
        table_row(nu[k], right, wrong, u[N], status_name(status),
                  cell_if(status == OK, u_printed[N]));
        if (k == 0) soft = u_printed[N] / u[N];
        else not_spd &= status == NOT_SPD;
    }
    table_end();

    table_begin("end_loads", "end X u u_printed");
    for (int end = 0; end <= 1; end++) {
        if (pulled(material_modulus(&notes), end, LOAD, u) != OK ||
            pulled(material_modulus(&notes), end, -LOAD, u_printed) != OK)
            die("the bar has no answer");
        for (int i = 0; i <= N; i++)
            table_row(end ? "right" : "left", i / (double)N, u[i],
                      u_printed[i]);
        pulled_by = fmax(pulled_by, fabs(u[end * N] - 0.0742857));
    }
    table_end();

    claim(least > 1.0 - 1e-14 && back < 1e-12, "2 mu + lambda is never below E "
          "(%g E), and E and nu come back (off by %g)", least, back);
    claim(fabs(soft - 7.0) < 1e-9 && not_spd, "the printed modulus makes the "
          "bar 7 times too soft at nu = 0.3 (%g), and K not positive definite "
          "from nu = 1/3 on", soft);
    claim(pulled_by < 1e-7, "+100 moves either end by +0.0742857 (off by %g)",
          pulled_by);
    return table_finish();
}
