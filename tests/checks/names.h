/*
 * names.h - the judge's words, in which checks are written, are the student's as
 * well: from here on they mean the judge's, under names that no student uses.
 * (tests/tools/lint.sh looks that none is missing.)
 */
#ifndef TESTS_CHECKS_NAMES_H
#define TESTS_CHECKS_NAMES_H

#define run judge_run
#define cell judge_cell
#define word judge_word
#define claim judge_claim
#define wrong judge_wrong
#define column judge_column
#define lesson judge_lesson
#define output judge_output
#define has_table judge_has_table
#define row_count judge_row_count
#define is_missing judge_is_missing
#define column_rule judge_column_rule
#define guards_hold judge_guards_hold
#define expect_close judge_expect_close
#define guarded_copy judge_guarded_copy
#define run_unsolved judge_run_unsolved
#define guarded_alloc judge_guarded_alloc
#define expect_refusal judge_expect_refusal
#define guarded_indices judge_guarded_indices
#define judge judge_lessons_program

#endif
