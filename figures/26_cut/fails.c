/*
 * fails.c - which cuts make the next step fail, and which start survives them?
 *
 * The square of lesson 26, 16 x 16, cubic law, is at rest under its full load
 * and is then cut at once.  Newton's method with a line search solves a step of
 * 1/30 s, or looks for rest, from the state before the cut or from u = 0.
 * Table fails: how it ends, and the systems if it may project on demand.
 *
 *     halfway    down the middle, from the upper side to the centre
 *     beside     the same, one cell from the held side
 *     slivers    halfway, where the vertices on its right are h / 20 from it
 *     through    beside the held side, all the way down
 *     triangle   one triangle in the middle is cut out
 *     thousand   1000 short strokes, here and there
 */
int program_main(int argc, char *argv[]);
#define PROGRAM "../../solutions/26_cut.c"
#define main program_main
#include PROGRAM
#undef main

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "plane/step.h"
#include "plane/tissue.h"

enum { N = 16, CUTS = 6, LOADS = 11, SLIVERS = 2, TRIANGLE = 4, THOUSAND = 5 };
static const char *const cuts[CUTS] = {"halfway", "beside", "slivers",
                                       "through", "triangle", "thousand"};

static void stroke(const struct mesh *mesh, const double blade[4], int cut[])
{
    int *chain = allocate((size_t)mesh->n_vertex, sizeof *chain);
    const int n = path(mesh, blade, tissue_nearest(mesh, blade),
                       tissue_nearest(mesh, &blade[2]), chain);
    tissue_mark(mesh, n, chain, cut);
    free(chain);
}

/* Mark cut k; slivers move vertices. */
static void mark(struct mesh *mesh, int k, int cut[])
{
    const double h = 2.0 / N;
    const double blade[TRIANGLE][4] = {{0.0, 1.0, 0.0, 0.0},
                                       {h - 1.0, 1.0, h - 1.0, 0.0},
                                       {0.0, 1.0, 0.0, 0.0},
                                       {h - 1.0, 1.0, h - 1.0, -1.0}};
    if (k == SLIVERS)
        for (int j = N / 2; j <= N; j++)
            mesh->X[2 * (j * (N + 1) + N / 2 + 1)] = h / 20.0;
    if (k < TRIANGLE) stroke(mesh, blade[k], cut);
    if (k == TRIANGLE) {
        const int *t = &mesh->triangle[3 * (N * N + N)];
        tissue_mark(mesh, 4, (int[]){t[0], t[1], t[2], t[0]}, cut);
    }
    for (int s = 1; k == THOUSAND && s <= 1000; s++) {
        const double x = 2.0 * fmod(0.7548776662 * s, 1.0) - 1.0;
        const double y = 2.0 * fmod(0.5698402910 * s, 1.0) - 1.0;
        stroke(mesh, (double[]){x, y, x + 0.3 * cos(s), y + 0.3 * sin(s)}, cut);
    }
}

/* From the state s, or from u = 0, by this method. */
static struct step_report trial(struct body *body, const struct tissue *s,
                                const char *method, int moving, int zero)
{
    const size_t rows = 2 * (size_t)s->mesh->n_vertex;
    const struct step_control control = step_method(method);
    double *u = allocate(rows, sizeof *u);
    if (!zero) memcpy(u, s->u, rows * sizeof *u);
    const struct step_report report = step_solve(
        body, &control, moving ? (struct incremental){1.0 / 30.0, s->u, s->f}
                               : at_rest(s->f), u);
    free(u);
    return report;
}

/* How many are solved, [cut][moving][u = 0], and the most systems with
 * projection. */
struct ends {
    int solved[CUTS][2][2], most;
};

/* A row for each kind of step, and at rest, after cut k under this load. */
static void print_trials(int k, double load, const struct tissue *s, int rest,
                         struct ends *ends)
{
    struct body *body = body_alloc(s->mesh, material_notes(CUBIC), 1.0, LUMPED,
                                   s->held);
    const double stretch = 1.0 + 0.5 * body_max_free(body, s->u);
    for (int moving = !rest; moving < 2; moving++)
        for (int zero = 0; zero < 2; zero++) {
            const struct step_report alone =
                trial(body, s, "search", moving, zero);
            const struct step_report all =
                trial(body, s, "demand+search", moving, zero);
            const int ok = alone.status == OK;
            if (all.status != OK) die("%s, %g N/m, fails", cuts[k], load);
            table_row(moving ? "step" : "rest", zero ? "zero" : "before",
                      cuts[k], k, load, stretch, status_name(alone.status),
                      cell_if(ok, alone.iterations), all.iterations);
            ends->solved[k][moving][zero] += ok;
            if (all.iterations > ends->most) ends->most = all.iterations;
        }
    body_free(body);
}

/* Cut k under all loads. */
static void print_cut(int k, struct ends *ends)
{
    const struct tissue square = tissue_alloc(mesh_square(N));
    int *cut = allocate(3 * (size_t)square.mesh->n_triangle, sizeof *cut);
    mark(square.mesh, k, cut);
    for (int j = 0, loose; j < LOADS; j++) {
        const double load = 25.0 * pow(2.0, 0.5 * j);
        const struct step_control search = step_method("search");
        struct tissue_whole whole = tissue_hold(&square, load);
        int *none = allocate(3 * (size_t)square.mesh->n_triangle, sizeof *none);
        const struct tissue before = cut_body(&whole, none, &square);
        struct body *body = body_alloc(before.mesh, material_notes(CUBIC), 1.0,
                                       LUMPED, before.held);
        if (step_solve(body, &search, at_rest(before.f), before.u).status != OK)
            die("%g N/m: the whole square has no rest", load);
        const struct tissue s = cut_body(&whole, cut, &before);
        memcpy(square.u, before.u,
               2 * (size_t)square.mesh->n_vertex * sizeof *square.u);
        tissue_parts(&s, &loose);
        print_trials(k, load, &s, !loose, ends);
        body_free(body);
        tissue_free(before);
        tissue_free(s);
        free(none);
        free(whole.across);
        free(whole.pulled);
    }
    tissue_free(square);
    free(cut);
}

int main(void)
{
    struct ends ends = {.most = 0};
    gsl_set_error_handler_off();
    table_begin("fails",
                "step start cut row load stretch status systems demand");
    for (int k = 0; k < CUTS; k++) print_cut(k, &ends);
    table_end();
    table_begin_note("most", "systems", "of all, projected on demand");
    table_row(ends.most);
    table_end();
    for (int k = 0; k < CUTS; k++) {
        const int before = ends.solved[k][1][0], zero = ends.solved[k][1][1];
        claim(k < TRIANGLE ? before >= 9 : before <= 4,
              "%s: from the state before the cut %d of %d steps are solved",
              cuts[k], before, LOADS);
        claim(k < THOUSAND ? zero >= 9 : zero <= 2,
              "%s: from u = 0 %d of %d steps are solved", cuts[k], zero, LOADS);
        claim(k > SLIVERS || ends.solved[k][0][0] < before,
              "%s: at rest fewer (%d)", cuts[k], ends.solved[k][0][0]);
    }
    claim(ends.most <= 20, "projected on demand, all end within 20 systems "
          "(%d)", ends.most);
    return table_finish();
}
