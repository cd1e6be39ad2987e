/*
 * Where linear elasticity leaves the logarithmic law by 1, 5 and 10 % of the
 * stress, in uniaxial strain, E = 1000, nu = 0.3; and the angle
 * by which a rotation shows linear elasticity a strain of so much.  Computed
 * independently with 50 digits (mpmath).
 */
static const struct {
    double off;             /* relative */
    double tension;         /* F - 1, linear */
    double compression;     /* F - 1, linear */
    double degrees;         /* cos = 1 - off */
} oracle_threshold[] = {
    {0.01, 0.010795498589063824, -0.010743244920793262, 8.109614455994178},
    {0.05, 0.05451713478548569, -0.05321043554622907, 18.19487233876678},
    {0.10, 0.11044919438708695, -0.10521792866587314, 25.84193276316713},
};
