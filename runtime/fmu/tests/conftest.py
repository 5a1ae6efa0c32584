"""Units of files of models, written by the program and unpacked where the path has blanks and letters beyond ASCII."""

import json
import os
import pathlib
import subprocess

import fmpy
import pytest

ROOT = pathlib.Path(__file__).parents[3]
BUILT = ROOT / "target" / "release"
PROGRAM = os.environ.get("LIFTOFF", BUILT / "examples" / "step_ladder")
GALLERY = ROOT / "runtime" / "web" / "gallery"
MODELS = ROOT / "runtime" / "fmu" / "tests" / "models"


class Unit:
    """A unit, and the runs of its model by the program."""

    def __init__(self, name, folder):
        files = [folder / f"{name}.rs" for folder in (MODELS, GALLERY)]
        self.source = next(file for file in files if file.exists())
        self.archive = folder / f"{name}.fmu"
        command = [PROGRAM, "export", self.source, "--fmu", self.archive, "--library", BUILT / "libliftoff_fmi.so"]
        subprocess.run(command, check=True, capture_output=True)
        self.folder = fmpy.extract(str(self.archive), str(folder / name))
        self.description = fmpy.read_model_description(self.folder)
        self.reference = {v.name: v.valueReference for v in self.description.modelVariables}
        self.outputs = [v.name for v in self.description.modelVariables if v.causality == "output"]

    def run(self, stop, *options):
        """The events of a run up to a time, the start and the end among them."""
        return self.motion(stop, *options)["events"]

    def samples(self, stop, every, outputs):
        """States and outputs of a run, by time."""
        asked = [f"--output={output}" for output in outputs]
        rows = self.motion(stop, f"--every={every!r}", *asked)["samples"]
        return {row["t"]: {**row["state"], **row["outputs"]} for row in rows}

    def motion(self, stop, *options):
        command = [PROGRAM, "run", self.source, "--until", f"t = {stop!r}", "--json", *options]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        return json.loads(done.stdout)

    def simulate(self, kind, stop, parts, **options):
        """Rows of all outputs by FMPy; co-simulation returns at events."""
        if kind == "CoSimulation":
            options = {"use_event_mode": True, "early_return_allowed": True, **options}
        return fmpy.simulate_fmu(
            self.folder, fmi_type=kind, stop_time=stop, output_interval=stop / parts, output=self.outputs, **options
        )


@pytest.fixture(scope="session")
def unit(tmp_path_factory):
    folder, made = tmp_path_factory.mktemp("Übung 1 – units"), {}

    def of(name):
        if name not in made:
            made[name] = Unit(name, folder)
        return made[name]

    return of
