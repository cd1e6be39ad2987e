/*
 * 11_newton_failure.c - where Newton's method fails, predicted, and two
 * of the four cures.
 *
 * Notes: Lecture 2, sections 2.5.5 and 2.5.6.
 * Problem.  In a bar with one free end every element carries a known stress p,
 * and Newton's method [alg:newton] is F := F + (p - P(F)) / P'(F) in each one.
 *
 *         P |       .-'
 *           |    .-'o F0        the tangent at F0 meets the level p at F1; when
 *     ------+--/-.'------ F     is F1 <= 0?
 *           | /.'
 *       p - +.' - - -
 *
 * Run       make lesson-11; make lesson-11 ARGS=-h lists its options
 * PREDICT 1 iterations of the log law at p = -1346: ...
 * PREDICT 2 largest time step of the notes' example with 100 elements (s): ...
 * Plot: history k F logy
 */
#include "bar/bar.h"
#include "base/options.h"
#include "base/table.h"

#include <float.h>
#include <math.h>

struct outcome {
    enum status status;
    int iterations; /* linear systems solved */
    double F;       /* the last state */
};

/*
 * Given F and the increment, which is the |step| that led to F, INFINITY at the
 * start, return where the iteration stands; *step is the next, 0 if none.
 *
 * INVERTED        the law is not defined at F
 * NONFINITE       the residual P(F) - p or the step is not a finite number
 * OK              converged: the residual is 0, or |residual| <= tolerance
 *                 (2 mu + lambda) and increment <= tolerance as well
 * STALLED         not converged, and increment <= DBL_EPSILON cannot change F
 * MAX_ITERATIONS  none of these: go on with the step
 */
static enum status newton_step(const struct material *material, double p,
                               double F, double increment, double tolerance,
                               double *step)
{
    *step = 0.0;
    /* SLOT 11a(material, p, F, increment, tolerance, step): given p and F, find
     * reason and step; write every comparison so that a NaN fails it. */
    if (!material_defined(material, F)) return INVERTED;
    const double residual = material1_pk1(material, F) - p;
    /* p = P(F) + P'(F) step */
    const double next = -residual / material1_dpk1(material, F);
    const double small = tolerance * material_modulus(material);
    /* before the step is looked at: P' may be 0 where nothing is left over */
    if (residual == 0.0) return OK;
    if (!isfinite(residual) || !isfinite(next)) return NONFINITE;
    if (fabs(residual) <= small && increment <= tolerance) return OK;
    if (increment <= DBL_EPSILON) return STALLED;
    *step = next;
    return MAX_ITERATIONS;
    /* END 11a */
}

/* What the failures of the log law should be, for a load step that starts from
 * F > 0; start and pull are infinite at nu = 0. */
struct limits {
    double load;     /* p at or below which the first step from F inverts */
    double step;     /* largest drop of the load from the equilibrium at F */
    double start;    /* F0 at or above which it inverts for p = 0 */
    double push;     /* dg / h from rest at or above which F0 is inverted */
    double pull;     /* dg / h from rest at or below which the first step is */
    double collapse; /* p at which the cubic law has F = 0 */
};
static struct limits predict(double mu, double lambda, double F)
{
    struct limits limits = {0};
    /* SLOT 11b(mu, lambda, F, &limits): given F, set the six closed forms of
     * "On paper" 2 to 4 and 6.  limits.load at F = 1 is -(2 mu + lambda). */
    /* F1 = F + (p - P) / P' is 0 at p = P - F P' */
    limits.load = (2.0 * lambda * log(F) - 2.0 * mu - lambda) / F;
    limits.step = mu * F + (mu + lambda - lambda * log(F)) / F; /* F P' */
    /* limits.load = 0, solved for F */
    limits.start = exp(0.5 + mu / lambda);
    /* F0 = 1 - dg / h has to stay above 0 and below limits.start */
    limits.push = 1.0;
    limits.pull = 1.0 - limits.start;
    /* r = -11/6 and r' = 3 at J = 0 */
    limits.collapse = -(3.0 * mu + 5.5 * lambda);
    /* END 11b */
    return limits;
}

/*
 * *length is the first of 1, 1/2, 1/4, ... > 1e-12 at which the law is defined
 * and the energy w(F) = psi(F) - p (F - 1) falls enough [alg:line-search],
 *     w(F + length step) <= w(F) + 1e-4 length w'(F) step + noise,
 * noise = 16 eps |w(F)|: at the minimum w has no digits left to compare.
 * NOT_SPD: the step does not lead downhill (P' < 0).  STALLED: no length does.
 */
static enum status line_search(const struct material *material, double p,
                               double F, double step, double *length)
{
    const double w = material1_psi(material, F) - p * (F - 1.0);
    const double slope = (material1_pk1(material, F) - p) * step;
    *length = 1.0;
    /* SLOT 11c(material, p, F, step, length, w, slope): given F and a step,
     * find *length and the status.  Ask for psi only where it is defined. */
    const double noise = 16.0 * DBL_EPSILON * fabs(w);
    if (!(slope < 0.0)) return NOT_SPD;
    for (; *length > 1e-12; *length *= 0.5) {
        const double trial = F + *length * step;
        /* no energy there: the length is too long */
        if (!material_defined(material, trial)) continue;
        const double w_trial =
            material1_psi(material, trial) - p * (trial - 1.0);
        if (w_trial <= w + 1e-4 * *length * slope + noise) return OK;
    }
    return STALLED;
    /* END 11c */
}

/* Newton from F until P(F) = p [alg:newton], as bar_newton() on one element. */
static struct outcome solve(const struct material *material, double p,
                            double F, const struct newton_control *control)
{
    double step, length = 1.0, increment = INFINITY;
    for (int k = 0;; k++) {
        enum status status = newton_step(material, p, F, increment,
                                         control->tolerance, &step);
        if (status != MAX_ITERATIONS || k >= control->max_iterations)
            return (struct outcome){status, k, F};
        if (control->line_search) {
            status = line_search(material, p, F, step, &length);
            if (status != OK) return (struct outcome){status, k + 1, F};
        }
        F += length * step;
        increment = fabs(step);
    }
}

/*
 * Load stepping with halving [alg:load-stepping].  At the fraction s of the way
 * the load is s p and the boundary has moved by s jump (in units of h).  A
 * step from s to s + ds <= 1, the first from 0 to 1, starts at the last
 * equilibrium (F = 1 at s = 0) less ds jump.  If it converges, ds := 2 ds; if
 * not, it is taken back, ds := ds / 2.  One attempt may take `patience`
 * iterations, all of them, also the failed ones, control->max_iterations (then:
 * MAX_ITERATIONS).  STALLED: ds < 2^-10.  F is the last equilibrium.
 */
static struct outcome load_stepping(const struct material *material, double p,
                                    double jump,
                                    const struct newton_control *control)
{
    const int patience = 25;
    struct newton_control attempt = *control;
    struct outcome state = {OK, 0, 1.0};
    /* SLOT 11d(material, p, jump, patience, &attempt, &state): given a load and
     * a jump, walk from s = 0 to 1 by calls of solve(), the books in state. */
    const int budget = attempt.max_iterations;
    double s = 0.0, ds = 1.0;
    while (s < 1.0 && state.status == OK) {
        const int left = budget - state.iterations;
        attempt.max_iterations = left < patience ? left : patience;
        ds = fmin(ds, 1.0 - s);
        const struct outcome trial = solve(
            material, (s + ds) * p, state.F - ds * jump, &attempt);
        state.iterations += trial.iterations;
        if (trial.status == OK) {
            state.F = trial.F;
            s += ds;
            /* as fast up as down: one bad place costs the rest nothing */
            ds *= 2.0;
        } else {
            ds *= 0.5;
            if (ds < ldexp(1.0, -10)) state.status = STALLED;
            if (state.iterations >= budget) state.status = MAX_ITERATIONS;
        }
    }
    /* END 11d */
    return state;
}

int main(int argc, char *argv[])
{
    int law = LOG, search = 0, stepping = 0, cap = 1000;
    double nu = 0.3, p = -1346.0, start = 1.0;
    const struct option options[] = {
        {"law", .choice = &law, .choices = MATERIAL_LAWS, .help = "material"},
        {"nu", .real = &nu, .min = 0.0, .max = 0.4999,
         .help = "Poisson's ratio", .why = "at 1/2 lambda is infinite"},
        {"p", .real = &p, .min = -1e12, .max = 1e12, .help = "stress, N/m^2"},
        {"start", .real = &start, .min = -20.0, .max = 20.0,
         .help = "F0; by stepping the boundary moves by 1 - F0"},
        {"search", .choice = &search, .choices = "off on",
         .help = "line search"},
        {"stepping", .choice = &stepping, .choices = "off on",
         .help = "load stepping from rest"},
        {"cap", .integer = &cap, .min = 1, .max = 1000, .help = "iterations"},
    };
    options_parse("11_newton_failure", options, COUNT(options), argc, argv);
    const struct material m = material_make((enum law)law, 1000.0, nu);
    struct outcome end = {OK, 0, start};

    /* the state after k iterations is where a run with the cap k ends */
    table_begin("history", "k F residual");
    for (int k = 0; k <= cap; k++) {
        const struct newton_control control = {1e-10, k, search, 0};
        end = stepping ? load_stepping(&m, p, 1.0 - start, &control)
                       : solve(&m, p, start, &control);
        if (end.iterations < k) break;
        const double P = material_defined(&m, end.F)
                             ? material1_pk1(&m, end.F) : NAN;
        table_row(k, end.F, cell_if(isfinite(P), P - p));
    }
    table_end();
    table_begin("limits", "F load step start push pull collapse");
    for (int k = 0; k < 4; k++) {
        const double F = (double[]){1.0, 0.75, 0.25, 0.05}[k];
        const struct limits l = predict(m.mu, m.lambda, F);
        table_row(F, l.load, l.step, cell_if(isfinite(l.start), l.start),
                  l.push, cell_if(isfinite(l.pull), l.pull), l.collapse);
    }
    table_end();
    if (end.status != OK)
        die("%s after %d iterations, F = %g", status_name(end.status),
            end.iterations, end.F);
    return table_finish();
}
