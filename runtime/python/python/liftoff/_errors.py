"""What goes wrong, as exceptions."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._liftoff import Trajectory


class Error(Exception):
    """What this package raises beside ValueError and TypeError."""


class DeclarationError(Error, ValueError):
    """Mistakes in a declaration, rendered as the compiler does.

    `mistakes` has a tuple (message, start, end) for each: it is about `text[start:end]`.
    """

    def __init__(self, report: str, mistakes: list[tuple[str, int, int]] | None = None) -> None:
        super().__init__(report, mistakes or [])
        self.mistakes: list[tuple[str, int, int]] = mistakes or []

    def __str__(self) -> str:
        return str(self.args[0])


class RunError(Error, RuntimeError):
    """A run that stopped short; `trajectory` is the motion up to there."""

    trajectory: Trajectory


class AnalysisError(Error, RuntimeError):
    """An analysis that gives nothing."""


class UnknownName(Error, KeyError, ValueError):
    """A name that the model does not have, with the nearest that it has."""

    def __str__(self) -> str:
        return str(self.args[0])
