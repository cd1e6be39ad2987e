/*
 * program.h - the program under test, before anything of the judge: it may call
 * its functions, types and macros as it likes.  The Makefile gives PROGRAM and
 * NAMES, a header that tests/tools/names.sh makes.  Before the program, where
 * main is a macro, it gives what the program defines names of its own; behind
 * it the program's macros are no more, and what the checks declare has names of
 * its own.
 */
#ifndef TESTS_CHECKS_PROGRAM_H
#define TESTS_CHECKS_PROGRAM_H

int program_main(int argc, char *argv[]);

#ifndef NAMES /* in an editor, for which .clangd gives PROGRAM */
#define NAMES "names.h"
#endif
#define main program_main
#include NAMES
#include PROGRAM
#undef main
#include NAMES

#endif
