"""What the book and the README show of Python, run as it stands there."""

import math
import re

import pytest

from conftest import ROOT


def shown(path):
    text = (ROOT / path).read_text(encoding="utf-8")
    return "".join(re.findall(r"```python\n(.*?)```", text, re.S))


def test_the_page_of_the_book_is_true(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(shown("runtime/cli/src/book/python.md"), names)
    leaves, table = names["leaves"], names["table"]
    assert (leaves.kind, leaves.names) == ("open", ["B"])
    assert f"{leaves['phi']:.4f}".startswith("0.697") and math.isclose(leaves.reactions["A"], 2.4525)
    first = names["derivatives"].events[1]
    assert first.event.kind == "impact" and first.time == pytest.approx({"e": 0, "y": 1 / math.sqrt(2 * 9.81)})
    assert names["fit"].freedom == 1 and names["best"].at_bounds == ["y"]
    assert names["built"].model().explain() == names["ladder"].explain()
    # SciPy, DOP853 over each hundredth of a second.
    ended = (0.14379412008352654, -0.9134929533112798)
    assert (names["state"]["x_P"], names["state"]["x_P'"]) == pytest.approx(ended, rel=1e-12)
    assert names["acceleration"] == pytest.approx(-1.5 * 9.81 * math.sin(0.3))
    assert names["rest"].stability == "unstable" and names["rest"].reactions["A"] == pytest.approx((9.81, 9.81))
    assert table["t of first open"].shape == (2, 101) and not table.failed
    assert (tmp_path / "ladder.svg").stat().st_size > 1000 and (tmp_path / "ladder.html").stat().st_size > 10_000


def test_the_readme_is_true(monkeypatch):
    monkeypatch.chdir(ROOT)
    names = {}
    exec("import liftoff\n" + shown("README.md"), names)
    # As the README prints of the same run.
    assert [event.text for event in names["run"].events][1].startswith("P, Q open at t = 0.8294, phi = 0.8155")
