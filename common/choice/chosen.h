/*
 * chosen.h - what `make choose` says of a scene and of the models that it has
 * tried, in words: each with its reason and the lesson that it rests on.
 */
#ifndef COMMON_CHOSEN_H
#define COMMON_CHOSEN_H

#include "choice/estimate.h"
#include "choice/scene_file.h"

/* A model that was tried, what is said of it, and what is added next. */
struct chosen_tried {
    struct ladder_model model;
    double part[N_PART], estimate;
    enum part add;
    enum doubt doubt;
};

/* Nothing is enough; the last model is; or is so with the triangles of
 * cells.h. */
enum chosen_how { CHOSEN_NOTHING, CHOSEN_LAST, CHOSEN_WITH_OTHERS };

/* "of the largest displacement" and so on. */
const char *chosen_quantity(enum ladder_quantity quantity);

void chosen_say_numbers(const struct scene_file *file,
                        const struct ladder_state *state);
void chosen_say_climb(const struct chosen_tried tried[], int n);
void chosen_say_model(const struct scene_file *file,
                      const struct ladder_state *state, double tolerance,
                      enum chosen_how how);

/* The parts of the error, and what no part sees; the state comes back as it
 * was. */
void chosen_say_error(struct ladder_state *state,
                      const struct chosen_tried *tried);

#endif
