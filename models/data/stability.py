"""References of the stability suite: closed forms, quadrature and Taylor integration in 40 digits (mpmath).

pip install mpmath; python stability.py > stability.json
All lengths, the masses of whole systems and gravity are 1 unless said otherwise; starts are the doubles nearest to the decimals.
"""
import json

import mpmath as mp

mp.mp.dps = 40
out = {}


def put(key, value):
    out[key] = mp.nstr(value, 20)


def double(text):
    """The double nearest to a decimal, exactly."""
    return mp.mpf(float(text))


# Fig. 1a from rest at φ₀: φ̇² = 4 (f(φ) − f(φ₀))/I(φ), f = tan φ − sin φ = y_C/(l/2), I = 4/3 + 1/cos⁴φ − 2/cos φ.
def falling_pair():
    f = lambda p: mp.tan(p) - mp.sin(p)
    f1 = lambda p: 1 / mp.cos(p) ** 2 - mp.cos(p)
    f2 = lambda p: 2 * mp.sin(p) / mp.cos(p) ** 3 + mp.sin(p)
    inertia = lambda p: mp.mpf(4) / 3 + 1 / mp.cos(p) ** 4 - 2 / mp.cos(p)
    slope = lambda p: 4 * mp.sin(p) / mp.cos(p) ** 5 - 2 * mp.sin(p) / mp.cos(p) ** 2
    for exponent in range(1, 13):
        text = f"1e-{exponent}"
        start = double(text)
        speed2 = lambda p: 4 * (f(p) - f(start)) / inertia(p)
        alpha = lambda p: (4 * f1(p) - speed2(p) * slope(p)) / inertia(p) / 2
        reaction = lambda p: 1 - (f2(p) * speed2(p) + f1(p) * alpha(p)) / 2
        lift = mp.findroot(reaction, mp.mpf("0.815"))
        # φ = φ₀ cosh² v makes 1/φ̇ regular at the start; f(φ) − f(φ₀) cancels some 24 digits there.
        with mp.workdps(80):
            angle = lambda v: start * mp.cosh(v) ** 2
            rate = lambda v: mp.sqrt(4 * (f(angle(v)) - f(start)) / inertia(angle(v)))
            integrand = lambda v: 2 * start * mp.cosh(v) * mp.sinh(v) / rate(v)
            end = mp.acosh(mp.sqrt(lift / start))
            pieces = [end * k / 16 for k in range(17)]
            time = mp.quad(integrand, pieces, method="gauss-legendre")
        put(f"falling-pair.lift-off[{text}]", lift)
        put(f"falling-pair.time[{text}]", time)


# The A-frame with S = s + φ̇²/3: N = 0 at s = sin φ = (S ± √(S² − 1))/3; φ̇² = 3 (S − s) on the floor. In flight
# φ̇² (1/3 + s²) is constant and the centres fall freely; the feet land where they are as high as sin φ says.
def a_frame():
    for text in [f"1e-{k}" for k in range(1, 13)]:
        total = 1 + mp.mpf(text)
        with mp.workdps(80):
            first = (total + mp.sqrt(total**2 - 1)) / 3
            phi = mp.asin(first)
            rate = -mp.sqrt(3 * (total - first))
            kept = rate**2 * (mp.mpf(1) / 3 + first**2)
            fall = lambda p: mp.sqrt(kept / (mp.mpf(1) / 3 + mp.sin(p) ** 2))
            time = lambda p: mp.quad(lambda x: 1 / fall(x), [p, phi], method="gauss-legendre")
            gap = lambda p: (first - mp.sin(p)) / 2 + mp.cos(phi) * rate / 2 * time(p) - time(p) ** 2 / 2
            span = phi - mp.asin((total - mp.sqrt(total**2 - 1)) / 3)
            # The reaction is all but a parabola in time where it is small: the flight takes about twice as long.
            scale = span**4
            landing = mp.findroot(lambda p: gap(p) / scale, (phi - 1.9 * span, phi - 2.1 * span), tol=1e-50)
        put(f"a-frame.open[{text}]", phi)
        put(f"a-frame.land[{text}]", landing)


# Fig. 1b, all feet down, from upright rest: Newton and Euler for the right half, bars CD (m1) and DE (m2).
def zigzag():
    for name, m1, m2 in [
        ("1e-12", 1, double("1e-12")),
        ("1e12", double("1e-12"), 1),
        ("1/3", mp.mpf("0.75"), mp.mpf("0.25")),
        ("1", mp.mpf("0.5"), mp.mpf("0.5")),
    ]:
        lam = m2 / (m1 + m2)
        speed2 = lambda p: (1 - mp.sin(p)) / (mp.mpf(1) / 3 + 2 * lam * mp.sin(p) ** 2)

        def bearing(p):
            s, c = mp.sin(p), mp.cos(p)
            omega2, alpha = speed2(p), mp.diff(speed2, p) / 2
            second = lambda x1, x2: x1 * alpha + x2 * omega2
            inner_x, outer_x = second(-s / 2, -c / 2), second(-3 * s / 2, -3 * c / 2)
            y = second(c / 2, -s / 2)
            hx = m2 * outer_x
            # unknown: hy (on DE at D), n_e, n_c (half the reaction at C), cx
            rows = mp.matrix([
                [1, 1, 0, 0],                     # DE, vertical
                [-c / 2, c / 2, 0, 0],            # DE, about its centre
                [-1, 0, 1, 0],                    # CD, vertical
                [0, 0, 0, 1],                     # CD, horizontal
            ])
            right = mp.matrix([m2 * (y + 1), -m2 * alpha / 12 + s / 2 * hx, m1 * (y + 1), m1 * inner_x + hx])
            hy, n_e, n_c, cx = mp.lu_solve(rows, right)
            # CD about its centre is then satisfied.
            rest = m1 * alpha / 12 - (-c / 2 * n_c + s / 2 * cx - c / 2 * hy + s / 2 * hx)
            assert abs(rest) < mp.mpf(10) ** -25, rest
            return n_e, 2 * n_c

        pick = 0 if lam < mp.mpf("0.25") - mp.mpf("1e-9") else 1
        scale = m2 if pick == 0 else 1
        grid = [mp.mpf(k) / 1000 for k in range(1560, 100, -5)]
        before = next(p for p in grid if bearing(p - mp.mpf("0.005"))[pick] < 0)
        lift = mp.findroot(lambda p: bearing(p)[pick] / scale, (before - mp.mpf("0.005"), before), solver="anderson")
        other = bearing(lift)[1 - pick]
        put(f"zigzag.open[{name}]", lift)
        put(f"zigzag.other[{name}]", other)


# Two hinged bars of masses m1, m2, hinged at O: ratio m2/m1, from (1, 0.5) at rest, state at t = 4.
def unequal_pendulum():
    for name, m1, m2 in [
        ("1e-12", mp.mpf(1), double("1e-12")),
        ("1e12", double("1e-12"), mp.mpf(1)),
        ("inf", mp.mpf(0), mp.mpf(1)),
    ]:
        m11, m12, m22 = m1 / 3 + m2, m2 / 2, m2 / 3

        def f(t, y):
            a, b, u, v = y
            c, s = mp.cos(a - b), mp.sin(a - b)
            r1 = -m12 * s * v**2 - (m1 / 2 + m2) * mp.sin(a)
            r2 = m12 * s * u**2 - m2 / 2 * mp.sin(b)
            det = m11 * m22 - (m12 * c) ** 2
            return [u, v, (m22 * r1 - m12 * c * r2) / det, (m11 * r2 - m12 * c * r1) / det]

        with mp.workdps(30):
            solution = mp.odefun(f, 0, [mp.mpf(1), mp.mpf("0.5"), mp.mpf(0), mp.mpf(0)])
            state = solution(4)
        for coordinate, value in zip(["phi_1", "phi_2", "phi_1'", "phi_2'"], state):
            put(f"unequal-pendulum.{coordinate}[{name}]", value)


# Pendulums by elliptic integrals: the period 4 K(sin(a/2)) of a mathematical one of amplitude a, in √(l/g); and the
# first-order lengthening of the period of a bob on a spring of stiffness k mg/l, T = T₀ (1 + c/k), on the slow
# manifold r = l + (mg/k)(3 cos φ − 2 cos a): φ̇² = 2 C (1 − (cos a + 15 C/2)/k), C = cos φ − cos a.
def pendulums():
    for name, amplitude in [("60", mp.pi / 3), ("90", mp.pi / 2), ("1 rad", mp.mpf(1))]:
        modulus = mp.sin(amplitude / 2) ** 2
        k, e = mp.ellipk(modulus), mp.ellipe(modulus)
        put(f"pendulum.period[{name}]", 4 * k)
        mean = 16 * (e - (1 - modulus) * k) / (4 * k) / 2
        put(f"spring.lengthening[{name}]", mp.cos(amplitude) / 2 + mp.mpf(15) / 4 * mean)


falling_pair()
a_frame()
zigzag()
unequal_pendulum()
pendulums()
print(json.dumps(out, indent=1))
