"""Planar bar systems with one-sided supports, simulated with located contact events.

>>> import liftoff
>>> model = liftoff.Model(text)  # a declaration as in Rust; or Model.from_file("ladder.rs")
>>> run = model.simulate(start={"phi": 0.1}, until="phi = pi/2", set={"m": 1, "l": 1, "g": 9.81})
>>> run.events, run.t, run["phi"], run.output("N(P)", 0.2)
>>> model.equilibrium(), model.linearise(), model.orbit("impact"), model.sensitivity("m")
>>> model.sweep("first open phi", start={"phi": [0.1, 0.2, 0.3]})["first open phi"]
"""

from ._analyses import (
    Boundary,
    Branch,
    Equilibrium,
    Estimate,
    EventDerivatives,
    Fit,
    LinearHalves,
    Linearisation,
    LoadLimit,
    Mode,
    Optimum,
    Orbit,
    Sensitivities,
)
from ._declaration import Declaration
from ._errors import AnalysisError, DeclarationError, Error, RunError, UnknownName
from ._functions import Functions
from ._liftoff import Event, Model, Trajectory, __version__
from ._show import Page, Svg
from ._table import Table

__all__ = [
    "AnalysisError",
    "Boundary",
    "Branch",
    "Declaration",
    "DeclarationError",
    "Equilibrium",
    "Error",
    "Estimate",
    "Event",
    "EventDerivatives",
    "Fit",
    "Functions",
    "LinearHalves",
    "Linearisation",
    "LoadLimit",
    "Mode",
    "Model",
    "Optimum",
    "Orbit",
    "Page",
    "RunError",
    "Sensitivities",
    "Svg",
    "Table",
    "Trajectory",
    "UnknownName",
    "__version__",
]
