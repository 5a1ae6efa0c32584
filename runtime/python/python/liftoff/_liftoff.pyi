from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any, Literal, Optional, Union, final, overload

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes

from ._analyses import (
    Boundary,
    Branch,
    Equilibrium,
    Fit,
    LinearHalves,
    Linearisation,
    Optimum,
    Orbit,
    Sensitivities,
)
from ._functions import Functions
from ._show import Page, Svg
from ._table import Table

__version__: str
_processor_features: list[str]

_Number = Union[float, str]
_Numbers = Mapping[str, _Number]
_Arrays = Mapping[str, npt.ArrayLike]
_Texts = Union[str, Sequence[str]]
_Impulses = Sequence[tuple[str, tuple[float, float], float]]
_Floats = npt.NDArray[np.float64]
_Method = Literal["auto", "tsit5", "dop853", "taylor", "radau", "gauss"]

@final
class Event:
    """Something that happened in a motion: `event.kind` to `event.names` at `event.t`, with the state
    and the reactions after it.

    `event["phi'"]` is a coordinate, a rate or the time `t`.
    """

    @property
    def t(self) -> float: ...
    @property
    def kind(self) -> str: ...
    @property
    def names(self) -> list[str]: ...
    @property
    def note(self) -> Optional[str]: ...
    @property
    def text(self) -> str: ...
    @property
    def state(self) -> dict[str, float]: ...
    @property
    def before(self) -> Optional[dict[str, float]]: ...
    @property
    def energy(self) -> dict[str, float]: ...
    @property
    def reactions(self) -> dict[str, float]: ...
    @property
    def friction(self) -> dict[str, float]: ...
    @property
    def impulses(self) -> dict[str, float]: ...
    @property
    def joint_impulses(self) -> dict[str, float]: ...
    def __contains__(self, name: str, /) -> bool: ...
    def __getitem__(self, name: str, /) -> float: ...

@final
class Model:
    """A planar bar system, declared as in Rust: `Model(text)`, `Model.from_file(path)`, or
    `Model.built_in(name)`.

    The text is that of a Rust file with a struct that derives `BarSystem`; where it has several,
    `model` names one.
    Mistakes in it are raised as `DeclarationError`, with the place of each.
    """

    def __new__(cls, text: str, model: Optional[str] = None) -> Model: ...
    @classmethod
    def from_file(cls, path: Union[str, PathLike[str]], model: Optional[str] = None) -> Model: ...
    @classmethod
    def list_file(cls, path: Union[str, PathLike[str]]) -> list[Model]: ...
    @classmethod
    def built_in(cls, name: str) -> Model: ...
    @classmethod
    def list_built_in(cls) -> list[str]: ...
    @property
    def text(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def summary(self) -> str: ...
    @property
    def parameters(self) -> list[str]: ...
    @property
    def coordinates(self) -> list[str]: ...
    @property
    def supports(self) -> list[str]: ...
    @property
    def points(self) -> list[str]: ...
    @property
    def defaults(self) -> dict[str, Any]: ...
    def simulate(
        self,
        start: Optional[_Numbers] = None,
        until: Optional[_Texts] = None,
        *,
        set: Optional[_Numbers] = None,
        energy_of: Optional[_Numbers] = None,
        hold: Optional[_Texts] = None,
        release: Optional[_Numbers] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        method: Optional[_Method] = None,
    ) -> Trajectory: ...
    def sweep(
        self,
        observe: _Texts,
        *,
        vary: Optional[_Arrays] = None,
        start: Optional[_Arrays] = None,
        set: Optional[_Arrays] = None,
        energy_of: Optional[_Arrays] = None,
        release: Optional[_Arrays] = None,
        until: Optional[_Texts] = None,
        hold: Optional[_Texts] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        threads: Optional[int] = None,
    ) -> Table: ...
    def boundary(
        self,
        vary: Mapping[str, Union[tuple[_Number, _Number], tuple[_Number, _Number, int]]],
        *,
        observe: str = "first open",
        start: Optional[_Numbers] = None,
        set: Optional[_Numbers] = None,
        energy_of: Optional[_Numbers] = None,
        release: Optional[_Numbers] = None,
        accuracy: _Number = 1e-10,
        until: Optional[_Texts] = None,
        hold: Optional[_Texts] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        threads: Optional[int] = None,
    ) -> list[Boundary]: ...
    def equilibrium(
        self,
        start: Optional[_Numbers] = None,
        *,
        set: Optional[_Numbers] = None,
        load: Union[None, str, _Numbers] = None,
    ) -> list[Equilibrium]: ...
    @overload
    def linearise(
        self,
        start: Optional[_Numbers] = None,
        *,
        set: Optional[_Numbers] = None,
        closed: Optional[_Texts] = None,
        unfold: Literal[False] = False,
    ) -> Linearisation: ...
    @overload
    def linearise(
        self,
        start: Optional[_Numbers] = None,
        *,
        set: Optional[_Numbers] = None,
        closed: Optional[_Texts] = None,
        unfold: Literal[True],
    ) -> LinearHalves: ...
    @overload
    def orbit(
        self,
        section: str,
        start: Optional[_Numbers] = None,
        *,
        drift: Optional[_Texts] = None,
        continue_to: None = None,
        set: Optional[_Numbers] = None,
        until: Optional[_Texts] = None,
        energy_of: Optional[_Numbers] = None,
        hold: Optional[_Texts] = None,
        release: Optional[_Numbers] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        method: Optional[_Method] = None,
    ) -> Orbit: ...
    @overload
    def orbit(
        self,
        section: str,
        start: Optional[_Numbers] = None,
        *,
        drift: Optional[_Texts] = None,
        continue_to: _Numbers,
        set: Optional[_Numbers] = None,
        until: Optional[_Texts] = None,
        energy_of: Optional[_Numbers] = None,
        hold: Optional[_Texts] = None,
        release: Optional[_Numbers] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        method: Optional[_Method] = None,
    ) -> Branch: ...
    def sensitivity(
        self,
        of: Optional[_Texts] = None,
        start: Optional[_Numbers] = None,
        *,
        set: Optional[_Numbers] = None,
        until: Optional[_Texts] = None,
        energy_of: Optional[_Numbers] = None,
        hold: Optional[_Texts] = None,
        release: Optional[_Numbers] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        method: Optional[_Method] = None,
    ) -> Sensitivities: ...
    def fit(
        self,
        vary: _Texts,
        start: Optional[_Numbers] = None,
        *,
        data: Any = None,
        of: Optional[_Texts] = None,
        sd: Optional[_Numbers] = None,
        events: Optional[Mapping[str, Union[_Number, tuple[_Number, _Number]]]] = None,
        set: Optional[_Numbers] = None,
        until: Optional[_Texts] = None,
        energy_of: Optional[_Numbers] = None,
        hold: Optional[_Texts] = None,
        release: Optional[_Numbers] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        method: Optional[_Method] = None,
    ) -> Fit: ...
    def optimise(
        self,
        of: str,
        vary: Union[_Texts, Mapping[str, Optional[tuple[_Number, _Number]]]],
        start: Optional[_Numbers] = None,
        *,
        greatest: bool = False,
        set: Optional[_Numbers] = None,
        until: Optional[_Texts] = None,
        energy_of: Optional[_Numbers] = None,
        hold: Optional[_Texts] = None,
        release: Optional[_Numbers] = None,
        cut: Optional[Mapping[str, str]] = None,
        impulses: Optional[_Impulses] = None,
        stop_at_impacts: Optional[bool] = None,
        limit: Optional[_Number] = None,
        tolerance: Optional[_Number] = None,
        method: Optional[_Method] = None,
    ) -> Optimum: ...
    @overload
    def explain(self, format: Literal["text", "latex"] = "text") -> str: ...
    @overload
    def explain(self, format: Literal["html"]) -> Page: ...
    @overload
    def conditions(
        self,
        phase: Optional[str] = None,
        start: Optional[_Numbers] = None,
        *,
        set: Optional[_Numbers] = None,
        format: Literal["text", "latex"] = "text",
    ) -> str: ...
    @overload
    def conditions(
        self,
        phase: Optional[str] = None,
        start: Optional[_Numbers] = None,
        *,
        set: Optional[_Numbers] = None,
        format: Literal["html"],
    ) -> Page: ...
    @overload
    def export(self, target: Literal["sympy"] = "sympy") -> str: ...
    @overload
    def export(self, target: Literal["c"]) -> dict[str, str]: ...
    def functions(self, set: Optional[_Numbers] = None) -> Functions: ...
    def drawing(self, start: Optional[_Numbers] = None, set: Optional[_Numbers] = None) -> Svg: ...
    def _repr_svg_(self) -> Optional[str]: ...
    def _repr_latex_(self) -> str: ...
    def _repr_html_(self) -> str: ...

@final
class Trajectory:
    """A motion from its start to the event that ended it.

    `trajectory["phi"]` and `trajectory["N(A)"]` are arrays over the times `trajectory.t`, the ends
    of the steps of the integration; `trajectory.output("N(A)", t)` has the values at any times. At
    an event they are those after it. Times of impacts and impulses stand twice in `trajectory.t`,
    and so do the rows of the arrays: before, then after.
    """

    @property
    def model(self) -> Model: ...
    @property
    def events(self) -> list[Event]: ...
    @property
    def t(self) -> _Floats: ...
    @property
    def state(self) -> _Floats: ...
    @property
    def names(self) -> list[str]: ...
    @property
    def stopped(self) -> Optional[str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def arguments(self) -> dict[str, Any]: ...
    def __contains__(self, name: str, /) -> bool: ...
    def __getitem__(self, output: str, /) -> _Floats: ...
    @overload
    def output(self, output: str, t: float) -> float: ...
    @overload
    def output(self, output: str, t: Optional[npt.ArrayLike] = None) -> _Floats: ...
    def at(self, t: Union[float, Sequence[float], npt.NDArray[Any]]) -> _Floats: ...
    def extrema(self, output: str) -> list[tuple[float, float, bool]]: ...
    def to_frame(
        self,
        *outputs: str,
        t: Optional[npt.ArrayLike] = None,
        every: Optional[_Number] = None,
    ) -> Any: ...
    def chart(self, *outputs: str, against: str = "t") -> Svg: ...
    def plot(self, *outputs: str, against: str = "t", ax: Optional[Axes] = None, **style: Any) -> Axes: ...
    def _chart_numbers(
        self, outputs: Sequence[str], against: str
    ) -> tuple[str, list[tuple[str, str, _Floats, _Floats]], list[tuple[str, list[float]]]]: ...
    def page(self, *outputs: str) -> Page: ...
    def _repr_html_(self) -> str: ...
    def _repr_svg_(self) -> str: ...
