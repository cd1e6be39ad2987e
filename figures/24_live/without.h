/*
 * without.h - the frame of live.h with one safeguard taken away, and the simple
 * frame of lesson 24, built up: what each safeguard is for.
 */
#ifndef FIGURES_WITHOUT_H
#define FIGURES_WITHOUT_H

#include "motion/live.h"

enum without {
    NOTHING,     /* the whole fallback */
    FIRST_RUNG,  /* each frame begins downhill */
    LIFT,        /* the first rung starts from the last state */
    SECOND_RUNG, /* the first rung alone; a frame is lost when it fails */
    PROJECTION,  /* the lift of the second rung is by the exact K */
    DEMAND,      /* the second rung never projects after its lift */
    SEARCH,      /* the second rung has no line search */
    ACCEPTING,   /* an unfinished frame is lost */
    STOPPING,    /* v stays what it is after an unfinished frame */
    HALVING,     /* the hand goes all of its way or none */
    BOUND,       /* the hand goes all the way to the pointer */
    LEAPING,     /* a lift may go any way that is finite */
    TROUBLE,     /* each frame begins with the first rung */
    N_WITHOUT,
    /* the simple frame; each has what those before it have */
    LOOP = N_WITHOUT, /* Newton's method from the last state, 40 systems */
    LIFTED,           /* the elastic lift */
    DESCENDING,       /* projection, of the lift and on demand */
    SEARCHING,        /* a line search */
    HURRIED,          /* FRAME_SYSTEMS at most */
    SIMPLE            /* unfinished frames are accepted, with v = 0 */
};
const char *without_word(enum without without);

/* Frames after which the second rung sets the velocity to 0, and the largest
 * kinetic energy (J) before one of them; 0 with ACCEPTING and STOPPING. */
struct without_stop {
    int frames;
    double energy;
};

struct without_result {
    int lost, freeze;      /* frames lost, and in a row at most */
    int first;             /* the first of them, counted from 1; 0: none */
    int stands;            /* frames in which a hand that holds goes nowhere */
    int unfinished;        /* frames accepted although not converged */
    double p50, p99, most; /* systems per frame */
    double energy, speed;  /* the largest (J), (m/s) */
    double last;           /* largest |u| at the end (m) */
    struct without_stop stop;
};

/* The square of n x n, a patch in the hand, through the whole script. */
struct without_result without_play(enum without without, int n, enum law law,
                                   enum method method,
                                   const struct pointers *script);

#endif
