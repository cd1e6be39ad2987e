/*
 * 01_deformation.c - what F, J and the strain measures satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *     1a   X0, X1, x0, x1  collapsed_..., affine_bar_...: of either sign, both
 *                          senses, lengths of their own, slopes of both signs
 *     1a   size            collapsed_...: 1e-6, 1 and 1e6; affine_bar_...: 6.4
 *     1b   node            affine_map_...: five triangles; order_of_...: six
 *     1b   X, x            affine_map_..., J_is_..., common_mesh_...
 *     1c   F               rotation_is_..., rigid_motions_..., common_agrees
 */
#include "program.h"

#include "judge.h"

#include "../oracle/01_deformation.h"
#include "bar/bar.c"
#include "material/material.c"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A quotient or a 2x2 product of numbers of size 1 from edges of length 1. */
static const double ROUND_OFF = 1e-13;

static const mat2 A_ = {{{1.247, -0.613}, {0.385, 0.731}}}; /* J > 0 */
static const double shift[] = {-0.731, 2.385};

static void expect_tensor(mat2 got, const double want[4], double scale,
                          const char *what)
{
    for (int k = 0; k < 4; k++)
        expect_close(got.m[k / 2][k % 2], want[k], ROUND_OFF, scale,
                     "%s, entry %d%d", what, k / 2 + 1, k % 2 + 1);
}

/* x = F X + c at n points. */
static void move(int n, const double X[], mat2 F, double x[])
{
    for (int p = 0; p < n; p++)
        for (int i = 0; i < 2; i++)
            x[2 * p + i] = F.m[i][0] * X[2 * p] + F.m[i][1] * X[2 * p + 1] +
                           shift[i];
}

/* Twice the area of a triangle, negative when it runs clockwise. */
static double doubled_area(const double x[6])
{
    return (x[2] - x[0]) * (x[5] - x[1]) - (x[4] - x[0]) * (x[3] - x[1]);
}

static double max_difference(mat2 A, mat2 B)
{
    double largest = 0.0;
    for (int k = 0; k < 4; k++)
        largest = fmax(largest, fabs(A.m[k / 2][k % 2] - B.m[k / 2][k % 2]));
    return largest;
}

static void collapsed_element_has_F_zero(void)
{
    const double place = 0.613, near = place * (1.0 + 2.0 * DBL_EPSILON);
    double F = 7.0;
    int sign = bar_gradient(0.137, 0.385, place, place, 1.0, &F);
    expect_close(F, 0.0, ROUND_OFF, 1.0, "F of an element of length 0");
    expect(sign == 0, "both ends at one place: sign is %d, not 0", sign);

    sign = bar_gradient(0.25, 0.5, 0.0, 16.0 * DBL_EPSILON, 1.0, &F);
    expect(sign == 0, "x1 - x0 = 16 eps size, the limit: sign is %d, not 0",
           sign);
    for (int k = -1; k <= 1; k += 2) {
        sign = bar_gradient(0.137, 0.385, k < 0 ? near : place,
                            k < 0 ? place : near, 1.0, &F);
        expect(sign == 0,
               "ends apart by the last digit of %g only: sign is %d; what "
               "round-off can do is neither upright nor inverted",
               place, sign);
        sign = bar_gradient(0.137, 0.385, place, place + k * 1e-9, 1.0, &F);
        expect(sign == k, "x1 - x0 = %g is no round-off: sign is %d, not %d",
               k * 1e-9, sign, k);
    }
    /* the same bar in kilometres and in micrometres; the limit is 16 eps, and
     * a method may make 3 of them */
    for (double unit = 1e-6; unit < 1e7; unit *= 1e6) {
        for (int k = -1; k <= 1; k += 2) {
            const double gap = k * DBL_EPSILON * unit, x0 = 0.5 * unit;
            sign = bar_gradient(0.137 * unit, 0.385 * unit, x0,
                                x0 + 12.0 * gap, unit, &F);
            expect(sign == 0, "x1 - x0 = %g eps size in a bar of size %g: "
                   "sign is %d, not 0", k * 12.0, unit, sign);
            sign = bar_gradient(0.137 * unit, 0.385 * unit, x0,
                                x0 + 24.0 * gap, unit, &F);
            expect(sign == k, "x1 - x0 = %g eps size in a bar of size %g: "
                   "sign is %d, not %d", k * 24.0, unit, sign, k);
        }
        sign = bar_gradient(0.137 * unit, 0.385 * unit, place * unit,
                            0.612 * unit, unit, &F);
        expect(sign == -1, "sign is %d, not -1, in a bar of size %g", sign,
               unit);
        expect_close(F, -0.001 / 0.248, 1e-12, 1.0,
                     "F in a bar of size %g", unit);
    }
}

static void affine_bar_is_exact(void)
{
    const double X[] = {-0.731, 0.137, 0.385, 2.385}, slope[] = {
        1.0, 2.385, 0.137, -1.247};
    for (int k = 0; k < COUNT(slope); k++)
        for (int e = 0; e < 3; e++) {
            double F = 0.0, G = 0.0;
            const double x0 = slope[k] * X[e] + 0.613;
            const double x1 = slope[k] * X[e + 1] + 0.613;
            const int sign = bar_gradient(X[e], X[e + 1], x0, x1, 6.4, &F);
            expect_close(F, slope[k], ROUND_OFF, 3.0,
                         "F of element %d under x = %g X + 0.613", e,
                         slope[k]);
            expect(sign == (slope[k] > 0.0 ? 1 : -1),
                   "sign of an element with F = %g is %d", slope[k], sign);
            const int back = bar_gradient(X[e + 1], X[e], x1, x0, 6.4, &G);
            expect_close(G, slope[k], ROUND_OFF, 3.0,
                         "F of the element with its ends exchanged");
            expect(back == sign, "exchanging the ends of an element changes "
                                 "its sign from %d to %d", sign, back);
        }
}

static void sine_inverts_by_midpoints(void)
{
    for (int k = 0; k < COUNT(oracle_sine); k++) {
        const int n = oracle_sine[k].n;
        int inverted = 0, collapsed = 0;
        for (int e = 0; e < n; e++) {
            const double X0 = (double)e / n, X1 = (e + 1.0) / n;
            double F = 0.0, G = 0.0;
            const int sign =
                bar_gradient(X0, X1, sine(X0), sine(X1), 1.0, &F);
            inverted += sign < 0;
            collapsed += sign == 0;
            /* the secant is the slope at the midpoint times sin(pi h)/(pi h) */
            expect_close(F, 2.0 * n * sin(M_PI / n) *
                                cos(2.0 * M_PI * (e + 0.5) / n),
                         1e-12, 6.3, "F of element %d of sin 2 pi X", e + 1);
            bar_gradient(X0, X1, square(X0), square(X1), 1.0, &G);
            expect_close(G, X0 + X1, 1e-12, 2.0, "F of element %d of X^2",
                         e + 1);
        }
        expect(inverted == oracle_sine[k].inverted &&
                   collapsed == oracle_sine[k].collapsed,
               "sin 2 pi X on %d elements: %d inverted and %d collapsed, "
               "must be %d and %d",
               n, inverted, collapsed, oracle_sine[k].inverted,
               oracle_sine[k].collapsed);
    }
}

/* Five triangles round a vertex that is nowhere in particular. */
static void affine_map_on_a_distorted_mesh(void)
{
    const double X[] = {0.137, 0.242,  1.385, -0.371, 0.613, 1.714,
                        -1.1,  0.9385, -0.8,  -0.731, 0.4,   -1.247};
    const double inverting[] = {0.385, 0.731, 1.247, -0.613};
    double x[12], want[4];
    for (int k = 0; k < 3; k++) {
        mat2 A = k == 0 ? mat2_identity() : A_;
        for (int i = 0; i < 4 && k == 2; i++) A.m[i / 2][i % 2] = inverting[i];
        for (int i = 0; i < 4; i++) want[i] = A.m[i / 2][i % 2];
        move(6, X, A, x);
        for (int t = 1; t <= 5; t++) {
            const int node[] = {0, t, t % 5 + 1};
            mat2 F = {{{0.0, 0.0}, {0.0, 0.0}}};
            const double J = triangle_gradient(node, X, x, &F);
            expect_tensor(F, want, 10.0,
                          k == 0   ? "F of a translation"
                          : k == 1 ? "F of x = A X + c"
                                   : "F of x = A X + c, det A < 0");
            expect_close(J, mat2_det(A), ROUND_OFF, 10.0, "J of x = A X + c");
        }
    }
}

static void order_of_vertices_is_irrelevant(void)
{
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                    {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int k = 0; k < 6; k++) {
        mat2 F = {{{0.0, 0.0}, {0.0, 0.0}}};
        const double J = triangle_gradient(order[k], oracle_X, oracle_x, &F);
        expect_tensor(F, oracle_triangle_F, 10.0,
                      k < 3 ? "F, vertices anticlockwise"
                            : "F, vertices clockwise");
        expect_close(J, oracle_triangle_J, ROUND_OFF, 10.0,
                     k < 3 ? "J, vertices anticlockwise"
                           : "J, vertices clockwise");
    }
}

static void J_is_the_ratio_of_signed_areas(void)
{
    /* the third vertex goes through the opposite edge */
    double x[6];
    memcpy(x, oracle_x, sizeof x);
    const int node[] = {0, 1, 2};
    for (int k = 0; k <= 8; k++) {
        mat2 F = {{{0.0, 0.0}, {0.0, 0.0}}};
        for (int i = 0; i < 2; i++)
            x[4 + i] = oracle_x[4 + i] +
                       k / 4.0 * (0.5 * (x[i] + x[2 + i]) - oracle_x[4 + i]);
        const double J = triangle_gradient(node, oracle_X, x, &F);
        expect_close(J, doubled_area(x) / doubled_area(oracle_X), ROUND_OFF,
                     10.0, "J with the third vertex %d/4 of the way to the "
                     "opposite edge", k);
        expect_close(J, mat2_det(F), ROUND_OFF, 10.0, "J, against det F");
    }
}

/* J is a null Lagrangian: its integral knows the boundary only. */
static void held_boundary_keeps_the_sum_of_J(void)
{
    const char *const options[] = {"--m 8 --push 0", "--m 8 --push 0.5",
                                   "--m 8 --push 1.385"};
    for (int k = 0; k < COUNT(options); k++) {
        struct output *output = run(options[k]);
        const double s = cell(output, "square", "s", 0);
        const double min_J = cell(output, "square", "min_J", 0);
        const double all = cell(output, "square", "absolute_area", 0);
        const double inverted = cell(output, "square", "inverted", 0);
        expect_close(cell(output, "square", "signed_area", 0), 4.0, ROUND_OFF,
                     10.0, "sum of J times area at push %g, boundary held", s);
        /* a mean of J over an element of length 1/4 */
        expect_close(min_J, 1.0 - s * 8.0 / (3.0 * sqrt(3.0)), 0.1,
                     1.0 + fabs(s), "smallest J at push %g", s);
        expect((inverted > 0) == (s > 1.0),
               "%g inverted triangles at push %g with a smallest J of %g",
               inverted, s, min_J);
        expect(s > 1.0 ? all > 4.0 + 1e-6 : fabs(all - 4.0) < 1e-12,
               "sum of |J| times area is %.10g at push %g", all, s);
    }
}

static void rotation_is_no_strain_but_linear(void)
{
    for (int degrees = -143; degrees <= 180; degrees += 17) {
        const double angle = degrees * M_PI / 180.0;
        const mat2 R = mat2_rotation(angle);
        const double zero[4] = {0.0};
        const double shrink[4] = {cos(angle) - 1.0, 0.0, 0.0,
                                  cos(angle) - 1.0};
        mat2 linear, green, left;
        strains(R, &linear, &green, &left);
        expect_tensor(linear, shrink, 1.0, "linear strain of a rotation");
        expect_tensor(green, zero, 1.0, "Green strain of a rotation");
        expect_tensor(left, zero, 1.0, "left strain of a rotation");

        /* rotate after the deformation, and before it */
        mat2 green_A, left_A, turned, other;
        strains(A_, &linear, &green_A, &left_A);
        strains(mat2_multiply(R, A_), &linear, &green, &left);
        turned = mat2_multiply(mat2_multiply(R, left_A), mat2_transpose(R));
        expect_close(max_difference(green, green_A), 0.0, ROUND_OFF, 1.0,
                     "change of the Green strain under x -> R x");
        expect_close(max_difference(left, turned), 0.0, ROUND_OFF, 1.0,
                     "left strain of R F, against R (left strain of F) R^T");
        strains(mat2_multiply(A_, R), &linear, &other, &left);
        turned = mat2_multiply(mat2_multiply(mat2_transpose(R), green_A), R);
        expect_close(max_difference(other, turned), 0.0, ROUND_OFF, 1.0,
                     "Green strain of F R, against R^T (Green strain of F) R");
        expect_close(max_difference(left, left_A), 0.0, ROUND_OFF, 1.0,
                     "change of the left strain under X -> R X");
    }
}

/* Gradients of mesh.h: F = sum_a x_a (x) dN_a/dX [eq:shape-gradient]. */
static void common_mesh_agrees(void)
{
    struct mesh *mesh = mesh_square(3);
    double *x = allocate(2 * (size_t)mesh->n_vertex, sizeof *x);
    for (int a = 0; a < mesh->n_vertex; a++)
        push(1.385, mesh->X + 2 * a, x + 2 * a);
    for (int e = 0; e < mesh->n_triangle; e++) {
        const int *node = mesh->triangle + 3 * e;
        double gradient[6], want[4] = {0.0};
        mat2 F = {{{0.0, 0.0}, {0.0, 0.0}}};
        mesh_gradients(mesh, e, gradient);
        for (int k = 0; k < 12; k++)
            want[k % 4] += x[2 * node[k / 4] + k % 4 / 2] *
                           gradient[2 * (k / 4) + k % 2];
        triangle_gradient(node, mesh->X, x, &F);
        expect_tensor(F, want, 10.0, "F, against common/plane/mesh.c");
    }
    free(x);
    mesh_free(mesh);
}

static void common_agrees(void)
{
    mat2 linear, green, left;
    common_mesh_agrees();
    strains(A_, &linear, &green, &left);
    expect_tensor(linear, oracle_linear, 1.0, "linear strain");
    expect_tensor(green, oracle_green, 1.0, "Green strain");
    expect_tensor(left, oracle_left, 1.0, "left strain");

    /* the linear energy of lesson 02 from the linear strain of this one */
    const struct material law = material_make(LINEAR, 2.385, 0.371);
    const double trace = mat2_trace(linear);
    expect_close(law.mu * mat2_dot(linear, linear) +
                     0.5 * law.lambda * trace * trace,
                 material2_psi(&law, A_), ROUND_OFF, 1.0,
                 "linear energy, against common/material/material.c");

    /* the log law where X^2 has F = 2 X near 0, at X = 0.1, 0.01, 0.001 */
    const struct material log_law = material_notes(LOG);
    for (int k = 0; k < COUNT(oracle_log_stress); k++) {
        const double X0 = 0.0, X1 = 2.0 * pow(10.0, -k - 1);
        double F = 0.0;
        bar_gradient(X0, X1, square(X0), square(X1), 1.0, &F);
        expect_close(material1_pk1(&log_law, F), oracle_log_stress[k],
                     ROUND_OFF, -10.0 * oracle_log_stress[k],
                     "log stress of X^2 at X = %g", X1 / 2.0);
    }

    /* the bar's energy from F, against common/bar/bar.c */
    const double u[] = {0.0, 0.137, -0.242, 0.0385}, b[4] = {0.0};
    const struct bar bar = {3, 0.371, {1, 1}, b, law};
    double energy, sum = 0.0;
    expect(bar_energy(&bar, u, &energy) == OK, "bar_energy failed");
    for (int e = 0; e < 3; e++) {
        const double X0 = e * bar.h, X1 = (e + 1) * bar.h;
        double F = 0.0;
        bar_gradient(X0, X1, X0 + u[e], X1 + u[e + 1], 2.0, &F);
        sum += bar.h * material1_psi(&law, F);
    }
    expect_close(sum, energy, ROUND_OFF, 10.0,
                 "energy of a bar from your F, against common/bar/bar.c");
}

/* What the notes say about rigid motions: F = I, F = W skew, du/dX = W, F = 0,
 * and the rotation by the size of W; all the tensors are multiples of I. */
static void rigid_motions_give_the_oracles_numbers(void)
{
    const double w = M_PI / 6.0;
    const mat2 I = mat2_identity(), W = {{{0.0, -w}, {w, 0.0}}};
    const mat2 F[] = {I, W, mat2_add(I, W), mat2_scale(0.0, I),
                      mat2_rotation(w)};
    const double want[5][3] = {{0, 0, 0},
                               {-1, 0.5 * (w * w - 1), 0.5 * (w * w - 1)},
                               {0, 0.5 * w * w, 0.5 * w * w},
                               {-1, -0.5, -0.5},
                               {oracle_strain_30, 0, 0}};
    const double stress[5] = {0, oracle_stress_collapsed, 0,
                              oracle_stress_collapsed, oracle_stress_30};
    const double energy[5] = {0, -oracle_stress_collapsed, 0,
                              -oracle_stress_collapsed, oracle_energy_30};
    const struct material law = material_notes(LINEAR);
    mat2 strain[3];
    for (int k = 0; k < 5; k++) {
        strains(F[k], &strain[0], &strain[1], &strain[2]);
        for (int q = 0; q < 3; q++)
            expect_close(strain[q].m[0][0], want[k][q], ROUND_OFF, 10.0,
                         "%s strain of rigid motion %d",
                         q == 0 ? "linear" : q == 1 ? "Green" : "left", k);
        expect_close(2.0 * law.mu * strain[0].m[0][0] +
                         law.lambda * mat2_trace(strain[0]),
                     stress[k], ROUND_OFF, 1e4,
                     "linear stress of rigid motion %d", k);
        expect_close(material2_psi(&law, F[k]), energy[k], ROUND_OFF, 1e4,
                     "linear energy of rigid motion %d", k);
    }
    for (int k = 0; k < COUNT(oracle_rotation); k++) {
        strains(mat2_rotation(oracle_rotation[k].degrees * M_PI / 180.0),
                &strain[0], &strain[1], &strain[2]);
        expect_close(strain[0].m[0][0], -oracle_rotation[k].level, ROUND_OFF,
                     1.0, "linear strain of a rotation by %g degrees",
                     oracle_rotation[k].degrees);
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *bar = run(""), *turned = run("--stretch 1 --angle 30");
    int inverted = 0;
    for (int e = 0; e < row_count(bar, "bar"); e++)
        inverted += strcmp(word(bar, "bar", "sign", e), "inverted") == 0;
    measured("1", inverted);
    measured("2", cell(turned, "strains", "e11", 0));
    measured("3", cell(bar, "square", "signed_area", 0));
}

static const struct claim claims[] = {
    {"collapsed_element_has_F_zero", collapsed_element_has_F_zero, "1a"},
    {"affine_bar_is_exact", affine_bar_is_exact, "1a"},
    {"affine_map_on_a_distorted_mesh", affine_map_on_a_distorted_mesh, "1b"},
    {"order_of_vertices_is_irrelevant", order_of_vertices_is_irrelevant, "1b"},
    {"J_is_the_ratio_of_signed_areas", J_is_the_ratio_of_signed_areas, "1b"},
    {"rotation_is_no_strain_but_linear", rotation_is_no_strain_but_linear,
     "1c"},
    {"common_agrees", common_agrees, "1c"},
    {"sine_inverts_by_midpoints", sine_inverts_by_midpoints, "1a"},
    {"held_boundary_keeps_the_sum_of_J", held_boundary_keeps_the_sum_of_J,
     "1b"},
    {"rigid_motions_give_the_oracles_numbers",
     rigid_motions_give_the_oracles_numbers, "1c"},
};

static const char *const runs[] = {
    "",
    "--n 6 --m 5 --push -0.731 --angle -77 --stretch 0.6",
    "--map square --n 9 --left -0.371 --m 3 --push 2.385 --angle 143",
    "--n 1 --m 1 --stretch 2.385",
    "--n 40 --left -1 --m 2 --push 0.613",
};

#define GRADIENT "a quotient of differences of coordinates of size 1"
#define TENSOR "a product of two 2x2 matrices; strains of size 1"
static const struct column_rule rules[] = {
    {"bar", "*", 1e-12, GRADIENT, 1.0},
    {"triangles", "e", 0, "a count", 0},
    {"triangles", "*", 1e-12, GRADIENT, 1.0},
    {"square", "inverted", 0, "a count", 0},
    {"square", "*", 1e-12, GRADIENT, 1.0},
    {"strains", "*", 1e-12, TENSOR, 1.0},
};

static const struct lesson lesson = {
    "01_deformation", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "A mesh of 10 elements collapses two elements of sin 2 pi X, one of 8 "
    "collapses none: what a mesh sees of phi' is its value at the midpoints "
    "(table `bar`). And sum J A of the pushed square is 4 to round-off, "
    "inverted or not (table `square`).",
    "A strip bent by 270 degrees (figures/01_deformation/meshes.svg): J is "
    "above 0.52 everywhere, yet a fifth of the strip shares its place. Which "
    "test on single elements could find that out?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
