/* side.c - see side.h. */
#include "motion/side.h"

#include "motion/hand.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct side *side_alloc(enum law law, int n, int slender)
{
    struct side *side = allocate(1, sizeof *side);
    for (int held = 0; held <= 1; held++) {
        struct scene_setting set =
            scene_notes(held ? STRETCH : GRAVITY, law, n);
        set.force = 0.0;
        set.slender = slender;
        side->scene[held] = scene_alloc(&set);
    }
    side->now = side->scene[0];
    const size_t n_dof = (size_t)side->now->n_dof;
    side->x = allocate(n_dof, sizeof *side->x);
    side->start = allocate(n_dof, sizeof *side->start);
    side->J = allocate((size_t)side->now->mesh->n_triangle, sizeof *side->J);
    return side;
}

void side_free(struct side *side)
{
    for (int held = 0; held <= 1; held++) scene_free(side->scene[held]);
    free(side->x);
    free(side->J);
    free(side->start);
    free(side);
}

int side_held(const struct side *side) { return side->now == side->scene[1]; }

/* Go on in the other scene with the state of this. */
static void change(struct side *side)
{
    struct scene *s = side->scene[!side_held(side)];
    const size_t size = (size_t)s->n_dof * sizeof(double);
    memcpy(s->u, side->now->u, size);
    memcpy(s->v, side->now->v, size);
    memcpy(s->v_before, side->now->v_before, size);
    s->steps = side->now->steps;
    side->now = s;
}

struct scene *side_next(struct side *side, const struct pointer *p)
{
    const struct mesh *mesh = side->now->mesh;
    const int n = mesh->n;
    if (p->key == 'r') scene_rest(side->now);
    for (int k = 0; k < 2 && p->key == 'l'; k++) {
        enum law *law = &side->scene[k]->body->material.law;
        *law = *law == LOG ? CUBIC : LOG;
    }
    if (side_held(side) && (!p->down || p->key == 'r')) change(side);
    double near = 0.5; /* within reach (m) */
    for (int a = n; a < mesh->n_vertex && p->down && !side_held(side);
         a += n + 1) {
        const double *X = &mesh->X[2 * a], *u = &side->now->u[2 * a];
        near = fmin(near, hypot(X[0] + u[0] - p->x, X[1] + u[1] - p->y));
    }
    if (near < 0.5) {
        change(side);
        side->from[0] = p->x;
        side->from[1] = p->y;
        memcpy(side->start, side->now->u,
               (size_t)side->now->n_dof * sizeof *side->start);
    }
    struct scene *s = side->now;
    memset(s->g, 0, (size_t)s->n_dof * sizeof *s->g);
    for (int a = n; a < mesh->n_vertex && side_held(side); a += n + 1) {
        /* x = X + u goes along with the pointer */
        s->g[2 * a] = side->start[2 * a] + p->x - side->from[0];
        s->g[2 * a + 1] = side->start[2 * a + 1] + p->y - side->from[1];
    }
    return s;
}

struct view_picture side_picture(struct side *side)
{
    const struct scene *s = side->now;
    side->min_J = INFINITY;
    for (int r = 0; r < s->n_dof; r++) side->x[r] = s->mesh->X[r] + s->u[r];
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        side->J[e] = mat2_det(body_deformation(s->body, s->u, e));
        side->min_J = fmin(side->min_J, side->J[e]);
    }
    struct view_picture picture = hand_triangles(s->mesh, side->x, side->J);
    picture.held = s->held;
    return picture;
}

double side_energy(struct side *side, struct view_picture *picture)
{
    const struct scene *s = side->now;
    double *Mv = allocate((size_t)s->n_dof, sizeof *Mv);
    double energy = scene_energy(s);
    body_mass(s->body, s->v, Mv);
    for (int r = 0; r < s->n_dof; r++) energy += 0.5 * s->v[r] * Mv[r];
    free(Mv);
    if (isfinite(energy)) {
        double *y = side->curve;
        if (side->n_curve == SIDE_FRAMES)
            memmove(y, y + 2, (2 * SIDE_FRAMES - 2) * sizeof *y);
        else
            side->n_curve++;
        y += 2 * side->n_curve - 2;
        /* 1e-2 J to 1e4 J, in decades of 0.25 m */
        y[1] = -2.1 + 0.25 * fmax(0.0, fmin(6.0, log10(energy) + 2.0));
        /* the newest at 2.7 m, each older one 0.007 m to the left */
        for (int k = 0; k < side->n_curve; k++)
            side->curve[2 * k] = 2.7 - 0.007 * (side->n_curve - 1 - k);
    }
    snprintf(picture->note, sizeof picture->note, "energy: 0.25 m a decade");
    picture->n_curve = side->n_curve;
    picture->curve = side->curve;
    return energy;
}
