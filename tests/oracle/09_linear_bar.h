/*
 * 09_linear_bar.h - numbers of the linear bar from an independent computation.
 *
 * Source: Python with mpmath and numpy, independent of this project; rounded
 * to doubles.  E = 1000, nu = 0.3, uniaxial strain.
 */
#ifndef TESTS_ORACLE_09_LINEAR_BAR_H
#define TESTS_ORACLE_09_LINEAR_BAR_H

/* Bar of length 1, u(0) = 0, P(1) = 0, body force c: u(1) of the linear law,
 * and of the cubic and the log law on 16 elements (midpoint loads). */
static const struct {
    double c, linear, cubic16, log16;
} oracle_hanging[] = {
    {10.0, 0.0037142857142857142, 0.0037314461483301076, 0.003731416617320355},
    {500.0, 0.18571428571428572, 0.24091178375151712, 0.23701196874011776},
    {2000.0, 0.7428571428571429, 0.96226644947015, 1.6282716677063909},
    {-10.0, -0.0037142857142857142, -0.0036973173223975985,
     -0.003697288404573222},
    {-500.0, -0.18571428571428572, -0.1525823055134903, -0.1504676137297446},
    {-1300.0, -0.4828571428571429, -0.31736125322669223, -0.2997788380647934},
};

#endif
