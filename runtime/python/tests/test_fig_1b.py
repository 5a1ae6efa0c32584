"""The paper's Fig. 1b, each support watched on its own: which opens first, and where; against 25 digits."""

import math

import numpy as np
import pytest

SHARES = [0.10, 0.25, 0.50, 0.75, 0.90]
UPRIGHT = {"phi_inner": math.pi / 2, "phi_outer": math.pi / 2, "y": 0}
LEANING = {"phi_inner": 1.56, "phi_outer": 1.56}


def reference(references, what, share):
    return references[f"strict.{what}[{share:.2f}]"]["value"]


@pytest.mark.parametrize("share", SHARES)
def test_first_openings(zigzag, references, share):
    values = {"m1": 1 - share, "m2": share, "l": 1, "g": 1}
    run = zigzag.simulate(LEANING, set=values, energy_of=UPRIGHT)
    first = run.events[1]
    assert (first.kind, ", ".join(first.names)) == ("open", reference(references, "first", share))
    # Ten times the tolerance of the integration.
    expected = float(reference(references, "phi_first", share))
    assert first["phi_inner"] == pytest.approx(expected, abs=1e-11)
    assert first["phi_outer"] == pytest.approx(expected, abs=1e-11)


def test_a_sweep_has_the_same(zigzag, references):
    table = zigzag.sweep(
        ["first open", "first open phi_inner"],
        vary={"share": SHARES},
        set={"m1": "1 - share", "m2": "share", "l": 1, "g": 1},
        start=LEANING,
        energy_of=UPRIGHT,
    )
    assert table["first open"].tolist() == [reference(references, "first", share) for share in SHARES]
    expected = [float(reference(references, "phi_first", share)) for share in SHARES]
    assert np.allclose(table["first open phi_inner"], expected, rtol=0, atol=1e-11)
