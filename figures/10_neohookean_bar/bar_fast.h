/*
 * bar_fast.h - Newton's method for the bar of bar.h, cubic law, when seconds
 * count: assembly fused into the tridiagonal sweep [alg:fused-sweep].
 *
 * A step of bar_newton() passes over memory again and again: residual, tangent,
 * elimination, back substitution.  Everything that one node needs is known when
 * the sweep gets there, so two passes will do.  The first reads u and b and
 * keeps two numbers per node, the second turns them into the increment:
 *
 *     forward    l_i = c / (c + 1/k_e),  z_i = l_i y / k_e,
 *                then  c := c + 1/k_e,  y := l_i y + (what node e adds to -q)
 *     backward   du_i = z_i + l_i du_{i+1},   u_i += du_i
 *
 * c is the compliance of the bar between the held end and node i: springs in
 * series add theirs.  This is the elimination with the pivot k_e + 1/c.  The
 * usual form of it, pivot_i = k_i + k_{i+1} - k_i^2 / pivot_{i-1}, has the
 * small 1/c as a difference of large numbers and loses digits as n grows; here
 * nothing is subtracted while P' > 0, and no division waits for another.
 * Behind a free end 1/c = 0: l_i = 1, z_i = y / k_e.
 *
 * y still waits for the y before.  Two sweeps that start at the two ends and
 * meet at a node do not wait for each other: each has a lane of the same
 * registers (vec.h).
 */
#ifndef BAR_FAST_H
#define BAR_FAST_H

#include "bar/bar.h"

enum elimination { FROM_LEFT, FROM_BOTH_ENDS };

/*
 * bar_newton() for the law CUBIC, neither line_search nor definite (asserted):
 * the same iterates to round-off, the same tests, statuses and report.
 *
 * NOT_SPD    a pivot is 0 to round-off; negative ones are no failure
 * NONFINITE  a NaN or an infinity came out (also where some P' is 0)
 */
struct newton_report bar_fast_newton(const struct bar *bar,
                                     const struct newton_control *control,
                                     enum elimination sweep, double u[]);

#endif
