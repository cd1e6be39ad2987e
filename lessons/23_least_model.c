/*
 * 23_least_model.c - the smallest model that meets a tolerance: solve cheaply,
 * estimate what was left out, add the largest part, until it is enough.
 *
 * Problem.  A scene of ladder.h, and a tolerance for its displacement.  The
 * ladder begins with a bar; each rung adds what was left out most.  Whether it
 * is enough is asked of its own answer u, all that there is [alg:least-model].
 *
 * Run       make lesson-23; make lesson-23 ARGS=-h lists its options
 * PREDICT 1 angle at which linear elasticity sees 10 % strain (degrees): ...
 * PREDICT 2 part that is inertia, of the shaken block at rest (rung 2): ...
 * Plot: ladder rung estimate
 */
#include "choice/estimate.h"
#include "choice/scene_file.h"
#include "base/options.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

/*
 * part[GEOMETRY] = max |H^T H| / 2 over max |H|, H = F - I, each maximum over
 * all triangles [eq:left-geometry]; 0 where u = 0.
 */
static void shape_part(const struct ladder_state *s, double part[N_PART])
{
    /* SLOT 23a(s, part): one loop over s->mesh->n_triangle triangles. F is
     * body_deformation(s->body, s->u, e), and |H| is mat2_norm(H). */
    todo("23a", s, part);
    /* END 23a */
}

/*
 * The forces that a mesh leaves out [eq:left-mesh]: g += int (P + p I - what is
 * recovered) grad N.  Of P that is the mean of the triangle's three edges, each
 * the mean of the two triangles there, of p the mean of its vertices, each that
 * of all triangles around; the areas are the weights of what is averaged.
 */
static void mesh_forces(const struct ladder_state *s,
                        const struct relax_field *of, double g[])
{
    const size_t n = (size_t)s->mesh->n_vertex;
    const double *area = s->body->area;
    double *mean = allocate(n, sizeof *mean);     /* zero, */
    double *around = allocate(n, sizeof *around); /* and zero */
    /* SLOT 23b(s, of, g, area, mean, around): two loops over the triangles,
     * with of->P[e], of->p[e], the vertices s->mesh->triangle[3 * e + k] and,
     * beyond the edges opposite to them, the triangles s->across[3 * e + k], e
     * itself at the boundary. relax_push(s, e, T, g) adds int T grad N. */
    todo("23b", s, of, g, area, mean, around);
    /* END 23b */
    free(mean);
    free(around);
}

/*
 * The forces that a linear model leaves out [eq:left-stress]: stress turns with
 * the body, and P is (I + H) sigma to first order.  g += -int H sigma grad N,
 * H = of->H[e] of any displacement, sigma = relax_stress(s, e) of u.
 */
static void stress_forces(const struct ladder_state *s,
                          const struct relax_field *of, double g[])
{
    /* SLOT 23c(s, of, g): one loop over the triangles, as in 23b. */
    todo("23c", s, of, g);
    /* END 23c */
}

/*
 * part[DIMENSION] = (across + missed along) / (across + along)
 * [eq:left-dimension].  along = |N| length / height, across = 6 |moment|
 * length^2 / height^3: what the load moves the free end by, times E', as a bar
 * and as a beam.  N is the sum of the forces along X1, moment that about the
 * middle of the left end, which is held.  A bar has no across, and of along it
 * misses s^2 height / (2 length), s = lambda / (2 mu + lambda).  What bends is
 * less where N pulls, more where it presses: across is divided by 1 + N /
 * buckles; from -N = buckles on the part is 1.  0 where along and across are 0.
 *
 * part[INERTIA] = min(1, 1 / (omega T)), omega^2 = f.u / u.M u
 * [eq:left-inertia], and 1 where f.u or u.M u is not positive; Mu is M u for
 * the density 1.
 */
static void load_parts(const struct ladder_state *s, const double Mu[],
                       double part[N_PART])
{
    const double *f = s->f, *u = s->u, *X = s->mesh->X, T = s->scene->T;
    const double length = 2.0, height = length / s->scene->slender;
    const struct material *m = &s->body->material;
    const double buckles = ladder_buckles(s->scene); /* (N) */
    /* SLOT 23d(s, Mu, part, f, u, X, T, length, height, m, buckles): one loop
     * over s->mesh->n_vertex vertices; the left end is at X1 = -1. */
    todo("23d", s, Mu, part, f, u, X, T, length, height, m, buckles);
    /* END 23d */
}

/*
 * The verdict on a solved model [alg:least-model].  Parts that it has become 0:
 * a BAR leaves out dimension and geometry (its mesh is exact), LINEAR_PLANE
 * geometry, stress and mesh, CUBIC_PLANE law and mesh, LOG_PLANE mesh; at rest
 * each leaves out the inertia too, unless the load STANDS.  *estimate is the
 * root of the sum of the squares of what remains, *add the largest, of equal
 * ones the first.  A model is enough where *estimate <= tolerance.  Where K is
 * not positive definite (unstable) none is; a linear one needs the geometry.
 */
static int verdict(struct ladder_model model, enum ladder_time time, int stable,
                   double tolerance, double part[N_PART], double *estimate,
                   enum part *add)
{
    int enough = 0;
    /* SLOT 23e(model, time, stable, tolerance, part, estimate, add, &enough):
     * model.rung, model.moving; set the part, *estimate, *add, enough. */
    todo("23e", model, time, stable, tolerance, part, estimate, add, &enough);
    /* END 23e */
    return enough;
}

/* Climb from the bar, a row of `ladder` per rung; truth may be NULL.  Returns
 * whether the last is enough. */
static int climb(const struct ladder_scene *scene, double tolerance,
                 const struct ladder_state *truth)
{
    struct ladder_model model = ladder_first(scene);
    int enough = 0, more = 1;
    for (int rung = 1; more; rung++) {
        struct ladder_state *s = ladder_solve(scene, model);
        if (s->status != OK) die("model: %s", status_name(s->status));
        double part[N_PART], estimate, *Mu = ladder_momentum(s);
        enum part add;
        const int stable = ladder_stable(s);
        part[LAW] = estimate_law(s); /* [eq:left-law], as in lesson 02 */
        shape_part(s, part);
        load_parts(s, Mu, part);
        const double dimension = part[DIMENSION]; /* 23d, not the library's */
        relax_parts(s, mesh_forces, stress_forces, part);
        part[DIMENSION] = dimension;
        enough = verdict(model, scene->time, stable, tolerance, part, &estimate,
                         &add);
        more = !enough && ladder_add(scene, add, &model);
        table_row(rung, ladder_rung(s->model.rung),
                  s->model.moving ? "motion" : "rest", s->model.level,
                  part[GEOMETRY], part[LAW], part[DIMENSION],
                  part[INERTIA], part[MESH], part[STRESS],
                  stable ? "stable" : "unstable", estimate,
                  truth ? cell_rounded(7, ladder_error(s, truth))
                        : cell_word(MISSING),
                  s->flops,
                  enough ? "enough" : more ? ladder_part(add) : "nothing");
        free(Mu);
        ladder_free(s);
    }
    return enough;
}

int main(int argc, char *argv[])
{
    int which = LADDER_SCENES - 1, ask = 0;
    double tolerance = 0.1, load = 1.0;
    const char *path = NULL;
    const struct option options[] = {
        {"scene", .choice = &which, .choices = LADDER_WORDS, .help = "which"},
        {"tolerance", .real = &tolerance, .min = 1e-6, .max = 10,
         .help = "of the displacement, relative"},
        {"load", .real = &load, .min = 1e-3, .max = 3, .help = "multiplied"},
        {"file", .text = &path, .unit = "a file's name",
         .help = "a scene of one's own"},
        {"truth", .choice = &ask, .choices = "no yes", .help = "its error too"},
    };
    options_parse("23_least_model", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();

    struct scene_file own;
    if (path) scene_file_read("23_least_model", path, 2, &own);
    const struct ladder_scene scene =
        ladder_loaded(path ? &own.scene : &ladder_scene[which], load);
    struct ladder_state *truth = NULL;
    if (ask) truth = ladder_solve(&scene, ladder_truth(&scene));
    table_begin("ladder",
                "rung model state mesh geometry law dimension inertia "
                "mesh_part stress stable estimate error flops verdict");
    const int enough = climb(&scene, tolerance, truth);
    table_end();
    if (!enough) die("the ladder ends before %g is met", tolerance);
    ladder_free(truth);
    return table_finish();
}
