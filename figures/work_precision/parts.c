/* parts.c - see parts.h. */
#include "parts.h"

#include "rule.h"
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

/* What the rule expects in the shake, and the parts it is made of. */
static void print_walk(const struct trials *s)
{
    static const int at[][2] = {{4, 4}, {4, 8}, {8, 4}, {8, 8}, {8, 16},
                                {16, 4}, {16, 8}, {16, 16}};
    double whole[COUNT(at)], sizes[COUNT(at)], part[N_PART];
    table_begin("walk", "n steps expected space time");
    for (int k = 0; k < COUNT(at); k++) {
        const struct work_setting set = {
            .scene = s->scene, .law = LOG, .dynamic = 1, .n = at[k][0],
            .steps = at[k][1], .method = IMPLICIT_MIDPOINT, .tolerance = 1e-2};
        whole[k] = rule_parts(s, 2, &set, part);
        sizes[k] = part[SPACE] + part[TIME];
        table_row(set.n, set.steps, cell_rounded(3, whole[k]),
                  cell_rounded(3, part[SPACE]), cell_rounded(3, part[TIME]));
    }
    table_end();
    claim(whole[3] < whole[5] && whole[4] < 0.1 && sizes[5] < sizes[3] &&
              sizes[6] > 0.1, "as vectors the parts say step, as sizes mesh "
          "(%g, %g; %g, %g)", whole[3], whole[5], sizes[3], sizes[5]);
}

/* How many runs of all elements fail, how many of these are explicit, and how
 * many explicit ones there are. */
struct failures {
    int all, explicit, tried;
};
static struct failures failures_of(const struct trials *s)
{
    struct failures f = {0, 0, 0};
    for (int i = 0; i < s->all; i++) {
        const int explicit = s->set[i].dynamic &&
                             s->set[i].method == SYMPLECTIC_EULER;
        f.tried += explicit;
        if (s->work[i].status == OK) continue;
        f.all++;
        f.explicit += explicit;
    }
    return f;
}

/* In how many settings, as the rule estimates, one part is more than 80 % of
 * the sum of the sizes. */
static void print_parts(struct trials *const s[])
{
    int all = 0, mostly = 0, column = 0, column_mostly = 0;
    struct failures failed = {0, 0, 0};
    table_begin("parts", "scene settings mostly failed explicit");
    for (int k = 0; k < JOLTED_PULL; k++) {
        int settings = 0, one = 0;
        for (int i = 0; i < s[k]->count; i++) {
            double part[N_PART], sum = 0.0, most = 0.0;
            if (s[k]->work[i].status != OK) continue;
            rule_parts(s[k], 3, &s[k]->set[i], part);
            for (int p = 0; p < N_PART; p++) {
                sum += part[p];
                most = fmax(most, part[p]);
            }
            if (!isfinite(sum)) continue;
            settings++;
            one += most > 0.8 * sum;
        }
        const struct failures f = failures_of(s[k]);
        table_row(work_scene_name(s[k]->scene), settings, one, f.all,
                  f.explicit);
        failed.all += f.all;
        failed.explicit += f.explicit;
        all += settings;
        mostly += one;
        if (s[k]->scene == BUCKLE) {
            column = settings;
            column_mostly = one;
            claim(f.explicit == f.tried - 1 && f.all == f.explicit, "in the "
                  "column only one explicit run succeeds, and no other fails "
                  "(%d of %d, %d)", f.explicit, f.tried, f.all);
        }
    }
    table_row("all", all, mostly, failed.all, failed.explicit);
    table_row("without_buckle", all - column, mostly - column_mostly,
              cell_word(MISSING), cell_word(MISSING));
    table_end();
    claim(failed.all == failed.explicit + 3 && failed.all == 200, "of the runs "
          "that fail all but three are explicit (%d of %d)", failed.explicit,
          failed.all);
    claim(fabs((double)mostly / all - 0.5) < 0.06 && column_mostly == column &&
              2 * (mostly - column) < all - column, "one part is nearly all in "
          "about half of the settings, in the column in all (%d of %d, %d of "
          "%d)", mostly, all, column_mostly, column);
}

/* Quadratic triangles and the midpoint rule in the column: what is so good with
 * eight steps is worse with twice as many. */
static void print_luck(const struct trials *s)
{
    double error[3][6];
    table_begin("luck", "n four eight sixteen thirtytwo sixtyfour more");
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 6; k++) {
            const struct work_setting set = {
                BUCKLE, LOG, 1, 16 << i, 4 << k, IMPLICIT_MIDPOINT, 1e-5,
                QUADRATIC_TRIANGLE, 1.0};
            const struct work run = work_run(&set);
            error[i][k] = work_distance(&run, &s->limit) / s->size;
        }
        const double *e = error[i];
        table_row(16 << i, cell_rounded(4, e[0]), cell_rounded(4, e[1]),
                  cell_rounded(4, e[2]), cell_rounded(4, e[3]),
                  cell_rounded(4, e[4]), cell_rounded(4, e[5]));
        claim(e[2] > 4.0 * e[1] && e[2] < 23.0 * e[1], "n = %d: good by luck, "
              "with twice the steps worse (%g, %g)", 16 << i, e[1], e[2]);
    }
    table_end();
    claim(error[0][5] < error[0][4], "that for 0.03 is as good with twice the "
          "steps (%g, %g)", error[0][4], error[0][5]);
}

void parts_tables(struct trials *const s[WORK_SCENES])
{
    print_walk(s[SHAKE]);
    print_parts(s);
    print_luck(s[BUCKLE]);
}
