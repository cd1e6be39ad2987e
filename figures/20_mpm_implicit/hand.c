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
int program_main(int argc, char *argv[]);
#define main program_main
#include PROGRAM
#undef main

#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { N = 48 };
static const double HAND_H = 0.25, HAND_EDGE[2] = {2.4, 1.8};

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

/* Corners of particle q and its triangles. */
static void hand_draw_particle(const struct particles *p, int q, double x[8],
                               int triangle[6], double J[2])
{
    const double half = 0.5 * sqrt(p->volume[q]);
    for (int c = 0; c < 4; c++) {
        const double X[2] = {c == 0 || c == 3 ? -half : half,
                             c < 2 ? -half : half};
        for (int i = 0; i < 2; i++)
            x[2 * c + i] = p->x[2 * q + i] + p->F[q].m[i][0] * X[0] +
                           p->F[q].m[i][1] * X[1];
    }
    for (int k = 0; k < 6; k++)
        triangle[k] = 4 * q + (const int[]){0, 1, 2, 0, 2, 3}[k];
    J[0] = J[1] = mat2_det(p->F[q]);
}

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("20", HAND_WHOSE, "slprs", argc, argv);
    struct cloud c = hand_block(), before = hand_block();
    struct material material = material_notes(CUBIC);
    struct particle_step step = {.rate = 30.0, .transfer = FLIP};
    struct pointer pointer;
    double x[8 * N], J[2 * N], offset[2 * N], nail[2 * N];
    int triangle[6 * N], held[N] = {0}, n_held = 0, nailed = 0, lost = 0;
    while (hand_next(hand, &pointer)) {
        const double at[2] = {fmax(-2.3, fmin(2.3, pointer.x)),
                              fmax(-1.7, fmin(1.7, pointer.y))};
        double least = INFINITY;
        if (pointer.key == 'l')
            material.law = material.law == LOG ? CUBIC : LOG;
        if (pointer.key == 'p')
            step.transfer = step.transfer == PIC ? FLIP : PIC;
        if (pointer.key == 's') nailed = !nailed;
        if (pointer.key == 'r') {
            cloud_free(c);
            c = hand_block();
        }
        if (!pointer.down) n_held = 0;
        const int grabs = pointer.down && n_held == 0;
        for (int q = 0; q < N; q++) {
            double *xq = &c.p->x[2 * q], *v = &c.p->v[2 * q];
            if (grabs) held[q] = hypot(xq[0] - at[0], xq[1] - at[1]) < 0.35;
            n_held += grabs && held[q];
            for (int i = 0; i < 2; i++) {
                double *from = &offset[2 * q + i], to = xq[i];
                if (grabs) *from = xq[i] - at[i];
                if (pointer.key == 's') nail[2 * q + i] = xq[i];
                if (nailed && q % 8 < 2) to = nail[2 * q + i];
                else if (pointer.down && held[q]) to = at[i] + *from;
                if (to != xq[i]) v[i] = step.rate * (to - xq[i]);
                v[i] = fmax(-6.0, fmin(6.0, v[i])); /* less than a cell */
                const double beyond = fabs(xq[i]) - HAND_EDGE[i];
                if (beyond > 0.0)
                    v[i] = copysign(fmax(0.5 * fabs(v[i]), 20.0 * beyond),
                                    -xq[i]);
            }
        }
        hand_copy(c.p, before.p);
        hand_slot("20c");
        const struct particle_report report = advance(c, material, &step);
        if (report.status != OK) hand_copy(before.p, c.p);
        hand_round(c.p);
        lost += report.status != OK;
        for (int q = 0; q < N; q++) {
            hand_draw_particle(c.p, q, &x[8 * q], &triangle[6 * q], &J[2 * q]);
            least = fmin(least, J[2 * q]);
        }
        struct view_picture picture = {
            .n_point = 4 * N, .x = x, .n_triangle = 2 * N, .value = J,
            .triangle = triangle, .alarm = report.status != OK};
        const int parts = hand_parts(c.p);
        snprintf(picture.caption, sizeof picture.caption,
                 "%d part%s, least J %.2f\n"
                 "%s: %s, %d systems, %d frames lost\n"
                 "[p] %s   [l] law: %s   [s] left end: %s\n"
                 "hold it, throw it, tear it   [r] reset",
                 parts, parts > 1 ? "s" : "", least,
                 report.status == OK ? "moves" : "lost",
                 status_name(report.status), report.iterations, lost,
                 transfer_name(step.transfer), material_law(material.law),
                 nailed ? "nailed" : "free");
        hand_draw(hand, &picture, "parts systems lost least_J",
                  (double[]){parts, report.iterations, lost, least});
    }
    cloud_free(c);
    cloud_free(before);
    return hand_close(hand);
}
