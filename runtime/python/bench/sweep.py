"""Ten thousand short runs from Python and from Rust, on one thread: whose speed, and what a call adds to each run.

Run it with the package installed from a wheel of the release profile; cargo builds the Rust side for the same processor.
"""

import pathlib
import statistics
import subprocess
import time

import numpy as np

import liftoff

ROOT = pathlib.Path(__file__).resolve().parents[3]
RUNS = 10_000
CARGO = ["cargo", "--config", 'build.rustflags=["-C", "target-cpu=generic"]', "run", "-q", "--release", "--features", "jit"]
VALUES = {"m1": 0.5, "m2": 0.5, "l": 1, "g": 1}


def from_python(model: liftoff.Model) -> list[float]:
    """Runs to their first opening, runs that end at once, and what is no run of these: the least of five."""
    angles = np.linspace(0.9, 1.5, RUNS)
    start = {"phi_inner": angles, "phi_outer": angles}
    seconds, beside = [], []
    for limit in (None, 1e-9):
        times = []
        for _ in range(5):
            begun = time.perf_counter()
            table = model.sweep("first open", start=start, set=VALUES, limit=limit, threads=1)
            times.append(time.perf_counter() - begun)
            beside.append(times[-1] - table.seconds)
            assert not table.failed
        seconds.append(min(times))
    return [*seconds, min(beside)]


def from_rust() -> list[float]:
    """The same."""
    command = [*CARGO, "-p", "liftoff-python", "--example", "sweep_from_rust"]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    return [float(line) for line in done.stdout.split()]


def main() -> None:
    """By turns, so that other work on the machine meets both."""
    model = liftoff.Model.from_file(ROOT / "models/src/zigzag.rs")
    from_rust()
    turns = [(from_python(model), from_rust()) for _ in range(7)]
    python, short, beside = (min(turn[0][k] for turn in turns) for k in range(3))
    rust, short_rust = (min(turn[1][k] for turn in turns) for k in range(2))
    ratio = statistics.median(rust[0] / python[0] for python, rust in turns)
    print(f"{RUNS} runs to the first opening: {python:.4f} s from Python, {rust:.4f} s from Rust")
    print(f"Rust's speed: {rust / python:.3f}; by turns median {ratio:.3f}")
    print(f"{RUNS} runs that end at once: {short:.4f} s from Python, {short_rust:.4f} s from Rust")
    print(f"what a call takes beside its runs: {beside / RUNS * 1e6:.4f} µs a run")


if __name__ == "__main__":
    main()
