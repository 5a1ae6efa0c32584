"""What pickles are read with."""

from __future__ import annotations

from typing import Any

from ._errors import RunError
from ._liftoff import Model, Trajectory


def trajectory(model: Model, arguments: dict[str, Any]) -> Trajectory:
    """Runs a model once more: the same motion, to the last bit on the same machine."""
    try:
        return model.simulate(**arguments)
    except RunError as error:
        return error.trajectory
