/*
 * hand.c - the square at rest in your hand: drag its right side.
 *
 * In every frame equilibrium() of the program under test goes from the last
 * state to the next, the left side held and the right one where the hand is,
 * which is lifted in first.  A frame in which it fails is lost: the body stays,
 * and the caption says why.  Colours: log2 J.
 */
int program_main(int argc, char *argv[]);
#define main program_main
#include PROGRAM
#undef main

#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("12", HAND_WHOSE, "lr", argc, argv);
    struct pointer pointer;
    struct scene_setting set = scene_notes(STRETCH, LOG, 8);
    struct scene *s = scene_alloc(&set);
    const int n_vertex = s->mesh->n_vertex;
    const size_t size = (size_t)s->n_dof * sizeof(double);
    double *x = allocate((size_t)s->n_dof, sizeof *x);
    double *u = allocate((size_t)s->n_dof, sizeof *u);
    double *J = allocate((size_t)s->mesh->n_triangle, sizeof *J);
    double from[2] = {0.0, 0.0}, moved[2] = {0.0, 0.0};
    int grabbed = 0, lost = 0;
    gsl_set_error_handler_off();
    while (hand_next(hand, &pointer)) {
        double to[2] = {moved[0], moved[1]};
        if (pointer.key == 'l')
            s->body->material.law = s->body->material.law == LOG ? CUBIC : LOG;
        if (pointer.key == 'r') {
            memset(s->u, 0, size);
            memset(to, 0, sizeof to);
            memset(moved, 0, sizeof moved);
        }
        if (!pointer.down) grabbed = 0;
        else if (!grabbed && fabs(pointer.x - 1.0 - moved[0]) < 0.4) {
            grabbed = 1;
            from[0] = pointer.x - moved[0];
            from[1] = pointer.y - moved[1];
        }
        if (grabbed) {
            to[0] = fmax(-1.8, fmin(1.6, pointer.x - from[0]));
            to[1] = fmax(-1.0, fmin(1.0, pointer.y - from[1]));
        }
        for (int a = 0; a < n_vertex; a++)
            for (int i = 0; i < 2; i++)
                s->g[2 * a + i] = s->held[a] && s->mesh->X[2 * a] > 0.0 ? to[i]
                                                                        : 0.0;
        memcpy(u, s->u, size);
        hand_slot("12e");
        step_boundary(s->body, s->g, 1, u);
        const struct history report = equilibrium(s, 1e-4, HISTORY_CAP, u);
        if (report.status == OK) {
            memcpy(s->u, u, size);
            memcpy(moved, to, sizeof moved);
        } else
            lost++;
        for (int r = 0; r < s->n_dof; r++) x[r] = s->mesh->X[r] + s->u[r];
        double least = INFINITY;
        for (int e = 0; e < s->mesh->n_triangle; e++) {
            double g[6];
            mesh_gradients(s->mesh, e, g);
            hand_slot("12a");
            J[e] = mat2_det(deformation(&s->mesh->triangle[3 * e], g, s->u));
            least = fmin(least, J[e]);
        }
        struct view_picture picture = {
            .n_point = n_vertex, .x = x, .n_triangle = s->mesh->n_triangle,
            .triangle = s->mesh->triangle, .value = J, .held = s->held,
            .alarm = report.status != OK};
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost, least J %.2f\n"
                 "drag the right side   [l] law: %s\n"
                 "[r] reset   [space] stop   [q] close",
                 report.status == OK ? "at rest" : "lost",
                 status_name(report.status), report.iterations, lost, least,
                 material_law(s->body->material.law));
        hand_draw(hand, &picture, "systems lost min_J",
                  (double[]){report.iterations, lost, least});
    }
    free(x);
    free(u);
    free(J);
    scene_free(s);
    return hand_close(hand);
}
