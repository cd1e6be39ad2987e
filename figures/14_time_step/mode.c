/*
 * mode.c - what does a method make of a single mode: what a frame of backward
 * Euler leaves, the path of each method, and its order with its constant?
 *
 * u'' = -u and dt = omega dt; error after omega T = 2.385 in the norm
 * (u^2 + v^2 / omega^2)^(1/2), over the leading coefficient of (omega dt)^p
 * that it should have [eq:mode-constants].
 */
#include "motion/integrate.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { STEPS = 40 };

/* Backward Euler, M = 1, u = 1, v = 0: what a push f leaves in a frame. */
static void claim_one_frame(void)
{
    static const double stiffness[] = {0.0, 100.0, 2385.0};
    const double dt = 1.0 / 30.0;
    double wrong = 0.0;
    for (int pushed = 0; pushed < 2; pushed++)
        for (int k = 0; k < 3; k++) {
            const double K = stiffness[k], f = pushed ? 371.4 : 0.0;
            struct model *model = model_mode(sqrt(K));
            struct state s = state_make(1);
            s.u[0] = 1.0;
            model->f[0] = f;
            integrate_step(model, BACKWARD_EULER, dt, NULL, &s);
            wrong = fmax(wrong, fabs(s.u[0] - (1.0 + dt * dt * f) /
                                                  (1.0 + dt * dt * K)));
            state_free(&s);
            model_free(model);
        }
    claim(wrong < 1e-12, "a frame ends at (u0 + dt^2 f) / (1 + dt^2 K) with "
          "M = 1, v0 = 0 (it is off by %g)", wrong);
}

/* Step by step from u = 1, v = 0; velocities in units of omega. */
static void print_path(double w_dt)
{
    struct model *model = model_mode(1.0);
    struct state s[N_METHOD];
    for (int m = 0; m < N_METHOD; m++) {
        s[m] = state_make(1);
        s[m].u[0] = 1.0;
    }
    table_begin("mode", "k exact symplectic_u symplectic_v backward_u "
                        "backward_v midpoint_u midpoint_v bdf2_u bdf2_v");
    for (int k = 0; k <= STEPS; k++) {
        table_row(k, cos(k * w_dt), s[0].u[0], s[0].v[0], s[1].u[0], s[1].v[0],
                  s[2].u[0], s[2].v[0], s[3].u[0], s[3].v[0]);
        if (k == STEPS) break;
        for (int m = 0; m < N_METHOD; m++)
            integrate_step(model, (enum method)m, w_dt, NULL, &s[m]);
    }
    table_end();
    const double radius = hypot(s[IMPLICIT_MIDPOINT].u[0],
                                s[IMPLICIT_MIDPOINT].v[0]);
    const double spiral = hypot(s[BACKWARD_EULER].u[0], s[BACKWARD_EULER].v[0]);
    const double due = pow(1.0 + w_dt * w_dt, -0.5 * STEPS);
    const double *u = s[SYMPLECTIC_EULER].u, *v = s[SYMPLECTIC_EULER].v;
    const double ellipse = u[0] * u[0] + v[0] * v[0] - w_dt * u[0] * v[0];
    for (int m = 0; m < N_METHOD; m++) state_free(&s[m]);
    model_free(model);
    claim(fabs(radius - 1.0) < 1e-12 && fabs(spiral / due - 1.0) < 1e-12 &&
              fabs(ellipse - 1.0) < 1e-12,
          "midpoint stays on the circle (%g), symplectic Euler on its ellipse "
          "(%g), backward Euler spirals inwards (%g of what is due)", radius,
          ellipse, spiral / due);
}

/* The error after T in n steps. */
static double error_of(enum method method, double T, int n)
{
    struct model *model = model_mode(1.0);
    struct state s = state_make(1);
    s.u[0] = 1.0;
    for (int k = 0; k < n; k++)
        integrate_step(model, method, T / n, NULL, &s);
    const double error = hypot(s.u[0] - cos(T), s.v[0] + sin(T));
    state_free(&s);
    model_free(model);
    return error;
}

int main(void)
{
    static const int order_due[] = {1, 1, 2, 2};
    const double T = 2.385;
    const double due[] = {sin(T) / 2.0, T / 2.0, T / 12.0, T / 3.0};
    double order[N_METHOD], constant[N_METHOD];

    claim_one_frame();
    print_path(0.5);
    table_begin("orders", "method steps w_dt error order constant predicted");
    for (int m = 0; m < N_METHOD; m++) {
        double before = 0.0;
        for (int n = 4; n <= 1024; n *= 2) {
            const double error = error_of((enum method)m, T, n);
            order[m] = study_order(before, error, 2.0);
            constant[m] = error / pow(T / n, order_due[m]);
            table_row(method_name((enum method)m), n, T / n, error,
                      cell_if(n > 4, order[m]), constant[m], due[m]);
            before = error;
        }
    }
    table_end();
    for (int m = 0; m < N_METHOD; m++)
        claim(fabs(order[m] - order_due[m]) < 0.01 &&
                  fabs(constant[m] / due[m] - 1.0) < 0.005,
              "%s is of order %d with the constant %g (it is %g with %g)",
              method_name((enum method)m), order_due[m], due[m], order[m],
              constant[m]);
    return table_finish();
}
