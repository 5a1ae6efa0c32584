"""What follows from a model beside its motions, against closed forms."""

import math

import numpy as np
import pytest

import liftoff
from conftest import ONE

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
