/* Equations of motion with constraints, M a = f + G' z and G a = -b, as the solvers ask for them. A problem's file defines NQ, NL and
   terms(), with what the conditions of position and the part of their rates that is not G v are, and ends with this one. */

#ifdef EXTENDED
typedef long double real;
#define sin sinl
#define cos cosl
#define sqrt sqrtl
#else
typedef double real;
#endif

typedef struct {
    real m[NQ][NQ], f[NQ], g[NL][NQ], b[NL], position[NL], velocity[NL];
} Terms;

static void terms(real t, const real *q, const real *v, Terms *at);

/* Cholesky's factor in the lower half, the diagonal inverted. */
static inline __attribute__((always_inline)) void factor(int n, real a[n][n]) {
    for (int j = 0; j < n; j++) {
        for (int k = 0; k < j; k++)
            for (int i = j; i < n; i++) a[i][j] -= a[i][k] * a[j][k];
        real scale = 1.0 / sqrt(a[j][j]);
        for (int i = j + 1; i < n; i++) a[i][j] *= scale;
        a[j][j] = scale;
    }
}

static inline __attribute__((always_inline)) void forward(int n, real a[n][n], real *x) {
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) x[i] -= a[i][k] * x[k];
        x[i] *= a[i][i];
    }
}

static inline __attribute__((always_inline)) void backward(int n, real a[n][n], real *x) {
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) x[i] -= a[k][i] * x[k];
        x[i] *= a[i][i];
    }
}

/* The equations solved for accelerations and multipliers: y is q, v. */
static void solved(real t, const real *y, real *slope, real *z) {
    Terms at;
    real w[NL][NQ], s[NL][NL];
    terms(t, y, y + NQ, &at);
    factor(NQ, at.m);
    forward(NQ, at.m, at.f);
    for (int i = 0; i < NL; i++) {
        for (int k = 0; k < NQ; k++) w[i][k] = at.g[i][k];
        forward(NQ, at.m, w[i]);
        z[i] = -at.b[i];
        for (int k = 0; k < NQ; k++) z[i] -= w[i][k] * at.f[k];
        for (int j = 0; j <= i; j++) {
            s[i][j] = 0.0;
            for (int k = 0; k < NQ; k++) s[i][j] += w[i][k] * w[j][k];
        }
    }
    factor(NL, s);
    forward(NL, s, z);
    backward(NL, s, z);
    for (int i = 0; i < NL; i++)
        for (int k = 0; k < NQ; k++) at.f[k] += w[i][k] * z[i];
    backward(NQ, at.m, at.f);
    for (int k = 0; k < NQ; k++) {
        slope[k] = y[NQ + k];
        slope[NQ + k] = at.f[k];
    }
}

void ode(real t, const real *y, real *slope) {
    real z[NL];
    solved(t, y, slope, z);
}

void multipliers(real t, const real *y, real *z) {
    real slope[2 * NQ];
    solved(t, y, slope, z);
}

/* y is q, v, z; the conditions differentiated twice, of index 1. */
void index1(real t, const real *y, const real *slope, real *residual) {
    Terms at;
    terms(t, y, y + NQ, &at);
    for (int k = 0; k < NQ; k++) {
        residual[k] = slope[k] - y[NQ + k];
        residual[NQ + k] = -at.f[k];
        for (int j = 0; j < NQ; j++) residual[NQ + k] += at.m[k][j] * slope[NQ + j];
        for (int i = 0; i < NL; i++) residual[NQ + k] -= at.g[i][k] * y[2 * NQ + i];
    }
    for (int i = 0; i < NL; i++) {
        residual[2 * NQ + i] = at.b[i];
        for (int k = 0; k < NQ; k++) residual[2 * NQ + i] += at.g[i][k] * slope[NQ + k];
    }
}

/* y is q, v, z, u; positions and velocities both held, by Gear, Gupta and Leimkuhler, of index 2. */
void stabilised(real t, const real *y, const real *slope, real *residual) {
    Terms at;
    terms(t, y, y + NQ, &at);
    const real *z = y + 2 * NQ, *u = y + 2 * NQ + NL;
    for (int k = 0; k < NQ; k++) {
        residual[k] = slope[k] - y[NQ + k];
        residual[NQ + k] = -at.f[k];
        for (int j = 0; j < NQ; j++) residual[NQ + k] += at.m[k][j] * slope[NQ + j];
        for (int i = 0; i < NL; i++) {
            residual[k] -= at.g[i][k] * u[i];
            residual[NQ + k] -= at.g[i][k] * z[i];
        }
    }
    for (int i = 0; i < NL; i++) {
        residual[2 * NQ + i] = at.position[i];
        residual[2 * NQ + NL + i] = at.velocity[i];
        for (int k = 0; k < NQ; k++) residual[2 * NQ + NL + i] += at.g[i][k] * y[NQ + k];
    }
}

/* The same as the solvers want it called. */
#ifndef EXTENDED
extern double *N_VGetArrayPointer(void *);

int cvode_ode(double t, void *y, void *slope, void *unused) {
    ode(t, N_VGetArrayPointer(y), N_VGetArrayPointer(slope));
    return 0;
}

int ida_index1(double t, void *y, void *slope, void *residual, void *unused) {
    index1(t, N_VGetArrayPointer(y), N_VGetArrayPointer(slope), N_VGetArrayPointer(residual));
    return 0;
}

int ida_stabilised(double t, void *y, void *slope, void *residual, void *unused) {
    stabilised(t, N_VGetArrayPointer(y), N_VGetArrayPointer(slope), N_VGetArrayPointer(residual));
    return 0;
}

void cyrk_ode(double *slope, double t, double *y, char *unused, void *none) {
    ode(t, y, slope);
}
#endif
