/*
 * @NN@_@NAME@.c - TODO: what the program computes, in one line.
 *
 * Notes: TODO: the section of the notes, or "beyond the notes".
 *
 * Problem.  TODO: the problem, with the labels of its equations.  What stands
 * here as an example: a line through 0 at the ends of n equal pieces of (0, 1),
 * and its integral by the trapezium rule.
 *
 * Run       make lesson-@NN@; make lesson-@NN@ ARGS=-h lists its options
 * PREDICT 1 the integral of 2.385 x over (0, 1): ...
 * PREDICT 2 the value at 1: ...
 * Plot: line x y
 */
#include "base/options.h"
#include "base/status.h"
#include "base/table.h"

#include <stdlib.h>

/*
 * y[i] := the line through 0 at x = i / n, i = 0 to n.
 */
static void values(int n, double slope, double y[])
{
    /* SLOT @N@a(n, slope, y): TODO: what to write; fill y[0..n]. */
    for (int i = 0; i <= n; i++) y[i] = slope * i / n; /* y(0) = 0 */
    /* END @N@a */
}

/*
 * The integral over (0, 1) of the function that has the values y at i / n and
 * is linear between them.
 */
static double integral(int n, const double y[])
{
    /* SLOT @N@b(n, y): TODO: what to write; return the integral. */
    double sum = 0.5 * (y[0] + y[n]); /* the ends belong to one piece only */
    for (int i = 1; i < n; i++) sum += y[i];
    return sum / n;
    /* END @N@b */
}

int main(int argc, char *argv[])
{
    int n = 4;
    double slope = 2.385;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 1000, .help = "pieces"},
        {"slope", .real = &slope, .min = -1e6, .max = 1e6, .help = "slope"},
    };
    options_parse("@NN@_@NAME@", options, COUNT(options), argc, argv);

    double *y = allocate((size_t)n + 1, sizeof *y);
    values(n, slope, y);
    table_begin("line", "x y");
    for (int i = 0; i <= n; i++) table_row((double)i / n, y[i]);
    table_end();
    table_begin("integral", "n integral");
    table_row(n, integral(n, y));
    table_end();
    free(y);
    return table_finish();
}
