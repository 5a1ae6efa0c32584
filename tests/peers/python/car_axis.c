/* The car axis of the Test Set for IVP Solvers, release 2.4, problem caraxis. */
#include <math.h>
#define NQ 4
#define NL 2
#include "solve.h"

static const real l = 1.0, l0 = 0.5, eps = 1e-2, mass = 10.0, r = 0.1, omega = 10.0;

static void terms(real t, const real *q, const real *v, Terms *at) {
    real xl = q[0], yl = q[1], xr = q[2], yr = q[3], k = 0.5 * eps * eps * mass;
    real yb = r * sin(omega * t), yb1 = r * omega * cos(omega * t), yb2 = -omega * omega * yb;
    real xb = sqrt(l * l - yb * yb), xb1 = -yb * yb1 / xb, xb2 = -(yb1 * yb1 + yb * yb2 + xb1 * xb1) / xb;
    real ll = sqrt(xl * xl + yl * yl), lr = sqrt((xr - xb) * (xr - xb) + (yr - yb) * (yr - yb));
    real fl = (l0 - ll) / ll, fr = (l0 - lr) / lr, dx = xl - xr, dy = yl - yr, du = v[0] - v[2], dv = v[1] - v[3];
    for (int i = 0; i < NQ; i++)
        for (int j = 0; j < NQ; j++) at->m[i][j] = i == j ? k : 0.0;
    at->f[0] = fl * xl, at->f[1] = fl * yl - k;
    at->f[2] = fr * (xr - xb), at->f[3] = fr * (yr - yb) - k;
    at->g[0][0] = xb, at->g[0][1] = yb, at->g[0][2] = at->g[0][3] = 0.0;
    at->g[1][0] = 2 * dx, at->g[1][1] = 2 * dy, at->g[1][2] = -2 * dx, at->g[1][3] = -2 * dy;
    at->b[0] = 2 * (v[0] * xb1 + v[1] * yb1) + xl * xb2 + yl * yb2;
    at->b[1] = 2 * (du * du + dv * dv);
    at->position[0] = xl * xb + yl * yb, at->position[1] = dx * dx + dy * dy - l * l;
    at->velocity[0] = xl * xb1 + yl * yb1, at->velocity[1] = 0.0;
}
