/*
 * 22_multigrid.c - what conjugate gradients and a V-cycle satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *   22a K: three_eigenvalues_take_three_iterations, residuals_are_orthogonal,
 *       curvature_decides_what_is_not_spd; its order: every_way_gives_the
 *       _increment_of_elimination; precondition, context, tolerance:
 *       the_unit_of_B_does_not_matter; cap: residuals_are_orthogonal, and just
 *       enough: three_eigenvalues_take_three_iterations; b, and what is no
 *       number: ends_are_named; report: residuals_are_orthogonal
 *   22b n, coarse, fine, down: transfer_agrees_with_the_fast_one
 *   22c m (grids, K), b: the_coarsest_grid_is_solved, cycle_agrees_with_the
 *       _fast_one; x, r: hold odd numbers before; g: by its own calls
 * The arrays of m are guarded; r, z, p, Kp of 22a lie one behind the other.
 */
#include "program.h"

#include "judge.h"

#include <stdio.h>

#define ROUND_OFF 1e-12 /* sums of some thousand products */

/* A smooth, irregular number in (-1, 1) for each r. */
static double odd_number(int r)
{
    return sin(2.385 * r + 0.613) * cos(0.3714 * r * r + 0.2385);
}

/* ---- 22a ----------------------------------------------------------------- */

enum { SIZE = 24 };

static struct csr *diagonal_matrix(int size, const double entry[])
{
    struct csr *D = csr_alloc(size, size);
    for (int i = 0; i < size; i++) {
        D->start[i + 1] = i + 1;
        D->index[i] = i;
        D->value[i] = entry[i];
    }
    return D;
}

/* Tridiagonal and positive definite, no two rows alike. */
static struct csr *chain_matrix(void)
{
    struct csr *A = csr_alloc(SIZE, 3 * SIZE);
    for (int i = 0, k = 0; i < SIZE; i++) {
        for (int j = i - 1; j <= i + 1; j++) {
            if (j < 0 || j >= SIZE) continue;
            A->index[k] = j;
            A->value[k++] = i == j ? 2.385 + odd_number(i)
                                   : -0.6 + 0.3 * odd_number(i + j + 100);
        }
        A->start[i + 1] = k;
    }
    return A;
}

/* Preconditioners: a number times r, and an uneven diagonal. */
static void times_number(const void *factor, const double r[], double z[])
{
    for (int i = 0; i < SIZE; i++) z[i] = *(const double *)factor * r[i];
}

static void uneven(const void *factor, const double r[], double z[])
{
    for (int i = 0; i < SIZE; i++)
        z[i] = *(const double *)factor * (1.2 + odd_number(i + 40)) * r[i];
}

static struct report *go(const struct csr *A, preconditioner *with,
                         double factor, double tolerance, int cap,
                         const double b[], double x[])
{
    struct report *out = allocate(1, sizeof *out);
    cg(A, with, &factor, tolerance, cap, b, x, out);
    return out;
}

/* Three eigenvalues: the error is a polynomial of degree 3 that vanishes. */
static void three_eigenvalues_take_three_iterations(void)
{
    double entry[SIZE], b[SIZE];
    for (int i = 0; i < SIZE; i++) {
        entry[i] = i % 3 == 0 ? 0.2385 : i % 3 == 1 ? 3.714 : 1.613;
        b[i] = odd_number(i);
    }
    struct csr *D = diagonal_matrix(SIZE, entry);
    double *x = guarded_alloc(SIZE);
    struct report *o = go(D, times_number, 1.0, 1e-10, 3, b, x);
    expect(o->status == OK && o->iterations == 3,
           "three eigenvalues, a cap of 3: got %s after %d iterations, want OK "
           "after 3",
           status_name(o->status), o->iterations);
    for (int i = 0; i < SIZE; i++)
        expect_close(x[i], b[i] / entry[i], 1e-9, 1.0, "x[%d]", i);
    free(o);
    csr_free(D);
}

/* The step from x to y was along p: p.Kp / p.p, whatever the length of p is. */
static double curvature_of(const struct csr *A, const double x[],
                           const double y[])
{
    double step[SIZE], product[SIZE], sum[2] = {0.0, 0.0};
    for (int i = 0; i < SIZE; i++) step[i] = y[i] - x[i];
    csr_multiply(A, step, product);
    for (int i = 0; i < SIZE; i++) {
        sum[0] += step[i] * product[i];
        sum[1] += step[i] * step[i];
    }
    return sum[0] / sum[1];
}

/* r_i.B r_j = 0: what defines the method, whatever its formulas are. */
static void residuals_are_orthogonal(void)
{
    enum { MANY = 6 };
    struct csr *A = chain_matrix();
    double b[SIZE], r[MANY][SIZE], z[MANY][SIZE], product[SIZE];
    double *last = NULL;
    const double factor = 2.385;
    for (int i = 0; i < SIZE; i++) b[i] = odd_number(i + 7);
    for (int k = 0; k < MANY; k++) {
        double *x = guarded_alloc(SIZE), size = 0.0, left = 0.0;
        struct report *o = go(A, uneven, factor, 1e-13, k, b, x);
        expect(o->status == MAX_ITERATIONS && o->iterations == k,
               "a cap of %d: got %s after %d iterations, want MAX_ITERATIONS "
               "after %d", k, status_name(o->status), o->iterations, k);
        csr_multiply(A, x, product);
        for (int i = 0; i < SIZE; i++) {
            r[k][i] = b[i] - product[i];
            left += r[k][i] * r[k][i];
            size += b[i] * b[i];
        }
        uneven(&factor, r[k], z[k]);
        expect_close(o->residual[k], sqrt(left / size), ROUND_OFF, 1.0,
                     "residual[%d], against |b - K x| / |b|", k);
        if (k > 0) /* differences of iterates, which have 1e-4 of their size */
            expect_close(o->curvature[k - 1], curvature_of(A, last, x), 1e-10,
                         1.0, "curvature[%d], against p.Kp / p.p of the step "
                         "that x has made", k - 1);
        last = x;
        for (int j = 0; j < k; j++) {
            double rz[3] = {0.0, 0.0, 0.0};
            for (int i = 0; i < SIZE; i++) {
                rz[0] += r[k][i] * z[j][i];
                rz[1] += r[k][i] * z[k][i];
                rz[2] += r[j][i] * z[j][i];
            }
            expect_close(rz[0] / sqrt(rz[1] * rz[2]), 0.0, 1e-9, 1.0,
                         "r.B r of iterates %d and %d, over their sizes", j, k);
        }
        free(o);
    }
    csr_free(A);
}

/* A number times B changes nothing; |B r| would. */
static void the_unit_of_B_does_not_matter(void)
{
    struct csr *A = chain_matrix();
    const double factor[] = {1.0, 0x1p-20, 0x1p20};
    double b[SIZE];
    int first = 0;
    for (int i = 0; i < SIZE; i++) b[i] = odd_number(i + 7);
    for (int k = 0; k < 3; k++) {
        double *x = guarded_alloc(SIZE);
        struct report *o = go(A, uneven, factor[k], 1e-6, 100, b, x);
        if (k == 0) first = o->iterations;
        expect(o->status == OK && o->iterations == first,
               "B times %g: got %s after %d iterations, want OK after %d",
               factor[k], status_name(o->status), o->iterations, first);
        const double left = csr_residual(A, x, b);
        expect(left <= 1.001e-6 && o->residual[first - 1] > 1e-6,
               "B times %g, tolerance 1e-6: |b - K x| / |b| is %.2e", factor[k],
               left);
        free(o);
    }
    csr_free(A);
}

static void curvature_decides_what_is_not_spd(void)
{
    const double entries[][3] = {
        {1.0, 2.385, -3.714}, {-1.0, -2.385, -3.714}, {0.0, 0.0, 2.385}};
    const double sides[][3] = {{3.714, 2.385, 1.0}, {1.0, 1.0, 1.0},
                               {2.385, 1.0, 0.0}};
    const double one = 1.0, minus = -1.0;
    for (int k = 0; k < 3; k++) {
        double entry[SIZE], b[SIZE], *x = guarded_alloc(SIZE);
        for (int i = 0; i < SIZE; i++) entry[i] = entries[k][i % 3];
        for (int i = 0; i < SIZE; i++) b[i] = sides[k][i % 3];
        struct csr *D = diagonal_matrix(SIZE, entry);
        struct report *o = go(D, times_number, one, 1e-10, 20, b, x);
        expect(o->status == NOT_SPD && o->curvature[o->iterations] <= 0.0,
               "eigenvalues %g, %g, %g: got %s, want NOT_SPD where p.Kp is not "
               "positive", entries[k][0], entries[k][1], entries[k][2],
               status_name(o->status));
        double *before = guarded_alloc(SIZE);
        free(go(D, times_number, one, 1e-10, o->iterations, b, before));
        for (int i = 0; i < SIZE; i++)
            expect_close(x[i], before[i], ROUND_OFF, 1.0, "eigenvalues %g, %g, "
                         "%g: x[%d] of iterate %d, the last one before p.Kp "
                         "was not positive", entries[k][0], entries[k][1],
                         entries[k][2], i, o->iterations);
        for (int j = 0; j < o->iterations; j++)
            expect(o->curvature[j] > 0.0 && o->curvature[j] <= 3.714,
                   "p.Kp / p.p is %g; it lies between the eigenvalues",
                   o->curvature[j]);
        csr_free(D);
        free(o);
    }
    struct csr *A = chain_matrix();
    double b[SIZE], *x = guarded_alloc(SIZE);
    for (int i = 0; i < SIZE; i++) b[i] = odd_number(i);
    struct report *o = go(A, times_number, minus, 1e-10, 20, b, x);
    expect(o->status == NOT_SPD, "r.B r < 0: got %s, want NOT_SPD",
           status_name(o->status));
    for (int i = 0; i < SIZE; i++)
        expect_close(x[i], 0.0, ROUND_OFF, 1.0, "r.B r < 0 at once, so that x "
                     "stays 0: x[%d]", i);
    free(o);
    csr_free(A);
    run_unsolved("--n 16 --squeeze 0.5 --with jacobi", "NOT_SPD");
    run_unsolved("--n 16 --squeeze 0.5", "NOT_SPD");
}

static void ends_are_named(void)
{
    struct csr *A = chain_matrix();
    double b[SIZE] = {0.0}, *x = guarded_alloc(SIZE);
    struct report *o = go(A, times_number, 1.0, 1e-10, 20, b, x);
    expect(o->status == OK && o->iterations == 0 && x[3] == 0.0,
           "b = 0: got %s and x[3] = %g after %d iterations, want OK and 0 "
           "after 0", status_name(o->status), x[3], o->iterations);
    free(o);
    b[3] = NAN;
    o = go(A, times_number, 1.0, 1e-10, 20, b, x);
    expect(o->status == NONFINITE, "b has a NaN: got %s, want NONFINITE",
           status_name(o->status));
    free(o);
    b[3] = 1.0;
    for (int k = 0; k < 2; k++) {
        const double value = A->value[7];
        if (k == 1) A->value[7] = NAN;
        o = go(A, times_number, k ? 1.0 : (double)NAN, 1e-10, 20, b, x);
        expect(o->status == NONFINITE, "%s has a NaN: got %s, want NONFINITE",
               k ? "K" : "B", status_name(o->status));
        A->value[7] = value;
        free(o);
    }
    csr_free(A);
    const struct output *out =
        run_unsolved("--n 12 --with jacobi --cap 5", "MAX_ITERATIONS");
    expect(row_count(out, "history") == 6, "5 iterations make 6 rows");
}

/* ---- 22b ----------------------------------------------------------------- */

static int unknowns_of(int n)
{
    return 2 * (n - 1) * (n + 1);
}

static double hat(double x)
{
    return fmax(0.0, 1.0 - fabs(x));
}

/* P times a unit vector: a product of two hats, added to what is there. */
static void a_coarse_vertex_is_a_product_of_hats(void)
{
    for (int n = 4; n <= 12; n += 4) {
        const int half = n / 2, size = unknowns_of(n);
        for (int V = 0; V < unknowns_of(half); V++) {
            const int I = V / 2 % (half - 1) + 1, J = V / 2 / (half - 1);
            double *unit = guarded_alloc(unknowns_of(half));
            double *fine = guarded_alloc(size);
            for (int r = 0; r < unknowns_of(half); r++) unit[r] = r == V;
            for (int r = 0; r < size; r++) fine[r] = odd_number(r);
            transfer(n, 0, unit, fine);
            for (int r = 0; r < size; r++) {
                const int i = r / 2 % (n - 1) + 1, j = r / 2 / (n - 1);
                const double want = r % 2 != V % 2 ? 0.0
                                    : hat(0.5 * i - I) * hat(0.5 * j - J);
                expect_close(fine[r] - odd_number(r), want, ROUND_OFF, 1.0,
                             "n = %d: what coarse vertex (%d, %d) adds at fine "
                             "vertex (%d, %d), component %d", n, I, J, i, j,
                             r % 2);
            }
        }
    }
}

static void down_is_the_transpose_of_up(void)
{
    for (int n = 4; n <= 20; n += 4) {
        const int many = unknowns_of(n), few = unknowns_of(n / 2);
        double *coarse = guarded_alloc(few), *sum = guarded_alloc(few);
        double *fine = guarded_alloc(many), *up = guarded_alloc(many);
        double products[2] = {0.0, 0.0};
        for (int r = 0; r < few; r++) coarse[r] = odd_number(r), sum[r] = 0.0;
        for (int r = 0; r < many; r++) fine[r] = odd_number(r + 71), up[r] = 0;
        transfer(n, 0, coarse, up);
        transfer(n, 1, sum, fine);
        for (int r = 0; r < few; r++) products[0] += sum[r] * coarse[r];
        for (int r = 0; r < many; r++) products[1] += up[r] * fine[r];
        expect_close(products[0], products[1], ROUND_OFF, 10.0,
                     "n = %d: (P^T f).c, against f.(P c)", n);
    }
}

static void transfer_agrees_with_the_fast_one(void)
{
    for (int n = 4; n <= 20; n += 2) {
        const int many = unknowns_of(n), few = unknowns_of(n / 2);
        double *c[2], *f[2];
        for (int k = 0; k < 2; k++) {
            c[k] = guarded_alloc(few);
            f[k] = guarded_alloc(many);
            for (int r = 0; r < few; r++) c[k][r] = odd_number(r);
            for (int r = 0; r < many; r++) f[k][r] = odd_number(r + 71);
        }
        transfer(n, 0, c[0], f[0]);
        multigrid_prolong(n, c[1], f[1]);
        for (int r = 0; r < many; r++)
            expect_close(f[0][r], f[1][r], ROUND_OFF, 1.0,
                         "n = %d: P c of unknown %d, against multigrid.h", n,
                         r);
        transfer(n, 1, c[0], f[0]);
        multigrid_restrict(n, f[1], c[1]);
        for (int r = 0; r < few; r++)
            expect_close(c[0][r], c[1][r], ROUND_OFF, 1.0,
                         "n = %d: P^T f of unknown %d, against multigrid.h", n,
                         r);
    }
}

/* ---- 22c ----------------------------------------------------------------- */

/* A system of n squares per side, its grids, and vectors r and z.  The arrays
 * of its grids are guarded; their own room waits until the end. */
struct bench {
    struct system *s;
    struct csr *A;
    struct multigrid *m;
    double *room[GRIDS][3];
    int size;
    double *r[2], *z[2];
};

static struct bench bench_make(int n)
{
    struct bench t = {.s = system_alloc(n)};
    t.A = system_matrix(t.s, NULL);
    t.m = multigrid_alloc(t.A, n);
    t.size = t.A->n;
    for (int k = 0; k < 2; k++) {
        t.r[k] = guarded_alloc(t.size);
        t.z[k] = guarded_alloc(t.size);
        for (int i = 0; i < t.size; i++) t.r[k][i] = odd_number(i + 1000 * k);
    }
    for (int g = 0; g < t.m->grids; g++) {
        const int size = t.m->K[g]->n;
        double **array[] = {&t.m->x[g], &t.m->b[g], &t.m->r[g]};
        for (int k = 0; k < 3; k++) { /* as an earlier cycle has left them */
            t.room[g][k] = *array[k];
            *array[k] = guarded_alloc(size);
            for (int i = 0; i < size; i++)
                (*array[k])[i] = odd_number(i + k * size);
        }
    }
    return t;
}

static void bench_end(struct bench t)
{
    for (int g = 0; g < t.m->grids; g++) {
        t.m->x[g] = t.room[g][0];
        t.m->b[g] = t.room[g][1];
        t.m->r[g] = t.room[g][2];
    }
    multigrid_free(t.m);
    csr_free(t.A);
    system_free(t.s);
}

static void the_coarsest_grid_is_solved(void)
{
    for (int n = 4; n <= 7; n++) {
        struct bench t = bench_make(n);
        v_cycle(t.m, t.r[0], t.z[0]);
        expect_close(csr_residual(t.A, t.z[0], t.r[0]), 0.0, ROUND_OFF, 1.0,
                     "n = %d is its own coarsest grid: residual of a V-cycle",
                     n);
        bench_end(t);
    }
}

static void the_cycle_is_symmetric(void)
{
    for (int n = 8; n <= 24; n += 8) {
        struct bench t = bench_make(n);
        double product[4] = {0.0, 0.0, 0.0, 0.0};
        for (int k = 0; k < 2; k++) v_cycle(t.m, t.r[k], t.z[k]);
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < t.size; i++)
                product[k] += t.r[k / 2][i] * t.z[k % 2][i];
        expect_close(product[1], product[2], ROUND_OFF, product[0],
                     "n = %d: r.B s, against s.B r", n);
        expect(product[0] > 0.0 && product[3] > 0.0,
               "n = %d: r.B r is not positive", n);
        bench_end(t);
    }
}

/* x := x + B (b - K x), again and again: what is left of the error in the norm
 * of K.  The solution leaves 0.21 to 0.25. */
static void a_cycle_leaves_a_quarter_of_the_error(void)
{
    for (int n = 8; n <= 32; n *= 2) {
        struct bench t = bench_make(n);
        double *e = t.r[0], before = 0.0, after = 0.0;
        for (int k = 0; k <= 8; k++) {
            csr_multiply(t.A, e, t.r[1]);
            before = after;
            after = 0.0;
            for (int i = 0; i < t.size; i++) after += e[i] * t.r[1][i];
            v_cycle(t.m, t.r[1], t.z[1]);
            for (int i = 0; i < t.size; i++) e[i] -= t.z[1][i];
        }
        const double left = sqrt(after / before);
        expect(left < 0.3, "n = %d, of the error a V-cycle leaves: got %.3f, "
               "want 0.25 or less (allowed 0.3)", n, left);
        bench_end(t);
    }
}

static void cycle_agrees_with_the_fast_one(void)
{
    for (int n = 8; n <= 32; n *= 2) {
        struct bench t = bench_make(n);
        double largest = 0.0;
        v_cycle(t.m, t.r[0], t.z[0]);
        multigrid_cycle(t.m, t.r[0], t.z[1]);
        for (int i = 0; i < t.size; i++)
            largest = fmax(largest, fabs(t.z[1][i]));
        for (int i = 0; i < t.size; i++)
            expect_close(t.z[0][i], t.z[1][i], ROUND_OFF, largest,
                         "n = %d: unknown %d after a V-cycle, against "
                         "multigrid.h", n, i);
        bench_end(t);
    }
}

static void iterations_do_not_depend_on_the_mesh(void)
{
    for (int n = 16; n <= 64; n *= 2)
        for (int fine = 0; fine < 2; fine++) {
            char options[64];
            snprintf(options, sizeof options, "--n %d --tolerance %s", n,
                     fine ? "1e-10" : "1e-4");
            struct output *o = run(options);
            const int took = row_count(o, "history") - 1;
            expect(took <= (fine ? 12 : 4), "%s: %d iterations; %d are enough",
                   options, took, fine ? 12 : 4);
        }
}

static void every_way_gives_the_increment_of_elimination(void)
{
    static const char *const with[] = {"jacobi", "incomplete", "multigrid"};
    for (int k = 0; k < 3; k++)
        for (int n = 8; n <= 24; n += 16) {
            char options[64];
            struct system *s = system_alloc(n);
            double *du = allocate((size_t)s->scene->n_dof, sizeof *du);
            snprintf(options, sizeof options, "--n %d --with %s --tolerance "
                     "1e-12", n, with[k]);
            struct output *o = run(options);
            for (int r = 0; r < s->scene->n_dof; r++) s->b[r] = -s->b[r];
            expect(body_increment(s->scene->body, s->scene->body->K, s->b,
                                  du) == OK, "the band is not SPD");
            double largest = 0.0;
            for (int r = 0; r < s->scene->n_dof; r++)
                largest = fmax(largest, fabs(du[r]));
            for (int v = 0; v < s->n_vertex; v++)
                for (int c = 0; c < 2; c++)
                    expect_close(cell(o, "vertices", c ? "y" : "x", v),
                                 du[2 * s->vertex[v] + c], 1e-9, largest,
                                 "%s: component %d of vertex %d, against the "
                                 "band", options, c, v);
            system_free(s);
            free(du);
        }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("");
    double coarser = 0.0;
    for (int g = 1; g < row_count(output, "grids"); g++)
        coarser += cell(output, "grids", "entries", g);
    measured("1a", cell(run("--n 96 --with jacobi"), "history", "k", -1));
    measured("1b", coarser / cell(output, "grids", "entries", 0));
}

static const struct claim claims[] = {
    {"three_eigenvalues_take_three_iterations",
     three_eigenvalues_take_three_iterations, "22a"},
    {"the_unit_of_B_does_not_matter", the_unit_of_B_does_not_matter, "22a"},
    {"residuals_are_orthogonal", residuals_are_orthogonal, "22a"},
    {"ends_are_named", ends_are_named, "22a"},
    {"a_coarse_vertex_is_a_product_of_hats",
     a_coarse_vertex_is_a_product_of_hats, "22b"},
    {"down_is_the_transpose_of_up", down_is_the_transpose_of_up, "22b"},
    {"transfer_agrees_with_the_fast_one", transfer_agrees_with_the_fast_one,
     "22b"},
    {"the_coarsest_grid_is_solved", the_coarsest_grid_is_solved, "22c"},
    {"the_cycle_is_symmetric", the_cycle_is_symmetric, "22c"},
    {"a_cycle_leaves_a_quarter_of_the_error",
     a_cycle_leaves_a_quarter_of_the_error, "22c"},
    {"cycle_agrees_with_the_fast_one", cycle_agrees_with_the_fast_one, "22c"},
    {"curvature_decides_what_is_not_spd", curvature_decides_what_is_not_spd,
     "22a"},
    {"iterations_do_not_depend_on_the_mesh",
     iterations_do_not_depend_on_the_mesh, "22c"},
    {"every_way_gives_the_increment_of_elimination",
     every_way_gives_the_increment_of_elimination, "22a"},
};

static const char *const runs[] = {
    "",
    "--n 4",
    "--n 12 --tolerance 1e-4",
    "--n 20 --with jacobi --tolerance 1e-4",
    "--n 20 --with incomplete --tolerance 1e-6",
    "--n 16 --squeeze 0.2",
    "--n 16 --squeeze 0.5",
    "--n 8 --squeeze 0.65 --with jacobi",
    "--n 12 --with jacobi --cap 5",
};

static const struct column_rule rules[] = {
    {"grids", "*", 0, "counts", 0},
    {"history", "k", 0, "a number", 0},
    {"history", "residual", 1e-6, "round-off grows from iteration to iteration",
     0},
    {"history", "curvature", NOT_COMPARED, "in the end it is round-off's", 0},
    {"vertices", "i", 0, "a number", 0},
    {"vertices", "j", 0, "a number", 0},
    {"vertices", "*", 1e-6, "the same", 0},
};

static const struct lesson lesson = {
    "22_multigrid", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "A sweep costs as much as a product with K, and all the coarser grids "
    "together less than half of the finest. So a V-cycle is worth about seven "
    "products, and its iterations do not care how large n is.",
    "Run with --squeeze 0.4 and --n 16, then --n 32. For which of them is K "
    "positive definite, and which preconditioner says so first?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
