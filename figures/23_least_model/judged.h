/*
 * judged.h - the ladder of a scene, and what it accepts, beside the truth.
 */
#ifndef FIGURES_23_JUDGED_H
#define FIGURES_23_JUDGED_H

#include "choice/ladder.h"

enum { JUDGED_RUNGS = 14, JUDGED_WANTED = 3 };
extern const double judged_wanted[JUDGED_WANTED]; /* 10, 3 and 1 % */

struct judged_rung {
    double estimate, error;
    struct ladder_model model;
    int sure;
    const char *how[JUDGED_WANTED]; /* is it accepted, a word or "-" */
};

/* Scenes judged, those that some rung meets, those for which one was accepted;
 * of these errors beyond the tolerance, twice and three times it, scenes for
 * which a lower rung would have done, and those in which neither is so. */
enum judged_count {
    JUDGED, REACHED, ACCEPTED, ABOVE, TWICE, THRICE, LOWER, RIGHT, COUNTS
};
struct judged {
    int of[COUNTS];
};
void judged_add(struct judged *to, struct judged more);

/*
 * All rungs of the scene of `truth`, as far as each has an answer; how many.
 * The first that is enough for judged_wanted[t] adds to by[t], if the truth is
 * judged: its own estimate is at most half of that.
 */
int judged_climb(const struct ladder_state *truth,
                 struct judged_rung rung[JUDGED_RUNGS],
                 struct judged by[JUDGED_WANTED]);

#endif
