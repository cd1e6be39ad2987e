/*
 * hand.c - four integrators in your hand: drag the right side of the square,
 * let go, and look at the energy.
 *
 * A frame of 1/30 s is cut into 1, 2, 4, ... 32 equal steps of one method, or
 * is one frame_step() of the program under test.  One that fails, or in which
 * the body leaves the window, is lost.  Then u and v are rounded to 1e-9, which
 * nobody sees: else an explosion would begin with round-off, which no two
 * machines have in common.  Colours: log2 J; the curve is the energy of the
 * last five seconds.
 */
#include "motion/hand.h"
#include "motion/side.h"

#include <stdio.h>
#include <string.h>

static const double HAND_FRAME = 1.0 / 30.0;

/* Cut the frame to s->g into so many steps. */
static enum status hand_steps(const struct scene *s, struct model *model,
                              enum method method, int parts, struct state *now)
{
    const double dt = HAND_FRAME / parts;
    double *g = allocate((size_t)s->n_dof, sizeof *g);
    enum status status = OK;
    if (method != SYMPLECTIC_EULER) hand_slot("14c");
    else hand_slot("14b");
    for (int k = 1; k <= parts && status == OK; k++) {
        for (int r = 0; r < s->n_dof; r++) {
            if (!s->held[r / 2]) continue;
            g[r] = s->u[r] + (double)k / parts * (s->g[r] - s->u[r]);
            if (method == SYMPLECTIC_EULER) now->v[r] = (g[r] - now->u[r]) / dt;
        }
        status = integrate_by(symplectic_euler, implicit_step, model, method,
                              dt, g, now).status;
        for (int r = 0; r < s->n_dof && status == OK; r++)
            if (!(fabs(now->u[r]) < 5.0)) status = NONFINITE;
    }
    free(g);
    return status;
}

/* One frame_step(); *rescued counts those that a later attempt has saved. */
static enum status hand_survive(const struct scene *s, struct state *now,
                                int *rescued)
{
    hand_slot("14d");
    const struct frame frame =
        frame_step(s->body, HAND_FRAME, s->g, NULL, now);
    *rescued += frame.status == OK && frame.attempts > 1;
    return frame.status;
}

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("14", HAND_WHOSE, "i+li-pi+rp", argc, argv);
    struct side *side = side_alloc(CUBIC, 8, 1);
    struct model *model[2] = {model_body(side->scene[0]->body),
                              model_body(side->scene[1]->body)};
    struct state now = state_make(side->now->n_dof), before = state_make(now.n);
    struct pointer pointer;
    int parts = 1, saved = 0, rescued = 0;
    enum method method = BACKWARD_EULER;
    while (hand_next(hand, &pointer)) {
        struct scene *s = side_next(side, &pointer);
        if (pointer.key == 'i') method = (method + 1) % N_METHOD;
        if (pointer.key == '+' && parts < 32) parts *= 2;
        if (pointer.key == '-' && parts > 1) parts /= 2;
        if (pointer.key == 'p') saved = !saved;
        if (pointer.key != '.') now.steps = 0; /* BDF2 begins anew */
        memcpy(now.u, s->u, (size_t)now.n * sizeof *now.u);
        memcpy(now.v, s->v, (size_t)now.n * sizeof *now.v);
        state_copy(&now, &before);
        enum status status =
            saved ? hand_survive(s, &now, &rescued)
                  : hand_steps(s, model[side_held(side)], method, parts, &now);
        if (status != OK) state_copy(&before, &now);
        side->lost += status != OK;
        for (int r = 0; r < now.n; r++) {
            s->u[r] = 1e-9 * rint(1e9 * now.u[r]);
            s->v[r] = 1e-9 * rint(1e9 * now.v[r]);
        }
        struct view_picture picture = side_picture(side);
        const double energy = side_energy(side, &picture);
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d frames lost, energy %.3g J\n"
                 "drag the right side, let go   [l] law: %s\n"
                 "[i] %s   [+ -] %d per frame   [p] %s",
                 status == OK ? "moves" : "lost", status_name(status),
                 side->lost, energy, material_law(s->body->material.law),
                 saved ? "backward" : method_name(method), saved ? 1 : parts,
                 saved ? "surviving frame" : "one attempt");
        snprintf(picture.note, sizeof picture.note,
                 "energy: 0.25 m a decade\n%d frames saved by p", rescued);
        if (status != OK && (saved || method != SYMPLECTIC_EULER))
            status = MAX_ITERATIONS; /* round-off says which it is */
        hand_draw(hand, &picture, status,
                  "method parts saved lost energy min_J",
                  (double[]){method, parts, saved, side->lost, energy,
                             side->min_J});
    }
    for (int k = 0; k < 2; k++) model_free(model[k]);
    state_free(&now);
    state_free(&before);
    side_free(side);
    return hand_close(hand);
}
