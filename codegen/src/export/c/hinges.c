/* A journal that turns in its bearing rubs with R = -friction*N, N the length of the force of its hinge, which R is a part of: N by
   iteration, which converges where journals are small against their bodies. */
int model_accelerations(const model_constants *k, const int *set, const double *state, double *acceleration,
    double *multiplier)
{
    model_equations free, e;
    double normal[CONTACTS + 1] = {0.0}, force[2*HINGES];
    int step, hinge, slip, i, status;
    model_equations_of(k, state, &free);
    for (step = 0; step < 200; step++) {
        double change = 0.0, most = 0.0;
        e = free;
        for (slip = SLIPS; slip < ROWS; slip++)
            for (hinge = 0; hinge < HINGES; hinge++)
                if (contact_of[slip] == hinges[hinge] && set[hinges[hinge]] == 2)
                    for (i = 0; i < COORDINATES; i++)
                        e.force[i] -= e.friction[slip]*normal[hinges[hinge]]*e.jacobian[slip][i];
        status = motion(&e, set, acceleration, multiplier);
        if (status == 1)
            return 1;
        hinge_forces(k, state, acceleration, multiplier, force);
        for (hinge = 0; hinge < HINGES; hinge++) {
            const int contact = hinges[hinge];
            const double size = sqrt(force[2*hinge]*force[2*hinge] + force[2*hinge + 1]*force[2*hinge + 1]);
            if (set[contact] == 0)
                continue;
            if (set[contact] == 2)
                change = fmax(change, fabs(size - normal[contact]));
            most = fmax(most, size);
            normal[contact] = size;
            multiplier[contact] = size;
            for (slip = SLIPS; slip < ROWS; slip++)
                if (contact_of[slip] == contact && set[contact] == 2)
                    multiplier[slip] = -e.friction[slip]*size;
        }
        if (change <= 1e-14*most)
            return status;
    }
    return 1;
}

