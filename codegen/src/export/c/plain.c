int model_accelerations(const model_constants *k, const int *set, const double *state, double *acceleration,
    double *multiplier)
{
    model_equations e;
    model_equations_of(k, state, &e);
    return motion(&e, set, acceleration, multiplier);
}

