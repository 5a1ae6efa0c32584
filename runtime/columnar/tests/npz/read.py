"""Tables of so many rows each, read by NumPy (arguments: the numbers of rows of the files ROWS.npz)."""
import hashlib
import json
import sys

import numpy

for count in map(int, sys.argv[1:]):
    with numpy.load(f"{count}.npz", allow_pickle=False) as file:
        assert set(file) == {"i", "φ̇/2", "s", "liftoff.metadata"}, list(file)
        i, x, s = file["i"], file["φ̇/2"], file["s"]
        said = json.loads(file["liftoff.metadata"].item())
    rows = numpy.arange(count)
    assert i.dtype == numpy.int64 and (i == rows).all() and len(i) == count
    assert x.dtype == numpy.float64 and numpy.array_equal(x, numpy.where(rows % 3 == 0, numpy.nan, 0.1 * rows), equal_nan=True)
    texts = ["" if k % 2 == 0 else ("𝜑 " if k % 11 == 0 else "") + f"row {k}" for k in range(count)]
    assert s.tolist() == texts, count
    digest = hashlib.sha256(b"struct A;").hexdigest()
    entries = {"liftoff.model": "näher", "liftoff.declaration": "struct A;", "liftoff.declaration.sha256": digest}
    assert said == {"entries": entries, "units": {"φ̇/2": "rad/s"}}, said
