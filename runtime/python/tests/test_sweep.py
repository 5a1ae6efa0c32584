"""Sweeps against single runs, and what arrays may be."""

import math

import liftoff
import numpy as np
import pytest


def test_runs_are_those_of_single_calls(ladder):
    starts, lengths = np.linspace(0.6, 1.4, 5), np.array([[1.0], [2.0]])
    observed = ["first open", "t of first open B", "end phi'", "max N(A)", "count open", "end"]
    table = ladder.sweep(observed, start={"phi": starts}, set={"l": lengths})
    assert (table.shape, len(table), table.failed) == ((2, 5), 10, {}) and table.seconds > 0
    assert set(table["first open"].ravel()) == {"B"} and table["first open"].dtype == object
    for (i, k), t in np.ndenumerate(table["t of first open B"]):
        run = ladder.simulate(start={"phi": starts[k]}, set={"l": lengths[i, 0]})
        assert t == run.events[1].t
        assert table["end phi'"][i, k] == run.events[-1]["phi'"]
        assert (table["count open"][i, k], table["end"][i, k]) == (1, "stop: phi = 0")
        assert table["max N(A)"][i, k] >= run["N(A)"].max()


def test_results_do_not_depend_on_the_threads(ladder):
    starts = np.linspace(0.3, 1.5, 101)
    one, three = (ladder.sweep("t of first open", start={"phi": starts}, threads=n) for n in (1, 3))
    assert np.array_equal(one["t of first open"], three["t of first open"])


def test_inputs_are_the_arrays_given(ladder):
    starts = np.linspace(0.6, 1.4, 4)
    table = ladder.sweep("end phi", start={"phi": starts}, set={"m": [1, 2, 3, 4]})
    assert np.shares_memory(table.inputs["phi"], starts) and table["m"].tolist() == [1, 2, 3, 4]
    assert table.keys() == ["m", "phi", "end phi"]
    assert list(table) == table.keys() and "end phi" in table and "phi" in table and "psi" not in table
    with pytest.raises(liftoff.UnknownName, match="no column `psi`; known: m, phi, end phi"):
        table["psi"]
    frame = table.to_frame()
    assert frame.shape == (4, 3) and frame.index.name == "run"
    assert repr(table) == "<Table of Ladder: 4 runs; m, phi, end phi>"
    # What was observed is Rust's memory.
    base = table["end phi"]
    while isinstance(base.base, np.ndarray):
        base = base.base
    assert not base.flags.owndata


def test_names_of_ones_own_go_into_expressions_and_conditions(zigzag):
    share, stop = np.array([0.1, 0.5]), np.array([[0.25], [0.75]])
    table = zigzag.sweep(
        "end t",
        vary={"share": share, "stop": stop},
        set={"m1": "1 - share", "m2": "share", "l": 1, "g": 1},
        start={"phi_inner": "1.1 + share", "phi_outer": "1.1 + share"},
        until="t = stop",
    )
    assert table["end t"].tolist() == [[0.25, 0.25], [0.75, 0.75]]
    assert table["share"].tolist() == [[0.1, 0.5], [0.1, 0.5]]


def test_energy_and_release_take_arrays(ladder):
    table = ladder.sweep("end phi'", start={"phi": 1.2}, energy_of={"phi": np.array([1.25, 1.3])})
    single = ladder.simulate(start={"phi": 1.2}, energy_of={"phi": 1.3})
    assert table["end phi'"][1] == single.events[-1]["phi'"]
    released = ladder.sweep("t of first release", release={"B": [0.1, 0.2]})
    assert released["t of first release"].tolist() == [0.1, 0.2]


def test_strided_arrays_and_lists_are_taken(ladder):
    starts = np.linspace(0.5, 1.4, 20)
    expected = ladder.sweep("end t", start={"phi": starts[::-2].copy()})["end t"]
    for given in (starts[::-2], starts[::-2].tolist(), starts[::-2].astype(object)):
        assert np.array_equal(ladder.sweep("end t", start={"phi": given})["end t"], expected)
    empty = ladder.sweep("end t", start={"phi": []})
    assert empty["end t"].shape == (0,) and len(empty) == 0
    single = ladder.sweep("end t", start={"phi": np.full((1, 1), 1.3)})
    assert single["end t"].shape == (1, 1)


def test_members_that_fail_say_why_and_leave_the_others(ladder):
    table = ladder.sweep(["end t", "end"], start={"phi": [1.3, math.nan, 1.2]}, set={"m": [1, 1, -1]})
    assert np.isnan(table["end t"]).tolist() == [False, True, True]
    assert table["end"].tolist() == ["stop: phi = 0", None, None]
    assert "NaN" in table.failed[1] and "negative" in table.failed[2]


@pytest.mark.parametrize(
    "arguments, kind, told",
    [
        ({"observe": "end t"}, ValueError, "nothing is varied"),
        ({"observe": [], "start": {"phi": [1]}}, ValueError, "nothing is observed"),
        ({"observe": "frist open", "start": {"phi": [1]}}, ValueError, "did you mean `first`"),
        ({"observe": "end t", "start": {"psi": [1]}}, KeyError, "no coordinate `psi`"),
        ({"observe": "end t", "vary": {"s": [1]}}, ValueError, "nothing depends on what is varied"),
        ({"observe": "end t", "start": {"phi": [1, 2]}, "set": {"m": [1, 2, 3]}}, ValueError, "do not agree"),
        ({"observe": "end t", "start": {"phi": ["a"]}}, ValueError, "phi"),
        ({"observe": "end t", "start": {"phi": [[1], [1, 2]]}}, ValueError, "phi"),
        ({"observe": "end t", "start": {"phi": [1]}, "threads": 0}, ValueError, "threads"),
        ({"observe": "end t", "start": {"phi": [1]}, "method": "auto"}, TypeError, "no argument `method`"),
        ({"observe": "end t", "set": {"m": "1 + s"}, "start": {"phi": [1]}}, ValueError, "no name `s`"),
    ],
)
def test_what_makes_no_sweep_is_refused(ladder, arguments, kind, told):
    with pytest.raises(kind, match=told):
        ladder.sweep(**arguments)


def test_too_many_runs_are_refused_before_memory_is_taken(ladder):
    huge = np.broadcast_to(1.0, (100_000, 100_000))
    with pytest.raises(ValueError, match="runs are the most"):
        ladder.sweep("end t", start={"phi": huge})


def test_matplotlib_draws_a_line_for_each_value_of_the_others(ladder):
    ax = pytest.importorskip("matplotlib.figure").Figure().add_subplot()
    phi, l = np.linspace(0.6, 1.4, 5), [[1.0], [2.0]]
    table = ladder.sweep(["t of first open", "first open"], start={"phi": phi}, set={"l": l})
    assert table.plot("t of first open", "phi", ax=ax, marker="o") is ax
    assert [line.get_label() for line in ax.lines] == ["l = 1", "l = 2"] and ax.get_xlabel() == "phi"
    for line, times in zip(ax.lines, table["t of first open"]):
        assert np.array_equal(line.get_xdata(), phi) and np.array_equal(line.get_ydata(), times)
    single = ladder.sweep("end t", start={"phi": phi}).plot("end t", ax=ax.figure.add_subplot())
    assert [line.get_label() for line in single.lines] == ["end t"] and single.get_legend() is None
    with pytest.raises(ValueError, match="against: which of l, phi"):
        table.plot("t of first open")
    with pytest.raises(ValueError, match="first open: these are names, not numbers"):
        table.plot("first open", "phi")
    with pytest.raises(liftoff.UnknownName, match="no column `psi`"):
        table.plot("t of first open", "psi")


def test_a_sweep_observes_something(ladder):
    with pytest.raises(ValueError, match="observe: nothing is observed"):
        ladder.sweep([], start={"phi": [1.0]})


def test_arrays_may_stand_at_any_address(ladder):
    starts = np.linspace(0.6, 1.4, 5)
    message = np.empty(8 * len(starts) + 1, np.uint8)
    shifted = message[1:].view(np.float64)
    shifted[:] = starts
    assert not shifted.flags.aligned
    table, expected = (ladder.sweep("end t", start={"phi": values}) for values in (shifted, starts))
    assert np.array_equal(table["phi"], starts) and np.array_equal(table["end t"], expected["end t"])
    run = ladder.simulate()
    shifted[:] = np.linspace(0, run.t[-1], 5)
    assert np.array_equal(run.at(shifted), run.at(np.array(shifted)))
