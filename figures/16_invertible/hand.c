/*
 * hand.c - a free square in your hand: drag any vertex, push the square through
 * itself or scramble it, and let go.
 *
 * It moves by explicit steps, symplectic Euler with lumped mass and damping,
 * 60 in a frame, under the stress() of the program under test, which all five
 * laws have; [p] takes it to rest at once by its release(), under a law of the
 * library.  Colours: log2 J.
 */
#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { CELLS = 4, VERTICES = 25, TRIANGLES = 32, DOFS = 50, PARTS = 60 };

struct hand_scene {
    struct body *body;
    struct principal_law law;
    double u[DOFS], v[DOFS], x[DOFS], J[TRIANGLES];
    int grabbed, seed, inverted, lost; /* grabbed: a vertex, -1: none */
    double way[2]; /* on which it goes in a part of a frame (m) */
};

static void hand_input(struct hand_scene *h, const struct pointer *pointer)
{
    if (pointer->key == 'l') h->law.form = (h->law.form + 1) % N_FORM;
    if (pointer->key == 'r') memset(h->u, 0, sizeof h->u);
    if (pointer->key == 's')
        release_scramble(h->body, (unsigned)++h->seed, h->u);
    if (strchr("rs", pointer->key)) memset(h->v, 0, sizeof h->v);
    h->grabbed = hand_grab(h->grabbed, pointer, VERTICES, h->x, 0.3);
    const double at[2] = {pointer->x, pointer->y};
    for (int i = 0; i < 2 && h->grabbed >= 0; i++)
        h->way[i] = (at[i] - h->x[2 * h->grabbed + i]) / PARTS;
}

/* Advance u and v by dt.  No vertex but the grabbed one is faster than 8 m/s
 * along an axis: deep inside out the cubic law would throw it a thousand times
 * as fast.  NONFINITE: P is no number. */
static enum status hand_step(struct hand_scene *h, double dt)
{
    const struct body *body = h->body;
    double f[DOFS] = {0.0}, mass[VERTICES] = {0.0}, *v = h->v;
    for (int e = 0; e < TRIANGLES; e++) {
        const int *t = &body->vertex[3 * e];
        const double *g = &body->gradient[6 * e];
        hand_slot("16c");
        const mat2 P = stress(&h->law, body_deformation(body, h->u, e));
        for (int a = 0; a < 3; a++) {
            mass[t[a]] += body->area[e] / 3.0; /* the density is 1 */
            for (int i = 0; i < 2; i++)
                f[2 * t[a] + i] -= body->area[e] * (P.m[i][0] * g[2 * a] +
                                                    P.m[i][1] * g[2 * a + 1]);
        }
    }
    for (int r = 0; r < DOFS; r++) {
        v[r] += dt * (f[r] / mass[r / 2] - 3.0 * v[r]);
        if (!isfinite(v[r])) return NONFINITE;
        v[r] = fmax(-8.0, fmin(8.0, v[r]));
        if (r / 2 == h->grabbed) v[r] = h->way[r % 2] / dt;
        h->u[r] += dt * v[r];
    }
    return OK;
}

static enum status hand_frame(struct hand_scene *h, char key)
{
    static const enum law of_library[N_FORM] = { /* LINEAR: has it not */
        [BY_CUBIC] = CUBIC, [BY_J] = EXTENDED, [BY_STABLE] = STABLE};
    enum status status = OK;
    double before[DOFS];
    memcpy(before, h->u, sizeof before);
    if (key == 'p' && of_library[h->law.form] != LINEAR) {
        h->body->material.law = of_library[h->law.form];
        hand_slot("16d");
        status = release(h->body, h->u).status;
        memset(h->v, 0, sizeof h->v);
    }
    for (int k = 0; k < PARTS && status == OK; k++)
        status = hand_step(h, 1.0 / 30.0 / PARTS);
    if (status == NONFINITE) {
        memcpy(h->u, before, sizeof before);
        memset(h->v, 0, sizeof h->v);
        h->lost++;
    }
    return status;
}

static struct view_picture hand_picture(struct hand_scene *h)
{
    h->inverted = 0;
    for (int r = 0; r < DOFS; r++) h->x[r] = h->body->mesh->X[r] + h->u[r];
    for (int e = 0; e < TRIANGLES; e++) {
        h->J[e] = mat2_det(body_deformation(h->body, h->u, e));
        h->inverted += h->J[e] <= 0.0;
    }
    return hand_triangles(h->body->mesh, h->x, h->J);
}

int main(int argc, char *argv[])
{
    static const int held[VERTICES];
    const struct material m = material_notes(STABLE);
    struct hand *hand = hand_open("16", HAND_WHOSE, "slprl", argc, argv);
    struct mesh *mesh = mesh_square(CELLS);
    struct hand_scene h = {
        .body = body_alloc(mesh, m, 1.0, LUMPED, held),
        .law = {BY_STABLE, m.mu, m.lambda, EXTENDED_BELOW}, .grabbed = -1};
    struct pointer pointer;
    memcpy(h.x, mesh->X, sizeof h.x);
    while (hand_next(hand, &pointer)) {
        hand_input(&h, &pointer);
        const enum status status = hand_frame(&h, pointer.key);
        struct view_picture picture = hand_picture(&h);
        const double wound = round(release_winding(h.body, h.u));
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d frames lost   [l] law: %s\n"
                 "%d of 32 inside out, wound %.0f times\n"
                 "drag a vertex   [s] scramble   [p] to rest",
                 status == NONFINITE ? "lost" : "moves", status_name(status),
                 h.lost, form_name[h.law.form], h.inverted, wound);
        hand_draw(hand, &picture, status, "law inverted wound lost",
                  (double[]){h.law.form, h.inverted, wound, h.lost});
    }
    body_free(h.body);
    mesh_free(mesh);
    return hand_close(hand);
}
