"""What came of a sweep."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
import numpy.typing as npt

from ._errors import UnknownName
from ._plot import sweep
from ._show import frame

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Table:
    """What was observed of the runs of a sweep: `table["first open phi"]` is an array of the shape
    of the arrays varied.

    Numbers are NaN, and names None, where a run has failed; numbers are NaN too where there was no
    such event. `inputs` has the arrays that were varied, `failed` why which runs have failed, by
    their places in the flattened arrays, and `seconds` how long the runs took.
    """

    def __init__(
        self,
        model: str,
        shape: tuple[int, ...],
        inputs: dict[str, npt.NDArray[Any]],
        observed: dict[str, npt.NDArray[Any]],
        failed: dict[int, str],
        seconds: float,
    ) -> None:
        self.model = model
        self.shape: tuple[int, ...] = tuple(shape)
        self.inputs = inputs
        self.observed = observed
        self.failed = failed
        self.seconds = seconds

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        for columns in (self.observed, self.inputs):
            if name in columns:
                return columns[name]
        raise UnknownName(f"no column `{name}`; known: {', '.join(self.keys())}")

    def __contains__(self, name: object) -> bool:
        return name in self.observed or name in self.inputs

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return int(np.prod(self.shape))

    def keys(self) -> list[str]:
        """Names of what was varied and of what was observed."""
        return [*self.inputs, *self.observed]

    def to_frame(self) -> Any:
        """A frame of pandas with a row for each run."""
        columns = {name: np.ravel(self[name]) for name in self.keys()}
        return frame(columns, range(len(self)), "run")

    def plot(self, output: str, against: Optional[str] = None, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws a column over an input on axes of Matplotlib, `ax` or new ones, which are returned.

        Each value of the other inputs has a line; without `against` there is one input.
        All other arguments are those of `Axes.plot`.
        """
        return sweep(self, output, against, ax, style)

    def __repr__(self) -> str:
        failed = f", {len(self.failed)} failed" if self.failed else ""
        return f"<Table of {self.model}: {len(self)} runs{failed}; {', '.join(self.keys())}>"
