/* window.c - window.h by the window of view.h. */
#include "motion/window.h"

#include "motion/caption.h"
#include "motion/view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct window {
    struct view *view;
    int mouse;
    int frames, saved, last; /* by the second rung: how many, the last one */
};

struct window *window_open(void)
{
    struct window *w = allocate(1, sizeof *w);
    w->view = view_open("Elasticity Workbook: lesson 24", 1);
    if (!w->view) return free(w), NULL;
    return w;
}

void window_close(struct window *w)
{
    if (w) view_close(w->view);
    free(w);
}

int window_next(struct window *w, struct pointers *input, int k, int mouse)
{
    struct pointer p;
    if (w && !view_next(w->view, POINTER_KEYS, &p)) return 0;
    if (w && mouse) pointers_add(input, p);
    if (w) w->mouse = mouse;
    return k < input->n;
}

/* Draw black squares where the body is held, red rings round its knots. */
void window_draw(struct window *w, const struct live *live,
                 const struct live_report *report, double seconds,
                 const char *shot)
{
    const struct mesh *mesh = live->mesh;
    const size_t n = (size_t)mesh->n_vertex;
    double *x = allocate(2 * n, sizeof *x);
    double *J = allocate((size_t)mesh->n_triangle, sizeof *J);
    int *held = allocate(n, sizeof *held), *knot = allocate(n, sizeof *knot);
    struct view_picture picture = {
        .n_point = mesh->n_vertex, .x = x, .n_triangle = mesh->n_triangle,
        .triangle = mesh->triangle, .value = J, .held = held, .ring = knot,
        .alarm = strcmp(report->rung, "lost") == 0};
    for (int r = 0; r < live->n_dof && r < 2 * mesh->n_vertex; r++)
        x[r] = mesh->X[r] + live->now.u[r];
    for (int e = 0; e < mesh->n_triangle; e++)
        J[e] = mat2_det(body_deformation(live->body, live->now.u, e));
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = live->body->equation[2 * a] < 0;
    caption_of(live, report, seconds, picture.caption);
    if (w->mouse)
        strncat(picture.caption, "   drag with the mouse",
                sizeof picture.caption - strlen(picture.caption) - 1);
    w->frames++;
    if (strcmp(report->rung, "downhill") == 0) {
        w->saved++;
        w->last = w->frames;
    }
    snprintf(picture.note, sizeof picture.note,
             "min J %.2f, %d knots\ndownhill saved %d frames%s",
             body_min_J(live->body, live->now.u),
             live_knots(mesh, live->now.u, knot), w->saved,
             w->saved && w->frames < w->last + 30 ? ", just now" : "");
    view_draw(w->view, &picture, seconds, shot);
    free(x);
    free(J);
    free(held);
    free(knot);
}
