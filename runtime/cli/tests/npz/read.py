"""A table that the program has written comma-separated and as an archive of arrays, read by NumPy (arguments: the kind of table, then the
files FILE.csv and FILE.npz without their ends)."""
import csv
import hashlib
import json
import re
import sys

import numpy

UNITS = {
    "run": {"t": "s", "phi": "rad", "phi'": "rad/s", "N(A)": "N", "gap(B)": "m", "E": "J", "E/(m*g*l)": "1"},
    "sweep": {"lambda": "1", "phi0": None, "first open phi_inner": "rad", "end": None, "member": None},
}

kind, stem = sys.argv[1:]
with open(f"{stem}.csv", newline="") as file:
    heads, *rows = csv.reader(file)
names = [re.sub(r" \[.*\]$", "", head) for head in heads]
arrays = numpy.load(f"{stem}.npz", allow_pickle=False)
said = json.loads(arrays["liftoff.metadata"].item())
assert sorted(arrays) == sorted([*names, "liftoff.metadata"]), list(arrays)
missing = 0
for name, column in zip(names, zip(*rows)):
    array = arrays[name]
    if array.dtype.kind == "U":
        assert array.tolist() == list(column), name
    elif array.dtype == numpy.int64:
        assert array.tolist() == list(map(int, column)), name
    else:
        expected = numpy.array([float(text) if text else numpy.nan for text in column])
        missing += column.count("")
        # To the last bit; NaN where the text has nothing.
        assert array.dtype == numpy.float64 and array.tobytes() == expected.tobytes(), name
assert (missing > 0) == (kind == "sweep")
units, entries = said["units"], said["entries"]
assert {name: units.get(name) for name in UNITS[kind]} == UNITS[kind], units
for name in ["declaration", kind]:
    text = entries[f"liftoff.{name}"]
    assert entries[f"liftoff.{name}.sha256"] == hashlib.sha256(text.encode()).hexdigest(), name
json.loads(entries[f"liftoff.{kind}"])
