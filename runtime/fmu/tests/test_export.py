"""Units that cannot be written: one line, and no file."""

import subprocess

from conftest import BUILT, GALLERY, PROGRAM

LIBRARY = BUILT / "libliftoff_fmi.so"


def refused(folder, source, library):
    unit = folder / "a.fmu"
    command = [PROGRAM, "export", source, "--fmu", unit, "--library", library]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1 and not unit.exists()
    (line,) = done.stderr.splitlines()
    return line


def test_a_library_that_is_not_there(tmp_path):
    line = refused(tmp_path, GALLERY / "ladder.rs", tmp_path / "nowhere.so")
    assert f"there is no `{tmp_path / 'nowhere.so'}`: build it" in line


def test_a_library_that_is_another(tmp_path):
    (tmp_path / "other.so").write_bytes(b"another")
    line = refused(tmp_path, GALLERY / "ladder.rs", tmp_path / "other.so")
    assert "is not the library of functional mock-up units of liftoff" in line


def test_a_parameter_without_a_value(tmp_path):
    lines = (GALLERY / "ladder.rs").read_text().splitlines()
    (tmp_path / "open.rs").write_text("\n".join(line for line in lines if "#[value(" not in line))
    line = refused(tmp_path, tmp_path / "open.rs", LIBRARY)
    assert "has no value to begin with: declare one, #[value(…)]" in line


def test_a_folder_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    command = [PROGRAM, "export", GALLERY / "ladder.rs", "--library", LIBRARY, "--fmu", tmp_path / "file" / "a.fmu"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1 and len(done.stderr.splitlines()) == 1


def test_units_are_the_same_each_time(tmp_path):
    for name in ["a.fmu", "b.fmu"]:
        command = [PROGRAM, "export", GALLERY / "ladder.rs", "--library", LIBRARY, "--fmu", tmp_path / name]
        subprocess.run(command, check=True, capture_output=True)
    assert (tmp_path / "a.fmu").read_bytes() == (tmp_path / "b.fmu").read_bytes()
