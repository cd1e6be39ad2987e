/* lanes.c - laws of lanes.h: many triangles at once are as many single ones,
 * digit by digit.  The judges are triangles_one_by_one() of triangles.h and
 * material2_psi() of material.h. */
#include "plane/lanes.h"
#include "plane/scene.h"
#include "plane/triangles.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of triangles that leave every remainder by 8: 2 n rows. */
static const struct {
    int n, slender;
    double grade;
} meshes[] = {{1, 1, 1.0}, {3, 1, 1.0}, {3, 3, 1.0}, {4, 2, 1.0},
              {5, 1, 1.0}, {5, 5, 1.0}, {6, 1, 2.5}, {7, 1, 1.0},
              {7, 7, 1.0}, {8, 4, 1.0}};
static const enum reading readings[] = {SPIN, STRETCH, GRAVITY};

static struct scene *scene_of(int mesh, enum reading reading, enum law law)
{
    struct scene_setting set = scene_notes(reading, law, meshes[mesh].n);
    set.slender = meshes[mesh].slender;
    set.grade = meshes[mesh].grade;
    set.mass = mesh % 2 ? LUMPED : CONSISTENT;
    if (meshes[mesh].n == 1) set.reading = GRAVITY; /* not all are held */
    return scene_alloc(&set);
}

/* So much that some triangles have something to clamp, and J stays > 0. */
static void deform(struct scene *s, double reach)
{
    for (int r = 0; r < s->n_dof; r++) {
        s->u[r] = reach / s->set.n * sin(2.385 * r + s->set.n);
        s->v[r] = 0.1 * cos(1.7 * r);
    }
}

/* q and K by the program at hand, on top of what is there. */
static enum status assemble(const struct scene *s, int fast, int moving,
                            enum tangent tangent, double q[])
{
    const struct incremental Phi = {0.03, moving ? s->v : NULL, NULL};
    for (int r = 0; r < s->n_dof; r++) q[r] = 0.5 * r;
    matrix_zero(s->body->K);
    return (fast ? triangles_assemble : triangles_one_by_one)(
        s->body, Phi, s->u, tangent, q);
}

static void check_digits(const struct scene *s)
{
    const size_t n = (size_t)s->n_dof, size = s->body->K->size;
    double *q[2], *K = calloc(size, sizeof *K);
    for (int k = 0; k < 2; k++) q[k] = calloc(n, sizeof **q);
    for (int moving = 0; moving < 2; moving++)
        for (int t = NO_TANGENT; t <= PROJECTED; t++)
            for (int fast = 0; fast < 2; fast++) {
                ck_assert_int_eq(
                    assemble(s, fast, moving, (enum tangent)t, q[fast]), OK);
                if (!fast) memcpy(K, s->body->K->a, size * sizeof *K);
                if (!fast) continue;
                ck_assert(!memcmp(q[0], q[1], n * sizeof **q));
                ck_assert(!memcmp(K, s->body->K->a, size * sizeof *K));
            }
    for (int k = 0; k < 2; k++) free(q[k]);
    free(K);
}

static void forces_and_tangents_have_the_same_digits(void)
{
    for (int mesh = 0; mesh < COUNT(meshes); mesh++)
        for (int law = LOG; law <= STABLE; law++)
            for (int k = 0; k < COUNT(readings); k++)
                for (int sparse = 0; sparse < 2; sparse++) {
                    struct scene *s =
                        scene_of(mesh, readings[k], (enum law)law);
                    body_store(s->body, sparse ? SPARSE : BANDED);
                    deform(s, 0.1);
                    check_digits(s);
                    deform(s, 0.3);
                    check_digits(s);
                    scene_free(s);
                }
}

static void the_energy_has_the_same_digits(void)
{
    for (int mesh = 0; mesh < COUNT(meshes); mesh++)
        for (int law = LOG; law <= STABLE; law++)
            for (double reach = 0.01; reach < 9.0; reach *= 3.0) {
                struct scene *s = scene_of(mesh, SPIN, (enum law)law);
                double energy, sum = 0.0;
                deform(s, reach);
                /* the cubic law allows J < 0, where psi takes another way */
                if (law != LOG || body_min_J(s->body, s->u) > 0.0) {
                    ck_assert_int_eq(
                        triangles_energy(s->body, s->u, &energy), OK);
                    for (int e = 0; e < s->body->n_element; e++)
                        sum += s->body->area[e] *
                               material2_psi(&s->body->material,
                                             triangles_deformation(
                                                 s->body, s->u, e, 0));
                    ck_assert(!memcmp(&energy, &sum, sizeof sum));
                }
                scene_free(s);
            }
}

/* One bad triangle anywhere, and the same status. */
static void what_is_not_defined_is_said(void)
{
    int inverted = 0;
    for (int mesh = 1; mesh < COUNT(meshes); mesh++)
        for (int law = LOG; law <= CUBIC; law++) {
            struct scene *s = scene_of(mesh, SPIN, (enum law)law);
            double *q = calloc((size_t)s->n_dof, sizeof *q), energy;
            for (int r = 0; r < s->n_dof; r++)
                for (int nan = 0; nan < 2; nan++) {
                    deform(s, 0.01);
                    s->u[r] = nan ? (double)NAN : r % 3 ? 5.0 : -5.0;
                    const enum status judge = assemble(s, 0, 1, EXACT, q);
                    ck_assert(!nan || judge == NONFINITE);
                    ck_assert(nan || judge == (law == LOG ? judge : OK));
                    inverted += judge == INVERTED;
                    for (int t = NO_TANGENT; t <= PROJECTED; t++)
                        ck_assert_int_eq(
                            assemble(s, 1, 1, (enum tangent)t, q), judge);
                    ck_assert_int_eq(
                        triangles_energy(s->body, s->u, &energy), judge);
                }
            free(q);
            scene_free(s);
        }
    ck_assert_int_ge(inverted, 100);
}

UNIT_MAIN("lanes",
    LAW(forces_and_tangents_have_the_same_digits),
    LAW(the_energy_has_the_same_digits),
    LAW(what_is_not_defined_is_said))
