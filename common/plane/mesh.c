/* mesh.c - see mesh.h. */
#include "plane/mesh.h"

#include "base/status.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct mesh *mesh_square(int n)
{
    return mesh_rectangle(n, n, 1.0, 1.0);
}

struct mesh *mesh_rectangle(int n, int rows, double a, double b)
{
    assert(n > 0 && rows > 0);
    struct mesh *mesh = allocate(1, sizeof *mesh);
    mesh->n = n;
    mesh->rows = rows;
    mesh->n_vertex = (n + 1) * (rows + 1);
    mesh->n_triangle = 2 * n * rows;
    mesh->X = allocate(2 * (size_t)mesh->n_vertex, sizeof *mesh->X);
    mesh->triangle = allocate(3 * (size_t)mesh->n_triangle, sizeof(int));
    double *X = mesh->X;
    for (int j = 0; j <= rows; j++)
        for (int i = 0; i <= n; i++) {
            *X++ = a * (-1.0 + 2.0 * i / n);
            *X++ = b * (-1.0 + 2.0 * j / rows);
        }
    int *t = mesh->triangle;
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < n; i++) {
            const int low = j * (n + 1) + i, up = low + n + 1; /* on the left */
            *t++ = low, *t++ = low + 1, *t++ = up + 1;
            *t++ = low, *t++ = up + 1, *t++ = up;
        }
    return mesh;
}

/* A row of three vertices, and no cells above it: so numbering.c numbers it. */
struct mesh *mesh_triangle(const double X[6])
{
    struct mesh *mesh = allocate(1, sizeof *mesh);
    *mesh = (struct mesh){.n = 2, .rows = 0, .n_vertex = 3, .n_triangle = 1};
    mesh->X = allocate(6, sizeof *mesh->X);
    mesh->triangle = allocate(3, sizeof *mesh->triangle);
    memcpy(mesh->X, X, 6 * sizeof *X);
    for (int a = 0; a < 3; a++) mesh->triangle[a] = a;
    return mesh;
}

void mesh_free(struct mesh *mesh)
{
    if (!mesh) return;
    free(mesh->X);
    free(mesh->triangle);
    free(mesh);
}

void mesh_grade(struct mesh *mesh, double m, int sides)
{
    mesh->graded = 1;
    for (int j = 0; j < 2; j++) {
        const double half = -mesh->X[j]; /* vertex 0 is a corner */
        const double L = 0.5 * half; /* d, from a side, becomes L (d/L)^m */
        for (int a = 0; a < mesh->n_vertex; a++) {
            double *x = &mesh->X[2 * a + j];
            const int side = (*x < 0.0 ? MESH_LEFT : MESH_RIGHT) << 2 * j;
            const double d = half - fabs(*x);
            if (sides & side && d < L)
                *x = copysign(half - L * pow(d / L, m), *x);
        }
    }
}

double mesh_gradients(const struct mesh *mesh, int e, double gradient[6])
{
    return mesh_gradients_of(mesh, &mesh->triangle[3 * e], gradient);
}

double mesh_gradients_of(const struct mesh *mesh, const int t[3],
                         double gradient[6])
{
    const double *X[3] = {&mesh->X[2 * t[0]], &mesh->X[2 * t[1]],
                          &mesh->X[2 * t[2]]};
    const double twice = (X[1][0] - X[0][0]) * (X[2][1] - X[0][1]) -
                         (X[2][0] - X[0][0]) * (X[1][1] - X[0][1]);
    for (int a = 0; a < 3; a++) { /* the opposite edge, turned by 90 degrees */
        const double *tail = X[(a + 1) % 3], *head = X[(a + 2) % 3];
        gradient[2 * a] = -(head[1] - tail[1]) / twice;
        gradient[2 * a + 1] = (head[0] - tail[0]) / twice;
    }
    return 0.5 * twice;
}

int mesh_clockwise(const struct mesh *mesh)
{
    double gradient[6];
    for (int e = 0; e < mesh->n_triangle; e++)
        if (!(mesh_gradients(mesh, e, gradient) > 0.0)) return e;
    return -1;
}

void mesh_angles(const struct mesh *mesh, const double u[], double angle[])
{
    memset(angle, 0, (size_t)mesh->n_vertex * sizeof *angle);
    for (int e = 0; e < mesh->n_triangle; e++) {
        const int *t = &mesh->triangle[3 * e];
        for (int k = 0; k < 3; k++) {
            double side[2][2];
            for (int s = 0; s < 2; s++)
                for (int i = 0; i < 2; i++) {
                    const int end = 2 * t[(k + 1 + s) % 3] + i;
                    const int corner = 2 * t[k] + i;
                    side[s][i] = mesh->X[end] + (u ? u[end] : 0.0) -
                                 mesh->X[corner] - (u ? u[corner] : 0.0);
                }
            /* |side 0| |side 1| times sine and cosine of the angle */
            angle[t[k]] += atan2(side[0][0] * side[1][1] -
                                     side[0][1] * side[1][0],
                                 side[0][0] * side[1][0] +
                                     side[0][1] * side[1][1]);
        }
    }
}

/* Return whether vertex a is one of triangle e. */
static int has(const struct mesh *mesh, int e, int a)
{
    const int *t = &mesh->triangle[3 * e];
    return t[0] == a || t[1] == a || t[2] == a;
}

int *mesh_across(const struct mesh *mesh)
{
    enum { MOST = 8 };
    const size_t vertices = (size_t)mesh->n_vertex;
    int *opposite = allocate(3 * (size_t)mesh->n_triangle, sizeof *opposite);
    int *around = allocate(MOST * vertices, sizeof *around); /* a vertex */
    int *n = allocate(vertices, sizeof *n);                  /* so many */
    for (int r = 0; r < 3 * mesh->n_triangle; r++) {
        const int a = mesh->triangle[r];
        assert(n[a] < MOST);
        around[MOST * a + n[a]++] = r / 3;
    }
    for (int e = 0; e < mesh->n_triangle; e++)
        for (int k = 0; k < 3; k++) {
            const int a = mesh->triangle[3 * e + (k + 1) % 3];
            const int b = mesh->triangle[3 * e + (k + 2) % 3];
            opposite[3 * e + k] = e;
            for (int i = 0; i < n[a]; i++) {
                const int beyond = around[MOST * a + i];
                if (beyond != e && has(mesh, beyond, b))
                    opposite[3 * e + k] = beyond;
            }
        }
    free(around);
    free(n);
    return opposite;
}
