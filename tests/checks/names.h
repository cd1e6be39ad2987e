/*
 * names.h - the judge's words, in which checks are written, are a student's as
 * well: from here on they mean the judge's, under names that no student uses.
 * The judge's own files include it too; tests/tools/lint.sh looks that no word
 * is missing.
 */
#ifndef TESTS_CHECKS_NAMES_H
#define TESTS_CHECKS_NAMES_H

#define run judge_run
#define cell judge_cell
#define quit judge_quit
#define word judge_word
#define claim judge_claim
#define judge judge_judge
#define wrong judge_wrong
#define column judge_column
#define lesson judge_lesson
#define measured judge_measured
#define output judge_output
#define word_at judge_word_at
#define child_run judge_child_run
#define has_table judge_has_table
#define last_line judge_last_line
#define number_at judge_number_at
#define output_of judge_output_of
#define row_count judge_row_count
#define find_table judge_find_table
#define is_missing judge_is_missing
#define column_rule judge_column_rule
#define find_column judge_find_column
#define guards_hold judge_guards_hold
#define output_free judge_output_free
#define expect_close judge_expect_close
#define guarded_copy judge_guarded_copy
#define open_regular judge_open_regular
#define run_unsolved judge_run_unsolved
#define child_command judge_child_command
#define child_seconds judge_child_seconds
#define child_work_in judge_child_work_in
#define guarded_alloc judge_guarded_alloc
#define expect_no_leak judge_expect_no_leak
#define expect_refusal judge_expect_refusal
#define child_am_inside judge_child_am_inside
#define child_hand_over judge_child_hand_over
#define guarded_indices judge_guarded_indices
#define predictions_read judge_predictions_read
#define child_on_interrupt judge_child_on_interrupt
#define prediction_compare judge_prediction_compare
#define child_restart_clock judge_child_restart_clock

#endif
