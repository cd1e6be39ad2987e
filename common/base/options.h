/*
 * options.h - command-line options from one table.
 *
 * A program lists its options once; parsing, range checks, the usage text of
 * -h and the message for a bad value all come from that list.  The variable's
 * initial value is the default, and the defaults reproduce the workbook.
 *
 *     int n = 4;
 *     double beta = 2.385;
 *     int diagonal = 0;
 *     const struct option table[] = {
 *         {"n", .integer = &n, .min = 1, .max = 1000, .help = "elements"},
 *         {"beta", .real = &beta, .min = 1e-9, .max = 1e9, .unit = "N",
 *          .help = "coefficient"},
 *         {"diagonal", .choice = &diagonal, .choices = "keep one",
 *          .help = "corrected diagonal"},
 *     };
 *     options_parse("program", table, COUNT(table), argc, argv);
 *
 * Accepted: --n 8 and --n=8; exactly one of integer, real, choice, text is set.
 */
#ifndef COMMON_OPTIONS_H
#define COMMON_OPTIONS_H

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

struct option {
    const char *name;    /* without the two dashes */
    int *integer;        /* a whole number in [min, max] */
    double *real;        /* a finite number in [min, max] */
    int *choice;         /* index of a word of choices */
    const char **text;   /* any that is not empty, such as a file's name; its
                          * unit says what it is; borrowed from argv */
    const char *choices; /* words separated by one space */
    double min, max;
    const char *unit; /* of a real, NULL when it has none */
    const char *help;
    const char *why; /* the reason for the range, or NULL */
};

/*
 * Set the variables from argv.  -h prints the table and exits with status 0.
 * An unknown option, a missing value or one that is not allowed gives one line
 * on stderr naming the option, the value and what is allowed, and exit status
 * 2; nothing is written to stdout.
 */
void options_parse(const char *program, const struct option table[], int n,
                   int argc, char *argv[]);

/* Print "program: words" on stderr, one line whatever the words are, and exit
 * with status 2: what the user gave is not allowed. */
_Noreturn void options_refuse(const char *program, const char *words);

#endif
