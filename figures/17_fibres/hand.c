/*
 * hand.c - a muscle between two bones, in your hand: drag the right bone, and
 * contract the muscle.
 *
 * A frame is a step of backward Euler, 1/30 s, with the fibres of the program
 * under test, which pull with up to 700 N/m^2.  The muscle goes downhill in
 * at most 12 systems, and from there on in the next frame.  Colours: log2 of
 * the stretch of the fibres.
 */
#include "motion/hand.h"
#include "motion/side.h"

#include <stdio.h>
#include <string.h>

enum { CELLS = 24, TRIANGLES = 2 * CELLS * 4, DOFS = 2 * (CELLS + 1) * 5 };

struct hand_scene {
    struct side *side;
    struct fibres fibres;
    struct step_report report;
    int missed; /* this frame is lost */
    double stretch[TRIANGLES], shortest, longest;
};

static void hand_input(struct hand_scene *h, const struct pointer *pointer)
{
    double *a = &h->fibres.fibre.activation;
    side_next(h->side, pointer);
    if (pointer->key == '+') *a = fmin(1.0, *a + 0.25);
    if (pointer->key == '-') *a = fmax(0.0, *a - 0.25);
}

static void hand_frame(struct hand_scene *h)
{
    struct scene *s = h->side->now;
    struct step_control control = step_method("demand+search");
    double u[DOFS], w[DOFS];
    control.tolerance = 1e-6;
    control.max_iterations = 12;
    for (int r = 0; r < DOFS; r++) w[r] = s->u[r] + s->set.dt * s->v[r];
    memcpy(u, s->u, sizeof u);
    step_boundary(s->body, s->g, 1, u);
    hand_slot("17c");
    h->report = step_solve(s->body, &control,
                           (struct incremental){s->set.dt, w, NULL}, u);
    h->missed = h->report.status != OK && h->report.status != MAX_ITERATIONS;
    for (int r = 0; r < DOFS && !h->missed; r++) {
        s->v[r] = (u[r] - s->u[r]) / s->set.dt;
        s->u[r] = u[r];
    }
    h->side->lost += h->missed;
}

static struct view_picture hand_picture(struct hand_scene *h)
{
    const struct scene *s = h->side->now;
    struct view_picture picture = side_picture(h->side);
    picture.value = h->stretch;
    h->shortest = INFINITY;
    h->longest = 0.0;
    for (int e = 0; e < TRIANGLES; e++) {
        h->stretch[e] = fibres_stretch(s->body, &h->fibres, s->u, e, NULL);
        h->shortest = fmin(h->shortest, h->stretch[e]);
        h->longest = fmax(h->longest, h->stretch[e]);
    }
    for (int i = 0; i < 2; i++) { /* the bones */
        const double *low = &h->side->x[2 * CELLS * i];
        const double *top = low + 2 * (CELLS + 1) * s->mesh->rows;
        hand_arrow(&picture, low,
                   (double[]){top[0] - low[0], top[1] - low[1]}, 1.0);
    }
    return picture;
}

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("17", HAND_WHOSE, "++++-+-r", argc, argv);
    const struct material material = material_notes(CUBIC);
    double angle[TRIANGLES] = {0.0};
    struct hand_scene h = {.side = side_alloc(CUBIC, CELLS, 6),
                           .fibres = {fibre_muscle(0.0), angle}};
    struct pointer pointer;
    h.fibres.fibre.sigma = 700.0;
    for (int k = 0; k < 2; k++) {
        struct body *body = h.side->scene[k]->body;
        body->rho = 30.0;
        body->add = add_fibres;
        body->added = &h.fibres;
    }
    while (hand_next(hand, &pointer)) {
        hand_input(&h, &pointer);
        hand_frame(&h);
        struct view_picture picture = hand_picture(&h);
        const struct fibre *fibre = &h.fibres.fibre;
        double alone[2];
        char free_length[32] = "none found";
        hand_slot("17d");
        if (strip(&material, fibre, 0.0, alone) == OK)
            snprintf(free_length, sizeof free_length, "%.2f", alone[0]);
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "fibres %.2f to %.2f long, a free strip, by strip(): %s\n"
                 "drag the right bone, let go   [+ -] activation %.2f",
                 h.missed ? "lost" : "moves", status_name(h.report.status),
                 h.report.iterations, h.side->lost, h.shortest, h.longest,
                 free_length, fibre->activation);
        hand_draw(hand, &picture, h.missed ? h.report.status : OK,
                  "activation systems lost shortest longest",
                  (double[]){fibre->activation, h.report.iterations,
                             h.side->lost, h.shortest, h.longest});
    }
    side_free(h.side);
    return hand_close(hand);
}
