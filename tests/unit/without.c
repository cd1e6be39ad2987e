/* without.c - laws of figures/24_live/without.h. */
#include "figures/24_live/without.h"

#include "unit.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

static struct without_result play(enum without without, enum law law,
                                  enum method method, struct pointers script)
{
    gsl_set_error_handler_off();
    const struct without_result result =
        without_play(without, 8, law, method, &script);
    pointers_free(&script);
    return result;
}

static struct without_result hard(enum without without, enum law law)
{
    return play(without, law, BACKWARD_EULER, pointers_hard());
}

static int same(struct without_result a, struct without_result b)
{
    return a.lost == b.lost && a.stands == b.stands &&
           a.unfinished == b.unfinished && a.most == b.most &&
           a.energy == b.energy && a.speed == b.speed && a.last == b.last;
}

/* With nothing taken away it is live_frame(), bit for bit; and without what it
 * does not need, as halved moves under the cubic law. */
static void nothing_is_the_ladder_of_live(void)
{
    const struct without_result all = hard(NOTHING, CUBIC);
    const struct live_setting set = {8, CUBIC, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN);
    struct pointers script = pointers_hard();
    struct without_result due = {0};
    for (int k = 0; k < script.n; k++) {
        double to[2];
        live_input(live, &script.frame[k]);
        live_hand(live->hand, &script.frame[k], to);
        live_carry(live, to);
        const struct live_report report = live_frame(live, to);
        due.most = fmax(due.most, report.systems);
        due.unfinished += report.status != OK;
        due.energy = fmax(due.energy, live_energy(live));
        due.last = 0.0;
        for (int r = 0; r < live->n_dof; r++) {
            due.speed = fmax(due.speed, fabs(live->now.v[r]));
            due.last = fmax(due.last, fabs(live->now.u[r]));
        }
    }
    pointers_free(&script);
    live_free(live);
    ck_assert(same(all, due) && all.freeze == 0);
    ck_assert(all.p50 <= all.p99 && all.p99 <= all.most);
    ck_assert(same(hard(HALVING, CUBIC), all));
}

/* What is missing is seen. */
static void a_rung_is_missed(void)
{
    const struct without_result cubic = hard(NOTHING, CUBIC);
    const struct without_result log = hard(NOTHING, LOG);
    struct without_result less = hard(SECOND_RUNG, LOG);
    ck_assert(less.lost >= 40 && less.freeze == less.lost);
    less = hard(ACCEPTING, LOG);
    ck_assert(less.lost > log.unfinished && log.unfinished > 0);
    ck_assert_int_eq(less.unfinished, 0);
    ck_assert(less.freeze > 1 && less.freeze < less.lost);
    less = hard(HALVING, LOG);
    ck_assert(less.energy < 3e3 && log.energy > 5e3);
    ck_assert(less.stands > log.stands && log.stands > 0);
    static const enum without halved[] = {PROJECTION, SEARCH, LEAPING};
    for (int k = 0; k < 3; k++) /* these halve the ways as the fallback does */
        ck_assert(hard(halved[k], LOG).energy > 5e3);
    less = hard(LIFT, CUBIC);
    ck_assert(less.p50 > cubic.p50 && less.lost == 0);
    less = hard(FIRST_RUNG, CUBIC);
    ck_assert(less.p50 <= cubic.p50 && less.lost == 0);
    less = hard(TROUBLE, CUBIC);
    ck_assert(less.unfinished > cubic.unfinished + 4 && cubic.unfinished > 0);
    less = hard(SEARCH, CUBIC);
    ck_assert(less.energy > 1e50);
    less = hard(PROJECTION, CUBIC);
    ck_assert(less.stands > 0 && cubic.stands == 0 && less.energy < 1e4);
    less = hard(STOPPING, CUBIC);
    ck_assert(less.energy > 1.05 * cubic.energy &&
              less.energy < 1.3 * cubic.energy);
    less = hard(BOUND, CUBIC);
    ck_assert(less.speed > 1.05 * cubic.speed && less.lost == 0);
    ck_assert(same(hard(LEAPING, CUBIC), cubic)); /* nothing leaps here */
}

static void a_rung_is_missed_rarely(void)
{
    const struct without_result
        all = play(NOTHING, CUBIC, BACKWARD_EULER, pointers_mad(38, 600)),
        leaps = play(LEAPING, CUBIC, BACKWARD_EULER, pointers_mad(38, 600)),
        swings = play(NOTHING, LOG, IMPLICIT_MIDPOINT, pointers_hard()),
        rests = play(FIRST_RUNG, LOG, IMPLICIT_MIDPOINT, pointers_hard()),
        whole = play(HALVING, LOG, BACKWARD_EULER, pointers_mad(18, 600));
    ck_assert_int_gt(whole.stands, 90); /* 52 if a way is halved once */
    ck_assert(leaps.speed > 2.0 * all.speed);
    ck_assert(swings.last > 0.1 && rests.last < 1e-3);
}

/* Nothing that one play leaves behind is read by the next.  A small square, so
 * that each ladder is seen by valgrind, too. */
static void a_play_repeats_itself(void)
{
    gsl_set_error_handler_off();
    struct pointers script = pointers_hard();
    for (int k = 0; k < 2 * (SIMPLE + 1); k++) {
        const enum without without = (enum without)(k / 2);
        const enum law law = k % 2 ? LOG : CUBIC;
        const struct without_result
            once = without_play(without, 2, law, BACKWARD_EULER, &script),
            again = without_play(without, 2, law, BACKWARD_EULER, &script);
        ck_assert(same(once, again) && once.p99 <= once.most);
    }
    pointers_free(&script);
}

/* Here the second rung is needed and always finishes: nothing is accepted that
 * has not, and accepting changes nothing. */
static void accepting_is_for_what_is_unfinished(void)
{
    gsl_set_error_handler_off();
    struct pointers script = pointers_mad(23, 60);
    for (int law = LOG; law <= CUBIC; law++) {
        static const enum without less[] = {NOTHING, SECOND_RUNG, ACCEPTING};
        struct without_result of[3];
        for (int k = 0; k < 3; k++)
            of[k] = without_play(less[k], 2, (enum law)law, BACKWARD_EULER,
                                 &script);
        ck_assert_int_eq(of[0].unfinished, 0);
        ck_assert_int_gt(of[1].lost, 0);
        ck_assert(same(of[2], of[0]));
    }
    pointers_free(&script);
}

static void rungs_have_words(void)
{
    for (int k = 0; k < N_WITHOUT; k++)
        for (int j = 0; j < k; j++)
            ck_assert_str_ne(without_word((enum without)k),
                             without_word((enum without)j));
    ck_assert_str_eq(without_word(NOTHING), "nothing");
    ck_assert_str_eq(without_word(PROJECTION), "projection of lift");
    ck_assert_str_eq(without_word(LEAPING), "bound on leaps");
    ck_assert_str_eq(without_word(TROUBLE), "memory of trouble");
}

UNIT_MAIN("without",
    LAW(nothing_is_the_ladder_of_live),
    LAW(a_rung_is_missed),
    LAW(a_rung_is_missed_rarely),
    LAW(a_play_repeats_itself),
    LAW(accepting_is_for_what_is_unfinished),
    LAW(rungs_have_words))
