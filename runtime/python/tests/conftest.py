"""Models that the tests run."""

import json
import pathlib

import pytest

import liftoff

ROOT = pathlib.Path(__file__).resolve().parents[3]

LADDER = """
use liftoff::prelude::*;

/// A ladder between a smooth floor and a smooth wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[run(start = "phi = 1.3", until = "phi = 0")]
struct Ladder {
    #[value = 1.0]
    m: f64,
    #[value = 2.0]
    l: f64,
    #[value = 9.81]
    g: f64,
}
"""

PENDULUM = """
/// A bar that swings.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Pendulum { m: f64, l: f64, g: f64 }
"""

ONE = {"m": 1, "l": 1, "g": 9.81}


@pytest.fixture(scope="session")
def ladder() -> liftoff.Model:
    return liftoff.Model(LADDER)


@pytest.fixture(scope="session")
def pendulum() -> liftoff.Model:
    return liftoff.Model(PENDULUM)


@pytest.fixture(scope="session")
def zigzag() -> liftoff.Model:
    return liftoff.Model.from_file(ROOT / "models/systems/src/zigzag.rs")


@pytest.fixture(scope="session")
def references() -> dict:
    """25 digits of what the paper's systems do."""
    return json.loads((ROOT / "models/data/references.json").read_text())
