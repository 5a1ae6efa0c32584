"""What was computed on axes of Matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Optional, cast

import numpy as np

from ._optional import load

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._liftoff import Trajectory
    from ._table import Table

# Parts of an axis that lie between the words of two events at least.
_WORDS = 40


def motion(
    run: Trajectory, outputs: Sequence[str], against: str, ax: Optional[Axes], style: Optional[dict[str, Any]]
) -> Axes:
    """Outputs of a motion, with its events."""
    outputs = list(outputs) or run.model.coordinates
    axis, curves, events = run._chart_numbers(outputs, against)
    ax = _axes(ax)
    units = {unit for _, unit, _, _ in curves}
    for name, unit, x, y in curves:
        ax.plot(x, y, **{"label": _named(name, unit if len(units) > 1 else ""), **(style or {})})
    _tell_names(ax, axis, _named(", ".join(name for name, *_ in curves), units.pop() if len(units) == 1 else ""))
    if against.strip() == "t":
        _mark_times(ax, events)
    else:
        for words, times in events:
            places = [run.output(output, times) for output in (against, outputs[0])]
            ax.plot(*places, "o", color="0.3", markersize=4)
            ax.annotate(words, (places[0][0], places[1][0]), (4, 4), textcoords="offset points", fontsize="small", color="0.3")
    return ax


def sweep(table: Table, output: str, against: Optional[str], ax: Optional[Axes], style: dict[str, Any]) -> Axes:
    """A column of a table over one of its inputs, with a line for each value of the others."""
    inputs = list(table.inputs)
    if against is None:
        if len(inputs) > 1:
            raise ValueError(f"against: which of {', '.join(inputs)} is along the axis?")
        against = inputs[0]
    x, y = table[against], table[output]
    for name, values in ((against, x), (output, y)):
        if values.dtype == object:
            raise ValueError(f"{name}: these are names, not numbers: they cannot be drawn as a line")
    # The axis of the arrays along which x varies comes first; each column is a line then.
    along = next((k for k in range(x.ndim) if np.any(np.diff(x, axis=k))), 0)
    columns = {name: np.moveaxis(table[name], along, 0).reshape(x.shape[along], -1) for name in {*inputs, output}}
    ax = _axes(ax)
    for k in range(columns[output].shape[1]):
        first = {name: columns[name][0, k] for name in inputs if name != against}
        differ = [f"{name} = {value:g}" for name, value in first.items() if np.any(columns[name][0] != value)]
        ax.plot(columns[against][:, k], columns[output][:, k], **{"label": ", ".join(differ) or output, **style})
    _tell_names(ax, against, output)
    return ax


def _axes(ax: Optional[Axes]) -> Axes:
    if ax is None:
        return cast("Axes", load("matplotlib.pyplot", "plots", "Matplotlib").figure().add_subplot())
    if not hasattr(ax, "annotate"):
        raise TypeError(f"ax: expected axes of Matplotlib, `pyplot.subplots()[1]`, not {ax!r}")
    return ax


def _named(name: str, unit: str) -> str:
    return f"{name}, {unit}" if unit else name


def _tell_names(ax: Axes, x: str, y: str) -> None:
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if len(ax.get_legend_handles_labels()[1]) > 1:
        ax.legend()


def _mark_times(ax: Axes, events: Sequence[tuple[str, Sequence[float]]]) -> None:
    room = float(np.ptp(ax.get_xlim())) / _WORDS
    free = -np.inf
    for words, times in events:
        for t in times:
            ax.axvline(t, color="0.6", linewidth=0.8, zorder=0)
        if times[0] >= free:
            ax.annotate(
                words, (times[0], 1), (2, -3), xycoords=ax.get_xaxis_transform(), textcoords="offset points",
                rotation=90, va="top", fontsize="small", color="0.3",
            )
            free = times[0] + room
