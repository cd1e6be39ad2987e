/*
 * 26_cut.h - a cut: the stress at its tip, its counts, and the stiffness of the
 * body.
 *
 * How strongly a cut at the side of a pulled strip concentrates the stress:
 * K_I = s sqrt(pi a) F(a / b), far ends pulled by s.
 *
 * Source: H. Tada, P. C. Paris and G. R. Irwin, The Stress Analysis of Cracks
 * Handbook (3rd edition, ASME Press, 2000), single edge notch test specimen:
 * two formulas, each said to be within 0.5 per cent, the first up to r = 0.6.
 *
 *     F(r) = 1.12 - 0.231 r + 10.55 r^2 - 21.72 r^3 + 30.39 r^4
 *     F(r) = sqrt(2 / (pi r) tan(pi r / 2)) / cos(pi r / 2)
 *            (0.752 + 2.02 r + 0.37 (1 - sin(pi r / 2))^3)
 *
 * Evaluated by Python, independent of this project.
 *
 * What a cut adds to the counts of a mesh: counted by hand on paper; Euler's
 * number is that of the parts less that of the holes.
 *
 * The eigenvalues of K at rest: a plain program that shares no code with
 * common/, and GSL's gsl_eigen_symm().  A part of the body has as many zeros as
 * it has rigid motions: three, one if a vertex of it is held, none if two are.
 *
 * Source: O. C. Zienkiewicz and R. L. Taylor, The Finite Element Method, volume
 * 1 (5th edition, Butterworth-Heinemann, 2000), chapter 4: the triangle of
 * constant strain, K = sum of A B^T D B, with D of plane strain.
 */
#ifndef TESTS_ORACLE_26_CUT_H
#define TESTS_ORACLE_26_CUT_H

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_sort_vector.h>

static const struct {
    double r, polynomial, closed;
} oracle_edge_crack[] = {{0.2, 1.370664, 1.366661},
                         {0.3, 1.659919, 1.655113},
                         {0.4, 2.103504, 2.107964},
                         {0.5, 2.826375, 2.826581},
                         {0.6, 4.026424, 4.043210}};

/* The boundary has so many edges; parts hang together by edges; V - E + T. */
struct oracle_counts {
    int vertices, boundary, parts, euler;
};

/* On 6 x 6 squares, vertices (i, j): a chain of up to 12, closed or not, and
 * another that crosses it. */
static const struct {
    const char *name;
    int length[2];
    int at[2][12][2];
    struct oracle_counts added; /* beyond 49 vertices, 24 edges, 1 part, 1 */
    int motions;                /* of parts that are not held by two vertices */
} oracle_cuts[] = {
    {"three edges inwards from the upper side", {4, 0},
     {{{3, 6}, {3, 5}, {3, 4}, {3, 3}}}, {3, 6, 0, 0}, 0},
    {"three edges inside", {4, 0}, {{{2, 3}, {3, 3}, {4, 4}, {4, 5}}},
     {2, 6, 0, -1}, 0},
    {"a cut from side to side", {7, 0},
     {{{3, 0}, {3, 1}, {3, 2}, {3, 3}, {4, 4}, {4, 5}, {4, 6}}},
     {7, 12, 1, 1}, 3},
    {"a ring of eight edges", {9, 0},
     {{{2, 2}, {3, 2}, {4, 2}, {4, 3}, {4, 4}, {3, 4}, {2, 4}, {2, 3},
       {2, 2}}}, {8, 16, 1, 0}, 3},
    {"two cuts of four edges that cross", {5, 5},
     {{{1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}},
      {{3, 1}, {3, 2}, {3, 3}, {3, 4}, {3, 5}}}, {7, 16, 0, -1}, 0},
    {"a cut that ends on another one", {5, 3},
     {{{1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}},
      {{3, 5}, {3, 4}, {3, 3}}}, {5, 12, 0, -1}, 0},
    {"a corner", {2, 0}, {{{5, 0}, {6, 1}}}, {2, 2, 1, 1}, 3},
    {"a triangle held by one vertex", {4, 0},
     {{{0, 3}, {1, 3}, {1, 4}, {0, 3}}}, {4, 6, 1, 1}, 1},
};

/* Fill value[] with the eigenvalues from the smallest to the largest, without
 * the held vertices, of 1024 at most, and return how many there are. */
static inline int oracle_spectrum(int n_vertex, const int held[],
                                  const double X[], int n_triangle,
                                  const int triangle[], double mu,
                                  double lambda, double value[])
{
    const double D[3][3] = {{lambda + 2.0 * mu, lambda, 0.0},
                            {lambda, lambda + 2.0 * mu, 0.0},
                            {0.0, 0.0, mu}};
    size_t row[1024], order = 0; /* of u of a vertex in x */
    for (int a = 0; a < n_vertex; a++) {
        row[a] = order;
        order += held[a] ? 0 : 2;
    }
    gsl_matrix *K = gsl_matrix_calloc(order, order);
    for (int e = 0; e < n_triangle; e++) {
        const int *t = &triangle[3 * e];
        const double *P = &X[2 * t[0]], *Q = &X[2 * t[1]], *R = &X[2 * t[2]];
        const double twice = (Q[0] - P[0]) * (R[1] - P[1]) -
                             (R[0] - P[0]) * (Q[1] - P[1]); /* 2 A */
        const double b[3] = {Q[1] - R[1], R[1] - P[1], P[1] - Q[1]};
        const double c[3] = {R[0] - Q[0], P[0] - R[0], Q[0] - P[0]};
        double B[3][6];
        for (int k = 0; k < 6; k++) { /* strains of x, of y, and shear */
            B[0][k] = k % 2 ? 0.0 : b[k / 2] / twice;
            B[1][k] = k % 2 ? c[k / 2] / twice : 0.0;
            B[2][k] = (k % 2 ? b : c)[k / 2] / twice;
        }
        for (int k = 0; k < 36; k++) {
            const int i = k / 6, j = k % 6;
            if (held[t[i / 2]] || held[t[j / 2]]) continue;
            double *K_ij = gsl_matrix_ptr(K, row[t[i / 2]] + (size_t)(i % 2),
                                          row[t[j / 2]] + (size_t)(j % 2));
            for (int r = 0; r < 9; r++)
                *K_ij += 0.5 * twice * B[r / 3][i] * D[r / 3][r % 3] *
                         B[r % 3][j];
        }
    }
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(order);
    gsl_vector_view all = gsl_vector_view_array(value, order);
    gsl_eigen_symm(K, &all.vector, work);
    gsl_sort_vector(&all.vector);
    gsl_eigen_symm_free(work);
    gsl_matrix_free(K);
    return (int)order;
}

#endif
