/*
 * stopped.c - how much motion is lost where the loop sets the velocity to 0?
 *
 * The script `hard`, n = 16, a patch in the hand, backward Euler, both rungs.
 * Table stopped: per law the frames after which the velocity is 0, the kinetic
 * energy (J) that the body had on its way through them, v = (u - u0) / dt, in
 * all and in the frame that loses most, and how far (m) the fastest free vertex
 * would have gone on in the next frame.
 */
#include "motion/live.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

struct motion {
    int frames;
    double energy, most, way;
};

static struct motion lost; /* by the frames of one script */

/* The kinetic energy of the way from the last state to u in a frame. */
static double kinetic(const struct live *live, const double u[], double *way)
{
    const int n = live->n_dof;
    double *v = allocate((size_t)n, sizeof *v), energy = 0.0;
    double *momentum = allocate((size_t)n, sizeof *momentum);
    *way = 0.0;
    for (int r = 0; r < n; r++) {
        v[r] = (u[r] - live->now.u[r]) / live->dt;
        if (live->body->equation[r] >= 0)
            *way = fmax(*way, live->dt * fabs(v[r]));
    }
    body_mass(live->body, v, momentum);
    for (int r = 0; r < n; r++) energy += 0.5 * v[r] * momentum[r];
    free(momentum);
    free(v);
    return energy;
}

/* The second rung, and what its velocity of 0 takes away. */
static enum status watched(struct live *live, double u[], double v[],
                           struct live_report *report)
{
    const enum status status = live_downhill(live, u, v, report);
    double way, energy = kinetic(live, u, &way);
    if (status == OK && report->part == 1.0) return status;
    lost.frames++;
    lost.energy += energy;
    lost.most = fmax(lost.most, energy);
    lost.way = fmax(lost.way, way);
    return status;
}

static struct motion play(enum law law)
{
    const struct live_setting set = {16, law, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    struct pointers hard = pointers_hard();
    body_store(live->body, PLAIN); /* trouble is chaotic */
    lost = (struct motion){0};
    for (int k = 0; k < hard.n; k++) {
        double to[2];
        live_input(live, &hard.frame[k]);
        live_hand(live->hand, &hard.frame[k], to);
        live_carry(live, to);
        live_frame_by(live, live_lift, watched, to);
    }
    pointers_free(&hard);
    live_free(live);
    return lost;
}

int main(void)
{
    struct motion of[2];
    gsl_set_error_handler_off();
    table_begin("stopped", "law frames energy most way");
    for (int l = 0; l < 2; l++) {
        of[l] = play(l ? CUBIC : LOG);
        table_row(material_law(l ? CUBIC : LOG), of[l].frames, of[l].energy,
                  of[l].most, of[l].way);
    }
    table_end();
    claim(of[0].frames >= 40 && of[0].frames <= 50 && of[1].frames >= 20 &&
              of[1].frames <= 30,
          "the velocity is set to 0 in some of the 300 frames (LOG: %d, cubic: "
          "%d)", of[0].frames, of[1].frames);
    claim(of[0].most > 130.0 && of[0].most < 150.0 && of[1].most > 270.0 &&
              of[1].most < 290.0,
          "a frame loses up to 140 J under LOG (%g), 280 J under CUBIC (%g)",
          of[0].most, of[1].most);
    return table_finish();
}
