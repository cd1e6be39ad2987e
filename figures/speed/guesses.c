/*
 * guesses.c - how many linear systems does a step need, by where it starts?
 *
 * The ends are pulled apart by sin t / 2 each (stretch), 30 steps of 1/30 s,
 * cubic law; Newton's method starts from the last u, from u + dt v, from the
 * same with the jump of the boundary lifted [eq:lift-2d], and extrapolated and
 * lifted; with new factors for every system, or with factors that are kept
 * [alg:chord].  Counts, no seconds; every run has to end in the same u.
 */
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 30, GUESSES = 4, SIZES = 5 };
static const struct {
    const char *name;
    enum guess guess;
    int lift;
} start[GUESSES] = {{"newton_last", FROM_LAST, 0},
                    {"newton_velocity", FROM_VELOCITY, 0},
                    {"newton_velocity_lift", FROM_VELOCITY, 1},
                    {"newton_extrapolated_lift", EXTRAPOLATED, 1}};

struct tally {
    enum status status; /* of the last step */
    int systems, most, factorisations;
    double failed; /* t of the step that failed (s) */
    double apart;  /* max|u - answer| in the end (m) */
};

/* answer: [n_dof], written when record. */
static struct tally run(int n, int g, int chord, int record,
                        double answer[])
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct step_control control = step_method("notes");
    struct tally tally = {.status = OK};
    set.reach = 0.5;
    struct scene *s = scene_alloc(&set);
    control.guess = start[g].guess;
    control.lift = start[g].lift;
    control.chord = chord;
    while (s->steps < STEPS && tally.status == OK) {
        s->body->kept.usable = 0; /* each step begins with new ones */
        const struct step_report report = scene_step(s, &control);
        tally.status = report.status;
        tally.systems += report.iterations;
        tally.factorisations += report.factorisations;
        if (report.iterations > tally.most) tally.most = report.iterations;
    }
    tally.failed = (s->steps + 1) * set.dt;
    if (record) memcpy(answer, s->u, (size_t)s->n_dof * sizeof *answer);
    for (int r = 0; r < s->n_dof; r++)
        tally.apart = fmax(tally.apart, fabs(s->u[r] - answer[r]));
    scene_free(s);
    return tally;
}

int main(void)
{
    const int size[SIZES] = {8, 16, 32, 64, 96};
    static struct tally tally[SIZES][GUESSES][2];
    int wrong = 0;
    for (int k = 0; k < SIZES; k++) {
        const int vertices = (size[k] + 1) * (size[k] + 1);
        double *answer = allocate(2 * (size_t)vertices, sizeof *answer);
        for (int g = GUESSES - 1; g >= 0; g--)
            for (int chord = 0; chord < 2; chord++)
                tally[k][g][chord] = run(size[k], g, chord,
                                         g == GUESSES - 1 && !chord, answer);
        free(answer);
    }
    for (int g = 0; g < GUESSES; g++) {
        table_begin_note(start[g].name,
                         "n full_mean full_max chord_mean chord_max "
                         "chord_factorisations difference full_failed "
                         "chord_failed",
                         "systems per step; chord: factors are kept while "
                         "max|du| falls below 0.3 of the one before; failed: "
                         "t of the step that did (s)");
        for (int k = 0; k < SIZES; k++) {
            const struct tally full = tally[k][g][0], kept = tally[k][g][1];
            const int a = full.status == OK, b = kept.status == OK;
            const double apart = fmax(full.apart, kept.apart);
            table_row(size[k], cell_if(a, (double)full.systems / STEPS),
                      cell_if(a, full.most),
                      cell_if(b, (double)kept.systems / STEPS),
                      cell_if(b, kept.most),
                      cell_if(b, (double)kept.factorisations / STEPS),
                      cell_if(a && b, apart), cell_if(!a, full.failed),
                      cell_if(!b, kept.failed));
            wrong += !(a && b && apart < 1e-9);
        }
        table_end();
    }
    const struct tally *best = tally[SIZES - 1][GUESSES - 1];
    claim(wrong == 0, "all runs end in the same displacements (%d do not)",
          wrong);
    claim(best[0].systems <= tally[0][GUESSES - 1][0].systems + 3 &&
              best[1].factorisations < 1.2 * STEPS,
          "with the best guess the systems do not grow with n, and kept "
          "factors last for the whole step");
    return table_finish();
}
