/* system.c - see system.h. */
#include "plane/system.h"

#include <assert.h>
#include <stdlib.h>

void system_store(struct system *system, enum storage storage)
{
    struct scene *s = system->scene;
    if (s->body->K->storage != storage) body_store(s->body, storage);
    const struct incremental Phi = {s->set.dt, s->u, NULL};
    if (body_assemble(s->body, Phi, s->u, EXACT, system->b) != OK)
        die("the stretched body is not defined");
    for (int r = 0; r < s->n_dof; r++) system->b[r] = -system->b[r];
}

void system_press(struct system *system, double squeeze)
{
    struct scene *s = system->scene;
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    double *u = allocate((size_t)s->n_dof, sizeof *u);
    for (int r = 0; r < s->n_dof; r += 2) u[r] = -squeeze * s->mesh->X[r];
    const struct incremental Phi = {s->set.dt, u, NULL};
    if (body_assemble(s->body, Phi, u, EXACT, q) != OK)
        die("the pressed body is not defined");
    free(q);
    free(u);
}

struct system *system_alloc(int n)
{
    const struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct system *system = allocate(1, sizeof *system);
    assert(n >= 2);
    struct scene *s = system->scene = scene_alloc(&set);
    for (int r = 0; r < s->n_dof; r += 2) {
        const double *X = &s->mesh->X[r];
        s->u[r] = X[0] / 20.0;
        s->u[r + 1] = -(1.0 - X[0] * X[0]) * X[1] / 40.0;
    }
    system->b = allocate((size_t)s->n_dof, sizeof *system->b);
    system_store(system, s->body->K->storage);
    system->vertex = allocate((size_t)s->mesh->n_vertex, sizeof(int));
    for (int a = 0; a < s->mesh->n_vertex; a++)
        if (!s->held[a]) system->vertex[system->n_vertex++] = a;
    return system;
}

void system_free(struct system *system)
{
    if (!system) return;
    scene_free(system->scene);
    free(system->vertex);
    free(system->b);
    free(system);
}

static int place_of(const int place[], int v)
{
    return place ? place[v] : v;
}

/* Put entry k in its place; entries k - 1, k - 2, ... back to first ascend. */
static void insert(struct csr *A, int first, int k)
{
    for (; k > first && A->index[k - 1] > A->index[k]; k--) {
        const int column = A->index[k];
        const double value = A->value[k];
        A->index[k] = A->index[k - 1];
        A->index[k - 1] = column;
        A->value[k] = A->value[k - 1];
        A->value[k - 1] = value;
    }
}

struct csr *system_matrix(const struct system *system, const int place[])
{
    enum { NEXT = 7 }; /* a vertex and its neighbours */
    static const int step[NEXT][2] = {{-1, -1}, {0, -1}, {-1, 0}, {0, 0},
                                      {1, 0},   {0, 1},  {1, 1}};
    const struct body *body = system->scene->body;
    const int width = body->mesh->n - 1, height = body->mesh->n + 1;
    const int n = system->n_vertex;
    struct csr *A = csr_alloc(2 * n, 4 * NEXT * n);
    int *order = allocate((size_t)n, sizeof *order), k = 0;
    for (int v = 0; v < n; v++) order[place_of(place, v)] = v;
    for (int p = 0; p < n; p++)
        for (int c = 0; c < 2; c++) {
            const int v = order[p], row = 2 * p + c;
            const int equation = body->equation[2 * system->vertex[v] + c];
            for (int s = 0; s < NEXT; s++) {
                const int i = v % width + step[s][0];
                const int j = v / width + step[s][1], b = j * width + i;
                if (i < 0 || i >= width || j < 0 || j >= height) continue;
                const int *columns = &body->equation[2 * system->vertex[b]];
                for (int d = 0; d < 2; d++) {
                    A->index[k] = 2 * place_of(place, b) + d;
                    A->value[k] = matrix_get(body->K, equation, columns[d]);
                    insert(A, A->start[row], k++);
                }
            }
            A->start[row + 1] = k;
        }
    free(order);
    return A;
}

void system_right_side(const struct system *system, const int place[],
                       double b[])
{
    for (int v = 0; v < system->n_vertex; v++)
        for (int k = 0; k < 2; k++)
            b[2 * place_of(place, v) + k] =
                system->b[2 * system->vertex[v] + k];
}

void system_back(const struct system *system, const int place[],
                 const double x[], double du[])
{
    for (int v = 0; v < system->n_vertex; v++)
        for (int k = 0; k < 2; k++)
            du[2 * v + k] = x[2 * place_of(place, v) + k];
}
