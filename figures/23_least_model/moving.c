/*
 * moving.c - the scenes of Work and precision in numbers without dimension.
 *
 * How far the held ends go against the length of the body; 1 / (omega T) for
 * the first mode of the body at rest and the time T in which they do; of eight
 * steps the longest jump of an end, and the speed of the end, against the side
 * of a cell, n = 8, and the speed of sound.  The swing, in which nothing held
 * moves, has none of these.  Table: moving.
 */
#include "base/study.h"
#include "base/table.h"
#include "plane/scene.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

enum { STEPS = 8 };
static const double cell = 0.25; /* (m) */

/* What is held, how far its ends go (m), within which time, in how many seconds
 * the scene ends, and whether it is slow. */
static const struct moving {
    const char *name;
    enum reading held;
    int slender;
    double reach, time, end;
    int slow;
} moving[] = {
    {"slow pull", STRETCH, 1, 0.84, 1.0, 1.0, 1},
    {"fast pull", STRETCH, 1, 0.6, 0.06, 0.08, 0},
    {"shake", GRAVITY, 1, 0.3, 0.2, 0.4, 0},
    {"buckle", COMPRESS, 8, 0.2, 2.0, 2.0, 1},
    {"push", STRETCH, 1, 0.6, 0.08, 0.08, 0},
};
enum { MOVING = sizeof moving / sizeof *moving };

/* omega of the first mode at rest, by inverse iteration. */
static double first_mode(const struct moving *m)
{
    struct scene_setting set = scene_notes(m->held, LOG, 16);
    set.slender = m->slender;
    struct scene *s = scene_alloc(&set);
    struct matrix *K = body_matrix(s->body), *M = body_matrix(s->body);
    const int n = s->body->n_equation;
    double *x = allocate((size_t)n, sizeof *x);
    double *y = allocate((size_t)n, sizeof *y);
    double square = 0.0;
    body_mass_matrix(s->body, M);
    if (body_stiffness(s->body, s->u, EXACT, K) != OK || matrix_factor(K) != OK)
        die("%s has no first mode", m->name);
    for (int i = 0; i < n; i++) x[i] = 1.0 + 0.37 * i / n;
    for (int k = 0; k < 60; k++) {
        double above = 0.0, below = 0.0;
        matrix_multiply(M, x, y);
        for (int i = 0; i < n; i++) above += x[i] * y[i];
        for (int i = 0; i < n; i++) x[i] = y[i];
        matrix_solve(K, x);
        for (int i = 0; i < n; i++) below += x[i] * y[i];
        square = above / below;
        for (int i = 0; i < n; i++) x[i] *= square;
    }
    free(x);
    free(y);
    matrix_free(K);
    matrix_free(M);
    scene_free(s);
    return sqrt(square);
}

int main(void)
{
    const struct material notes = material_notes(LOG);
    const double c = sqrt(material_modulus(&notes)); /* density 1 */
    double slow = 0.0, fast = INFINITY;
    gsl_set_error_handler_off();
    table_begin("moving", "scene strain moves jump mach");
    for (int k = 0; k < MOVING; k++) {
        const struct moving *m = &moving[k];
        const double moves = 1.0 / (first_mode(m) * m->time);
        const double speed = 2.0 * m->reach / m->time; /* at most */
        table_row(m->name, cell_rounded(3, m->reach / 2.0),
                  cell_rounded(3, moves),
                  cell_rounded(3, speed * m->end / STEPS / cell),
                  cell_rounded(3, speed / c));
        if (m->slow)
            slow = fmax(slow, moves);
        else
            fast = fmin(fast, moves);
    }
    table_end();
    claim(slow < 0.05 && fast > 0.4, "1 / (omega T) tells what is slow: at "
          "most %g, and at least %g elsewhere", slow, fast);
    return table_finish();
}
