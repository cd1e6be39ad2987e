/* judged.c - see judged.h. */
#include "judged.h"

#include "choice/climb.h"

#include <math.h>

const double judged_wanted[JUDGED_WANTED] = {0.1, 0.03, 0.01};

void judged_add(struct judged *to, struct judged more)
{
    for (int k = 0; k < COUNTS; k++) to->of[k] += more.of[k];
}

/* All rungs; how many, as far as each has an answer. */
static int climb(const struct ladder_state *truth,
                 struct judged_rung rung[JUDGED_RUNGS])
{
    const struct ladder_scene *scene = truth->scene;
    struct ladder_model model = ladder_first(scene);
    int n = 0;
    for (int more = 1; more && n < JUDGED_RUNGS;) {
        struct ladder_state *s = ladder_solve(scene, model);
        more = s->status == OK;
        if (more) {
            struct climb_rung r;
            const int sure = climb_judge(s, INFINITY, &r);
            rung[n++] = (struct judged_rung){.model = model,
                                             .how = {"-", "-", "-"},
                                             .error = ladder_error(s, truth),
                                             .estimate = r.estimate,
                                             .sure = sure};
            more = ladder_add(scene, r.add, &model);
        }
        ladder_free(s);
    }
    return n;
}

/* The first rung that is enough for judged_wanted[t], and how it does. */
static struct judged judge(struct judged_rung rung[], int n, int t)
{
    const double wanted = judged_wanted[t];
    struct judged c = {.of = {[JUDGED] = 1}};
    int k = 0;
    while (k < n && !(rung[k].sure && rung[k].estimate <= wanted)) k++;
    for (int i = 0; i < n; i++) {
        c.of[REACHED] |= rung[i].error <= wanted;
        c.of[LOWER] |= i < k && k < n && rung[i].error <= wanted;
    }
    if (k == n) return c;
    c.of[ACCEPTED] = 1;
    c.of[ABOVE] = rung[k].error > wanted;
    c.of[TWICE] = rung[k].error > 2.0 * wanted;
    c.of[THRICE] = rung[k].error > 3.0 * wanted;
    c.of[RIGHT] = !c.of[ABOVE] && !c.of[LOWER];
    rung[k].how[t] = c.of[TWICE]   ? "wrong"
                     : c.of[LOWER] ? "lower"
                     : c.of[ABOVE] ? "above"
                                   : "right";
    return c;
}

int judged_climb(const struct ladder_state *truth,
                 struct judged_rung rung[JUDGED_RUNGS],
                 struct judged by[JUDGED_WANTED])
{
    const int n = climb(truth, rung);
    struct climb_rung own;
    climb_judge(truth, 0.0, &own);
    for (int t = 0; t < JUDGED_WANTED; t++)
        if (own.estimate <= 0.5 * judged_wanted[t])
            judged_add(&by[t], judge(rung, n, t));
    return n;
}
