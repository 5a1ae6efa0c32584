"""heyoka on many states and many motions at once, on one core: nanoseconds a state, and motions a second.

Right-hand sides of pinned chains of equal bars for 512 states, by the articulated-body recursion, the least of its sizes of
batches and options; double pendula for 10 s at 1e-9, eight side by side, with the median error against runs at 1e-16.

    pip install heyoka
    python many.py

Beside it: cargo bench -p liftoff-tests --bench speed.
"""
import time

import heyoka as hy
import numpy as np

G, STATES, MOTIONS = 9.81, 512, 800


def least(work, count):
    times = []
    for _ in range(count):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def chain(bars):
    """Angular accelerations of a chain of bars with m = l = 1, angles from the downward vertical."""
    angles = [hy.make_vars(f"q{k}") for k in range(bars)]
    rates = [hy.make_vars(f"u{k}") for k in range(bars)]
    xx = xy = yy = bx = by = 0.0
    known = []
    for angle, rate in zip(reversed(angles), reversed(rates)):
        ny, nx = hy.cos(angle), -hy.sin(angle)
        rx, ry = rate * rate * ny, -rate * rate * nx
        px, py = xx * nx + xy * ny, xy * nx + yy * ny
        vx, vy = 0.5 * nx + px, 0.5 * ny + py
        inverse = 1.0 / (1 / 3 + nx * px + ny * py)
        sx, sy = bx - xx * rx - xy * ry, by - xy * rx - yy * ry
        s = nx * sx + ny * sy
        hx, hy_ = vx * inverse, vy * inverse
        xx, xy, yy = 1.0 + xx - vx * hx, xy - vx * hy_, 1.0 + yy - vy * hy_
        bx, by = sx - 0.5 * rx - s * hx, sy - 0.5 * ry - s * hy_
        known.append((hx, hy_, inverse * s, nx, ny, rx, ry))
    ax, ay, turns = -G, 0.0, []
    for hx, hy_, bias, nx, ny, rx, ry in reversed(known):
        turn = -(hx * ax + hy_ * ay + bias)
        ax, ay = ax + turn * nx - rx, ay + turn * ny - ry
        turns.append(turn)
    return turns, angles + rates


def batch(bars):
    formulas, variables = chain(bars)
    place = 1 + np.arange(2 * bars)[:, None] + 2 * bars * np.arange(STATES)[None, :]
    states, out = 3.0 * ((place * 0.618033988749895) % 1 - 0.5), np.zeros((bars, STATES))
    found = []
    for size in (4, 8, 16):
        for options in ({}, {"force_avx512": True}, {"force_avx512": True, "fast_math": True}):
            function = hy.cfunc(formulas, variables, batch_size=size, **options)
            found.append(least(lambda: function(states, outputs=out), 1000))
    return 1e9 * min(found) / STATES


def pendula(tolerance):
    a, b, u, v = hy.make_vars("a", "b", "u", "v")
    cos, sin = hy.cos(a - b), hy.sin(a - b)
    fa, fb, m = -0.5 * sin * v * v - 1.5 * G * hy.sin(a), 0.5 * sin * u * u - 0.5 * G * hy.sin(b), 0.5 * cos
    det = 4 / 9 - m * m
    system = [(a, u), (b, v), (u, (fa / 3 - m * fb) / det), (v, (fb * (4 / 3) - m * fa) / det)]
    taylor = hy.taylor_adaptive_batch(system, np.zeros((4, 8)), tol=tolerance)
    angle = lambda step: 0.5 + 2 * step / 99
    places = [i * 10_000 // MOTIONS for i in range(MOTIONS)]
    starts = np.array([[angle(i % 100), angle(i // 100), 0, 0] for i in places]).T
    ends = np.empty_like(starts)

    def work():
        for first in range(0, MOTIONS, 8):
            taylor.state[:] = starts[:, first : first + 8]
            taylor.set_time(0.0)
            taylor.propagate_until(np.full(8, 10.0))
            ends[:, first : first + 8] = taylor.state

    return MOTIONS / least(work, 5 if tolerance > 1e-15 else 1), ends


for bars in (2, 8, 16, 32):
    print(f"chain of {bars}: {batch(bars):.1f} ns a state", flush=True)
rate, ends = pendula(1e-9)
exact = pendula(1e-16)[1]
error = np.median(np.abs(ends - exact).max(0) / np.abs(exact).max(0))
print(f"double pendula: {rate:.0f} a second, median error {error:.1e}")
