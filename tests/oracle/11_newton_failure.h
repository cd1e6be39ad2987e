/*
 * 11_newton_failure.h - Newton's method in one dimension, independently.
 *
 * Source: Python with mpmath (40 digits) and numpy, written from the energies
 * and not from this project's code; rounded to doubles.  E = 1000, nu = 0.3
 * unless it is a column.
 */
#ifndef TESTS_ORACLE_11_NEWTON_FAILURE_H
#define TESTS_ORACLE_11_NEWTON_FAILURE_H

/* One scalar Newton run; iterations -1: it fails, F has left F > 0. */
static const struct {
    int cubic;
    double p, start;
    int iterations;
    double F;
} oracle_newton[] = {
    {1, 0, -9, 15, 1},
    {1, 0, -1, 9, 1},
    {1, 0, 0.001, 8, 1},
    {1, 0, 0.5, 6, 1},
    {1, 0, 2, 6, 1},
    {1, 0, 3.2, 9, 1},
    {1, 0, 5, 11, 1},
    {1, -100, 1, 5, 0.9304753267190372},
    {1, -1346, 1, 7, 0.4505273415497815},
    {1, -4000, 1, 10, 0.03407234534350597},
    {1, -1e5, 1, 20, -1.8041873118077048},
    {1, 1000, 1, 7, 2.1139170266075706},
    {0, 0, -9, -1, 0},
    {0, 0, -1, -1, 0},
    {0, 0, 0.001, 17, 1},
    {0, 0, 0.5, 7, 1},
    {0, 0, 2, 8, 1},
    {0, 0, 3.2, 17, 1},
    {0, 0, 5, -1, 0},
    {0, -100, 1, 5, 0.9305775651514606},
    {0, -1346, 1, 21, 0.505330550872447},
    {0, -1347, 1, -1, 0},
    {0, -4000, 1, -1, 0},
    {0, -1e5, 1, -1, 0},
    {0, 1000, 1, 6, 2.4580047785573833},
};

static const double oracle_load = -1346.1538461538462; /* log, from rest */
static const double oracle_start = 3.2112705431535606; /* log, p = 0 */
static const double oracle_pull = -2.2112705431535606; /* dg / dX */
static const double oracle_collapse = -4326.923076923077; /* cubic: F = 0 */
static const struct {
    double F, p, step; /* equilibrium, largest drop of the load from it */
} oracle_step[] = {{1.0, 0.0, 1346.1538461538462},
                   {0.75, -445.6528762449597, 1791.8067223988057},
                   {0.25, -4641.448525661286, 7141.448525661286},
                   {0.05, -42239.21854100759, 53816.14161793067}};

/* Log law, p = 0: first step and residual of squashed starts. */
static const struct {
    double start, step_over_start, residual;
} oracle_false[] = {{1e-4, 0.9080629433108106, -56982732.87678567},
                    {1e-8, 0.9502174189773132, -1101193119843.4058},
                    {1e-12, 0.9658676136007543, -1.6325589105343394e+16}};

/* p = 0, cubic, small nu: start -> the rest state that Newton finds */
static const struct {
    double nu, start, F;
} oracle_rest[] = {{0.0, 1.9, 1.0},
                   {0.0, 2.5, 3.0},
                   {0.0, 6.0, 3.0},
                   {0.02, 2.1, 4.6995538937327135},
                   {0.02, 4.0, 1.0}};

#endif
