"""Andrews' squeezer and the car axis: error of the positions against time, liftoff beside SUNDIALS, SciPy and CyRK, in one run.

    pip install numpy scipy scikit-sundae CyRK
    python ivp.py target/release/liftoff

All of SUNDIALS and CyRK calls the equations of squeezer.c and car_axis.c, compiled by cc -O3 -march=native, from compiled code;
SciPy's own solvers are written in Python and call them through ctypes. Times are minima of repeats that take turns.
"""
import ctypes
import json
import subprocess
import sys
import time

import numpy as np
from CyRK import nbsolve2_ivp
from scipy.integrate import solve_ivp

import sundials
from problems import PLACE, problems

TOLERANCES = [10.0**-k for k in range(4, 15)]
GOALS = [1e-6, 1e-8, 1e-10]
ROUNDS, REPEATS = 3, 3
# Seconds of a run that is made once, and tolerances below which one takes many of them or is refused.
SLOW = 0.06
LEAST = {"SUNDIALS IDA, index 1": 1e-13, "SUNDIALS IDA, stabilised": 1e-12, "SUNDIALS CVODE BDF": 1e-13, "SciPy Radau": 1e-7, "SciPy BDF": 1e-7, "SciPy LSODA": 1e-11, "SciPy DOP853": 1e-12, "CyRK RADAU": 1e-10, "CyRK BDF": 1e-13}
OURS = ["auto", "taylor", "dop853"]


def cyrk(method):
    def prepared(problem, tolerance):
        address = ctypes.cast(problem.c.cyrk_ode, ctypes.c_void_p).value

        def run():
            made = nbsolve2_ivp(address, (0.0, problem.end), problem.start, method, rtol=tolerance, atol=tolerance)
            if not made.success:
                raise RuntimeError(method)
            return made.y[:, -1]

        return run

    return prepared


def scipy(method):
    def prepared(problem, tolerance):
        def slope(t, y):
            # Columns of differences come as views.
            y, made = np.ascontiguousarray(y), np.empty(len(y))
            problem.c.ode(t, y.ctypes.data, made.ctypes.data)
            return made

        def run():
            made = solve_ivp(slope, (0.0, problem.end), problem.start, method, rtol=tolerance, atol=tolerance)
            if not made.success:
                raise RuntimeError(method)
            return made.y[:, -1]

        return run

    return prepared


SOLVERS = {
    "SUNDIALS IDA, index 1": lambda p, tol: sundials.ida(p, "index1", tol),
    "SUNDIALS IDA, stabilised": lambda p, tol: sundials.ida(p, "stabilised", tol),
    "SUNDIALS CVODE BDF": lambda p, tol: sundials.cvode(p, "bdf", tol),
    "SUNDIALS CVODE Adams": lambda p, tol: sundials.cvode(p, "adams", tol),
    **{f"CyRK {method}": cyrk(method) for method in ("RADAU", "BDF", "LSODA", "DOP853", "Vern8")},
    **{f"SciPy {method}": scipy(method) for method in ("Radau", "BDF", "LSODA", "DOP853")},
}


def measured(problem, solvers, tolerances):
    """(solver, tolerance): error, least seconds; where a solver gives up there is no row."""
    rows, runs = {}, {}
    for name, make in solvers.items():
        for tolerance in tolerances:
            if tolerance < LEAST.get(name, 0.0):
                continue
            try:
                run = make(problem, tolerance)
                begun = time.perf_counter()
                end = run()
                took = time.perf_counter() - begun
            except RuntimeError:
                continue
            if np.all(np.isfinite(end)):
                rows[name, tolerance] = [problem.error(end), took]
                if took < SLOW:
                    runs[name, tolerance] = run
    for _ in range(ROUNDS):
        for key, run in runs.items():
            for _ in range(REPEATS):
                begun = time.perf_counter()
                run()
                rows[key][1] = min(rows[key][1], time.perf_counter() - begun)
    return rows


def ours(program, problem):
    """The same of liftoff: errors by its runs, times by its command that measures."""
    rows, table = {}, PLACE / "liftoff.csv"
    for method in OURS:
        for tolerance in TOLERANCES:
            words = [program, "run", problem.model, "--method", method, "--tol", str(tolerance), "--json"]
            end = json.loads(subprocess.run(words, capture_output=True, check=True).stdout)["final_state"]
            rows[f"liftoff {method}", tolerance] = [problem.error(problem.ours(end)), float("inf")]
    for _ in range(ROUNDS):
        words = [program, "precision", problem.model, "--methods", ",".join(OURS), "--csv", table]
        words += ["--tolerances", ",".join(str(x) for x in TOLERANCES)]
        subprocess.run(words, capture_output=True, check=True)
        lines = [line.split(",") for line in open(table).read().splitlines()]
        at = {name: i for i, name in enumerate(lines[0])}
        for line in lines[1:]:
            row = rows[f"liftoff {line[at['method']]}", min(TOLERANCES, key=lambda x: abs(x / float(line[at["tolerance"]]) - 1))]
            row[1] = min(row[1], 1e-6 * float(line[at["microseconds"]]))
    return rows


def least(rows, solver, goal):
    """The quickest run of a solver that is as good as asked for."""
    fit = [(s, error, tol) for (name, tol), (error, s) in rows.items() if name == solver and error <= goal]
    return min(fit, default=None)


def told(problem, rows):
    print(f"\n{problem.name}: positions at t = {problem.end}, µs (tolerance), and over the quickest of liftoff's")
    names = list(dict.fromkeys(name for name, _ in rows))
    best = [min(least(rows, name, goal) or (float("inf"),) for name in names if name.startswith("liftoff"))[0] for goal in GOALS]
    print("| solver | " + " | ".join(f"error ≤ {goal:g}" for goal in GOALS) + " |\n|---|" + "--:|" * len(GOALS))
    for name in names:
        cells = [(least(rows, name, goal), own) for goal, own in zip(GOALS, best)]
        text = [f"{1e6 * made[0]:.0f} ({made[2]:.0e}), {made[0] / own:.2f}" if made else "–" for made, own in cells]
        print(f"| {name} | " + " | ".join(text) + " |")


if __name__ == "__main__":
    for problem in problems():
        print(problem.name, flush=True)
        rows = ours(sys.argv[1], problem)
        rows |= measured(problem, SOLVERS, TOLERANCES)
        told(problem, rows)
        sys.stdout.flush()
