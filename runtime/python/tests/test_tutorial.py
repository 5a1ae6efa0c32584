"""The book's tutorial, from its own text."""

import re

import numpy as np
import pytest

import liftoff
from conftest import ROOT

BOOK = (ROOT / "runtime/cli/src/book/tutorial.md").read_text(encoding="utf-8")
VALUES = {"m": 4, "p": 70, "l": 2, "s": 1.2, "g": 9.81}


@pytest.fixture(scope="module")
def step_ladder():
    program = re.search(r"```ignore\n(.*?)```", BOOK, re.S).group(1)
    return liftoff.Model(program)


def test_the_events_are_those_that_the_tutorial_prints(step_ladder):
    run = step_ladder.simulate(set=VALUES, cut={"AB": "t = 0.5"}, limit=3)
    printed = re.search(r"```text\n(start at t = 0, phi = 1.*?)```", BOOK, re.S).group(1).splitlines()
    events = [event.text for event in run.events]
    before, after = printed[: printed.index("…")], printed[printed.index("…") + 1 :]
    assert events[: len(before)] == before and events[-len(after) :] == after
    assert all(set(event.impulses) == {"A", "B", "C"} for event in run.events if event.kind == "impact")


def test_without_a_cut_it_stands(step_ladder):
    with pytest.raises(ValueError, match="the start is an equilibrium: it never moves"):
        step_ladder.simulate(set=VALUES, until=[])
    run = step_ladder.simulate(set=VALUES, until="phi = 0", limit=3)
    assert run.t[-1] == 3 and np.array_equal(run.state[0], run.state[-1])
    assert run.notes == [
        "at t = 0.0000: the start is an equilibrium: it stays there, unless it is unstable and roundoff grows",
        "at t = 3.0000: the run ends here, and `phi = 0` was not met",
    ]
