/* compression.c - laws of figures/23_least_model/compression.h. */
#include "figures/23_least_model/compression.h"

#include "unit.h"

#include <math.h>

static int certified(const struct ladder_scene *scene, int level, int *stable)
{
    double flops;
    struct ladder_state *s =
        ladder_solve(scene, (struct ladder_model){BAR, 0, level});
    const int bound = compression_certifies(s, &flops);
    *stable = ladder_stable(s);
    ladder_free(s);
    return bound;
}

/* The largest pressure that passes, by the bound or by Cholesky's method. */
static double largest(int slender, double nu, int level, int by_bound)
{
    double low = 0.0, high = 400.0 / slender;
    for (int k = 0; k < 25; k++) {
        const double here = 0.5 * (low + high);
        const struct ladder_scene scene = {
            "pressed", slender, nu, .pull = {-here, 0.0}, .finest = 2};
        int stable;
        const int bound = certified(&scene, level, &stable);
        if (by_bound ? bound : stable)
            low = here;
        else
            high = here;
    }
    return low;
}

/* Columns are certified up to a part of the load at which they buckle, and none
 * beyond it; of a slender one that is most. */
static void no_column_is_certified_that_buckles(void)
{
    for (int slender = 2; slender <= 8; slender *= 2) {
        const double bound = largest(slender, 0.0, 0, 1);
        const double buckles = largest(slender, 0.0, 2, 0);
        ck_assert(bound > 0.5 * buckles && bound < 0.9 * buckles);
    }
}

/* Whatever is pulled, and only a little else. */
static void what_is_pulled_is_certified(void)
{
    for (double pull = 1.0; pull < 200.0; pull *= 2.3) {
        const struct ladder_scene scene = {
            "pulled", 4, 0.27, .pull = {pull, 0.0}, .finest = 1};
        int stable;
        ck_assert(certified(&scene, 0, &stable) && stable);
    }
}

/* The proof is for whole squares: of others nothing is said. */
static void parts_of_squares_are_refused(void)
{
    for (double slender = 2.0; slender < 3.0; slender += 0.25) {
        const struct ladder_scene scene = {
            "pulled", slender, 0.3, .pull = {5.0, 0.0}, .finest = 1};
        int stable;
        ck_assert_int_eq(certified(&scene, 0, &stable), slender < 2.1);
        ck_assert(stable);
    }
}

/* The work: a try of two triangles for each section; K with its factors. */
static void certificates_are_charged(void)
{
    double flops;
    struct ladder_state *s = ladder_solve(
        &ladder_scene[0], (struct ladder_model){BAR, 0, 0});
    ck_assert(compression_certifies(s, &flops));
    ck_assert_double_eq(flops, 60.0 * 2 * 16);
    ck_assert(compression_cholesky(s) > 250.0 * 128 + 160 * 100);
    ladder_free(s);
    s = ladder_solve(&ladder_scene[5], (struct ladder_model){BAR, 0, 0});
    ck_assert(!compression_certifies(s, &flops));
    ck_assert_double_eq(flops, 4 * 60.0 * 2 * 16);
    ladder_free(s);
    s = ladder_alloc(&ladder_scene[6],
                     (struct ladder_model){LINEAR_PLANE, 1, 0});
    ck_assert_double_eq(compression_cholesky(s), 0.0);
    ladder_free(s);
}

static const struct unit_law laws[] = {
    {"no_column_is_certified_that_buckles",
     no_column_is_certified_that_buckles},
    {"what_is_pulled_is_certified", what_is_pulled_is_certified},
    {"parts_of_squares_are_refused", parts_of_squares_are_refused},
    {"certificates_are_charged", certificates_are_charged},
};

UNIT_MAIN("compression", laws)
