"""Declarations that are put together call by call."""

from __future__ import annotations

import keyword
from collections.abc import Iterable, Mapping
from numbers import Integral, Real
from typing import Any, Callable, Optional, Union

from ._liftoff import Model

_Value = Union[str, float, tuple[Any, ...], list[Any], Mapping[str, Any]]


class Declaration:
    """A planar bar system, attribute by attribute: each method has the name of an attribute and
    returns a longer declaration.

    >>> frame = Declaration("Ladder").gravity("g").bar("AB", mass="m", length="l")
    >>> frame = frame.support(A="floor", friction="mu").support(B="wall(0)", facing="right")

    Arguments are written as they are: texts are expressions, tuples are in parentheses. A dict or a
    list is what belongs to a word, `points={"A": (0, 0)}`, `swap=["A", "E"]`; True is the word
    alone, `rough=True`. A name that Python has for itself ends with an underscore, `from_="right"`.
    """

    def __init__(self, name: str, summary: str = "") -> None:
        if not name.isidentifier():
            raise ValueError(f"`{name}` is no name of a model: letters and digits, as `MyLadder`")
        self._name = name
        self._summary = summary
        self._attributes: tuple[str, ...] = ()
        self._fields: tuple[str, ...] = ()

    def __getattr__(self, attribute: str) -> Callable[..., Declaration]:
        if attribute.startswith("_"):
            raise AttributeError(attribute)

        def add(*words: _Value, **entries: _Value) -> Declaration:
            return self._with(_call(_plain(attribute), _items(words, entries)))

        return add

    def run(
        self,
        start: Optional[Mapping[str, Union[str, float]]] = None,
        until: Union[None, str, Iterable[str]] = None,
        limit: Optional[float] = None,
    ) -> Declaration:
        """The default run."""
        entries = []
        if start:
            entries.append(f"start = {_quoted(', '.join(f'{name} = {_text(value)}' for name, value in start.items()))}")
        for condition in [until] if isinstance(until, str) else until or ():
            entries.append(f"until = {_quoted(condition)}")
        if limit is not None:
            entries.append(f"limit = {_text(limit)}")
        return self._with(_call("run", entries))

    def parameters(self, *names: str, **values: Union[None, str, float, tuple[float, str]]) -> Declaration:
        """Parameters without and with default values: numbers, expressions, or numbers with units,
        `(200, "mm")`."""
        longer = self._with()
        fields = [(name, None) for name in names] + [(_plain(name), value) for name, value in values.items()]
        longer._fields = (*self._fields, *(_field(name, value) for name, value in fields))
        return longer

    @property
    def text(self) -> str:
        """The declaration as in Rust."""
        summary = [f"/// {line}" for line in self._summary.splitlines()]
        attributes = ["#[derive(BarSystem)]", *(f"#[{attribute}]" for attribute in self._attributes)]
        return "\n".join([*summary, *attributes, f"struct {self._name} {{", *self._fields, "}\n"])

    def model(self) -> Model:
        """The model that it declares."""
        return Model(self.text)

    def __repr__(self) -> str:
        return f"<Declaration of {self._name}: {len(self._attributes)} attributes>"

    def _with(self, *attributes: str) -> Declaration:
        longer = Declaration(self._name, self._summary)
        longer._attributes = (*self._attributes, *attributes)
        longer._fields = self._fields
        return longer


def _call(word: str, items: Iterable[str]) -> str:
    items = list(items)
    return f"{word}({', '.join(items)})" if items else word


def _items(words: Iterable[Any], entries: Mapping[str, Any]) -> list[str]:
    return [*map(_text, words), *(_entry(_plain(name), value) for name, value in entries.items())]


def _entry(name: str, value: Any) -> str:
    if value is True:
        return name
    if isinstance(value, Mapping):
        return _call(name, _items((), value))
    if isinstance(value, list):
        return _call(name, _items(value, {}))
    return f"{name} = {_text(value)}"


def _text(value: Any) -> str:
    if hasattr(value, "tolist"):
        value = value.tolist()
        return _text(tuple(value) if isinstance(value, list) else value)
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    if isinstance(value, tuple):
        return f"({', '.join(map(_text, value))})"
    raise TypeError(f"expected a text, a number or a tuple, not {value!r}")


def _field(name: str, value: Union[None, str, float, tuple[float, str]]) -> str:
    if value is None:
        return f"    {name}: f64,"
    items = [_text(value)]
    if isinstance(value, tuple):
        if len(value) != 2 or not isinstance(value[1], str):
            raise TypeError(f"{name}: expected a number with its unit, `(200, \"mm\")`, not {value!r}")
        items = [_text(value[0]), f"unit = {_quoted(value[1])}"]
    return f"    #[{_call('value', items)}]\n    {name}: f64,"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _plain(name: str) -> str:
    return name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name
