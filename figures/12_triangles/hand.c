/*
 * hand.c - the square at rest in your hand: drag its right side.
 *
 * In every frame equilibrium() of the program under test goes from the last
 * state to the next, the left side held, and the right one free or where the
 * hand is, which is lifted in first.  A frame in which it fails is lost: the
 * body stays, and the caption says why.  Colours: log2 J.
 */
#include "motion/hand.h"
#include "motion/side.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("12", HAND_WHOSE, "lr", argc, argv);
    struct side *side = side_alloc(LOG, 8, 1);
    struct pointer pointer;
    const size_t n_dof = (size_t)side->now->n_dof;
    double *u = allocate(n_dof, sizeof *u);
    while (hand_next(hand, &pointer)) {
        struct scene *s = side_next(side, &pointer);
        memcpy(u, s->u, n_dof * sizeof *u);
        hand_slot("12e");
        step_boundary(s->body, s->g, 1, u);
        const struct history report = equilibrium(s, 1e-4, HISTORY_CAP, u);
        if (report.status == OK) memcpy(s->u, u, n_dof * sizeof *u);
        side->lost += report.status != OK;
        struct view_picture picture = side_picture(side);
        for (int e = 0; e < s->mesh->n_triangle; e++) {
            double g[6];
            mesh_gradients(s->mesh, e, g);
            hand_slot("12a");
            side->J[e] =
                mat2_det(deformation(&s->mesh->triangle[3 * e], g, s->u));
            side->min_J = e ? fmin(side->min_J, side->J[e]) : side->J[e];
        }
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost, least J %.2f\n"
                 "drag the right side   [l] law: %s",
                 report.status == OK ? "at rest" : "lost",
                 status_name(report.status), report.iterations, side->lost,
                 side->min_J, material_law(s->body->material.law));
        hand_draw(hand, &picture, report.status, "systems lost min_J",
                  (double[]){report.iterations, side->lost, side->min_J});
    }
    free(u);
    side_free(side);
    return hand_close(hand);
}
