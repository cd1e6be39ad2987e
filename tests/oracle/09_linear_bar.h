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

/* Where the relative error of linear elasticity first reaches 1, 5, 10 %:
 * strain for the stress at equal strain, load for the strain at equal load. */
static const struct {
    double percent, strain_t, strain_c, load_t, load_c;
} oracle_model_error[2][3] = {
    {{1, 0.010795498589063824, -0.010743244920793262, 14.532761068574414,
      -14.462404963602374},
     {5, 0.05451713478548569, -0.05321043554622907, 73.43733460492092,
      -71.66912848182503},
     {10, 0.11044919438708695, -0.10521792866587314, 149.11858901272515,
      -141.92719344781307}}, /* against the log law */
    {{1, 0.010760095022297326, -0.01077921129217855, 14.484624888201736,
      -14.510338150751137},
     {5, 0.05366034213958701, -0.05413781733979924, 72.2259147900806,
      -72.85591557842871},
     {10, 0.10716686650977753, -0.10907102456817158, 144.258532029431,
      -146.6101944294706}}, /* against the cubic law */
};

/* P_log = M e - (mu + 3 lambda / 2) e^2 + ...: error per strain */
static const double oracle_leading = 0.9285714286;

#endif
