/*
 * hand.c - the bar in your hand: drag its right end.
 *
 * In every frame newton() of the program under test goes from the last state to
 * the next, whose right end has jumped to the hand, or is free.  A frame in
 * which it fails is lost: the bar stays, and the caption says why.
 *
 *     |####|####|####|####|    at x = -1.5 + 2.5 (X + u), the colours log2 F
 *      _____-----~~~~~~~~~     P over X, 1 m high for 4000 N/m^2
 *     ---------------------    0
 */
#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { PARTS = 12, POINTS = 2 * PARTS + 2 };

/* Fill in what is drawn, and return P of the last element. */
static double hand_bar(const struct material *material, const double u[],
                       double x[], double F[], double curve[])
{
    double P = 0.0, *c = curve;
    for (int i = 0; i <= PARTS; i++)
        for (int k = 0; k < 2; k++) {
            x[4 * i + 2 * k] = -1.5 + 2.5 * ((double)i / PARTS + u[i]);
            x[4 * i + 2 * k + 1] = 0.5 + 0.4 * k;
        }
    for (int e = 0; e < PARTS; e++) {
        F[2 * e] = F[2 * e + 1] = 1.0 + PARTS * (u[e + 1] - u[e]);
        if (material_defined(material, F[2 * e]))
            P = material1_pk1(material, F[2 * e]);
        for (int k = 0; k < 2; k++) {
            *c++ = -1.5 + 2.5 * (e + k) / PARTS;
            *c++ = -0.3 + fmax(-0.8, fmin(0.7, P / 4000.0));
        }
    }
    /* back along P = 0 */
    *c++ = 1.0, *c++ = -0.3, *c++ = -1.5, *c++ = -0.3;
    return P;
}

int main(int argc, char *argv[])
{
    struct hand *hand = hand_open("10", HAND_WHOSE, "rl", argc, argv);
    struct bar_scene scene = bar_scene_notes(LOG, PARTS);
    struct newton_control control = bar_scene_control(&scene);
    struct pointer pointer;
    double u[PARTS + 1] = {0.0}, x[2 * POINTS], F[2 * PARTS];
    double curve[2 * POINTS];
    int triangle[6 * PARTS], lost = 0;
    for (int k = 0; k < 6 * PARTS; k++)
        triangle[k] = k / 6 * 2 + (const int[]){0, 2, 3, 0, 3, 1}[k % 6];
    scene.c = -1300.0;
    control.max_iterations = 40;
    while (hand_next(hand, &pointer)) {
        if (pointer.key == 'l')
            scene.material.law = scene.material.law == LOG ? CUBIC : LOG;
        if (pointer.key == 'r') memset(u, 0, sizeof u);
        if (!pointer.down) scene.held[1] = 0;
        else if (fabs(pointer.x - 1.0 - 2.5 * u[PARTS]) < 0.4)
            scene.held[1] = 1;
        scene.g[1] = (pointer.x - 1.0) / 2.5;
        hand_slot("10a");
        struct bar_state *s = bar_state_by(load_vector, &scene);
        for (int i = 0; i <= PARTS; i++)
            if (i < PARTS || !scene.held[1]) s->u[i] = u[i];
        hand_slot("10e");
        const struct newton_report report = newton(&s->bar, &control, s->u);
        if (report.status == OK) memcpy(u, s->u, sizeof u);
        lost += report.status != OK;
        const double least = bar_min_stretch(&s->bar, u);
        bar_state_free(s);
        const double P = hand_bar(&scene.material, u, x, F, curve);
        struct view_picture picture = {
            .n_point = POINTS, .x = x, .n_triangle = 2 * PARTS, .value = F,
            .triangle = triangle, .n_curve = POINTS, .curve = curve,
            .note = "the curve is P over X"};
        snprintf(picture.caption, sizeof picture.caption,
                 "%s: %s, %d systems, %d frames lost\n"
                 "least F %.2f, P at the right %.0f N/m^2\n"
                 "drag the right end   [l] law: %s",
                 report.status == OK ? "at rest" : "lost",
                 status_name(report.status), report.iterations, lost, least, P,
                 material_law(scene.material.law));
        hand_draw(hand, &picture, report.status, "systems lost least_F P",
                  (double[]){report.iterations, lost, least, P});
    }
    return hand_close(hand);
}
