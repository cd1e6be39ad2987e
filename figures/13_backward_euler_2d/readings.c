/*
 * readings.c - what do the scenes do, in all readings of the notes' example?
 *
 * The notes hold both ends of the square and give their motion as a number,
 * sin|X1|t; scene.h has the five ways to read it, and three scenes more.  One
 * second of each with both laws by Newton with Cholesky: a step fails where a
 * matrix is not positive definite.  Tables: readings (n = 4), gallery (the
 * triangles of the five readings at two times, n = 6, cubic law, reach 0.6).
 */
#include "corners.h"
#include "base/options.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

/* Make up to n steps; the status of the last, and all iterations added up.  A
 * step in which a matrix was indefinite is taken back: it is NOT_SPD. */
static enum status advance(struct scene *s, int n, int *iterations)
{
    const struct step_control newton = step_method("notes");
    const size_t bytes = (size_t)s->n_dof * sizeof(double);
    double u[98], v[98]; /* n <= 6 */
    enum status status = OK;
    for (int k = 0; k < n && status == OK; k++) {
        memcpy(u, s->u, bytes);
        memcpy(v, s->v, bytes);
        const struct step_report report = scene_step(s, &newton);
        status = report.indefinite ? NOT_SPD : report.status;
        *iterations += report.iterations;
        if (report.indefinite && report.status == OK) {
            memcpy(s->u, u, bytes);
            memcpy(s->v, v, bytes);
            s->steps--;
        }
    }
    return status;
}

/* Where a step fails the row is the state before. */
static void print_readings(struct scene_measures m[SPIN + 1][2],
                           enum status status[SPIN + 1][2], double top_y[])
{
    table_begin_note("readings", "scene law steps iterations reason centre_x "
                     "centre_y top_x top_y elastic kinetic momentum_x min_J",
                     "n = 4; top: the vertex at (0, 1)");
    for (enum reading reading = RIGID; reading <= SPIN; reading++)
        for (enum law law = LOG; law <= CUBIC; law++) {
            const struct scene_setting set = scene_notes(reading, law, 4);
            struct scene *s = scene_alloc(&set);
            int iterations = 0;
            const enum status ended = advance(s, 30, &iterations);
            const struct scene_measures e = scene_measure(s);
            const double *centre = &s->u[2 * 12], *top = &s->u[2 * 22];
            table_row(scene_name(reading), material_law(law), s->steps,
                      cell_if(ended == OK, iterations), status_name(ended),
                      centre[0], centre[1], top[0], top[1], e.elastic,
                      e.kinetic, e.momentum[0], e.min_J);
            m[reading][law == CUBIC] = e;
            status[reading][law == CUBIC] = ended;
            top_y[reading] = top[1];
            scene_free(s);
        }
    table_end();
}

static void print_gallery(void)
{
    int unused = 0;
    table_begin("gallery", "scene t J x0 y0 x1 y1 x2 y2");
    for (enum reading reading = RIGID; reading <= STEADY; reading++) {
        struct scene_setting set = scene_notes(reading, CUBIC, 6);
        set.reach = 0.6;
        struct scene *s = scene_alloc(&set);
        for (int frame = 0; frame < 2; frame++) {
            if (advance(s, 15, &unused) != OK)
                die("%s fails", scene_name(reading));
            for (int e = 0; e < s->mesh->n_triangle; e++) {
                double x[6];
                const double J = corners_of(s, e, x);
                table_row(scene_name(reading), s->steps * set.dt, J, x[0], x[1],
                          x[2], x[3], x[4], x[5]);
            }
        }
        scene_free(s);
    }
    table_end();
}

int main(void)
{
    struct scene_measures m[SPIN + 1][2];
    enum status status[SPIN + 1][2];
    double top_y[SPIN + 1];

    gsl_set_error_handler_off();
    print_readings(m, status, top_y);
    print_gallery();

    for (enum reading reading = RIGID; reading <= SPIN; reading++)
        for (int cubic = 0; cubic < 2; cubic++)
            claim(status[reading][cubic] ==
                      (reading == COMPRESS && !cubic ? NOT_SPD : OK),
                  "compression stops the log law, NOT_SPD, and nothing else "
                  "(%s: %s)", scene_name(reading),
                  status_name(status[reading][cubic]));
    claim(m[RIGID][1].elastic < 1e-3 && m[STRETCH][1].elastic > 1e3,
          "read literally the body follows its ends: it stores %g J, and %g J "
          "when it is stretched", m[RIGID][1].elastic, m[STRETCH][1].elastic);
    claim(fabs(top_y[RIGID]) < 1e-4 && fabs(top_y[BOTH] / sin(1.0) - 1) < 1e-2,
          "the scalar boundary value takes the body off diagonally, by %g m",
          top_y[BOTH]);
    return table_finish();
}
