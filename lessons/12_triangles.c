/*
 * 12_triangles.c - a square of rubber at rest: the force of a triangle, its
 * tangent, and Newton's method.
 *
 * Notes: Lecture 2, 3.3.2 to 3.3.4.
 *
 * Problem.  A body (-1, 1)^2 of Neo-Hookean material: some vertices are held,
 * u = g, and forces f act on the vertices.  Find the u at which no free vertex
 * is pulled: [eq:body-q] at rest, which is
 *
 *     q_a = sum_e area_e P(F_e) grad N_a - f_a = 0
 *
 *     6---7---8     vertex a rests at X_a; component i of its displacement is
 *     | / | / |     u[2a + i] [eq:flatten].  Triangle e has the vertices
 *     3---4---5     t = &mesh->triangle[3e], counter-clockwise; on it F, P and
 *     | / | / |     the gradients of its three shape functions are constant.
 *     0---1---2     The slots take any mesh, a strip as well
 *
 * Run       make lesson-12; make lesson-12 ARGS=-h lists its options
 * PREDICT 1 force that holds the left side, --scene gravity (N/m): ...
 * PREDICT 2 residual of the default scene after 0.23 and 1.8e-4 (N/m): ...
 * PREDICT 3 fraction of the error left by half the h, nu = 0.4999: ...
 * Plot: history k residual logy
 */
#include "plane/history.h"
#include "base/options.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

/* Given the vertices t of a triangle and dN_a/dX_k = g[2a + k], a = 0, 1, 2
 * [eq:shape-gradient], return F = I + sum_a u_a (x) grad N_a. */
static mat2 deformation(const int t[3], const double g[6], const double u[])
{
    mat2 F = mat2_identity();
    /* SLOT 12a(t, g, u, &F): given u, fill F; u_a begins at u[2 t[a]]. */
    todo("12a", t, g, u, &F);
    /* END 12a */
    return F;
}

/* Given u, return q_a = sum_e area_e P(F_e) grad N_a - f_a at all vertices.
 * INVERTED where the material is not defined; q is then incomplete. */
static enum status residual(const struct scene *s, const double u[], double q[])
{
    const struct mesh *mesh = s->mesh;
    const struct material *material = &s->body->material;
    /* SLOT 12b(s->f, mesh, material, u, q, deformation): given u, set q;
     * mesh_gradients(mesh, e, g) fills g, returns the area; ask
     * material_defined() and material2_pk1(). */
    todo("12b", s->f, mesh, material, u, q, deformation);
    /* END 12b */
    return OK;
}

/*
 * Given u, return K = dq/du, before anything is held: each triangle with the
 * vertices a and b adds to row 2a + i, column 2b + j, by dP_ik/dF_jm (3.3.3).
 * K is banded or dense; what it held is forgotten.
 * INVERTED as in residual().
 */
static enum status tangent(const struct scene *s, const double u[],
                           struct matrix *K)
{
    const struct mesh *mesh = s->mesh;
    const struct material *material = &s->body->material;
    /* SLOT 12c(mesh, material, u, K): given u, set K: for each i, j the 2x2
     * block dP_ik/dF_jm, rows k, columns m; material_r(), mat2_cofactor(),
     * matrix_zero(), matrix_add(). */
    todo("12c", mesh, material, u, K);
    /* END 12c */
    return OK;
}

/*
 * Given K and q of tangent() and residual(), return du: K du = -q, du = 0 at
 * held vertices [eq:newton] [eq:dirichlet-correction].  K may be overwritten.
 * NOT_SPD: K is not positive definite; du is meaningless.
 */
static enum status increment(const struct scene *s, struct matrix *K,
                             const double q[], double du[])
{
    enum status status = OK;
    int *row = allocate((size_t)s->n_dof, sizeof *row);
    double *zero = allocate((size_t)s->n_dof, sizeof *zero);
    /* SLOT 12d(s, K, q, du, row, zero, &status): given K and q, collect the
     * unknowns of held vertices, s->held[a], in row[]; then matrix_dirichlet()
     * with zero[] as values, matrix_factor() and matrix_solve(). */
    todo("12d", s, K, q, du, row, zero, &status);
    /* END 12d */
    free(row);
    free(zero);
    return status;
}

/*
 * Newton's method for q(u) = 0 at the free vertices [alg:body-newton], from a u
 * that has its values at the held ones to the solution, or to the last state
 * reached.  Done: max|q| <= tolerance (2 mu + lambda) over the free vertices,
 * and in the iteration before max|du| <= tolerance (m); so there is at least
 * one, even where q is 0 to begin with.  NONFINITE: q or du is not finite;
 * MAX_ITERATIONS: not done after cap linear systems.
 */
static struct history equilibrium(const struct scene *s, double tolerance,
                                  int cap, double u[])
{
    const double weight = material_modulus(&s->body->material);
    struct history report = {.status = MAX_ITERATIONS};
    struct matrix *K = matrix_alloc(BANDED, s->n_dof, 2 * s->mesh->n + 5);
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    double *du = allocate((size_t)s->n_dof, sizeof *du);

    /* SLOT 12e(s, tolerance, cap, weight, u, &report, K, q, du, residual,
     * tangent, increment): given the first u, iterate and fill report
     * (history.h); body_max_free() is the size of q and du.  New since 10e:
     * report keeps all sizes, and du is looked at before u takes it. */
    todo("12e", s, tolerance, cap, weight, u, &report, K, q, du, residual,
         tangent, increment);
    /* END 12e */
    matrix_free(K);
    free(q);
    free(du);
    return report;
}

/* q of a held vertex is the force that holds it; hold: all of the left side. */
static void print_solution(const struct scene *s, const double q[])
{
    const struct scene_measures m = scene_measure(s);
    double hold[2] = {0.0, 0.0};
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        if (s->mesh->X[2 * a] != -1.0) continue;
        hold[0] += q[2 * a];
        hold[1] += q[2 * a + 1];
    }
    history_nodes(s, "q", q);
    table_begin("result", "scene law elastic external min_J hold_x hold_y");
    table_row(scene_name(s->set.reading), material_law(s->set.law), m.elastic,
              m.external, m.min_J, hold[0], hold[1]);
    table_end();
}

int main(int argc, char *argv[])
{
    int scene = STRETCH, law = 1, lifted = 1;
    struct scene_setting set = scene_notes(STRETCH, CUBIC, 8);
    set.reach = 0.5;
    const struct option options[] = {
        {"scene", .choice = &scene, .choices = SCENES, .help = "see scene.h"},
        {"law", .choice = &law, .choices = "log cubic", .help = "r"},
        {"n", .integer = &set.n, .min = 2, .max = 60, .help = "n x n squares"},
        {"reach", .real = &set.reach, .min = -20, .max = 20, .unit = "m",
         .help = "amplitude of the moving ends"},
        {"force", .real = &set.force, .min = -1e4, .max = 1e4,
         .unit = "N/m^2 or N/m", .help = "of gravity, traction"},
        {"nu", .real = &set.nu, .min = 0, .max = 0.49, .help = "Poisson's"},
        {"start", .choice = &lifted, .choices = "rest lifted",
         .help = "are the moved ends carried into the body?"},
    };
    options_parse("12_triangles", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();

    set.reading = (enum reading)scene;
    set.law = law ? CUBIC : LOG;
    struct scene *s = scene_alloc(&set);
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    scene_hold(s, 1.0);
    step_boundary(s->body, s->g, lifted, s->u);
    const struct history report = equilibrium(s, 1e-10, HISTORY_CAP, s->u);
    history_table("history", &report);
    if (report.status != OK)
        die("Newton's method ends with %s after %d iterations",
            status_name(report.status), report.iterations);
    residual(s, s->u, q);
    print_solution(s, q);
    free(q);
    scene_free(s);
    return table_finish();
}
