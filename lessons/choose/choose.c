/*
 * choose.c - `make choose`: the least model, mesh, step and solver for a scene
 * of one's own, each with its reason and the lesson that it rests on.
 *
 * The ladder of ladder.h is climbed from the bar up, as lesson 23 does; what is
 * printed is the last rung.  Seconds are those of price.h, which calibrates for
 * a second at most.
 */
#include "cells.h"
#include "chosen.h"
#include "price.h"
#include "base/clock.h"
#include "base/options.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FINEST = 2 };

/* Return the model of s with these triangles. */
static struct ladder_state *solved(const struct ladder_state *s,
                                   const struct cells *c)
{
    struct ladder_model model = s->model;
    model.level = c->level;
    return ladder_solve_of(c->element, c->grade, s->scene, model);
}

/* Print what one frame costs. */
static void say_frame(const char *which, double flops, int moving,
                      double seconds, double within)
{
    printf("  %s%.2g flops per %s, %.3g ms: %s %g ms\n", which, flops,
           moving ? "step" : "solve", 1e3 * seconds,
           seconds <= within ? "within" : "NOT within", 1e3 * within);
}

/* Return whether c are triangles which s has not, and at rest, where their
 * price is known. */
static int others_at_rest(const struct ladder_state *s, const struct cells *c)
{
    return c && !s->model.moving &&
           (c->element != LINEAR_TRIANGLE || c->grade > 1.0 ||
            c->level != s->model.level);
}

/* The price of s, of the triangles c where those are the better ones, and what
 * choosing them has cost. */
static void say_price(const struct ladder_state *s, const struct cells *c,
                      double within, double choosing)
{
    const double frames = price_frames(s);
    struct price price[FINEST + 1];
    for (int k = 0; k <= FINEST; k++) {
        struct ladder_model model = s->model;
        model.level = k;
        price[k] = price_calibrate(LINEAR_TRIANGLE, 1.0, model);
    }
    double run = price_seconds(s, price[s->model.level]), flops = s->flops;
    struct ladder_state *richest = ladder_alloc(
        s->scene, (struct ladder_model){LOG_PLANE, s->model.moving, FINEST});
    const int p = richest->body->K->p, n = richest->body->n_equation;
    ladder_free(richest);
    printf("Price, by a calibration of this machine on another body\n");
    say_frame(s->model.rung == BAR ? "" : "linear triangles: ", flops / frames,
              s->model.moving, run / frames, within);
    if (s->model.rung != BAR)
        printf("  about %d cells along the body would fit into %g ms\n",
               price_columns(s, price, FINEST + 1, within), 1e3 * within);
    if (others_at_rest(s, c)) {
        struct ladder_state *q = solved(s, c);
        run = price_seconds(q, price_calibrate(c->element, c->grade,
                                               q->model));
        flops = q->flops;
        say_frame("those of Element: ", flops, 0, run, within);
        ladder_free(q);
    }
    /* of the logarithmic law: some six factorisations at rest, two per step */
    const double rich = matrix_cost(BANDED, n, p).flops *
                        (s->model.moving ? 2.0 * frames : 6.0);
    printf("  choosing took %.3g ms, as much as %.2g runs\n", 1e3 * choosing,
           choosing / run);
    if (rich > flops)
        printf("  the richest model on the finest mesh takes about %.3g times "
               "the flops: choosing\n  pays from run %.0f on\n",
               rich / flops, ceil(choosing / run / (rich / flops - 1.0)));
    else
        printf("  the richest model on the finest mesh costs no more: choosing "
               "does not pay here\n");
}

/* The triangles of cells.h beside those of an answer. */
struct compared {
    struct cells cells[CELLS];
    double room; /* the tolerance less the other parts */
    const struct cells *best; /* the fewest flops for the room; NULL: none, or
                               * nobody knows */
    double own; /* how far those of the answer, at rest, are from the best mesh;
                 * 0: nobody knows */
};

static void compare(const struct ladder_state *s, const struct climb_rung *t,
                    double tolerance, struct compared *c)
{
    const double rest = pow(t->estimate, 2) - pow(t->part[MESH], 2);
    c->best = NULL;
    c->own = 0.0;
    c->room = sqrt(fmax(0.0, pow(tolerance, 2) - fmax(0.0, rest)));
    if (s->model.rung == BAR || t->doubt != NO_DOUBT || !(c->room > 0.0) ||
        !cells_compare(s->scene, s->model.rung, c->cells))
        return;
    c->best = cells_cheapest(c->cells, c->room);
    if (!s->model.moving) /* even linear ones come first, by level */
        c->own = c->cells[s->model.level].error - c->cells[CELLS - 1].error;
}

static void say_triangles(const struct ladder_state *s,
                          const struct compared *c)
{
    const struct cells *best = c->best;
    printf("Element%s (lesson 25)\n",
           s->model.moving ? ", judged at rest under the full load" : "");
    if (c->own > 0.0)
        printf("  of linear triangles, mesh %d, the mesh's part is %.2g %%, "
               "measured from quadratic\n  ones%s\n", s->model.level,
               100.0 * c->own, c->own > c->room ? ": too much" : "");
    if (best)
        printf("  the cheapest that are fine enough: %s triangles, mesh %d, "
               "%s:\n  the mesh's part is %.2g %%, for %.2g flops at rest\n",
               cells_name(best->element), best->level, best->grade > 1.0 ?
               "graded to the corners" : "even", 100.0 * best->error,
               best->flops);
    else
        printf("  no triangles here are known to be fine enough\n");
}

static void say_true(const struct ladder_state *s, struct ladder_state *truth,
                     double tolerance)
{
    const struct ladder_scene *scene = truth->scene;
    struct ladder_scene other = *scene;
    const int n = ladder_has_hand(scene) ? LADDER_HAND : LADDER_RMS;
    const double error = ladder_error(s, truth);
    printf("Verified: the answer differs by %.2g %% %s%s\n  from that of "
           "quadratic triangles, logarithmic law, %s, mesh %d\n",
           100.0 * error, chosen_quantity(scene->quantity),
           error > tolerance ? ", too much," : "",
           truth->model.moving ? "in motion" : "at rest", truth->model.level);
    truth->scene = &other;
    for (int k = 0; k <= n; k++) {
        other.quantity = (enum ladder_quantity)k;
        if (other.quantity != scene->quantity)
            printf("  and by %.2g %% %s\n", 100.0 * ladder_error(s, truth),
                   chosen_quantity(other.quantity));
    }
    truth->scene = scene;
}

/* Verify the answer, with linear triangles or with `others`, beside that of the
 * richest model, with quadratic ones, which are richer than as many linear
 * ones.  Return whether it could be done. */
static int verify(const struct ladder_state *s, enum doubt doubt,
                  const struct cells *others, double tolerance)
{
    struct ladder_scene finer = *s->scene;
    if (s->model.moving) finer.finest = s->model.level;
    const struct ladder_model richest = ladder_truth(&finer);
    struct ladder_state *truth =
        ladder_solve_of(QUADRATIC_TRIANGLE, 1.0, &finer, richest);
    const int can =
        truth->status == OK && doubt < GIVES_WAY && ladder_stable(truth);
    if (truth->status != OK)
        printf("Verified: no, the richest model on a finer mesh ends with %s\n",
               status_name(truth->status));
    else if (!can)
        printf("Verified: no, for a body that gives way may go elsewhere\n");
    else if (others) {
        struct ladder_state *q = solved(s, others);
        say_true(q, truth, tolerance);
        ladder_free(q);
    } else
        say_true(s, truth, tolerance);
    ladder_free(truth);
    return can;
}

/* Write for figures/scene.gp the parts of the error (%), and the triangles
 * (m). */
static void write_picture(const char *path, const struct scene_file *file,
                          const struct ladder_state *s,
                          const struct climb_rung *t, double tolerance)
{
    FILE *out = fopen(path, "w");
    if (!out) die("%s: cannot be written", path);
    fprintf(out, "# %s\t%g\n", file->name, 100.0 * tolerance);
    for (int k = 0; k < N_PART; k++)
        fprintf(out, "%s\t%.6g\n", ladder_part((enum part)k),
                100.0 * t->part[k]);
    fprintf(out, "together\t%.6g\n\n\n", 100.0 * t->estimate);
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        for (int i = 0; i < 4; i++) {
            const int a = s->mesh->triangle[3 * e + i % 3];
            const double *X = &s->mesh->X[2 * a], *u = &s->u[2 * a];
            fprintf(out, "%.6g\t%.6g\t%.6g\t%.6g\n", file->metre * X[0],
                    file->metre * X[1], file->metre * (X[0] + u[0]),
                    file->metre * (X[1] + u[1]));
        }
        fputc('\n', out);
    }
    if (fclose(out) != 0) die("%s: cannot be written", path);
}

/* The allowed error and seconds. */
struct asked {
    double error, within;
    int check;
    const char *picture;
};

/* The answer has cells of this error. */
static void put_mesh(struct climb_rung *t, double error)
{
    const double rest = pow(t->estimate, 2) - pow(t->part[MESH], 2);
    t->part[MESH] = error;
    t->estimate = sqrt(fmax(0.0, rest) + pow(error, 2));
}

/* Print the report.  Return whether s, or the same law on other triangles, is
 * accurate enough. */
static int end(const struct scene_file *file, const struct asked *asked,
               struct ladder_state *s, const struct climb_rung tried[], int n,
               double start)
{
    struct climb_rung t = tried[n - 1];
    struct compared c;
    int enough = t.doubt == NO_DOUBT && t.estimate <= asked->error;
    compare(s, &t, asked->error, &c);
    const double choosing = clock_processor() - start;
    const int others_needed = !s->model.moving && (!enough || c.own > c.room);
    const struct cells *others = others_needed ? c.best : NULL;
    put_mesh(&t, others ? others->error : fmax(t.part[MESH], c.own));
    enough = chosen_say_answer(s, &t, asked->error, others);
    chosen_say_climb(tried, n);
    chosen_say_numbers(file, s);
    if (t.doubt == NO_DOUBT) chosen_say_model(file, s, others);
    if (t.doubt == NO_DOUBT && s->model.rung != BAR) say_triangles(s, &c);
    chosen_say_error(s, &t, others);
    if (t.doubt == NO_DOUBT) say_price(s, c.best, asked->within, choosing);
    const int known =
        !asked->check || verify(s, t.doubt, others, asked->error);
    if (asked->picture && t.doubt < GIVES_WAY)
        write_picture(asked->picture, file, s, &t, asked->error);
    return known && enough;
}

int main(int argc, char *argv[])
{
    const char *path = NULL, *picture = NULL;
    double error = 10.0, within = 33.0;
    int check = 0;
    const struct option options[] = {
        {"scene", .text = &path, .unit = "a file's name", .help = "the scene"},
        {"error", .real = &error, .min = 0.01, .max = 100, .unit = "%",
         .help = "that may be made, of the quantity of the scene"},
        {"within", .real = &within, .min = 1e-3, .max = 1e6, .unit = "ms",
         .help = "that a frame may take"},
        {"verify", .choice = &check, .choices = "no yes",
         .help = "by a better model on a finer mesh"},
        {"picture", .text = &picture, .unit = "a file's name",
         .help = "what figures/scene.gp draws"},
    };
    struct scene_file file;
    options_parse("choose", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    if (!path) options_refuse("choose", "--scene is missing; -h lists them");
    scene_file_read("choose", path, FINEST, &file);

    const struct asked asked = {error / 100.0, within / 1e3, check, picture};
    const double start = clock_processor();
    struct climb_rung tried[CLIMB_MOST];
    int n;
    struct ladder_state *s = climb_ladder(&file.scene, asked.error, tried, &n);
    if (s->status != OK)
        die("%s: the %s model finds no state (%s): the load may be beyond "
            "every equilibrium%s", path, ladder_rung(s->model.rung),
            status_name(s->status), s->model.moving ? ", or the steps too "
            "long: make 'end' shorter" : "");
    const int enough = end(&file, &asked, s, tried, n, start);
    ladder_free(s);
    return enough ? EXIT_SUCCESS : EXIT_FAILURE;
}
