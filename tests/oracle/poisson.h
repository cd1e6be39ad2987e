/*
 * poisson.h - numbers of the Poisson exercises from an independent computation.
 *
 * Source: Python with mpmath (40 digits) and numpy, written from the weak form
 * and not from this project's code; rounded to doubles.  Linear elements on
 * (0, 1), N equal elements.
 */
#ifndef TESTS_ORACLE_POISSON_H
#define TESTS_ORACLE_POISSON_H

/*
 * 2-norm condition numbers, beta = 1.  DD: both ends Dirichlet, order N - 1;
 * DN: left end Dirichlet, order N.  one: DN with modulus 1346.153846153846 and
 * the replaced equation's diagonal set to 1; with the diagonal kept it is DN.
 */
static const struct {
    int N;
    double DD, DN, one;
} oracle_condition[] = {
    {4, 5.82842712474619, 29.28405223595454, 19018.94015666592},
    {16, 103.08686891981746, 437.69761653851197, 85375.39003593197},
    {64, 1659.3796462927587, 6740.677204247274, 344411.0372107264},
};

/* -u'' = e^x, flux 0 at x = 0 and -(e - 1) at x = 1: sum of the midpoint-rule
 * right-hand side, and the N = 4 solution with zero nodal mean. */
static const struct {
    int N;
    double sum_b;
} oracle_neumann[] = {{4, -0.0044665486879582415},
                      {16, -0.00027963640638492256}};
static const double oracle_neumann_u4[] = {
    0.257750541639648, 0.22211632504691178, 0.10537941015462053,
    -0.11543200004864439, -0.46981427679253596};

/*
 * Exercise (5): -((1+x)u')' = (1+x)^-2, u(0) = 1, 2u'(1) = -1/2.  Load by the
 * midpoint rule and by exact integration; L2 and H1 (unweighted u') errors.
 */
struct oracle_bvp {
    int N;
    double nodal, L2, H1, reaction;
};
static const struct oracle_bvp oracle_bvp_midpoint[] = {
    {4, 0.0008385800825273764, 0.0018719482913449274, 0.024813032592327578,
     0.004452063519662587},
    {16, 5.5135034768265334e-05, 0.0001236011329557285, 0.006465264133367355,
     0.00028440094535410834},
    {64, 3.457416426403139e-06, 7.75303365793405e-06, 0.0016207812073732908,
     1.780023676416831e-05},
};
static const struct oracle_bvp oracle_bvp_exact_load[] = {
    {4, 0.0010466918695353463, 0.002436343736951133, 0.024846264378632014, 0.0},
    {16, 6.765894036354488e-05, 0.00015954454868402976, 0.0064658697752193565,
     0.0},
    {64, 4.237933589503486e-06, 1.0002354409701776e-05, 0.00162079077096418,
     0.0},
};
static const double oracle_bvp_u4_midpoint[] = {
    1.0, 0.9770627787514604, 0.9283175732611818, 0.869617325448508,
    0.8076913995225821};
static const double oracle_bvp_A4[] = { /* before any correction */
    4.5, -4.5, 0, 0, 0, -4.5, 10, -5.5, 0, 0, 0, -5.5, 12, -6.5, 0,
    0, 0, -6.5, 14, -7.5, 0, 0, 0, -7.5, 7.5};
static const double oracle_bvp_b4_midpoint[] = {
    0.09876543209876543, 0.16488113457810427, 0.11345298058584771,
    0.08289283366206443, -0.46444444444444444};

#endif
