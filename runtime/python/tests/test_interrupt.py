"""Nothing holds the interpreter while a model runs, and Ctrl-C stops it."""

import _thread
import signal
import threading
import time

import numpy as np
import pytest

from conftest import ONE


@pytest.fixture(autouse=True)
def heeds_ctrl_c():
    """What a shell runs in the background begins with Ctrl-C ignored, and Python leaves that so."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def interrupted(work):
    """How long it takes until what another thread tells has stopped a work."""
    told = []

    def tell():
        told.append(time.monotonic())
        _thread.interrupt_main()

    timer = threading.Timer(0.3, tell)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        work()
    stopped = time.monotonic()
    timer.join()
    return stopped - told[0]


def test_a_long_run_stops_on_ctrl_c(pendulum):
    assert interrupted(lambda: pendulum.simulate({"phi": 1}, set=ONE, limit=1e6)) < 5


def test_a_long_sweep_stops_on_ctrl_c(pendulum):
    starts = np.linspace(0.5, 1, 1_000_000)
    assert interrupted(lambda: pendulum.sweep("end t", start={"phi": starts}, set=ONE, limit=10)) < 5
    # And the next one runs.
    assert pendulum.sweep("end t", start={"phi": [1]}, set=ONE, limit=1)["end t"].tolist() == [1]


@pytest.mark.parametrize("ask", ["orbit", "sensitivity", "fit", "optimise"])
def test_a_long_search_stops_on_ctrl_c(pendulum, ask):
    arguments = {
        "orbit": {"section": "phi > 10"},
        "sensitivity": {},
        "fit": {"vary": "g", "events": {"first stop": 1}},
        "optimise": {"of": "end phi", "vary": "g"},
    }
    search = getattr(pendulum, ask)
    assert interrupted(lambda: search(start={"phi": 1}, set=ONE, limit=1e6, **arguments[ask])) < 5
