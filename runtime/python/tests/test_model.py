"""What a model tells of itself."""

import json
import math
import pickle
import subprocess

import numpy as np
import pytest

import liftoff
from conftest import LADDER, ONE, PENDULUM, ROOT


def test_names_are_those_of_the_declaration(ladder):
    assert ladder.name == "Ladder"
    assert ladder.summary == "A ladder between a smooth floor and a smooth wall."
    assert (ladder.parameters, ladder.coordinates) == (["m", "l", "g"], ["phi", "x_A", "y_A"])
    assert (ladder.supports, ladder.points) == (["A", "B"], ["A", "B"])
    assert repr(ladder) == "<Model Ladder: parameters m, l, g; coordinates phi, x_A, y_A>"


def test_defaults_ask_for_the_default_run(ladder):
    assert ladder.defaults["set"] == {"m": 1.0, "l": 2.0, "g": 9.81}
    assert (ladder.defaults["start"], ladder.defaults["until"]) == ({"phi": 1.3}, ["phi = 0"])
    assert np.array_equal(ladder.simulate(**ladder.defaults).state, ladder.simulate().state)


def test_a_file_of_several_models_has_to_be_told_which(tmp_path):
    path = tmp_path / "two.rs"
    path.write_text(LADDER + PENDULUM)
    assert liftoff.Model.from_file(path, model="Pendulum").name == "Pendulum"
    assert liftoff.Model.from_file(str(path), "ladder").name == "Ladder"
    both = liftoff.Model.list_file(path)
    assert [(model.name, model.parameters) for model in both] == [("Ladder", ["m", "l", "g"]), ("Pendulum", ["m", "l", "g"])]
    assert both[0].simulate().events[1].kind == "open" and both[1] == liftoff.Model.from_file(path, model="Pendulum")
    with pytest.raises(ValueError, match='several models; choose one: model="Ladder", "Pendulum"'):
        liftoff.Model.from_file(path)
    with pytest.raises(KeyError, match="did you mean `Ladder`"):
        liftoff.Model.from_file(path, model="Lader")


def test_equations_are_those_of_the_command_line(ladder):
    assert "⅓ m l² φ̈ = −½ m g l cos φ" in ladder.explain()
    latex, html = ladder.explain("latex"), ladder.explain(format="html")
    assert latex.startswith("\\documentclass") and "\\ddot{\\varphi}" in latex
    assert html.startswith("<!doctype html>") and isinstance(html, liftoff.Page)
    with pytest.raises(ValueError, match="known: text, latex, html"):
        ladder.explain("pdf")


def test_conditions_are_those_of_the_command_line(ladder):
    told = ladder.conditions("A, B", {"phi": 1.3})
    assert told.startswith("Ladder\n") and "on A, B" in told and "on A\n" in ladder.conditions()
    # sin φ = ⅔ sin φ₀
    assert f"B opens first, at φ = {math.asin(2 / 3 * math.sin(1.3)):.10f}"[:-2] in told
    assert ladder.conditions(format="latex").startswith("\\documentclass")
    assert isinstance(ladder.conditions(format="html"), liftoff.Page)
    with pytest.raises(ValueError, match="known: text, latex, html"):
        ladder.conditions(format="pdf")
    with pytest.raises(ValueError, match="C"):
        ladder.conditions("C")
    with pytest.raises(TypeError, match="did you mean `phase`"):
        ladder.conditions(phas="A")


def test_equations_are_exported(pendulum):
    sources = pendulum.export("c")
    assert any(name.endswith(".h") for name in sources) and any(name.endswith(".c") for name in sources)
    module = {}
    exec(pendulum.export(), module)
    m, l, g, phi = (module[name] for name in ("m", "l", "g", "phi"))
    assert module["mass_matrix"][0, 0] == m * l**2 / 3
    assert module["forces"][0].equals(-m * g * l * module["sin"](phi) / 2)
    with pytest.raises(ValueError, match="known: sympy, c"):
        pendulum.export("fortran")


def test_a_notebook_shows_drawing_and_equations(ladder, pendulum):
    assert ladder._repr_svg_().startswith("<svg")
    assert ladder._repr_latex_().startswith("$$\\begin{aligned}")
    shown = ladder._repr_html_()
    assert "<svg" in shown and "<math" in shown and "<script" not in shown
    # Without values of its parameters there is nothing to draw.
    assert pendulum._repr_svg_() is None and "<math" in pendulum._repr_html_()
    assert pendulum.drawing(set=ONE).startswith("<svg")
    assert pendulum.drawing({"phi": 1}, ONE) != pendulum.drawing({"phi": 2}, ONE)


def test_models_are_equal_where_their_texts_are(ladder):
    assert ladder == liftoff.Model(LADDER) and hash(ladder) == hash(liftoff.Model(LADDER))
    assert ladder != liftoff.Model(PENDULUM) and ladder != "Ladder"


def test_all_models_of_the_gallery_are_read():
    files = [path for path in (ROOT / "models/systems/src").glob("*.rs") if "#[derive(BarSystem" in path.read_text()]
    assert len(files) > 30
    assert all(liftoff.Model.from_file(path).explain() for path in files)


PROGRAM = ROOT / "target/release/liftoff"


@pytest.mark.skipif(not PROGRAM.exists(), reason="the program is not built")
@pytest.mark.parametrize("name", liftoff.Model.list_built_in())
def test_built_in_models_move_as_on_the_command_line(name):
    """Steps differ, as the wheel compiles what runs often: bounds are the spread of events at 1e-12."""
    told = json.loads(subprocess.run([PROGRAM, "run", name, "--json"], check=True, capture_output=True).stdout)
    model = liftoff.Model.built_in(name)
    run = model.simulate()
    assert [(event.kind, event.names) for event in run.events] == [(event["kind"], event["supports"]) for event in told["events"]]
    for event, expected in zip(run.events, told["events"]):
        assert event.t == pytest.approx(expected["t"], rel=1e-9, abs=1e-9)
        assert event.state == pytest.approx(expected["state"], rel=1e-7, abs=1e-7)
    assert model.defaults["set"] == told["parameters"]
    assert pickle.loads(pickle.dumps(model)) == model


def test_built_in_models_are_those_of_the_command_line():
    names = liftoff.Model.list_built_in()
    assert len(names) == len(set(names)) > 40 and {"zigzag", "falling-pair"} <= set(names)
    zigzag = liftoff.Model.built_in("zigzag")
    assert zigzag.name == "Zigzag" and zigzag == liftoff.Model.built_in("Zigzag")
    # A text has what attributes express of a run.
    ladder = liftoff.Model.built_in("ladder")
    assert liftoff.Model(ladder.text).defaults == ladder.defaults
    assert liftoff.Model(zigzag.text).defaults["set"] == zigzag.defaults["set"]
    with pytest.raises(liftoff.UnknownName, match="no model `zigzak`.*did you mean `zigzag`"):
        liftoff.Model.built_in("zigzak")


def test_functions_are_the_equations_of_the_motion(ladder, zigzag):
    functions = zigzag.functions(set={"m1": 0.5, "m2": 0.5, "l": 1, "g": 9.81})
    assert functions.coordinates == zigzag.coordinates
    run = zigzag.simulate({"phi_inner": 1, "phi_outer": 1.2, "y": 1}, set={"m1": 0.5, "m2": 0.5, "l": 1, "g": 9.81}, limit=0.1)
    n, span = 3, 1e-4
    before, now, after = run.at([0.05 - span, 0.05, 0.05 + span])
    q, v, a = now[:n], now[n:], (after[n:] - before[n:]) / (2 * span)
    mass, terms, forces = (f(q, v, 0.05) for f in (functions.mass_matrix, functions.velocity_terms, functions.forces))
    assert mass.shape == (3, 3) and np.array_equal(mass, mass.T)
    assert mass @ a + terms == pytest.approx(forces, abs=1e-6)
    assert ladder.functions().forces([0, 0, 0], [0, 0, 0]) == pytest.approx([-9.81, 0, -9.81])
    with pytest.raises(ValueError, match="parameter `l` is not given"):
        zigzag.functions(set={"m1": 1, "m2": 1})
