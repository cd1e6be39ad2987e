/*
 * choose.c - scenes in numbers without dimension: do they tell the least model?
 *
 * The twelve scenes of ladder.h, and three in which a load along the axis acts
 * on what another one bends.  Of the linear answer at rest on the coarsest
 * mesh: its largest strain, what the geometry leaves out, and 1 / (omega T); by
 * the beam's formulas alone: the share of bending [eq:left-dimension], and the
 * axial force over the one that buckles.  `turned` is the larger of geometry
 * and of axial force times bending, times 1 + 2 / (omega T) in motion, for so
 * far a body may overshoot; and 1 or more where it is pressed beyond its
 * buckling load.  Three comparisons with a tolerance of 10 % then name a model,
 * and beside it stands the cheapest within 10 % of the truth.
 * Table: scenes.
 */
#include "prices.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

enum { OTHERS = 3 };
static const struct ladder_scene other[OTHERS] = {
    {"guyed", 4, 0.3, .weight = {0.0, -1.0}, .pull = {30.0, 0.0}, .finest = 2},
    {"leaning", 4, 0.3, .pull = {-8.0, -0.08}, .finest = 2},
    {"arch", 8, 0.3, .weight = {0.0, -0.4}, .pull = {6.0, 0.0}, .finest = 2},
};
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
    for (int k = 0; k < OTHERS; k++)
        if (strcmp(other[k].name, word) == 0) return &other[k];
    die("there is no scene %s", word);
}

/* The axial force over the one that buckles a beam, > 0 where it presses: at
 * the end pi^2/4 E' I / L^2, and 7.84 E' I / L^2 is the weight of a column that
 * buckles under itself. */
static double axial(const struct ladder_scene *s)
{
    const double pi = 2.0 * acos(0.0), L = 2.0, height = L / s->slender;
    const double bending =
        1000.0 / (1.0 - s->nu * s->nu) * pow(height, 3) / 12.0 / (L * L);
    return -(s->pull[0] * height / (0.25 * pi * pi) +
             s->weight[0] * L * height / 7.84) / bending;
}

static double largest_strain(const struct ladder_state *s)
{
    double most = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++)
        most = fmax(most, mat2_norm(ladder_strain(s, e)));
    return most;
}

/* Bending takes triangles, and so does motion; turning takes a law. */
static enum rung rung_of(double bends, double turned, double moves)
{
    if (turned > tolerance) return CUBIC_PLANE;
    return bends > tolerance || moves > tolerance ? LINEAR_PLANE : BAR;
}

/* A row; true: where the numbers put the scene, on both axes, is where the
 * cheapest model is. */
static int print_scene(const struct ladder_scene *scene)
{
    static struct prices prices;
    int none;
    struct ladder_state *s =
        ladder_solve(scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
    const double bends = estimate_dimension(s), force = axial(scene);
    const double geometry = estimate_geometry(s);
    const double moves = scene->time == STANDS ? 0.0 : estimate_inertia(s);
    double turned =
        (1.0 + 2.0 * moves) * fmax(geometry, fabs(force) * bends);
    if (force >= 1.0) turned = fmax(turned, force);
    prices_find(scene, &prices);
    const struct ladder_model least =
        prices_cheapest(&prices, tolerance, &none);
    table_row(scene->name, scene->slender, scene->nu,
              cell_rounded(2, largest_strain(s)), cell_rounded(3, geometry),
              cell_rounded(2, bends), cell_rounded(2, force),
              cell_rounded(3, turned),
              moves > 0.0 ? cell_rounded(3, moves) : cell_word(MISSING),
              ladder_rung(least.rung),
              least.moving ? "motion" : "rest", least.level);
    ladder_free(s);
    return !none && least.rung == rung_of(bends, turned, moves) &&
           least.moving == (moves > tolerance);
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
