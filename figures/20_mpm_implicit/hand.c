/*
 * hand.c - a block of particles in your hand: hold some of them, throw the
 * block, pull it apart, and put it together again.
 *
 * A frame is one implicit step of the program under test, 1/30 s; one that
 * fails is lost.  The hand sets the velocity of what it holds, as nails do of
 * the left end, and the edges of the window throw back.  What shares no node
 * of the grid is apart, whatever the material is: numerical fracture.  Each
 * particle is drawn as what F makes of its square; colours: log2 J.
 */
#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { N = 48 };
static const double HAND_H = 0.25, HAND_EDGE[2] = {2.4, 1.8};

struct hand_scene {
    struct cloud c, before;
    struct material material;
    struct particle_step step;
    int held[N], triangle[6 * N], n_held, nailed, lost;
    double offset[2 * N], nail[2 * N]; /* from the hand; where nailed (m) */
    double x[8 * N], J[2 * N], least;
};

static struct cloud hand_block(void)
{
    const double low[2] = {-4.0, -3.5};
    const double box[2][2] = {{-0.5, -0.375}, {0.5, 0.375}};
    const int nodes[2] = {33, 29}, count[2] = {8, 6};
    return (struct cloud){grid_alloc(2, low, HAND_H, nodes),
                          particles_box(box[0], box[1], count, 30.0)};
}

/* Rounded to 1e-9: what collides makes much of round-off. */
static void hand_round(struct particles *p)
{
    for (int r = 0; r < 2 * N; r++) {
        double *F = p->F[r / 2].m[r % 2];
        for (int k = 0; k < 2; k++) F[k] = 1e-9 * rint(1e9 * F[k]);
        p->x[r] = 1e-9 * rint(1e9 * p->x[r]);
        p->v[r] = 1e-9 * rint(1e9 * p->v[r]);
    }
}

static void hand_copy(const struct particles *from, struct particles *to)
{
    memcpy(to->x, from->x, 2 * N * sizeof *to->x);
    memcpy(to->v, from->v, 2 * N * sizeof *to->v);
    memcpy(to->F, from->F, N * sizeof *to->F);
}

/* How many parts there are: two particles share a node if the nodes nearest to
 * them are at most two cells apart. */
static int hand_parts(const struct particles *p)
{
    int part[N], parts = N;
    for (int q = 0; q < N; q++) part[q] = q;
    for (int k = 0; k < N * N; k++) {
        const int q = k / N, r = k % N, mine = part[q], other = part[r];
        int apart = mine == other;
        for (int i = 0; i < 2; i++)
            apart |= fabs(rint(p->x[2 * q + i] / HAND_H) -
                          rint(p->x[2 * r + i] / HAND_H)) > 2.0;
        for (int a = 0; a < N && !apart; a++)
            if (part[a] == other) part[a] = mine;
        parts -= !apart;
    }
    return parts;
}

/* Keys; and velocities by the hand, the nails and the edges. */
static void hand_input(struct hand_scene *h, const struct pointer *pointer)
{
    enum law *law = &h->material.law;
    if (pointer->key == 'l') *law = *law == LOG ? CUBIC : LOG;
    if (pointer->key == 'p')
        h->step.transfer = h->step.transfer == PIC ? FLIP : PIC;
    if (pointer->key == 's') h->nailed = !h->nailed;
    if (pointer->key == 'r') {
        cloud_free(h->c);
        h->c = hand_block();
    }
    if (!pointer->down) h->n_held = 0;
    const double at[2] = {fmax(-2.3, fmin(2.3, pointer->x)),
                          fmax(-1.7, fmin(1.7, pointer->y))};
    const int grabs = pointer->down && h->n_held == 0;
    for (int q = 0; q < N; q++) {
        double *x = &h->c.p->x[2 * q], *v = &h->c.p->v[2 * q];
        if (grabs) h->held[q] = hypot(x[0] - at[0], x[1] - at[1]) < 0.35;
        h->n_held += grabs && h->held[q];
        for (int i = 0; i < 2; i++) {
            double *from = &h->offset[2 * q + i], to = x[i];
            if (grabs) *from = x[i] - at[i];
            if (pointer->key == 's') h->nail[2 * q + i] = x[i];
            if (h->nailed && q % 8 < 2) to = h->nail[2 * q + i];
            else if (pointer->down && h->held[q]) to = at[i] + *from;
            if (to != x[i]) v[i] = h->step.rate * (to - x[i]);
            v[i] = fmax(-6.0, fmin(6.0, v[i])); /* less than a cell */
            const double beyond = fabs(x[i]) - HAND_EDGE[i];
            if (beyond > 0.0)
                v[i] = copysign(fmax(0.5 * fabs(v[i]), 20.0 * beyond), -x[i]);
        }
    }
}

static struct particle_report hand_frame(struct hand_scene *h)
{
    hand_copy(h->c.p, h->before.p);
    hand_slot("20c");
    const struct particle_report report = advance(h->c, h->material, &h->step);
    if (report.status != OK) hand_copy(h->before.p, h->c.p);
    hand_round(h->c.p);
    h->lost += report.status != OK;
    return report;
}

static struct view_picture hand_picture(struct hand_scene *h)
{
    const struct particles *p = h->c.p;
    for (int k = 0; k < 4 * N; k++) { /* a corner */
        const int q = k / 4, c = k % 4;
        const double half = 0.5 * sqrt(p->volume[q]);
        const double X[2] = {c == 0 || c == 3 ? -half : half,
                             c < 2 ? -half : half};
        for (int i = 0; i < 2; i++)
            h->x[2 * k + i] = p->x[2 * q + i] + p->F[q].m[i][0] * X[0] +
                              p->F[q].m[i][1] * X[1];
    }
    h->least = INFINITY;
    for (int e = 0; e < 2 * N; e++) {
        for (int a = 0; a < 3; a++)
            h->triangle[3 * e + a] = e / 2 * 4 + (a ? a + e % 2 : 0);
        h->J[e] = mat2_det(p->F[e / 2]);
        h->least = fmin(h->least, h->J[e]);
    }
    return (struct view_picture){
        .n_point = 4 * N, .x = h->x, .n_triangle = 2 * N, .value = h->J,
        .triangle = h->triangle};
}

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("20", HAND_WHOSE, "slprs", argc, argv);
    struct hand_scene h = {
        .c = hand_block(), .before = hand_block(),
        .material = material_notes(CUBIC),
        .step = {.rate = 30.0, .transfer = FLIP}};
    struct pointer pointer;
    while (hand_next(hand, &pointer)) {
        hand_input(&h, &pointer);
        const struct particle_report report = hand_frame(&h);
        struct view_picture picture = hand_picture(&h);
        const int parts = hand_parts(h.c.p), ok = report.status == OK;
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "%d part%s, least J %.2f   hold it, throw it, tear it\n"
                 "[p] transfer: %s   [l] law: %s   [s] left end: %s",
                 ok ? "moves" : "lost", status_name(report.status),
                 report.iterations, h.lost, parts, parts > 1 ? "s" : "",
                 h.least, transfer_name(h.step.transfer),
                 material_law(h.material.law), h.nailed ? "nailed" : "free");
        hand_draw(hand, &picture, report.status,
                  "parts systems lost least_J",
                  (double[]){parts, report.iterations, h.lost, h.least});
    }
    cloud_free(h.c);
    cloud_free(h.before);
    return hand_close(hand);
}
