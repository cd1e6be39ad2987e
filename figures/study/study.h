/*
 * study.h - what the studies in figures/ share: a root, an order, seconds that
 * can be trusted, and the claim that a study ends with.
 */
#ifndef FIGURES_STUDY_H
#define FIGURES_STUDY_H

/* A function of one number and its context. */
typedef double study_function(double x, void *context);

/*
 * Return the x between low and high, in either order, with f(x) = 0, to the
 * last digit, by GSL's Brent.  f must change its sign between them; die() when
 * it does not, or when f is not finite there.
 */
double study_root(study_function *f, void *context, double low, double high);

/* Return log(coarse / fine) / log(ratio) [eq:order]: errors at the sizes ratio
 * h and h.  NAN unless both errors are > 0. */
double study_order(double coarse, double fine, double ratio);

/*
 * What the caption of the picture says, as a condition; the rest is a printf
 * message that says it in words.  A study prints its tables first.  When the
 * condition is false the study ends with the message and exit status 1.
 */
#define claim(condition, ...) \
    do { \
        if (!(condition)) study_claim_failed(__VA_ARGS__); \
    } while (0)
_Noreturn void study_claim_failed(const char *format, ...)
    __attribute__((__format__(__printf__, 1, 2)));

/* ---- rates of random runs ------------------------------------------------ */

/*
 * Return the standard error of the rate hits / runs of independent runs: the
 * standard deviation of the true rate when nothing else is known of it
 * (Laplace).  That is nearly sqrt(p (1 - p) / runs), and 1 / runs for none and
 * for all.
 */
double rate_error(int hits, int runs);

/*
 * The difference of two rates of independent runs in its standard errors, > 0
 * when the first is the larger one.  A study claims a difference from RATE_SURE
 * on.  (From the same starts, as studies have them, it is rather surer.)
 */
enum { RATE_SURE = 3 };
double rate_apart(int hits, int runs, int other_hits, int other_runs);

/* ---- seconds ------------------------------------------------------------ */

/* Samples of the seconds that one run takes.  A run whose answer is not valid
 * has no seconds: its sample is NAN, and so is then every figure below. */
enum { STUDY_SAMPLES = 1024 };
struct times {
    int runs;
    double second[STUDY_SAMPLES];
};

/* Add a sample, as long as there is room. */
void times_record(struct times *t, double seconds, int valid);

double times_best(const struct times *t);
double times_median(const struct times *t);
double times_quantile(const struct times *t, double fraction);

/* Print "# machine: ..." at the top of the output, for tables with seconds. */
void study_machine(void);

#endif
