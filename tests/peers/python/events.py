"""Long runs of impacts by heyoka: a ball that bounces without loss, and a wheel without rim that rolls down a slope. Time per
impact, memory that the run has added, and how far the impacts are from where they belong.

    pip install heyoka
    python events.py 100000

Beside it: cargo bench -p liftoff-tests --bench events. Each impact is a terminal event whose callback changes the state. Steps
are bounded, for in free flight, where series end, heyoka takes infinite ones and finds no roots.
"""
import math
import resource
import sys
import time

import heyoka as hy

G = 9.81
LONGEST = 1.0
# The wheel: mass, moment of inertia, spokes, slope.
M, J, L, GAMMA = 1.0, 0.1, 1.0, 0.2
INERTIA = J + M * L * L
LEAVES = (J + M * L * L * math.cos(math.pi / 3)) / INERTIA


def ball(tolerance, after):
    y, v = hy.make_vars("y", "v")

    def bounce(made, _):
        made.state[1] = -made.state[1]
        return after()

    events = [hy.t_event(y, direction=hy.event_direction.negative, callback=bounce)]
    return hy.taylor_adaptive([(y, v), (v, hy.expression(-G))], [1.0, 0.0], tol=tolerance, t_events=events)


def wheel(tolerance, after):
    """θ: the spoke that bears from the vertical, down the slope."""
    p, w = hy.make_vars("p", "w")
    strikes = GAMMA + math.pi / 6

    def tread(made, _):
        made.state[0] -= math.pi / 3
        made.state[1] *= LEAVES
        return after()

    events = [hy.t_event(p - strikes, direction=hy.event_direction.positive, callback=tread)]
    equations = [(p, w), (w, M * G * L / INERTIA * hy.sin(p))]
    start = [strikes - math.pi / 3, 2.0]
    return hy.taylor_adaptive(equations, start, tol=tolerance, t_events=events)


def ball_error(t, n):
    """Of the time of the n-th impact, relative."""
    exact = (2 * n - 1) * math.sqrt(2.0 / G)
    return abs(t / exact - 1.0)


def run(make, tolerance, events):
    count = 0

    def after():
        nonlocal count
        count += 1
        return count < events

    made = make(tolerance, after)
    before, begun = memory(), time.perf_counter()
    made.propagate_until(1e9, max_delta_t=LONGEST)
    return 1e6 * (time.perf_counter() - begun) / events, memory() - before, made.time


def memory():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


if __name__ == "__main__":
    events = int(sys.argv[1])
    for name, make in (("bouncing-ball", ball), ("rimless-wheel", wheel)):
        for tolerance in (1e-9, 1e-14):
            runs = [run(make, tolerance, events) for _ in range(5)]
            t = runs[0][2]
            error = f", error {ball_error(t, events):.1e}" if name == "bouncing-ball" else ""
            print(f"{name} {tolerance:g}: {min(r[0] for r in runs):.2f} µs per impact, {max(r[1] for r in runs):.1f} MB, t = {t!r}{error}")
