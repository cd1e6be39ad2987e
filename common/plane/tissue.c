/* tissue.c - see tissue.h. */
#include "plane/tissue.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>

struct tissue tissue_alloc(struct mesh *mesh)
{
    const size_t n = (size_t)mesh->n_vertex;
    return (struct tissue){
        mesh, allocate(n, sizeof(int)), allocate(2 * n, sizeof(double)),
        allocate(2 * n, sizeof(double)), allocate(n, sizeof(double)),
        allocate(2 * n, sizeof(double))};
}

void tissue_free(struct tissue s)
{
    mesh_free(s.mesh);
    free(s.held);
    free(s.u);
    free(s.v);
    free(s.mass);
    free(s.f);
}

static void ends(const int t[], int c, int end[2])
{
    end[0] = t[c / 3 * 3 + (c + 1) % 3];
    end[1] = t[c / 3 * 3 + (c + 2) % 3];
}

struct tissue_whole tissue_hold(const struct tissue *square, double pull)
{
    const struct mesh *mesh = square->mesh;
    const struct tissue_whole whole = {
        mesh, mesh_across(mesh),
        allocate(3 * (size_t)mesh->n_triangle, sizeof(int)), {pull, 0.0}, 1.0};
    for (int a = 0; a < mesh->n_vertex; a++)
        square->held[a] = mesh->X[2 * a] == -1.0;
    for (int c = 0; c < 3 * mesh->n_triangle; c++) {
        int end[2];
        ends(mesh->triangle, c, end);
        whole.pulled[c] =
            mesh->X[2 * end[0]] == 1.0 && mesh->X[2 * end[1]] == 1.0;
    }
    return whole;
}

struct mesh *tissue_section(int wide, int high, double width, double height)
{
    struct mesh *mesh = mesh_rectangle(high, wide, 0.5 * height, 0.5 * width);
    for (int a = 0; a < mesh->n_vertex; a++) { /* turned by a right angle */
        double *X = &mesh->X[2 * a];
        const double up = -X[0];
        X[0] = X[1];
        X[1] = up;
    }
    return mesh;
}

enum { STRIP_WIDE = 50, STRIP_HIGH = 15 }; /* cells */

struct tissue tissue_strip(void)
{
    const double scale = sqrt(1000.0);
    return tissue_alloc(tissue_section(STRIP_WIDE, STRIP_HIGH, 0.1 * scale,
                                       0.03 * scale));
}

struct tissue_whole tissue_on_bone(const struct tissue *strip)
{
    const struct mesh *mesh = strip->mesh;
    for (int a = STRIP_HIGH; a < mesh->n_vertex; a += STRIP_HIGH + 1)
        strip->held[a] = 1;
    return (struct tissue_whole){
        mesh, mesh_across(mesh),
        allocate(3 * (size_t)mesh->n_triangle, sizeof(int)), {0.0}, 1.0};
}

int tissue_nearest(const struct mesh *mesh, const double x[2])
{
    int best = 0;
    double least = INFINITY;
    for (int a = 0; a < mesh->n_vertex; a++) {
        const double *X = &mesh->X[2 * a];
        const double d = hypot(X[0] - x[0], X[1] - x[1]);
        if (d < least) best = a, least = d;
    }
    return best;
}

void tissue_mark(const struct mesh *mesh, int n, const int chain[], int cut[])
{
    for (int c = 0; c < 3 * mesh->n_triangle; c++) {
        int end[2];
        ends(mesh->triangle, c, end);
        for (int k = 1; k < n; k++) {
            const int a = chain[k - 1], b = chain[k];
            if ((end[0] == a && end[1] == b) || (end[0] == b && end[1] == a))
                cut[c] = 1;
        }
    }
}

void tissue_label(const struct mesh *mesh, int part[])
{
    for (int a = 0; a < mesh->n_vertex; a++) part[a] = a;
    for (int again = 1; again;) { /* until each has the first of its part */
        again = 0;
        for (int c = 0; c < 3 * mesh->n_triangle; c++) {
            int end[2];
            ends(mesh->triangle, c, end);
            int *a = &part[end[0]], *b = &part[end[1]];
            again |= *a != *b;
            *a = *b = *a < *b ? *a : *b;
        }
    }
}

int tissue_parts(const struct tissue *s, int *loose)
{
    const size_t n = (size_t)s->mesh->n_vertex;
    int *part = allocate(n, sizeof *part), *holds = allocate(n, sizeof *holds);
    int parts = 0;
    tissue_label(s->mesh, part);
    for (int a = 0; a < s->mesh->n_vertex; a++) holds[part[a]] += s->held[a];
    *loose = 0;
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        parts += part[a] == a;
        *loose += part[a] == a && holds[a] < 2;
    }
    free(holds);
    free(part);
    return parts;
}

double tissue_opening(const struct mesh *mesh, const double u[])
{
    double widest = 0.0;
    const double *X = mesh->X;
    for (int a = 0; a < mesh->n_vertex; a++)
        for (int b = a + 1; b < mesh->n_vertex && X[2 * a] == X[2 * b] &&
                            X[2 * a + 1] == X[2 * b + 1]; b++)
            widest = fmax(widest, hypot(u[2 * a] - u[2 * b],
                                        u[2 * a + 1] - u[2 * b + 1]));
    return widest;
}

struct tissue_border tissue_border_alloc(struct body *const body[2])
{
    const struct mesh *mesh = body[1]->mesh;
    const struct matrix *K = body[1]->K;
    const int n = body[0]->n_equation, N = body[1]->n_equation;
    const struct tissue_border s = {
        allocate((size_t)N, sizeof(int)), allocate((size_t)N, sizeof(int)),
        allocate((size_t)n * (size_t)(N - n), sizeof(double)),
        matrix_alloc(DENSE, N - n, 0)};
    int *seen = allocate((size_t)n, sizeof *seen), k = 0;
    for (int i = 0; i < N; i++) s.old[i] = -1;
    for (int c = 0; c < 6 * mesh->n_triangle; c++) {
        const int row = 2 * mesh->triangle[c / 2] + c % 2;
        const int was = 2 * body[0]->mesh->triangle[c / 2] + c % 2;
        const int i = body[1]->equation[row], j = body[0]->equation[was];
        if (i < 0 || s.old[i] >= 0) continue;
        s.old[i] = j;
        s.jump[i] = seen[j]++ ? k++ : -1;
    }
    for (int i = 0; i < N; i++)
        for (int j = i < K->p ? 0 : i - K->p; j <= i + K->p && j < N; j++) {
            const double K_ij = matrix_get(K, i, j);
            if (s.jump[j] < 0) continue;
            /* the columns of d: B in the rows of y, C in those of d */
            s.B[(size_t)n * (size_t)s.jump[j] + (size_t)s.old[i]] += K_ij;
            if (s.jump[i] >= 0) matrix_add(s.C, s.jump[i], s.jump[j], K_ij);
        }
    free(seen);
    return s;
}

void tissue_border_free(struct tissue_border s)
{
    free(s.old);
    free(s.jump);
    free(s.B);
    matrix_free(s.C);
}
