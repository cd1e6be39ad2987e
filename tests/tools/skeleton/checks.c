/*
 * @NN@_@NAME@.c - what a right program satisfies.
 *
 * TODO: the claims of the lesson, cheapest and most telling first.
 *
 * Arguments: slot, argument: varied by checks
 *     @N@a, @N@b  n         values_...: 7 and 1; the_integral_...: 5
 *     @N@a      slope     values_...
 *     @N@b      y         the_integral_...: no line; ...of_a_line_...: a line
 */
#include "program.h"

#include "judge.h"

static void values_lie_on_the_line(void)
{
    static const int pieces[] = {7, 1};
    for (int k = 0; k < COUNT(pieces); k++) {
        const int n_piece = pieces[k];
        double *y_got = guarded_alloc(n_piece + 1);
        values(n_piece, -0.613, y_got);
        for (int i = 0; i <= n_piece; i++)
            expect_close(y_got[i], -0.613 * i / n_piece, 1e-14, 0.613,
                         "y at %d of %d pieces", i, n_piece);
    }
}

/* 0.5 y_0 + y_1 + ... + 0.5 y_n, by hand, over n. */
static void the_integral_weighs_every_value(void)
{
    static const double weight[] = {0.1, 0.2, 0.2, 0.2, 0.2, 0.1};
    for (int k = 0; k < COUNT(weight); k++) {
        double unit[6] = {0.0};
        unit[k] = 1.0;
        expect_close(integral(5, guarded_copy(6, unit)), weight[k], 1e-14, 1.0,
                     "the integral of a hat at node %d of 5", k);
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    const struct output *const r = run("");
    measured("1", cell(r, "integral", "integral", 0));
    measured("2", cell(r, "line", "y", -1));
}

static const struct claim claims[] = {
    {"values_lie_on_the_line", values_lie_on_the_line, "@N@a"},
    {"the_integral_weighs_every_value", the_integral_weighs_every_value,
     "@N@b"},
};

static const char *const runs[] = {
    "",
    "--n 1",
    "--n 7 --slope -0.613",
};

static const struct column_rule rules[] = {
    {"line", "*", 1e-14, "one product", 0},
    {"integral", "*", 1e-13, "a sum of n values", 0},
};

static const struct lesson lesson = {
    "@NN@_@NAME@", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "TODO: what to notice after a pass.",
    "TODO: one thing to break, and the question that it asks.",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
