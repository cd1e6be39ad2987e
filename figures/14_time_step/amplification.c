/*
 * amplification.c - what does one step make of the amplitude of a mode?
 *
 * The spectral radius of a step of u'' = -u with dt = omega dt: the largest
 * modulus of an eigenvalue of the matrix that maps (u, v, u_before, v_before)
 * of one time to those of the next [eq:amplification].  Tables: the four
 * methods over omega dt; modes 1, 3, 5 of the bar at 30 steps per second, with
 * the step at which backward Euler takes 1 % per period.
 */
#include "motion/integrate.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_math.h>
#include <math.h>

static double spectral_radius(enum method method, double w_dt)
{
    struct model *model = model_mode(1.0);
    struct state s = state_make(1);
    gsl_matrix *G = gsl_matrix_alloc(4, 4);
    gsl_vector_complex *value = gsl_vector_complex_alloc(4);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(4);
    double radius = 0.0;

    double *const of[4] = {s.u, s.v, s.u_before, s.v_before};
    for (size_t c = 0; c < 4; c++) {
        for (size_t r = 0; r < 4; r++) *of[r] = r == c;
        s.steps = 1;
        integrate_step(model, method, w_dt, NULL, &s);
        for (size_t r = 0; r < 4; r++) gsl_matrix_set(G, r, c, *of[r]);
    }
    gsl_eigen_nonsymm(G, value, work);
    for (size_t c = 0; c < 4; c++)
        radius = fmax(radius,
                      hypot(value->data[2 * c], value->data[2 * c + 1]));
    gsl_eigen_nonsymm_free(work);
    gsl_vector_complex_free(value);
    gsl_matrix_free(G);
    state_free(&s);
    model_free(model);
    return radius;
}

/* What the radius should be; of BDF2 it is only known to be less than 1. */
static double due(enum method method, double z)
{
    if (method == BACKWARD_EULER) return 1.0 / sqrt(1.0 + z * z);
    if (method == SYMPLECTIC_EULER && z > 2.0)
        return z * z / 2.0 - 1.0 + z * sqrt(z * z / 4.0 - 1.0);
    return 1.0;
}

/* The largest distance of the radii from what is due, relative to that. */
static double print_radii(void)
{
    double wrong = 0.0;
    table_begin("amplification", "w_dt symplectic backward midpoint bdf2");
    for (int k = 0; k <= 96; k++) {
        double row[1 + N_METHOD] = {pow(10.0, -2.0 + k / 24.0)};
        for (int m = 0; m < N_METHOD; m++) {
            const double radius = spectral_radius((enum method)m, row[0]);
            const double off = radius / due((enum method)m, row[0]) - 1.0;
            wrong = fmax(wrong, m == BDF2 ? off : fabs(off));
            row[1 + m] = radius;
        }
        table_row_of(1 + N_METHOD, row);
    }
    table_end();
    return wrong;
}

/* Amplitude after a period minus 0.99, backward Euler at omega dt = z; a period
 * of the computed motion has 2 pi / atan z steps. */
static double loss_excess(double z, void *unused)
{
    (void)unused;
    return pow(1.0 + z * z, -M_PI / atan(z)) - 0.99;
}

int main(void)
{
    const struct material material = material_notes(LINEAR);
    const double c = sqrt(material_modulus(&material));
    const double one_percent = study_root(loss_excess, NULL, 1e-4, 1e-1);
    const double wrong = print_radii();
    double first = 0.0;

    /* modes of the continuous bar, omega = (2k - 1) pi c / 2 */
    table_begin("bar_modes", "mode omega hertz backward bdf2 midpoint "
                             "backward_1s dt_1percent");
    for (int k = 1; k <= 5; k += 2) {
        const double omega = (2 * k - 1) * M_PI_2 * c, z = omega / 30.0;
        const double left = spectral_radius(BACKWARD_EULER, z);
        if (k == 1) first = left;
        table_row(k, omega, omega / (2.0 * M_PI), left,
                  spectral_radius(BDF2, z),
                  spectral_radius(IMPLICIT_MIDPOINT, z), pow(left, 30.0),
                  one_percent / omega);
    }
    table_end();
    /* at omega dt = 2 an eigenvalue is double: the root of round-off */
    claim(wrong < 1e-7, "the radii of three methods are their closed forms, "
          "and that of BDF2 is below 1 (they are off by %g)", wrong);
    claim(first < 0.5, "a frame of backward Euler leaves less than half of "
          "the bar's first mode (it leaves %g)", first);
    return table_finish();
}
