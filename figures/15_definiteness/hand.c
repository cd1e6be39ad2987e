/*
 * hand.c - a column in your hand: press its right end, then touch it.
 *
 * A frame makes at most 8 systems with direction() of the program under test:
 * with a line search, and on in the next frame, where it projects; else full
 * steps, and the frame is lost unless they end.  A column that is at rest
 * though K is not positive definite stands until it is touched: round-off does
 * not touch it, for u is rounded to 1e-9 m.  Colours: log2 of 1 + twist / mu,
 * so that blue is a triangle that would rather turn away.
 */
#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { SYSTEMS = 8, DOFS = 2 * 41 * 5, TRIANGLES = 2 * 40 * 4 };

struct hand_scene {
    struct scene *s;
    enum projection projection;
    double e, pressed, from; /* the way of the end: now, in u, at the grab */
    int grabbed;             /* 1: the end, 2: the rest, which is touched */
    int systems, definite, missed, lost;
    double push, x[DOFS], value[TRIANGLES];
};

static void hand_input(struct hand_scene *h, const struct pointer *pointer)
{
    enum law *law = &h->s->body->material.law;
    if (pointer->key == 'p') h->projection = (h->projection + 1) % 3;
    if (pointer->key == 'l') *law = *law == LOG ? CUBIC : LOG;
    if (pointer->key == 'r') {
        scene_rest(h->s);
        h->e = h->pressed = 0.0;
    }
    if (pointer->down && !h->grabbed) {
        h->grabbed = fabs(pointer->x - 1.0 + h->e) < 0.3 ? 1 : 2;
        h->from = pointer->x + h->e;
    }
    if (!pointer->down) h->grabbed = 0;
    if (h->grabbed == 1) h->e = fmax(-0.5, fmin(0.5, h->from - pointer->x));
    h->push = pointer->y > *scene_middle(h->s) ? 0.01 : -0.01;
    if (h->grabbed != 2) h->push = 0.0;
}

/* Newton's method from u.  MAX_ITERATIONS: not at rest yet. */
static enum status hand_settle(struct hand_scene *h)
{
    struct body *body = h->s->body;
    const double small = 1e-7 * material_modulus(&body->material);
    double *u = h->s->u, q[DOFS], du[DOFS];
    enum status status = OK;
    hand_slot("15d");
    for (h->systems = h->definite = 0; status == OK; h->systems++) {
        status = direction(body, h->projection, u, q, du, &h->definite);
        if (status != OK || body_max_free(body, q) <= small) break;
        if (h->systems == SYSTEMS) return MAX_ITERATIONS;
        if (h->projection != NEVER)
            status = step_search(body, at_rest(NULL), q, du, u);
        for (int r = 0; r < DOFS && h->projection == NEVER; r++) u[r] += du[r];
    }
    return status;
}

static enum status hand_frame(struct hand_scene *h)
{
    double *u = h->s->u, before[DOFS];
    memcpy(before, u, sizeof before);
    scene_press(h->s, h->e, h->push);
    const enum status status = hand_settle(h);
    h->missed = status != OK &&
                (status != MAX_ITERATIONS || h->projection == NEVER);
    h->lost += h->missed;
    if (h->missed) memcpy(u, before, sizeof before);
    if (h->missed) h->e = h->pressed;
    h->pressed = h->e;
    for (int r = 0; r < DOFS; r++) u[r] = 1e-9 * rint(1e9 * u[r]);
    return status;
}

static struct view_picture hand_picture(struct hand_scene *h)
{
    const struct body *body = h->s->body;
    for (int r = 0; r < DOFS; r++) h->x[r] = h->s->mesh->X[r] + h->s->u[r];
    for (int t = 0; t < TRIANGLES; t++) {
        double factor[4] = {0.0};
        hand_slot("15a");
        const struct svd svd = signed_svd(body_deformation(body, h->s->u, t));
        hand_slot("15b");
        if (material_defined(&body->material, svd.s1 * svd.s2))
            eigenvalues(&body->material, svd.s1, svd.s2, factor);
        h->value[t] = 1.0 + factor[MODE_TWIST] / body->material.mu;
    }
    struct view_picture picture = hand_triangles(body->mesh, h->x, h->value);
    picture.held = h->s->held;
    return picture;
}

int main(int argc, char *argv[])
{
    static const char *const name[] = {"never", "on demand", "always"};
    struct hand *hand = hand_open("15", HAND_WHOSE, "plrpp", argc, argv);
    const struct scene_setting set = scene_column(CUBIC, 40, 0.0);
    struct hand_scene h = {.s = scene_alloc(&set), .projection = ON_DEMAND};
    struct pointer pointer;
    while (hand_next(hand, &pointer)) {
        hand_input(&h, &pointer);
        const enum status status = hand_frame(&h);
        struct view_picture picture = hand_picture(&h);
        const double middle = *scene_middle(h.s);
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "pressed by %.3f m, middle at %.3f m\n"
                 "drag the end, touch the middle\n"
                 "[p] projection: %s   [l] law: %s",
                 h.missed       ? "lost"
                 : status != OK ? "moves"
                 : h.definite   ? "stable"
                                : "at rest, NOT stable",
                 status_name(status), h.systems, h.lost, h.e, middle,
                 name[h.projection], material_law(h.s->body->material.law));
        hand_draw(hand, &picture, h.missed ? status : OK,
                  "projection systems lost definite e middle",
                  (double[]){h.projection, h.systems, h.lost, h.definite, h.e,
                             middle});
    }
    scene_free(h.s);
    return hand_close(hand);
}
