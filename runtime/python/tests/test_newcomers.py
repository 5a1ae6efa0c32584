"""Mistakes of users who come from Drake, SymPy and SciPy: each message names the cause and a cure."""

import math
import warnings

import numpy as np
import pytest

import liftoff
from conftest import LADDER, ONE, PENDULUM

# In the text of the pendulum: what stands there, what is written in its place, the cause and the cure in the message.
TEXTS = [
    ("#[pin(O", "#[revolute(O", "no attribute `revolute`", "#[pin(O = (0, 0))]"),
    ("#[pin(O", "#[revolute_joint(O", "no attribute `revolute_joint`", "#[pin(O = (0, 0))]"),
    ("#[pin(O", "#[prismatic_joint(O", "no attribute `prismatic_joint`", "#[slider(P = horizontal(0))]"),
    ("#[bar(OA", "#[link(OA", "no attribute `link`", "#[bar(AB, mass = m, length = l)]"),
    ("#[bar(OA", "#[rigid_body(OA", "no attribute `rigid_body`", "#[body(hull, points("),
    ("#[gravity(g)]", "#[gravity(g)] #[actuator(OA = tau)]", "no attribute `actuator`", "#[drive(phi = omega * t)]"),
    ("#[gravity(g)]", "#[gravity(g)] #[collision(A)]", "no attribute `collision`", "#[support(A = floor)]"),
    ("#[gravity(g)]", "#[gravity(g)] #[half_space(A)]", "no attribute `half_space`", "#[support(A = floor)]"),
    ("#[gravity(g)]", "#[gravity(0, 0, -g)]", "one strength downwards or two components", "#[gravity(g)]"),
    ("#[gravity(g)]", "#[gravity([0, -g])]", "expected a number, a parameter", "[0, -g]"),
    ("length = l", "length = l ** 2", "** 2", "`l.powi(2)`"),
    ("length = l", "length = l ^ 2", "length = l ^ 2", "`l.powi(2)`"),
    ("length = l", "length = np.sqrt(l)", "np.sqrt(l)", "`sqrt(…)`"),
    ("length = l", "length = math.pi", "math.pi", "`pi`"),
    ("length = l", "length = dynamicsymbols(l)", "dynamicsymbols", "a parameter"),
    ("mass = m", "mass = 1 kg", "have no unit", '#[value(1, unit = "kg")]'),
    ("mass = m", "mass = mass", "no parameter `mass`", "declared: `m`, `l`, `g`"),
    ("mass = m, ", "", "`OA` has no mass", "add `mass = …`"),
    ("from = down", "from = 90 deg", "have no unit", "from = horizontal"),
    ("(0, 0)", "(0, 0, 0)", "(0, 0, 0)", "expected a position `(x, y)`"),
    ("(0, 0)", "[0, 0]", "[0, 0]", "expected a position `(x, y)`"),
    ("A = (0, -l)", "A = (0, -2 * l)", "draws bar `OA` 2 long, and its length is 1", "move `O` or `A`"),
    ("A = (0, -l)", "B = (0, -l)", "no point `B`", "declared: `O`, `A`"),
    ("angle(OA)", "angle(AB)", "no bar `AB`", "declared: `OA`"),
    ("phi = angle(OA)", "q[0] = angle(OA)", "expected `=`", "#[coordinate(phi = angle(AD)"),
    ("phi = angle(OA)", "t = angle(OA)", "`t` has the name of a quantity of every run", "rename"),
    ("m: f64", "m: float", "parameter `m` must be an `f64`", "f64"),
    ("g: f64", "g: f64, k: f64", "parameter `k` is used nowhere", "use it or remove it"),
    ("#[derive(BarSystem)]", "", "derives `BarSystem`", "below `#[derive(BarSystem)]`"),
    (PENDULUM, "<robot><link name='a'/></robot>", "derives `BarSystem`", 'Model.built_in("pendulum").text'),
    (PENDULUM, "class Pendulum: pass", "derives `BarSystem`", "a struct of Rust"),
    (PENDULUM, "pendulum.rs", "derives `BarSystem`", 'Model.from_file("ladder.rs")'),
]


@pytest.mark.parametrize(("old", "new", "cause", "cure"), TEXTS)
def test_texts_are_refused_with_cause_and_cure(old, new, cause, cure):
    assert old in PENDULUM
    with pytest.raises(ValueError) as error:
        liftoff.Model(PENDULUM.replace(old, new, 1))
    assert cause in str(error.value) and cure in str(error.value)


def swing(start, **arguments):
    return liftoff.Model(PENDULUM).simulate(start, **{"set": ONE, "limit": 0.1, **arguments})


def spread(start=1.0, **arguments):
    return liftoff.Model(PENDULUM).sweep(
        "end phi", start={"phi": start}, **{"set": {**ONE, "l": [1.0, 2.0]}, "limit": 0.1, **arguments}
    )


def lean(**arguments):
    return liftoff.Model(LADDER).simulate(**arguments)


# A call, the error, the cause and the cure in its message.
CALLS = [
    (lambda: swing({"theta": 1}), KeyError, "no coordinate `theta`", "known: phi, phi'"),
    (lambda: swing({"phi": 1, "phi_dot": 0}), KeyError, "no coordinate `phi_dot`", "known: phi, phi'"),
    (lambda: swing([1, 0]), TypeError, "start: expected a dict", '{"phi": 0.1}'),
    (lambda: swing(np.array([1.0, 0])), TypeError, "start: expected a dict", '{"phi": 0.1}'),
    (lambda: swing({"phi": np.linspace(0, 1, 3)}), TypeError, "start: phi: expected a number", "`sweep` runs arrays"),
    (lambda: swing({"phi": 1j}), TypeError, "start: phi: expected a number or its text", "not 1j"),
    (lambda: swing({"phi": "85 degrees"}), ValueError, "no unit `degrees`", "did you mean `deg`?"),
    (lambda: swing({"phi": 1}, set={**ONE, "m": "2 lb"}), ValueError, "no unit `lb`", "known: m, g, s"),
    (lambda: swing({"phi": 1}, set={**ONE, "l": "2 kg"}), ValueError, "l: measured in m", "not in kg"),
    (lambda: swing({"phi": 1}, set={"m": 1, "l": 1}), ValueError, "parameter `g` is not given", "set it, `g = 1`"),
    (lambda: swing({"phi": 1}, set={**ONE, "mass": 1}), KeyError, "no parameter `mass`", "known: m, l, g"),
    (lambda: swing({"phi": 1}, set={**ONE, "m": -1}), ValueError, "mass of bar OA is negative", "-1"),
    (lambda: swing({"phi": 0}, limit=None), ValueError, "it never moves", "start it elsewhere, or with a rate"),
    (lambda: swing({"phi": 1}, t_span=(0, 1)), TypeError, "no argument `t_span`", "`limit=10`"),
    (lambda: swing({"phi": 1}, t_final=1), TypeError, "no argument `t_final`", "`limit=10`"),
    (lambda: liftoff.Model.built_in("fig_1a"), KeyError, "no model `fig_1a`", "did you mean `falling-pair`?"),
    (lambda: swing({"phi": 1}, t0=0.5), TypeError, "no argument `t0`", '`start={"t": 0.3, "phi": 0.1}`'),
    (lambda: swing({"phi": 1}, until="t = 3 ms"), ValueError, "found `ms`", "`s` (else numbers are in SI units)"),
    (lambda: swing({"phi": 1, "t": "3 m"}), ValueError, "t: measured in s", "not in m"),
    (lambda: spread(threads=-1), ValueError, "threads: a whole number from 1", "not -1"),
    (lambda: spread(threads=1.5), ValueError, "threads: a whole number from 1", "not 1.5"),
    (lambda: liftoff.Declaration("P").parameters(m=("kg", 1)), TypeError, "m: expected a number with its unit", '`(200, "mm")`'),
    (lambda: swing({"phi": 1}, params=ONE), TypeError, "no argument `params`", '`set={"m": 1}`'),
    (lambda: swing({"phi": 1}, dt=0.01), TypeError, "no argument `dt`", "`to_frame(every=0.01)`"),
    (lambda: swing({"phi": 1}, rtol=1e-6), TypeError, "no argument `rtol`", "`tolerance=1e-10`"),
    (lambda: swing({"phi": 1}, events=[]), TypeError, "no argument `events`", '`until="phi = 0"`'),
    (lambda: swing({"phi": 1}, method="RK45"), KeyError, "no method `RK45`", "known: auto, tsit5, dop853"),
    (lambda: swing({"phi": 1}, until=1.0), TypeError, "until: expected a text", "not 1.0"),
    (lambda: swing({"phi": 1}, until=lambda t, y: y[0]), TypeError, "until: expected a text", "not <function"),
    (lambda: swing({"phi": 1}, until="phi != 0"), ValueError, "found `!` at column 5", "`=`, `<` or `>`"),
    (lambda: lean(hold="C"), KeyError, "no support `C`", "known: A, B"),
    (lambda: lean(release=["B"]), TypeError, "release: expected a dict", "names and values"),
    (lambda: lean(impulses=[("A", (1, 0, 0), 0.1)]), TypeError, "impulses: expected a list", '("A", (1, 0), 0.5)'),
    (lambda: lean(stop_at_impacts="yes"), TypeError, "stop_at_impacts: expected True or False", "not yes"),
    (lambda: lean(start={"phi": 1.0, "y_A": -0.5}), ValueError, "support A is penetrated", "5.000e-1"),
    (lambda: lean()["np.sin(phi)"], ValueError, "found `.` at column 3", "`sin(x)`"),
    (lambda: lean()["F(A)"], KeyError, "no function `F`", "known: x, y, vx, vy"),
    (lambda: lean().output("phi", 99.0), ValueError, "t = 99 is not within the run", "ended at t = 0.93"),
    (lambda: lean().plot("phi", ax="phi"), TypeError, "not 'phi'", "expected axes of Matplotlib"),
    (lambda: liftoff.Model(LADDER).sweep("end phi", start={"phi": 1.0}), ValueError, "nothing is varied", "give an array or a list"),
    (lambda: liftoff.Model(LADDER).sweep("final phi", start={"phi": [1.0]}), ValueError, "no observation `final`", "known: first, last"),
    (lambda: liftoff.Model(LADDER).functions().forces([0.1], [0]), ValueError, "q: expected a number for each", "phi, x_A, y_A, not 1"),
    (lambda: liftoff.Model(LADDER).linearise(q0=[1]), TypeError, "no argument `q0`", "`start={\"phi\": 0.1}`"),
    (lambda: liftoff.Model(LADDER).export("urdf"), ValueError, "target: `urdf`", "known: sympy, c"),
    (lambda: liftoff.Model.built_in("double pendulum"), KeyError, "no model `double pendulum`", "did you mean `double-pendulum`?"),
    (lambda: liftoff.Declaration("my pendulum"), ValueError, "`my pendulum` is no name of a model", "`MyLadder`"),
    (lambda: liftoff.Declaration("P").revolute(O=(0, 0)).model(), ValueError, "no attribute `revolute`", "#[pin(O = (0, 0))]"),
]


@pytest.mark.parametrize(("call", "kind", "cause", "cure"), CALLS)
def test_calls_are_refused_with_cause_and_cure(call, kind, cause, cure):
    with pytest.raises(kind) as error:
        call()
    assert cause in str(error.value) and cure in str(error.value)


def test_fifty_mistakes_are_tried():
    assert len(TEXTS) + len(CALLS) > 50


def test_degrees_without_their_unit_are_told():
    with pytest.warns(UserWarning, match="phi starts at 85 rad, 13.5 turns; degrees have their unit, `85deg`"):
        swing({"phi": 85})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        swing({"phi": "85deg", "phi'": 85})
        spread("85deg")
        texts = spread(["85deg", "5 rad"], set=ONE)
    assert list(texts["phi"]) == [math.radians(85), 5.0]
    for start in (85, [0.1, 85], np.array([85, 3])):
        with pytest.warns(UserWarning, match="phi starts at 85 rad, 13.5 turns; degrees have their unit, `85deg`"):
            spread(start)


def test_powers_are_written_as_in_python():
    run = lean()
    assert np.array_equal(run["phi ** 2"], run["phi^2"])


def test_a_run_begins_at_its_time():
    text = PENDULUM.replace("#[pin(O", "#[couple(OA = cos(t))]\n#[pin(O")
    model = liftoff.Model(text)
    whole = model.simulate({"phi": 0.5}, "t = 2 s", set=ONE)
    state = dict(zip(whole.names, whole.at(0.75)))
    rest = model.simulate({"t": "750 ms", **state}, "t = 2", set=ONE)
    assert rest.t[0] == 0.75 and rest.state[-1] == pytest.approx(whole.state[-1], rel=1e-9)
    assert list(rest.to_frame(every=0.5)["t"] if "t" in rest.to_frame(every=0.5) else rest.to_frame(every=0.5).index) == [1.0, 1.5, 2.0]
    table = model.sweep("end phi", start={"t": [0.0, 0.75], "phi": 0.5}, set=ONE, until="t = 2")
    assert table["end phi"][0] == whole["phi"][-1] != table["end phi"][1]
    with pytest.raises(ValueError, match="began at t = 0.75"):
        rest.at(0.5)


def test_arrays_and_floats_are_numbers_of_a_declaration():
    def build(number):
        return (
            liftoff.Declaration("Chain")
            .gravity(number(9.81))
            .bar("OA", mass=number(0.1 + 0.2), length=number(1 / 3))
            .bar("AB", mass=number(1 / 7), length=number(0.1 * 0.7))
            .pin(O=np.zeros(2))
            .figure(A=np.array([0, -1 / 3]), B=(0, number(-1 / 3 - 0.1 * 0.7)))
        )

    texts = [build(number).text for number in (float, np.float64, np.array)]
    assert texts[1:] == texts[:1] * 2 and "mass = 0.30000000000000004" in texts[0]
    run = build(float).model().simulate({"theta_OA": 1.0}, limit=0.1)
    assert run["E"][-1] == pytest.approx(run["E"][0], abs=1e-12)
