/*
 * hand.c - a free square in your hand: drag any vertex, push the square through
 * itself or scramble it, and let go.
 *
 * It moves by explicit steps, symplectic Euler with lumped mass and damping,
 * 60 in a frame, under the stress() of the program under test, which all five
 * laws have; [p] takes it to rest at once by its release(), under a law of the
 * library.  Colours: log2 J.
 */
int program_main(int argc, char *argv[]);
#define main program_main
#include PROGRAM
#undef main

#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { CELLS = 4, VERTICES = 25, TRIANGLES = 32, DOFS = 50, PARTS = 60 };

/* Advance u and v by dt; vertex `grabbed` goes on by `way` (m), if >= 0.  No
 * other is faster than 8 m/s along an axis: deep inside out the cubic law would
 * throw it a thousand times as fast.  NONFINITE: P is no number. */
static enum status hand_step(const struct principal_law *law,
                             const struct body *body, double dt, int grabbed,
                             const double way[2], double u[], double v[])
{
    double f[DOFS] = {0.0}, mass[VERTICES] = {0.0};
    for (int e = 0; e < TRIANGLES; e++) {
        const int *t = &body->vertex[3 * e];
        const double *g = &body->gradient[6 * e];
        hand_slot("16c");
        const mat2 P = stress(law, body_deformation(body, u, e));
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
        if (r / 2 == grabbed) v[r] = way[r % 2] / dt;
        u[r] += dt * v[r];
    }
    return OK;
}

int main(int argc, char *argv[])
{
    static const int held[VERTICES];
    static const enum law of_library[N_FORM] = { /* LINEAR: has it not */
        [BY_CUBIC] = CUBIC, [BY_J] = EXTENDED, [BY_STABLE] = STABLE};
    const struct material m = material_notes(STABLE);
    struct hand *hand = hand_open("16", HAND_WHOSE, "slprl", argc, argv);
    struct mesh *mesh = mesh_square(CELLS);
    struct body *body = body_alloc(mesh, m, 1.0, LUMPED, held);
    struct principal_law law = {BY_STABLE, m.mu, m.lambda, EXTENDED_BELOW};
    struct pointer pointer;
    double u[DOFS] = {0.0}, v[DOFS] = {0.0}, x[DOFS], J[TRIANGLES];
    int grabbed = -1, lost = 0, seed = 0;
    memcpy(x, mesh->X, sizeof x);
    gsl_set_error_handler_off();
    while (hand_next(hand, &pointer)) {
        enum status status = OK;
        double before[DOFS];
        int inverted = 0;
        if (pointer.key == 'l') law.form = (law.form + 1) % N_FORM;
        if (pointer.key == 'r') memset(u, 0, sizeof u);
        if (pointer.key == 's') release_scramble(body, (unsigned)++seed, u);
        if (strchr("rs", pointer.key)) memset(v, 0, sizeof v);
        if (!pointer.down) grabbed = -1;
        else if (grabbed < 0)
            grabbed = hand_nearest(&pointer, VERTICES, x, 0.3);
        memcpy(before, u, sizeof u);
        if (pointer.key == 'p' && of_library[law.form] != LINEAR) {
            body->material.law = of_library[law.form];
            hand_slot("16d");
            status = release(body, u).status;
            memset(v, 0, sizeof v);
        }
        double way[2] = {pointer.x / PARTS, pointer.y / PARTS};
        for (int i = 0; i < 2 && grabbed >= 0; i++)
            way[i] -= x[2 * grabbed + i] / PARTS;
        for (int k = 0; k < PARTS && status == OK; k++)
            status = hand_step(&law, body, 1.0 / 30.0 / PARTS, grabbed, way, u,
                               v);
        if (status == NONFINITE) {
            memcpy(u, before, sizeof u);
            memset(v, 0, sizeof v);
        }
        lost += status == NONFINITE;
        for (int r = 0; r < DOFS; r++) x[r] = mesh->X[r] + u[r];
        for (int e = 0; e < TRIANGLES; e++) {
            J[e] = mat2_det(body_deformation(body, u, e));
            inverted += J[e] <= 0.0;
        }
        const double wound = round(release_winding(body, u));
        struct view_picture picture = {
            .n_point = VERTICES, .x = x, .n_triangle = TRIANGLES, .value = J,
            .triangle = mesh->triangle, .alarm = status != OK};
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %d of 32 inside out, wound %.0f times\n"
                 "%d frames lost   [l] law: %s\n"
                 "drag a vertex   [s] scramble   [p] to rest\n"
                 "[r] reset   [space] stop   [q] close",
                 status_name(status), inverted, wound, lost,
                 form_name[law.form]);
        hand_draw(hand, &picture, "law inverted wound lost",
                  (double[]){law.form, inverted, wound, lost});
    }
    body_free(body);
    mesh_free(mesh);
    return hand_close(hand);
}
