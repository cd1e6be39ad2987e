/*
 * user.h - a scripted user who moves the right side of the square about.
 *
 * The square of scene.h, its left side held; 30 frames per second.  The right
 * side goes smoothly to a place, trembles about it, or is let go.  What the
 * user does not know is whether a frame can be solved.
 *
 *     while (user_next(user))
 *         ... one frame of user->body to the boundary values user->g ...
 */
#ifndef COMMON_USER_H
#define COMMON_USER_H

#include "plane/scene.h"

/* A motion of the right side until a time. */
struct user_motion {
    const char *word;
    double until;   /* (s) */
    double to[2];   /* where it is then (m), times reach */
    double tremble; /* amplitude across (m), times reach, 3 per second */
    int held;       /* 0: it is let go */
};
enum { USER_MOTIONS = 8 };
extern const struct user_motion USER_SCRIPT[USER_MOTIONS];

struct user {
    struct scene *scene[2]; /* right side free, right side held; owned */
    double reach;
    double dt;              /* 1/30 s */
    int n_dof;
    int side;               /* u of the middle of the right side: [side],
                             * [side + 1] */
    int frames;             /* of the whole script */
    int k;                  /* number of this frame, 1 the first */
    double t;               /* at its end */
    const char *motion;     /* word of its motion */
    struct body *body;      /* with its prescribed vertices; borrowed */
    double *g;              /* [n_dof] boundary values at its end; owned */
    double *kept;           /* [motions][n_dof] see user_keep(); owned */
    int n_kept;
};

/* Make n squares per side, with consistent mass, the notes' material; LOG or
 * CUBIC. */
struct user *user_alloc(int n, enum law law, double reach);
void user_free(struct user *user);

/* Go on to the next frame; false when the script is over. */
int user_next(struct user *user);

/* Keep the state u [n_dof] of this frame, if it is the last of a motion. */
void user_keep(struct user *user, const double u[]);

/* Print the table square: the vertices in the states kept, k being the number
 * of the motion. */
void user_table(const struct user *user);

#endif
