"""heyoka's error against run time for one double pendulum: from (2, 1) at rest, 10 s, the least of twenty runs each.

The error is the largest of an angle in radians and of a rate in natural units √(g/l), against a run at 1e-18 in long double.

    pip install heyoka
    python precision.py

Beside it, on the same machine: cargo run --profile bench -p liftoff-compiled --features program -- precision double-pendulum
--start phi_1=2 --start phi_2=1 --limit 10.
"""
import time

import heyoka as hy
import numpy as np

G, END = 9.81, 10.0


def system():
    a, b, u, v = hy.make_vars("a", "b", "u", "v")
    cos, sin = hy.cos(a - b), hy.sin(a - b)
    fa, fb, m = -0.5 * sin * v * v - 1.5 * G * hy.sin(a), 0.5 * sin * u * u - 0.5 * G * hy.sin(b), 0.5 * cos
    det = 4 / np.longdouble(9) - m * m
    third, four_thirds = 1 / np.longdouble(3), 4 / np.longdouble(3)
    return [(a, u), (b, v), (u, (fa * third - m * fb) / det), (v, (fb * four_thirds - m * fa) / det)]


def run(taylor, kind):
    taylor.time = kind(0)
    taylor.state[:] = np.array([2, 1, 0, 0], dtype=kind)
    start = time.perf_counter()
    taylor.propagate_until(kind(END))
    return time.perf_counter() - start, taylor.state.copy()


long = np.longdouble
_, exact = run(hy.taylor_adaptive(system(), np.zeros(4, dtype=long), tol=long(1e-18), fp_type=long), long)
units = np.array([1, 1, np.sqrt(G), np.sqrt(G)])
print("tolerance  error     µs")
for exponent in range(3, 15):
    taylor = hy.taylor_adaptive(system(), np.zeros(4), tol=10.0**-exponent)
    runs = [run(taylor, float) for _ in range(20)]
    error = np.max(np.abs(runs[0][1] - exact) / units)
    print(f"1e-{exponent:<7} {float(error):.2e}  {1e6 * min(seconds for seconds, _ in runs):.1f}", flush=True)
