"""Units simulated by FMPy, beside runs of the program: co-simulation is that run, model exchange comes near it."""

import numpy
import pytest
from fmpy.validation import validate_fmu

# Lift-off, impacts, friction that sticks and slips, guides with friction, a smooth motion, one that is driven: each until when.
MODELS = [
    ("fig_1a", 1.2),
    ("bouncing_ball", 2.0),
    ("belt", 5.0),
    ("guided_ladder", 3.0),
    ("double_pendulum", 3.0),
    ("four_bar", 2.0),
]


def at_events(rows):
    """The rows after each event."""
    return [rows[i] for i in range(1, len(rows)) if rows["events"][i] > rows["events"][i - 1]]


@pytest.mark.parametrize("name", [name for name, _ in MODELS])
def test_descriptions_are_valid(unit, name):
    assert validate_fmu(str(unit(name).archive)) == []


@pytest.mark.parametrize("parts", [1, 7, 100])
@pytest.mark.parametrize("name, stop", MODELS)
def test_co_simulation_has_the_events_of_the_engine(unit, name, stop, parts):
    *events, end = unit(name).run(stop)[1:]
    rows = unit(name).simulate("CoSimulation", stop, parts)
    met = at_events(rows)
    assert [row["time"] for row in met] == [event["t"] for event in events]
    for row, event in zip([*met, rows[-1]], [*events, end]):
        for coordinate, value in event["state"].items():
            # What is printed of an event is rounded to zero, and has not been in the phase after it yet.
            assert abs(row[coordinate] - value) <= 1e-14 * max(1.0, abs(value))


@pytest.mark.parametrize("name, stop", MODELS)
def test_co_simulation_is_the_run_of_the_engine_bit_by_bit(unit, name, stop):
    outputs = [output for output in unit(name).outputs if not output.startswith(("contact", "events"))]
    samples = unit(name).samples(stop, stop / 64, outputs)
    rows = unit(name).simulate("CoSimulation", stop, 64)
    compared = 0
    for row in rows[rows["time"] < stop]:
        sample = samples.get(row["time"])
        for output in outputs if sample else []:
            # Zero is printed in place of what rounding makes of it.
            assert row[output] == sample[output] or sample[output] == 0.0 and abs(row[output]) < 1e-12, output
        compared += sample is not None
    assert compared >= 48


@pytest.mark.parametrize("name, stop", MODELS)
def test_without_event_mode_steps_pass_events(unit, name, stop):
    rows = unit(name).simulate("CoSimulation", stop, 7, use_event_mode=False, early_return_allowed=False)
    assert len(rows) == 8
    events = unit(name).simulate("CoSimulation", stop, 7)
    assert all(rows[-1][name] == events[-1][name] for name in rows.dtype.names)


# Local errors of 1e-9 in each of some hundred steps of CVode add up to some 1e-7, which the double pendulum, whose errors grow by
# e^(3 t) or so, makes 7e-6 at its end. Events are those of the others: they come to 6e-9 s.
NEAR, SOON = 1e-5, 1e-7


@pytest.mark.parametrize("parts", [7, 100])
@pytest.mark.parametrize("name, stop", MODELS)
def test_model_exchange_comes_near_the_run(unit, name, stop, parts):
    *events, end = unit(name).run(stop)[1:]
    rows = unit(name).simulate("ModelExchange", stop, parts, relative_tolerance=1e-9)
    met = at_events(rows)
    assert len(met) == len(events)
    for row, event in zip([*met, rows[-1]], [*events, end]):
        assert abs(row["time"] - event["t"]) <= SOON
        for coordinate, value in event["state"].items():
            assert abs(row[coordinate] - value) <= NEAR * max(1.0, abs(value)), coordinate


@pytest.mark.parametrize("tolerance, bound", [(1e-6, 3e-3), (1e-8, 3e-5), (1e-10, 3e-7)])
def test_model_exchange_gets_nearer_with_the_importers_tolerance(unit, tolerance, bound):
    opens, end = unit("fig_1a").run(1.2)[1:]
    rows = unit("fig_1a").simulate("ModelExchange", 1.2, 7, relative_tolerance=tolerance)
    (row,) = at_events(rows)
    assert abs(row["time"] - opens["t"]) <= bound
    assert abs(rows[-1]["phi"] - end["state"]["phi"]) <= bound


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_a_ball_comes_to_rest_after_infinitely_many_impacts(unit, kind):
    rows = unit("bouncing_ball").simulate(kind, 5.0, 50, record_events=True)
    # It rests at (1 + e)/(1 − e) √(2h/g) = 4.0637 s.
    rests = rows[rows["time"] > 4.1]
    assert set(rests["contact(P)"]) == {1} and numpy.abs(rests["y"]).max() == numpy.abs(rests["y'"]).max() == 0.0
    assert numpy.abs(rests["N(P)"] - 9.81).max() < 1e-12 * 9.81
    flies = rows[rows["time"] < 4.0]
    assert set(flies["contact(P)"]) == {0} and 10 < rows["events"][-1] < 200


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_what_is_set_holds(unit, kind):
    options = ["--set", "l=2", "--start", "phi=0.2"]
    opens, end = unit("fig_1a").run(1.2, *options)[1:]
    rows = unit("fig_1a").simulate(kind, 1.2, 7, start_values={"l": 2.0, "phi": 0.2})
    bound = 0.0 if kind == "CoSimulation" else NEAR
    assert abs(at_events(rows)[0]["time"] - opens["t"]) <= bound
    assert abs(rows[-1]["phi"] - end["state"]["phi"]) <= bound
    # The height of the hinge follows from the corners, though its start value stands in the description.
    assert abs(rows[0]["y"] - numpy.tan(0.2)) < 1e-12 and rows[0]["contact(P, Q)"] == 1


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("name, still", [("double_pendulum", {"phi": 0.0, "psi": 0.0}), ("bouncing_ball", {"y": 0.0})])
def test_what_rests_may_start(unit, kind, name, still):
    rows = unit(name).simulate(kind, 1.0, 4, start_values=still)
    assert rows[-1]["time"] == 1.0 and rows[-1]["events"] == 0 and rows[-1]["T"] == 0.0
    assert all(rows[-1][coordinate] == value for coordinate, value in still.items())


def test_contacts_stick_and_slide(unit):
    rows = unit("belt").simulate("CoSimulation", 5.0, 500)
    named = {2: "sticking", 3: "sliding forward", 4: "sliding backward"}
    assert set(named) >= set(rows["contact(P)"]) > {2}
    sticks = rows[rows["contact(P)"] == 2]
    assert numpy.abs(sticks["v(P)"]).max() < 1e-12
    slides = rows[rows["contact(P)"] != 2]
    ratio = numpy.abs(slides["R(P)"]) / slides["N(P)"]
    assert numpy.abs(ratio - 0.2).max() < 1e-12


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_a_motion_of_the_time_starts_when_it_is_asked_to(unit, kind):
    whole = unit("four_bar").simulate("CoSimulation", 2.0, 4)[-1]
    rows = unit("four_bar").simulate(kind, 2.0, 4, start_time=1.0)
    assert rows[0]["time"] == 1.0
    # The crank turns at 2 rad/s from a right angle.
    assert abs(rows[0]["phi"] - (2.0 + numpy.pi / 2)) < 1e-12 and abs(rows[0]["phi'"] - 2.0) < 1e-12
    bound = 1e-11 if kind == "CoSimulation" else NEAR
    for output in ["phi", "phi'", "E"]:
        assert abs(rows[-1][output] - whole[output]) < bound * max(1.0, abs(whole[output]))


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_a_motion_that_does_not_depend_on_time_is_the_same_later(unit, kind):
    early = unit("fig_1a").simulate(kind, 1.2, 4)[-1]
    late = unit("fig_1a").simulate(kind, 6.2, 4, start_time=5.0)[-1]
    assert late["time"] == 6.2 and late["events"] == early["events"] == 1
    assert abs(late["phi"] - early["phi"]) < (1e-11 if kind == "CoSimulation" else NEAR)
