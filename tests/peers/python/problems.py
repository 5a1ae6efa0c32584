"""The problems: their C, compiled; starts; what is compared; references by extrapolation in 80-bit numbers. SUNDIALS is to be loaded
before, as the C calls it."""
import ctypes
import math
import subprocess
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
PLACE = Path(tempfile.mkdtemp(prefix="liftoff-peers-"))
FLAGS = ["cc", "-O3", "-march=native", "-shared", "-fPIC"]


def library(name, *flags):
    out = PLACE / f"{name}{len(flags)}.so"
    subprocess.run([*FLAGS, *flags, "-o", out, HERE / f"{name}.c", "-lm"], check=True)
    made = ctypes.CDLL(str(out))
    for call in (made.ode, made.multipliers):
        call.argtypes = [ctypes.c_longdouble if flags else ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]
    return made


class Problem:
    """`start`: q, then v; `ours`: positions as the C has them, of the final state that `liftoff run --json` prints."""

    def __init__(self, name, model, end, start, conditions, ours):
        self.name, self.model, self.end, self.ours = name, model, end, ours
        self.start = np.array(start)
        self.n, self.conditions = len(start) // 2, conditions
        self.c = library(name)
        self.reference = self.extrapolated(600 if name == "car_axis" else 900)[: self.n].astype(float)

    def error(self, y):
        """The test set's measure, of the positions: the largest relative error."""
        return float(np.max(np.abs(np.asarray(y)[: self.n] / self.reference - 1.0)))

    def extrapolated(self, steps):
        """Modified midpoint rule, extrapolated in h² to order 16 (Gragg, Bulirsch and Stoer), in fixed steps."""
        wide = library(self.name, "-DEXTENDED")

        def slope(t, y):
            made = np.empty_like(y)
            wide.ode(t, y.ctypes.data, made.ctypes.data)
            return made

        y, big = self.start.astype(np.longdouble), np.longdouble(self.end) / steps
        for step in range(steps):
            t0, table = step * big, []
            for j in range(1, 9):
                h = big / (2 * j)
                before, now = y, y + h * slope(t0, y)
                for i in range(1, 2 * j):
                    before, now = now, before + 2 * h * slope(t0 + i * h, now)
                row = [0.5 * (before + now + h * slope(t0 + big, now))]
                for k in range(1, j):
                    ratio = np.longdouble(j * j) / np.longdouble((j - k) ** 2)
                    row.append(row[-1] + (row[-1] - table[-1][k - 1]) / (ratio - 1))
                table.append(row)
            y = table[-1][-1]
        return y


def squeezer(end):
    turned = {"phi": 0.5 * math.pi, "omega": -0.5 * math.pi}
    return [end[name] + turned.get(name, 0.0) for name in ("beta", "theta", "gamma", "phi", "delta", "omega", "epsilon")]


def car_axis(end):
    x, y, theta = end["x_L"], end["y_L"], end["theta"]
    return [x, y, x + math.cos(theta), y + math.sin(theta)]


def problems():
    angles = [-0.061713890014276451, 0.0, 0.455279819163070385, 0.222668390165885878, 0.487364979543842553,
              -0.222668390165885878, 1.23054744454982124]
    yield Problem("squeezer", "squeezer", 0.03, angles + 7 * [0.0], 6, squeezer)
    yield Problem("car_axis", "car-axis", 3.0, [0.0, 0.5, 1.0, 0.5, -0.5, 0.0, -0.5, 0.0], 2, car_axis)
