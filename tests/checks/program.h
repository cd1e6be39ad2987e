/*
 * program.h - the program under test, as its checks see it: the lesson's types,
 * constants and functions, from the header PROGRAM, which contract.awk makes of
 * the solution.  The program itself is compiled alone, by program.sh of
 * tests/tools/: its macros and its other names are no matter here.
 */
#ifndef TESTS_CHECKS_PROGRAM_H
#define TESTS_CHECKS_PROGRAM_H

int program_main(int argc, char *argv[]);

/* f() is declared as the program's, whose linker name is program_f. */
#define AS_PROGRAM(name) __asm__(PROGRAM_LABEL(__USER_LABEL_PREFIX__, name))
#define PROGRAM_LABEL(prefix, name) PROGRAM_TEXT(prefix) "program_" #name
#define PROGRAM_TEXT(text) #text

#define main program_main /* in an editor PROGRAM is the solution (.clangd) */
#include PROGRAM
#undef main

#endif
