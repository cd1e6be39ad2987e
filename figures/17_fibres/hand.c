/*
 * hand.c - a muscle between two bones, in your hand: drag the right bone, and
 * contract the muscle.
 *
 * A frame is a step of backward Euler, 1/30 s, with the fibres of the program
 * under test, which pull with up to 700 N/m^2.  The muscle goes downhill in
 * at most 12 systems, and from there on in the next frame.  Colours: log2 of
 * the stretch of the fibres.
 */
int program_main(int argc, char *argv[]);
#define main program_main
#include PROGRAM
#undef main

#include "motion/hand.h"
#include "motion/side.h"

#include <stdio.h>
#include <string.h>

enum { CELLS = 24, TRIANGLES = 2 * CELLS * 4, DOFS = 2 * (CELLS + 1) * 5 };

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("17", HAND_WHOSE, "++++-+-r", argc, argv);
    struct side *side = side_alloc(CUBIC, CELLS, 6);
    const struct material material = material_notes(CUBIC);
    double angle[TRIANGLES] = {0.0}, l[TRIANGLES], u[DOFS], w[DOFS];
    struct fibres fibres = {fibre_muscle(0.0), angle};
    struct step_control control = step_method("demand+search");
    struct pointer pointer;
    control.tolerance = 1e-6;
    control.max_iterations = 12;
    fibres.fibre.sigma = 700.0;
    gsl_set_error_handler_off();
    for (int k = 0; k < 2; k++) {
        side->scene[k]->body->rho = 30.0;
        side->scene[k]->body->add = add_fibres;
        side->scene[k]->body->added = &fibres;
    }
    while (hand_next(hand, &pointer)) {
        struct scene *s = side_next(side, &pointer);
        double *a = &fibres.fibre.activation;
        double shortest = INFINITY, longest = 0.0;
        if (pointer.key == '+') *a = fmin(1.0, *a + 0.25);
        if (pointer.key == '-') *a = fmax(0.0, *a - 0.25);
        for (int r = 0; r < DOFS; r++) w[r] = s->u[r] + s->set.dt * s->v[r];
        memcpy(u, s->u, sizeof u);
        step_boundary(s->body, s->g, 1, u);
        hand_slot("17c");
        const struct step_report report = step_solve(
            s->body, &control, (struct incremental){s->set.dt, w, NULL}, u);
        const int lost = report.status != OK && report.status != MAX_ITERATIONS;
        for (int r = 0; r < DOFS && !lost; r++) {
            s->v[r] = (u[r] - s->u[r]) / s->set.dt;
            s->u[r] = u[r];
        }
        side->lost += lost;
        struct view_picture picture = side_picture(side);
        picture.value = l;
        picture.alarm = lost;
        for (int e = 0; e < TRIANGLES; e++) {
            l[e] = fibres_stretch(s->body, &fibres, s->u, e, NULL);
            shortest = fmin(shortest, l[e]);
            longest = fmax(longest, l[e]);
        }
        for (int i = 0; i < 2; i++) { /* the bones */
            const double *low = &side->x[2 * CELLS * i];
            const double *top = low + 2 * (CELLS + 1) * s->mesh->rows;
            hand_arrow(&picture, low, (double[]){top[0] - low[0],
                                                 top[1] - low[1]}, 1.0);
        }
        double alone[2];
        char free_length[32] = "none found";
        hand_slot("17d");
        if (strip(&material, &fibres.fibre, 0.0, alone) == OK)
            snprintf(free_length, sizeof free_length, "%.2f", alone[0]);
        snprintf(picture.caption, sizeof picture.caption,
                 "[+ -] activation %.2f: fibres %.2f to %.2f\n"
                 "a free strip, by your strip(): %s\n"
                 "%s: %s, %d systems, %d frames lost\n"
                 "drag the right bone, let go   [r] reset",
                 *a, shortest, longest, free_length,
                 lost ? "lost" : "moves",
                 status_name(report.status), report.iterations, side->lost);
        hand_draw(hand, &picture, "activation systems lost shortest longest",
                  (double[]){*a, report.iterations, side->lost, shortest,
                             longest});
    }
    side_free(side);
    return hand_close(hand);
}
