/*
 * robustness.h - two-dimensional steps that converge or fail, independently.
 *
 * Source: Python with numpy, written from the energies and not from this
 * project's code; rounded to doubles.  E = 1000, nu = 0.3, rho = 1, consistent
 * mass, dt = 1/30 unless said otherwise; (-1,1)^2, both ends prescribed.
 */
#ifndef TESTS_ORACLE_ROBUSTNESS_H
#define TESTS_ORACLE_ROBUSTNESS_H

/*
 * One step from rest, both ends shifted by jump h, h = 2/n.  Plain Newton from
 * the last u with either law, and from the shifted square with CUBIC:
 * iterations, negative where it failed; and min J of the answers, cubic and log
 * (0: none was computed).
 */
static const struct {
    int n;
    double jump;
    int cubic, log, shifted;
    double min_J, min_J_log;
} oracle_step[] = {
    {8, 0.25, 5, 5, 4,
     0.9701771940414249, 0.970182657812817},
    {8, 0.75, 6, 8, 4,
     0.9133728951635546, 0.9135150001968988},
    {8, 0.85, 7, -3, 4,
     0.9024502030420722, 0.9026552254005293},
    {8, 0.95, -13, -2, 5,
     0.8916688796905233, 0.8919524382299403},
    {8, 1.5, -12, -1, 5,
     0.8348077868547155, 0.8358603394760278},
    {8, 3.0, -30, -1, 5,
     0.6935689147982171, 0.7020832792771992},
    {16, 0.25, 5, 5, 4,
     0.9822893798305534, 0.982290590714352},
    {16, 0.75, 6, 8, 4,
     0.9474257410658822, 0.9474586043289921},
    {16, 0.85, 7, -3, 4,
     0.9405395489835441, 0.9405874231106345},
    {16, 0.95, -18, -2, 4,
     0.9336814669120166, 0.9337483460347938},
    {16, 1.5, -9, -1, 4,
     0.8964505696625564, 0.8967143273398661},
    {16, 3.0, -5, -1, 5,
     0.7987873297385981, 0.8008820517344031},
    {16, 0.26661728669402895, 5, 5, 4,
     0.9811188701579123, 0.9811203392210003},
    {40, 0.6665432167350724, 6, 7, 4,
     0.9750631033460463, 0.9750660348599596},
};

/*
 * Linear elasticity, clamped at X1 = -1, body force (0,-1): vertical
 * displacement of vertex (1,0) for n = 4, 8, 16, 32, and the reference, of
 * bilinear quadrilaterals with the volume change at one point, 64 x 64.
 */
static const struct {
    double nu, u[4], reference;
} oracle_locking[] = {
    {0.3,
     {-0.009575259599249573, -0.010555541911572935,
      -0.010958601466248278, -0.01110267783318189},
     -0.01117176656958354},
    {0.49,
     {-0.00720184351558431, -0.008147874375589384,
      -0.009214323382720081, -0.009932402528119737},
     -0.010553785978897308},
    {0.4999,
     {-0.006576103629601912, -0.006597239087851025,
      -0.006692048593043398, -0.007014524289671029},
     -0.010491906134727268},
};

#endif
