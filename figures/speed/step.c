/*
 * step.c - what does a whole time step cost, and what does an accuracy cost?
 *
 * Stretch by sin t / 2, 90 steps of 1/30 s, cubic law, to max|du| <= 1e-10 m:
 *
 *     readable  readable.h, full Newton from the last u, GSL's banded Cholesky
 *     lapack    closed-form assembly, the same Newton, dpbtrf and dpbtrs
 *     blocked   the same with common/linear/tiles.c
 *     best      guess extrapolated and lifted, factors kept [alg:chord]
 *     sparse    the same with common/linear/sparse.c
 *
 * They take turns; one that was twice too slow for 30 pictures per second does
 * a few steps.  A run off the path of `sparse` ends it.
 */
#include "exact.h"
#include "machine.h"
#include "readable.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <string.h>

enum method { READABLE, LAPACK_BAND, BLOCKED, BEST, DISSECTED, METHODS };
static const char *name[] = {"readable", "lapack", "blocked", "best", "sparse"};
enum { FRAMES = 90, SECOND = 30, SIZES = 16 }; /* n = 8, 16, 24, ..., 128 */

struct measured {
    struct times t[METHODS];
    int n, steps[METHODS], systems[METHODS];
    double read;             /* ms of a step of best, L read [eq:roofline] */
    double u[2 * 129 * 129]; /* at t = 1 */
};

static int lapack_increment(struct readable *r, const double w[],
                            const double u[], double du[])
{
    const struct incremental Phi = {r->dt, w, NULL};
    body_assemble(r->body, Phi, u, EXACT, r->q);
    cblas_dscal(2 * r->body->mesh->n_vertex, -1.0, r->q, 1);
    body_gather(r->body, r->q, r->K); /* which has room, and nothing to do */
    if (!lapack_factor(r->body->K)) return 0;
    lapack_solve(r->body->K, r->K);
    body_scatter(r->body, r->K, du);
    return 1;
}

/* Steps first .. last.  path: u, v, v_before [3 n_dof] after step 0, 1, ...; a
 * run starts there and is compared with it, or `sparse` writes it on. */
static void run(int k, struct scene *s, int first, int last, double path[],
                struct measured *m)
{
    const size_t n_dof = (size_t)s->n_dof, state = 3 * n_dof;
    struct step_control control = step_method(k >= BEST ? "lift" : "notes");
    body_store(s->body, k == DISSECTED ? SPARSE : BANDED);
    exact_factors(s->body);
    struct readable *r = readable_alloc(s->body, s->set.dt);
    control.chord = k >= BEST;
    double *const now[3] = {s->u, s->v, s->v_before};
    for (size_t i = 0; i < 3; i++)
        memcpy(now[i], &path[(size_t)(first - 1) * state + i * n_dof],
               n_dof * sizeof *path);
    for (int step = first; step <= last; step++) {
        double *at = &path[(size_t)step * state], apart = 0.0;
        scene_hold(s, step * s->set.dt);
        s->body->kept.usable = 0; /* kept within a step, as `best` does */
        const double before = clock_seconds();
        const struct step_report report =
            k < BLOCKED
                ? readable_step(r, k ? lapack_increment : readable_gsl, s->g,
                                s->u, s->v)
                : step_backward_euler(s->body, &control, s->set.dt, s->g, NULL,
                                      s->u, s->v, s->v_before);
        const double seconds = clock_seconds() - before;
        for (size_t i = 0; i < 3; i++)
            if (k == DISSECTED)
                memcpy(&at[i * n_dof], now[i], n_dof * sizeof *at);
        for (size_t i = 0; i < n_dof; i++)
            apart = fmax(apart, fabs(s->u[i] - at[i]));
        claim(report.status == OK && apart <= 1e-9, "%s: the same u", name[k]);
        times_record(&m->t[k], seconds, 1);
        m->steps[k]++;
        m->systems[k] += report.iterations;
    }
    readable_free(r);
}

static void measure(int n, int missed[METHODS], struct measured *m)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    m->n = n;
    set.reach = 0.5;
    struct scene *s = scene_alloc(&set);
    double *path = allocate((FRAMES + 1) * 3 * (size_t)s->n_dof, sizeof *path);
    run(DISSECTED, s, 1, FRAMES, path, m); /* and memory is touched */
    m->t[DISSECTED].runs = 0;
    body_store(s->body, BANDED);
    const size_t room = matrix_bytes(s->body->K); /* with what pads columns */
    const double bytes = 32.0 * n * (n * n - 1); /* 8 N (p + 1) */
    for (int turn = 0; turn < (n <= 16 ? 10 : n <= 32 ? 3 : 1); turn++)
        for (int k = 0; k < METHODS; k++) {
            if (k == LAPACK_BAND && !*MACHINE_LAPACK) continue;
            if (missed[k] < 2) run(k, s, 1, FRAMES, path, m);
            else if (k == BEST || (n & (n - 1)) == 0) /* a power of 2 */
                run(k, s, 12, k == READABLE ? 13 : k == LAPACK_BAND ? 14 : 19,
                    path, m);
        }
    for (int k = 0; k < METHODS; k++)
        missed[k] += !(times_quantile(&m->t[k], 0.99) <= set.dt);
    m->read = 2e-6 * m->systems[BEST] / m->steps[BEST] * bytes /
              machine_read_gigabyte(room);
    memcpy(m->u, &path[SECOND * 3 * s->n_dof], (size_t)s->n_dof * sizeof *m->u);
    free(path);
    scene_free(s);
}

static struct cell ms(const struct times *t, double fraction)
{
    return cell_if(t->runs > 0, 1e3 * times_quantile(t, fraction));
}

/* real_time: the 99 % quantile is in time, so that of ninety steps at most one
 * is late. */
static void print_method(int k, const struct measured m[])
{
    for (int i = 0; i < SIZES; i++) {
        const struct times *t = &m[i].t[k];
        if (t->runs == 0) continue;
        table_row(name[k], m[i].n, t->runs, ms(t, 0.5),
                  times_median(t) / times_median(&m[i].t[BEST]),
                  times_quantile(t, 0.99) <= 1.0 / 30.0 ? "yes" : "no",
                  (double)m[i].systems[k] / m[i].steps[k]);
    }
}

int main(void)
{
    static struct measured m[SIZES];
    int missed[METHODS] = {0};
    double before[2] = {0.0, 0.0}, order[2] = {0.0, 0.0};
    const double peak = machine_peak_gigaflop();
    study_machine();
    for (int i = 0; i < SIZES; i++) measure(8 * (i + 1), missed, &m[i]);
    table_begin("steps", "method n samples median_ms over_best real_time "
                "systems");
    for (int k = 0; k < METHODS; k++) print_method(k, m);
    table_end();
    table_begin_note("roofline", "n predicted_ms",
                     "%g flops per second; 250 for an element; LAPACK: %s",
                     1e9 * peak, MACHINE_LAPACK);
    for (int i = 0; i < SIZES; i++) {
        const double n2 = m[i].n * m[i].n, assembly = 5e-4 * n2 / peak;
        const double factor = 8e-6 * (n2 - 1) * n2 / peak;
        table_row(m[i].n, factor + m[i].read + assembly);
    }
    table_end();
    table_begin("accuracy", "n rms order max max_order readable_ms lapack_ms "
                "blocked_ms best_ms sparse_ms"); /* |u_n - u_2n| at t = 1 */
    for (int i = 0; 2 * i + 1 < SIZES; i = 2 * i + 1) {
        const int row = m[i].n + 1, fine = 2 * m[i].n + 1;
        const double *u = m[i].u, *v = m[2 * i + 1].u;
        double rms = 0.0, max = 0.0;
        for (int j = 0; j < row; j++)
            for (int k = 0; k < row; k++, u += 2) {
                const double *other = &v[4 * (j * fine + k)];
                const double d = hypot(u[0] - other[0], u[1] - other[1]);
                rms = hypot(rms, d / row);
                max = fmax(max, d);
            }
        order[0] = study_order(before[0], rms, 2.0);
        order[1] = study_order(before[1], max, 2.0);
        before[0] = rms;
        before[1] = max;
        const struct times *t = m[i].t;
        table_row(m[i].n, rms, cell_if(i > 0, order[0]), max,
                  cell_if(i > 0, order[1]), ms(t, 0.5), ms(t + 1, 0.5),
                  ms(t + 2, 0.5), ms(t + 3, 0.5), ms(t + 4, 0.5));
    }
    table_end();
    claim(fabs(order[0] - 1.6) < 0.1 && order[1] < 1.0,
          "twice the n does not give a quarter of the error");
    return table_finish();
}
