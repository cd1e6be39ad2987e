/*
 * choose.c - `make choose`: the least model, mesh, step and solver for a scene
 * of one's own, each with its reason and the lesson that it rests on.
 *
 * The ladder of ladder.h is climbed from the bar up, as lesson 23 does; what is
 * printed is the last rung.  Seconds are those of price.h, which calibrates for
 * a second at most.
 */
#include "choice/cells.h"
#include "choice/chosen.h"
#include "choice/price.h"
#include "choice/rung.h"
#include "base/clock.h"
#include "base/options.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FINEST = 2 };

/* The scene at rest with other triangles. */
static struct ladder_state *solved(const struct ladder_scene *scene,
                                   enum rung rung, enum element element,
                                   double grade, int level)
{
    struct ladder_state *s = ladder_alloc_of(
        element, grade, scene, (struct ladder_model){rung, 0, level});
    s->status = rung_solve(s);
    return s;
}

/* Of a frame. */
static void say_frame(const char *which, double flops, int moving,
                      double seconds, double within)
{
    printf("  %s%.2g flops per %s, %.3g ms: %s %g ms\n", which, flops,
           moving ? "step" : "solve", 1e3 * seconds,
           seconds <= within ? "within" : "NOT within", 1e3 * within);
}

/* Whether c are triangles which s has not, and at rest, where their price is
 * known. */
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
    const struct ladder_scene *scene = s->scene;
    const double frames = price_frames(s);
    struct price price[FINEST + 1];
    for (int k = 0; k <= FINEST; k++) {
        struct ladder_model model = s->model;
        model.level = k;
        price[k] = price_calibrate(model);
    }
    double run = price_seconds(s, price[s->model.level]), flops = s->flops;
    struct ladder_state *richest = ladder_alloc(
        scene, (struct ladder_model){LOG_PLANE, s->model.moving, FINEST});
    const int p = richest->body->K->p, n = richest->body->n_equation;
    ladder_free(richest);
    printf("Price, by a calibration of this machine on another body\n");
    say_frame(s->model.rung == BAR ? "" : "linear triangles: ", flops / frames,
              s->model.moving, run / frames, within);
    if (s->model.rung != BAR)
        printf("  about %d cells along the body would fit into %g ms\n",
               price_columns(s, price, FINEST + 1, within), 1e3 * within);
    if (others_at_rest(s, c)) {
        struct ladder_state *q = solved(scene, s->model.rung, c->element,
                                        c->grade, c->level);
        run = price_seconds(q, price_calibrate_of(c->element, c->grade,
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

/* The triangles that need the fewest flops for what is left of the tolerance
 * beside the other parts; NULL: none, or nobody knows. */
static const struct cells *other_triangles(const struct ladder_state *s,
                                           const struct chosen_tried *t,
                                           double tolerance)
{
    static struct cells cells[CELLS_KINDS * CELLS_LEVELS];
    const double others =
        sqrt(fmax(0.0, pow(t->estimate, 2) - pow(t->part[MESH], 2)));
    if (s->model.rung == BAR || t->doubt != NO_DOUBT || others >= tolerance ||
        !cells_compare(s->scene, s->model.rung, cells))
        return NULL;
    return cells_cheapest(cells, sqrt(pow(tolerance, 2) - pow(others, 2)));
}

static void say_triangles(const struct ladder_state *s, const struct cells *c)
{
    printf("Element%s (lesson 25)\n",
           s->model.moving ? ", judged at rest under the full load" : "");
    if (!c) {
        printf("  no triangles here are known to be fine enough\n");
        return;
    }
    printf("  the cheapest that are fine enough: %s triangles, mesh %d, %s:\n"
           "  the mesh's part is %.2g %%, for %.2g flops at rest\n",
           cells_name(c->element), c->level, c->grade > 1.0 ?
           "graded to the corners" : "even", 100.0 * c->error, c->flops);
}

static void say_true(const struct ladder_state *s, struct ladder_state *truth)
{
    const struct ladder_scene *scene = truth->scene;
    struct ladder_scene other = *scene;
    const int n = ladder_has_hand(scene) ? LADDER_HAND : LADDER_RMS;
    printf("Verified: from that of the logarithmic law%s on one mesh finer the "
           "answer differs\nby %.2g %% %s\n",
           truth->model.moving ? " in motion" : "",
           100.0 * ladder_error(s, truth), chosen_quantity(scene->quantity));
    truth->scene = &other;
    for (int k = 0; k <= n; k++) {
        other.quantity = (enum ladder_quantity)k;
        if (other.quantity != scene->quantity)
            printf("  and by %.2g %% %s\n", 100.0 * ladder_error(s, truth),
                   chosen_quantity(other.quantity));
    }
    truth->scene = scene;
}

/* Whether it could be done. */
static int verify(const struct ladder_state *s, enum doubt doubt,
                   const struct cells *other)
{
    struct ladder_scene finer = *s->scene;
    finer.finest = s->model.level;
    struct ladder_state *truth = ladder_solve(&finer, ladder_truth(&finer));
    const int can =
        truth->status == OK && doubt < GIVES_WAY && ladder_stable(truth);
    if (truth->status != OK)
        printf("Verified: no, the richest model on a finer mesh ends with %s\n",
               status_name(truth->status));
    else if (!can)
        printf("Verified: no, for a body that gives way may go elsewhere\n");
    else
        say_true(s, truth);
    ladder_free(truth);
    if (!other || s->model.moving || doubt != NO_DOUBT) return can;
    struct ladder_state *q = solved(s->scene, s->model.rung, other->element,
                                    other->grade, other->level);
    truth = solved(s->scene, LOG_PLANE, QUADRATIC_TRIANGLE, 1.0, CELLS_LEVELS);
    if (truth->status == OK && ladder_stable(truth))
        printf("  the %s triangles of mesh %d by %.2g %%, from quadratic ones "
               "on one finer still\n", cells_name(other->element),
               other->level, 100.0 * ladder_error(q, truth));
    ladder_free(q);
    ladder_free(truth);
    return can;
}

/* For figures/scene.gp: the parts of the error (%), and the triangles (m). */
static void write_picture(const char *path, const struct scene_file *file,
                          const struct ladder_state *s,
                          const struct chosen_tried *t, double tolerance)
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

/* What is asked for: the error and the seconds that may be. */
struct asked {
    double error, within;
    int check;
    const char *picture;
};

/* The climb has ended with s, tried[n - 1], and everything is said.  Whether it
 * is enough, or the same law with other triangles. */
static int end(const struct scene_file *file, const struct asked *asked,
               struct ladder_state *s, const struct chosen_tried tried[], int n,
               int enough, double start)
{
    const struct chosen_tried *t = &tried[n - 1];
    const struct cells *c = other_triangles(s, t, asked->error);
    const double choosing = clock_seconds() - start;
    const int others = !enough && c && !s->model.moving;
    chosen_say_numbers(file, s);
    chosen_say_climb(tried, n);
    chosen_say_model(file, s, asked->error, enough ? CHOSEN_LAST : others
                     ? CHOSEN_WITH_OTHERS : CHOSEN_NOTHING);
    if (s->model.rung != BAR && t->doubt == NO_DOUBT) say_triangles(s, c);
    chosen_say_error(s, t);
    say_price(s, c, asked->within, choosing);
    const int known = !asked->check || verify(s, t->doubt, c);
    if (asked->picture && t->doubt < GIVES_WAY)
        write_picture(asked->picture, file, s, t, asked->error);
    return known && (enough || others);
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
    struct asked asked;
    options_parse("choose", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    if (!path) options_refuse("choose", "--scene is missing; -h lists them");
    scene_file_read("choose", path, FINEST, &file);

    const struct ladder_scene *scene = &file.scene;
    struct ladder_model model = ladder_first(scene);
    asked = (struct asked){error / 100.0, within / 1e3, check, picture};
    const double start = clock_seconds();
    int enough = 0, n = 0;
    struct chosen_tried tried[16]; /* each adds a rung, motion or a level */
    for (int more = 1; more;) {
        struct ladder_state *s = ladder_solve(scene, model);
        if (s->status != OK)
            die("%s: the %s model finds no state (%s): the load may be beyond "
                "every equilibrium%s", path, ladder_rung(model.rung),
                status_name(s->status), model.moving ? ", or the steps too "
                "long: make 'end' shorter" : "");
        struct chosen_tried *t = &tried[n++];
        t->model = model;
        t->doubt = estimate_doubt(s);
        estimate_parts(s, t->part);
        enough = estimate_verdict(model, scene->time, t->doubt == NO_DOUBT,
                                  asked.error, t->part, &t->estimate,
                                  &t->add);
        more = !enough && t->doubt != LONG_STEPS && n < COUNT(tried);
        if (more && !ladder_add(scene, t->add, &model)) /* no finer mesh, but */
            more = !model.moving && t->doubt == NO_DOUBT && /* triangles */
                   ladder_add(scene, GEOMETRY, &model);
        if (!more) enough = end(&file, &asked, s, tried, n, enough, start);
        ladder_free(s);
    }
    return enough ? EXIT_SUCCESS : EXIT_FAILURE;
}
