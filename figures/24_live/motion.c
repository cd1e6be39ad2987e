/*
 * motion.c - the square in a hand that wants to break it.
 *
 * The script `hard`, n = 8, the cubic law, backward Euler.  Table: the
 * triangles after every third frame, their J, and where the pointer is.
 */
#include "motion/live.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <string.h>

int main(void)
{
    const struct live_setting set = {8, CUBIC, BACKWARD_EULER, PATCH, ELASTIC,
                                     1};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* trouble is chaotic */
    struct pointers hard = pointers_hard();
    int lost = 0;
    gsl_set_error_handler_off();
    table_begin("motion", "k J x0 y0 x1 y1 x2 y2 pointer_x pointer_y down");
    for (int k = 0; k < 240; k++) {
        const struct pointer *p = &hard.frame[k];
        double to[2], x[6];
        live_input(live, p);
        live_hand(live->hand, p, to);
        live_carry(live, to);
        lost += strcmp(live_frame(live, to).rung, "lost") == 0;
        if (k % 3 != 0) continue;
        for (int e = 0; e < live->mesh->n_triangle; e++) {
            for (int a = 0; a < 3; a++)
                for (int i = 0; i < 2; i++) {
                    const int r = 2 * live->mesh->triangle[3 * e + a] + i;
                    x[2 * a + i] = live->mesh->X[r] + live->now.u[r];
                }
            table_row(k, mat2_det(body_deformation(live->body, live->now.u, e)),
                      x[0], x[1], x[2], x[3], x[4], x[5], p->x, p->y, p->down);
        }
    }
    table_end();
    pointers_free(&hard);
    live_free(live);
    claim(lost == 0, "no frame is lost (%d)", lost);
    return table_finish();
}
