"""The equations of motion as functions of numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from ._optional import load

_Function = Callable[..., npt.NDArray[np.float64]]


@dataclass(frozen=True)
class Functions:
    """M(q) a + h(q, v) = Q(q, v, t) of the motion without contacts, each a function `f(q, v, t=0)`
    of coordinates and rates.

    `coordinates` has the names of the entries of q.
    """

    coordinates: list[str]
    mass_matrix: _Function
    velocity_terms: _Function
    forces: _Function


def compiled(source: str, coordinates: list[str], parameters: Sequence[float]) -> Functions:
    """The functions of a module that `export` has written, at these values of its parameters."""
    sympy = load("sympy", "functions", "SymPy")
    n = len(coordinates)
    module: dict[str, Any] = {"__name__": "equations"}
    exec(source, module)
    values = dict(zip(module["parameters"], parameters))
    state = [*module["coordinates"], *module["rates"], module["t"]]

    def function(name: str, shape: tuple[int, ...]) -> _Function:
        entries = [entry.subs(values) for entry in module[name]]
        strangers = {str(symbol) for entry in entries for symbol in entry.free_symbols - set(state)}
        if strangers:
            raise ValueError(f"{name}: depends on {', '.join(sorted(strangers))}, which no position and no time determines")
        evaluate = sympy.lambdify([state], entries, modules="numpy", cse=True)

        def numbers(q: npt.ArrayLike, v: npt.ArrayLike, t: float = 0.0) -> npt.NDArray[np.float64]:
            for letter, given in (("q", q), ("v", v)):
                if np.size(given) != n:
                    raise ValueError(f"{letter}: expected a number for each of {', '.join(coordinates)}, not {np.size(given)}")
            return np.array(evaluate([*np.ravel(q), *np.ravel(v), t]), dtype=float).reshape(shape)

        numbers.__name__ = name
        return numbers

    return Functions(coordinates, function("mass_matrix", (n, n)), function("velocity_terms", (n,)), function("forces", (n,)))
