/* caption.c - laws of common/motion/caption.h. */
#include "motion/caption.h"

#include "unit.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct live_report REPORT = {
    .first = "NOT_SPD", .status = MAX_ITERATIONS, .rung = "downhill",
    .systems = 7, .part = 0.5};

static struct live *some_live(void)
{
    gsl_set_error_handler_off();
    return live_alloc(&(struct live_setting){
        2, LOG, BACKWARD_EULER, PATCH, ELASTIC, 1, LINEAR_TRIANGLE});
}

/* What the caption says of a key: from its bracket to the next one. */
static void says(const struct live *live, char key, char words[CAPTION])
{
    char text[CAPTION];
    caption_of(live, &REPORT, 0.03217, text);
    const char *at = text;
    while ((at = strchr(at, '[')) && !memchr(at, key, strcspn(at, "]"))) at++;
    ck_assert_msg(at, "no key %c in:\n%s", key, text);
    snprintf(words, CAPTION, "%.*s", (int)(1 + strcspn(at + 1, "[\n")), at);
}

static void each_key_is_named(void)
{
    char words[CAPTION];
    struct live *live = some_live();
    for (const char *key = &POINTER_KEYS[1]; *key; key++)
        says(live, *key, words);
    live_free(live);
}

static void a_key_changes_its_own_words(void)
{
    static const char KEYS[] = "lispge+";
    char before[CAPTION], after[CAPTION];
    for (const char *pressed = KEYS; *pressed; pressed++)
        for (const char *key = KEYS; *key; key++) {
            struct live *live = some_live();
            says(live, *key, before);
            live_input(live, &(struct pointer){0.0, 0.0, 0, *pressed});
            says(live, *key, after);
            ck_assert_msg((strcmp(before, after) != 0) == (key == pressed),
                          "%c: %s became %s", *pressed, before, after);
            live_free(live);
        }
}

static void each_word_is_that_of_the_setting(void)
{
    static const char *const start[] = {"elastic", "rows", "last state"};
    char words[CAPTION];
    struct live *live = some_live();
    for (int k = 0; k < 8; k++) {
        live->set.start = (enum start)(k % 3);
        live->set.grab = k & 1 ? SIDE : PATCH;
        live->set.element = k & 2 ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE;
        live->set.fallback = k & 4;
        says(live, 's', words);
        ck_assert(strstr(words, start[k % 3]));
        says(live, 'g', words);
        ck_assert(strstr(words, k & 1 ? "side" : "patch"));
        says(live, 'e', words);
        ck_assert(strstr(words, k & 2 ? "quadratic" : "linear"));
        says(live, 'p', words);
        ck_assert(strstr(words, k & 4 ? "downhill" : "nothing"));
    }
    live_free(live);
}

static void the_frame_is_told_in_short_lines(void)
{
    char text[CAPTION];
    struct live *live = some_live();
    live_input(live, &(struct pointer){0.0, 0.0, 0, 'i'});
    live_input(live, &(struct pointer){0.0, 0.0, 0, 'e'});
    caption_of(live, &REPORT, 0.03217, text);
    const char *first = "downhill: MAX_ITERATIONS, 7 systems in 32.2 ms\n";
    ck_assert_msg(strncmp(text, first, strlen(first)) == 0, "%s", text);
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"))
        ck_assert_msg(strlen(line) <= 60, "%s", line);
    live_free(live);
}

UNIT_MAIN("caption",
    LAW(each_key_is_named),
    LAW(a_key_changes_its_own_words),
    LAW(each_word_is_that_of_the_setting),
    LAW(the_frame_is_told_in_short_lines))
