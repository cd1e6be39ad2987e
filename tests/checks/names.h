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
#define output judge_output
#define word_at judge_word_at
#define judging judge_judging
#define examine judge_examine
#define measured judge_measured
#define claim_at judge_claim_at
#define diagnose judge_diagnose
#define child_run judge_child_run
#define has_table judge_has_table
#define last_line judge_last_line
#define number_at judge_number_at
#define output_of judge_output_of
#define row_count judge_row_count
#define work_file judge_work_file
#define run_claim judge_run_claim
#define find_rule judge_find_rule
#define find_table judge_find_table
#define is_missing judge_is_missing
#define row_allows judge_row_allows
#define output_run judge_output_run
#define column_rule judge_column_rule
#define find_column judge_find_column
#define guards_hold judge_guards_hold
#define output_free judge_output_free
#define output_read judge_output_read
#define cells_print judge_cells_print
#define child_spend judge_child_spend
#define output_kept judge_output_kept
#define is_kept judge_is_kept
#define expect_close judge_expect_close
#define keep_figures judge_keep_figures
#define guarded_copy judge_guarded_copy
#define open_regular judge_open_regular
#define run_unsolved judge_run_unsolved
#define verdict_name judge_verdict_name
#define child_command judge_child_command
#define child_seconds judge_child_seconds
#define child_work_in judge_child_work_in
#define guarded_alloc judge_guarded_alloc
#define write_report judge_write_report
#define keep_outputs judge_keep_outputs
#define tables_differ judge_tables_differ
#define print_wrapped judge_print_wrapped
#define child_confine judge_child_confine
#define column_allows judge_column_allows
#define times_allowed judge_times_allowed
#define expect_no_leak judge_expect_no_leak
#define expect_refusal judge_expect_refusal
#define child_am_inside judge_child_am_inside
#define child_hand_over judge_child_hand_over
#define guarded_indices judge_guarded_indices
#define predictions_read judge_predictions_read
#define child_set_limits judge_child_set_limits
#define output_read_back judge_output_read_back
#define output_of_subject judge_output_of_subject
#define child_look_around judge_child_look_around
#define child_on_interrupt judge_child_on_interrupt
#define prediction_compare judge_prediction_compare
#define child_restart_clock judge_child_restart_clock
#define child_remove_shared_memory judge_child_remove_shared_memory
#define check_same_numbers_as_reference judge_check_same_numbers_as_reference

#endif
