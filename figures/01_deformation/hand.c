/*
 * hand.c - twelve triangles in your hand: drag any vertex.
 *
 * F, J and the strain of every triangle are those of the program under test.
 * Colours: log2 J.  From the middle of each triangle two arrows along the
 * principal directions N of the Green strain E: F N, which is as long as the
 * stretch sqrt(1 + 2 E) times a tenth of a metre.
 */
#include "motion/hand.h"

#include <stdio.h>
#include <string.h>

enum { TRIANGLES = 12, VERTICES = 12 };

/* The two principal directions of a symmetric tensor. */
static void hand_principal(mat2 E, double N[2][2])
{
    const double angle = 0.5 * atan2(2.0 * E.m[0][1], E.m[0][0] - E.m[1][1]);
    N[0][0] = N[1][1] = cos(angle);
    N[0][1] = sin(angle);
    N[1][0] = -N[0][1];
}

int main(int argc, char *argv[])
{
    struct mesh *mesh = mesh_rectangle(3, 2, 1.2, 0.8);
    struct hand *hand = hand_open("01", HAND_WHOSE, "r", argc, argv);
    struct pointer pointer;
    double x[2 * VERTICES], J[TRIANGLES];
    int grabbed = -1;
    memcpy(x, mesh->X, sizeof x);
    while (hand_next(hand, &pointer)) {
        struct view_picture picture = hand_triangles(mesh, x, J);
        int inverted = 0;
        double sum = 0.0, most = 0.0;
        if (pointer.key == 'r') memcpy(x, mesh->X, sizeof x);
        grabbed = hand_grab(grabbed, &pointer, VERTICES, x, 0.3);
        if (grabbed >= 0) {
            x[2 * grabbed] = pointer.x;
            x[2 * grabbed + 1] = pointer.y;
        }
        for (int e = 0; e < TRIANGLES; e++) {
            const int *node = &mesh->triangle[3 * e];
            mat2 F = mat2_identity(), linear, green, left;
            double N[2][2], middle[2] = {0.0, 0.0}, gradient[6];
            hand_slot("1b");
            J[e] = triangle_gradient(node, mesh->X, x, &F);
            hand_slot("1c");
            strains(F, &linear, &green, &left);
            hand_principal(green, N);
            for (int a = 0; a < 3; a++)
                for (int i = 0; i < 2; i++)
                    middle[i] += x[2 * node[a] + i] / 3.0;
            for (int k = 0; k < 2; k++) {
                const double stretched[2] = {
                    F.m[0][0] * N[k][0] + F.m[0][1] * N[k][1],
                    F.m[1][0] * N[k][0] + F.m[1][1] * N[k][1]};
                hand_arrow(&picture, middle, stretched, 0.1);
                most = fmax(most, hypot(stretched[0], stretched[1]));
            }
            inverted += J[e] <= 0.0;
            sum += J[e] * mesh_gradients(mesh, e, gradient);
        }
        snprintf(picture.caption, sizeof picture.caption,
                 "%d of 12 inside out, longest stretch %.2f\n"
                 "sum of J area: %.2f m^2 (at rest 3.84)\n"
                 "drag a vertex",
                 inverted, most, sum);
        hand_draw(hand, &picture, inverted ? INVERTED : OK,
                  "inverted stretch area", (double[]){inverted, most, sum});
    }
    mesh_free(mesh);
    return hand_close(hand);
}
