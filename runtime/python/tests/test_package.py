"""What is installed: types, documentation, code for any processor."""

import ast
import importlib.metadata
import importlib.resources
import inspect
import os
import platform
import subprocess
import sys

import pytest

import liftoff
from conftest import ROOT
from liftoff import _liftoff
from test_book import shown

STUBS = ast.parse(importlib.resources.files(liftoff).joinpath("_liftoff.pyi").read_text(encoding="utf-8"))
CLASSES = [liftoff.Event, liftoff.Model, liftoff.Trajectory]


def stubbed(name):
    found = next(node for node in STUBS.body if isinstance(node, ast.ClassDef) and node.name == name)
    return found, {node.name: node for node in found.body if isinstance(node, ast.FunctionDef)}


@pytest.mark.parametrize("kind", CLASSES)
def test_stubs_have_what_there_is(kind):
    found, functions = stubbed(kind.__name__)
    public = {name for name in vars(kind) if not name.startswith("_")}
    assert {name for name in functions if not name.startswith("_")} == public
    assert ast.get_docstring(found) == inspect.getdoc(kind)
    for name in public:
        member = inspect.getattr_static(kind, name)
        assert inspect.getdoc(member), name
        is_property = [ast.unparse(node) for node in functions[name].decorator_list] == ["property"]
        assert inspect.isgetsetdescriptor(member) == is_property, name
        if not is_property:
            arguments = functions[name].args
            listed = [*arguments.args, *arguments.kwonlyargs]
            stub = [argument.arg for argument in listed if argument.arg not in ("self", "cls")]
            stub += [rest.arg for rest in (arguments.vararg, arguments.kwarg) if rest]
            signature = inspect.signature(getattr(kind, name))
            assert sorted(stub) == sorted(set(signature.parameters) - {"self"}), name


def test_documentation_fits_a_terminal():
    kinds = [value for value in map(vars(liftoff).get, liftoff.__all__) if inspect.isclass(value)]
    documented = [liftoff, *kinds, *(member for kind in kinds for name, member in vars(kind).items() if name[0] != "_")]
    texts = [text for text in map(inspect.getdoc, documented) if text]
    assert len(texts) > 80
    assert [line for text in texts for line in text.splitlines() if len(line) > 100] == []


def checked(command, **options):
    """What a checker of types says of the installed package, which has to be nothing wrong."""
    environment = {**os.environ, "PATH": f"{os.path.dirname(sys.executable)}{os.pathsep}{os.environ['PATH']}"}
    ended = subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, env=environment, **options)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended.stdout


def test_types_are_complete_and_strict(tmp_path):
    (tmp_path / "book.py").write_text(shown("runtime/cli/src/book/python.md"), encoding="utf-8")
    assert "Type completeness score: 100%" in checked(["pyright", "--verifytypes", "liftoff", "--ignoreexternal"], cwd=tmp_path)
    checked(["pyright", "book.py"], cwd=tmp_path)
    checked(["mypy", "--strict", "book.py"], cwd=tmp_path)
    checked(["mypy"], cwd=ROOT / "runtime/python")


def test_the_package_is_typed_and_has_its_version():
    files = importlib.resources.files(liftoff)
    assert files.joinpath("py.typed").is_file()
    assert liftoff.__version__ == importlib.metadata.version("liftoff-dynamics")
    assert all(hasattr(liftoff, name) for name in liftoff.__all__)


def test_the_code_is_for_any_processor_of_its_kind():
    assert platform.machine() not in ("x86_64", "AMD64") or _liftoff._processor_features == []
