"""Pictures and pages as notebooks show them."""

from __future__ import annotations

import html
import os
from typing import Any

from ._optional import load


class _File(str):
    """The text of a file."""

    __slots__ = ()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the file."""
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(self)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {len(self)} characters>"


class Svg(_File):
    """A picture, as the text of an SVG file."""

    __slots__ = ()

    def _repr_svg_(self) -> str:
        return str(self)


class Page(_File):
    """A page, as the text of an HTML file that needs nothing beside itself."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        # In a frame of its own, which sees nothing of the notebook.
        source = html.escape(self, quote=True)
        style = "width: 100%; height: 42rem; border: 0"
        return f'<iframe sandbox="allow-scripts" style="{style}" srcdoc="{source}"></iframe>'


def frame(columns: dict[str, Any], index: Any, name: str = "t") -> Any:
    """A frame of pandas."""
    pandas = load("pandas", "frames", "pandas")
    return pandas.DataFrame(columns, index=pandas.Index(index, name=name))
