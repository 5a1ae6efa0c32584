"""Models and motions in other processes."""

import copy
import multiprocessing
import pickle
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

import liftoff
from conftest import ONE
from test_errors import STALLS

STARTS = [0.6, 0.9, 1.2]


def test_a_model_comes_back_by_its_text(ladder):
    again = pickle.loads(pickle.dumps(ladder))
    assert again == ladder and again.name == ladder.name
    assert copy.deepcopy(ladder) == ladder


def test_a_motion_comes_back_to_the_last_bit(ladder, pendulum):
    for run in (
        ladder.simulate(start={"phi": 1.0}, release={"B": 0.1}, tolerance=1e-9, method="tsit5"),
        pendulum.simulate({"phi": 1}, set=ONE, limit=1, impulses=[("A", (1, 0), 0.5)]),
        ladder.simulate(start={}, energy_of={}, until=[], limit=0.3),
    ):
        again = pickle.loads(pickle.dumps(run))
        assert np.array_equal(again.state, run.state) and np.array_equal(again.t, run.t)
        assert again.events == run.events and again.arguments == run.arguments


def test_a_motion_that_stopped_short_comes_back():
    with pytest.raises(liftoff.RunError) as error:
        liftoff.Model(STALLS).simulate(set={"m": 1, "k": 1}, start={"x": 1}, limit=10)
    run = error.value.trajectory
    again = pickle.loads(pickle.dumps(run))
    assert np.array_equal(again.t, run.t) and again.stopped == run.stopped
    assert str(pickle.loads(pickle.dumps(error.value))) == str(error.value)


def test_errors_events_and_tables_come_back(ladder):
    with pytest.raises(liftoff.DeclarationError) as error:
        liftoff.Model("#[derive(BarSystem)] struct")
    again = pickle.loads(pickle.dumps(error.value))
    assert str(again) == str(error.value) and again.mistakes == error.value.mistakes
    events = ladder.simulate().events
    assert pickle.loads(pickle.dumps(events)) == events
    table = pickle.loads(pickle.dumps(ladder.sweep("end t", start={"phi": STARTS})))
    assert np.array_equal(table["phi"], STARTS)


def end(task):
    model, phi = task
    single = model.simulate({"phi": phi})
    swept = model.sweep("end t", start={"phi": [phi, 1.0]})
    return single.events[-1], float(swept["end t"][0])


@pytest.mark.parametrize("how", ["fork", "spawn"])
def test_processes_run_models(ladder, how):
    # The parent's threads have run before: none of them is in a child.
    ladder.sweep("end t", start={"phi": STARTS})
    context = multiprocessing.get_context(how)
    with ProcessPoolExecutor(2, mp_context=context) as pool:
        ends = list(pool.map(end, [(ladder, phi) for phi in STARTS], timeout=60))
    for phi, (event, swept) in zip(STARTS, ends):
        assert event == ladder.simulate({"phi": phi}).events[-1] and event.t == swept


def test_threads_run_a_model_at_once(ladder):
    with ThreadPoolExecutor(4) as pool:
        runs = list(pool.map(lambda phi: ladder.simulate({"phi": phi}), STARTS * 8))
    for phi, run in zip(STARTS * 8, runs):
        assert np.array_equal(run.state, ladder.simulate({"phi": phi}).state)
