"""What follows from a model: answers of its analyses, keyed by the names of the declaration."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, Optional

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from ._liftoff import Event

_Floats = npt.NDArray[np.float64]
_Complex = npt.NDArray[np.complex128]


@dataclass(frozen=True)
class Mode:
    """A mode of vibration: δq = shape · exp(rate t), the largest coordinate of the shape being 1 in
    natural units."""

    rate: complex
    shape: dict[str, complex]

    @property
    def frequency(self) -> float:
        """The frequency without damping, rad/s."""
        return abs(self.rate)

    @property
    def growth(self) -> float:
        """The rate of growth, 1/s; negative where the mode decays."""
        return self.rate.real

    @property
    def damping_ratio(self) -> float:
        """The damping ratio; 1 or −1 where the mode does not vibrate."""
        return -self.rate.real / abs(self.rate) if self.rate else 0.0


@dataclass(frozen=True, eq=False)
class Linearisation:
    """The motion about a position at rest: ẋ = A x + B Q with x = (ξ, ξ̇), δq = Z ξ and the
    generalised forces Q.

    Rows of Z and columns of B are those of the coordinates. `residual` is the acceleration there in
    natural units: zero at an equilibrium. Modes come with the fastest growing first, then the
    slowest.
    """

    modes: list[Mode]
    A: _Floats
    B: _Floats
    Z: _Floats
    residual: float


@dataclass(frozen=True, eq=False)
class LinearHalves:
    """The motion about a symmetric position: what keeps its symmetry, and what breaks it.

    `growth_ratio` is how many times as fast the antisymmetric motion grows as the symmetric one;
    None where one does not grow.
    """

    symmetric: Linearisation
    antisymmetric: Linearisation
    growth_ratio: Optional[float]


@dataclass(frozen=True)
class LoadLimit:
    """The largest value of a load, or the least where it falls, and what ends the equilibrium
    there."""

    value: float
    end: str


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A position of rest.

    `reactions` and `friction` have the least and the largest force of each support that touches:
    they are equal where it is determined. `joint_forces` has what joints and drives transmit.
    `linear` is the motion nearby, with the supports closed that bear. `limit` is None where no load
    was asked for, or the load may go as far as it was followed.
    """

    closed: list[str]
    stability: Literal["fixed", "stable", "neutral", "unstable"]
    position: dict[str, float]
    reactions: dict[str, tuple[float, float]]
    friction: dict[str, tuple[float, float]]
    joint_forces: dict[str, float]
    linear: Linearisation = field(repr=False)
    limit: Optional[LoadLimit]


@dataclass(frozen=True, eq=False)
class Orbit:
    """A periodic orbit, by its state on the section.

    `shift` is by how much each coordinate has changed after a period, zero where it does not drift.
    `events` are the kinds of the events of a period, each with its supports. `multipliers` come
    with the largest first. `residual` is by how much the state differs from its image, in natural
    units. `special` is what an orbit of a branch is beside: a fold, a branch point, a flip or a
    torus.
    """

    period: float
    stability: Literal["stable", "neutral", "unstable"]
    state: dict[str, float]
    parameters: dict[str, float]
    shift: dict[str, float]
    events: list[tuple[str, list[str]]]
    multipliers: _Complex
    residual: float
    special: Optional[str]


@dataclass(frozen=True, eq=False)
class Branch:
    """Periodic orbits followed in a parameter, and where the branch ends."""

    orbits: list[Orbit]
    end: str


@dataclass(frozen=True, eq=False)
class EventDerivatives:
    """Derivatives at an event: `time["m"]` of its time, None of what only touches,
    `state["phi"]["m"]` of the state after it."""

    event: Event
    time: Optional[dict[str, float]]
    state: dict[str, dict[str, float]]


@dataclass(frozen=True, eq=False)
class Sensitivities:
    """Derivatives of a run: at each of its events, and of the state at its end,
    `end["phi"]["m"]`."""

    events: list[EventDerivatives]
    end: dict[str, dict[str, float]]


@dataclass(frozen=True)
class Estimate:
    """A fitted value with its standard error and its 95 % interval, which need more values than
    variables."""

    value: float
    standard_error: Optional[float]
    interval: Optional[tuple[float, float]]


@dataclass(frozen=True, eq=False)
class Fit:
    """What the data say of the varied names, `estimates["m"].value`.

    `correlations` has a row and a column for each of them. `residuals` are computed less measured
    values, in the order of `data`, and `norm` is that of the residuals in standard deviations.
    `scatter` is by how much they scatter, with `freedom` degrees of freedom. `stopped` is why the
    search has not converged, or None.
    """

    estimates: dict[str, Estimate]
    correlations: _Floats
    data: list[str]
    residuals: _Floats
    norm: float
    freedom: int
    scatter: Optional[float]
    runs: int
    stopped: Optional[str]


@dataclass(frozen=True)
class Optimum:
    """The least or the greatest value of an output, and the values of the varied names with which
    it has it.

    `slopes` are the derivatives of the output there, `at_bounds` the names that are at a bound,
    `first` the output where the search began. `stopped` is why the search has not converged, or
    None.
    """

    value: float
    values: dict[str, float]
    slopes: dict[str, float]
    at_bounds: list[str]
    first: float
    runs: int
    stopped: Optional[str]


@dataclass(frozen=True, eq=False)
class Boundary:
    """A curve in the plane of two varied names, `points["phi"]`, across which what is observed
    changes.

    Along the points `left` is observed to the left, and `right` to the right. `ends` is where it
    ends at the first point and at the last.
    """

    left: str
    right: str
    points: dict[str, _Floats]
    ends: tuple[str, str]
