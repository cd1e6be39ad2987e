/*
 * motion.c - the square in a hand that wants to break it.
 *
 * The script `hard`, n = 8, the cubic law, backward Euler.  Table: the
 * triangles after every third frame, their J, and where the pointer is.
 */
#include "motion/film.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <string.h>

int main(void)
{
    const struct live_setting set = {8, CUBIC, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* trouble is chaotic */
    struct pointers hard = pointers_hard();
    int lost = 0;
    gsl_set_error_handler_off();
    table_begin("motion", FILM);
    for (int k = 0; k < 240; k++) {
        const struct pointer *p = &hard.frame[k];
        double to[2];
        live_input(live, p);
        live_hand(live->hand, p, to);
        live_carry(live, to);
        lost += strcmp(live_frame(live, to).rung, "lost") == 0;
        film_frame(live, 3, k, p);
    }
    table_end();
    pointers_free(&hard);
    live_free(live);
    claim(lost == 0, "no frame is lost (%d)", lost);
    return table_finish();
}
