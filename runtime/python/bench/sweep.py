"""Ten thousand short runs from Python and from Rust, on one thread: whose speed, and what a call adds to each run.

Run it with the package installed from a wheel of the release profile; cargo builds the Rust side for the same processor. What counts
is processor time, so that other work on the machine does not.
"""

import pathlib
import resource
import statistics
import subprocess
import time

import numpy as np

import liftoff

ROOT = pathlib.Path(__file__).resolve().parents[3]
RUNS, TURNS = 10_000, 7
CARGO = ["cargo", "--config", 'build.rustflags=["-C", "target-cpu=generic"]', "run", "-q", "--release", "--features", "jit"]
VALUES = {"m1": 0.5, "m2": 0.5, "l": 1, "g": 1}


def from_python(model: liftoff.Model, repeats: int) -> tuple[float, float]:
    """Processor time of the runs of `sweep.rs`, and the seconds that a call takes beside them."""
    angles = np.linspace(0.9, 1.5, RUNS)
    start = {"phi_inner": angles, "phi_outer": angles}
    begun, beside = time.process_time(), []
    for limit in (None, 1e-9):
        for _ in range(repeats):
            called = time.perf_counter()
            table = model.sweep("first open", start=start, set=VALUES, limit=limit, threads=1)
            beside.append(time.perf_counter() - called - table.seconds)
            assert not table.failed
    return time.process_time() - begun, min(beside)


def from_rust(program: str) -> float:
    """Its processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program], check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    """By turns, so that what the machine does meets both."""
    model = liftoff.Model.from_file(ROOT / "models/systems/src/zigzag.rs")
    build = [*CARGO, "-p", "liftoff-python", "--example", "sweep_from_rust", "--", "--where"]
    program, repeats = subprocess.run(build, cwd=ROOT, check=True, capture_output=True, text=True).stdout.split()
    turns = [(from_python(model, int(repeats)), from_rust(program)) for _ in range(TURNS)]
    python, beside = (min(turn[0][k] for turn in turns) for k in (0, 1))
    rust = min(turn[1] for turn in turns)
    ratio = statistics.median(rust / python for (python, _), rust in turns)
    runs = 2 * int(repeats) * RUNS
    print(f"{runs} runs, half of them to the first opening: {python:.3f} s from Python, {rust:.3f} s from Rust")
    print(f"Rust's speed: {rust / python:.3f}; by turns median {ratio:.3f}; {(python - rust) / runs * 1e6:.2f} µs more a run")
    print(f"what a call takes beside its runs: {beside / RUNS * 1e6:.3f} µs a run")


if __name__ == "__main__":
    main()
