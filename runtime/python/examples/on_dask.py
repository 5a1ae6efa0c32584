"""A sweep on a Dask cluster of processes: python on_dask.py FILE.npz [RUNS]."""

import sys
from pathlib import Path

import numpy as np
from dask.distributed import Client, LocalCluster

import liftoff

OBSERVED = ["first open", "t of first open"]


def batch(model, starts):
    return model.sweep(OBSERVED, start={"phi": starts}, threads=1)


def swept(client, model, starts, size):
    batches = np.split(starts, range(size, len(starts), size))
    [model] = client.scatter([model], broadcast=True)  # its text: a worker derives it once
    tables = client.gather(client.map(batch, [model] * len(batches), batches))
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


if __name__ == "__main__":  # workers are processes that read this file too
    ladder = liftoff.Model.from_file(Path(__file__).parents[2] / "web/gallery/ladder.rs")
    starts = np.linspace(0.5, 1.5, int(sys.argv[2]) if len(sys.argv) > 2 else 100_000)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        rows = swept(client, ladder, starts, size=10_000)
    np.savez(sys.argv[1], **{name: column.astype(str) if column.dtype == object else column for name, column in rows.items()})
