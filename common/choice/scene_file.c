/* scene_file.c - see scene_file.h. */
#include "choice/scene_file.h"

#include "base/options.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { LONGEST = 256, MOST_STEPS = 400, LEAST_STEPS = 40 };

enum {
    WIDTH, HEIGHT, YOUNG, POISSON, DENSITY, GRAVITY, HELD, PULLED, PUSHED, LOAD,
    TIME, PERIOD, END, QUANTITY, LINES
};
static const struct scene_line lines[LINES] = {
    [WIDTH] = {"width", 1, 1e-6, 1e3, NULL, 1, " m"},
    [HEIGHT] = {"height", 1, 1e-6, 1e3, NULL, 1, " m"},
    [YOUNG] = {"E", 1, 1e-3, 1e12, NULL, 1, " N/m^2"},
    [POISSON] = {"nu", 1, 0.0, 0.499, NULL, 1, ""},
    [DENSITY] = {"rho", 1, 1e-3, 1e5, NULL, 1, " kg/m^3"},
    [GRAVITY] = {"gravity", 2, -1e4, 1e4, NULL, 0, " m/s^2"},
    [HELD] = {"held", 0, 0, 0, " left ends ", 1, ""},
    [PULLED] = {"pulled", 2, -1e12, 1e12, NULL, 0, " N/m^2"},
    [PUSHED] = {"pushed", 2, -1e12, 1e12, NULL, 0, " N/m^2"},
    [LOAD] = {"load", 0, 0, 0, " stands rises swings ", 0, ""},
    [TIME] = {"time", 1, 1e-9, 1e6, NULL, 0, " s"},
    [PERIOD] = {"period", 1, 1e-9, 1e6, NULL, 0, " s"},
    [END] = {"end", 1, 1e-9, 1e6, NULL, 0, " s"},
    [QUANTITY] = {"quantity", 0, 0, 0, " displacement rms force ", 0, ""},
};

struct said {
    double value[LINES][2]; /* of words their number */
    int at[LINES];          /* line of the file; 0: it says nothing */
};

/* Print "PROGRAM: FILE: line 3: MESSAGE"; line 0: the file as a whole. */
_Noreturn static void refuse(const char *program, const char *path, int line,
                             const char *format, ...)
{
    char message[LONGEST], words[2 * LONGEST], where[32] = "";
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    if (line) snprintf(where, sizeof where, "line %d: ", line);
    snprintf(words, sizeof words, "%.200s: %s%s", path, where, message);
    options_refuse(program, words);
}

/* Return the number of a word in " a b c ", or -1. */
static int number_of(const char *words, const char *word)
{
    int k = 0;
    for (const char *w = words + 1; *w; k++) {
        const size_t length = strcspn(w, " ");
        if (strlen(word) == length && strncmp(w, word, length) == 0) return k;
        w += length + 1;
    }
    return -1;
}

static void read_line(const char *program, const char *path, int line,
                      char *text, struct said *said)
{
    const char *blank = " \t\r\n";
    const char *word = strtok(text, blank);
    if (!word) return;
    int k = 0;
    while (k < LINES && strcmp(lines[k].word, word) != 0) k++;
    if (k == LINES)
        refuse(program, path, line, "'%.40s' is no word of a scene: width "
               "height E nu rho gravity held pulled pushed load time period "
               "end quantity", word);
    if (said->at[k])
        refuse(program, path, line, "'%s' was said in line %d", word,
               said->at[k]);
    said->at[k] = line;
    for (int i = 0; i < (lines[k].words ? 1 : lines[k].n); i++) {
        const char *value = strtok(NULL, blank);
        char *end = NULL;
        if (!value) value = "";
        if (lines[k].words) {
            said->value[k][0] = number_of(lines[k].words, value);
            if (said->value[k][0] < 0.0 && k == HELD &&
                strcmp(value, "nothing") == 0)
                refuse(program, path, line, "a body of which nothing is held "
                       "cannot stand: held must be one of:%s",
                       lines[k].words);
            if (said->value[k][0] < 0.0)
                refuse(program, path, line, "%s '%.40s': must be one of:%s",
                       word, value, lines[k].words);
            continue;
        }
        said->value[k][i] = strtod(value, &end);
        if (end == value || *end || !(said->value[k][i] >= lines[k].least &&
                                      said->value[k][i] <= lines[k].most))
            refuse(program, path, line,
                   "%s '%.40s': must be %s from %g to %g%s", word, value,
                   lines[k].n == 2 ? "two numbers" : "a number",
                   lines[k].least, lines[k].most, lines[k].unit);
    }
    const char *rest = strtok(NULL, blank);
    if (rest)
        refuse(program, path, line, "%s: '%.40s' is one value too many; a "
               "comment begins with #", word, rest);
}

const struct scene_line *scene_file_line(int k)
{
    return k >= 0 && k < LINES ? &lines[k] : NULL;
}

/* The last part of the path, without its ending. */
static void name_of(const char *path, char name[64])
{
    const char *slash = strrchr(path, '/');
    snprintf(name, 64, "%s", slash ? slash + 1 : path);
    char *dot = strrchr(name, '.');
    if (dot && dot != name) *dot = '\0';
    for (char *c = name; *c; c++)
        if (!isgraph((unsigned char)*c)) *c = '_';
}

/* Return the time step: 16 to the shortest of the load's time, half the period
 * of the first swing as a beam (3.52 of its modulus) or, held at both ends,
 * 22.4, and that of the first one along the axis; for a long scene fewer. */
static double time_step(const struct ladder_scene *scene)
{
    const double modulus = 1000.0 / (1.0 - scene->nu * scene->nu);
    const double root = scene->held == LADDER_ENDS ? 22.4 : 3.52;
    const double bends =
        root / scene->slender * sqrt(modulus / 3.0) / 2.0; /* 2 omega, L = 2 */
    const double along = acos(-1.0) / 4.0 * sqrt(modulus);
    const double shortest =
        fmin(scene->T, 2.0 * acos(-1.0) / fmin(bends, along));
    return scene->end / ceil(fmin(MOST_STEPS,
                                  fmax(LEAST_STEPS,
                                       16.0 * scene->end / shortest)));
}

/* Ask for the lines of a moving load, and refuse them of a standing one. */
static void ask_time(const char *program, const char *path,
                     const struct said *said, enum ladder_time time)
{
    static const char *const how[] = {"stands", "rises", "swings"};
    const int belongs[LINES] = {[TIME] = time == RISES,
                                       [PERIOD] = time == SWINGS,
                                       [END] = time != STANDS};
    for (int k = TIME; k <= END; k++)
        if (belongs[k] && !said->at[k])
            refuse(program, path, said->at[LOAD], "a load that %s needs '%s'",
                   how[time], lines[k].word);
        else if (!belongs[k] && said->at[k])
            refuse(program, path, said->at[k], "a load that %s has no '%s': "
                   "load must be one of:%s", how[time], lines[k].word,
                   k == TIME ? " rises" : k == PERIOD ? " swings"
                                                      : " rises swings");
}

/* The force in the hand: there must be one, and in motion nothing else. */
static void ask_quantity(const char *program, const char *path,
                         const struct said *said,
                         const struct ladder_scene *scene)
{
    if (scene->quantity != LADDER_HAND || ladder_has_hand(scene)) return;
    struct ladder_scene rest = *scene;
    rest.time = STANDS;
    if (!ladder_has_hand(&rest))
        refuse(program, path, said->at[QUANTITY], "quantity 'force' is that of "
               "a hand, and none pulls or pushes: quantity must be one of: "
               "displacement rms");
    refuse(program, path, said->at[QUANTITY], "quantity 'force' in motion is "
           "not known apart from the weight: gravity must be 0 0");
}

static void scene_of(const char *program, const char *path, int finest,
                     const struct said *said, struct scene_file *file)
{
    struct ladder_scene *scene = &file->scene;
    file->metre = said->value[WIDTH][0] / 2.0;
    file->pascal = said->value[YOUNG][0] / 1000.0;
    file->second =
        file->metre * sqrt(said->value[DENSITY][0] / file->pascal);
    *scene = (struct ladder_scene){
        .name = file->name,
        .slender = said->value[WIDTH][0] / said->value[HEIGHT][0],
        .nu = said->value[POISSON][0],
        .held = (enum ladder_held)said->value[HELD][0],
        .time = (enum ladder_time)said->value[LOAD][0],
        .finest = finest,
        .quantity = (enum ladder_quantity)said->value[QUANTITY][0]};
    if (!(scene->slender >= 0.5 && scene->slender <= 16.0))
        refuse(program, path, said->at[HEIGHT], "width over height is %g: must "
               "be from 0.5 to 16%s", scene->slender, scene->slender < 0.5
               ? " (a body that stands has its axis as width)" : "");
    int loaded = 0;
    for (int i = 0; i < 2; i++) {
        scene->weight[i] = said->value[GRAVITY][i] * said->value[DENSITY][0] *
                           file->metre / file->pascal;
        scene->pull[i] = said->value[PULLED][i] / file->pascal;
        scene->push[i] = said->value[PUSHED][i] / file->pascal;
        if (scene->held == LADDER_ENDS && scene->pull[i] != 0.0)
            refuse(program, path, said->at[PULLED], "the right end is held and "
                   "cannot be pulled: push, or held left");
        loaded += scene->weight[i] != 0.0 || scene->pull[i] != 0.0 ||
                  scene->push[i] != 0.0;
    }
    if (!loaded)
        refuse(program, path, 0, "nothing is loaded: gravity, pulled or pushed "
               "must not be 0");
    ask_time(program, path, said, scene->time);
    ask_quantity(program, path, said, scene);
    if (scene->time == STANDS) return;
    const int swings = scene->time == SWINGS;
    const double full =
        swings ? said->value[PERIOD][0] / 4.0 : said->value[TIME][0];
    if (said->value[END][0] < full)
        refuse(program, path, said->at[END], "end '%g': must be at least %g s, "
               "when the load is full", said->value[END][0], full);
    scene->T = (swings ? full * 2.0 / acos(-1.0) : full) / file->second;
    scene->end = said->value[END][0] / file->second;
    scene->dt = time_step(scene);
}

void scene_file_read(const char *program, const char *path, int finest,
                     struct scene_file *file)
{
    char text[LONGEST];
    struct said said = {.at = {0}};
    struct stat is;
    if (stat(path, &is) != 0) refuse(program, path, 0, "there is no such file");
    if (!S_ISREG(is.st_mode)) /* a pipe would be waited for */
        refuse(program, path, 0, "is not a plain file");
    FILE *in = fopen(path, "r");
    if (!in) refuse(program, path, 0, "cannot be read");
    for (int line = 1; fgets(text, sizeof text, in); line++) {
        if (!strchr(text, '\n') && !feof(in))
            refuse(program, path, line, strlen(text) < sizeof text - 1
                   ? "has a byte that is 0: is this a text?"
                   : "is longer than %d characters", LONGEST - 2);
        /* what some editors begin a text with */
        const int mark = line == 1 && strncmp(text, "\357\273\277", 3) == 0;
        text[strcspn(text, "#")] = '\0';
        read_line(program, path, line, text + (mark ? 3 : 0), &said);
    }
    const int bad = ferror(in);
    fclose(in);
    if (bad) refuse(program, path, 0, "cannot be read");
    for (int k = 0; k < LINES; k++)
        if (lines[k].must && !said.at[k]) {
            if (k == HELD)
                refuse(program, path, 0, "does not say 'held', and what "
                       "nothing holds cannot stand: must be one of:%s",
                       lines[k].words);
            refuse(program, path, 0, "does not say '%s': must be a number from "
                   "%g to %g%s", lines[k].word, lines[k].least, lines[k].most,
                   lines[k].unit);
        }
    name_of(path, file->name);
    scene_of(program, path, finest, &said, file);
}
