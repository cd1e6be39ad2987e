/*
 * 01_deformation.h - numbers of lesson 01 from an independent computation.
 *
 * Source: Python with mpmath (40 digits) and with exact fractions, independent
 * of this project, from the definitions; rounded to doubles.  E = 1000,
 * nu = 0.3.
 */
#ifndef TESTS_ORACLE_01_DEFORMATION_H
#define TESTS_ORACLE_01_DEFORMATION_H

/* The angle at which the linear strain of a rotation, cos(angle) - 1, reaches
 * a level in size. */
static const struct {
    double level, degrees;
} oracle_rotation[] = {{0.01, 8.109614455994178},
                       {0.05, 18.19487233876678},
                       {0.1, 25.84193276316713}};

/* What the linear law gives to a rotation by 30 degrees: stress and energy are
 * 2 (mu + lambda) e and 2 (mu + lambda) e^2, e = cos 30 - 1; and to F skew, or
 * to the collapse F = 0, e = -1. */
static const double oracle_strain_30 = -0.1339745962155614;
static const double oracle_stress_30 = -257.6434542606949;
static const double oracle_energy_30 = 34.51767775215905;
static const double oracle_stress_collapsed = -1923.076923076923;

/* The log law's stress of X^2 at X = 0.1, 0.01, 0.001. */
static const double oracle_log_stress[] = {
    -6488.763208944521, -132069.89438735036, -1984982.3360833244};

/* Strains of F = (1.247 -0.613; 0.385 0.731), entries 11 12 21 22. */
static const double oracle_linear[] = {0.247, -0.114, -0.114, -0.269};
static const double oracle_green[] = {
    0.351617, -0.241488, -0.241488,
    -0.044935};
static const double oracle_left[] = {
    0.465389, 0.015996, 0.015996,
    -0.158707};

/* A triangle before and after, the F between them by Cramer's rule. */
static const double oracle_X[] = {0.137, -0.242, 1.385, 0.371, 0.613, 1.714};
static const double oracle_x[] = {2.385, 0.731, 1.247, 1.613, 3.714, 2.137};
static const double oracle_triangle_F[] = {
    -1.4146954822500348, 1.0237193504862048, 0.4016721723351789,
    0.6210654631740566};
static const double oracle_triangle_J = -1.2898180803052157;

/* sin 2 pi X on n equal elements of (0, 1), in exact rational arithmetic: an
 * element inverts when its midpoint is inside (1/4, 3/4), and collapses when
 * it is at 1/4 or 3/4. */
static const struct {
    int n, inverted, collapsed;
} oracle_sine[] = {{2, 0, 2}, {3, 1, 0}, {4, 2, 0},
                   {5, 3, 0}, {6, 2, 2}, {7, 3, 0},
                   {8, 4, 0}, {9, 5, 0}, {10, 4, 2},
                   {11, 5, 0}, {12, 6, 0}, {13, 7, 0}};

#endif
