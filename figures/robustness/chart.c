/*
 * chart.c - which method, and which law, for which scene?
 *     stretch         ends pulled apart by sin t each, n = 8, 45 steps
 *     jerk            ends moved to and fro, n = 16, 20 steps of 0.13 s, of
 *                     0.16, 0.2 and 0.25 s: the first by 1.0 to 2.0 cells
 *     press           a column shortened by 5 %; its limit is 4.0 %; no saddle
 *     crushed         a square, n = 4, flat or inside out, let go: 4 ways
 *     scrambled_held  its inner vertices at random: 25 ways; standard error
 *     scrambled_free  all of them; error: of the stress at a stretch of 1.1
 */
#include "first_step.h"
#include "base/clock.h"
#include "plane/release.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <string.h>

enum { STRETCHED, JERKED, PRESSED, CRUSHED, HELD, FREE, SCENE, METHOD = 12,
       RUNS = 5 };
static const struct {
    const char *name;
    int starts, steps;
} scene[SCENE] = {{"stretch", 1, 45}, {"jerk", 4, 20}, {"press", 1, 1},
    {"crushed", 4, 1}, {"scrambled_held", 25, 1}, {"scrambled_free", 25, 1}};
static const struct {
    const char *name;
    enum law law;
} method[METHOD] = {{"notes", LOG}, {"notes", CUBIC}, {"lift", LOG},
    {"lift", CUBIC}, {"search", LOG}, {"search", CUBIC}, {"search", STABLE},
    {"demand+search", LOG}, {"demand+search", CUBIC},
    {"demand+search", EXTENDED}, {"demand+search", STABLE},
    {"always+search", CUBIC}};

/* Steps of a body that is moved, in way k; whether all are OK; counts linear
 * systems. */
static int move(int which, int k, enum law law, struct step_control control,
                int *systems)
{
    static const double jerk[] = {0.13, 0.16, 0.2, 0.25};
    struct scene_setting set = scene_notes(STRETCH, law, 8);
    if (which == JERKED) {
        set = scene_notes(RIGID, law, 16);
        set.dt = jerk[k];
    }
    if (which == PRESSED) set = scene_column(law, 40, 0.05 / sin(1.0));
    struct scene *s = scene_alloc(&set);
    int ok = 1;

    if (which == PRESSED) {
        control.lift = 1;
        first_scatter(s, 1, 1e-3);
    }
    while (ok && s->steps < scene[which].steps) {
        const struct step_report report = scene_step(s, &control);
        *systems += report.iterations;
        ok = report.status == OK;
    }
    if (which == PRESSED && ok)
        ok = step_certify(s->body, at_rest(NULL), s->u) == OK;
    scene_free(s);
    return ok;
}

/* The square that is let go. */
enum { SIDE = 4, VERTICES = (SIDE + 1) * (SIDE + 1), DOFS = 2 * VERTICES };

/* System after system, a tiny mass on what turns freely; whether to rest. */
static int let_go(int which, int k, enum law law, struct step_control control,
                  int *systems)
{
    struct mesh *mesh = mesh_square(SIDE);
    int held[VERTICES], rest = 0;
    double u[DOFS] = {0.0}, w[DOFS], energy;

    for (int a = 0; a < VERTICES; a++)
        held[a] = which == HELD && fmax(fabs(mesh->X[2 * a]),
                                        fabs(mesh->X[2 * a + 1])) == 1.0;
    struct body *body =
        body_alloc(mesh, material_notes(law), 1e-4, CONSISTENT, held);
    if (which == CRUSHED) release_place(body, RELEASE_CRUSHED[k].F, u);
    if (which != CRUSHED) release_scramble(body, (unsigned)k + 1, u);
    control.max_iterations = 1;
    const struct incremental Phi = {1.0, w, NULL};
    enum status s = MAX_ITERATIONS;
    while (s == MAX_ITERATIONS && *systems < 200 && !rest) {
        memcpy(w, u, sizeof w);
        s = step_solve(body, &control, Phi, u).status;
        rest = body_energy(body, u, &energy) == OK &&
               fabs(energy) <= RELEASE_ENERGY && body_min_J(body, u) > 0.0;
        ++*systems;
    }
    body_free(body);
    mesh_free(mesh);
    return rest;
}

/* A row; returns the systems per step and start if all pass, otherwise 0. */
static double try(int which, int m)
{
    const struct step_control control = step_method(method[m].name);
    const struct material law = material_notes(method[m].law);
    const struct material exact = material_notes(LOG);
    const int starts = scene[which].starts;
    struct times time = {0};
    int passed = 0, all = 0;
    for (int run = 0; run < RUNS; run++) {
        double seconds = 0.0;
        passed = all = 0;
        for (int k = 0; k < starts; k++) {
            int systems = 0;
            const double start = clock_seconds();
            if (!(which < CRUSHED ? move : let_go)(which, k, law.law, control,
                                                   &systems))
                continue;
            seconds += clock_seconds() - start;
            all += systems;
            passed++;
        }
        times_record(&time, seconds, passed > 0);
    }
    const double share = (double)passed * scene[which].steps;
    const double error = /* of the stress at a stretch of 1.1 */
        fabs(material1_pk1(&law, 1.1) / material1_pk1(&exact, 1.1) - 1.0);
    table_row(method[m].name, material_law(law.law), scene[which].name,
              100.0 * passed / starts,
              cell_if(which >= HELD, 100.0 * rate_error(passed, starts)),
              cell_if(passed > 0, all / share),
              cell_if(passed > 0, 1e3 * times_median(&time) / share),
              100.0 * error);
    return passed == starts ? all / share : 0.0;
}

int main(void)
{
    double all[METHOD][SCENE]; /* systems where all pass, otherwise 0 */

    study_machine();
    table_begin("chart", "method law scene passed passed_se systems ms error");
    for (int m = 0; m < METHOD; m++)
        for (int k = 0; k < SCENE; k++) all[m][k] = try(k, m);
    table_end();

    claim(all[0][STRETCHED] > 0.0, "a stretch needs nothing");
    claim(all[2][JERKED] < 0.4 * all[8][JERKED],
          "in a jerk a lift takes less than two fifths of the systems");
    claim(all[7][PRESSED] > 0.0 && all[7][HELD] == 0.0 && all[8][HELD] > 0.0 &&
              all[8][CRUSHED] > 0.0,
          "past its limit a column needs a projection, a tangle another law");
    for (int m = 0; m < METHOD; m++) {
        claim((all[m][JERKED] > 0.0) == (m == 2 || m == 3 || m >= 8),
              "a jerk beyond a cell needs a lift, or else a projection and a "
              "law that is defined everywhere");
        claim(m >= 7 || all[m][PRESSED] == 0.0, "only a projection helps");
        claim((all[m][FREE] > 0.0) == (m == 10),
              "only the stable law brings all back");
    }
    return table_finish();
}
