/*
 * solvers.c - which solver does a step need, and when does the answer change?
 *
 * K of system.h: factorisation and solve by the band, by dissection, by the
 * same in single precision, refined, by CHOLMOD in the same order and by
 * LAPACK's band, where there are any (rival.h); and steps of the stretch, after
 * the jolt of the start, also with factors kept across steps.  They take turns,
 * of ten steps in a row after one that finds the caches full of other numbers
 * and counts as cold; seconds of the processor.  A backward error above 1e-12
 * has no time.
 */
#include "exact.h"
#include "machine.h"
#include "rival.h"
#include "solved.h"
#include "../21_sparse_cholesky/refine.h"
#include "linear/sparse.h"
#include "../study/study.h"
#include "plane/system.h"
#include "base/table.h"

enum solver {
    BAND, DISSECTION, SINGLE, KEPT, KEPT_SINGLE, CHOLMOD_SAME, LAPACK_SAME,
    SOLVERS
};
static const struct {
    const char *name;
    int single; /* precision of the factors */
    int across; /* kept across steps */
} solver[] = {{"band", 0, 0},   {"dissection", 0, 0},
              {"single", 1, 0}, {"kept", 0, 1},
              {"kept_single", 1, 1}, {"cholmod", 0, 0}, {"lapack", 0, 0}};
static const int sizes[] = {8, 16, 24, 32, 40, 48, 56, 64, 96, 128, 256};
enum { SIZES = sizeof sizes / sizeof *sizes, N_64 = 7, START = 9 };
enum { ROUNDS = 3, IN_A_ROW = 10 };

struct measured {
    struct times factor, solve, step, cold;
};

/* Is there solver k?  Of LAPACK only OpenBLAS is quick enough for n > 64. */
static int takes_part(int k, int n)
{
    const int quick = strstr(MACHINE_LAPACK, "openblas") != NULL;
    if (k == CHOLMOD_SAME) return *MACHINE_CHOLMOD != '\0';
    return k != LAPACK_SAME ||
           (*MACHINE_LAPACK && n <= (quick ? 128 : 64));
}

/* K of solver k; NULL: it is ours. */
static struct rival *store(struct body *body, int k)
{
    body_store(body, k == BAND ? BANDED : SPARSE);
    return k < CHOLMOD_SAME ? NULL : rival_alloc(k == LAPACK_SAME, body);
}

/* A step as step.h makes it. */
static enum status one_step(struct scene *s, int across)
{
    struct step_control control = step_method("lift");
    control.chord = 1;
    if (!across) s->body->kept.usable = 0;
    return scene_step(s, &control).status;
}

static void measure_system(struct system *s, int k, struct measured *m)
{
    struct body *body = s->scene->body;
    double t[3];
    struct rival *c = rival_now = store(body, k);
    system_store(s, body->K->storage);
    if (k == SINGLE) matrix_keep_single(body->K, 1);
    struct csr *K = system_matrix(s, NULL);
    const size_t size = (size_t)K->n;
    double *x = allocate(size, sizeof *x), *b = allocate(size, sizeof *b);
    double *by_rows = allocate(size, sizeof *by_rows);
    int fine = 0;
    body_gather(body, s->b, x);
    for (int turn = k == BAND; turn < 2; turn++) { /* 0: memory is touched */
        t[0] = clock_processor();
        fine = matrix_factor(body->K) == OK;
    }
    t[1] = clock_processor();
    if (k == SINGLE) refine_solve(body->K, 1e-12, x, NULL);
    else matrix_solve(body->K, x);
    t[2] = clock_processor();
    for (int v = 0; v < s->n_vertex; v++)
        for (int i = 0; i < 2; i++)
            by_rows[2 * v + i] = x[body->equation[2 * s->vertex[v] + i]];
    system_right_side(s, NULL, b);
    const int valid = fine && solved_error(K, by_rows, b) <= 1e-12;
    times_record(&m->factor, t[1] - t[0], valid);
    times_record(&m->solve, t[2] - t[1], valid);
    rival_free(c);
    free(x);
    free(b);
    free(by_rows);
    csr_free(K);
}

static void measure(int n, struct measured m[SOLVERS])
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct scene *scene[SOLVERS] = {NULL};
    struct system *system = system_alloc(n);
    set.reach = 0.5;
    for (int turn = 0; turn < (n <= 64 ? 15 : n <= 128 ? 5 : 2); turn++)
        for (int k = 0; k < SOLVERS; k++)
            if ((k < KEPT || k >= CHOLMOD_SAME) && takes_part(k, n))
                measure_system(system, k, &m[k]);
    struct rival *c[SOLVERS] = {NULL};
    for (int k = 0; k < SOLVERS; k++) {
        if (!takes_part(k, n)) continue;
        scene[k] = scene_alloc(&set);
        for (int step = 0; step < START; step++)
            one_step(scene[k], solver[k].across);
        c[k] = store(scene[k]->body, k);
        if (!c[k] && !solver[k].single) exact_factors(scene[k]->body);
    }
    for (int turn = 0; turn < (n <= 128 ? ROUNDS : 1); turn++)
        for (int k = 0; k < SOLVERS; k++)
            for (int step = 0; takes_part(k, n) && step <= IN_A_ROW; step++) {
                const double before = clock_processor();
                rival_now = c[k];
                const enum status status =
                    one_step(scene[k], solver[k].across);
                times_record(step == 0 ? &m[k].cold : &m[k].step,
                             clock_processor() - before, status == OK);
            }
    for (int k = 0; k < SOLVERS; k++)
        for (int r = 0; takes_part(k, n) && r < scene[k]->n_dof; r++)
            if (!(fabs(scene[k]->u[r] - scene[0]->u[r]) <= 1e-9))
                m[k].step.second[0] = NAN; /* another answer has no time */
    for (int k = 0; k < SOLVERS; k++) {
        scene_free(scene[k]);
        rival_free(c[k]);
    }
    system_free(system);
}

static struct cell ms(const struct times *t)
{
    return cell_if(t->runs > 0, 1e3 * times_median(t));
}

/* How many times longer than dissection k takes for a step. */
static double gain(const struct measured m[SOLVERS], int k)
{
    return times_median(&m[k].step) / times_median(&m[DISSECTION].step);
}

/* From half of n to n. */
static double exponent(const struct times *n, const struct times *half)
{
    return study_order(times_median(n), times_median(half), 2.0);
}

int main(void)
{
    static struct measured m[SIZES][SOLVERS];
    int from = sizes[SIZES - 1];
    study_machine();
    for (int i = 0; i < SIZES; i++) measure(sizes[i], m[i]);
    table_begin_note("solvers", "solver n factor_ms solve_ms step_ms "
                     "over_dissection",
                     "CHOLMOD: %s; LAPACK: %s",
                     *MACHINE_CHOLMOD ? "yes" : "not found",
                     *MACHINE_LAPACK ? MACHINE_LAPACK : "not found");
    for (int k = 0; k < SOLVERS; k++)
        for (int i = 0; i < SIZES && m[i][k].step.runs > 0; i++) {
            const struct measured *now = &m[i][k];
            table_row(solver[k].name, sizes[i], ms(&now->factor),
                      ms(&now->solve), ms(&now->step), gain(m[i], k));
        }
    table_end();
    for (int i = SIZES; i-- > 0 && gain(m[i], BAND) > 1.0;) from = sizes[i];
    table_begin("crossover", "step_n chosen_n"); /* dissection is faster from */
    table_row(from, BODY_SPARSE_FROM);
    table_end();
    table_begin("growth", "solver to_128 to_256 cold_to_128 cold_to_256");
    const int at[] = {N_64, N_64 + 2, N_64 + 3}; /* 64, 128, 256 */
    for (int k = 0; k < SOLVERS && m[SIZES - 1][k].step.runs > 0; k++) {
        double order[4];
        for (int i = 0; i < 2; i++) {
            const struct measured *half = &m[at[i]][k], *n = &m[at[i + 1]][k];
            order[i] = exponent(&n->step, &half->step);
            order[2 + i] = exponent(&n->cold, &half->cold);
        }
        table_row(solver[k].name, order[0], order[1], order[2], order[3]);
    }
    table_end();
    return table_finish();
}
