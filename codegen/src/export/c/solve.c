/* Solves n equations, a row of a its coefficients and its right-hand side, by elimination with scaled partial pivoting. An unknown
   from determined on may have no pivot: it is 0 then, and 2 is returned. 1 where there is no solution. */
static int solve(int n, int determined, double a[UNKNOWNS + 1][UNKNOWNS + 2], double *x)
{
    double scale[UNKNOWNS + 1], most = 0.0;
    int column[UNKNOWNS + 1], rank = 0, i, j, row;
    for (i = 0; i < n; i++) {
        scale[i] = 0.0;
        for (j = 0; j < n; j++)
            scale[i] = fmax(scale[i], fabs(a[i][j]));
        if (!(scale[i] > 0.0))
            return 1;
        most = fmax(most, fabs(a[i][n])/scale[i]);
        x[i] = 0.0;
    }
    for (i = 0; i < n; i++) {
        int best = rank;
        double size;
        for (row = rank + 1; row < n; row++)
            if (fabs(a[row][i])*scale[best] > fabs(a[best][i])*scale[row])
                best = row;
        if (!(rank < n && fabs(a[best][i]) > 1e-12*scale[best])) {
            if (i < determined)
                return 1;
            continue;
        }
        for (j = i; j <= n; j++) {
            const double swapped = a[rank][j];
            a[rank][j] = a[best][j];
            a[best][j] = swapped;
        }
        size = scale[rank];
        scale[rank] = scale[best];
        scale[best] = size;
        for (row = rank + 1; row < n; row++) {
            const double factor = a[row][i]/a[rank][i];
            for (j = i + 1; j <= n; j++)
                a[row][j] -= factor*a[rank][j];
        }
        column[rank++] = i;
    }
    for (row = rank; row < n; row++)
        if (!(fabs(a[row][n]) <= 1e-9*most*scale[row]))
            return 1;
    for (row = rank - 1; row >= 0; row--) {
        double sum = a[row][n];
        for (j = row + 1; j < rank; j++)
            sum -= a[row][column[j]]*x[column[j]];
        x[column[row]] = sum/a[row][column[row]];
    }
    return rank < n ? 2 : 0;
}

/* The slip of a contact that slides on it; -1 of others. */
static int slip_of(const int *set, int row)
{
    int slip;
    for (slip = SLIPS; row < CONTACTS && set[row] == 2 && slip < ROWS; slip++)
        if (contact_of[slip] == row)
            return slip;
    return -1;
}

/* Whether a row holds: of every joint, of a contact that is closed, of a slip where its contact does not slide. */
static int holds(const int *set, int row)
{
    if (contact_of[row] < 0)
        return contact_of[row] == JOINT;
    return row < SLIPS ? set[row] != 0 : set[contact_of[row]] == 1;
}

/* The motion in a contact set; R = -friction*N where a contact slides, which is a part of its column. */
static int motion(const model_equations *e, const int *set, double *acceleration, double *multiplier)
{
    double a[UNKNOWNS + 1][UNKNOWNS + 2], x[UNKNOWNS + 1];
    int held[ROWS + 1] = {0}, count = 0, row, i, j, n, status;
    for (row = 0; row < ROWS; row++)
        if (holds(set, row))
            held[count++] = row;
    n = COORDINATES + count;
    for (i = 0; i < COORDINATES; i++) {
        for (j = 0; j < COORDINATES; j++)
            a[i][j] = e->mass[i][j];
        for (j = 0; j < count; j++) {
            const int slip = slip_of(set, held[j]);
            a[i][COORDINATES + j] = -e->jacobian[held[j]][i];
            if (slip >= 0)
                a[i][COORDINATES + j] += e->friction[slip]*e->jacobian[slip][i];
        }
        a[i][n] = e->force[i];
    }
    for (i = 0; i < count; i++) {
        for (j = 0; j < COORDINATES; j++)
            a[COORDINATES + i][j] = e->jacobian[held[i]][j];
        for (j = 0; j < count; j++)
            a[COORDINATES + i][COORDINATES + j] = 0.0;
        a[COORDINATES + i][n] = -e->bias[held[i]];
    }
    status = solve(n, COORDINATES, a, x);
    if (status == 1)
        return 1;
    for (i = 0; i < COORDINATES; i++)
        acceleration[i] = x[i];
    for (row = 0; row < ROWS; row++)
        multiplier[row] = 0.0;
    for (i = 0; i < count; i++) {
        const int slip = slip_of(set, held[i]);
        multiplier[held[i]] = x[COORDINATES + i];
        if (slip >= 0)
            multiplier[slip] = -e->friction[slip]*x[COORDINATES + i];
    }
    return status;
}

