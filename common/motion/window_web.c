/* window_web.c - window.h on a page: a script has canvas, buttons and clock.
 * window_next() waits for it by Asyncify, without a busy wait. */
#include "motion/window.h"

#include "motion/caption.h"

#include <emscripten.h>
#include <stdlib.h>
#include <string.h>

struct window {
    int lost; /* frames so far */
};

/* The page's next frame: x, y, down and the key's code, all of them doubles;
 * false: the window was closed. */
EM_ASYNC_JS(int, page_next, (int mouse, double *now), {
    const pointer = await Module.page.next(mouse);
    if (pointer) HEAPF64.set(pointer, now >> 3);
    return pointer ? 1 : 0;
});

/* The arrays are borrowed until the call returns: x and rest [2 n_vertex], held
 * and knot [n_vertex], triangle [3 n_triangle], J [n_triangle]. */
EM_JS(void, page_draw, (int n_vertex, const double *x, const double *rest,
                        const int *held, const int *knot, int n_triangle,
                        const int *triangle, const double *J, double ms,
                        int lost, const char *text), {
    const real = (at, n) => HEAPF64.subarray(at >> 3, (at >> 3) + n);
    const whole = (at, n) => HEAP32.subarray(at >> 2, (at >> 2) + n);
    Module.page.draw({
        x: real(x, 2 * n_vertex), rest: real(rest, 2 * n_vertex),
        held: whole(held, n_vertex), knot: whole(knot, n_vertex),
        triangle: whole(triangle, 3 * n_triangle), J: real(J, n_triangle),
        ms: ms, lost: lost, text: UTF8ToString(text)});
});

EM_JS(void, page_close, (void), { Module.page.close(); });

struct window *window_open(void)
{
    struct window *w = allocate(1, sizeof *w);
    return w;
}

void window_close(struct window *w)
{
    page_close();
    free(w);
}

int window_next(struct window *w, struct pointers *input, int k, int mouse)
{
    double now[4] = {0.0};
    (void)w;
    if (!page_next(mouse, now)) return 0;
    const struct pointer p = {now[0], now[1], now[2] > 0.0, (char)now[3]};
    if (mouse) pointers_add(input, p);
    return k < input->n;
}

void window_draw(struct window *w, const struct live *live,
                 const struct live_report *report, double seconds,
                 const char *shot)
{
    const struct mesh *mesh = live->mesh;
    const size_t n = (size_t)mesh->n_vertex;
    double *x = allocate(2 * n, sizeof *x);
    double *J = allocate((size_t)mesh->n_triangle, sizeof *J);
    int *held = allocate(n, sizeof *held);
    int *knot = allocate(n, sizeof *knot);
    char text[CAPTION];
    (void)shot; /* a browser has a way of its own */
    live_knots(mesh, live->now.u, knot);
    for (int r = 0; r < live->n_dof; r++) x[r] = mesh->X[r] + live->now.u[r];
    for (size_t a = 0; a < n; a++) held[a] = live->body->equation[2 * a] < 0;
    for (int e = 0; e < mesh->n_triangle; e++)
        J[e] = mat2_det(body_deformation(live->body, live->now.u, e));
    w->lost += strcmp(report->rung, "lost") == 0;
    caption_of(live, report, seconds, text);
    page_draw(mesh->n_vertex, x, mesh->X, held, knot, mesh->n_triangle,
              mesh->triangle, J, 1e3 * seconds, w->lost, text);
    free(x);
    free(J);
    free(held);
    free(knot);
}
