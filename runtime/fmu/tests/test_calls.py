"""Calls in any order and with any values: one line says what is wrong, and nothing else happens."""

import ctypes

import pytest
from fmpy.fmi3 import FMU3Model, FMU3Slave

ERROR = 3


class Told(list):
    """Messages of an instance."""

    def __call__(self, _environment, status, category, message):
        assert status == ERROR and category == b"logStatusError"
        self.append(message.decode())


def instance(unit, of, **options):
    description, told = unit.description, Told()
    kind = description.coSimulation if of is FMU3Slave else description.modelExchange
    made = of(
        guid=options.pop("token", description.guid),
        unzipDirectory=unit.folder,
        modelIdentifier=kind.modelIdentifier,
        instanceName="one",
    )
    made.told, made.unit = told, unit
    made.instantiate(logMessage=told, **options)
    return made


def begun(unit, of=FMU3Slave, start=(), **options):
    made = instance(unit, of, **options)
    for name, value in start:
        made.setFloat64([unit.reference[name]], [value])
    made.enterInitializationMode()
    made.exitInitializationMode()
    return made


def fails(made, call):
    """The one line that a call fails with."""
    with pytest.raises(Exception, match="status 3"):
        call()
    (line,) = made.told
    made.told.clear()
    assert "\n" not in line
    return line


def value(made, name):
    return made.getFloat64([made.unit.reference[name]])[0]


@pytest.mark.parametrize(
    "name, start, line",
    [
        ("bouncing_ball", [("y", -1.0)], "support P is penetrated by 1.000e0"),
        ("fig_1a", [("y", 2.0), ("phi", 0.1)], "support P, Q is penetrated"),
        ("fig_1a", [("m", -1.0)], "mass"),
        ("fig_1a", [("l", 0.0)], "l"),
        ("four_bar", [("phi", 0.0)], "cannot close"),
    ],
)
@pytest.mark.parametrize("of", [FMU3Slave, FMU3Model])
def test_inconsistent_starts(unit, of, name, start, line):
    made = instance(unit(name), of)
    for variable, to in start:
        made.setFloat64([made.unit.reference[variable]], [to])
    made.enterInitializationMode()
    assert line in fails(made, made.exitInitializationMode)
    # Another start, and it goes on.
    made.reset()
    made.enterInitializationMode()
    made.exitInitializationMode()
    made.freeInstance()


def test_values_that_cannot_be_set_or_read(unit):
    made = instance(unit("fig_1a"), FMU3Slave)
    of = made.unit.reference
    assert "`N(P, Q)` cannot be set" in fails(made, lambda: made.setFloat64([of["N(P, Q)"]], [1.0]))
    assert "value reference 1000" in fails(made, lambda: made.setFloat64([1000], [1.0]))
    assert "value reference 1000" in fails(made, lambda: made.getFloat64([1000]))
    assert "cannot be set to NaN" in fails(made, lambda: made.setFloat64([of["phi"]], [float("nan")]))
    assert "cannot be set to inf" in fails(made, lambda: made.setFloat64([of["l"]], [float("inf")]))
    assert "no Float64" in fails(made, lambda: made.getFloat64([of["events"]]))
    assert "another type" in fails(made, lambda: made.getInt32([of["contact(P, Q)"]]))
    assert "no variable has this type" in fails(made, lambda: made.getBoolean([of["events"]]))
    made.enterInitializationMode()
    made.exitInitializationMode()
    assert "after the initialisation" in fails(made, lambda: made.setFloat64([of["l"]], [2.0]))
    made.freeInstance()


def test_units_of_others(unit):
    with pytest.raises(Exception, match="instantiate"):
        instance(unit("fig_1a"), FMU3Slave, token="another")


def test_calls_out_of_order(unit):
    made = instance(unit("fig_1a"), FMU3Slave, eventModeUsed=True, earlyReturnAllowed=True)
    step = lambda length, at=0.0: made.doStep(currentCommunicationPoint=at, communicationStepSize=length)
    assert "step mode" in fails(made, lambda: step(0.1))
    assert "initialization mode" in fails(made, made.exitInitializationMode)
    assert "not for what is instantiated" in fails(made, made.enterEventMode)
    made.enterInitializationMode(stopTime=1.2)
    assert "not for initialization mode" in fails(made, made.enterInitializationMode)
    made.exitInitializationMode()
    assert "not for event mode" in fails(made, lambda: step(0.1))
    made.updateDiscreteStates()
    made.enterStepMode()
    assert "not a finite time > 0" in fails(made, lambda: step(0.0))
    assert "not a finite time > 0" in fails(made, lambda: step(-0.1))
    assert "not a finite time > 0" in fails(made, lambda: step(float("nan")))
    assert "the motion is at t = 0" in fails(made, lambda: step(0.1, at=0.5))
    assert "after the stop time 1.2" in fails(made, lambda: step(1.3))
    step(0.1)
    made.terminate()
    assert "what is terminated" in fails(made, lambda: step(0.1, at=0.1))
    made.freeInstance()


@pytest.mark.parametrize(
    "experiment, line",
    [
        ({"startTime": -1.0}, "start time"),
        ({"startTime": 1.0, "stopTime": 0.5}, "stop time"),
        ({"tolerance": 2.0}, "tolerance"),
    ],
)
def test_experiments_without_sense(unit, experiment, line):
    made = instance(unit("fig_1a"), FMU3Slave)
    assert line in fails(made, lambda: made.enterInitializationMode(**experiment))
    made.freeInstance()


def test_a_step_that_ends_at_an_event_and_one_that_is_huge(unit):
    opens = unit("fig_1a").run(1.2)[1]["t"]
    made = begun(unit("fig_1a"), eventModeUsed=True, earlyReturnAllowed=True)
    made.updateDiscreteStates()
    made.enterStepMode()
    event, ended, early, last = made.doStep(currentCommunicationPoint=0.0, communicationStepSize=opens)
    assert (event, ended, early, last) == (True, False, False, opens)
    assert made.getInt64([made.unit.reference["contact(P, Q)"]])[0] == 1
    made.enterEventMode()
    made.updateDiscreteStates()
    assert made.getInt64([made.unit.reference["contact(P, Q)"]])[0] == 0
    # Nothing more to be handled: nothing changes.
    made.updateDiscreteStates()
    made.enterStepMode()
    event, ended, early, last = made.doStep(currentCommunicationPoint=opens, communicationStepSize=1e3)
    assert not event and not early and abs(last - 1000.0 - opens) < 1e-9
    made.freeInstance()


def test_many_instances_do_not_disturb_one_another(unit):
    alone = begun(unit("bouncing_ball"))
    alone.doStep(currentCommunicationPoint=0.0, communicationStepSize=3.0)
    others = [begun(unit("bouncing_ball"), start=[("y", 1.0 + 0.01 * (k % 2))]) for k in range(60)]
    for part in range(6):
        for one in others:
            one.doStep(currentCommunicationPoint=part / 2, communicationStepSize=0.5)
    heights = [value(one, "y") for one in others]
    assert set(heights[::2]) == {value(alone, "y")} and len(set(heights[1::2])) == 1
    assert heights[1] != heights[0]
    for one in [alone, *others]:
        one.freeInstance()


def test_reset_begins_anew(unit):
    made = begun(unit("bouncing_ball"), start=[("e", 0.2), ("y", 2.0)])
    made.doStep(currentCommunicationPoint=0.0, communicationStepSize=1.0)
    changed = value(made, "y")
    made.reset()
    assert value(made, "e") == 0.8 and value(made, "y") == 1.0
    made.enterInitializationMode()
    made.exitInitializationMode()
    made.doStep(currentCommunicationPoint=0.0, communicationStepSize=1.0)
    fresh = begun(unit("bouncing_ball"))
    fresh.doStep(currentCommunicationPoint=0.0, communicationStepSize=1.0)
    assert value(made, "y") == value(fresh, "y") != changed
    made.freeInstance()
    fresh.freeInstance()


def test_what_the_phase_does_not_keep_is_not_believed(unit):
    """An importer's error off the contacts changes neither derivatives nor indicators."""
    made = begun(unit("fig_1a"), FMU3Model)
    made.updateDiscreteStates()
    made.enterContinuousTimeMode()
    n = 4
    states, derivatives = (ctypes.c_double * n)(), [(ctypes.c_double * n)() for _ in range(2)]
    made.getContinuousStates(states, n)
    made.getContinuousStateDerivatives(derivatives[0], n)
    states[1] += 1e-3
    states[3] += 1e-3
    made.setContinuousStates(states, n)
    made.getContinuousStateDerivatives(derivatives[1], n)
    assert list(derivatives[0]) == list(derivatives[1])
    made.freeInstance()
