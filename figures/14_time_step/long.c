/*
 * long.c - what is left of the energy of the square after a long time?
 *
 * n = 3, cubic law, lumped mass, both ends held, let go from a swing of 0.05 m,
 * at half of the critical step [eq:critical-step]; least and largest energy
 * over that of the start in blocks of steps, to 6 digits.  So small a swing is
 * not chaotic; one of 0.3 m is, so that only bounds of it are claimed, and
 * critical.c shows what becomes of symplectic Euler.
 */
#include "frequency.h"
#include "swing.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { PER_DECADE = 8, BLOCKS = 33 };

struct range {
    int last;           /* step */
    double least, most; /* energy over that of the start */
};

static const double SMALL = 0.05, LARGE = 0.3; /* (m) of a swing */

static double six_digits(double x) { return round(1e6 * x) / 1e6; }

/* A row for each block of steps, while there is energy to be seen. */
static void swing(struct model *model, enum method method, double dt,
                  double size, struct range block[BLOCKS])
{
    struct state s = swing_start(model->body, size);
    const double start = model_energy(model, s.u, s.v);
    int k = 0;
    for (int n = 0; n < BLOCKS; n++) {
        struct range r = {.least = INFINITY, .most = 0.0};
        r.last = (int)round(pow(10.0, 1.0 + (double)n / PER_DECADE));
        for (; k < r.last; k++) {
            if (integrate_step(model, method, dt, s.u, &s).status != OK)
                break;
            const double E = model_energy(model, s.u, s.v) / start;
            r.least = fmin(r.least, E);
            r.most = fmax(r.most, E);
        }
        if (size == SMALL && k == r.last && r.least > 1e-5)
            table_row(method_name(method), r.last, r.last * dt,
                      six_digits(r.least), six_digits(r.most));
        block[n] = r;
    }
    state_free(&s);
}

int main(void)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, 3);
    set.mass = LUMPED;
    struct scene *scene = scene_alloc(&set);
    struct model *model = model_body(scene->body);
    const double dt = 1.0 / frequency_largest(model);
    struct range r[N_METHOD][BLOCKS], large[BLOCKS];

    table_begin("long", "method steps t least most");
    for (int m = 0; m < N_METHOD; m++)
        swing(model, (enum method)m, dt, SMALL, r[m]);
    table_end();
    swing(model, IMPLICIT_MIDPOINT, dt, LARGE, large);
    model_free(model);
    scene_free(scene);

    /* the last decade against the second */
    const int early = PER_DECADE, late = BLOCKS - 1;
    double wide[2] = {0.0, 0.0}, off = 0.0;
    for (int n = 1; n <= PER_DECADE; n++) {
        const struct range *s = r[SYMPLECTIC_EULER];
        wide[0] = fmax(wide[0], s[n].most - s[n].least);
        wide[1] = fmax(wide[1], s[BLOCKS - n].most - s[BLOCKS - n].least);
    }
    for (int n = 0; n < BLOCKS; n++) {
        const struct range *s = &r[IMPLICIT_MIDPOINT][n];
        off = fmax(off, fmax(s->most - 1.0, 1.0 - s->least));
    }
    claim(r[SYMPLECTIC_EULER][late].last == 100000 && wide[1] < 1.1 * wide[0],
          "after %d steps the energy of symplectic Euler wanders no wider than "
          "in the first 100 (%g, %g)", r[SYMPLECTIC_EULER][late].last,
          wide[1], wide[0]);
    claim(off < 0.002, "that of the midpoint rule stays within 0.2 %% (%g)",
          off);
    claim(r[BACKWARD_EULER][early].most < 0.02, "of that of backward Euler "
          "less than 2 %% is left after 100 steps (%g)",
          r[BACKWARD_EULER][early].most);
    const double end = large[late].most - 1.0;
    claim(0.03 < end && end < 0.055, "late in a large swing that of the "
          "midpoint rule is at most about 4 %% too high (%g)", end);
    return table_finish();
}
