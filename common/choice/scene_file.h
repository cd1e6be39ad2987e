/*
 * scene_file.h - a scene of one's own, ten lines of plain text.
 *
 *     # a skin flap that hangs from its edge
 *     width    0.08               m; it lies along X1
 *     height   0.02               m
 *     E        20000              N/m^2
 *     nu       0.45
 *     rho      1000               kg/m^3
 *     gravity  0 -9.81            m/s^2, along X1 and X2
 *     held     left               or ends: left and right
 *     pulled   0 0                N/m^2 on the right end
 *     pushed   0 0                N/m^2 on the upper side
 *     load     rises              or stands, swings
 *     time     0.1                s, in which it rises
 *     period   0.4                s, instead of time, in which it swings once
 *     end      0.5                s, so long it is followed: until it is full
 *     quantity displacement       or rms, force
 *
 * A line is a word and its values; from a # on it is a comment.  width, height,
 * E, nu, rho and held must be there, end where the load does not stand, time
 * where it rises, period where it swings, and only there, and a load; the rest
 * is 0.  Plane strain, per metre of depth.  What is pulled or pushed is so by a
 * dead load, per area at rest: it does not turn with the body.
 *
 * The quantity is what the error is one of: the displacement, at its largest or
 * in the root mean square, or the force in the hand that pulls or pushes.  Such
 * a hand there must be, and in motion no gravity beside it.
 *
 * The scene of ladder.h has the length 2, E = 1000 and rho = 1: lengths are in
 * units of width / 2, stresses of E / 1000, times of the root of
 * rho (width / 2)^2 / (E / 1000).
 */
#ifndef COMMON_SCENE_FILE_H
#define COMMON_SCENE_FILE_H

#include "choice/ladder.h"

/* A line of a file: n numbers from least to most in a unit, or (n = 0) one
 * of `words`, with a blank around each. */
struct scene_line {
    const char *word;
    int n;
    double least, most;
    const char *words; /* NULL: numbers */
    int must;          /* be there */
    const char *unit;  /* after a blank, or "" */
};

/* Return the k-th from 0 on, or NULL. */
const struct scene_line *scene_file_line(int k);

struct scene_file {
    struct ladder_scene scene;
    double metre, pascal, second; /* what its units are (m, N/m^2, s) */
    char name[64];                /* of the file, without folder and ending */
};

/*
 * Read the file, for at most `finest` refinements of the mesh.  What is wrong
 * is one line on stderr: the line's number, the word and what is allowed; then
 * the program ends with status 2.  A scene that cannot stand, because nothing
 * is held or nothing is loaded, is named as such; so is a path that is no plain
 * file.  file->scene.name is
 * file->name, so that the struct must stay where it is.
 */
void scene_file_read(const char *program, const char *path, int finest,
                     struct scene_file *file);

#endif
