/*
 * stopped.c - how much motion is lost where the loop sets the velocity to 0?
 *
 * The script `hard`, n = 16, a patch in the hand, backward Euler, both rungs.
 * Table stopped: per law the frames after which the velocity is 0, and the
 * kinetic energy (J) that the body had when they began, in all and at most.
 * ((u - u0) / dt at the end of an unfinished frame is the velocity of no
 * motion, so it is not counted.)
 */
#include "motion/live.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

struct motion {
    int frames;
    double energy, most;
};

static struct motion lost; /* by the frames of one script */

static double kinetic(const struct live *live)
{
    const double *v = live->now.v;
    double *momentum = allocate((size_t)live->n_dof, sizeof *momentum);
    double energy = 0.0;
    body_mass(live->body, v, momentum);
    for (int r = 0; r < live->n_dof; r++) energy += 0.5 * v[r] * momentum[r];
    free(momentum);
    return energy;
}

/* The second rung, and what its velocity of 0 takes away. */
static enum status watched(struct live *live, double u[], double v[],
                           struct live_report *report)
{
    const double energy = kinetic(live);
    const enum status status = live_downhill(live, u, v, report);
    if (status == OK && report->part == 1.0) return status;
    lost.frames++;
    lost.energy += energy;
    lost.most = fmax(lost.most, energy);
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
    table_begin("stopped", "law frames energy most");
    for (int l = 0; l < 2; l++) {
        of[l] = play(l ? CUBIC : LOG);
        table_row(material_law(l ? CUBIC : LOG), of[l].frames, of[l].energy,
                  of[l].most);
    }
    table_end();
    claim(of[0].frames >= 40 && of[0].frames <= 50 && of[1].frames >= 20 &&
              of[1].frames <= 30,
          "the velocity is set to 0 in some of the 300 frames (LOG: %d, cubic: "
          "%d)", of[0].frames, of[1].frames);
    claim(fabs(of[0].most - 50.7) < 1.0 && fabs(of[1].most - 83.4) < 1.0,
          "a frame takes up to 51 J of kinetic energy under LOG (%g), 83 J "
          "under CUBIC (%g)", of[0].most, of[1].most);
    return table_finish();
}
