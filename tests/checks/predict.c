/* predict.c - see predict.h. */
#include "predict.h"

#include "output.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The answer behind the colon, without blanks before it, and blanks and dots
 * behind it; it is printed, so that what moves a cursor becomes a ?. */
static void read_answer(const char *from, size_t size, char answer[])
{
    from += strspn(from, " \t");
    size_t n = strlen(from);
    while (n > 0 && strchr(" \t\r\n.", from[n - 1])) n--;
    snprintf(answer, size, "%.*s", (int)n, from);
    for (char *c = answer; *c; c++)
        if (iscntrl((unsigned char)*c)) *c = '?';
}

int predictions_read(const char *path, struct prediction p[])
{
    FILE *file = open_regular(path);
    char line[256];
    int n = 0;
    while (file && n < MAX_PREDICTIONS && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (colon && sscanf(line, " * PREDICT %3[0-9a-z]", p[n].key) == 1)
            read_answer(colon + 1, sizeof p[n].answer, p[n++].answer);
    }
    if (file) fclose(file);
    return n;
}

/* The whole text as a number a or a fraction a/b; NaN when it is neither. */
static double number(const char *text)
{
    char *end;
    double value = strtod(text, &end);
    if (*end == '/' && end[1]) value /= strtod(end + 1, &end);
    return *text && *end == '\0' && isfinite(value) ? value : (double)NAN;
}

void prediction_compare(const struct prediction *p, double measured,
                        size_t size, char text[])
{
    const size_t at = strlen(text);
    const double expected = number(p->answer);
    const double off = fabs(expected - measured), part = off / fabs(measured);
    char how[64];

    if (isnan(expected)) {
        snprintf(text + at, size - at,
                 "%s: `%s` is not a number, measured %.7g. ",
                 p->key, p->answer, measured);
        return;
    }
    if (off <= 5e-7 * fabs(measured)) /* of the digits that are printed */
        snprintf(how, sizeof how, "right");
    else if (fabs(expected + measured) <= 5e-7 * fabs(measured))
        snprintf(how, sizeof how, "right but for its sign");
    else if (part < 0.995)
        snprintf(how, sizeof how, "off by %.2g %%", 100.0 * part);
    else if (part < 10.0)
        snprintf(how, sizeof how, "off by %.0f %%", 100.0 * part);
    else if (part < INFINITY)
        snprintf(how, sizeof how, "%.2g times as large", expected / measured);
    else
        snprintf(how, sizeof how, "off by %.3g", off);
    snprintf(text + at, size - at, "%s: %s, measured %.7g, %s. ",
             p->key, p->answer, measured, how);
}
