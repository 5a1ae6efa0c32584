"""Packages that only some of this one needs."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def load(module: str, what: str, package: str) -> Any:
    """A module, or which package to install for it."""
    try:
        return import_module(module)
    except ImportError as error:
        name = module.split(".")[0]
        raise ImportError(f"{what} need {package}: pip install {name}") from error
