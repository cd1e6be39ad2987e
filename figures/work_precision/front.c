/*
 * front.c - for a wanted error, which setting is the cheapest, and does the
 * balance rule find it?
 *
 * All settings of sweep.h in six scenes: error against counted flops, the front
 * of those that nothing cheaper is as good as, and what the rule [alg:balance]
 * takes for errors 0.5, 0.4, ... as far as a setting gets.  over_same: its
 * flops over those of the cheapest that is as good; over_asked: as was asked.
 */
#include "base/study.h"
#include "sweep.h"
#include "base/table.h"

#include <math.h>
#define COLUMNS "scene asked law method n steps tolerance error flops reason " \
                "systems"

static void print_run(const struct sweep *s, int k, double asked)
{
    const struct work_setting *set = &s->set[k];
    const int ok = s->work[k].status == OK;
    table_row(work_scene_name(s->scene), asked, material_law(set->law),
              set->dynamic ? method_name(set->method) : "static", set->n,
              set->steps, set->tolerance,
              ok ? cell_rounded(4, s->error[k]) : cell_word(MISSING),
              cell_if(ok, s->work[k].flops), status_name(s->work[k].status),
              s->work[k].systems);
}

/* What the rule did; the last three are the worst. */
struct rule {
    int asked, found, twice, asked_twice;
    double same, late, over; /* late: error over what was asked for */
};

static struct rule rule_of(const struct sweep *s, int print)
{
    struct rule rule = {0};
    for (double e = 0.5; sweep_cheapest(s, e) >= 0; e /= 1.25) {
        const int k = sweep_balanced(s, e);
        rule.asked++;
        if (k < 0) continue;
        const double flops = s->work[k].flops;
        const double same =
            flops / s->work[sweep_cheapest(s, s->error[k])].flops;
        const double over = flops / s->work[sweep_cheapest(s, e)].flops;
        if (print) print_run(s, k, e);
        rule.found++;
        rule.twice += same <= 2.0;
        rule.asked_twice += over <= 2.0;
        rule.same = fmax(rule.same, same);
        rule.late = fmax(rule.late, s->error[k] / e);
        rule.over = fmax(rule.over, over);
    }
    return rule;
}

static void print_best(struct sweep *const s[])
{
    static const double wanted[] = {0.3, 0.1, 0.03, 0.01};
    table_begin("cheapest", COLUMNS);
    for (int k = 0; k < FLAGSHIP; k++)
        for (int i = 0, best; i < 4; i++)
            if ((best = sweep_cheapest(s[k], wanted[i])) >= 0)
                print_run(s[k], best, wanted[i]);
    table_end();
    table_begin("front", COLUMNS);
    for (int k = 0; k < FLAGSHIP; k++)
        for (int i = sweep_cheapest(s[k], 10.0); i >= 0;
             i = sweep_cheapest(s[k], s[k]->error[i] * (1.0 - 1e-9)))
            print_run(s[k], i, 0.0);
    table_end();
}

int main(void)
{
    struct sweep *s[FLAGSHIP];
    struct rule all = {0};
    int failed = 0;

    table_begin("settings", COLUMNS);
    for (int k = 0; k < FLAGSHIP; k++) {
        s[k] = sweep_alloc((enum work_scene)k);
        for (int i = 0; i < s[k]->count; i++) {
            print_run(s[k], i, 0.0);
            failed += s[k]->work[i].status != OK &&
                      s[k]->set[i].method != SYMPLECTIC_EULER;
        }
    }
    table_end();
    table_begin("scenes", "scene size floor settings");
    for (int i = 0; i < FLAGSHIP; i++)
        table_row(work_scene_name(s[i]->scene), s[i]->size,
                  cell_rounded(4, s[i]->floor), s[i]->count);
    table_end();
    print_best(s);
    table_begin("takes", COLUMNS);
    for (int k = 0; k < FLAGSHIP; k++) rule_of(s[k], 1);
    table_end();
    table_begin("rule", "scene asked found twice same late asked_twice over");
    for (int k = 0; k <= FLAGSHIP; k++) {
        const int last = k == FLAGSHIP;
        const struct rule rule = last ? all : rule_of(s[k], 0);
        table_row(last ? "all" : work_scene_name(s[k]->scene), rule.asked,
                  rule.found, rule.twice, rule.same, cell_rounded(4, rule.late),
                  rule.asked_twice, rule.over);
        if (last) break;
        all = (struct rule){all.asked + rule.asked, all.found + rule.found,
            all.twice + rule.twice, all.asked_twice + rule.asked_twice,
            fmax(all.same, rule.same), fmax(all.late, rule.late),
            fmax(all.over, rule.over)};
        sweep_free(s[k]);
    }
    table_end();
    claim(failed == 0, "only symplectic Euler fails (%d others)", failed);
    claim(all.same <= 2.0 && all.twice == all.found && all.late < 1.7 &&
              10 * all.found > 9 * all.asked, "the rule costs at most twice "
          "the cheapest that is as good, and delivers (%g, %g, %d of %d)",
          all.same, all.late, all.twice, all.found);
    return table_finish();
}
