/*
 * choose.c - scenes in numbers without dimension: do they tell the least model?
 *
 * The twelve scenes of ladder.h, and three in which a load along the axis acts
 * on what another one bends, with the numbers of numbers.h.  Four comparisons
 * with a tolerance of 10 % name a model, and beside it stands the cheapest that
 * is within 10 % of the truth.  Table: scenes.
 */
#include "numbers.h"
#include "prices.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

static const double tolerance = 0.1;

/* From the least model to the richest. */
static const char *const name[] = {
    "hanging", "below-buckling", "slow-pull", "slender-column", "cantilever",
    "small-twist", "incompressible", "fast-pull", "large-twist",
    "above-buckling", "stout-column", "guyed", "leaning", "arch", "shaken"};
enum { ALL = sizeof name / sizeof *name };

static const struct ladder_scene *scene_named(const char *word)
{
    for (int k = 0; k < LADDER_SCENES; k++)
        if (strcmp(ladder_scene[k].name, word) == 0) return &ladder_scene[k];
    for (int k = 0; k < LADDER_TWO_LOADS; k++)
        if (strcmp(ladder_two_loads[k].name, word) == 0)
            return &ladder_two_loads[k];
    die("there is no scene %s", word);
}

/* A row; true: where the numbers put the scene, on both axes, is where the
 * cheapest model is. */
static int print_scene(const struct ladder_scene *scene)
{
    static struct prices prices;
    int none;
    const struct numbers n = numbers_of(scene);
    prices_find(scene, &prices);
    const struct ladder_model least =
        prices_cheapest(&prices, tolerance, &none);
    table_row(scene->name, scene->slender, scene->nu,
              cell_rounded(2, n.strain), cell_rounded(3, n.geometry),
              cell_rounded(2, n.bends), cell_rounded(3, n.force),
              cell_rounded(3, n.turned),
              n.moves > 0.0 ? cell_rounded(3, n.moves) : cell_word(MISSING),
              ladder_rung(least.rung),
              least.moving ? "motion" : "rest", least.level);
    return !none && least.rung == numbers_rung(n, tolerance) &&
           least.moving == numbers_moving(n, tolerance);
}

int main(void)
{
    int right = 0;
    gsl_set_error_handler_off();
    table_begin("scenes", "scene slender nu strain geometry bends force turned "
                          "moves least state mesh");
    for (int k = 0; k < ALL; k++)
        right += print_scene(scene_named(name[k]));
    table_end();
    claim(right == ALL, "the numbers tell the least model in %d of %d "
          "scenes", right, ALL);
    return table_finish();
}
