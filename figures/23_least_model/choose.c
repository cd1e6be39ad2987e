/*
 * choose.c - scenes in numbers without dimension: do they tell the least model?
 *
 * The twelve scenes of ladder.h, three in which a load along the axis acts on
 * what another one bends, and a block whose strain alone is too large, with the
 * numbers of numbers.h.  Four comparisons with a tolerance of 10 % name a
 * model, and beside it stands the cheapest that is within 10 % of the truth,
 * with its error and its price.  Table: scenes.
 */
#include "numbers.h"
#include "prices.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

static const double tolerance = 0.1;

/* From the least model to the richest. */
static const char *const name[] = {
    "hanging", "below-buckling", "slow-pull", "slender-column", "cantilever",
    "small-twist", "incompressible", "fast-pull", "large-twist",
    "above-buckling", "squeezed", "stout-column", "guyed", "leaning", "arch",
    "shaken"};
enum { ALL = sizeof name / sizeof *name };

/* lessons/scenes/pressed.scene with three quarters of its load. */
static const struct ladder_scene squeezed = {
    "squeezed", 1, 0.3, .pull = {-150.0, 0.0}, .finest = 2};

static const struct ladder_scene *scene_named(const char *word)
{
    for (int k = 0; k < LADDER_SCENES; k++)
        if (strcmp(ladder_scene[k].name, word) == 0) return &ladder_scene[k];
    for (int k = 0; k < LADDER_TWO_LOADS; k++)
        if (strcmp(ladder_two_loads[k].name, word) == 0)
            return &ladder_two_loads[k];
    if (strcmp(squeezed.name, word) == 0) return &squeezed;
    die("there is no scene %s", word);
}

/* A row; true: where the numbers put the scene, on both axes, is where the
 * cheapest model is.  *by_strain counts those in which strain decides alone. */
static int print_scene(const struct ladder_scene *scene, int *by_strain)
{
    static struct prices prices;
    int none;
    const struct numbers n = numbers_of(scene);
    prices_find(scene, &prices);
    const struct ladder_model least =
        prices_cheapest(&prices, tolerance, &none);
    const struct price *price = prices_at(&prices, least);
    struct numbers unstrained = n;
    unstrained.strained = 0.0;
    *by_strain += numbers_rung(unstrained, tolerance) !=
                  numbers_rung(n, tolerance);
    table_row(scene->name, scene->nu, cell_rounded(2, n.strain),
              cell_rounded(3, n.strained), cell_rounded(3, n.geometry),
              cell_rounded(2, n.bends), cell_rounded(3, n.force),
              cell_rounded(3, n.turned),
              n.moves > 0.0 ? cell_rounded(3, n.moves) : cell_word(MISSING),
              ladder_rung(least.rung),
              least.moving ? "motion" : "rest", least.level,
              cell_rounded(2, 100.0 * price->error),
              cell_rounded(2, price->flops));
    return !none && least.rung == numbers_rung(n, tolerance) &&
           least.moving == numbers_moving(n, tolerance);
}

int main(void)
{
    int right = 0, by_strain = 0;
    gsl_set_error_handler_off();
    table_begin("scenes", "scene nu strain strained geometry bends force "
                          "turned moves least state mesh error flops");
    for (int k = 0; k < ALL; k++)
        right += print_scene(scene_named(name[k]), &by_strain);
    table_end();
    claim(right == ALL && by_strain == 1, "the numbers tell the least model in "
          "%d of %d scenes, and strain decides alone in %d", right, ALL,
          by_strain);
    return table_finish();
}
