/*
 * walks.c - what does each Newton's method end in when the column is pressed?
 *
 * 80 x 8 squares, walked through rising loads, straight or pushed by 1e-3 while
 * it is straight.  Table: linear systems (400 at most), deflection of the
 * middle (0: below 1e-9 m), energy, elements with an eigenvalue < 0; SADDLE
 * is converged, and K there is not positive definite.  Beyond the bifurcation a
 * projected K bends a column that was not pushed by its round-off, and this
 * decides how many systems it takes (-).
 */
#include "material/modes.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static struct scene *column(int n)
{
    const struct scene_setting set = scene_column(CUBIC, n, 0.0);
    struct scene *s = scene_alloc(&set);
    body_store(s->body, PLAIN); /* near a bifurcation counts are chaotic */
    return s;
}

static int negative_elements(const struct scene *s)
{
    int count = 0;
    for (int t = 0; t < s->mesh->n_triangle; t++)
        count += modes_at(&s->body->material, body_deformation(
                              s->body, s->u, t)).value[MODE_TWIST] < 0.0;
    return count;
}

int main(void)
{
    const double load[] = {0.02, 0.034, 0.036, 0.04, 0.05};
    const char *const method[] = {"notes", "demand+search", "always+search"};
    double psi[6][5], out[6][5];
    enum status status[6][5];
    int elements[6][5];
    table_begin("walks",
                "method push load systems deflection energy elements status");
    for (int m = 0; m < 3; m++)
        for (int pushed = 0; pushed < 2; pushed++) {
            const int k = 2 * m + pushed;
            const double push = pushed ? 1e-3 : 0.0;
            struct scene *s = column(80);
            for (int l = 0; l < 5; l++) {
                const struct step_report r =
                    scene_walk(s, method[m], load[l], push);
                status[k][l] = r.status;
                psi[k][l] = scene_energy(s);
                out[k][l] = fabs(*scene_middle(s));
                elements[k][l] = negative_elements(s);
                const int round_off = m > 0 && !pushed && l > 1;
                table_row(method[m], push, load[l],
                          cell_if(!round_off, r.iterations),
                          out[k][l] > 1e-9 ? out[k][l] : 0.0, psi[k][l],
                          elements[k][l], status_name(r.status));
            }
            scene_free(s);
        }
    table_end();

    claim(elements[0][0] == 1280 && status[0][0] == OK,
          "at e = 0.02 all 1280 elements have a negative eigenvalue (%d), and "
          "the body is stable", elements[0][0]);
    for (int l = 2; l < 5; l++)
        claim(status[0][l] == SADDLE && status[1][l] == SADDLE &&
                  status[3][l] == OK && psi[3][l] < psi[0][l],
              "at e = %g the notes' method ends in a saddle, pushed or not; "
              "projected and pushed it is a minimum, of less energy", load[l]);
    claim(status[2][2] == SADDLE && status[4][2] == SADDLE,
          "projection does not leave a symmetric start at e = 0.036");
    claim(fabs(psi[0][2] - 0.2926138038403667) < 1e-11 &&
              fabs(psi[3][3] - 0.35422048584304616) < 1e-11 &&
              fabs(out[3][3] - 0.10107347482842402) < 1e-6 &&
              fabs(psi[3][4] - 0.5104410137736349) < 1e-11,
          "energies and deflections are those of another program");
    claim(status[3][1] == OK && status[5][1] == MAX_ITERATIONS,
          "just below the bifurcation always projecting has not arrived after "
          "400 systems");
    return table_finish();
}
