/*
 * 24_live.c - the square in your hand: a loop that loses no frame.
 *
 * Notes: Lecture 1, "get user boundary condition input, solve nonlinear system,
 * render solution to screen", and "abnormally robust to user input".
 *
 * Problem.  A hand takes some vertices of the square and carries them wherever
 * it likes, thirty frames per second.  Each frame is a step of backward Euler
 * or of the midpoint rule; none may be lost, whatever the hand does.
 *
 *     fast       elastic lift, factors kept                 at most 6 systems
 *        |  it failed, or the frame before was in trouble
 *     downhill   from the last state, projected, Phi falls  at most 8 in all
 *                the hand goes 1, 1/2, 1/4, 1/8 of its way, at last 0
 *
 * Input is a line per frame, "x y down key"; see common/motion/pointer.h.
 *
 * Run       make lesson-24 (ARGS=-h lists its options); make live: a window
 * PREDICT 1a frames lost of 60 while a side is pushed in at 3 m/s: ...
 * PREDICT 1b frames that need the second rung: ...
 * Plot: frames k energy
 */
#include "base/clock.h"
#include "motion/film.h"
#include "base/options.h"
#include "base/table.h"
#include "motion/window.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Given a hand at `from` and the pointer, return in `to` where the hand is a
 * frame later: the pointer is held within LIVE_FAR in x and in y, and the hand
 * goes at most LIVE_REACH on the straight way to it. */
static void hand_next(const double from[2], const struct pointer *pointer,
                      double to[2])
{
    /* SLOT 24a(from, pointer, to): to[0], to[1]; LIVE_FAR, LIVE_REACH (m). */
    todo("24a", from, pointer, to);
    /* END 24a */
}

/*
 * Given u, return how many vertices inside the square are knots: at rest the
 * angles of the triangles around a vertex add up to 2 pi.  They are between -pi
 * and pi, and negative where a triangle is inverted; a sum that is off by more
 * than pi is a knot [eq:winding].
 */
static int count_knots(const struct mesh *mesh, const double u[])
{
    const double *X = mesh->X;
    double *angle = allocate((size_t)mesh->n_vertex, sizeof *angle);
    int knots = 0;
    /* SLOT 24b(mesh, X, u, angle, &knots): angle[a] is 0; vertex a is at
     * X[2a] + u[2a], X[2a + 1] + u[2a + 1], and inside if -1 < X < 1 twice. */
    todo("24b", mesh, X, u, angle, &knots);
    /* END 24b */
    free(angle);
    return knots;
}

/*
 * Given the last state u0 and the held values g, return in u the first
 * iteration of Newton's method, in which the jump enters linearly: u = u0 + du,
 * and g where it is held.  K of the kind `tangent` and q are those of Phi, by
 * body_assemble().  OK, or the status of assembly or factorisation, or
 * NONFINITE: a move by more than LIVE_LEAP.
 */
static enum status elastic_lift(struct body *body, struct incremental Phi,
                                const double u0[], const double g[],
                                enum tangent tangent, double u[])
{
    const int n = 2 * body->mesh->n_vertex;
    double *move = allocate((size_t)n, sizeof *move), size = 0.0;
    double *q = allocate((size_t)n, sizeof *q);
    double *ahead = allocate((size_t)n, sizeof *ahead);
    double *behind = allocate((size_t)n, sizeof *behind);
    enum status status = OK;
    for (int r = 0; r < n; r++) {
        move[r] = body->equation[r] < 0 ? g[r] - u0[r] : 0.0;
        size = fmax(size, fabs(move[r]));
    }
    const double e = size > 0.0 ? 1e-6 / size : 0.0; /* e move: a micrometre */
    /* SLOT 24c(body, Phi, u0, tangent, u, move, q, ahead, behind, e, &status):
     * n numbers each; K_fh move is the central difference of q over u0 - e move
     * and u0 + e move; body_assemble(), body_increment(). */
    todo("24c", body, Phi, u0, tangent, u, move, q, ahead, behind, e, &status);
    /* END 24c */
    free(behind);
    free(ahead);
    free(q);
    free(move);
    return status;
}

/*
 * Given the last state, return u and v: the second rung, backward Euler.  The
 * projected lift, the hand going 1, 1/2, 1/4, ... of its way, until it is OK
 * and live_start() is: LIVE_TRIES at most, and none with the last of
 * FRAME_SYSTEMS; else u = u0 and 0 of the way.  Then LIVE_DOWNHILL with the
 * systems that are left, whose status is returned; u is taken as it is then.
 * v = (u - u0) / dt, but 0 where that is not OK or the hand was held back.
 *
 * report  in/out  systems: those of the frame so far, with one more for each
 *                 lift and those of Newton's method; part: of the hand's way
 */
static enum status downhill(struct live *live, double u[], double v[],
                            struct live_report *report)
{
    const double dt = live->dt, *u0 = live->now.u, *v0 = live->now.v;
    const int n = live->n_dof;
    double *w = allocate((size_t)n, sizeof *w);
    double *g = allocate((size_t)n, sizeof *g);
    const struct incremental Phi = {dt, w, NULL};
    struct step_control control = LIVE_DOWNHILL;
    enum status status = INVERTED;
    /* SLOT 24d(live, dt, u0, v0, n, w, Phi, g, u, v, report, &status,
     * &control): w and g are to be filled; live->g has the held values at the
     * end of the way. */
    todo("24d", live, dt, u0, v0, n, w, Phi, g, u, v, report, &status,
         &control);
    /* END 24d */
    free(g);
    free(w);
    return status;
}

/* What is counted over all frames. */
struct summary {
    int frames, lost, downhill, most;
    double energy; /* the largest (J) */
};

static void print_summary(const struct live *live, const struct summary *sum)
{
    double u = 0.0;
    for (int r = 0; r < live->n_dof; r++) u = fmax(u, fabs(live->now.u[r]));
    table_begin("summary", "frames lost downhill most_systems most_energy "
                           "last_max_u");
    table_row(sum->frames, sum->lost, sum->downhill, sum->most, sum->energy, u);
    table_end();
}

static void begin_table(int film)
{
    table_begin(film ? "motion" : "frames",
                film ? FILM : "k rung first status systems part min_J knots "
                              "energy x y ms");
}

/* A row of the table, and what is counted. */
static void print_frame(const struct live *live, int knots, struct cell ms,
                        const struct live_report *report, struct summary *sum)
{
    const double energy = live_energy(live);
    sum->frames++;
    table_row(sum->frames, report->rung, report->first,
              status_name(report->status), report->systems, report->part,
              body_min_J(live->body, live->now.u), knots, energy,
              live->hand[0], live->hand[1], ms);
    sum->lost += strcmp(report->rung, "lost") == 0;
    sum->downhill += strcmp(report->rung, "downhill") == 0;
    if (report->systems > sum->most) sum->most = report->systems;
    if (energy > sum->energy) sum->energy = energy;
}

/* One frame of input: the hand, the solver, a row of the table, a picture. */
static void play(struct live *live, const struct pointer *pointer, int timed,
                 int film, struct window *window, const char *shot,
                 struct summary *sum)
{
    double to[2];
    const double begin = clock_seconds();
    live_input(live, pointer);
    hand_next(live->hand, pointer, to);
    live_carry(live, to);
    const struct live_report report =
        live_frame_by(live, elastic_lift, downhill, to);
    const double seconds = clock_seconds() - begin;
    if (film == 0)
        print_frame(live, count_knots(live->mesh, live->now.u),
                    cell_if(timed, 1e3 * seconds), &report, sum);
    else
        film_frame(live, film, sum->frames++, pointer);
    if (window) window_draw(window, live, &report, seconds, shot);
}

int main(int argc, char *argv[])
{
    const char *name = NULL, *record = NULL, *shot = NULL;
    int n = 8, law = 0, method = 0, element = 0, seed = 1, timed = 0, film = 0;
    double speed = -3.0;
    const struct option options[] = {
        {"input", .text = &name, .unit = "pull, hard, mad or a file's name",
         .help = "what the hand does [the mouse, or pull]"},
        {"speed", .real = &speed, .min = -100.0, .max = 100.0, .unit = "m/s",
         .help = "of pull; < 0 is a push"},
        {"seed", .integer = &seed, .min = 1, .max = 1000000, .help = "of mad"},
        {"n", .integer = &n, .min = 2, .max = 64,
         .help = "squares per side"},
        {"law", .choice = &law, .choices = "log cubic", .help = "material"},
        {"integrator", .choice = &method, .choices = "backward midpoint",
         .help = "of the first rung"},
        {"element", .choice = &element, .choices = "linear quadratic",
         .help = "triangles; quadratic: n is made even"},
        {"time", .choice = &timed, .choices = "no yes",
         .help = "milliseconds per frame in the table"},
        {"film", .integer = &film, .max = 999, .help = "triangles alone"},
        {"record", .text = &record, .unit = "a file's name",
         .help = "where the input is written to"},
        {"shot", .text = &shot, .unit = "a file's name",
         .help = "the last picture of the window, as BMP"},
    };
    options_parse("24_live", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    const struct live_setting set = {
        n, law ? CUBIC : LOG, method ? IMPLICIT_MIDPOINT : BACKWARD_EULER,
        PATCH, ELASTIC, 1, element ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE};
    struct window *window = window_open(); /* NULL: not by make live */
    const int mouse = window && !name;
    struct pointers input = {0, NULL};
    if (!mouse) input = pointers_named(name ? name : "pull", speed, seed);
    struct live *live = live_alloc(&set);
    struct summary sum = {0};

    begin_table(film);
    for (int k = 0; window_next(window, &input, k, mouse); k++)
        play(live, &input.frame[k], timed, film, window,
             !mouse && k == input.n - 1 ? shot : NULL, &sum);
    table_end();
    if (film == 0) print_summary(live, &sum);
    if (record) pointers_write(&input, record);
    window_close(window);
    live_free(live);
    pointers_free(&input);
    return table_finish();
}
