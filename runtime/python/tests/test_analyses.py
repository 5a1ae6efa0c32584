"""What follows from a model beside its motions, against closed forms."""

import math

import numpy as np
import pytest

import liftoff
from conftest import ONE, ROOT

LEANING = """
use liftoff::prelude::*;

/// A rod that leans on a smooth wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[support(B = wall(0), facing = right)]
#[force(B = (0, -F))]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[run(start = "phi = 60deg")]
struct Leaning {
    #[value = 1.0]
    m: f64,
    #[value = 2.0]
    l: f64,
    #[value = 9.81]
    g: f64,
    #[value = 0.5]
    mu: f64,
    #[value = 0.0]
    F: f64,
}
"""


@pytest.fixture(scope="module")
def leaning():
    return liftoff.Model(LEANING)


def test_a_pendulum_rests_hanging_and_standing(pendulum):
    hanging, standing = pendulum.equilibrium({"phi": 0.1}, set=ONE)
    assert (hanging.closed, hanging.stability, hanging.limit) == ([], "stable", None)
    assert hanging.position["phi"] == pytest.approx(0, abs=1e-12)
    [mode] = hanging.linear.modes
    assert mode.frequency == pytest.approx(math.sqrt(1.5 * 9.81), rel=1e-12) and mode.shape == {"phi": 1}
    assert mode.rate.real == 0 and mode.damping_ratio == 0
    assert hanging.joint_forces["fy(O, OA)"] == pytest.approx(9.81, rel=1e-12)
    assert abs(standing.position["phi"]) == pytest.approx(math.pi) and standing.stability == "unstable"
    assert standing.linear.modes[0].growth == pytest.approx(math.sqrt(1.5 * 9.81), rel=1e-12)


def test_a_ladder_bears_what_statics_says(leaning):
    found = leaning.equilibrium()
    [rest] = [rest for rest in found if rest.position["phi"] == pytest.approx(math.pi / 3)]
    wall = 9.81 / (2 * math.tan(math.pi / 3))
    assert rest.closed == ["A", "B"] and rest.stability == "fixed"
    assert rest.reactions["A"] == pytest.approx((9.81, 9.81), rel=1e-12)
    assert rest.reactions["B"] == pytest.approx((wall, wall), rel=1e-12)
    assert np.abs(rest.friction["A"]) == pytest.approx(wall, rel=1e-12) and list(rest.friction) == ["A"]


def test_a_load_grows_until_a_support_slides(leaning):
    # (m g/2 + F)/tan φ = μ (m g + F) at the floor.
    share = 0.5 * math.tan(math.pi / 3)
    limit = 9.81 * (share - 0.5) / (1 - share)
    for load in ("F", {"F": 50}):
        ends = [rest.limit for rest in leaning.equilibrium(load=load) if rest.stability == "fixed"]
        assert ends[0].end == "A slides" and ends[0].value == pytest.approx(limit, rel=1e-6)
    assert leaning.equilibrium(load={"F": "1 N"})[0].limit is None


def test_what_an_equilibrium_cannot_take_is_told(leaning):
    with pytest.raises(liftoff.UnknownName, match="no parameter `f`; did you mean `F`"):
        leaning.equilibrium(load="f")
    with pytest.raises(TypeError, match="no argument `laod`; did you mean `load`"):
        leaning.equilibrium(laod="F")
    with pytest.raises(TypeError, match="no argument `strat`; did you mean `start`"):
        leaning.equilibrium(strat={})
    with pytest.raises(TypeError, match="load: expected"):
        leaning.equilibrium(load=3)
    with pytest.raises(ValueError, match="one parameter is a load, not 2"):
        leaning.equilibrium(load={"F": 1, "m": 2})
    with pytest.raises(ValueError, match="measured in N"):
        leaning.equilibrium(load={"F": "1 m"})
    with pytest.raises(liftoff.AnalysisError, match="no equilibrium found"):
        leaning.equilibrium(set={"g": -9.81})


def test_a_linearisation_has_the_matrices_of_the_motion(pendulum):
    linear = pendulum.linearise({"phi": 0}, set=ONE)
    # θ'' = −(3 g/2 l) θ, with ξ = √(m l²/3) θ.
    assert linear.A == pytest.approx(np.array([[0, 1], [-1.5 * 9.81, 0]]), rel=1e-12, abs=1e-12)
    assert linear.B == pytest.approx(np.array([[0], [math.sqrt(3)]]), rel=1e-12)
    assert linear.Z == pytest.approx(np.array([[math.sqrt(3)]]), rel=1e-12) and linear.residual < 1e-12
    with pytest.warns(UserWarning, match="the start is no equilibrium"):
        falling = pendulum.linearise({"phi": 1}, set=ONE)
    assert falling.modes[0].frequency == pytest.approx(math.sqrt(1.5 * 9.81 * math.cos(1)), rel=1e-9)


def test_a_ladder_is_linearised_with_the_supports_that_are_closed(leaning):
    with pytest.warns(UserWarning):
        assert [len(leaning.linearise(closed=closed).modes) for closed in (["A", "B"], "A", "free", [])] == [0, 1, 3, 3]
    with pytest.raises(liftoff.UnknownName, match="no support `C`"):
        leaning.linearise(closed="C")
    with pytest.raises(ValueError, match="unfold: "):
        leaning.linearise(unfold=True)


def test_an_unfolded_zigzag_falls_faster_to_one_side(zigzag):
    upright = {"phi_inner": "90deg", "phi_outer": "90deg"}
    for share in (0, 0.25, 1):
        masses = {"m1": 1 - share, "m2": share}
        halves = zigzag.linearise(upright, set={**masses, "l": 1, "g": 9.81}, unfold=True)
        # Fig. 1b upright: σₐ/σₛ.
        ratio = math.sqrt((1 / 3 + 2 * share) / (1 / 12 + share - share**2))
        assert halves.growth_ratio == pytest.approx(ratio, rel=1e-10)
        assert "phi_inner_image" in halves.antisymmetric.modes[0].shape


WHEEL = {"m": 1, "j": 0.1, "l": 1, "gamma": 0.2, "mu": 1.5, "g": 9.81}


@pytest.fixture(scope="module")
def wheel():
    return liftoff.Model.from_file(ROOT / "models/systems/src/rimless_wheel.rs")


@pytest.fixture(scope="module")
def ball():
    return liftoff.Model.from_file(ROOT / "models/systems/src/bouncing_ball.rs")


def rolling(phi=-0.2, rate=-2.0):
    # It turns about A: the hub has the velocity of a spoke's end.
    at = phi - math.pi / 3
    return {"phi": phi, "phi'": rate, "x'": rate * math.sin(at), "y'": -rate * math.cos(at)}


def test_a_rimless_wheel_has_the_multiplier_of_its_impacts(wheel):
    drift = ["phi", "x", "y"]
    orbit = wheel.orbit("impact", rolling(), drift=drift, set=WHEEL, limit=5)
    share = ((0.1 + 0.5) / 1.1) ** 2
    assert orbit.multipliers == pytest.approx([share], rel=1e-8) and orbit.stability == "stable"
    assert orbit.shift["phi"] == pytest.approx(-math.pi / 3) and orbit.parameters["gamma"] == 0.2
    # Half a turn of 60° falls by sin γ: φ'² gains 2 g sin γ m l/(j + m l²), and keeps a share of it.
    gained = 2 * 9.81 * math.sin(0.2) / 1.1
    assert orbit.state["phi'"] ** 2 == pytest.approx(share * gained / (1 - share), rel=1e-9)
    assert ("impact", ["C"]) in orbit.events or ("impact", ["B"]) in orbit.events
    branch = wheel.orbit("impact", rolling(), drift=drift, set=WHEEL, limit=5, continue_to={"gamma": 0.21})
    assert branch.end == "followed to the end" and branch.orbits[-1].parameters["gamma"] == pytest.approx(0.21)
    assert all(point.multipliers == pytest.approx([share], rel=1e-6) for point in branch.orbits)


def test_what_an_orbit_cannot_take_is_told(wheel):
    with pytest.raises(liftoff.UnknownName, match="no coordinate `phj`; did you mean `phi`"):
        wheel.orbit("impact", rolling(), drift="phj", set=WHEEL)
    with pytest.raises(ValueError, match="section `impct`"):
        wheel.orbit("impct", rolling(), set=WHEEL)
    with pytest.raises(TypeError, match="did you mean `continue_to`"):
        wheel.orbit("impact", rolling(), set=WHEEL, continue_too={"gamma": 1})
    with pytest.raises(liftoff.AnalysisError, match="does not reach the section"):
        wheel.orbit("impact", {"phi": -0.2}, set={**WHEEL, "gamma": 0}, limit=0.1)


def test_derivatives_of_a_bouncing_ball_are_those_of_its_closed_form(ball):
    found = ball.sensitivity(["g", "e", "y"], {"x": 0, "y": 1}, set={"m": 1, "g": 9.81, "e": 0.8}, until="t = 1.5")
    first, second = (at for at in found.events if at.event.kind == "impact")
    # t₁ = √(2 y/g), t₂ = (1 + 2 e) t₁
    t = math.sqrt(2 / 9.81)
    assert first.time == pytest.approx({"g": -t / (2 * 9.81), "e": 0, "y": t / 2}, rel=1e-9, abs=1e-12)
    assert second.time == pytest.approx({"g": -2.6 * t / (2 * 9.81), "e": 2 * t, "y": 2.6 * t / 2}, rel=1e-9)
    assert first.state["y'"]["e"] == pytest.approx(9.81 * t, rel=1e-9)
    assert list(found.end) == ["x", "y", "x'", "y'"]


def test_unknown_variables_are_told(ball):
    given = {"set": {"m": 1, "g": 9.81, "e": 0.8}, "until": "t = 1"}
    with pytest.raises(liftoff.UnknownName, match=r"y': neither a parameter nor given .* start={\"y'\": …} gives it"):
        ball.sensitivity("y'", {"y": 1}, **given)
    with pytest.raises(ValueError, match="`g` is given twice"):
        ball.sensitivity(["g", "g"], {"y": 1}, **given)


BALL = {"m": 1, "g": 9.81, "e": 0.8}


def test_a_fit_finds_what_made_the_times_of_impacts(ball):
    t = math.sqrt(2 * 1.2 / 9.81)
    times = {"first impact": t, "2nd impact": t * (1 + 2 * 0.7), "3rd impact": (t * (1 + 2 * 0.7 + 2 * 0.49), 1)}
    events = {name: time if isinstance(time, tuple) else (time, "1 s") for name, time in times.items()}
    fit = ball.fit(["e", "y"], {"x": 0, "y": 1}, set=BALL, until="t = 5", events=events)
    assert fit.estimates["e"].value == pytest.approx(0.7, rel=1e-9) and fit.stopped is None
    assert fit.estimates["y"].value == pytest.approx(1.2, rel=1e-9) and fit.freedom == 1
    assert fit.data[0] == "the time of first impact" and fit.residuals == pytest.approx(np.zeros(3), abs=1e-9)


@pytest.mark.parametrize("kind", ["dict", "frame", "file"])
def test_a_fit_of_a_series_is_that_of_linear_least_squares(ball, tmp_path, kind):
    pandas = pytest.importorskip("pandas")
    t = np.linspace(0, 0.4, 21)
    measured = 1 - 4.9 * t**2 + 1e-3 * np.cos(57 * np.arange(21))
    data = {"t": t, "y": np.where(t == t[3], np.nan, measured)}
    if kind == "frame":
        data = pandas.DataFrame(data).set_index("t")
    elif kind == "file":
        data = tmp_path / "measured.csv"
        pandas.DataFrame({"t": t, "y": measured}).drop(3).to_csv(data, index=False)
    given = {"set": BALL, "data": data}
    if kind == "file":
        fit = ball.fit(["y", "g"], {"x": 0, "y": 1}, **given)
    else:
        with pytest.warns(UserWarning, match="empty cells, which are skipped: 1"):
            fit = ball.fit(["y", "g"], {"x": 0, "y": 1}, **given)
    matrix = np.delete(np.stack([np.ones(21), -(t**2) / 2], axis=1), 3, axis=0)
    exact, square, *_ = np.linalg.lstsq(matrix, np.delete(measured, 3), rcond=None)
    variances = square[0] / 18 * np.diag(np.linalg.inv(matrix.T @ matrix))
    estimates = [fit.estimates[name] for name in ("y", "g")]
    assert [estimate.value for estimate in estimates] == pytest.approx(exact, rel=1e-7)
    assert [estimate.standard_error for estimate in estimates] == pytest.approx(np.sqrt(variances), rel=1e-5)
    assert fit.scatter == pytest.approx(math.sqrt(square[0] / 18), rel=1e-5) and fit.freedom == 18


@pytest.mark.parametrize(
    "arguments, told",
    [
        ({"events": {"first impct": 1}}, "events: first impct: .*did you mean `impact`"),
        ({"events": {"first impact": "1 m"}}, "events: first impact: measured in s, not in m"),
        ({"events": {"first impact": (1, -1)}}, "a standard deviation is a number > 0"),
        ({"events": {"first impact": 1, "2nd impact y": 1}}, "has no standard deviation"),
        ({"data": {"y": [1]}}, "data: there is no column `t` among `y`"),
        ({"data": {"t": [0, 1], "q": [1, 2]}}, "data: column `q`: .*; of COLUMN leaves others out"),
        ({"data": {"t": [0, 1], "y": [1]}}, "data: y has 1 values, but t has 2"),
        ({"data": {"t": [0, 0.2, 0.1], "y": [1, 1, 1]}}, "data, row 2: t = 0.1 does not come after t = 0.2"),
        ({"data": {"t": [0, 0.2], "y": ["one", 1]}}, "data: y: "),
        ({"data": {"t": [0, 0.2], "y": [1, 1]}, "sd": {"x": 1}}, "sd: x: no such column is fitted"),
        ({"sd": {"y": 1}, "events": {"first impact": 1}}, "of, sd: there is no data"),
        ({"data": {"t": [0, 0.2], "y": [1, 1]}, "limit": 0.1}, "t = 0.2 is after the limit 0.1"),
        ({}, "0 measured values are too few"),
    ],
)
def test_what_cannot_be_fitted_is_told(ball, arguments, told):
    with pytest.raises(ValueError, match=told):
        ball.fit("e", {"x": 0, "y": 1}, set=BALL, until="t = 1", **arguments)


def test_an_optimum_is_that_of_its_closed_form(ball):
    flying = {"set": BALL, "until": "t = 0.1"}
    # y − y'² after t is greatest for the rate g t + t/2 at first.
    best = ball.optimise("end y - y'*y'", "y'", {"x": 0, "y": 1, "y'": 0}, greatest=True, **flying)
    rate = 9.81 * 0.1 + 0.05
    assert best.values["y'"] == pytest.approx(rate, rel=1e-6) and best.stopped is None and best.at_bounds == []
    assert best.value == pytest.approx(1 + rate * 0.1 - 9.81 * 0.005 - 0.0025, rel=1e-9)
    falling = {"set": BALL, "limit": 5}
    soonest = ball.optimise("first impact", {"y": (0.5, "2 m")}, {"x": 0, "y": 1}, **falling)
    assert soonest.at_bounds == ["y"] and soonest.value == pytest.approx(math.sqrt(1 / 9.81), rel=1e-4)
    with pytest.warns(UserWarning, match="the output improves without bound .*: vary g="):
        assert "without bound" in ball.optimise("first impact", "g", {"x": 0, "y": 1}, **falling).stopped


@pytest.mark.parametrize(
    "of, vary, told",
    [
        ("first impct", "y", "of: `first impct`: .*did you mean `impact`"),
        ("max y", "y", "expected an event"),
        ("first impact", "q", "q: neither a parameter nor given at the start"),
        ("first impact", {"y": (2, 1)}, "expected a lower and a greater bound"),
        ("first impact", {"y": 3}, "expected a lower and a greater bound"),
        ("first impact", {"y": (2, 3)}, "y = 1 is not between its bounds, 2 and 3"),
        ("first impact", {"y": ("0 s", 3)}, "vary: y: measured in m, not in s"),
    ],
)
def test_what_cannot_be_optimised_is_told(ball, of, vary, told):
    with pytest.raises(ValueError, match=told):
        ball.optimise(of, vary, {"x": 0, "y": 1}, set=BALL, limit=1)


def test_a_boundary_is_where_what_is_observed_changes(ball):
    # At t the height is y − g t²/2.
    given = {"observe": "end y = 0.4", "start": {"x": 0}, "set": BALL, "until": "t = 0.3"}
    [curve] = ball.boundary({"y": (0.5, 1.5), "g": ("1 m/s^2", 10, 9)}, **given)
    assert list(curve.points) == ["y", "g"] and curve.ends == ("the edge", "the edge")
    assert curve.points["y"] == pytest.approx(0.4 + curve.points["g"] * 0.045, abs=1e-8)
    is_upward = curve.points["g"][-1] > curve.points["g"][0]
    assert (curve.left, curve.right) == (("< 0.4", "> 0.4") if is_upward else ("> 0.4", "< 0.4"))
    named = {"start": {"x": 0, "y": "h + 0.1"}, "set": BALL, "until": "t = 0.3", "observe": "end y = 0.4"}
    [curve] = ball.boundary({"h": (0.5, 1.5), "m": (1, 2)}, threads=1, accuracy=1e-8, **named)
    assert curve.points["h"] == pytest.approx(0.3 + 9.81 * 0.045, abs=1e-5)


@pytest.mark.parametrize(
    "vary, options, told",
    [
        ({"y": (0.5, 1.5)}, {}, "two"),
        ({"y": (1.5, 0.5), "g": (1, 2)}, {}, "vary: y: "),
        ({"y": 3, "g": (1, 2)}, {}, "vary: y: expected a pair"),
        ({"y": (1, 2), "q": (1, 2)}, {}, "q"),
        ({"y": (1, 2), "g": (1, 2)}, {"observe": "first impct"}, "did you mean `impact`"),
        ({"y": (1, 2), "g": (1, 2)}, {"set": {"e": [0.1, 0.2]}}, "e: an array"),
        ({"y": (1, 2), "g": (1, 2)}, {"accuracy": -1}, "a width above zero"),
    ],
)
def test_what_has_no_boundary_is_told(ball, vary, options, told):
    with pytest.raises(ValueError, match=told):
        ball.boundary(vary, **{"start": {"x": 0}, "set": BALL, "until": "t = 0.1", **options})
