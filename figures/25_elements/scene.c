/*
 * scene.c - what is wrong with linear triangles near nu = 1/2?
 *
 * The square of lesson 12's study of locking at nu = 0.4999, by linear
 * triangles on a coarse and a fine mesh, and where it hangs: graded quadratic
 * triangles with n = 64.  Tables: the rows, the columns and the free sides of
 * each mesh with their displacement, each as one line that turns at its ends;
 * and how much of the sag is missing.
 */
#include "hang.h"

#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

static const char *const word[] = {"coarse", "fine", "limit"};
enum { BODIES = 3 };
struct body_drawn {
    const char *word;
    struct mesh *mesh;
    double *u;
};

/* To 1e-6 m: what is 0 but for round-off, which nu amplifies, is 0. */
static struct cell displacement(double u)
{
    return cell_rounded(4, 1e-6 * round(1e6 * u) + 0.0);
}

static void point(const struct body_drawn *b, const char *path, int i, int j)
{
    const int a = 2 * (j * (b->mesh->n + 1) + i);
    table_row(b->word, path, cell_rounded(6, b->mesh->X[a]),
              cell_rounded(6, b->mesh->X[a + 1]), displacement(b->u[a]),
              displacement(b->u[a + 1]));
}

/* There and back. */
static void lattice(const struct body_drawn *b)
{
    const int n = b->mesh->n;
    for (int line = 0; line <= n; line++)
        for (int k = 0; k <= n; k++)
            point(b, "rows", line % 2 ? n - k : k, line);
    for (int line = 0; line <= n; line++)
        for (int k = 0; k <= n; k++)
            point(b, "columns", line, line % 2 ? n - k : k);
}

static void sides(const struct body_drawn *b)
{
    const int n = b->mesh->n;
    for (int k = 0; k < n; k++) point(b, "sides", k, 0);
    for (int k = 0; k < n; k++) point(b, "sides", n, k);
    for (int k = n; k >= 0; k--) point(b, "sides", k, n);
}

int main(void)
{
    const double nu = 0.4999;
    struct body_drawn body[BODIES];
    const struct hang hang[BODIES] = {
        hang_whole(HANG_LINEAR, 8, 1.0, nu, &body[0].mesh, &body[0].u),
        hang_whole(HANG_LINEAR, 32, 1.0, nu, &body[1].mesh, &body[1].u),
        hang_whole(HANG_QUADRATIC, 64, 3.0, nu, &body[2].mesh, &body[2].u)};
    double missing[BODIES];
    table_begin("lines", "body path X Y u_x u_y");
    for (int b = 0; b < BODIES; b++) {
        body[b].word = word[b];
        if (b < BODIES - 1) lattice(&body[b]);
        sides(&body[b]);
        mesh_free(body[b].mesh);
        free(body[b].u);
    }
    table_end();
    table_begin("missing", "body sag missing");
    for (int b = 0; b < BODIES; b++) {
        missing[b] = 1.0 - hang[b].sag / hang[BODIES - 1].sag;
        table_row(word[b], cell_rounded(4, hang[b].sag),
                  cell_rounded(4, missing[b]));
    }
    table_end();
    claim(missing[0] < 0.4 && missing[1] > 0.85 * missing[0],
          "sixteen times as many triangles bring back less than 15 %% of what "
          "is missing (%g, %g)", missing[0], missing[1]);
    return table_finish();
}
