/*
 * choose.c - `make choose`: the least model, mesh, step and solver for a scene
 * of one's own, each with its reason and the lesson that it rests on.
 *
 * The ladder of ladder.h is climbed from the bar up, as lesson 23 does; what is
 * printed is the last rung.  Seconds are measured on the machine at hand, for
 * half a second at most.
 */
#include "choice/estimate.h"
#include "choice/scene_file.h"
#include "base/clock.h"
#include "base/options.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FINEST = 2 };

/* max |G|, G the Green strain, and the largest angle (rad) of the rotation in
 * F. */
static void sizes(const struct ladder_state *s, double *strain, double *turn)
{
    *strain = *turn = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, s->u, e);
        const mat2 C = mat2_multiply(mat2_transpose(F), F);
        const mat2 G = mat2_scale(0.5, mat2_subtract(C, mat2_identity()));
        *strain = fmax(*strain, mat2_norm(G));
        *turn = fmax(*turn, fabs(atan2(F.m[1][0] - F.m[0][1],
                                       F.m[0][0] + F.m[1][1])));
    }
}

static void say_numbers(const struct scene_file *file,
                        const struct ladder_state *s)
{
    const struct ladder_scene *scene = s->scene;
    double strain, turn, N = 0.0;
    sizes(s, &strain, &turn);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r += 2) N += s->f[r];
    printf("Scene %s, %g m long, in numbers without dimension\n", file->name,
           2.0 * file->metre);
    printf("  strain %.2g, turn %.2g rad: where they are 0.1, linear "
           "elasticity errs by 5 to 10 %% (lesson 9)\n", strain, turn);
    printf("  slenderness %.3g, Poisson's ratio %g%s (lesson 12)\n",
           scene->slender, scene->nu,
           scene->nu > 0.45 ? ": linear triangles lock, quadratic ones do not"
                            : "");
    if (scene->held == LADDER_LEFT)
        printf("  along the axis %.2g of the buckling load%s (lesson 23)\n",
               fabs(N) / ladder_buckles(scene),
               N < 0.0 ? ", pressed" : N > 0.0 ? ", pulled" : "");
    if (scene->time != STANDS)
        printf("  1 / (omega T) %.2g: inertia counts where it is not small "
               "(lesson 23)\n", estimate_inertia(s));
}

static void say_model(const struct scene_file *file,
                      const struct ladder_state *s, double tolerance,
                      int enough)
{
    static const char *const model[] = {
        "a bar (lesson 9)", "linear triangles, linear law (lesson 12)",
        "linear triangles, cubic Neo-Hookean law (lesson 12)",
        "linear triangles, logarithmic Neo-Hookean law (lesson 12)"};
    static const char *const why[] = {
        "hardly anything bends", "turn and strain are small",
        "it turns, strains or is under stress that turns",
        "J is far from 1, where the cubic law departs"};
    const struct ladder_scene *scene = s->scene;
    printf("%s for %g %%\n", enough ? "The least model" :
           "NOT SURE: no model here is known to be enough", 100.0 * tolerance);
    printf("  %s: %s\n", model[s->model.rung], why[s->model.rung]);
    printf("  %s\n", s->model.moving ?
           "in motion: the load moves as fast as the body swings (lesson 14)" :
           scene->time == STANDS ? "at rest: the load stands"
                                 : "at rest: the load is slow");
    printf("  mesh %d x %d cells (lesson 23; quadratic or graded: lesson 25)\n",
           s->mesh->n, s->mesh->rows);
    if (s->model.moving)
        printf("  implicit midpoint, steps of %.3g s, %.0f of them (lesson "
               "14)\n", scene->dt * file->second, scene->end / scene->dt);
    printf("  solver: %s, %d unknowns (lesson 21)\n",
           s->model.rung == BAR ? "none is needed" : "band",
           s->model.rung == BAR ? s->mesh->n : s->body->n_equation);
    if (s->model.rung > LINEAR_PLANE)
        printf("  cure to switch on: line search, projection on demand (lesson "
               "15)\n");
}

/* The parts of the error, and what no part sees. */
static void say_error(const struct ladder_state *s, double tolerance,
                      int stable)
{
    double part[N_PART], estimate;
    enum part add;
    estimate_parts(s, part);
    estimate_verdict(s->model, s->scene->time, stable, tolerance, part,
                     &estimate, &add);
    printf("Expected error %.2g %% of the largest displacement (lesson 23)\n",
           100.0 * estimate);
    for (int k = 0; k < N_PART; k++)
        if (part[k] > 0.0)
            printf("  %-9s %.2g %%\n", ladder_part((enum part)k),
                   100.0 * part[k]);
    printf("Not sure of\n");
    printf("  the estimate: it was 0.6 to 3.3 times the error in twelve "
           "scenes, in random\n  ones with two loads seldom far less\n");
    if (s->model.moving)
        printf("  the time step, which no part measures, and whether K stays "
               "positive definite\n");
    if (!stable)
        printf("  where the body goes: K is not positive definite here (lesson "
               "15)\n");
    if (s->scene->nu > 0.45)
        printf("  the mesh: triangles lock where nu is near 1/2\n");
}

/* Seconds of one run, the least of those that half a second has time for. */
static double seconds_of(const struct ladder_scene *scene,
                         struct ladder_model model)
{
    double best = INFINITY;
    const double start = clock_seconds();
    do {
        const double before = clock_seconds();
        ladder_free(ladder_solve(scene, model));
        best = fmin(best, clock_seconds() - before);
    } while (clock_seconds() - start < 0.5);
    return best;
}

static void say_price(const struct ladder_state *s, double within,
                      double choosing)
{
    const struct ladder_scene *scene = s->scene;
    const double frames =
        s->model.moving ? floor(scene->end / scene->dt + 0.5) : 1.0;
    const double run = seconds_of(scene, s->model);
    struct ladder_state *richest = ladder_alloc(
        scene, (struct ladder_model){LOG_PLANE, s->model.moving, FINEST});
    const int p = richest->body->K->p, n = richest->body->n_equation;
    ladder_free(richest);
    printf("Price\n");
    printf("  %.2g flops per %s, %.3g ms on this machine: %s %.3g ms\n",
           s->flops / frames, s->model.moving ? "step" : "solve",
           1e3 * run / frames, run / frames <= within ? "within" : "NOT within",
           1e3 * within);
    if (s->model.rung != BAR) /* the band: n p^2, h^-4 */
        printf("  within that, about %d cells along fit\n",
               (int)(s->mesh->n * pow(within * frames / run, 0.25)));
    /* of the logarithmic law: some six factorisations at rest, two per step */
    const double rich = matrix_cost(BANDED, n, p).flops *
                        (s->model.moving ? 2.0 * frames : 6.0);
    printf("  choosing took %.3g ms, as much as %.2g runs\n", 1e3 * choosing,
           choosing / run);
    if (rich > s->flops)
        printf("  the richest model on the finest mesh takes about %.2g times "
               "the flops: choosing pays\n  from run %.0f on\n",
               rich / s->flops, ceil(choosing / run / (rich / s->flops - 1.0)));
}

static void verify(const struct ladder_state *s)
{
    struct ladder_scene finer = *s->scene;
    finer.finest = s->model.level;
    struct ladder_state *truth = ladder_solve(&finer, ladder_truth(&finer));
    if (truth->status != OK)
        printf("Verified: not possible, the richest model ends with %s\n",
               status_name(truth->status));
    else
        printf("Verified: against the logarithmic law on one mesh finer it is "
               "off by %.2g %%\n", 100.0 * ladder_error(s, truth));
    ladder_free(truth);
}

int main(int argc, char *argv[])
{
    const char *path = NULL;
    double error = 10.0, within = 33.0;
    int check = 0;
    const struct option options[] = {
        {"scene", .text = &path, .unit = "a file's name", .help = "of a scene"},
        {"error", .real = &error, .min = 0.01, .max = 100, .unit = "%",
         .help = "of the displacement"},
        {"within", .real = &within, .min = 1e-3, .max = 1e6, .unit = "ms",
         .help = "for a frame"},
        {"verify", .choice = &check, .choices = "no yes",
         .help = "one model and mesh better"},
    };
    struct scene_file file;
    options_parse("choose", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    if (!path) options_refuse("choose", "--scene is missing; -h lists them");
    scene_file_read("choose", path, FINEST, &file);

    const struct ladder_scene *scene = &file.scene;
    struct ladder_model model = ladder_first(scene);
    const double start = clock_seconds();
    double estimate = 1.0;
    int enough = 0;
    for (int more = 1; more;) {
        struct ladder_state *s = ladder_solve(scene, model);
        enum part add = GEOMETRY;
        if (s->status != OK)
            die("%s: a %s model finds no state: %s; the load may be beyond "
                "every equilibrium", path, ladder_rung(model.rung),
                status_name(s->status));
        enough = estimate_state(s, error / 100.0, &estimate, &add);
        more = !enough && ladder_add(scene, add, &model);
        if (!more) {
            const double choosing = clock_seconds() - start;
            say_numbers(&file, s);
            say_model(&file, s, error / 100.0, enough);
            say_error(s, error / 100.0, ladder_stable(s));
            say_price(s, within / 1e3, choosing);
            if (check) verify(s);
        }
        ladder_free(s);
    }
    return enough ? EXIT_SUCCESS : EXIT_FAILURE;
}
