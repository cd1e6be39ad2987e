/*
 * tissue.c - a section through soft tissue, in which two hooks open a wound.
 *
 * 10 cm by 3 cm, held by bone below; a cut of 13 mm goes in from above.  A hook
 * on either side holds the skin in a circle, pulls it up and aside, and turns.
 * One material, the notes' under LOG: layers are depths.  Quasistatics, from
 * rest half way, and on, each time from the elastic lift.  Tables: pull (place
 * and turn of the left hook; its force on 1 cm of depth, and the other's, which
 * is the same but for the mesh; least J; linear systems), strip (what is
 * between two lines of the mesh).
 */
#include "motion/live.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* In cells: the cut is the column CUT above row DEEP. */
enum { WIDE = 201, HIGH = 60, CUT = 100, DEEP = 34, MUSCLE = 38, FAT = 54 };
enum { GRID = 2 }; /* a strip is 2 cells high */
static const char *const WHEN[] = {"rest", "half", "full"};
static const double SIZE = 0.5e-3; /* of a cell (m) */
/* A hook's centre at rest, off the middle and deep; its radius; how far it goes
 * (m); its turn (degrees). */
static const double OFF = 3.75e-3, UNDER = 1.5e-3, RADIUS = 2.05e-3;
static const double ASIDE = 18e-3, UP = 13e-3, TURN = 45.0;

/* Which hook holds vertex a: -1 the left, 1 the right, 0 none.  move := where
 * it takes a on the part s of its way. */
static int hook(const struct mesh *mesh, int a, double s, double move[2])
{
    const int side = mesh->X[2 * a] < 0.0 ? -1 : 1;
    const double r[2] = {mesh->X[2 * a] - side * OFF,
                         mesh->X[2 * a + 1] - 0.5 * HIGH * SIZE + UNDER};
    const double turn = -side * s * TURN * atan(1.0) / 45.0;
    if (hypot(r[0], r[1]) > RADIUS) return 0;
    move[0] = side * s * ASIDE + (cos(turn) - 1.0) * r[0] - sin(turn) * r[1];
    move[1] = s * UP + sin(turn) * r[0] + (cos(turn) - 1.0) * r[1];
    return side;
}

/* The row of table pull; returns |left force / right force - 1|. */
static double measure(int k, const struct body *body, const double u[], int n)
{
    double *q = allocate(2 * (size_t)body->mesh->n_vertex, sizeof *q), to[2];
    double F[3][2] = {{0.0}};
    if (body_force(body, u, q) != OK) die("no force");
    for (int a = 0; a < body->mesh->n_vertex; a++)
        for (int i = 0, side = hook(body->mesh, a, 0.0, to); i < 2; i++)
            F[side + 1][i] += 0.01 * q[2 * a + i];
    free(q);
    const double L = hypot(F[0][0], F[0][1]), R = hypot(F[2][0], F[2][1]);
    table_row(WHEN[k], -OFF - 0.5 * k * ASIDE,
              0.5 * HIGH * SIZE - UNDER + 0.5 * k * UP, 0.5 * k * TURN, F[0][0],
              F[0][1], L, R, body_min_J(body, u), n, body->n_equation);
    return fabs(L / R - 1.0);
}

/* The rows of table strip; at rest those at its ends are enough. */
static void print_strips(int k, const struct mesh *mesh, const double u[])
{
    for (int j = 0, strip = 0; j < HIGH; j += GRID) {
        const char *layer = j < MUSCLE ? "muscle" : j < FAT ? "fat" : "skin";
        for (int i = 0; i <= WIDE; i++) {
            double x[4];
            if (i % (CUT + 1) % (k == 0 ? CUT : GRID)) continue;
            strip += i == 0 || (i == CUT + 1 && j >= DEEP);
            for (int c = 0; c < 4; c++) {
                const int a = (j + c / 2 * GRID) * (WIDE + 1) + i;
                x[c] = mesh->X[2 * a + c % 2] + u[2 * a + c % 2];
            }
            table_row(WHEN[k], layer, strip, x[0], x[1], x[2], x[3]);
        }
    }
}

int main(void)
{
    struct mesh *mesh =
        mesh_rectangle(WIDE, HIGH, 0.5 * WIDE * SIZE, 0.5 * HIGH * SIZE);
    const int n = 2 * mesh->n_vertex;
    double *u = allocate(4 * (size_t)n, sizeof *u), *g = u + 3 * n, apart = 0.0;
    int *held = allocate((size_t)n, sizeof *held), left = 0;
    gsl_set_error_handler_off();
    for (int e = 0; e < mesh->n_triangle; e++)
        if (e / 2 % WIDE != CUT || e / 2 / WIDE < DEEP)
            memmove(&mesh->triangle[3 * left++], &mesh->triangle[3 * e],
                    3 * sizeof *mesh->triangle);
    mesh->n_triangle = left;
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = a <= WIDE || hook(mesh, a, 0.0, &g[2 * a]);
    struct body *body =
        body_alloc(mesh, material_notes(LOG), 0.0, LUMPED, held);
    const struct step_control newton = step_method("search");
    table_begin("pull", "when x y turn Fx Fy left right J systems unknowns");
    for (int k = 1; k <= 2; k++) {
        double *u0 = u + (k - 1) * n, *to = u + k * n;
        for (int a = 0; a < mesh->n_vertex; a++)
            hook(mesh, a, 0.5 * k, &g[2 * a]);
        if (live_lift(body, at_rest(NULL), u0, g, EXACT, to) != OK)
            die("no lift");
        const struct step_report report =
            step_solve(body, &newton, at_rest(NULL), to);
        claim(report.status == OK &&
                  step_certify(body, at_rest(NULL), to) == OK,
              "%s: no stable balance, %s", WHEN[k], status_name(report.status));
        apart = fmax(apart, measure(k, body, to, 1 + report.iterations));
    }
    table_end();
    table_begin("strip", "when layer strip x0 y0 x1 y1");
    for (int k = 0; k <= 2; k++) print_strips(k, mesh, u + k * n);
    table_end();
    body_free(body);
    mesh_free(mesh);
    free(held);
    free(u);
    claim(apart < 0.01, "both hooks pull alike, to 1 %% (%g)", apart);
    return table_finish();
}
