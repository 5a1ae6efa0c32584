/* Andrews' squeezer as published: Hairer & Wanner, Solving Ordinary Differential Equations II, VII.7. */
#include <math.h>
#define NQ 7
#define NL 6
#include "solve.h"

static const real M[7] = {0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498};
static const real J[7] = {2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5};
static const real xa = -0.06934, ya = -0.00227, xb = -0.03635, yb = 0.03273, xc = 0.014, yc = 0.072;
static const real d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092;
static const real ss = 0.035, sa = 0.01874, sb = 0.01043, sc = 0.018, sd = 0.02, ta = 0.02308, tb = 0.00916;
static const real u = 0.04, ua = 0.01228, ub = 0.00449, zf = 0.02, zt = 0.04, fa = 0.01421;
static const real torque = 0.033, c0 = 4530.0, l0 = 0.07785;

static void terms(real t, const real *q, const real *v, Terms *at) {
    real sibe = sin(q[0]), cobe = cos(q[0]), sith = sin(q[1]), coth = cos(q[1]), siga = sin(q[2]), coga = cos(q[2]);
    real siph = sin(q[3]), coph = cos(q[3]), side = sin(q[4]), code = cos(q[4]), siom = sin(q[5]), coom = cos(q[5]);
    real siep = sin(q[6]), coep = cos(q[6]);
    real sibeth = sibe * coth + cobe * sith, cobeth = cobe * coth - sibe * sith;
    real siphde = siph * code + coph * side, cophde = coph * code - siph * side;
    real siomep = siom * coep + coom * siep, coomep = coom * coep - siom * siep;
    for (int i = 0; i < NQ; i++)
        for (int j = 0; j < NQ; j++) at->m[i][j] = 0.0;
    for (int i = 0; i < NL; i++)
        for (int j = 0; j < NQ; j++) at->g[i][j] = 0.0;
    at->m[0][0] = M[0] * ra * ra + M[1] * (rr * rr - 2 * da * rr * coth + da * da) + J[0] + J[1];
    at->m[1][0] = at->m[0][1] = M[1] * (da * da - da * rr * coth) + J[1];
    at->m[1][1] = M[1] * da * da + J[1];
    at->m[2][2] = M[2] * (sa * sa + sb * sb) + J[2];
    at->m[3][3] = M[3] * (e - ea) * (e - ea) + J[3];
    at->m[4][3] = at->m[3][4] = M[3] * ((e - ea) * (e - ea) + zt * (e - ea) * siph) + J[3];
    at->m[4][4] = M[3] * (zt * zt + 2 * zt * (e - ea) * siph + (e - ea) * (e - ea)) + M[4] * (ta * ta + tb * tb) + J[3] + J[4];
    at->m[5][5] = M[5] * (zf - fa) * (zf - fa) + J[5];
    at->m[6][5] = at->m[5][6] = M[5] * ((zf - fa) * (zf - fa) - u * (zf - fa) * siom) + J[5];
    at->m[6][6] = M[5] * ((zf - fa) * (zf - fa) - 2 * u * (zf - fa) * siom + u * u) + M[6] * (ua * ua + ub * ub) + J[5] + J[6];

    real xd = sd * coga + sc * siga + xb, yd = sd * siga - sc * coga + yb;
    real length = sqrt((xd - xc) * (xd - xc) + (yd - yc) * (yd - yc)), force = -c0 * (length - l0) / length;
    real fx = force * (xd - xc), fy = force * (yd - yc);
    at->f[0] = torque - M[1] * da * rr * v[1] * (v[1] + 2 * v[0]) * sith;
    at->f[1] = M[1] * da * rr * v[0] * v[0] * sith;
    at->f[2] = fx * (sc * coga - sd * siga) + fy * (sd * coga + sc * siga);
    at->f[3] = M[3] * zt * (e - ea) * v[4] * v[4] * coph;
    at->f[4] = -M[3] * zt * (e - ea) * v[3] * (v[3] + 2 * v[4]) * coph;
    at->f[5] = -M[5] * u * (zf - fa) * v[6] * v[6] * coom;
    at->f[6] = M[5] * u * (zf - fa) * v[5] * (v[5] + 2 * v[6]) * coom;

    real p = (v[0] + v[1]) * (v[0] + v[1]), p4 = (v[3] + v[4]) * (v[3] + v[4]), p6 = (v[5] + v[6]) * (v[5] + v[6]);
    real x = rr * cobe - d * cobeth, y = rr * sibe - d * sibeth;
    real bx = -rr * cobe * v[0] * v[0] + d * cobeth * p, by = -rr * sibe * v[0] * v[0] + d * sibeth * p;
    for (int i = 0; i < NL; i += 2) {
        at->g[i][0] = -y, at->g[i][1] = d * sibeth;
        at->g[i + 1][0] = x, at->g[i + 1][1] = -d * cobeth;
    }
    at->g[0][2] = -ss * coga, at->g[1][2] = -ss * siga;
    at->g[2][3] = -e * cophde, at->g[2][4] = -e * cophde + zt * side;
    at->g[3][3] = -e * siphde, at->g[3][4] = -e * siphde - zt * code;
    at->g[4][5] = zf * siomep, at->g[4][6] = zf * siomep - u * coep;
    at->g[5][5] = -zf * coomep, at->g[5][6] = -zf * coomep - u * siep;
    at->b[0] = bx + ss * siga * v[2] * v[2];
    at->b[1] = by - ss * coga * v[2] * v[2];
    at->b[2] = bx + e * siphde * p4 + zt * code * v[4] * v[4];
    at->b[3] = by - e * cophde * p4 + zt * side * v[4] * v[4];
    at->b[4] = bx + zf * coomep * p6 + u * siep * v[6] * v[6];
    at->b[5] = by + zf * siomep * p6 - u * coep * v[6] * v[6];
    at->position[0] = x - ss * siga - xb;
    at->position[1] = y + ss * coga - yb;
    at->position[2] = x - e * siphde - zt * code - xa;
    at->position[3] = y + e * cophde - zt * side - ya;
    at->position[4] = x - zf * coomep - u * siep - xa;
    at->position[5] = y - zf * siomep + u * coep - ya;
    for (int i = 0; i < NL; i++) at->velocity[i] = 0.0;
}
