/*
 * scramble.c - which law brings a scrambled square back, and what is it worth
 * where nothing is scrambled?
 *
 * The vertices of a square, all or the inner ones only (boundary held), are put
 * at random places and let go [alg:release].  Table: how many squares come
 * back, in per cent with the standard error, the median number of iterations of
 * these and of the others, and the stress error at a stretch of 1.1.  (PLAIN
 * storage: its digits are the same on every machine, as a chaotic path needs.)
 */
#include "plane/release.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sort_int.h>
#include <gsl/gsl_statistics_int.h>
#include <math.h>

enum { LARGEST = 81 /* vertices */, SIZES = 3, MOST_STARTS = 2000 };
static const int cells[SIZES] = {2, 4, 8}; /* the last is free only */
static const int starts_of[SIZES] = {MOST_STARTS, 500, 50};

/* P / P_log - 1 in per cent, at F = 1.1 in uniaxial strain. */
static double error_of(enum law law)
{
    const struct material m = material_notes(law), log = material_notes(LOG);
    return 100.0 * fabs(material1_pk1(&m, 1.1) / material1_pk1(&log, 1.1) - 1);
}

struct count {
    int starts, recovered, stuck, inverted, wound, at_893;
    int not_spd;        /* stopped so, all of them inside out */
    double median[2];   /* of the iterations: stuck, recovered; or NAN */
    double rate, error; /* recovered, its standard error (%) */
};

static double median_of(int sample[], int size)
{
    gsl_sort_int(sample, 1, (size_t)size);
    return size == 0 ? NAN : gsl_stats_int_median_from_sorted_data(
                                 sample, 1, (size_t)size);
}

/* Seeds 1, 2, ... */
static struct count scramble(int size, enum law law, int held_boundary)
{
    const int n = cells[size];
    struct count count = {.starts = starts_of[size]};
    struct mesh *mesh = mesh_square(n);
    int held[LARGEST] = {0}, iterations[2][MOST_STARTS];
    if (held_boundary)
        for (int j = 0; j <= n; j++)
            for (int i = 0; i <= n; i++)
                held[j * (n + 1) + i] = i == 0 || i == n || j == 0 || j == n;
    struct body *body =
        body_alloc(mesh, material_notes(law), 0.0, CONSISTENT, held);
    body_store(body, PLAIN);
    for (int seed = 1; seed <= count.starts; seed++) {
        double x[2 * LARGEST] = {0.0};
        release_scramble(body, (unsigned)seed, x);
        const struct release_report report = release_solve(body, 300, x);
        int *these = iterations[report.recovered];
        these[report.recovered ? count.recovered++ : count.stuck++] =
            report.iterations;
        if (report.recovered) continue;
        count.inverted += !(report.min_J > 0.0);
        count.not_spd += report.status == NOT_SPD && !(report.min_J > 0.0);
        count.wound += report.min_J > 0.0 && release_winding(body, x) > 1.5;
        count.at_893 += fabs(report.energy - 893.414401) < 1e-5;
    }
    count.median[0] = median_of(iterations[0], count.stuck);
    count.median[1] = median_of(iterations[1], count.recovered);
    count.rate = 100.0 * count.recovered / count.starts;
    count.error = 100.0 * rate_error(count.recovered, count.starts);
    body_free(body);
    mesh_free(mesh);
    return count;
}

/* By how many standard errors does a recover more often than b? */
static double apart(const struct count *a, const struct count *b)
{
    return rate_apart(a->recovered, a->starts, b->recovered, b->starts);
}

static void print(int size, int held, enum law law, const struct count *c)
{
    table_row(cells[size], held ? "held" : "free", material_law(law),
              c->starts, c->recovered, c->rate, c->error, c->wound,
              cell_if(c->recovered > 0, c->median[1]),
              cell_if(c->stuck > 0, c->median[0]), error_of(law));
}

/* all[size][boundary][law] */
static void judge(struct count all[SIZES][2][3])
{
    for (int size = 0; size < SIZES; size++) {
        const struct count *c = all[size][0], *held = all[size][1];
        for (int k = 0; k < 3; k++) {
            claim(c[k].wound + c[k].inverted == c[k].stuck &&
                      c[k].not_spd == c[k].inverted &&
                      (size == 2 || c[k].inverted == 0),
                  "what is stuck is wound twice; only with n = 8 some stop "
                  "inside out, all with NOT_SPD");
            claim(held[k].stuck == 0, "held, a square always comes back");
        }
        claim(fmin(apart(&c[2], &c[0]), apart(&c[2], &c[1])) > RATE_SURE &&
                  fabs(apart(&c[0], &c[1])) < RATE_SURE,
              "free squares come back most often under the stable law; between "
              "the two others %d starts show no difference", c->starts);
    }
    const struct count *two = all[0][0], *eight = all[2][0];
    claim(two->at_893 == two->stuck, "the cubic law is stuck at 893.4 J/m");
    claim(eight[0].rate < 10 && eight[1].rate < 10 && eight[2].stuck == 0,
          "with n = 8 none but the stable law brings more than a few back");
}

int main(void)
{
    const enum law law[] = {CUBIC, EXTENDED, STABLE};
    struct count all[SIZES][2][3] = {0}; /* size, boundary, law */
    gsl_set_error_handler_off();
    table_begin("scramble", "n boundary law starts recovered rate "
                            "standard_error wound iterations iterations_stuck "
                            "error");
    for (int size = 0; size < SIZES; size++)
        for (int held = 0; held < (size < 2 ? 2 : 1); held++)
            for (int k = 0; k < 3; k++) {
                all[size][held][k] = scramble(size, law[k], held);
                print(size, held, law[k], &all[size][held][k]);
            }
    table_end();

    judge(all);
    claim(error_of(STABLE) > 10 * error_of(CUBIC) && error_of(EXTENDED) == 0,
          "the stable law is the least accurate, extended has no error");
    return table_finish();
}
