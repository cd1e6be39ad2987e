/*
 * hand.c - a square under load, and a knife: draw, and it opens as it moves.
 *
 * With the knife a held button cuts along the edges nearest to where the
 * pointer goes, from vertex to vertex, while the body moves on: a step of
 * backward Euler per frame, 1/30 s.  With the hand it drags the nearest
 * vertex.  Paths, fans and what is carried come from the program under test.
 * A frame whose step fails is lost: the body stays.  Colours: log2 J.
 */
int program_main(int argc, char *argv[]);
#define main program_main
#include PROGRAM
#undef main

#include "motion/hand.h"

#include <stdio.h>

enum { SQUARES = 12 };
static const double LOAD = 40.0;  /* N/m on the right side */
static const double REACH = 0.3;  /* m, within which a vertex is grabbed */
static const double STRIDE = 0.1; /* m, which it moves in a frame at most */

struct patient {
    struct tissue square, s; /* before any cut, and as it is */
    struct tissue_whole whole;
    struct body *body;
    int *cut;         /* marks */
    int *held, *ring; /* [n_vertex] with what the hand holds; that alone */
    double *g, *x, *J;
    int grabbed; /* a vertex, -1: none */
    int at;      /* the vertex of the whole mesh where the blade is, -1: up */
    int knife, lost;
};

/* Room and body for the state as it is now; the hand lets go. */
static void patient_renew(struct patient *p, struct tissue s)
{
    const size_t n = (size_t)s.mesh->n_vertex;
    free(p->held);
    free(p->ring);
    free(p->g);
    free(p->x);
    p->s = s;
    p->held = allocate(n, sizeof *p->held);
    p->ring = allocate(n, sizeof *p->ring);
    p->g = allocate(2 * n, sizeof *p->g);
    p->x = allocate(2 * n, sizeof *p->x);
}

static void patient_hold(struct patient *p, int vertex)
{
    p->grabbed = vertex;
    for (int a = 0; a < p->s.mesh->n_vertex; a++) {
        p->held[a] = p->s.held[a] || a == vertex;
        p->ring[a] = a == vertex;
    }
    body_free(p->body);
    p->body = body_alloc(p->s.mesh, material_notes(CUBIC), p->whole.rho, LUMPED,
                         p->held);
}

/* Open the body along the marks. */
static void patient_open(struct patient *p, const struct tissue *before)
{
    hand_slot("26b");
    struct tissue after = cut_body(&p->whole, p->cut, before);
    hand_slot("26c");
    body_free(p->body);
    p->body = NULL;
    if (before == &p->s) tissue_free(p->s);
    patient_renew(p, after);
    patient_hold(p, -1);
}

/* X of the point that is at y now: of the triangle that it is in, or by the
 * nearest vertex. */
static void patient_place(const struct patient *p, const double y[2],
                          double X[2])
{
    const struct mesh *mesh = p->s.mesh;
    int best = 0;
    double least = INFINITY;
    for (int a = 0; a < mesh->n_vertex; a++) {
        const double d = hypot(p->x[2 * a] - y[0], p->x[2 * a + 1] - y[1]);
        if (d < least) best = a, least = d;
    }
    for (int i = 0; i < 2; i++)
        X[i] = mesh->X[2 * best + i] + y[i] - p->x[2 * best + i];
    for (int e = 0; e < mesh->n_triangle; e++) {
        const int *t = &mesh->triangle[3 * e];
        const double *a = &p->x[2 * t[0]], *b = &p->x[2 * t[1]];
        const double *c = &p->x[2 * t[2]];
        const double b0 = b[0] - a[0], b1 = b[1] - a[1];
        const double c0 = c[0] - a[0], c1 = c[1] - a[1];
        const double area = b0 * c1 - b1 * c0;
        const double s = ((y[0] - a[0]) * c1 - (y[1] - a[1]) * c0) / area;
        const double r = (b0 * (y[1] - a[1]) - b1 * (y[0] - a[0])) / area;
        if (!(s >= 0.0 && r >= 0.0 && s + r <= 1.0)) continue;
        for (int i = 0; i < 2; i++)
            X[i] = (1.0 - s - r) * mesh->X[2 * t[0] + i] +
                   s * mesh->X[2 * t[1] + i] + r * mesh->X[2 * t[2] + i];
        return;
    }
}

/* On with the blade to the pointer: the path from the vertex where it was. */
static void patient_cut(struct patient *p, const struct pointer *pointer)
{
    const struct mesh *mesh = p->whole.mesh;
    double to[2];
    patient_place(p, (double[]){pointer->x, pointer->y}, to);
    const int last = p->at, next = tissue_nearest(mesh, to);
    p->at = next;
    if (last < 0 || last == next) return;
    const double *from = &mesh->X[2 * last];
    int *chain = allocate((size_t)mesh->n_vertex, sizeof *chain);
    hand_slot("26a");
    const int n = path(mesh, (double[]){from[0], from[1], to[0], to[1]}, last,
                       next, chain);
    tissue_mark(mesh, n, chain, p->cut);
    free(chain);
    patient_open(p, &p->s);
}

/* The hand holds the nearest vertex, and takes it along. */
static void patient_drag(struct patient *p, const struct pointer *pointer)
{
    if (p->grabbed < 0 && pointer->down) {
        const int a =
            hand_nearest(pointer, p->s.mesh->n_vertex, p->x, REACH);
        if (a >= 0 && !p->s.held[a]) patient_hold(p, a);
    }
    if (p->grabbed >= 0 && !pointer->down) patient_hold(p, -1);
    if (p->grabbed < 0) return;
    const int a = 2 * p->grabbed;
    const double d[2] = {pointer->x - p->x[a], pointer->y - p->x[a + 1]};
    const double part = fmin(1.0, STRIDE / fmax(hypot(d[0], d[1]), 1e-9));
    for (int i = 0; i < 2; i++) p->g[a + i] = p->s.u[a + i] + part * d[i];
}

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("26", HAND_WHOSE, "gr", argc, argv);
    struct step_control newton = step_method("demand+search");
    struct patient p = {.square = tissue_alloc(mesh_square(SQUARES)),
                        .knife = 1};
    struct pointer pointer;
    gsl_set_error_handler_off();
    newton.tolerance = 1e-6;
    p.whole = tissue_hold(&p.square, LOAD);
    const int corners = 3 * p.whole.mesh->n_triangle;
    p.cut = allocate((size_t)corners, sizeof *p.cut);
    p.J = allocate((size_t)corners, sizeof *p.J);
    for (int fresh = 1; hand_next(hand, &pointer);) {
        if (pointer.key == 'r') fresh = 2;
        if (fresh) {
            memset(p.cut, 0, (size_t)corners * sizeof *p.cut);
            body_free(p.body);
            p.body = NULL;
            if (fresh == 2) tissue_free(p.s);
            patient_open(&p, &p.square);
            p.at = -1;
            fresh = 0;
        }
        const int n = p.s.mesh->n_vertex;
        for (int r = 0; r < 2 * n; r++) p.x[r] = p.s.mesh->X[r] + p.s.u[r];
        if (pointer.key == 'g') p.knife = !p.knife;
        if (p.knife && pointer.down) patient_cut(&p, &pointer);
        else p.at = -1;
        const struct mesh *mesh = p.s.mesh;
        for (int r = 0; r < 2 * mesh->n_vertex; r++)
            p.x[r] = mesh->X[r] + p.s.u[r];
        if (!p.knife) patient_drag(&p, &pointer);
        else if (p.grabbed >= 0) patient_hold(&p, -1);
        hand_slot(NULL);
        const struct step_report report =
            step_backward_euler(p.body, &newton, 1.0 / 30.0, p.g, p.s.f, p.s.u,
                                p.s.v, NULL);
        p.lost += report.status != OK;

        double energy = 0.0, mass = 0.0, least = INFINITY;
        body_energy(p.body, p.s.u, &energy);
        for (int a = 0; a < mesh->n_vertex; a++) mass += p.s.mass[a];
        for (int r = 0; r < 2 * mesh->n_vertex; r++)
            p.x[r] = mesh->X[r] + p.s.u[r];
        for (int e = 0; e < mesh->n_triangle; e++) {
            p.J[e] = mat2_det(body_deformation(p.body, p.s.u, e));
            least = fmin(least, p.J[e]);
        }
        int loose;
        const int parts = tissue_parts(&p.s, &loose);
        struct view_picture picture = {
            .n_point = mesh->n_vertex, .x = p.x, .n_triangle = mesh->n_triangle,
            .triangle = mesh->triangle, .value = p.J, .held = p.s.held,
            .ring = p.ring, .alarm = report.status != OK};
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "%d vertices, %d parts, %d loose; mass %.4f kg, "
                 "elastic %.3g J\n"
                 "[g] %s   [r] whole again   [space] stop   [q] close",
                 report.status == OK ? "moves" : "lost",
                 status_name(report.status), report.iterations, p.lost,
                 mesh->n_vertex, parts, loose, mass, energy,
                 p.knife ? "knife: hold and draw" : "hand: drag a vertex");
        hand_draw(hand, &picture, "systems lost vertices parts mass min_J",
                  (double[]){report.iterations, p.lost, mesh->n_vertex, parts,
                             mass, least});
    }
    return hand_close(hand);
}
