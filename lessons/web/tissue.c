/*
 * tissue.c - a strip of soft tissue, a knife and a hand; on a page only.
 *
 * The strip is that of tissue.h, and the loop is that of lesson 24.  The
 * pointer is a knife where it is pressed beside the strip, and a hand where it
 * is pressed on it; paths, fans and what is carried are those of lesson 26.
 */
#define main program_main
#include "../../solutions/26_cut.c"
#undef main

#include "base/clock.h"
#include "motion/window.h"

static const double RADIUS = 0.15;

struct strip {
    struct tissue uncut, s; /* at rest; as it is, with its state in live->now */
    struct tissue_whole whole;
    int *cut;  /* marks */
    int knife; /* is the pointer down, and a knife? */
    int at;    /* the vertex of the uncut strip where it is */
};

/* The vertex that is nearest to x, and how far it is away. */
static int nearest(const struct live *live, const double x[2], double *away)
{
    int best = 0;
    *away = INFINITY;
    for (int a = 0; a < live->mesh->n_vertex; a++) {
        const double *X = &live->mesh->X[2 * a], *u = &live->now.u[2 * a];
        const double d = hypot(X[0] + u[0] - x[0], X[1] + u[1] - x[1]);
        if (d < *away) best = a, *away = d;
    }
    return best;
}

/* Make a new body: bone holds its vertices and the hand, if it is down, those
 * near it that hang together there, so that it takes one lip of a cut. */
static void hold(struct live *live, const struct strip *strip, int down)
{
    const struct mesh *mesh = live->mesh;
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    double away;
    for (int r = 0; r < live->n_dof; r++)
        live->grip[r] = mesh->X[r] + live->now.u[r] - live->hand[r % 2];
    held[nearest(live, live->hand, &away)] = down;
    for (int again = down; again;) {
        again = 0;
        for (int c = 0; c < 3 * mesh->n_triangle; c++) {
            const int a = mesh->triangle[c];
            const int b = mesh->triangle[c % 3 == 2 ? c - 2 : c + 1];
            if (held[a] == held[b]) continue;
            const int one = held[a] ? b : a; /* that is not taken yet */
            if (hypot(live->grip[2 * one], live->grip[2 * one + 1]) > RADIUS)
                continue;
            held[one] = again = 1;
        }
    }
    for (int a = 0; a < mesh->n_vertex; a++) held[a] |= strip->s.held[a];
    body_free(live->body);
    live->body = body_alloc(mesh, material_notes(live->set.law), 1.0,
                            CONSISTENT, held);
    live->holding = down;
    free(held);
}

/* Open the strip along the marks, from a state that it has or had. */
static void renew(struct live *live, struct strip *strip,
                  const struct tissue *before)
{
    const struct tissue old = strip->s;
    strip->s = cut_body(&strip->whole, strip->cut, before);
    live->mesh = strip->s.mesh;
    live->n_dof = 2 * live->mesh->n_vertex;
    state_free(&live->now);
    live->now = state_make(live->n_dof);
    state_accept(&live->now, strip->s.u, strip->s.v);
    free(live->grip);
    free(live->g);
    live->grip = allocate((size_t)live->n_dof, sizeof *live->grip);
    live->g = allocate((size_t)live->n_dof, sizeof *live->g);
    hold(live, strip, 0);
    if (old.mesh) tissue_free(old);
}

/* On with the knife to the vertex at x. */
static void cut(struct live *live, struct strip *strip, const double x[2])
{
    const struct mesh *whole = strip->whole.mesh;
    const int last = strip->at;
    double away;
    const int b = nearest(live, x, &away);
    for (int c = 0; c < 3 * whole->n_triangle; c++)
        if (live->mesh->triangle[c] == b) strip->at = whole->triangle[c];
    if (last < 0 || last == strip->at) return;
    const double *from = &whole->X[2 * last], *to = &whole->X[2 * strip->at];
    int *chain = allocate((size_t)whole->n_vertex, sizeof *chain);
    const int n = path(whole, (double[]){from[0], from[1], to[0], to[1]}, last,
                       strip->at, chain);
    tissue_mark(whole, n, chain, strip->cut);
    free(chain);
    struct tissue before = strip->s;
    before.u = live->now.u;
    before.v = live->now.v;
    renew(live, strip, &before);
}

/* What live_input() and live_carry() do for the square. */
static void input(struct live *live, struct strip *strip,
                  const struct pointer *pointer)
{
    const double x[2] = {fmax(-LIVE_FAR, fmin(LIVE_FAR, pointer->x)),
                         fmax(-LIVE_FAR, fmin(LIVE_FAR, pointer->y))};
    double away;
    if (pointer->key == 'r') {
        memset(strip->cut, 0, 3 * (size_t)strip->whole.mesh->n_triangle *
                                  sizeof *strip->cut);
        renew(live, strip, &strip->uncut);
        live->trouble = strip->knife = 0;
    }
    if (pointer->down && !live->holding && !strip->knife) {
        memcpy(live->hand, x, sizeof x);
        nearest(live, x, &away);
        strip->knife = away > RADIUS;
        strip->at = -1;
        if (!strip->knife) hold(live, strip, 1);
    }
    if (!pointer->down && live->holding) hold(live, strip, 0);
    strip->knife = strip->knife && pointer->down;
    if (strip->knife) cut(live, strip, x);
}

static void carry_on(struct live *live, const struct strip *strip,
                     const double to[2])
{
    for (int r = 0; r < live->n_dof; r++)
        live->g[r] = live->body->equation[r] >= 0 || strip->s.held[r / 2]
                         ? 0.0
                         : live->grip[r] + to[r % 2] - live->mesh->X[r];
}

int main_tissue(int argc, char *argv[]);
int main_tissue(int argc, char *argv[])
{
    (void)argc;
    (void)argv; /* a page says nothing */
    struct window *window = window_open();
    struct pointers all = {0, NULL};
    struct strip strip = {.at = -1};
    struct live live = {.set = {0, LOG, BACKWARD_EULER, PATCH, ELASTIC, 1,
                                LINEAR_TRIANGLE}, .dt = 1.0 / 30.0};
    if (!window) die("tissue: there is no page");
    gsl_set_error_handler_off();
    strip.uncut = tissue_strip();
    strip.whole = tissue_on_bone(&strip.uncut);
    strip.cut = allocate(3 * (size_t)strip.whole.mesh->n_triangle, sizeof(int));
    renew(&live, &strip, &strip.uncut);
    table_begin("frames", "k rung status systems part min_J vertices");
    for (int k = 0; window_next(window, &all, k, 1); k++) {
        double to[2];
        const double start = clock_seconds();
        input(&live, &strip, &all.frame[k]);
        live_hand(live.hand, &all.frame[k], to);
        carry_on(&live, &strip, to);
        const struct live_report report = live_frame(&live, to);
        window_draw(window, &live, &report, clock_seconds() - start, NULL);
        table_row(k + 1, report.rung, status_name(report.status),
                  report.systems, report.part,
                  body_min_J(live.body, live.now.u), live.mesh->n_vertex);
    }
    table_end();
    window_close(window);
    pointers_free(&all); /* the page ends, and with it the rest */
    return table_finish();
}
