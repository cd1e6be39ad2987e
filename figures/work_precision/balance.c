/* balance.c - see balance.h. */
#include "balance.h"

#include "rule.h"

#include "base/study.h"
#include "base/table.h"

#include <math.h>

/* What the rule did; the last four are the worst. */
struct record {
    int asked, found, twice, asked_twice, all_twice;
    double same, late, over; /* late: error over what was asked for */
    double all; /* as same, of all settings; 0: there are no others */
};

static struct record record_of(const struct trials *s, int meshes)
{
    struct record r = {0};
    for (double e = 0.5; trials_cheapest(s, s->count, e) >= 0; e /= 1.25) {
        const int k = rule_take(s, meshes, e).taken;
        r.asked++;
        if (k < 0) continue;
        const double flops = s->work[k].flops;
        const double same =
            flops / s->work[trials_cheapest(s, s->count, s->error[k])].flops;
        const double over =
            flops / s->work[trials_cheapest(s, s->count, e)].flops;
        r.found++;
        r.twice += same <= 2.0;
        r.asked_twice += over <= 2.0;
        r.same = fmax(r.same, same);
        r.late = fmax(r.late, s->error[k] / e);
        r.over = fmax(r.over, over);
        if (s->all == s->count) continue;
        const double all =
            flops / s->work[trials_cheapest(s, s->all, s->error[k])].flops;
        r.all_twice += all <= 2.0;
        r.all = fmax(r.all, all);
    }
    return r;
}

static struct record both(struct record a, struct record b)
{
    return (struct record){a.asked + b.asked, a.found + b.found,
                           a.twice + b.twice, a.asked_twice + b.asked_twice,
                           a.all_twice + b.all_twice, fmax(a.same, b.same),
                           fmax(a.late, b.late), fmax(a.over, b.over),
                           fmax(a.all, b.all)};
}

static void print_record(const char *scene, int meshes, struct record r)
{
    table_row(scene, meshes, r.asked, r.found, r.twice, r.same,
              cell_rounded(4, r.late), r.asked_twice, r.over,
              cell_if(r.all > 0.0, r.all_twice), cell_if(r.all > 0.0, r.all));
}

/* Whoever has no rule takes the finest that is to be had, every time. */
static int finest(const struct trials *s)
{
    int best = -1;
    for (int k = 0; k < s->count; k++) {
        const struct work_setting *a = &s->set[k];
        if (a->law == LOG && a->dynamic && a->method == IMPLICIT_MIDPOINT &&
            a->tolerance < 1e-4 && a->n == 4 * work_coarsest(s->scene) &&
            (best < 0 || a->steps > s->set[best].steps))
            best = k;
    }
    return best;
}

/* A good guess: of what is plain to take, the log law on the mesh of that run,
 * the cheapest that is as good.  Its index. */
static int good_guess(const struct trials *s, int last)
{
    int best = last;
    for (int k = 0; k < s->count; k++)
        if (s->set[k].law == LOG && s->set[k].n == s->set[last].n &&
            s->error[k] <= s->error[last] &&
            s->work[k].flops < s->work[best].flops)
            best = k;
    return best;
}

/* The rule's price for an error, or for the first above it that it reaches; how
 * many runs it takes to pay, against the finest one (which may be worse). */
static double print_price(const struct trials *s, int meshes, double e)
{
    struct rule_choice c = rule_take(s, meshes, e);
    while (c.taken < 0) c = rule_take(s, meshes, e *= 1.25);
    const double answer = s->work[c.taken].flops;
    const int last = finest(s);
    const double rich = s->work[last].flops;
    const double pays = fmax(1.0, ceil(c.flops / (rich - answer)));
    const int guess = good_guess(s, last);
    table_row(work_scene_name(s->scene), cell_rounded(2, e), c.probes,
              c.flops, answer, cell_rounded(4, s->error[c.taken]), rich,
              cell_rounded(4, s->error[last]), pays, c.flops / answer,
              s->work[guess].flops, s->set[guess].dynamic
                  ? method_name(s->set[guess].method) : "static",
              s->set[guess].steps, cell_rounded(4, s->error[guess]));
    claim(c.flops > 9.0 * answer, "%s: to decide costs more than nine answers "
          "(%g)", work_scene_name(s->scene), c.flops / answer);
    claim((s->error[c.taken] > e) == (s->scene == BUCKLE) &&
              (s->error[last] > 0.5 * e) == (s->scene == BUCKLE), "%s: except "
          "in the column the answer is good enough, and the finest twice as "
          "exact as asked (%g, %g; %g)", work_scene_name(s->scene),
          s->error[c.taken], s->error[last], e);
    claim(s->work[guess].flops < c.flops, "%s: as good as the finest run, and "
          "cheaper than deciding (%g, %g)", work_scene_name(s->scene),
          s->work[guess].flops, c.flops);
    claim((s->error[last] > s->error[c.taken]) ==
              (s->scene == SWING || s->scene == BUCKLE), "%s: the finest is "
          "worse than the answer in the swing and in the column only (%g, %g)",
          work_scene_name(s->scene), s->error[last], s->error[c.taken]);
    return pays;
}

/* Where the rule was made, and where it was not. */
static void judge(int meshes, struct record made, struct record test)
{
    claim(made.same <= 2.1 && made.twice + 1 >= made.found &&
              made.late < 1.7 && 10 * made.found > 9 * made.asked, "from %d "
          "meshes the rule costs at most 2.1 times the cheapest that is as "
          "good (%g), has an error below 1.7 times what was asked (%g), and "
          "answers nine of ten (%d of %d)", meshes, made.same, made.late,
          made.found, made.asked);
    claim(lround(made.all) == (meshes == 3 ? 8 : 17) &&
              made.all_twice < made.twice - 10, "of all settings the cheapest "
          "that is as good is up to 8 times cheaper, from two meshes 17 (%g, "
          "%d)", made.all, made.all_twice);
    claim(test.found == test.asked && test.late < 1.7 &&
              test.twice + 1 == test.found && test.same < 20.0, "in other "
          "scenes at most twice in all but one (%d of %d, %g)", test.twice,
          test.found, test.same);
}

/* The example by hand: the slow pull to an error of 0.02 from two meshes. */
static void check_example(const struct trials *s)
{
    const struct rule_choice c = rule_take(s, 2, 0.02);
    const int k = c.taken < 0 ? 0 : c.taken;
    const double times = c.flops / s->work[k].flops;
    claim(c.taken >= 0 && s->set[k].law == LOG && !s->set[k].dynamic &&
              s->set[k].n == 8 && s->set[k].steps == 1 &&
              fabs(times - 100.0) < 5.0, "for 0.02 the slow pull is taken "
          "static with n = 8, for 100 times its flops (%g)", times);
}

void balance_tables(struct trials *const s[WORK_SCENES])
{
    struct record made[2] = {{0}, {0}}, test[2] = {{0}, {0}};
    double slowest[2] = {0.0, 0.0};

    table_begin("rule", "scene meshes asked found twice same late asked_twice "
                        "over all_twice all");
    for (int m = 0; m < 2; m++) {
        for (int k = 0; k < WORK_SCENES; k++) {
            const struct record r = record_of(s[k], 3 - m);
            struct record *sum = k < JOLTED_PULL ? &made[m] : &test[m];
            print_record(work_scene_name(s[k]->scene), 3 - m, r);
            *sum = both(*sum, r);
        }
    }
    table_end();
    table_begin("sums", "scene meshes asked found twice same late asked_twice "
                        "over all_twice all");
    for (int m = 0; m < 2; m++) {
        print_record("the six", 3 - m, made[m]);
        print_record("the two others", 3 - m, test[m]);
    }
    table_end();
    for (int m = 0; m < 2; m++) judge(3 - m, made[m], test[m]);
    const double late = fmax(fmax(made[0].late, made[1].late), test[0].late);
    claim(fabs(test[1].late - 1.65) < 0.005 && test[1].late > late, "the "
          "largest error is 1.65 times what was asked, in other scenes from "
          "two meshes (%g, %g)", test[1].late, late);
    check_example(s[SLOW_PULL]);
    for (int m = 0; m < 2; m++) {
        table_begin(m ? "price_two" : "price_three", "scene wanted runs probes "
                    "answer error finest finest_error pays times guess "
                    "guess_method guess_steps guess_error");
        for (int k = 0; k < WORK_SCENES; k++)
            slowest[m] = fmax(slowest[m], print_price(s[k], 3 - m, 0.1));
        table_end();
    }
    claim(slowest[0] <= 7.0 && slowest[1] <= 1.0, "it pays from %g runs on, "
          "from two meshes from %g", slowest[0], slowest[1]);
}
