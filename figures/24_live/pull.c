/*
 * pull.c - how fast may a side be pulled, and from which start?
 *
 * The right side of the square is taken and pulled to the right, backward
 * Euler, dt = 1/30, no second rung: `fast` alone, with 40 systems and factors
 * kept within the frame (what others do: kept.c).  It starts from the elastic
 * lift, by rows, or from the last state, held values written in.  Tables: pull
 * (frames lost of 40 at 6 m/s, and the most systems in a frame), limit (of both
 * laws the least speed, in steps of 0.1 m/s, that loses one of the first three
 * frames from the last state, and the jump in one frame over h; under LOG also
 * the largest such speed, and the frames lost of 10 at the fastest hand, 7.5
 * m/s, and then with the second rung and from the elastic lift), slope (G' of
 * both laws over J: dP/dF of a triangle has the eigenvalue mu - G'), poisson
 * (over nu, n = 24: the jump over h of the least speed that loses a frame, and
 * the J at which G' passes mu; an empty cell says that there is none).
 */
#include "motion/live.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

static const char *const START[] = {"elastic", "rows", "last state"};

struct losses {
    int lost, most;
};

/* What is lost of the first `frames` of a pull. */
static struct losses pull(int n, enum law law, enum start start,
                          int second_rung, double nu, double speed,
                          int frames)
{
    const struct live_setting set = {n, law, BACKWARD_EULER, SIDE, start,
                                     second_rung, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    if (n < 40) body_store(live->body, PLAIN); /* trouble is chaotic */
    struct pointers script = pointers_pull(speed);
    struct losses sum = {0, 0};
    for (int k = 0; k <= frames; k++) { /* the hand grabs in frame 0 */
        if (frames < 5 && sum.lost) break; /* for limit() one is enough */
        double to[2];
        live_input(live, &script.frame[k]);
        live->body->material = material_make(law, 1000.0, nu);
        live_hand(live->hand, &script.frame[k], to);
        live_carry(live, to);
        live->body->kept.usable = 0;
        const struct live_report report = live_frame(live, to);
        sum.lost += strcmp(report.rung, "lost") == 0;
        if (report.systems > sum.most) sum.most = report.systems;
    }
    pointers_free(&script);
    live_free(live);
    return sum;
}

/* Which speeds lose a frame (m/s): the least, to 0.1, looked for upwards in
 * steps of 0.5, and the largest, or NAN; how many of these lose none. */
struct limit {
    double least, largest;
    int spared;
};
static struct limit limit(int n, enum law law, double nu)
{
    enum { FASTEST = 75 }; /* the hand is bounded to 7.5 m/s */
    int least = 5, largest = FASTEST, spared = 0;
    while (!pull(n, law, LAST_STATE, 0, nu, 0.1 * least, 3).lost)
        if ((least += 5) > FASTEST) return (struct limit){NAN, NAN, 0};
    while (pull(n, law, LAST_STATE, 0, nu, 0.1 * (least - 1), 3).lost) least--;
    while (!pull(n, law, LAST_STATE, 0, nu, 0.1 * largest, 3).lost) largest--;
    for (int speed = least; speed <= largest; speed += 10) /* 1 m/s */
        spared += !pull(n, law, LAST_STATE, 0, nu, 0.1 * speed, 3).lost;
    return (struct limit){0.1 * least, 0.1 * largest, spared};
}

static void print_limit(void)
{
    static const int n[] = {16, 24, 32, 40, 42, 44, 48, 56, 64};
    double before = 0.0;
    table_begin("limit", "n cubic jump log log_jump log_to log_lost log_second "
                         "log_elastic");
    for (int k = 0; k < COUNT(n); k++) {
        const struct limit cubic = limit(n[k], CUBIC, 0.3);
        const struct limit of_log = limit(n[k], LOG, 0.3);
        const double h_per_frame = 30.0 * 2.0 / n[k]; /* m/s */
        const double jump = of_log.least / h_per_frame;
        const int some = n[k] > 40, fine = n[k] > 42;
        const int lost = pull(n[k], LOG, LAST_STATE, 0, 0.3, 7.5, 10).lost;
        const int second = pull(n[k], LOG, LAST_STATE, 1, 0.3, 7.5, 10).lost;
        const int elastic = pull(n[k], LOG, ELASTIC, 0, 0.3, 7.5, 10).lost;
        table_row(n[k], cubic.least, cubic.least / h_per_frame,
                  cell_if(some, of_log.least), cell_if(some, jump),
                  cell_if(some, of_log.largest), lost, second, elastic);
        claim(fabs(cubic.least / h_per_frame - 1.85) < 0.1 &&
                  cubic.largest == 7.5 && cubic.spared == 0,
              "cubic law: lost above a jump of 1.85 h in one frame, for "
              "every h (n = %d: %g m/s)", n[k], cubic.least);
        claim(some == isfinite(of_log.least) && of_log.spared == 0 &&
                  fine == (of_log.largest == 7.5) && lost == (fine ? 10 : 0),
              "LOG: none is lost up to n = 40, with 42 between two speeds, "
              "from 44 on above a limit (n = %d: %g to %g m/s, but %d)", n[k],
              of_log.least, of_log.largest, of_log.spared);
        claim(second == 0 && elastic == 0 && (n[k] <= 44 || jump < before),
              "LOG: the second rung, or the elastic lift, saves them all, and "
              "in h, too, the limit falls with h (%g, %g)", jump, before);
        before = jump;
    }
    table_end();
}

/* The J at which G' passes mu, or NAN. */
static double crossing(enum law law, double nu)
{
    const struct material m = material_make(law, 1000.0, nu);
    for (double J = 1.0; J < 6.0; J += 1e-4)
        if (material_volume(&m, J).dG > m.mu) return J;
    return NAN;
}

/* G' of both laws: the most under LOG. */
static double print_slope(const struct material law[2])
{
    double most_log = 0.0;
    table_begin("slope", "J log cubic mu");
    for (double J = 1.0; J < 6.0; J += 0.0625) {
        const double G[2] = {material_volume(&law[0], J).dG,
                             material_volume(&law[1], J).dG};
        table_row(J, G[0], G[1], law[0].mu);
        most_log = fmax(most_log, G[0]);
    }
    table_end();
    return most_log;
}

/* Where a pull is lost, as Poisson's ratio comes near 1/2. */
static void print_poisson(void)
{
    static const double ratio[] = {0.0, 0.1, 0.3, 0.4, 0.45, 0.49};
    enum { N = 24, RATIOS = COUNT(ratio) };
    double jump[RATIOS][2], J[RATIOS][2]; /* cubic, LOG */
    table_begin_note("poisson", "nu cubic log cubic_J log_J", "n = %d", N);
    for (int k = 0; k < RATIOS; k++) {
        for (int l = 0; l < 2; l++) {
            const enum law law = l ? LOG : CUBIC;
            jump[k][l] = limit(N, law, ratio[k]).least / (30.0 * 2.0 / N);
            J[k][l] = crossing(law, ratio[k]);
            claim(!pull(N, law, LAST_STATE, 1, ratio[k], 7.5, 10).lost,
                  "the second rung saves them all (nu = %g)", ratio[k]);
        }
        table_row(ratio[k], cell_if(isfinite(jump[k][0]), jump[k][0]),
                  cell_if(isfinite(jump[k][1]), jump[k][1]),
                  cell_if(isfinite(J[k][0]), J[k][0]),
                  cell_if(isfinite(J[k][1]), J[k][1]));
    }
    table_end();
    for (int k = 3; k < RATIOS; k++)
        claim(jump[k][0] < 0.75 * jump[k - 1][0] &&
                  !(jump[k][1] > 0.75 * jump[k - 1][1]) &&
                  jump[k][1] <= jump[k][0] && J[k][0] < J[k - 1][0],
              "nearer 1/2 a smaller jump loses a frame, under LOG too "
              "(nu = %g: %g and %g h)", ratio[k], jump[k][0],
              jump[k][1]);
    claim(!isfinite(J[2][1]) && !isfinite(jump[2][1]) && isfinite(jump[3][1]),
          "LOG loses frames where its G' passes mu");
}

int main(void)
{
    struct losses cubic[3], of_log[3];
    gsl_set_error_handler_off();

    table_begin_note("pull", "start cubic cubic_systems log log_systems",
                     "n = 24, 6 m/s, 40 frames");
    for (int s = ELASTIC; s <= LAST_STATE; s++) {
        cubic[s] = pull(24, CUBIC, (enum start)s, 0, 0.3, 6.0, 40);
        of_log[s] = pull(24, LOG, (enum start)s, 0, 0.3, 6.0, 40);
        table_row(START[s], cubic[s].lost, cubic[s].most, of_log[s].lost,
                  of_log[s].most);
    }
    table_end();

    print_limit();
    const struct material law[] = {material_notes(LOG), material_notes(CUBIC)};
    const double most_log = print_slope(law), J = crossing(CUBIC, 0.3);
    print_poisson();

    claim(cubic[LAST_STATE].lost >= 36 && of_log[LAST_STATE].lost == 0,
          "from the last state a pull of 6 m/s is lost for ever under the "
          "cubic law (%d of 40), and under LOG not (%d)",
          cubic[LAST_STATE].lost, of_log[LAST_STATE].lost);
    claim(cubic[ELASTIC].lost + cubic[ROWS].lost + of_log[ELASTIC].lost +
                  of_log[ROWS].lost == 0 &&
              2 * cubic[ELASTIC].most < of_log[LAST_STATE].most,
          "either lift loses none, in half of the systems (%d) of LOG from the "
          "last state (%d)", cubic[ELASTIC].most, of_log[LAST_STATE].most);
    claim(fabs(J - 2.2787) < 2e-4 &&
              fabs(most_log / law[0].mu - 0.2833) < 1e-4,
          "G' passes mu at J = 2.28 under the cubic law (%g), under LOG never: "
          "it has at most 0.2833 mu (%g)", J, most_log / law[0].mu);
    return table_finish();
}
