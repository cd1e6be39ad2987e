/*
 * hand.c - the square that moves, in your hand: drag its right side, let go.
 *
 * A frame is one step of backward Euler of the program under test, 1/30 s.
 * One in which it fails is lost: the body stays, and the caption says why.
 * Colours: log2 J; the curve is the energy of the last five seconds.
 */
#include "motion/hand.h"
#include "motion/side.h"

#include <stdio.h>

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("13", HAND_WHOSE, "lr", argc, argv);
    struct side *side = side_alloc(CUBIC, 8, 1);
    struct pointer pointer;
    while (hand_next(hand, &pointer)) {
        struct scene *s = side_next(side, &pointer);
        hand_slot("13d");
        const struct history report = step(s, 1e-6, CAP, 1);
        side->lost += report.status != OK;
        struct view_picture picture = side_picture(side);
        const double energy = side_energy(side, &picture);
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "energy %.3g J, least J %.2f\n"
                 "drag the right side, let go   [l] law: %s",
                 report.status == OK ? "moves" : "lost",
                 status_name(report.status), report.iterations, side->lost,
                 energy, side->min_J, material_law(s->body->material.law));
        hand_draw(hand, &picture, report.status, "systems lost energy min_J",
                  (double[]){report.iterations, side->lost, energy,
                             side->min_J});
    }
    side_free(side);
    return hand_close(hand);
}
