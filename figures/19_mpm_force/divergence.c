/*
 * divergence.c - with respect to what is the divergence of P taken?
 *
 * A smooth motion of a square and its stress P, P = J sigma F^-T.  The notes
 * print the divergence of P with respect to x; the momentum balance has the one
 * with respect to X, which is J times the divergence of sigma with respect to
 * x.
 */
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

/* phi = (X + .21 sin 1.3 Y + .07 X Y, Y + .17 X^2 - .11 cos 2.1 X). */
static mat2 gradient(const double X[2])
{
    return (mat2){
        {{1.0 + 0.07 * X[1], 0.21 * 1.3 * cos(1.3 * X[1]) + 0.07 * X[0]},
         {0.34 * X[0] + 0.231 * sin(2.1 * X[0]), 1.0}}};
}

static mat2 stress(const double X[2], int cauchy)
{
    const struct material law = material_notes(CUBIC);
    const mat2 F = gradient(X), P = material2_pk1(&law, F);
    return cauchy ? mat2_scale(1.0 / mat2_det(F),
                               mat2_multiply(P, mat2_transpose(F)))
                  : P;
}

/* The divergence of the tensor whose derivative along X_K is D[K], with respect
 * to x: d/dx_l = F^-1_Kl d/dX_K. */
static void divergence(const double X[2], int cauchy, int in_x, double div[2])
{
    const double step = 1e-5; /* errors 1e-10 of third derivatives */
    const mat2 F = gradient(X), cof = mat2_cofactor(F);
    div[0] = div[1] = 0.0;
    for (int K = 0; K < 2; K++) {
        double more[2] = {X[0], X[1]}, less[2] = {X[0], X[1]};
        more[K] += step;
        less[K] -= step;
        const mat2 D =
            mat2_scale(0.5 / step, mat2_subtract(stress(more, cauchy),
                                                 stress(less, cauchy)));
        for (int i = 0; i < 2; i++)
            for (int l = 0; l < 2; l++) /* F^-1_Kl = cof_lK / J */
                div[i] += D.m[i][l] *
                          (in_x ? cof.m[l][K] / mat2_det(F) : (double)(l == K));
    }
}

static void row(double X, double Y, double got[6])
{
    const double at[2] = {X, Y}, J = mat2_det(gradient(at));
    divergence(at, 0, 0, got);
    divergence(at, 0, 1, got + 2);
    divergence(at, 1, 1, got + 4);
    got[4] *= J;
    got[5] *= J;
    table_row(X, Y, X + 0.21 * sin(1.3 * Y) + 0.07 * X * Y,
              Y + 0.17 * X * X - 0.11 * cos(2.1 * X), got[0], got[1], got[2],
              got[3], got[4], got[5]);
    claim(hypot(got[0] - got[4], got[1] - got[5]) < 1e-5,
          "Div P is J div sigma");
}

#define COLUMNS "X Y x y Div_X_1 Div_X_2 div_x_1 div_x_2 J_div_1 J_div_2"
int main(void)
{
    double got[6];
    table_begin("point", COLUMNS);
    row(0.7132, 0.5817, got);
    table_end();
    claim(hypot(got[0] + 344.66025925220197, got[1] - 407.30080467585407) <
              1e-5,
          "Div_X P at the point (%.9g, %.9g)", got[0], got[1]);
    claim(hypot(got[2] - got[0], got[3] - got[1]) > 200.0,
          "as printed it is another vector (%g, %g)", got[2], got[3]);
    table_begin("square", COLUMNS);
    for (int j = 0; j <= 8; j += 2)
        for (int i = 0; i <= 8; i += 2) row(i / 8.0, j / 8.0, got);
    table_end();
    return table_finish();
}
