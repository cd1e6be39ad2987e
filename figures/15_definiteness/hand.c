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
int program_main(int argc, char *argv[]);
#define main program_main
#include PROGRAM
#undef main

#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { SYSTEMS = 8, DOFS = 2 * 41 * 5, TRIANGLES = 2 * 40 * 4 };

/* Newton's method from u; *systems so far.  MAX_ITERATIONS: not at rest yet. */
static enum status hand_settle(struct body *body, enum projection projection,
                               double u[], int *systems, int *definite)
{
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    const double small = 1e-7 * material_modulus(&body->material);
    double *q = allocate(n_dof, sizeof *q), *du = allocate(n_dof, sizeof *du);
    enum status status = OK;
    hand_slot("15d");
    for (*systems = 0; status == OK; ++*systems) {
        status = direction(body, projection, u, q, du, definite);
        if (status != OK || body_max_free(body, q) <= small) break;
        status = MAX_ITERATIONS;
        if (*systems == SYSTEMS) break;
        status = OK;
        if (projection != NEVER)
            status = step_search(body, at_rest(NULL), q, du, u);
        for (size_t r = 0; r < n_dof && projection == NEVER; r++) u[r] += du[r];
    }
    free(q);
    free(du);
    return status;
}

int main(int argc, char *argv[])
{
    static const char *const name[] = {"never", "on demand", "always"};
    struct hand *hand = hand_open("15", HAND_WHOSE, "plrpp", argc, argv);
    const struct scene_setting set = scene_column(CUBIC, 40, 0.0);
    struct scene *s = scene_alloc(&set);
    struct material *material = &s->body->material;
    struct pointer pointer;
    double x[DOFS], before[DOFS], value[TRIANGLES], e = 0.0, from = 0.0;
    enum projection projection = ON_DEMAND;
    int grabbed = 0, lost = 0;
    gsl_set_error_handler_off();
    while (hand_next(hand, &pointer)) {
        const double old = e, *middle = scene_middle(s);
        double push = 0.0;
        int systems = 0, definite = 0;
        if (pointer.key == 'p') projection = (projection + 1) % 3;
        if (pointer.key == 'l')
            material->law = material->law == LOG ? CUBIC : LOG;
        if (pointer.key == 'r') {
            scene_rest(s);
            e = 0.0;
        }
        memcpy(before, s->u, sizeof before);
        if (!pointer.down) grabbed = 0;
        else if (!grabbed) {
            /* 1: the end, 2: the rest, which is only touched */
            grabbed = fabs(pointer.x - 1.0 + e) < 0.3 ? 1 : 2;
            from = pointer.x + e;
        }
        if (grabbed == 1) e = fmax(-0.5, fmin(0.5, from - pointer.x));
        if (grabbed == 2) push = pointer.y > *middle ? 0.01 : -0.01;
        scene_press(s, e, push);
        const enum status status =
            hand_settle(s->body, projection, s->u, &systems, &definite);
        const int going = status == MAX_ITERATIONS && projection != NEVER;
        if (status != OK && !going) {
            memcpy(s->u, before, sizeof before);
            e = old;
            lost++;
        }
        for (int r = 0; r < DOFS; r++) {
            s->u[r] = 1e-9 * rint(1e9 * s->u[r]);
            x[r] = s->mesh->X[r] + s->u[r];
        }
        for (int t = 0; t < TRIANGLES; t++) {
            double factor[4] = {0.0};
            hand_slot("15a");
            const struct svd svd =
                signed_svd(body_deformation(s->body, s->u, t));
            hand_slot("15b");
            if (material_defined(material, svd.s1 * svd.s2))
                eigenvalues(material, svd.s1, svd.s2, factor);
            value[t] = 1.0 + factor[MODE_TWIST] / material->mu;
        }
        struct view_picture picture = {
            .n_point = s->mesh->n_vertex, .x = x, .held = s->held,
            .n_triangle = TRIANGLES, .value = value,
            .triangle = s->mesh->triangle, .alarm = status != OK && !going};
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "pressed by %.3f m, middle at %.3f m\n"
                 "[p] projection: %s   [l] law: %s\n"
                 "drag the end, touch the middle   [r] reset",
                 status == OK ? definite ? "stable" : "at rest, NOT stable"
                 : going      ? "moves"
                              : "lost",
                 status_name(status), systems, lost, e, *middle,
                 name[projection], material_law(material->law));
        hand_draw(hand, &picture, "projection systems lost definite e middle",
                  (double[]){projection, systems, lost, definite, e, *middle});
    }
    scene_free(s);
    return hand_close(hand);
}
