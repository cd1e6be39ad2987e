/*
 * strike.c - how hard a blow does a frame survive, and by which attempt?
 *
 * The square at rest, n = 8, left side held, its right side struck inwards by
 * so much within one frame, and up by 0.3 m: what integrate_frame() needs
 * [alg:frame], the middle of the square and its speed afterwards.
 *
 * Of the cubic law the blows end at 1.2 m: struck harder, it turns triangles
 * over on its way, and the reason that FAST ends with is round-off.
 */
#include "motion/integrate.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { N = 8, MIDDLE = 2 * (N / 2 * (N + 1) + N / 2) };

struct outcome {
    struct frame frame;
    double min_J;
};

static struct outcome strike(enum law law, double moved)
{
    const struct scene_setting set = scene_notes(STRETCH, law, N);
    struct scene *scene = scene_alloc(&set);
    struct state s = state_make(scene->n_dof);
    for (int a = N; a < scene->mesh->n_vertex; a += N + 1) {
        scene->g[2 * a] = -moved;
        scene->g[2 * a + 1] = 0.3;
    }
    const struct frame frame =
        integrate_frame(scene->body, set.dt, scene->g, &s);
    const double min_J = body_min_J(scene->body, s.u);
    table_row(material_law(law), moved, status_name(frame.status),
              status_name(frame.first), frame.attempts, frame.substeps,
              frame.iterations, frame.factorisations, s.u[MIDDLE],
              s.u[MIDDLE + 1], hypot(s.v[MIDDLE], s.v[MIDDLE + 1]), min_J);
    state_free(&s);
    scene_free(scene);
    return (struct outcome){frame, min_J};
}

int main(void)
{
    static const double moved[] = {0.3, 0.6, 0.9, 1.2, 1.5, 2.1};
    struct outcome of_log[6], cubic[4];
    table_begin("strike", "law moved status first attempts substeps iterations "
                          "factorisations u1 u2 speed min_J");
    for (int k = 0; k < 6; k++) of_log[k] = strike(LOG, moved[k]);
    for (int k = 0; k < 4; k++) cubic[k] = strike(CUBIC, moved[k]);
    table_end();

    for (int k = 0; k < 5; k++)
        claim(of_log[k].frame.attempts == (moved[k] < 0.7 ? 1 : 2) &&
                  of_log[k].frame.status == OK && of_log[k].min_J > 0.0,
              "log: FAST is enough up to 0.6 m, ROBUST up to 1.5 m (%g m: %d "
              "attempts, %s)", moved[k], of_log[k].frame.attempts,
              status_name(of_log[k].frame.status));
    claim(of_log[5].frame.status == INVERTED && of_log[5].min_J == 1.0,
          "log: 2.1 m are more than the square is long; the frame is lost, and "
          "the state is the one before (%s, least det F %g)",
          status_name(of_log[5].frame.status), of_log[5].min_J);
    claim(cubic[3].frame.status == OK && cubic[3].min_J < 0.0,
          "cubic: goes through with 1.2 m by turning triangles over (%s, %g)",
          status_name(cubic[3].frame.status), cubic[3].min_J);
    return table_finish();
}
