/*
 * form.c - the words of a scene file as a table, for the form of choose.html.
 *
 * words is a word of the file, - for numbers; unit is - where there is none.
 */
#include "base/table.h"
#include "choice/scene_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* " a b c " without its ends, as "a,b,c". */
static const char *joined(const char *words, char text[64])
{
    snprintf(text, 64, "%s", words + 1);
    text[strlen(text) - 1] = '\0';
    for (char *c = text; *c; c++)
        if (*c == ' ') *c = ',';
    return text;
}

int main(void)
{
    const struct scene_line *line;
    char text[64];
    table_begin("words", "word n least most must unit words");
    for (int k = 0; (line = scene_file_line(k)); k++)
        table_row(line->word, line->n, line->least, line->most, line->must,
                  *line->unit ? line->unit + 1 : MISSING,
                  line->words ? joined(line->words, text) : MISSING);
    table_end();
    return table_finish();
}
