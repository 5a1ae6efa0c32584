"""The notebook, run from its first cell to its last."""

import pathlib

import nbformat
from nbclient import NotebookClient

NOTEBOOK = pathlib.Path(__file__).parents[1] / "examples/liftoff.ipynb"


def outputs(notebook):
    """Of each cell the kinds of its answers, with what they say in plain text."""
    cells = [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]
    return [[(sorted(data), data.get("text/plain")) for data in map(shown, cell)] for cell in cells]


def shown(output):
    return output.get("data", {"text/plain": output.get("text", "")})


def test_the_notebook_runs():
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbformat.validate(notebook)
    stored = outputs(notebook)
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    assert outputs(notebook) == stored
    kinds = {kind for cell in stored for kinds, _ in cell for kind in kinds}
    assert {"image/svg+xml", "text/html", "text/latex"} <= kinds
    text = "".join(text or "" for cell in stored for _, text in cell)
    assert "'A, C, E'" in text and "C settle at t = 1.970" in text
