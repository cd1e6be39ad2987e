/*
 * scripts.c - does a body that is cut at random keep its books?
 *
 * Random scripts of `make live-26 --input mad`, a seed each: the pointer leaps
 * while the button is down, or is not; every 37 frames a key takes loose parts
 * away, undoes the last cut, changes between knife and hand, or makes the
 * square whole again, each in turn.  The books are those of hand.c.
 */
#define PROGRAM "../../solutions/26_cut.c"
#define SCRIPTS
#include "hand.c"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "motion/hand.h"
#include "plane/step.h"
#include "plane/tissue.h"

int main(void)
{
    enum { SEEDS = 40 };
    int frames = 0, lost = 0, judged = 0, cuts = 0;
    double most[NUMBERS] = {0.0}, gained = 0.0, longest = 0.0;
    gsl_set_error_handler_off();
    for (int seed = 1; seed <= SEEDS; seed++) {
        char text[12], *argv[] = {(char *)"live-26", (char *)"--input",
                                  (char *)"mad", (char *)"--seed", text, NULL};
        snprintf(text, sizeof text, "%d", seed);
        struct hand *hand = hand_open("26", "", "e-gr", 5, argv);
        struct patient p;
        struct pointer pointer;
        double number[NUMBERS], sum = 0.0, least = 1.0, vertices = 1e9;
        patient_alloc(&p, 0);
        for (; hand_next(hand, &pointer); frames++) {
            patient_frame(&p, &pointer, number);
            for (int k = 0; k < NUMBERS; k++)
                most[k] = fmax(most[k], number[k]);
            if (pointer.key == 'r') sum = 0.0;
            sum += number[GAINED];
            longest = fmax(longest, sum);
            if (fmin(least, number[MIN_J]) > 0.6) {
                gained = fmax(gained, number[GAINED]);
                judged++;
            }
            least = number[MIN_J];
            cuts += number[VERTICES] > vertices;
            vertices = number[VERTICES];
        }
        lost += p.lost;
        patient_free(&p);
        hand_close(hand);
    }
    table_begin("scripts", "scripts frames lost");
    table_row(SEEDS, frames, lost);
    table_end();
    claim(lost == 0, "no frame is lost (%d)", lost);
    claim(cuts > 200 && most[PARTS] > 8.0 && most[TAKEN] > 1.0,
          "hundreds of cuts (%d), more than eight parts (%g), and more than a "
          "kilogram taken away (%g)", cuts, most[PARTS], most[TAKEN]);
    claim(most[MASS_OFF] < 1e-12, "no mass is lost (%g)", most[MASS_OFF]);
    claim(most[JUMPED] < 1e-12, "no cut gives or takes energy (%g)",
          most[JUMPED]);
    claim(2 * judged > frames && gained < 1e-4, "no step gains energy unless a "
          "triangle has been pressed to 0.6 of its area, or less (%g J)",
          gained);
    claim(longest < 1e-4, "nor does a sequence of steps (%g J)", longest);
    return table_finish();
}
