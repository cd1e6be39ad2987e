/*
 * 15_definiteness.h - modes of dP/dF, and the column, independently computed.
 *
 * Modes: mpmath, 50 digits, closed forms that agree with its eigensolver to
 * 1e-33 and with central differences of P to 1e-20; rounded to doubles.
 * E = 1000, nu = 0.3, cubic law unless log is said.  projected: row by row.
 *
 * Column: double precision, scipy, an independent finite element code; 80 x 8
 * cells, residual below 1e-9; out: of the middle (m), -1 where it is straight.
 */
#ifndef TESTS_ORACLE_15_DEFINITENESS_H
#define TESTS_ORACLE_15_DEFINITENESS_H

#include "material/material.h"

static const struct {
    const char *name;
    enum law law;
    mat2 F;
    double s1, s2, twist, flip, low, high;
} oracle_modes[] = {
    {"generic", CUBIC, {{{1.17, 0.23}, {-0.31, 0.88}}}, 1.2103807116160457,
     0.9095485324862191, 85.33190604847853, 683.8988631822907,
     665.930817896769, 1798.95357082789},
    {"generic", LOG, {{{1.17, 0.23}, {-0.31, 0.88}}}, 1.2103807116160457,
     0.9095485324862191, 85.62645969428182, 683.6043095364874,
     665.7593335776746, 1817.2008371676404},
    {"stretched", CUBIC, {{{2.31, 0.19}, {-0.27, 1.43}}}, 2.325905733592375,
     1.4422768522173943, 8281.75789414929, -7512.527124918521,
     -6775.805543395545, 135758.98219744625},
    {"stretched", LOG, {{{2.31, 0.19}, {-0.27, 1.43}}}, 2.325905733592375,
     1.4422768522173943, 478.1148741129031, 291.1158951178661,
     295.8939993402467, 648.5638376546099},
    {"inverted", CUBIC, {{{0.9, 0.4}, {0.35, -0.6}}}, 0.9905945548198767,
     -0.6864564283049657, -16561.96395323077, 17331.19472246154,
     -15942.246674982562, 61586.919911905636},
    {"pressed to a line", CUBIC, {{{1.1, 0.5}, {0.44, 0.2}}},
     1.3013838787997951, 0.0, -3942.3076923076924, 4711.538461538462,
     -703.2771913056143, 17594.277191305613},
};

/* The inverted state with its negative eigenvalues set to 0. */
static const double oracle_projected[16] = {
    20901.454217004215, 6934.028702017395, 7750.128976148065,
    -25798.05586178824, 6934.028702017395, 12575.407677062129,
    13018.203641884791, -9590.804490953371, 7750.128976148065,
    13018.203641884791, 13495.745434464781, -10615.379731628005,
    -25798.05586178824, -9590.804490953371, -10615.379731628005,
    31945.50730583605};

static const struct {
    double e, straight, buckled, out;
    int stable; /* is the straight column? */
} oracle_column[] = {
    {0.02, 0.08946751336471621, 0.08946751336471621, -1.0, 1},
    {0.04, 0.3621113763509317, 0.35422048584304616, 0.10107347482842402, 0},
};

#endif
