/*
 * time_step.h - numbers of the time-stepping lesson.
 *
 * Source: an independent computation in Python (mpmath, numpy, scipy's
 * generalised eigenvalues) from the equations, not from this project's code;
 * rounded to doubles.  E = 1000, nu = 0.3, density 1.
 */
#ifndef TESTS_ORACLE_TIME_STEP_H
#define TESTS_ORACLE_TIME_STEP_H

/* Backward Euler of u'' = -w^2 u: amplitude and energy a step. */
static const struct {
    double w_dt, amplitude, energy;
} oracle_step[] = {{0.01, 0.9999500037496876, 0.9999000099990001},
                   {0.5, 0.8944271909999159, 0.8},
                   {2.0, 0.4472135954999579, 0.2},
                   {10.0, 0.09950371902099892, 0.009900990099009901}};

/* [u, v / w] for w dt = 1 from (1, 0) */
static const double oracle_sequence[][2] = {
    {1.0, 0.0},    {0.5, -0.5},   {0.0, -0.5},
    {-0.25, -0.25}, {-0.25, 0.0}, {-0.125, 0.125}};

/* M = 1, K = 100, u = 1, v = 0, dt = 1/30: the step, and what the residual as
 * Lecture 1 prints it gives */
static const double oracle_right = 0.9, oracle_printed = 0.0;

/* Bar fixed at 0, free at 1, continuous: modes 1, 3, 5. */
static const struct {
    double omega, hertz, a_frame, a_second, dt_one_percent;
} oracle_mode[] = {
    {57.6324689835152, 9.172492321316785, 0.46172966917145114,
     8.543453339122035e-11, 5.5509104067522435e-05},
    {288.16234491757604, 45.86246160658393, 0.10354834068654187,
     2.846389427457111e-30, 1.1101820813504487e-05},
    {518.6922208516369, 82.55243089185106, 0.0577412697322611,
     6.991814442875183e-38, 6.1676782297247146e-06}};

/* The largest stable step of symplectic Euler, [0] consistent, [1] lumped. */
static const struct {
    int n;
    double bound[2], dt[2];
    int a_frame; /* lumped steps in 1/30 s */
} oracle_bar[] = {
    {4, {0.003933978962347216, 0.006813851438692469},
     {0.004160912083215167, 0.006947342680235871}, 5},
    {10, {0.0015735915849388862, 0.0027255405754769875},
     {0.0015881444331358602, 0.002733968487909357}, 13},
    {32, {0.000491747370293402, 0.0008517314298365586},
     {0.0004921916857163367, 0.0008519880327030665}, 40}};
static const struct {
    int n;
    double dt[2], omega[2];
    int a_frame;
} oracle_square[] = {
    {2, {0.013475694134894526, 0.023340586908895244},
     {148.4153602760333, 85.68764820724313}, 2},
    {8, {0.0028041104912662046, 0.004880219792575043},
     {713.2386566896278, 409.8176076091651}, 7}};

#endif
