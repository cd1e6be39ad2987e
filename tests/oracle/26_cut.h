/*
 * 26_cut.h - how strongly a cut at the side of a pulled strip concentrates the
 * stress: K_I = s sqrt(pi a) F(a / b), far ends pulled by s.
 *
 * Source: H. Tada, P. C. Paris and G. R. Irwin, The Stress Analysis of Cracks
 * Handbook (3rd edition, ASME Press, 2000), single edge notch test specimen:
 * two formulas, each said to be within 0.5 per cent, the first up to r = 0.6.
 *
 *     F(r) = 1.12 - 0.231 r + 10.55 r^2 - 21.72 r^3 + 30.39 r^4
 *     F(r) = sqrt(2 / (pi r) tan(pi r / 2)) / cos(pi r / 2)
 *            (0.752 + 2.02 r + 0.37 (1 - sin(pi r / 2))^3)
 *
 * Evaluated by Python, independent of this project.
 */
#ifndef TESTS_ORACLE_26_CUT_H
#define TESTS_ORACLE_26_CUT_H

static const struct {
    double r, polynomial, closed;
} oracle_edge_crack[] = {{0.2, 1.370664, 1.366661},
                         {0.3, 1.659919, 1.655113},
                         {0.4, 2.103504, 2.107964},
                         {0.5, 2.826375, 2.826581},
                         {0.6, 4.026424, 4.043210}};

#endif
