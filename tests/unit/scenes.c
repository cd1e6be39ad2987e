/* scenes.c - laws of common/choice/scene_file.h. */
#include "choice/scene_file.h"

#include "choice/estimate.h"

#include "unit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char path[64];
static struct scene_file file;

static void write_file(const char *text)
{
    snprintf(path, sizeof path, "/tmp/unit-%ld.some.scene", (long)getpid());
    FILE *out = fopen(path, "w");
    ck_assert(out && fputs(text, out) >= 0 && fclose(out) == 0);
}
static void read_file(void)
{
    scene_file_read("unit", path, 3, &file);
}

/* A body of 4 cm by 1 cm, E = 20 kN/m^2, 1000 kg/m^3: lengths are in units of
 * 2 cm, stresses of 20 N/m^2, times of 0.02 sqrt(50). */
static void a_file_is_scaled(void)
{
    write_file("# all words\n\n  width 0.04 # m\nheight\t0.01\r\nE 2e4\n"
               "nu 0.45\nrho 1000\ngravity 1 -9.81\nheld left\npulled 30 -7\n"
               "pushed 0.5 -0.25\nload swings\nperiod 0.3\nend 2\n"
               "quantity rms");
    read_file();
    const struct ladder_scene *s = &file.scene;
    const double second = 0.02 * sqrt(50.0);
    close_to(s->slender, 4.0, 1e-14);
    close_to(s->nu, 0.45, 0.0 + 1e-15);
    close_to(s->weight[0], 1000.0 * 0.02 / 20.0, 1e-13);
    close_to(s->weight[1], -9810.0 * 0.02 / 20.0, 1e-12);
    close_to(s->pull[0], 1.5, 1e-14);
    close_to(s->pull[1], -0.35, 1e-14);
    close_to(s->push[0], 0.025, 1e-14);
    close_to(s->push[1], -0.0125, 1e-14);
    close_to(s->T, 0.3 / (2.0 * acos(-1.0)) / second, 1e-12);
    ck_assert_int_eq(s->quantity, LADDER_RMS);
    close_to(s->end, 2.0 / second, 1e-12);
    ck_assert(s->time == SWINGS && s->held == LADDER_LEFT && s->finest == 3);
    const double steps = s->end / s->dt;
    close_to(steps, floor(steps + 0.5), 1e-9);
    ck_assert(steps > 39.5 && steps < 400.5 && s->dt < s->T / 8.0);
    ck_assert_str_eq(s->name + strlen(s->name) - 5, ".some");
    close_to(file.metre, 0.02, 1e-16);
    close_to(file.pascal, 20.0, 1e-13);
    close_to(file.second, second, 1e-14);
    unlink(path);
}

/* Twelve times the size, 144 times the modulus and load: the same strain; and
 * where both ends are held there is no bar, and neither moves. */
static void units_do_not_matter(void)
{
    double u[2];
    for (int k = 0; k < 2; k++) {
        write_file(k ? "width 24\nheight 6\nE 144000\nnu 0.3\nrho 1\n"
                       "held ends\npushed 0 -1440\nload rises\ntime 1\nend 2\n"
                     : "width 2\nheight 0.5\nE 1000\nnu 0.3\nrho 1\n"
                       "held ends\npushed 0 -10\nload rises\ntime 1\nend 2\n");
        read_file();
        struct ladder_state *s = ladder_solve(
            &file.scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
        const int middle = s->mesh->n_vertex / 2;
        u[k] = s->u[2 * middle + 1];
        ck_assert(ladder_first(&file.scene).rung == LINEAR_PLANE);
        close_to(s->u[2 * s->mesh->n], 0.0, 1e-300); /* the right end */
        ladder_free(s);
        unlink(path);
    }
    ck_assert(u[0] < -1e-3);
    close_to(u[1], u[0], 1e-12);
}

#define GOOD "width 1\nheight 1\nE 1\nnu 0\nrho 1\nheld left\n"

/* One line, status 2: the number of the line, the word, what is allowed. */
static void what_is_wrong_is_named(void)
{
    static const struct {
        const char *text, *says;
    } is[] = {
        {"width 1\nwdith 2\n", "line 2: 'wdith' is no word of a scene"},
        {"width 1\nheight 0\n", "line 2: height '0': must be a number from"},
        {"width 1 2\n", "line 1: width: '2' is one value too many"},
        {"nu 0.5\n", "nu '0.5': must be a number from 0 to 0.499"},
        {"E 1e3x\n", "E '1e3x': must be"}, {"E\n", "E '': must be"},
        {"E nan\n", "E 'nan': must be"}, {"\nE inf\n", "line 2: E 'inf'"},
        {"gravity 1\n", "gravity '': must be two numbers"},
        {"held right\n", "held 'right': must be one of: left ends"},
        {"held nothing\n", "nothing is held cannot stand"},
        {"rho 1\n\nrho 2\n", "line 3: 'rho' was said in line 1"},
        {"width 1\n", "does not say 'height'"},
        {"width 1\nheight 1\nE 1\nnu 0\nrho 1\n", "nothing holds cannot stand"},
        {GOOD, "nothing is loaded"},
        {GOOD "gravity 0 1\nload rises\nend 2\n", "line 8: a load that rises "
                                                  "needs 'time'"},
        {GOOD "gravity 0 1\nload swings\nperiod 2\n", "swings needs 'end'"},
        {GOOD "gravity 0 1\nload swings\nend 2\n", "swings needs 'period'"},
        {GOOD "gravity 0 1\nload swings\nperiod 2\nend 2\ntime 1\n",
         "line 11: a load that swings has no 'time': load must be one of: "
         "rises"},
        {GOOD "gravity 0 1\nload rises\ntime 2\nend 2\nperiod 1\n",
         "line 11: a load that rises has no 'period': load must be one of: "
         "swings"},
        {GOOD "gravity 0 1\nquantity stress\n", "line 8: quantity 'stress': "
         "must be one of: displacement rms force"},
        {GOOD "gravity 0 1\nquantity force\n",
         "line 8: quantity 'force' is that of a hand, and none pulls"},
        {GOOD "gravity 0 1\npulled 1 0\nquantity force\nload rises\n"
         "time 1\nend 1\n", "line 9: quantity 'force' in motion is not"},
        {"width 9\nheight 0.5\nE 1\nnu 0\nrho 1\nheld left\n",
         "line 2: width over height is 18"},
        {"width 1\nheight 1\nE 1\nnu 0\nrho 1\nheld ends\npulled 1 0\n",
         "line 7: the right end is held"},
        {"width 1\nload\tstands\n\001\n", "line 3: '?' is no word"},
        {"width 5cm\n", "width '5cm': must be a number from 1e-06 to 1000 m"},
        {"width 1\n", "'height': must be a number from 1e-06 to 1000 m"},
        {GOOD "gravity 0 1\ntime 3\n", "line 8: a load that stands has no "
                                       "'time'"},
        {GOOD "gravity 0 1\nload rises\ntime 3\nend 1\n",
         "line 10: end '1': must be at least 3 s"},
        {GOOD "gravity 0 1\nload swings\nperiod 6\nend 1.4\n",
         "line 10: end '1.4': must be at least 1.5 s"},
    };
    for (int k = 0; k < COUNT(is); k++) {
        write_file(is[k].text);
        const struct outcome o = outcome_of(read_file);
        ck_assert_msg(o.status == 2 && strstr(o.err, is[k].says),
                      "%s: status %d, %s", is[k].text, o.status, o.err);
        ck_assert(strchr(o.err, '\n') == o.err + strlen(o.err) - 1);
        unlink(path);
    }
    const struct outcome o = outcome_of(read_file);
    ck_assert(o.status == 2 && strstr(o.err, "there is no such file"));
}

/* A folder, a pipe that nobody writes to, a byte that is 0: none is waited for
 * or taken for something else; the mark before a text of Windows is skipped. */
static void only_a_text_is_read(void)
{
    snprintf(path, sizeof path, "/dev/null");
    ck_assert(strstr(outcome_of(read_file).err, "is not a plain file"));
    snprintf(path, sizeof path, "/tmp/unit-%ld.text.scene", (long)getpid());
    ck_assert(mkdir(path, 0700) == 0);
    ck_assert(strstr(outcome_of(read_file).err, "is not a plain file"));
    ck_assert(rmdir(path) == 0 && mkfifo(path, 0600) == 0);
    const struct outcome o = outcome_of(read_file);
    ck_assert(o.status == 2 && strstr(o.err, "is not a plain file"));
    unlink(path);
    write_file("width 1\n");
    FILE *more = fopen(path, "a");
    ck_assert(more && fwrite("rho\0 1\n", 1, 7, more) == 7 &&
              fclose(more) == 0);
    ck_assert(strstr(outcome_of(read_file).err, "line 2: has a byte that is"));
    unlink(path);
    write_file("\357\273\277" GOOD "gravity 0 1");
    read_file();
    close_to(file.metre, 0.5, 1e-16);
    unlink(path);
}

/* What a form shows of a line is what the file is refused by. */
static void a_line_is_what_it_says(void)
{
    char text[128], says[128];
    const struct scene_line *line;
    int k = 0;
    for (; (line = scene_file_line(k)); k++) {
        snprintf(text, sizeof text, "%s 1e99 no\n", line->word);
        if (line->words)
            snprintf(says, sizeof says, "must be one of:%s", line->words);
        else
            snprintf(says, sizeof says, "%s '1e99': must be %s from %g to %g%s",
                     line->word, line->n == 2 ? "two numbers" : "a number",
                     line->least, line->most, line->unit);
        write_file(text);
        const struct outcome o = outcome_of(read_file);
        ck_assert_msg(o.status == 2 && strstr(o.err, says), "%s", o.err);
        unlink(path);
        /* GOOD has all that must be there, and nothing else */
        ck_assert(!line->must == !strstr(GOOD, line->word));
    }
    ck_assert(k >= 12 && !scene_file_line(-1));
}

/* What no word may have in it becomes _; the ending goes. */
static void a_name_is_one_word(void)
{
    char odd[sizeof path];
    write_file(GOOD "gravity 0 1\n");
    snprintf(odd, sizeof odd, "/tmp/unit-%ld a\tb.c.scene", (long)getpid());
    ck_assert(rename(path, odd) == 0);
    memcpy(path, odd, sizeof path);
    read_file();
    unlink(path);
    const char *end = strchr(file.name, '_');
    ck_assert(end && strncmp(file.name, "unit-", 5) == 0);
    ck_assert_str_eq(end, "_a_b.c");
}

/* A beam's first swing has 32 steps, of the period that its weight bends it
 * with; so has the load's time 16, if that is shorter. */
static void a_step_is_a_part_of_a_swing(void)
{
    static const char *const how[] = {
        "held left\nload rises\ntime 3\nend 30\n",
        "held ends\nload rises\ntime 3\nend 3\n",
        "held left\nload rises\ntime 0.05\nend 0.4\n"};
    for (int k = 0; k < 3; k++) {
        char text[200];
        snprintf(text, sizeof text, "width 2\nheight 0.2\nE 1000\nnu 0.3\n"
                 "rho 1\ngravity 0 -1e-4\n%s", how[k]);
        write_file(text);
        read_file();
        unlink(path);
        struct ladder_state *s = ladder_solve(
            &file.scene, (struct ladder_model){LINEAR_PLANE, 0, 1});
        const double period = 2.0 * acos(-1.0) / estimate_frequency(s);
        const double steps = (k < 2 ? period : file.scene.T) /
                             file.scene.dt;
        close_to(steps, k < 2 ? 32.0 : 16.0, 2.0);
        ladder_free(s);
    }
}

static void a_long_line_is_refused(void)
{
    char text[600];
    memset(text, ' ', sizeof text);
    memcpy(text, "width 1", 7);
    text[sizeof text - 1] = '\0';
    text[sizeof text - 2] = '\n';
    write_file(text);
    const struct outcome o = outcome_of(read_file);
    ck_assert(o.status == 2 && strstr(o.err, "line 1: is longer than"));
    unlink(path);
}

UNIT_MAIN("scenes",
    LAW(a_file_is_scaled),
    LAW(units_do_not_matter),
    LAW(what_is_wrong_is_named),
    LAW(only_a_text_is_read),
    LAW(a_line_is_what_it_says),
    LAW(a_name_is_one_word),
    LAW(a_step_is_a_part_of_a_swing),
    LAW(a_long_line_is_refused))
