/* hand.c - see hand.h. */
#include "motion/hand.h"

#include "base/clock.h"
#include "base/options.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifndef __wasm__
#include <sys/resource.h>
#endif

#ifndef HAND_MEMORY
#define HAND_MEMORY 1000000L /* kB that a slot may leak */
#endif
enum { FRAME_SECONDS = 60, BEFORE = 6, NUMBERS = 8, KEYED = 37 };

struct hand {
    const char *whose, *keys;
    const char *record, *shot, *svg;
    struct view *view; /* NULL: none */
    struct pointers input;
    int scripted; /* the input was given; else each frame adds to it */
    int k, late;  /* frames begun; with a window, those of more than 1/30 s */
    int began;    /* the table */
    double start; /* of this frame (s) */
};

/* The state that a handler of a signal may read. */
static char said[8], slot_now[8]; /* the lesson; the slot that is called */
static volatile sig_atomic_t open_now;

/* Stop: `helps`, unless NULL, is a goal that does; `said` is written behind
 * it. */
static _Noreturn void stop(const char *verdict, const char *why,
                           const char *helps)
{
    char line[256];
    const char *slot = slot_now[0] ? slot_now : "none";
    const char *part[] = {"live-", said, ": ", verdict, " (slot ", slot, "): ",
                          why, helps ? helps : "", helps ? said : "", "\n"};
    size_t n = 0;
    for (int k = 0; k < COUNT(part); k++)
        for (const char *c = part[k]; *c && n < sizeof line; c++)
            line[n++] = *c;
    if (write(STDERR_FILENO, line, n) < 0) _exit(1);
    _exit(1);
}

/* Stop if the slot that is called has leaked: the largest memory of the program
 * has grown with it, time and again. */
static void weigh(void)
{
#ifndef __wasm__
    static long grown[16], most; /* kB, of each slot and of all */
    struct rusage used = {0};
    getrusage(RUSAGE_SELF, &used);
#ifdef __APPLE__ /* bytes, and without a name where only POSIX is asked for */
    const long peak = used.ru_opaque[0] / 1024;
#else
    const long peak = used.ru_maxrss;
#endif
    const size_t n = strlen(slot_now);
    long *slot = &grown[n ? (slot_now[n - 1] - 'a') & 15 : 15];
    *slot += peak - most;
    most = peak;
    if (n && *slot > HAND_MEMORY)
        stop("CRASHED", "it leaks, more than a gigabyte by now", NULL);
#endif
}

static void caught(int signal)
{
    if (signal == SIGALRM)
        stop("TIMEOUT", "this frame does not end", NULL);
    weigh();
    stop("CRASHED", "a signal ended it; the line: ", "make debug-");
}

static void left(void)
{
    if (!open_now || !slot_now[0]) return;
    weigh();
    stop("CRASHED", "it ended the program", NULL);
}

void hand_slot(const char *slot)
{
    if (slot && strcmp(slot, slot_now) == 0) return;
    weigh();
    snprintf(slot_now, sizeof slot_now, "%s", slot ? slot : "");
}

struct hand *hand_open(const char *lesson, const char *whose,
                       const char *keys, int argc, char *argv[])
{
    struct hand *hand = allocate(1, sizeof *hand);
    const char *input = NULL;
    int seed = 1, frames = 600;
    const struct option options[] = {
        {"input", .text = &input, .unit = "a file's name, pull, hard or mad",
         .help = "what the pointer does; without it the mouse"},
        {"seed", .integer = &seed, .min = 1, .max = 1000000, .help = "of mad"},
        {"frames", .integer = &frames, .min = 1, .max = 1000000,
         .help = "of mad"},
        {"record", .text = &hand->record, .unit = "a file's name",
         .help = "where the input is written to"},
        {"shot", .text = &hand->shot, .unit = "a file's name",
         .help = "the last picture of the window, as BMP"},
        {"picture", .text = &hand->svg, .unit = "a file's name",
         .help = "the last picture as SVG"},
    };
    char name[32];
    snprintf(name, sizeof name, "live-%s", lesson);
    options_parse(name, options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    hand->whose = whose;
    hand->keys = keys;
    hand->scripted = input != NULL;
    if (input && strcmp(input, "mad") == 0)
        hand->input = pointers_mad(seed, frames);
    else if (input)
        hand->input = pointers_named(input, 3.0, seed);
    const int n_key = (int)strlen(keys);
    if (input && (strcmp(input, "hard") == 0 || strcmp(input, "mad") == 0))
        for (int k = KEYED; k < hand->input.n; k += KEYED)
            hand->input.frame[k].key = keys[(k / KEYED - 1) % n_key];
    snprintf(name, sizeof name, "Lesson %s in your hand", lesson);
    hand->view = view_open(name, !input || hand->shot);
    if (!hand->view && !input)
        options_refuse("live", "without a window it needs --input");
#ifdef RLIMIT_DATA
    const rlim_t most = (rlim_t)2 << 30; /* bytes, should one call leak */
    if (hand->view) setrlimit(RLIMIT_DATA, &(struct rlimit){most, most});
#endif
    snprintf(said, sizeof said, "%s", lesson);
    static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT,
                                  SIGALRM};
    for (int k = 0; k < COUNT(signals); k++) {
        struct sigaction act = {.sa_handler = caught};
        sigaction(signals[k], &act, NULL);
    }
    open_now = 1;
    atexit(left);
    return hand;
}

int hand_next(struct hand *hand, struct pointer *pointer)
{
    struct pointer read = {.key = '.'};
    hand_slot(NULL);
    alarm(0);
    if (hand->view && !view_next(hand->view, hand->keys, &read)) return 0;
    if (!hand->scripted) pointers_add(&hand->input, read);
    if (hand->k >= hand->input.n) return 0;
    *pointer = hand->input.frame[hand->k++];
    pointer->x = fmax(-2.7, fmin(2.7, pointer->x));
    pointer->y = fmax(-2.1, fmin(2.1, pointer->y));
    hand->start = clock_seconds();
    alarm(FRAME_SECONDS);
    return 1;
}

/* ---- a picture as SVG ------------------------------------------------- */

static double across(double x) { return 280.0 + 100.0 * x; }
static double down(double y) { return 220.0 - 100.0 * y; }

/* Colour as view.h has it: blue, white, orange; magenta where it is not
 * positive. */
static void colour(double value, char text[16])
{
    const double s = fmax(-1.0, fmin(1.0, log2(value > 0.0 ? value : 1.0)));
    const double *c = (double[2][3]){{33, 102, 196}, {235, 120, 20}}[s > 0.0];
    int rgb[3] = {214, 0, 190};
    for (int k = 0; k < 3 && value > 0.0; k++)
        rgb[k] = (int)(250.0 + fabs(s) * (c[k] - 250.0)); /* from white */
    snprintf(text, 16, "#%02x%02x%02x", rgb[0] & 255, rgb[1] & 255,
             rgb[2] & 255);
}

static void print_svg(FILE *file, const struct view_picture *p)
{
    char fill[16];
    fprintf(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                  "viewBox=\"0 0 560 440\" font-family=\"sans-serif\">\n"
                  "<rect width=\"560\" height=\"440\" fill=\"white\"/>\n");
    for (int k = 0; k < 2 * p->n_triangle; k++) { /* the inverted ones last */
        const int e = k % p->n_triangle;
        if ((p->value[e] > 0.0) != (k < p->n_triangle)) continue;
        colour(p->value[e], fill);
        fprintf(file, "<polygon stroke=\"#777\" fill=\"%s\" points=\"", fill);
        for (int a = 0; a < 3; a++) {
            const double *x = &p->x[2 * p->triangle[3 * e + a]];
            fprintf(file, "%.2f,%.2f ", across(x[0]), down(x[1]));
        }
        fprintf(file, "\"/>\n");
    }
    for (int a = 0; a < p->n_point; a++)
        if (p->held && p->held[a])
            fprintf(file, "<rect x=\"%.2f\" y=\"%.2f\" width=\"5\" "
                          "height=\"5\"/>\n", across(p->x[2 * a]) - 2.5,
                    down(p->x[2 * a + 1]) - 2.5);
    for (int k = 0; k < p->n_arrow; k++) {
        const double *a = p->arrow[k];
        fprintf(file, "<path stroke=\"black\" stroke-width=\"2\" "
                      "d=\"M%.2f,%.2fL%.2f,%.2f\"/>\n"
                      "<circle r=\"4\" cx=\"%.2f\" cy=\"%.2f\"/>\n",
                across(a[0]), down(a[1]), across(a[2]), down(a[3]),
                across(a[2]), down(a[3]));
    }
    if (p->n_curve) fprintf(file, "<polyline fill=\"none\" stroke=\"black\" "
                                  "points=\"");
    for (int k = 0; k < p->n_curve; k++)
        fprintf(file, "%.2f,%.2f ", across(p->curve[2 * k]),
                down(p->curve[2 * k + 1]));
    if (p->n_curve) fprintf(file, "\"/>\n");
    double y = 18.0;
    for (const char *c = p->caption; *c;) {
        const int length = (int)strcspn(c, "\n");
        fprintf(file, "<text x=\"8\" y=\"%.0f\" font-size=\"13\">%.*s</text>\n",
                y, length, c);
        c += length + (c[length] == '\n');
        y += 17.0;
    }
    fprintf(file, "</svg>\n");
}

/* ---- a frame ---------------------------------------------------------- */

/* The sum of all numbers in the picture. */
static double sum(const struct view_picture *p)
{
    double all = 0.0;
    for (int r = 0; r < 2 * p->n_point; r++) all += p->x[r];
    for (int e = 0; e < p->n_triangle; e++) all += p->value[e];
    for (int k = 0; k < p->n_arrow; k++)
        for (int i = 0; i < 4; i++) all += p->arrow[k][i];
    for (int k = 0; k < 2 * p->n_curve; k++) all += p->curve[k];
    return all;
}

static struct cell cell_of(double x)
{
    if (!isfinite(x)) return cell_if(0, x);
    return x != floor(x) ? cell_rounded(6, x) : cell_number(x);
}

void hand_draw(struct hand *hand, struct view_picture *picture,
               enum status status, const char *columns, const double number[])
{
    const double seconds = clock_seconds() - hand->start, seen = sum(picture);
    const struct pointer *p = &hand->input.frame[hand->k - 1];
    struct cell row[BEFORE + NUMBERS] = {
        cell_number(hand->k), cell_number(p->x), cell_number(p->y),
        cell_number(p->down), cell_word(status_name(status)), cell_of(seen)};
    int n = BEFORE;
    if (!isfinite(seen))
        stop("NONFINITE", "what it returned is no number", NULL);
    hand_slot(NULL);
    picture->alarm = status != OK;
    if (!hand->began++) {
        char names[200];
        snprintf(names, sizeof names, "frame x y down status seen %s", columns);
        table_begin("frames", names);
    }
    for (const char *c = columns; c && n < COUNT(row); c = strchr(c + 1, ' '))
        row[n] = cell_of(number[n - BEFORE]), n++;
    table_row_of(n, row);
    char late[40] = "";
    hand->late += hand->view && seconds > 1.0 / 30.0;
    if (hand->late)
        snprintf(late, sizeof late, "\n%d of %d frames late", hand->late,
                 hand->k);
    const size_t length = strlen(picture->caption);
    snprintf(picture->caption + length, sizeof picture->caption - length,
             "%s\n[r] reset   [space] stop   [q] close\n%s", late, hand->whose);
    const int last = hand->scripted && hand->k == hand->input.n;
    if (hand->view)
        view_draw(hand->view, picture, seconds, last ? hand->shot : NULL);
    if (!hand->svg || !last) return;
    FILE *file = fopen(hand->svg, "w");
    if (!file) die("%s cannot be written", hand->svg);
    print_svg(file, picture);
    if (fclose(file) != 0) die("%s cannot be written", hand->svg);
}

int hand_close(struct hand *hand)
{
    alarm(0);
    open_now = 0;
    if (hand->began) table_end();
    if (hand->record) pointers_write(&hand->input, hand->record);
    if (hand->view) view_close(hand->view);
    pointers_free(&hand->input);
    free(hand);
    return table_finish();
}

/* ---- for scenes ------------------------------------------------------- */

void hand_arrow(struct view_picture *picture, const double a[2],
                const double d[2], double scale)
{
    if (picture->n_arrow == VIEW_ARROWS) return;
    if (scale * hypot(d[0], d[1]) < 0.02) return; /* two pixels */
    double *arrow = picture->arrow[picture->n_arrow++];
    for (int i = 0; i < 2; i++) {
        arrow[i] = a[i];
        arrow[2 + i] = a[i] + scale * d[i];
    }
}

int hand_grab(int held, const struct pointer *pointer, int n, const double x[],
              double reach)
{
    int nearest = -1;
    if (!pointer->down || held >= 0) return pointer->down ? held : -1;
    for (int a = 0; a < n; a++) {
        const double far = hypot(x[2 * a] - pointer->x,
                                 x[2 * a + 1] - pointer->y);
        if (far > reach) continue;
        reach = far;
        nearest = a;
    }
    return nearest;
}

struct view_picture hand_triangles(const struct mesh *mesh, const double x[],
                                   const double value[])
{
    return (struct view_picture){
        .n_point = mesh->n_vertex, .x = x, .n_triangle = mesh->n_triangle,
        .triangle = mesh->triangle, .value = value};
}
