"""A table that the program has written comma-separated and in columns, read by pyarrow, pandas and DuckDB (arguments: the kind of table,
then the files FILE.csv, FILE.parquet, FILE.arrow without their ends)."""
import csv
import hashlib
import json
import math
import re
import struct
import sys

import duckdb
import pandas
import pyarrow
import pyarrow.feather
import pyarrow.ipc
import pyarrow.parquet

UNITS = {
    "run": {"t": "s", "phi": "rad", "phi'": "rad/s", "N(A)": "N", "gap(B)": "m", "E": "J", "E/(m*g*l)": "1"},
    "sweep": {"lambda": "1", "phi0": None, "first open phi_inner": "rad", "count open": "1", "end": None, "member": None},
    "parameters": {"m": "kg", "end vy(C)": "m/s"},
}


def bits(number):
    return struct.pack("<d", number)


def separated(path, schema):
    """The rows of a CSV file as the columns are to have them."""
    def value(text, kind):
        if text == "":
            return None
        return text if kind == pyarrow.string() else int(text) if kind == pyarrow.int64() else float(text)
    with open(path, newline="") as file:
        heads, *rows = csv.reader(file)
    # A motion's heads have units, which the schema has beside the names.
    names = [re.sub(r" \[.*\]$", "", head) for head in heads]
    assert names == schema.names, (names, schema.names)
    return [[value(text, kind) for text in column] for column, kind in zip(zip(*rows), schema.types)]


def alike(column, expected):
    """The same values, numbers to the last bit."""
    same = lambda a, b: bits(a) == bits(b) if isinstance(b, float) and a is not None else a == b
    return len(column) == len(expected) and all(map(same, column, expected))


def said(metadata, kind):
    """What a file says of its whole, with hashes as others compute them."""
    text = lambda name: metadata[f"liftoff.{name}".encode()].decode()
    digest = lambda name: hashlib.sha256(text(name).encode()).hexdigest()
    subject = "run" if kind == "run" else "sweep"
    assert all(text(f"{name}.sha256") == digest(name) for name in ["declaration", subject])
    assert text("version").count(".") == 2 and "struct" in text("declaration"), metadata
    json.loads(text(subject))
    return text("model")


kind, stem = sys.argv[1:]
table = pyarrow.parquet.read_table(f"{stem}.parquet")
schema = table.schema
expected = separated(f"{stem}.csv", schema)
for name, column in zip(schema.names, expected):
    assert alike(table[name].to_pylist(), column), name
units = {field.name: (field.metadata or {}).get(b"unit", b"").decode() or None for field in schema}
assert {name: units[name] for name in UNITS[kind]} == UNITS[kind], units
model = said(schema.metadata, kind)

file = pyarrow.ipc.open_file(f"{stem}.arrow")
assert file.schema.equals(schema, check_metadata=True)
# Equality of tables takes NaN for unequal.
assert all(alike(file.read_all()[name].to_pylist(), column) for name, column in zip(schema.names, expected))
assert pyarrow.feather.read_table(f"{stem}.arrow").num_rows == table.num_rows

frame = pandas.read_parquet(f"{stem}.parquet")
assert list(frame) == schema.names and len(frame) == table.num_rows
# By place: DuckDB takes `t` and `T` for one name, and calls the second T_1.
columns = list(zip(*duckdb.sql(f"SELECT * FROM '{stem}.parquet'").fetchall()))
for name, type, column in zip(schema.names, schema.types, columns):
    assert alike(list(column), table[name].to_pylist()), name
    if type == pyarrow.float64():
        there = [x for x in table[name].to_pylist() if x is not None and not math.isnan(x)]
        assert frame[name].dropna().tolist() == there, name
entries = duckdb.sql(f"SELECT key, value FROM parquet_kv_metadata('{stem}.parquet')").fetchall()
assert said({bytes(key): bytes(value) for key, value in entries}, kind) == model
created = duckdb.sql(f"SELECT created_by FROM parquet_file_metadata('{stem}.parquet')").fetchall()[0][0]
assert created.startswith("liftoff "), created
print(f"{table.num_rows} rows of {model}")
