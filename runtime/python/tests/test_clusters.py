"""The examples of sweeps on clusters, where there is Dask or Ray."""

import re
import subprocess
import sys

import numpy as np
import pytest

import liftoff
from conftest import ROOT

EXAMPLES = ROOT / "runtime/python/examples"
CLUSTERS = [("distributed", "on_dask.py"), ("ray", "on_ray.py")]


@pytest.mark.parametrize("package, example", CLUSTERS)
def test_rows_of_two_processes_are_those_of_one_sweep(package, example, tmp_path):
    pytest.importorskip(package)
    runs = 25_000  # three batches, the last one shorter
    command = [sys.executable, str(EXAMPLES / example), str(tmp_path / "rows.npz"), str(runs)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    rows = np.load(tmp_path / "rows.npz")
    ladder = liftoff.Model.from_file(ROOT / "runtime/web/gallery/ladder.rs")
    table = ladder.sweep(["first open", "t of first open"], start={"phi": np.linspace(0.5, 1.5, runs)})
    assert sorted(rows) == sorted(table)
    for name in table:
        column = table[name]
        if column.dtype == object:
            assert rows[name].tolist() == list(map(str, column)), name
        else:
            assert rows[name].tobytes() == column.tobytes(), name
    # The starts differ, so that rows in another order would differ too.
    assert len(set(rows["t of first open"])) > 0.9 * runs


def test_the_book_shows_the_examples():
    book = (ROOT / "runtime/cli/src/book/python.md").read_text(encoding="utf-8")
    shown = re.findall(r"```py\n(.*?)```", book, re.S)
    for part, (_, example) in zip(shown, CLUSTERS, strict=True):
        lines = [line.strip() for line in (EXAMPLES / example).read_text(encoding="utf-8").splitlines()]
        for line in filter(None, part.splitlines()):
            assert line.strip() in lines, line
