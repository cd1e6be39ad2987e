/* corners.c - see corners.h. */
#include "corners.h"

double corners_of(const struct scene *scene, int e, double x[6])
{
    double unused[6];
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++) {
            const int k = 2 * scene->mesh->triangle[3 * e + a] + i;
            x[2 * a + i] = scene->mesh->X[k] + scene->u[k];
        }
    return ((x[2] - x[0]) * (x[5] - x[1]) - (x[4] - x[0]) * (x[3] - x[1])) /
           (2.0 * mesh_gradients(scene->mesh, e, unused));
}
