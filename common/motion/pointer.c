/* pointer.c - see pointer.h. */
#include "motion/pointer.h"

#include "base/status.h"

#include <ctype.h>
#include <errno.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void pointers_add(struct pointers *pointers, struct pointer pointer)
{
    const size_t n = (size_t)pointers->n;
    if ((n & (n - 1)) == 0) { /* full: 1, 2, 4, ... */
        const size_t size = (n ? 2 * n : 1) * sizeof *pointers->frame;
        struct pointer *longer = realloc(pointers->frame, size);
        if (!longer) die("no memory for %d frames", pointers->n);
        pointers->frame = longer;
    }
    pointers->frame[pointers->n++] = pointer;
}

void pointers_free(struct pointers *pointers)
{
    free(pointers->frame);
    *pointers = (struct pointers){0, NULL};
}

/* ---- scripts ------------------------------------------------------------- */

struct pointers pointers_pull(double speed)
{
    struct pointers all = {0, NULL};
    for (int k = 0; k < 60; k++)
        pointers_add(&all, (struct pointer){1.0 + speed * fmin(k, 40) / 30.0,
                                            0.0, 1, '.'});
    return all;
}

struct pointers pointers_hard(void)
{
    static const struct { /* where the hand is at these frames */
        int frame;
        double x, y;
    } way[] = {{0, 1.0, 0.0},    {20, 2.2, 0.0},   {30, 2.2, 0.9},
               {40, 2.2, -0.9},  {50, 2.2, 0.9},   {60, 2.2, -0.9},
               {64, -0.5, 0.0},  {90, -1.8, 0.2},  {110, -1.8, -0.6},
               {116, 1.6, -0.6}, {120, 1.6, 1.6},  {150, 0.2, 1.9},
               {156, 2.6, -1.5}, {180, -0.4, -0.4}};
    struct pointers all = {0, NULL};
    for (int k = 0, leg = 0; k < 180; k++) {
        while (k >= way[leg + 1].frame) leg++;
        const double s = (double)(k - way[leg].frame) /
                         (way[leg + 1].frame - way[leg].frame);
        pointers_add(&all, (struct pointer){
            way[leg].x + s * (way[leg + 1].x - way[leg].x),
            way[leg].y + s * (way[leg + 1].y - way[leg].y), 1, '.'});
    }
    for (int k = 0; k < 120; k++)
        pointers_add(&all, (struct pointer){-0.4, -0.4, 0, '.'});
    return all;
}

struct pointers pointers_mad(int seed, int frames)
{
    struct pointers all = {0, NULL};
    struct pointer now = {1.0, 0.0, 0, '.'};
    double target[2] = {1.0, 0.0}, speed = 0.1;
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    if (!random) die("no memory for random numbers");
    gsl_rng_set(random, (unsigned long)seed);
    for (int k = 0; k < frames; k++) {
        const double chance = gsl_rng_uniform(random);
        if (chance < 0.06) { /* somewhere else, slowly or in one leap */
            for (int i = 0; i < 2; i++)
                target[i] = 4.0 * gsl_rng_uniform(random) - 2.0;
            speed = 0.02 * pow(200.0, gsl_rng_uniform(random));
        } else if (chance < 0.10) {
            now.down = !now.down;
        } else if (chance < 0.101) { /* far out of the window */
            target[0] = 1e3 * (gsl_rng_uniform(random) - 0.5);
        }
        const double d[2] = {target[0] - now.x, target[1] - now.y};
        const double way = hypot(d[0], d[1]);
        const double s = way > speed ? speed / way : 1.0;
        now.x += s * d[0];
        now.y += s * d[1];
        pointers_add(&all, now);
    }
    gsl_rng_free(random);
    now.down = 0;
    for (int k = 0; k < 120; k++) pointers_add(&all, now);
    return all;
}

/* ---- files --------------------------------------------------------------- */

/* Return the path in a message of one line. */
static const char *shown(const char *path)
{
    char *text = allocate(strlen(path) + 1, 1);
    for (size_t k = 0; path[k]; k++)
        text[k] = (char)(iscntrl((unsigned char)path[k]) ? '?' : path[k]);
    return text;
}

_Noreturn static void refuse(const char *path, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "error: %s: ", shown(path));
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(2);
}

static struct pointers read_file(const char *path)
{
    struct pointers all = {0, NULL};
    char text[128], rest;
    FILE *file = fopen(path, "r");
    if (!file) refuse(path, "%s", strerror(errno));
    while (fgets(text, sizeof text, file)) {
        const int line = all.n + 1;
        struct pointer p;
        if (!strchr(text, '\n') && !feof(file))
            refuse(path, "line %d is longer than %d characters", line,
                   (int)sizeof text - 2);
        if (sscanf(text, "%lf %lf %1d %c %c", &p.x, &p.y, &p.down, &p.key,
                   &rest) != 4 ||
            !isfinite(p.x) || !isfinite(p.y) || (p.down != 0 && p.down != 1) ||
            !strchr(POINTER_KEYS, p.key))
            refuse(path, "line %d must be: x y down key, two finite numbers "
                   "(m), 0 or 1, and one of %s", line, POINTER_KEYS);
        pointers_add(&all, p);
    }
    const int bad = ferror(file);
    fclose(file);
    if (bad) refuse(path, "cannot be read");
    if (all.n == 0) refuse(path, "has no line; a frame is: x y down key");
    return all;
}

struct pointers pointers_named(const char *name, double speed, int seed)
{
    if (strcmp(name, "pull") == 0) return pointers_pull(speed);
    if (strcmp(name, "hard") == 0) return pointers_hard();
    if (strcmp(name, "mad") == 0) return pointers_mad(seed, 600);
    return read_file(name);
}

/* A new file beside path, whose name becomes `beside`, with the permissions
 * that path has or would get. */
static FILE *open_beside(char *beside, const struct stat *old)
{
    const int file = mkstemp(beside);
    if (file < 0) return NULL;
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(file, old ? old->st_mode & 0777 : 0666 & ~mask);
    return fdopen(file, "w");
}

void pointers_write(const struct pointers *pointers, const char *path)
{
    struct stat old;
    const int is_there = lstat(path, &old) == 0;
    const int is_replaced = !is_there || S_ISREG(old.st_mode);
    const size_t size = strlen(path) + 8;
    char *beside = allocate(size, 1);
    snprintf(beside, size, "%s.XXXXXX", path);
    signal(SIGXFSZ, SIG_IGN); /* a limit of size is an error, too */
    FILE *file = is_replaced ? open_beside(beside, is_there ? &old : NULL)
                             : fopen(path, "w");
    int bad = !file;
    for (int k = 0; k < pointers->n && !bad; k++) {
        const struct pointer *p = &pointers->frame[k];
        bad = fprintf(file, "%.17g %.17g %d %c\n", p->x, p->y, p->down,
                      p->key) < 0;
    }
    if (file) bad |= fclose(file) != 0;
    if (is_replaced) bad = bad || rename(beside, path) != 0;
    if (bad) {
        const char *why = strerror(errno);
        if (file && is_replaced) remove(beside);
        die("%s cannot be written: %s", shown(path), why);
    }
    free(beside);
}
