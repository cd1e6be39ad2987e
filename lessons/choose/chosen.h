/*
 * chosen.h - what `make choose` says of a scene and of the models that it has
 * tried, in words: each with its reason and the lesson that it rests on.
 */
#ifndef CHOOSE_CHOSEN_H
#define CHOOSE_CHOSEN_H

#include "cells.h"
#include "choice/climb.h"
#include "choice/scene_file.h"

/* Return "of the largest displacement" and so on. */
const char *chosen_quantity(enum ladder_quantity quantity);

/* Print the answer in two lines, with these triangles as below, and below them
 * why it is in doubt.  Return whether it is enough. */
int chosen_say_answer(const struct ladder_state *state,
                      const struct climb_rung *tried, double tolerance,
                      const struct cells *others);
void chosen_say_numbers(const struct scene_file *file,
                        const struct ladder_state *state);
void chosen_say_climb(const struct climb_rung tried[], int n);

/* Print for `others`, triangles of cells.h, or if it is NULL for linear ones as
 * in the state, the solver and the parts of the error with what no part sees;
 * the state comes back as it was. */
void chosen_say_model(const struct scene_file *file,
                      const struct ladder_state *state,
                      const struct cells *others);
void chosen_say_error(struct ladder_state *state,
                      const struct climb_rung *tried,
                      const struct cells *others);

#endif
