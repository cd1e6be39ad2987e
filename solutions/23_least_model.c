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
    double forgotten = 0.0, most = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, s->u, e);
        const mat2 H = mat2_subtract(F, mat2_identity());
        /* The strain is (H + H^T) / 2 + H^T H / 2; linear is without that. */
        const mat2 HtH = mat2_multiply(mat2_transpose(H), H);
        forgotten = fmax(forgotten, 0.5 * mat2_norm(HtH));
        most = fmax(most, mat2_norm(H));
    }
    part[GEOMETRY] = most > 0.0 ? forgotten / most : 0.0;
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
    for (int e = 0; e < s->mesh->n_triangle; e++)
        for (int k = 0; k < 3; k++) {
            const int a = s->mesh->triangle[3 * e + k];
            mean[a] += area[e] * of->p[e]; /* over around[a]: the mean */
            around[a] += area[e];
        }
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        mat2 T = mat2_scale(of->p[e], mat2_identity());
        for (int k = 0; k < 3; k++) {
            const int a = s->mesh->triangle[3 * e + k];
            const int b = s->across[3 * e + k];
            /* P[e] less the edge's mean is b's share of the jump */
            const double share = area[b] / (area[e] + area[b]);
            const mat2 jump = mat2_subtract(of->P[e], of->P[b]);
            const mat2 p = mat2_scale(mean[a] / around[a], mat2_identity());
            T = mat2_add(T, mat2_scale(share / 3.0, jump));
            T = mat2_subtract(T, mat2_scale(1.0 / 3.0, p));
        }
        relax_push(s, e, T, g);
    }
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
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 T = mat2_multiply(of->H[e], relax_stress(s, e));
        relax_push(s, e, mat2_scale(-1.0, T), g);
    }
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
    double N = 0.0, moment = 0.0, work = 0.0, mass = 0.0;
    for (int x = 0, y = 1; x < 2 * s->mesh->n_vertex; x += 2, y += 2) {
        N += f[x];
        /* (X - (-1, 0)) cross f */
        moment += (X[x] + 1.0) * f[y] - X[y] * f[x];
        work += f[x] * u[x] + f[y] * u[y];
        mass += u[x] * Mu[x] + u[y] * Mu[y];
    }
    /* A bar narrows freely; where it is held, s of it is missed. */
    const double lateral = m->lambda / (2.0 * m->mu + m->lambda);
    const double along = fabs(N) * length / height;
    double across = 6.0 * fabs(moment) * pow(length, 2) / pow(height, 3);
    across /= fmax(0.0, 1.0 + N / buckles);
    const double missed = lateral * lateral * height / (2.0 * length);
    part[DIMENSION] = 0.0;
    if (N <= -buckles)
        part[DIMENSION] = 1.0; /* where it goes no bar can say */
    else if (across + along > 0.0)
        part[DIMENSION] = (across + missed * along) / (across + along);
    part[INERTIA] = 1.0;
    /* f = K u at rest: f.u / u.M u is Rayleigh's quotient of u. */
    if (work > 0.0 && mass > 0.0)
        part[INERTIA] = fmin(1.0, 1.0 / (sqrt(work / mass) * T));
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
    /* what the model has is not left out */
    if (model.rung != BAR) part[DIMENSION] = 0.0;
    if (model.rung == BAR) part[MESH] = 0.0;
    if (model.rung != BAR && model.rung != LINEAR_PLANE) part[GEOMETRY] = 0.0;
    if (model.rung != LINEAR_PLANE) part[STRESS] = 0.0;
    if (model.rung != CUBIC_PLANE) part[LAW] = 0.0;
    if (model.moving || time == STANDS) part[INERTIA] = 0.0;
    *estimate = 0.0;
    *add = GEOMETRY;
    for (int k = 0; k < N_PART; k++) {
        *estimate = hypot(*estimate, part[k]);
        if (part[k] > part[*add]) *add = (enum part)k;
    }
    /* Where a body goes when it buckles is a matter of geometry. */
    if (!stable && model.rung <= LINEAR_PLANE) *add = GEOMETRY;
    enough = stable && *estimate <= tolerance;
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
