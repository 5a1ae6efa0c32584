"""A motion as arrays, against what mechanics says of it."""

import math
import sys

import numpy as np
import pytest

import liftoff
from conftest import ONE


@pytest.fixture(scope="module")
def run(ladder):
    return ladder.simulate()


def test_events_are_located(run):
    assert [event.kind for event in run.events] == ["start", "open", "stop"]
    leaves = run.events[1]
    # The wall lets go where sin φ = ⅔ sin φ₀; the floor bears a quarter of the weight then.
    assert leaves.names == ["B"]
    assert math.isclose(math.sin(leaves["phi"]), 2 / 3 * math.sin(1.3), abs_tol=1e-11)
    assert math.isclose(leaves.reactions["A"], 9.81 / 4, abs_tol=1e-10)
    assert list(leaves.state) == ["phi", "x_A", "y_A", "phi'", "x_A'", "y_A'"]
    assert leaves.state["phi'"] == leaves["phi'"] < 0
    assert leaves["t"] == leaves.t and str(leaves) == leaves.text and leaves.text.startswith("B open at t = ")
    assert repr(leaves) == f"<Event: {leaves}>"
    assert run.events is run.events


def test_columns_lie_over_the_times(run):
    assert run.names == list(run.events[0].state)
    assert run.state.shape == (len(run.t), 6) and run.t.dtype == np.float64
    assert run.t[0] == 0 and run.t[-1] == run.events[-1].t and (np.diff(run.t) > 0).all()
    assert run["phi"][0] == 1.3 and abs(run["phi"][-1]) < 1e-12
    energy = run["T + V"]
    assert np.ptp(energy) < 1e-11 * abs(energy[0])


def test_arrays_are_not_copied_and_cannot_be_written(run):
    assert run.t is run.t and run.state is run.state
    assert np.shares_memory(run["phi'"], run.state)
    # The memory is Rust's.
    assert not run.t.flags.owndata and run.t.base is not None
    for array in (run.t, run.state, run["phi"]):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


def test_both_sides_of_an_impact():
    ball = liftoff.Model(
        """#[derive(BarSystem)] #[gravity(g)] #[particle(P, mass = m)] #[support(P = floor, restitution = e)]
        #[figure(P = (0, 1))] #[coordinate(x = x(P))] #[coordinate(y = y(P))]
        struct Ball { #[value(1)] m: f64, #[value(0.5)] e: f64, #[value(2)] g: f64 }"""
    )
    run = ball.simulate({"x": 0, "y": 1}, limit=1.5)
    impact = run.events[1]
    [before, after] = np.flatnonzero(run.t == impact.t)
    assert run["y'"][[before, after]] == pytest.approx([-2, 1])
    assert run.state[before, 3] == run["y'"][before] and len(run.state) == len(run.t)
    assert run["y'"].min() == pytest.approx(-2) and impact.before["y'"] == pytest.approx(-2)
    assert impact.before["T"] == pytest.approx(2) and impact.energy["T"] == pytest.approx(0.5)
    assert (impact.t, pytest.approx(-2), True) in run.extrema("y'")
    assert run.events[0].before is None


def test_outputs_are_read_at_any_times(run):
    end = run.events[-1].t
    times = np.linspace(0, end, 12).reshape(3, 4)
    reactions = run.output("N(A)", times)
    assert reactions.shape == (3, 4)
    assert reactions[1, 2] == run.output("N(A)", times[1, 2])
    assert isinstance(run.output("N(A)", 0.5), float)
    assert np.array_equal(run.output("sin(phi)^2", run.t), run["sin(phi)^2"])
    assert np.array_equal(run.at(times)[..., 0], run.output("phi", times))
    assert run.at(0.25).shape == (6,)
    assert np.array_equal(run.output("phi", [0, 0.5]), [1.3, run.output("phi", 0.5)])
    t, value, minimum = run.extrema("N(B)")[0]
    sampled = run.output("N(B)", np.linspace(0, run.events[1].t, 2001)[:-1])
    assert not minimum and 0 < t < end and value == pytest.approx(sampled.max(), rel=1e-6)


@pytest.mark.parametrize("t", [-1, 1e9, math.nan, [0.1, math.inf]])
def test_times_outside_the_run_are_refused(run, t):
    with pytest.raises(ValueError, match="not within the run"):
        run.output("phi", t)


def test_frames_have_the_same(run):
    frame = run.to_frame("N(A)")
    assert list(frame.columns) == [*run.names, "N(A)"] and frame.index.name == "t"
    assert np.array_equal(frame["N(A)"], run["N(A)"])
    assert list(run.to_frame(t=[0.0, 0.5]).index) == [0.0, 0.5]
    even = run.to_frame("N(A)", every="10 ms")
    assert list(even.index) == [k * 0.01 for k in range(len(even))] and even.index[-1] <= run.t[-1] < even.index[-1] + 0.01
    assert np.array_equal(even["N(A)"], run.output("N(A)", even.index))
    for wrong, told in [(0, "a time > 0"), (-1, "a time > 0"), (math.nan, "a time > 0"), ("1 m", "measured in s"), (1e-12, "rows")]:
        with pytest.raises(ValueError, match=told):
            run.to_frame(every=wrong)
    with pytest.raises(ValueError, match="given by `t` already"):
        run.to_frame(t=[0.0], every=0.1)


def test_pictures_and_pages_are_whole(run, tmp_path):
    chart = run.chart("N(A)", against="phi")
    assert isinstance(chart, liftoff.Svg) and chart.startswith("<svg") and chart._repr_svg_() == str(chart)
    page = run.page("T")
    page.save(tmp_path / "run.html")
    assert (tmp_path / "run.html").read_text(encoding="utf-8") == page
    shown = run._repr_html_()
    assert shown.startswith("<iframe sandbox") and "<script" not in shown and run._repr_svg_().startswith("<svg")


def test_matplotlib_draws_on_given_axes(run, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    ax = matplotlib.figure.Figure().add_subplot()
    assert run.plot("phi", "N(A)", ax=ax, linewidth=3) is ax
    phi, normal, opened = ax.lines
    assert (phi.get_label(), normal.get_label(), normal.get_linewidth()) == ("φ, rad", "N(A), N", 3)
    assert ax.get_xlabel() == "t, s" and len(ax.get_legend().texts) == 2
    assert phi.get_ydata() == pytest.approx(run.output("phi", phi.get_xdata()), abs=1e-9) and len(phi.get_xdata()) > 200
    assert list(opened.get_xdata()) == [run.events[1].t] * 2 and [text.get_text() for text in ax.texts] == ["B open"]
    against = run.plot("N(A)", against="phi")
    assert (against.get_xlabel(), against.get_ylabel(), against.get_legend()) == ("φ, rad", "N(A), N", None)
    assert [against.lines[1].get_xdata()[0], against.lines[1].get_ydata()[0]] == [run.events[1]["phi"], run.events[1].reactions["A"]]
    assert [line.get_label() for line in run.plot().lines[:3]] == ["φ, rad", "x_A, m", "y_A, m"]
    with pytest.raises(liftoff.UnknownName, match="no support `C`"):
        run.plot("N(C)", ax=ax)
    with pytest.raises(TypeError, match="ax: expected axes of Matplotlib"):
        run.plot("phi", ax="phi")
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match="plots need Matplotlib: pip install matplotlib"):
        run.plot("phi")


def test_values_that_jump_break_the_line():
    run = liftoff.Model.built_in("bouncing-ball").simulate()
    ax = pytest.importorskip("matplotlib.figure").Figure().add_subplot()
    velocity = run.plot("y'", ax=ax).lines[0].get_ydata()
    impacts = [event for event in run.events if event.kind == "impact"]
    assert np.isnan(velocity).sum() > 5 and ax.texts[0].get_text() == f"P impact × {len(impacts)}"


def test_what_is_asked_for_is_done(pendulum):
    period = 2 * math.pi * math.sqrt(2 / (3 * 9.81))
    run = pendulum.simulate({"phi": "1deg"}, ["phi = 0", "t = 10"], set=ONE, tolerance=1e-10, method="dop853")
    assert run.events[-1].t == pytest.approx(period / 4, rel=1e-4)
    assert run.arguments["method"] == "dop853" and run.arguments["tolerance"] == 1e-10
    assert run.stopped is None
    short = pendulum.simulate(start={"phi": 1}, set=ONE, limit=0.5)
    assert (short.events[-1].kind, short.events[-1].t) == ("end", 0.5)
    struck = pendulum.simulate({"phi": 1}, set=ONE, limit=0.5, impulses=[("A", (1.0, 0.0), 0.25)])
    assert [event.kind for event in struck.events] == ["start", "impulse", "end"]


def test_supports_are_held_and_released(ladder):
    kinds = lambda **options: [event.kind for event in ladder.simulate(**options).events]
    assert kinds(hold="B") == ["start", "stop"]
    assert kinds(hold=["A", "B"]) == ["start", "stop"]
    assert kinds(release={"B": 0.1}) == ["start", "release", "stop"]


def test_names_are_asked_for_by_in(run):
    assert "phi" in run and "phi'" in run and "psi" not in run
    assert "phi" in run.events[0] and "t" in run.events[0] and "psi" not in run.events[0]
    for what in (run, run.events[0]):
        with pytest.raises(TypeError, match="not iterable"):
            iter(what)
