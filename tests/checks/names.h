/*
 * names.h - the words that checks are written in are the student's as well:
 * from here on they mean the judge's, under names that no student uses.
 */
#ifndef TESTS_CHECKS_NAMES_H
#define TESTS_CHECKS_NAMES_H

#undef expect
#define run judge_run
#define cell judge_cell
#define column judge_column
#define word judge_word
#define wrong judge_wrong
#define claim judge_claim
#define output judge_output
#define lesson judge_lesson
#define has_table judge_has_table
#define row_count judge_row_count
#define is_missing judge_is_missing
#define run_unsolved judge_run_unsolved
#define column_rule judge_column_rule
#define expect_close judge_expect_close
#define expect_refusal judge_expect_refusal

#endif
