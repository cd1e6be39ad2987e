/*
 * tissue.c - a section through soft tissue, in which two hooks open a wound.
 *
 * 10 cm by 3 cm, held by bone below; the knife of lesson 26 goes in from above,
 * 13 mm deep.  A hook on either side holds the skin in a circle, pulls it up
 * and aside, and turns.  One material, the notes' under LOG: layers are depths.
 * Quasistatics, from rest half way, and on, each time from the elastic lift.
 * Tables: pull (place and turn of the left hook; its force on 1 cm of depth,
 * and the other's, which is the same but for the mesh; least J; linear
 * systems), strip (what is between two lines of the mesh).
 */
#include "strip.h"

#include "motion/live.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

/* In cells: the cut goes down column CUT of the vertices to row DEEP. */
enum { WIDE = 200, HIGH = 60, CUT = 100, DEEP = 34, MUSCLE = 38, FAT = 54 };
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

/* The vertex of this column and row in the left half, or in the right one: they
 * differ on the cut.  It is that of a cell. */
static int corner(const struct mesh *mesh, int column, int row, int right)
{
    const int i = right ? column - (column == WIDE) : column - (column > 0);
    const int j = row - (row > 0);
    const int *t = &mesh->triangle[6 * (i * HIGH + HIGH - 1 - j)];
    return i < column ? (j < row ? t[5] : t[2]) : (j < row ? t[0] : t[1]);
}

/* The rows of table strip; at rest those at its ends are enough. */
static void print_strips(int k, const struct mesh *mesh, const double u[])
{
    for (int j = 0, strip = 0; j < HIGH; j += GRID) {
        const char *layer = j < MUSCLE ? "muscle" : j < FAT ? "fat" : "skin";
        for (int i = 0; i < 2 * (CUT + 1); i++) {
            const int right = i > CUT, column = i % (CUT + 1);
            const int shown =
                k == 0 ? column == 0 || column == CUT : column % GRID == 0;
            if (!shown) continue;
            strip += i == 0 || (i == CUT + 1 && j >= DEEP);
            const int at = right * CUT + column;
            const int low = 2 * corner(mesh, at, j, right);
            const int up = 2 * corner(mesh, at, j + GRID, right);
            table_row(WHEN[k], layer, strip, mesh->X[low] + u[low],
                      mesh->X[low + 1] + u[low + 1], mesh->X[up] + u[up],
                      mesh->X[up + 1] + u[up + 1]);
        }
    }
}

static struct tissue cut_section(void)
{
    const struct tissue section = tissue_alloc(
        tissue_section(WIDE, HIGH, WIDE * SIZE, HIGH * SIZE));
    for (int a = 0; a < section.mesh->n_vertex; a++)
        section.held[a] = a % (HIGH + 1) == HIGH; /* bone */
    const double top = 0.5 * HIGH * SIZE;
    const double blade[4] = {0.0, top, 0.0, DEEP * SIZE - top};
    const struct tissue s = strip_knife(&section, blade);
    tissue_free(section);
    return s;
}

int main(void)
{
    double *u[3], apart = 0.0;
    gsl_set_error_handler_off();
    const struct tissue s = cut_section();
    const struct mesh *mesh = s.mesh;
    const size_t n = 2 * (size_t)mesh->n_vertex;
    double *g = allocate(n, sizeof *g);
    for (int k = 0; k <= 2; k++) u[k] = allocate(n, sizeof *u[k]);
    for (int a = 0; a < mesh->n_vertex; a++)
        s.held[a] |= hook(mesh, a, 0.0, &g[2 * a]) != 0;
    struct body *body =
        body_alloc(mesh, material_notes(LOG), 0.0, LUMPED, s.held);
    struct step_control newton = step_method("search");
    newton.tolerance = 1e-8; /* m; far below it round-off decides */
    table_begin("pull", "when x y turn Fx Fy left right J systems unknowns");
    for (int k = 1; k <= 2; k++) {
        double *u0 = u[k - 1], *to = u[k];
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
    for (int k = 0; k <= 2; k++) print_strips(k, mesh, u[k]);
    table_end();
    body_free(body);
    tissue_free(s);
    for (int k = 0; k <= 2; k++) free(u[k]);
    free(g);
    claim(apart < 0.01, "both hooks pull alike, to 1 %% (%g)", apart);
    return table_finish();
}
