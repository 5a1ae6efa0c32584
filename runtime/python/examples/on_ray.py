"""A sweep on a Ray cluster of processes: python on_ray.py FILE.npz [RUNS]."""

import sys
from pathlib import Path

import numpy as np
import ray

import liftoff

OBSERVED = ["first open", "t of first open"]


@ray.remote
def batch(model, starts):
    return model.sweep(OBSERVED, start={"phi": starts}, threads=1)


def swept(model, starts, size):
    batches = np.split(starts, range(size, len(starts), size))
    model = ray.put(model)  # its text: a worker derives it once
    tables = ray.get([batch.remote(model, starts) for starts in batches])
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


if __name__ == "__main__":
    ladder = liftoff.Model.from_file(Path(__file__).parents[2] / "web/gallery/ladder.rs")
    starts = np.linspace(0.5, 1.5, int(sys.argv[2]) if len(sys.argv) > 2 else 100_000)
    with ray.init(num_cpus=2, include_dashboard=False):
        rows = swept(ladder, starts, size=10_000)
    np.savez(sys.argv[1], **{name: column.astype(str) if column.dtype == object else column for name, column in rows.items()})
