"""Declarations that are put together call by call are those of texts."""

import copy
import pickle

import numpy as np
import pytest

import liftoff
from conftest import LADDER

BUILT = (
    liftoff.Declaration("Ladder", "A ladder between a smooth floor and a smooth wall.")
    .gravity("g")
    .bar("AB", mass="m", length="l")
    .support(A="floor")
    .support(B="wall(0)", facing="right")
    .figure(A=("3 * l / 5", 0), B=(0, "4 * l / 5"))
    .coordinate(phi="angle(AB)", from_="horizontal")
    .run(start={"phi": 1.3}, until="phi = 0")
    .parameters(m=1.0, l=2, g=np.float64(9.81))
)


def test_a_built_ladder_is_that_of_its_text():
    built, declared = BUILT.model(), liftoff.Model(LADDER)
    assert built.summary == declared.summary and built.defaults == declared.defaults
    assert built.explain() == declared.explain()
    assert np.array_equal(built.simulate().state, declared.simulate().state)


def test_a_declaration_is_not_changed_by_what_goes_on_from_it():
    start = liftoff.Declaration("Ball").particle("P", mass=1).gravity(9.81)
    rough = start.support(P="floor", restitution=0.5)
    assert "support" not in start.text and "#[support(P = floor, restitution = 0.5)]" in rough.text
    assert copy.copy(rough).text == rough.text and pickle.loads(pickle.dumps(rough)).text == rough.text


def test_words_have_what_belongs_to_them():
    text = (
        liftoff.Declaration("S", "One line\nand another.")
        .body("hull", points={"A": (0, 0), "B": ("l", -1.5)}, mass="m")
        .support(A="floor", rough=True)
        .mirror(x=0, swap=["A", "E"])
        .force(P=("f", 0), while_=['"phi > 0"'])
        .liftoff("dimensionless", names=False)
        .run(start={"phi": "80 deg", "psi": 1}, until=["t = 10", 'phi = "x"'], limit=20)
        .parameters("m", l=(200, "mm"), f="pi / 3", lambda_=None)
        .text
    )
    assert text.splitlines() == [
        "/// One line",
        "/// and another.",
        "#[derive(BarSystem)]",
        "#[body(hull, points(A = (0, 0), B = (l, -1.5)), mass = m)]",
        "#[support(A = floor, rough)]",
        "#[mirror(x = 0, swap(A, E))]",
        '#[force(P = (f, 0), while("phi > 0"))]',
        "#[liftoff(dimensionless, names = false)]",
        '#[run(start = "phi = 80 deg, psi = 1", until = "t = 10", until = "phi = \\"x\\"", limit = 20)]',
        "struct S {",
        "    m: f64,",
        '    #[value(200, unit = "mm")]',
        "    l: f64,",
        "    #[value(pi / 3)]",
        "    f: f64,",
        "    lambda: f64,",
        "}",
    ]


def test_mistakes_are_those_of_the_text():
    with pytest.raises(liftoff.DeclarationError, match="no attribute `suport`; did you mean `support`"):
        BUILT.suport(A="floor").model()
    with pytest.raises(TypeError, match="expected a text, a number or a tuple, not None"):
        BUILT.bar("BC", mass=None)
    with pytest.raises(AttributeError):
        BUILT._repr_svg_
