/* numbering.c - see numbering.h. */
#include "plane/numbering.h"

#include "linear/sparse.h"

int numbering_lines(const struct mesh *mesh, const struct sparse *pattern,
                    int equation[])
{
    const int n = mesh->n, rows = mesh->rows, by_rows = n <= rows;
    int next = 0;
    for (int line = 0; line <= (by_rows ? rows : n); line++)
        for (int k = by_rows ? n : rows; k >= 0; k--) {
            const int a = by_rows ? line * (n + 1) + k : k * (n + 1) + line;
            for (int i = 0; i < 2; i++) {
                int *r = &equation[2 * a + i];
                if (*r < 0) continue;
                *r = pattern ? 2 * pattern->place[a] + i : next;
                next++;
            }
        }
    return next;
}

void numbering_order(int nodes, const int vertex[], const int equation[],
                     int order[])
{
    for (int a = 0; a < nodes; a++) { /* by insertion */
        int k = a;
        for (; k > 0; k--) {
            const int before = vertex[order[k - 1]];
            if (equation[2 * before] <= equation[2 * vertex[a]]) break;
            order[k] = order[k - 1];
        }
        order[k] = a;
    }
}

int numbering_half_bandwidth(struct numbering s)
{
    int widest = 0;
    for (int e = 0; e < s.n_element; e++) {
        const int *t = &s.vertex[s.nodes * e];
        const int last = s.equation[2 * t[s.nodes - 1]];
        for (int a = 0; a < s.nodes - 1; a++) { /* the last and a free one */
            const int low = s.equation[2 * t[a]];
            if (low >= 0 && last - low > widest) widest = last - low;
        }
    }
    return widest + 1; /* component 1 of the one, 0 of the other */
}

void numbering_places(struct numbering s, const struct matrix *K, int place[])
{
    for (int e = 0; e < s.n_element; e++)
        for (int a = 0; a < s.nodes; a++)
            for (int b = 0; b <= a; b++) {
                const int *t = &s.vertex[s.nodes * e];
                const int row = s.equation[2 * t[a]];
                const int column = s.equation[2 * t[b]];
                *place++ = column < 0 ? -1 : matrix_place(K, row, column);
            }
}
