/*
 * hand.c - a square under load, and a knife: draw, and it opens as it moves; or
 * the strip of tissue of the pages, without a load.
 *
 * With the knife a held button cuts along the edges nearest to where the
 * pointer goes, from vertex to vertex, while the body moves on: a step of
 * backward Euler per frame, 1/30 s.  With the hand it drags the nearest
 * vertex.  Loose parts can be taken away: they are laid down beside the window,
 * at rest and held.  Undo makes all as it was before the last stroke, or before
 * they were taken.  Paths, fans and what is carried come from the program under
 * test.  A frame whose step fails is lost: the body stays.  Colours: log2 J.
 *
 * Books are kept: mass_off is the relative error of the mass, with what was
 * taken away; jumped is what a cut has done to the energy E, over 1 J + E;
 * gained is the energy (J) that a step leaves beyond what was there and the
 * work of load and hand.  Backward Euler loses some, and gains nothing as long
 * as Psi is convex between the two states: of a crushed body it is not.
 */
#include "motion/hand.h"

#include <stdio.h>

#ifndef SQUARES
#define SQUARES 12
#endif
static const double LOAD = 40.0;  /* N/m on the right side */
static const double REACH = 0.3;  /* m, within which a vertex is grabbed */
static const double STRIDE = 0.1; /* m, which it moves in a frame at most */
static const double ASIDE = 10.0; /* m, by which a part is taken away */
static const double DT = 1.0 / 30.0;

#define COLUMNS "lost vertices parts taken mass_off jumped gained min_J"
enum { LOST, VERTICES, PARTS, TAKEN, MASS_OFF, JUMPED, GAINED, MIN_J, NUMBERS };

struct patient {
    struct tissue square, s; /* before any cut, and as it is */
    struct tissue_whole whole;
    struct body *body;
    int *cut;         /* marks */
    struct tissue before; /* the last stroke: for undo; mesh NULL: none */
    int *cut_before;
    int stroke;       /* begun, and undo knows what was before */
    int *held, *ring; /* [n_vertex] with what the hand holds; that alone */
    double *g, *x, *q, *J;
    double energy;    /* after the last frame, without what was taken (J) */
    int systems;
    int grabbed; /* a vertex, -1: none */
    int at;      /* the vertex of the whole mesh where the blade is, -1: up */
    int knife, lost;
    int strip;   /* of tissue, not the square */
    double mass; /* before any cut (kg) */
};

/* Room and body for the state as it is now; the hand lets go. */
static void patient_renew(struct patient *p, struct tissue s)
{
    const size_t n = (size_t)s.mesh->n_vertex;
    free(p->held);
    free(p->ring);
    free(p->g);
    free(p->x);
    free(p->q);
    p->s = s;
    p->held = allocate(n, sizeof *p->held);
    p->ring = allocate(n, sizeof *p->ring);
    p->g = allocate(2 * n, sizeof *p->g);
    p->x = allocate(2 * n, sizeof *p->x);
    p->q = allocate(2 * n, sizeof *p->q);
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

static double patient_energy(const struct patient *p)
{
    double energy = 0.0;
    body_energy(p->body, p->s.u, &energy);
    for (int r = 0; r < 2 * p->s.mesh->n_vertex; r++)
        energy += 0.5 * p->s.mass[r / 2] * p->s.v[r] * p->s.v[r];
    return energy;
}

/* Open the body along the marks. */
static void patient_open(struct patient *p, const struct tissue *before)
{
    hand_slot("26b");
    struct tissue after = cut_body(&p->whole, p->cut, before);
    hand_slot("26c");
    if (before == &p->s) tissue_free(p->s);
    patient_renew(p, after);
    patient_hold(p, -1);
}

/* What undo comes back to. */
static void patient_save(struct patient *p)
{
    const size_t marks = 3 * (size_t)p->whole.mesh->n_triangle;
    if (p->before.mesh) tissue_free(p->before);
    p->before = cut_body(&p->whole, p->cut, &p->s); /* a copy */
    memcpy(p->cut_before, p->cut, marks * sizeof *p->cut);
}

static void patient_undo(struct patient *p)
{
    if (!p->before.mesh) return;
    const size_t marks = 3 * (size_t)p->whole.mesh->n_triangle;
    memcpy(p->cut, p->cut_before, marks * sizeof *p->cut);
    tissue_free(p->s);
    patient_renew(p, p->before);
    p->before.mesh = NULL;
    patient_hold(p, -1);
    p->energy = patient_energy(p);
    p->at = -1;
}

/* Lay the loose parts down beside the window, with their energy. */
static void patient_excise(struct patient *p)
{
    const int n = p->s.mesh->n_vertex;
    int loose, *part = allocate((size_t)n, sizeof *part);
    int *holds = allocate((size_t)n, sizeof *holds);
    tissue_parts(&p->s, &loose);
    if (loose) {
        patient_save(p);
        p->energy -= patient_energy(p);
        tissue_label(p->s.mesh, part);
        for (int a = 0; a < n; a++) holds[part[a]] += p->s.held[a];
        for (int a = 0; a < n; a++) {
            if (holds[part[a]] >= 2) continue;
            p->s.held[a] = 1;
            p->s.u[2 * a] = ASIDE;
            p->s.u[2 * a + 1] = p->s.v[2 * a] = p->s.v[2 * a + 1] = 0.0;
        }
        patient_hold(p, -1);
        p->energy += patient_energy(p);
    }
    free(holds);
    free(part);
}

/* The vertex of the whole mesh that is nearest to the pointer now. */
static int patient_nearest(const struct patient *p,
                           const struct pointer *pointer)
{
    const struct mesh *mesh = p->s.mesh;
    int best = 0;
    double least = INFINITY;
    for (int c = 0; c < 3 * mesh->n_triangle; c++) {
        const double *x = &p->x[2 * mesh->triangle[c]];
        const double d = hypot(x[0] - pointer->x, x[1] - pointer->y);
        if (d < least) best = p->whole.mesh->triangle[c], least = d;
    }
    return best;
}

/* On with the blade to the pointer: the path from the vertex where it was. */
static void patient_cut(struct patient *p, const struct pointer *pointer)
{
    const struct mesh *mesh = p->whole.mesh;
    const int last = p->at, next = patient_nearest(p, pointer);
    p->at = next;
    if (last < 0 || last == next) return;
    if (!p->stroke) patient_save(p);
    p->stroke = 1;
    const double *from = &mesh->X[2 * last], *to = &mesh->X[2 * next];
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
            hand_grab(-1, pointer, p->s.mesh->n_vertex, p->x, REACH);
        if (a >= 0 && !p->s.held[a]) patient_hold(p, a);
    }
    if (p->grabbed >= 0 && !pointer->down) patient_hold(p, -1);
    if (p->grabbed < 0) return;
    const int a = 2 * p->grabbed;
    const double d[2] = {pointer->x - p->x[a], pointer->y - p->x[a + 1]};
    const double part = fmin(1.0, STRIDE / fmax(hypot(d[0], d[1]), 1e-9));
    for (int i = 0; i < 2; i++) p->g[a + i] = p->s.u[a + i] + part * d[i];
}

static void patient_alloc(struct patient *p, int strip)
{
    *p = (struct patient){.square = strip ? tissue_strip()
                                          : tissue_alloc(mesh_square(SQUARES)),
                          .knife = 1, .strip = strip,
                          .mass = strip ? 3.0 : 4.0};
    p->whole = strip ? tissue_on_bone(&p->square)
                     : tissue_hold(&p->square, LOAD);
    const size_t corners = 3 * (size_t)p->whole.mesh->n_triangle;
    p->cut = allocate(corners, sizeof *p->cut);
    p->cut_before = allocate(corners, sizeof *p->cut_before);
    p->J = allocate(corners, sizeof *p->J);
}

static void patient_free(struct patient *p)
{
    body_free(p->body);
    if (p->before.mesh) tissue_free(p->before);
    tissue_free(p->s);
    tissue_free(p->square);
    free(p->whole.across);
    free(p->whole.pulled);
    void *room[] = {p->cut, p->cut_before, p->held, p->ring,
                    p->g,   p->x,          p->q,    p->J};
    for (int k = 0; k < COUNT(room); k++) free(room[k]);
}

static void patient_place_all(struct patient *p)
{
    for (int r = 0; r < 2 * p->s.mesh->n_vertex; r++)
        p->x[r] = p->s.mesh->X[r] + p->s.u[r];
}

/* The whole square, at rest without a load. */
static void patient_reset(struct patient *p)
{
    memset(p->cut, 0, 3 * (size_t)p->whole.mesh->n_triangle * sizeof *p->cut);
    if (p->before.mesh) tissue_free(p->before);
    p->before.mesh = NULL;
    if (p->s.mesh) tissue_free(p->s);
    patient_open(p, &p->square);
    p->energy = 0.0;
    p->at = -1;
}

/* A step, and the work (J) of the load and of the hand in it: what holds a
 * vertex is q / dt^2 there. */
static struct step_report patient_step(struct patient *p, double *work)
{
    const int rows = 2 * p->s.mesh->n_vertex;
    double *u0 = p->x, *q = p->q;
    struct step_control newton = step_method("demand+search");
    newton.tolerance = 1e-6;
    for (int r = 0; r < rows; r++) {
        u0[r] = p->s.u[r];
        if (p->s.held[r / 2]) p->g[r] = u0[r]; /* also where it was laid */
    }
    double *predicted = allocate((size_t)rows, sizeof *predicted);
    for (int r = 0; r < rows; r++)
        predicted[r] = p->s.u[r] + DT * p->s.v[r];
    const struct step_report report = step_backward_euler(
        p->body, &newton, DT, p->g, p->s.f, p->s.u, p->s.v, NULL);
    *work = 0.0;
    if (report.status == OK &&
        body_assemble(p->body, (struct incremental){DT, predicted, p->s.f},
                      p->s.u, NO_TANGENT, q) == OK)
        for (int r = 0; r < rows; r++)
            *work += (p->s.f[r] + (p->held[r / 2] ? q[r] / (DT * DT) : 0.0)) *
                     (p->s.u[r] - u0[r]);
    free(predicted);
    return report;
}

/* One frame; number[] has the COLUMNS. */
static enum status patient_frame(struct patient *p,
                                 const struct pointer *pointer,
                                 double number[NUMBERS])
{
    double work, mass = 0.0, taken = 0.0, least = INFINITY;
    int loose;
    if (pointer->key == 's' && p->body) {
        const int strip = !p->strip;
        patient_free(p);
        patient_alloc(p, strip);
    }
    if (!p->body || pointer->key == 'r') patient_reset(p);
    if (pointer->key == 'g') p->knife = !p->knife;
    if (pointer->key == 'e') patient_excise(p);
    if (pointer->key == '-') patient_undo(p);
    patient_place_all(p);
    if (p->knife && pointer->down) patient_cut(p, pointer);
    else p->at = -1, p->stroke = 0;
    patient_place_all(p);
    if (!p->knife) patient_drag(p, pointer);
    else if (p->grabbed >= 0) patient_hold(p, -1);
    hand_slot(NULL);
    const double start = patient_energy(p);
    const struct step_report report = patient_step(p, &work);
    p->systems = report.iterations;
    p->lost += report.status != OK;
    const double energy = patient_energy(p);
    const struct mesh *mesh = p->s.mesh;
    patient_place_all(p);
    for (int a = 0; a < mesh->n_vertex; a++) {
        mass += p->s.mass[a];
        taken += p->s.u[2 * a] == ASIDE && p->s.held[a] ? p->s.mass[a] : 0.0;
    }
    for (int e = 0; e < mesh->n_triangle; e++) {
        p->J[e] = mat2_det(body_deformation(p->body, p->s.u, e));
        least = fmin(least, p->J[e]);
    }
    number[LOST] = p->lost;
    number[VERTICES] = mesh->n_vertex;
    number[PARTS] = tissue_parts(&p->s, &loose);
    number[TAKEN] = taken;
    number[MASS_OFF] = fabs(mass - p->mass) / p->mass;
    number[JUMPED] = fabs(start - p->energy) / (1.0 + p->energy);
    number[GAINED] = energy - start - work;
    number[MIN_J] = least;
    p->energy = energy;
    return report.status;
}

#ifndef SCRIPTS /* scripts.c needs no window */
int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("26", HAND_WHOSE, "e-grs", argc, argv);
    struct patient p;
    struct pointer pointer;
    double number[NUMBERS];
    patient_alloc(&p, 0);
    while (hand_next(hand, &pointer)) {
        const enum status status = patient_frame(&p, &pointer, number);
        struct view_picture picture = hand_triangles(p.s.mesh, p.x, p.J);
        picture.held = p.s.held;
        picture.ring = p.ring;
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "%d vertices, parts: %.0f, %.4f kg away, energy %.3g J\n"
                 "[g] %s   [e] take loose parts away\n[-] undo   [s] body: %s",
                 status == OK ? "moves" : "lost", status_name(status),
                 p.systems, p.lost, p.s.mesh->n_vertex, number[PARTS],
                 number[TAKEN], p.energy,
                 p.knife ? "knife: hold and draw" : "hand: drag a vertex",
                 p.strip ? "strip of tissue" : "square");
        hand_draw(hand, &picture, status, COLUMNS, number);
    }
    patient_free(&p);
    return hand_close(hand);
}
#endif
