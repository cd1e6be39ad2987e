/*
 * balance.h - does the balance rule find the cheapest setting, and when does it
 * pay?
 *
 * The settings of trials.h with even linear triangles, which the rule knows, in
 * six scenes, on which it was made, and in two on which it was not: a pull
 * that begins with a jolt, and a weight.  The rule [alg:balance] from three
 * meshes and from two, asked for the errors 0.5, 0.4, ... as far as a setting
 * gets: its flops over those of the cheapest that is as good (same; of all
 * settings, all), over those of the cheapest for what was asked (over), and its
 * own price.
 */
#ifndef FIGURES_BALANCE_H
#define FIGURES_BALANCE_H

#include "trials.h"

/* Tables: rule, sums over its scenes, price_three, price_two; claims. */
void balance_tables(struct trials *const s[WORK_SCENES]);

#endif
