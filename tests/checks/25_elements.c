/*
 * 25_elements.c - what right elements satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *     25a      l, of_l        six places, inside and outside; a skew triangle
 *     25b      material       both laws, each with moduli of its own
 *     25b      of_l, area, u  a skew triangle; turned, sheared, inside out, one
 *                             point of it alone; a column that is pressed
 *     25c      degree, m, p, both   all; m = 0, below 1 and above
 *     25d      area           several
 */
#include "program.h"

#include "judge.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define ROUND_OFF 1e-12 /* sums of some ten products */
enum { COLUMN = 5 * 33 };  /* its vertices */

static double odd_number(int r)
{
    return sin(2.385 * r + 0.613) * cos(0.3714 * r * r + 0.2385);
}

/* Two skew triangles, 0 1 2 and 0 2 3, of different areas. */
static const double quad_corner[4][2] = {
    {0.1, -0.2}, {1.3, 0.15}, {1.1, 1.2}, {-0.3, 0.7}};

/* of_l of the triangle with these corners of the quadrangle; its area. */
static double hats_of(int b, int c, double of_l[6])
{
    const double *X[3] = {quad_corner[0], quad_corner[b], quad_corner[c]};
    const double twice = (X[1][0] - X[0][0]) * (X[2][1] - X[0][1]) -
                         (X[2][0] - X[0][0]) * (X[1][1] - X[0][1]);
    for (int a = 0; a < 3; a++) {
        const double *from = X[(a + 1) % 3], *to = X[(a + 2) % 3];
        of_l[2 * a] = (from[1] - to[1]) / twice;
        of_l[2 * a + 1] = (to[0] - from[0]) / twice;
    }
    return 0.5 * twice;
}

/* The six nodes of that triangle. */
static void places_of(int b, int c, double X[6][2])
{
    const double *corner[3] = {quad_corner[0], quad_corner[b], quad_corner[c]};
    for (int a = 0; a < 3; a++)
        for (int j = 0; j < 2; j++) {
            X[a][j] = corner[a][j];
            X[3 + a][j] =
                0.5 * (corner[(a + 1) % 3][j] + corner[(a + 2) % 3][j]);
        }
}

static void shapes_at(const double l[3], double N6[6], double gradient[12])
{
    double of_l[6];
    double *N_guarded = guarded_alloc(6), *g = guarded_alloc(12);
    hats_of(1, 2, of_l);
    shapes(guarded_copy(3, l), guarded_copy(6, of_l), N_guarded, g);
    memcpy(N6, N_guarded, 6 * sizeof *N6);
    memcpy(gradient, g, 12 * sizeof *gradient);
}

/* ---- 25a ----------------------------------------------------------------- */

static const double node_l[6][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                    {0.0, 0.0, 1.0}, {0.0, 0.5, 0.5},
                                    {0.5, 0.0, 0.5}, {0.5, 0.5, 0.0}};

static void functions_are_1_at_their_nodes(void)
{
    double N6[6], g[12];
    for (int b = 0; b < 6; b++) {
        shapes_at(node_l[b], N6, g);
        for (int a = 0; a < 6; a++)
            expect_close(N6[a], a == b, ROUND_OFF, 1.0,
                         "the function of node %d at node %d", a, b);
    }
}

static void functions_add_up_to_1(void)
{
    for (int k = 0; k < 12; k++) {
        const double l0 = odd_number(k), l1 = odd_number(k + 30);
        const double l[3] = {l0, l1, 1.0 - l0 - l1};
        double N6[6], g[12], sum = 0.0, slope[2] = {0.0, 0.0};
        shapes_at(l, N6, g);
        for (int a = 0; a < 6; a++) {
            sum += N6[a];
            for (int j = 0; j < 2; j++) slope[j] += g[2 * a + j];
        }
        expect_close(sum, 1.0, ROUND_OFF, 1.0, "the sum of the six functions");
        for (int j = 0; j < 2; j++)
            expect_close(slope[j], 0.0, ROUND_OFF, 10.0,
                         "the sum of the gradients, component %d", j);
    }
}

/* Central differences, exact for degree 2. */
static void gradients_are_slopes(void)
{
    const double l[3] = {0.2385, 0.3714, 0.3901}, d = 0.1;
    double of_l[6], N6[6], g[12], ahead[6], behind[6], unused[12];
    hats_of(1, 2, of_l);
    shapes_at(l, N6, g);
    for (int j = 0; j < 2; j++) {
        double on[3], back[3];
        for (int v = 0; v < 3; v++) {
            on[v] = l[v] + d * of_l[2 * v + j];
            back[v] = l[v] - d * of_l[2 * v + j];
        }
        shapes_at(on, ahead, unused);
        shapes_at(back, behind, unused);
        for (int a = 0; a < 6; a++)
            expect_close(g[2 * a + j], (ahead[a] - behind[a]) / (2.0 * d),
                         ROUND_OFF, 10.0, "dN_%d/dX_%d", a, j);
    }
}

/* ---- 25b ----------------------------------------------------------------- */

static const struct material laws[2] = {{LOG, 371.4, 238.5},
                                        {CUBIC, 238.5, 371.4}};
static double size_of(const struct material *m) { return m->mu + m->lambda; }

/* q and K (which may be NULL) of the triangle 0 b c at u. */
static enum status element_at(const struct material *m, int c, const double u[],
                              double q[12], double K[144])
{
    double of_l[6];
    double *q_guarded = guarded_alloc(12), *K_guarded = guarded_alloc(144);
    const double area = hats_of(c - 1, c, of_l);
    const enum status status = element(m, guarded_copy(6, of_l), area,
                                       guarded_copy(12, u), q_guarded,
                                       K_guarded);
    memcpy(q, q_guarded, 12 * sizeof *q);
    if (K) memcpy(K, K_guarded, 144 * sizeof *K);
    return status;
}

static void move(int c, mat2 F, double amount, double u[12])
{
    double X[6][2];
    places_of(c - 1, c, X);
    for (int a = 0; a < 6; a++)
        for (int i = 0; i < 2; i++)
            u[2 * a + i] = F.m[i][0] * X[a][0] + F.m[i][1] * X[a][1] -
                           X[a][i] + 0.3 + amount * odd_number(2 * a + i);
}

static const mat2 sheared = {{{1.1, 0.2385}, {-0.1371, 0.9}}};
static const mat2 mirror = {{{-1.0, 0.0}, {0.0, 1.0}}};

/* u linear: P is constant, and int grad N_a is a third of the hat's at a
 * corner, times the area, and -4/3 of the opposite hat's in a middle. */
static void affine_u_gives_the_forces_of_its_stress(void)
{
    for (int k = 0; k < 4; k++) {
        const struct material *m = &laws[k % 2];
        double of_l[6], u[12], q[12];
        const int c = 2 + k / 2;
        const double area = hats_of(c - 1, c, of_l);
        const mat2 P = material2_pk1(m, sheared);
        move(c, sheared, 0.0, u);
        expect(element_at(m, c, u, q, NULL) == OK, "element() is not OK");
        for (int a = 0; a < 6; a++)
            for (int i = 0; i < 2; i++) {
                const double *g = &of_l[2 * (a % 3)];
                const double force = area * (a < 3 ? 1.0 : -4.0) / 3.0 *
                                     (P.m[i][0] * g[0] + P.m[i][1] * g[1]);
                expect_close(q[2 * a + i], force, ROUND_OFF, size_of(m),
                             "u linear, force on node %d, component %d", a, i);
            }
    }
}

static void tangent_is_the_derivative(void)
{
    const double d = 1e-5;
    for (int c = 0; c < 3; c++) {
        const int k = c > 0;
        double u[12], q[12], K[144], ahead[12], behind[12], unused[144];
        move(2, c < 2 ? sheared : mirror, 0.05, u);
        expect(element_at(&laws[k], 2, u, q, K) == OK, "element() is not OK");
        for (int s = 0; s < 12; s++) {
            double v[12];
            memcpy(v, u, sizeof v);
            v[s] = u[s] + d;
            element_at(&laws[k], 2, v, ahead, unused);
            v[s] = u[s] - d;
            element_at(&laws[k], 2, v, behind, unused);
            for (int r = 0; r < 12; r++) /* d^2 and round-off over d: 1e-9 */
                expect_close(K[12 * r + s], (ahead[r] - behind[r]) / (2.0 * d),
                             1e-6, size_of(&laws[k]),
                             "K of row %d, column %d, and the change of q", r,
                             s);
        }
        for (int r = 0; r < 12; r++)
            for (int s = 0; s < r; s++)
                expect_close(K[12 * r + s], K[12 * s + r], ROUND_OFF,
                             size_of(&laws[k]), "K, row %d, column %d, and "
                             "the other way round", r, s);
    }
}

/* At rest: the energy of u of degree 1 and 2 over the triangle, by hand, is
 * 1/2 u.Ku; a rule of one point misses that of what is 0 in the middle. */
static void only_three_motions_cost_nothing(void)
{
    double u[12] = {0.0}, q[12], K[144], value[12];
    expect(element_at(&laws[1], 2, u, q, K) == OK, "element() is not OK");
    struct matrix *A = matrix_alloc(DENSE, 12, 0);
    for (int r = 0; r < 12; r++)
        for (int s = 0; s < 12; s++) A->a[12 * r + s] = K[12 * r + s];
    expect(matrix_eigenvalues(A, value) == OK, "K has no eigenvalues");
    for (int k = 0; k < 3; k++)
        expect_close(value[k], 0.0, ROUND_OFF, value[11],
                     "eigenvalue %d of K at rest, of a rigid motion", k);
    expect(value[3] > 1e-3 * value[11],
           "K at rest has more than three eigenvalues near 0: the fourth is %g "
           "of the largest. Which u costs nothing, and is no rigid motion?",
           value[3] / value[11]);
    matrix_free(A);
}

static void inverted_is_named(void)
{
    double u[12], q[12], of_l[6];
    move(2, mirror, 0.0, u);
    expect(element_at(&laws[0], 2, u, q, NULL) == INVERTED,
           "log law, inside out: the status is not INVERTED");
    expect(element_at(&laws[1], 2, u, q, NULL) == OK,
           "cubic law, inside out: it is defined there, and the status not OK");
    hats_of(1, 2, of_l);
    for (int k = 0; k < 3; k++) { /* J = 1 - 3 l_k, below 0 at one point */
        const double *of = &of_l[2 * k], size = of[0] * of[0] + of[1] * of[1];
        for (int r = 0; r < 12; r++)
            u[r] = -1.5 * node_l[r / 2][k] * node_l[r / 2][k] * of[r % 2] /
                   size;
        expect(element_at(&laws[0], 2, u, q, NULL) == INVERTED,
               "log law, J = -1 at point %d and 1/2 at the others: the status "
               "is not INVERTED", k);
    }
}

/* The straight state of the column between ends that have their places in u:
 * Newton's method, NOT_SPD where K is not positive definite on the way. */
static enum status straighten(const struct mesh *column, double u[])
{
    const struct material m = material_notes(LOG);
    for (int k = 0; k < 12; k++) {
        struct elements *s = elements_alloc(column, 2);
        enum status status = OK;
        double du[2 * COLUMN], largest = 0.0;
        for (int i = 0; i <= column->n; i++)
            s->held[i] = s->held[column->n_vertex - 1 - i] = 1;
        for (int e = 0; e < column->n * column->rows / 2 && !status; e++) {
            int node[6];
            double of_l[6], at[12], q[12], K[144];
            quadratic_nodes(column, e, node);
            const double area = mesh_gradients_of(column, node, of_l);
            for (int r = 0; r < 12; r++) at[r] = u[2 * node[r / 2] + r % 2];
            status = element(&m, of_l, area, at, q, K);
            elements_add(s, 6, node, K);
            for (int r = 0; r < 12; r++) s->f[2 * node[r / 2] + r % 2] -= q[r];
        }
        if (!status) status = elements_solve(s, du);
        elements_free(s);
        if (status) return status;
        for (int r = 0; r < 2 * COLUMN; r++) {
            u[r] += du[r];
            largest = fmax(largest, fabs(du[r]));
        }
        if (largest < 1e-8) return OK;
    }
    return MAX_ITERATIONS;
}

/* (-1/8, 1/8) x (-1, 1), log law, both ends e inwards: the straight state loses
 * its stability at e = 0.04969, by another program's graded triangles, n = 128.
 * Quadratic triangles with n = 16 are 0.8 % above that, linear ones 94 %. */
static void a_column_buckles_where_it_should(void)
{
    struct mesh *column = mesh_rectangle(4, 32, 0.125, 1.0);
    double u[2 * COLUMN] = {0.0}, trial[2 * COLUMN], e = 0.0, step = 0.01;
    enum status status = OK;
    while (step > 1e-5 && e < 0.1) {
        for (int a = 0; a < column->n_vertex; a++) { /* carried on evenly */
            trial[2 * a] = u[2 * a];
            trial[2 * a + 1] = u[2 * a + 1] - step * column->X[2 * a + 1];
        }
        status = straighten(column, trial);
        if (status == OK) {
            e += step;
            memcpy(u, trial, sizeof u);
        } else {
            step *= 0.5;
        }
    }
    mesh_free(column);
    expect_close(e, 0.04969, 0.015, 0.04969, "a column of 2 x 16 squares loses "
                 "its straight state (%s) when its ends are so far inwards",
                 status_name(status));
}

/* ---- 25d ----------------------------------------------------------------- */

static void loads_are_integrals(void)
{
    for (int k = 1; k <= 3; k++) {
        double *load = guarded_alloc(6), *mass = guarded_alloc(6);
        const double area = 0.2385 * k;
        shares(area, load, mass);
        for (int a = 0; a < 6; a++)
            expect_close(load[a], a < 3 ? 0.0 : area / 3.0, ROUND_OFF, area,
                         "load of node %d, the integral of its function", a);
    }
}

static void mass_is_scaled_and_positive(void)
{
    for (int k = 1; k <= 3; k++) {
        double *load = guarded_alloc(6), *mass = guarded_alloc(6), sum = 0.0;
        const double area = 0.2385 * k;
        shares(area, load, mass);
        for (int a = 0; a < 6; a++) {
            expect(mass[a] > 0.0, "the mass of node %d is %g: nothing can "
                   "move by M^-1 of that", a, mass[a]);
            sum += mass[a];
        }
        expect_close(sum, area, ROUND_OFF, area, "the sum of the six masses");
        for (int a = 0; a < 6; a++)
            expect_close(mass[a], area * (a < 3 ? 3.0 : 16.0) / 57.0,
                         ROUND_OFF, area, "mass of node %d", a);
    }
}

/* u of degree 2: K u balances the body force at the middle that the two
 * triangles share, -mu lap u - (lambda + mu) grad div u. */
static void quadratic_u_balances_its_body_force(void)
{
    const struct material *m = &laws[1];
    const double c[2][3] = {{0.7, -0.4, 0.3}, {0.2, 0.6, -0.5}};
    const double div[2] = {2.0 * c[0][0] + c[1][1], c[0][1] + 2.0 * c[1][2]};
    double force[2] = {0.0, 0.0}, balance[2] = {0.0, 0.0};
    for (int t = 2; t <= 3; t++) {
        double X[6][2], u[12], q[12], K[144], load[6], mass[6], of_l[6];
        const double rest[12] = {0.0}, area = hats_of(t - 1, t, of_l);
        const int shared = t == 2 ? 4 : 5; /* the middle of 0 and 2 */
        places_of(t - 1, t, X);
        for (int a = 0; a < 6; a++)
            for (int i = 0; i < 2; i++)
                u[2 * a + i] = c[i][0] * X[a][0] * X[a][0] +
                               c[i][1] * X[a][0] * X[a][1] +
                               c[i][2] * X[a][1] * X[a][1];
        expect(element_at(m, t, rest, q, K) == OK, "element() is not OK");
        shares(area, load, mass);
        for (int i = 0; i < 2; i++) {
            force[i] += load[shared] *
                        (-2.0 * m->mu * (c[i][0] + c[i][2]) -
                         (m->lambda + m->mu) * div[i]);
            for (int s = 0; s < 12; s++)
                balance[i] += K[12 * (2 * shared + i) + s] * u[s];
        }
    }
    for (int i = 0; i < 2; i++)
        expect_close(balance[i], force[i], ROUND_OFF, size_of(m),
                     "u of degree 2, force on the node that two triangles "
                     "share, component %d", i);
}

/* ---- 25c ----------------------------------------------------------------- */

static void lines_are_graded_towards_the_corners(void)
{
    for (int k = 0; k < 8; k++) {
        const int n = k % 2 ? 16 : 8, both = k / 4, degree = 1 + k / 2 % 2;
        const double m = 0.6 + 0.35 * k;
        double *x = guarded_alloc(n + 1);
        expect_close(lines(n, degree, 0.7, m, both, x), m, ROUND_OFF, 1.0,
                     "the exponent that lines() returns");
        for (int i = 0; i <= n; i += degree) {
            const double even = -1.0 + 2.0 * i / n, d = 1.0 - fabs(even);
            double want = even;
            if (d < 0.5 && (even < 0.0 || both))
                want = copysign(1.0 - 0.5 * pow(2.0 * d, m), even);
            expect_close(x[i], want, ROUND_OFF, 1.0,
                         "degree %d, m = %g, %s: line %d of %d", degree, m,
                         both ? "both ends graded" : "graded towards -1", i,
                         n);
        }
    }
}

static void middles_lie_in_the_middle(void)
{
    for (int both = 0; both < 2; both++) {
        double *x = guarded_alloc(13);
        lines(12, 2, 0.7, 2.5, both, x);
        for (int i = 1; i < 12; i += 2)
            expect_close(x[i], 0.5 * (x[i - 1] + x[i + 1]), ROUND_OFF, 1.0,
                         "line %d, between two ends of quadratic triangles", i);
    }
}

static void the_exponent_is_the_least_that_does(void)
{
    for (int k = 0; k < 4; k++) {
        const double p = 0.55 + 0.1 * k;
        double *x = guarded_alloc(9), *same = guarded_alloc(9);
        for (int degree = 1; degree <= 2; degree++) {
            const double m = lines(8, degree, p, 0.0, 1, x);
            expect_close(m, degree / p, ROUND_OFF, 1.0,
                         "m = 0, degree %d, p = %g: the least m with which "
                         "2 min(k, p m) = 2 k", degree, p);
            lines(8, degree, p, m, 1, same);
            for (int i = 0; i <= 8; i++)
                expect_close(x[i], same[i], ROUND_OFF, 1.0,
                             "line %d with m = 0, and with that m", i);
        }
    }
}

/* ---- the square ---------------------------------------------------------- */

static double sag_of(const char *options, int row)
{
    return cell(run(options), "sag", "sag", row);
}

/* The library's quadratic triangles on the same mesh. */
static void agrees_with_the_library(void)
{
    struct mesh *mesh = mesh_square(12);
    mesh_grade(mesh, 2.0, MESH_LEFT | MESH_BOTTOM | MESH_TOP);
    quadratic_straighten(mesh);
    int held[13 * 13];
    double f[2 * 13 * 13] = {0.0}, u[2 * 13 * 13] = {0.0}, q[2 * 13 * 13];
    for (int a = 0; a < 13 * 13; a++) held[a] = a % 13 == 0;
    struct body *body = body_alloc_of(
        QUADRATIC_TRIANGLE, mesh, material_make(CUBIC, 1000.0, 0.4), 0.0,
        CONSISTENT, held);
    quadratic_load(mesh, (const double[2]){0.0, -1.0}, f);
    expect(body_assemble(body, at_rest(f), u, EXACT, q) == OK &&
           body_increment(body, body->K, q, u) == OK, "the library fails");
    /* two ways to assemble one system: its condition is 1e4 */
    expect_close(sag_of("--n 12 --m 2 --nu 0.4", 1), u[2 * (6 * 13 + 12) + 1],
                 1e-9, 0.01, "sag, quadratic triangles, n = 12, m = 2");
    body_free(body);
    mesh_free(mesh);
}

/* The limits are those of another program's graded quadratic triangles, n = 80:
 * this sag (nu = 0.3). */
static const double LIMIT = 0.0111804;
static void the_orders_are_those_of_the_corner(void)
{
    static const struct {
        int row, degree;
        double m;
    } kind[] = {{0, 1, 1.0}, {0, 1, 1.5}, {1, 2, 1.0}, {1, 2, 1.5},
                {1, 2, 2.0}};
    for (int k = 0; k < COUNT(kind); k++) {
        const double order = 2.0 * fmin(kind[k].degree, 0.711 * kind[k].m);
        double lacks[2];
        for (int j = 0; j < 2; j++) {
            char options[60];
            snprintf(options, sizeof options, "--n %d --m %g", 32 << j,
                     kind[k].m);
            lacks[j] = 1.0 + sag_of(options, kind[k].row) / LIMIT;
        }
        /* at m = 2 six digits of the limit leave 0.02, the finite n 0.15 */
        expect_close(log2(lacks[0] / lacks[1]), order, 0.2, 1.0,
                     "order of the sag of %s triangles, m = %g",
                     kind_name[kind[k].row], kind[k].m);
    }
}

static void what_was_predicted(void)
{
    struct output *output = run("--nu 0.4999 --n 16 --m 0");
    measured("1", cell(output, "sag", "sag", 1) /
                      cell(output, "sag", "sag", 0));
    measured("2", cell(output, "shares", "mass", 5) /
                      cell(output, "shares", "mass", 0));
    /* against the limit: three meshes alone show 2.56 */
    const double coarse = 1.0 + sag_of("--m 2 --n 32", 1) / LIMIT;
    const double fine = 1.0 + sag_of("--m 2 --n 64", 1) / LIMIT;
    measured("3", log2(coarse / fine));
}

static const struct claim claims[] = {
    {"functions_are_1_at_their_nodes", functions_are_1_at_their_nodes, "25a"},
    {"functions_add_up_to_1", functions_add_up_to_1, "25a"},
    {"gradients_are_slopes", gradients_are_slopes, "25a"},
    {"affine_u_gives_the_forces_of_its_stress",
     affine_u_gives_the_forces_of_its_stress, "25b"},
    {"only_three_motions_cost_nothing", only_three_motions_cost_nothing,
     "25b"},
    {"inverted_is_named", inverted_is_named, "25b"},
    {"tangent_is_the_derivative", tangent_is_the_derivative, "25b"},
    {"lines_are_graded_towards_the_corners",
     lines_are_graded_towards_the_corners, "25c"},
    {"middles_lie_in_the_middle", middles_lie_in_the_middle, "25c"},
    {"the_exponent_is_the_least_that_does",
     the_exponent_is_the_least_that_does, "25c"},
    {"loads_are_integrals", loads_are_integrals, "25d"},
    {"mass_is_scaled_and_positive", mass_is_scaled_and_positive, "25d"},
    {"quadratic_u_balances_its_body_force",
     quadratic_u_balances_its_body_force, "25b"},
    {"a_column_buckles_where_it_should", a_column_buckles_where_it_should,
     "25b"},
    {"agrees_with_the_library", agrees_with_the_library, "25b"},
    {"the_orders_are_those_of_the_corner", the_orders_are_those_of_the_corner,
     "25c"},
};

static const char *const runs[] = {
    "", "--n 4", "--n 16 --m 0", "--n 32 --nu 0.4999 --m 2", "--n 20 --nu 0",
    "--n 9 --m 1.5 --nu 0.45",
};

static const struct column_rule rules[] = {
    {"sag", "element", 0, "a word", 0},
    {"sag", "m", 1e-12, "a quotient", 0},
    {"sag", "unknowns", 0, "a number", 0},
    {"sag", "sag", 1e-8, "the condition of K, near nu = 1/2 1e7, in eps", 0},
    {"axis", "*", 1e-8, "the same", 0},
    {"shares", "node", 0, "a number", 0},
    {"shares", "*", 1e-12, "a quotient", 0},
};

static const struct lesson lesson = {
    "25_elements", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "At nu = 0.4999 and n = 16 linear triangles lack a third of the sag, and "
    "quadratic triangles 3 per cent; a finer mesh hardly helps the linear "
    "ones.",
    "Run with --m 4 --n 16, then with --m 2. Is finer at the corner better?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
