/* robustness.c - laws of failure: where the step of step.h fails, and what
 * cures it. */
#include "figures/robustness/first_step.h"
#include "figures/robustness/reason.h"
#include "plane/scene.h"

#include "../oracle/robustness.h"
#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Both ends shifted by jump h in one step from rest; min J afterwards. */
static struct step_report shift(int n, enum law law, double jump,
                                const char *method, double *min_J)
{
    const struct step_control control = step_method(method);
    struct scene_setting set = scene_notes(RIGID, law, n);
    set.reach = jump * 2.0 / n / sin(set.dt);
    struct scene *s = scene_alloc(&set);
    const struct step_report report = scene_step(s, &control);
    *min_J = body_min_J(s->body, s->u);
    scene_free(s);
    return report;
}

static void first_steps_end_as_the_oracle_says(void)
{
    for (int k = 0; k < COUNT(oracle_step); k++) {
        const int n = oracle_step[k].n;
        const double jump = oracle_step[k].jump;
        double min_J;
        struct step_report report = shift(n, CUBIC, jump, "notes", &min_J);
        ck_assert_msg((report.status == OK) == (oracle_step[k].cubic > 0),
                      "cubic, n = %d, jump %g: %s", n, jump,
                      status_name(report.status));
        report = shift(n, LOG, jump, "notes", &min_J);
        ck_assert_msg(report.status == (oracle_step[k].log > 0 ? OK : INVERTED),
                      "log, n = %d, jump %g: %s", n, jump,
                      status_name(report.status));
        report = shift(n, CUBIC, jump, "lift", &min_J);
        ck_assert_int_eq(report.status, OK);
        ck_assert_int_le(abs(report.iterations - oracle_step[k].shifted), 1);
        close_to(min_J, oracle_step[k].min_J, 1e-9);
        if (oracle_step[k].min_J_log > 0.0) {
            report = shift(n, LOG, jump, "lift", &min_J);
            ck_assert_int_eq(report.status, OK);
            close_to(min_J, oracle_step[k].min_J_log, 1e-9);
        }
        report = shift(n, CUBIC, jump, "demand+search", &min_J);
        ck_assert_int_eq(report.status, OK);
        close_to(min_J, oracle_step[k].min_J, 1e-9);
    }
}

/* Steps of 1/30 s, until one fails. */
struct run {
    int iterations;
    enum status status;
    double energy;
};
static struct run move_ends(enum reading reading, int n, enum law law,
                            int steps, const char *method)
{
    const struct step_control control = step_method(method);
    const struct scene_setting set = scene_notes(reading, law, n);
    struct scene *s = scene_alloc(&set);
    struct run run = {.status = OK};
    while (s->steps < steps && run.status == OK) {
        const struct step_report report = scene_step(s, &control);
        run.iterations += report.iterations;
        run.status = report.status;
    }
    body_energy(s->body, s->u, &run.energy);
    scene_free(s);
    return run;
}

/* The same answers; for all 60 steps with n = 8 one takes 338 iterations, the
 * other 3198.  Buckling is in step 22. */
static void projecting_on_demand_is_several_times_cheaper(void)
{
    for (int n = 4; n <= 8; n *= 2) {
        const int steps = n == 4 ? 60 : 25;
        const struct run demand =
            move_ends(COMPRESS, n, CUBIC, steps, "demand+search");
        const struct run every =
            move_ends(COMPRESS, n, CUBIC, steps, "always+search");
        ck_assert_int_eq(demand.status, OK);
        ck_assert_int_eq(every.status, OK);
        ck_assert_int_ge(every.iterations, 4 * demand.iterations);
        close_to(demand.energy, every.energy, 1e-6 * every.energy);
    }
}

/* The same motion with fewer linear systems. */
static void extrapolation_saves_iterations(void)
{
    const struct run from_last = move_ends(STRETCH, 8, CUBIC, 60, "notes");
    const struct run extrapolated = move_ends(STRETCH, 8, CUBIC, 60, "lift");
    ck_assert(from_last.status == OK && extrapolated.status == OK);
    close_to(extrapolated.energy, from_last.energy, 1e-8 * from_last.energy);
    ck_assert_int_le(extrapolated.iterations, from_last.iterations - 60);
}

static void first_increment_is_linear_elasticity(void)
{
    struct step_control one = step_method("notes");
    one.max_iterations = 1;
    for (int k = 0; k < COUNT(oracle_locking); k++)
        for (int i = 0; i < 4; i++)
            for (int law = LOG; law <= CUBIC; law++) {
                const int n = 4 << i;
                struct scene_setting set =
                    scene_notes(GRAVITY, (enum law)law, n);
                set.nu = oracle_locking[k].nu;
                set.rho = 0.0;
                set.force = 1.0;
                struct scene *s = scene_alloc(&set);
                step_solve(s->body, &one, at_rest(s->f), s->u);
                close_to(s->u[2 * (n / 2 * (n + 1) + n) + 1],
                         oracle_locking[k].u[i], 1e-9);
                scene_free(s);
            }
}

/* Free vertices of n = 4 anywhere within 4 h, almost half of the triangles
 * inverted, both ends held; how the run from seed ends. */
struct rest {
    enum status status;
    int iterations;
    double size;
};
static struct rest unscramble(const char *method, enum law law, int seed)
{
    const struct step_control control = step_method(method);
    struct scene_setting set = scene_notes(RIGID, law, 4);
    set.rho = set.force = 0.0;
    struct scene *s = scene_alloc(&set);
    first_scatter(s, seed, 4.0 * 0.5);
    const struct step_report report =
        step_solve(s->body, &control, at_rest(NULL), s->u);
    struct rest end = {.status = report.status,
                       .iterations = report.iterations};
    for (int r = 0; r < s->n_dof; r++) end.size = fmax(end.size, fabs(s->u[r]));
    scene_free(s);
    return end;
}

static void any_scramble_comes_to_rest(void)
{
    const char *const sound[] = {"demand+search", "always+search"};
    for (int seed = 1; seed <= 40; seed++) {
        for (int m = 0; m < COUNT(sound); m++) {
            const struct rest end = unscramble(sound[m], CUBIC, seed);
            ck_assert_int_eq(end.status, OK);
            close_to(end.size, 0.0, 1e-8);
        }
        ck_assert_int_ne(unscramble("notes", CUBIC, seed).status, OK);
        ck_assert_int_eq(unscramble("search", CUBIC, seed).status,
                         NOT_SPD);
        const struct rest none = unscramble("demand+search", LOG, seed);
        ck_assert(none.status == INVERTED && none.iterations == 0);
    }
}

/* Systems are what is iterated; new factors for each, and once more where K is
 * projected on demand; as it was, where it is not SPD and nothing is done. */
static void a_report_counts_its_systems(void)
{
    static const char *const name[] = {"notes", "lift", "demand+search",
                                       "always+search"};
    int projections = 0, indefinite = 0;
    for (int m = 0; m < COUNT(name); m++) {
        const struct step_control control = step_method(name[m]);
        const struct scene_setting set = scene_notes(COMPRESS, CUBIC, 4);
        struct scene *s = scene_alloc(&set);
        enum status status = OK;
        while (s->steps < 40 && status == OK) {
            const struct step_report report = scene_step(s, &control);
            const int on_demand = m == 2 ? report.projections : 0;
            status = report.status;
            if (status != OK) break;
            ck_assert_int_gt(report.iterations, 0);
            ck_assert_int_eq(report.factorisations,
                             report.iterations + on_demand);
            if (m != 2)
                ck_assert_int_eq(report.projections,
                                 m == 3 ? report.iterations : 0);
            if (m >= 2) ck_assert_int_eq(report.indefinite, 0);
            projections += on_demand;
        }
        scene_free(s);
    }
    ck_assert_int_gt(projections, 0);

    struct step_control once = step_method("notes");
    once.max_iterations = 1;
    for (int seed = 1; seed <= 20; seed++) {
        const struct scene_setting set = scene_notes(RIGID, CUBIC, 4);
        struct scene *s = scene_alloc(&set);
        first_scatter(s, seed, 0.1 * seed);
        const struct incremental Phi = {1.0, s->v, NULL};
        body_assemble(s->body, Phi, s->u, EXACT, s->g);
        const int due = matrix_factor(s->body->K) != OK;
        ck_assert_int_eq(step_solve(s->body, &once, Phi, s->u).indefinite,
                         due);
        indefinite += due;
        scene_free(s);
    }
    ck_assert(indefinite > 0 && indefinite < 20);
}

/* Whole steps decrease Phi here, of which the forces are a part. */
static void a_line_search_knows_the_forces(void)
{
    for (int reading = GRAVITY; reading <= TRACTION; reading++) {
        const struct scene_setting set =
            scene_notes((enum reading)reading, CUBIC, 4);
        struct scene *s = scene_alloc(&set), *t = scene_alloc(&set);
        const struct step_control notes = step_method("notes");
        const struct step_control search = step_method("search");
        for (int k = 0; k < 5; k++) {
            const struct step_report a = scene_step(s, &notes);
            const struct step_report b = scene_step(t, &search);
            ck_assert(a.status == OK && b.status == OK);
            ck_assert_int_eq(a.iterations, b.iterations);
            for (int r = 0; r < s->n_dof; r++) close_to(s->u[r], t->u[r], 1e-9);
        }
        scene_free(s);
        scene_free(t);
    }
}

/* What a method does is in its name; caps as the comment of step.h says. */
static void methods_are_what_their_names_say(void)
{
    static const struct {
        const char *name;
        int cap;
    } method[] = {{"notes", 40}, {"search", 40}, {"demand", 100},
                  {"demand+search", 2000}, {"always+search", 2000},
                  {"lift", 40}, {"lift+search", 40}, {"all", 300}};
    for (int k = 0; k < COUNT(method); k++) {
        const char *name = method[k].name;
        const struct step_control c = step_method(name);
        const int all = strcmp(name, "all") == 0;
        const int lift = all || strstr(name, "lift");
        ck_assert_double_eq(c.tolerance, 1e-10);
        ck_assert_int_eq(c.max_iterations, method[k].cap);
        ck_assert_int_eq(c.guess, lift ? EXTRAPOLATED : FROM_LAST);
        ck_assert_int_eq(c.lift, lift);
        ck_assert_int_eq(c.chord, 0);
        ck_assert_int_eq(c.line_search, all || strstr(name, "search"));
        const int demand = all || strstr(name, "demand");
        ck_assert_int_eq(c.projection, strstr(name, "always") ? ALWAYS
                                       : demand               ? ON_DEMAND
                                                              : NEVER);
    }
}

static void ask_for_no_method(void) { step_method("noted"); }

static void an_unknown_method_is_an_error(void)
{
    const struct outcome end = outcome_of(ask_for_no_method);
    ck_assert_int_eq(end.status, 1);
    ck_assert_str_eq(end.err, "error: there is no method noted\n");
}

/* What a blow-up ends as is round-off, what a line search meets is not. */
static void reasons_are_words(void)
{
    const struct step_control notes = step_method("notes");
    const struct step_control search = step_method("search");
    ck_assert_str_eq(reason_of(&notes, OK), "OK");
    ck_assert_str_eq(reason_of(&notes, INVERTED), "INVERTED");
    ck_assert_str_eq(reason_of(&notes, NOT_SPD), "fails");
    ck_assert_str_eq(reason_of(&notes, NONFINITE), "fails");
    ck_assert_str_eq(reason_of(&notes, MAX_ITERATIONS), "fails");
    ck_assert_str_eq(reason_of(&search, NOT_SPD), "NOT_SPD");
}

/* Within reach, both ways, and the same again; the held vertices stay. */
static void scattered_vertices_stay_within_reach(void)
{
    const struct scene_setting set = scene_notes(GRAVITY, CUBIC, 6);
    struct scene *s = scene_alloc(&set);
    double first[2 * 7 * 7], least = 0.0, most = 0.0;
    first_scatter(s, 3, 0.25);
    memcpy(first, s->u, sizeof first);
    for (int r = 0; r < s->n_dof; r++) {
        if (s->held[r / 2]) ck_assert_double_eq(first[r], 0.0);
        least = fmin(least, first[r]);
        most = fmax(most, first[r]);
    }
    ck_assert(least > -0.25 && least < -0.2 && most > 0.2 && most < 0.25);
    first_scatter(s, 4, 0.25);
    ck_assert(s->u[s->n_dof - 1] != first[s->n_dof - 1]);
    first_scatter(s, 3, 0.25);
    for (int r = 0; r < s->n_dof; r++)
        ck_assert_double_eq(s->u[r], first[r]);
    scene_free(s);
}

UNIT_MAIN("robustness",
    LAW(scattered_vertices_stay_within_reach),
    LAW(first_steps_end_as_the_oracle_says),
    LAW(projecting_on_demand_is_several_times_cheaper),
    LAW(extrapolation_saves_iterations),
    LAW(first_increment_is_linear_elasticity),
    LAW(any_scramble_comes_to_rest),
    LAW(a_report_counts_its_systems),
    LAW(a_line_search_knows_the_forces),
    LAW(methods_are_what_their_names_say),
    LAW(an_unknown_method_is_an_error),
    LAW(reasons_are_words))
