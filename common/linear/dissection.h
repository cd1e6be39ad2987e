/*
 * dissection.h - nested dissection: an order in which elimination fills little.
 *
 * A line of vertices cuts a mesh of triangles in two that have no edge in
 * common.  They are numbered first, each cut in its turn, and the line last
 * [alg:dissection]:
 *
 *     0 0 0 6 3 3 3       a piece is a line, or a part that is not cut;
 *     0 0 0 6 3 3 3       in elimination the lines fill, and little else does:
 *     2 2 2 6 5 5 5       n^2 log n numbers and n^3 flops, where a band takes
 *     1 1 1 6 4 4 4       n^3 and n^4
 *     1 1 1 6 4 4 4
 *
 * Held vertices are left out.  Where triangles go over two columns or rows,
 * every second line may cut.
 *
 * Source: George, SIAM J. Numer. Anal. 10 (1973) 345.
 */
#ifndef COMMON_DISSECTION_H
#define COMMON_DISSECTION_H

struct piece {
    int first, count; /* its vertices have places first .. first + count - 1 */
    int depth;        /* so many lines cut it off */
    int child[2];     /* the last pieces of either side of a line, -1: none */
};

struct dissection {
    int n_vertex; /* free ones */
    int *place;   /* [vertices of the mesh] place in the order, -1: held */
    int n_piece;
    struct piece *piece; /* in the order: children before their line */
    int *start, *row;    /* row[start[v]] is place v; from there to start[v + 1]
                          * come its later neighbours, in no order */
};

/* Dissect a mesh whose vertex a = j columns + i is the i-th of row j.  held[a]
 * != 0: vertex a is left out; not all may be.  At most `leaf` >= 1 vertices are
 * not cut.  The caller frees it. */
struct dissection *dissection_alloc(int columns, int rows, int n_triangle,
                                    const int triangle[], const int held[],
                                    int leaf);
void dissection_free(struct dissection *dissection);

#endif
