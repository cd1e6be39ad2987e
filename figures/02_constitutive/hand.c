/*
 * hand.c - one triangle in your hand: its lower corners stay, drag the third.
 *
 * psi and P are those of the program under test.  The arrow is the force of the
 * triangle on the corner that you hold, -area P grad N [eq:body-q], 1 m long
 * for 3000 N; the colour is log2 J.  [+] and [-] turn all of it by ten degrees,
 * which deforms nothing.
 */
#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

static const double HAND_REST[6] = {-0.7, -0.5, 0.7, -0.5, 0.0, 0.7};

static void hand_turn(double angle, double x[6])
{
    const double c = cos(angle), s = sin(angle);
    for (int a = 0; a < 3; a++) {
        const double old[2] = {x[2 * a], x[2 * a + 1]};
        x[2 * a] = c * old[0] - s * old[1];
        x[2 * a + 1] = s * old[0] + c * old[1];
    }
}

int main(int argc, char *argv[])
{
    static const enum law laws[] = {LOG, CUBIC, LINEAR};
    struct mesh *mesh = mesh_triangle(HAND_REST);
    struct hand *hand = hand_open("02", HAND_WHOSE, "lr+-", argc, argv);
    struct pointer pointer;
    double x[6], gradient[6];
    int law = 0, grabbed = -1, turned = 0;
    const double area = mesh_gradients(mesh, 0, gradient);
    const int held[3] = {1, 1, 0};
    memcpy(x, HAND_REST, sizeof x);
    while (hand_next(hand, &pointer)) {
        mat2 F = {{{0.0, 0.0}, {0.0, 0.0}}}, P = F;
        double psi = 0.0, J, force[2] = {0.0, 0.0};
        const int turn = (pointer.key == '+') - (pointer.key == '-');
        if (pointer.key == 'r') memcpy(x, HAND_REST, sizeof x);
        if (pointer.key == 'l') law = (law + 1) % 3;
        turned = pointer.key == 'r' ? 0 : turned + 10 * turn;
        if (turn) hand_turn(turn * acos(-1.0) / 18.0, x);
        grabbed = hand_grab(grabbed, &pointer, 1, &x[4], 0.3);
        if (grabbed >= 0) {
            x[4] = pointer.x;
            x[5] = pointer.y;
        }
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++)
                for (int k = 0; k < 2; k++)
                    F.m[i][k] += x[2 * a + i] * gradient[2 * a + k];
        J = mat2_det(F);
        hand_slot("2c");
        const struct material m = lame(laws[law], 1000.0, 0.3);
        const enum status status = response2(&m, F, &psi, &P);
        struct view_picture picture = hand_triangles(mesh, x, &J);
        picture.held = held;
        if (status == OK) {
            for (int i = 0; i < 2; i++)
                for (int k = 0; k < 2; k++)
                    force[i] -= area * P.m[i][k] * gradient[4 + k];
            hand_arrow(&picture, &x[4], force, 1.0 / 3000.0);
        }
        char answer[64] = "not defined here: no force";
        if (status == OK)
            snprintf(answer, sizeof answer, "psi %.1f J/m^2, force %.1f N", psi,
                     hypot(force[0], force[1]));
        snprintf(picture.caption, sizeof picture.caption,
                 "J %.2f: %s\n"
                 "drag the upper corner   [l] law: %s\n"
                 "[+ -] turn all: by %d degrees",
                 J, answer, material_law(laws[law]), turned);
        hand_draw(hand, &picture, status, "law J psi force_x force_y",
                  (double[]){laws[law], J, psi, force[0], force[1]});
    }
    mesh_free(mesh);
    return hand_close(hand);
}
