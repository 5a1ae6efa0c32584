"""Bad input is told, whatever it is."""

import math
import random

import pytest

import liftoff
from conftest import LADDER, ONE, PENDULUM


def test_mistakes_are_told_at_their_places():
    text = LADDER.replace("mass = m", "mass = µ").replace("support(A", "suport(A")
    with pytest.raises(liftoff.DeclarationError) as told:
        liftoff.Model(text)
    report = str(told.value)
    assert "error: there is no attribute `suport`; did you mean `support`?" in report
    assert "#[bar(AB, mass = µ, length = l)]" in report and "\x1b" not in report
    assert {text[start:end] for _, start, end in told.value.mistakes} >= {"µ", "suport"}
    assert isinstance(told.value, (liftoff.Error, ValueError))


def test_a_file_is_named_in_the_report(tmp_path):
    path = tmp_path / "bad.rs"
    path.write_text(LADDER.replace("wall(0)", "wal(0)"))
    with pytest.raises(liftoff.DeclarationError, match=r"bad\.rs:9:"):
        liftoff.Model.from_file(path)
    with pytest.raises(FileNotFoundError, match="nowhere.rs"):
        liftoff.Model.from_file(tmp_path / "nowhere.rs")
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(OSError):
        liftoff.Model.from_file(path)


def test_a_text_without_a_model_is_refused():
    with pytest.raises(ValueError, match="nothing in text derives `BarSystem`"):
        liftoff.Model("struct Empty;")
    with pytest.raises(TypeError):
        liftoff.Model(3)


@pytest.mark.parametrize(
    "arguments, told",
    [
        ({"start": {"psi": 1}}, "no coordinate `psi`"),
        ({"set": {"mm": 1}}, "no parameter `mm`; did you mean `m`"),
        ({"hold": "Z"}, "no support `Z`"),
        ({"release": {"Z": 1}}, "no support `Z`"),
        ({"until": "psi = 0"}, "no name `psi`"),
        ({"method": "tsit"}, "did you mean `tsit5`"),
    ],
)
def test_unknown_names_are_key_errors_with_the_nearest(ladder, arguments, told):
    with pytest.raises(KeyError) as error:
        ladder.simulate(**arguments)
    assert told in str(error.value) and isinstance(error.value, liftoff.UnknownName)
    assert isinstance(error.value, ValueError)


@pytest.mark.parametrize(
    "arguments, told",
    [
        ({"start": {"phi": math.nan}}, "NaN"),
        ({"set": {"l": math.inf}}, "inf"),
        ({"set": {"m": -1}}, "negative"),
        ({"start": {"phi": "2 m"}}, "measured in rad"),
        ({"start": {"phi": "one"}}, "is no number"),
        ({"until": "phi ="}, "until"),
        ({"limit": -1}, "limit"),
        ({"limit": "2 m"}, "limit: measured in s, not in m"),
        ({"limit": math.nan}, "limit"),
        ({"tolerance": 2}, "tolerance"),
        ({"cut": {"A": "t = 1"}}, "not a thread"),
    ],
)
def test_values_without_a_motion_are_value_errors(ladder, arguments, told):
    with pytest.raises(ValueError, match=told):
        ladder.simulate(**arguments)


@pytest.mark.parametrize(
    "arguments",
    [{"start": 3}, {"start": {"phi": None}}, {"until": 3}, {"untl": "t = 1"}, {"hold": [1]}, {"set": {1: 2}}, {"impulses": 3}],
)
def test_other_types_are_type_errors(ladder, arguments):
    with pytest.raises(TypeError):
        ladder.simulate(**arguments)


def test_parameters_that_are_not_given_are_named(pendulum):
    with pytest.raises(ValueError, match="parameter `l` is not given"):
        pendulum.simulate({"phi": 1}, set={"m": 1, "g": 1}, limit=1)


def test_expressions_are_checked(ladder):
    run = ladder.simulate()
    with pytest.raises(KeyError, match="phj"):
        run["phj"]
    with pytest.raises(ValueError, match="expected"):
        run.output("phi +", 0)
    with pytest.raises(KeyError):
        run.chart("N(Z)")
    with pytest.raises(KeyError):
        run.page("N(Z)")
    with pytest.raises(KeyError, match="no coordinate `psi`"):
        run.events[0]["psi"]


def test_a_run_that_stops_short_keeps_its_motion():
    with pytest.raises(liftoff.RunError) as error:
        liftoff.Model(STALLS).simulate(set={"m": 1, "k": 1}, start={"x": 1}, limit=10)
    run = error.value.trajectory
    assert "stopped short" in str(error.value) and run.stopped == str(error.value)
    assert 0 < run.t[-1] < 10 and len(run["x"]) == len(run.t)


# x'' = 1/(1 − t)² has no motion beyond t = 1.
STALLS = """
/// A particle under a force that grows beyond all bounds.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[force(P = (k / ((1 - t) * (1 - t)), 0))]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Pushed { m: f64, k: f64 }
"""


def test_no_text_panics():
    random.seed(1)
    words = ["(", ")", "#[", "]", "mass", "l", "9e999", "AB", "'", '"', "::", "µ", "\0", "{", "mirror", "-", "/ 0", "figure"]
    for text in (LADDER, PENDULUM):
        for _ in range(150):
            letters = list(text)
            for _ in range(random.randint(1, 4)):
                at = random.randrange(len(letters))
                letters[at : at + random.randint(0, 8)] = random.choice(words)
            try:
                model = liftoff.Model("".join(letters))
                model.simulate({"phi": 0.5}, set=ONE, limit=0.1)
            except (ValueError, liftoff.Error):
                pass


def test_deep_texts_are_refused():
    for text in ("(" * 100_000, "fn f() { " + "- " * 100_000 + "}"):
        with pytest.raises(ValueError):
            liftoff.Model(text + PENDULUM)
