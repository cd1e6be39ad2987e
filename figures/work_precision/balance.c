/*
 * balance.c - does the balance rule find the cheapest setting?
 *
 * All settings of trials.h in six scenes.  The cheapest for an error; and the
 * rule [alg:balance], asked for the errors 0.5, 0.4, ... as far as a setting
 * gets: its flops over those of the cheapest that is as good (same), and over
 * those of the cheapest for what was asked (over).
 */
#include "base/study.h"
#include "trials.h"
#include "base/table.h"

#include <math.h>

/* What the rule did; the last three are the worst. */
struct rule {
    int asked, found, twice, asked_twice;
    double same, late, over; /* late: error over what was asked for */
};

static struct rule rule_of(const struct trials *s)
{
    struct rule rule = {0};
    for (double e = 0.5; trials_cheapest(s, s->count, e) >= 0; e /= 1.25) {
        const int k = trials_balanced(s, e);
        rule.asked++;
        if (k < 0) continue;
        const double flops = s->work[k].flops;
        const double same =
            flops / s->work[trials_cheapest(s, s->count, s->error[k])].flops;
        const double over =
            flops / s->work[trials_cheapest(s, s->count, e)].flops;
        rule.found++;
        rule.twice += same <= 2.0;
        rule.asked_twice += over <= 2.0;
        rule.same = fmax(rule.same, same);
        rule.late = fmax(rule.late, s->error[k] / e);
        rule.over = fmax(rule.over, over);
    }
    return rule;
}

static struct rule both(struct rule a, struct rule b)
{
    return (struct rule){a.asked + b.asked, a.found + b.found,
                         a.twice + b.twice, a.asked_twice + b.asked_twice,
                         fmax(a.same, b.same), fmax(a.late, b.late),
                         fmax(a.over, b.over)};
}

static void print_rule(const char *scene, struct rule rule)
{
    table_row(scene, rule.asked, rule.found, rule.twice, rule.same,
              cell_rounded(4, rule.late), rule.asked_twice, rule.over);
}

int main(void)
{
    static const double wanted[] = {0.3, 0.1, 0.03, 0.01, 0.003, 0.001};
    struct trials *s[FLAGSHIP];
    struct rule all = {0};

    table_begin("cheapest", TRIALS_COLUMNS);
    for (int k = 0; k < FLAGSHIP; k++) {
        s[k] = trials_alloc((enum work_scene)k);
        for (int i = 0; i < 6; i++) {
            const int best = trials_cheapest(s[k], s[k]->all, wanted[i]);
            if (best >= 0 && wanted[i] > s[k]->floor)
                trials_row(s[k], best, wanted[i]);
        }
    }
    table_end();
    table_begin("rule", "scene asked found twice same late asked_twice over");
    for (int k = 0; k < FLAGSHIP; k++) {
        const struct rule rule = rule_of(s[k]);
        print_rule(work_scene_name(s[k]->scene), rule);
        all = both(all, rule);
        trials_free(s[k]);
    }
    print_rule("all", all);
    table_end();
    claim(all.same <= 2.0 && all.twice == all.found && all.late < 1.7 &&
              10 * all.found > 9 * all.asked, "the rule costs at most twice "
          "the cheapest that is as good, and delivers (%g, %g, %d of %d)",
          all.same, all.late, all.twice, all.found);
    return table_finish();
}
