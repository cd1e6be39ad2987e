/*
 * motion.c - the square in a hand that wants to break it.
 *
 * The script `hard`, n = 8, the cubic law, backward Euler.  Tables: the
 * triangles after every third frame, their J, and where the pointer is; the
 * vertices in the hand then; and the rungs by which all frames went.
 */
#include "motion/film.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <string.h>

enum { FRAMES = 240, EVERY = 3, N_VERTEX = 81 };

/* The vertices that the hand has, in their places. */
static int in_hand(const struct live *live, double x[N_VERTEX][2])
{
    int n = 0;
    for (int a = 0; a < N_VERTEX && live->holding; a++) {
        const double *X = &live->mesh->X[2 * a];
        if (live->body->equation[2 * a] >= 0 || X[0] == -1.0) continue;
        for (int i = 0; i < 2; i++) x[n][i] = X[i] + live->now.u[2 * a + i];
        n++;
    }
    return n;
}

int main(void)
{
    const struct live_setting set = {8, CUBIC, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* trouble is chaotic */
    struct pointers hard = pointers_hard();
    static double place[FRAMES / EVERY][N_VERTEX][2];
    int n_held[FRAMES / EVERY], drawn = 0, lost = 0, downhill = 0;
    const char *rung[FRAMES];
    gsl_set_error_handler_off();
    table_begin("motion", FILM);
    for (int k = 0; k < FRAMES; k++) {
        const struct pointer *p = &hard.frame[k];
        double to[2];
        live_input(live, p);
        live_hand(live->hand, p, to);
        live_carry(live, to);
        rung[k] = live_frame(live, to).rung;
        lost += strcmp(rung[k], "lost") == 0;
        downhill += strcmp(rung[k], "downhill") == 0;
        film_frame(live, EVERY, k, p);
        if (k == EVERY * drawn) {
            n_held[drawn] = in_hand(live, place[drawn]);
            drawn++;
        }
    }
    table_end();
    table_begin("hand", "k x y");
    for (int f = 0; f < FRAMES / EVERY; f++)
        for (int i = 0; i < n_held[f]; i++)
            table_row(EVERY * f, place[f][i][0], place[f][i][1]);
    table_end();
    table_begin("rungs", "k rung");
    for (int k = 0; k < FRAMES; k++) table_row(k, rung[k]);
    table_end();
    pointers_free(&hard);
    live_free(live);
    claim(lost == 0, "no frame is lost (%d)", lost);
    claim(downhill > 20, "the second rung is needed (%d times)", downhill);
    return table_finish();
}
