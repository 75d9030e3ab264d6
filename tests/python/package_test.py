# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The names of the parameters, the stub, the examples of the documents, the command line of the package."""

import doctest
import inspect
import json
import pickle
import re
import subprocess
import sys
from pathlib import Path

import pytest

import gpremesh
from gpremesh import _api, _core
from meshes import command_line, torus

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("tool", ["remesh", "sample", "features"])
def test_every_parameter_is_in_signature_and_help(tool):
    function = getattr(gpremesh, tool)
    names = list(inspect.signature(function).parameters)
    for entry in _core.parameters(tool):
        assert entry["name"].isidentifier() and names.count(entry["name"]) == 1
        assert f"\n{entry['name']} : " in inspect.getdoc(function)


def test_the_names_are_those_of_the_command_line():
    options = set(re.findall(r"--([a-z-]+)", command_line("remesh", "--help-all").stdout))
    options -= {"help", "help-all", "quiet", "report", "selected", "memory", "scratch", "tiles-out", "regions", "sizes", "transfer",
                "periodic", "out-dir", "output"}
    names = {entry["name"].rstrip("_").replace("_", "-") for entry in _core.parameters("remesh")}
    names = (names - {"vertex-count", "face-count"}) | {"vertices", "faces"}
    assert names <= options
    # What the help names beside the table's options.
    assert not {option for option in options - names if f"\n  --{option} " in command_line("remesh", "--help-all").stdout}


def test_defaults_given_by_hand_change_nothing():
    vertices, faces = torus()
    given = {entry["name"]: entry["default"] for entry in _core.parameters("remesh")}
    expected = gpremesh.remesh(vertices, faces)
    assert gpremesh.remesh(vertices, faces, **given).vertices.tobytes() == expected.vertices.tobytes()


def test_the_stub_is_up_to_date():
    script = ROOT / "vcg_extras/python/make_stubs"
    checked = subprocess.run([sys.executable, script, "--check"], capture_output=True, text=True)
    assert checked.returncode == 0, checked.stderr


TYPED = """
import numpy as np
import gpremesh
vertices, faces = np.zeros((4, 3)), np.zeros((4, 3), np.int32)
result: gpremesh.RemeshResult = gpremesh.remesh(vertices, faces, vertex_count=np.int64(9), periodic=[1, 1, 0], adapt=np.float32(1))
reveal_type(gpremesh.Surface(vertices, [[0, 1, 2], [0, 1, 2, 3]]).remesh(percent=5))
mesh = gpremesh.FileMesh(vertices, faces, vertex_values={"height": vertices[:, 2]})
reveal_type(mesh.remesh(9, regions=faces[:, 0]))
reveal_type(mesh.uv)
gpremesh.remesh_together(((vertices, faces), {"vertices": vertices, "faces": faces}))
gpremesh.trimesh.remesh(None, 9)
gpremesh.levels(vertices, faces, percent=(20, 10))
gpremesh.remesh(vertices, faces, preset="quick")
"""


def test_types_for_checkers(tmp_path, monkeypatch):
    api = pytest.importorskip("mypy.api", reason="mypy is not installed")
    monkeypatch.setenv("MYPYPATH", str(Path(gpremesh.__file__).parents[1]))
    (tmp_path / "typed.py").write_text(TYPED)
    told = api.run(["--cache-dir", str(tmp_path / "cache"), "--follow-imports=silent", str(tmp_path / "typed.py")])[0]
    for expected in ("RemeshResult", "FileMesh", "ndarray"):
        assert re.search(f"Revealed type is .*{expected}", told), told
    assert told.count("error:") == 1 and "preset" in told, told


@pytest.mark.parametrize("holder", [gpremesh, _api], ids=lambda module: module.__name__)
def test_examples_in_the_code(holder):
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner()
    for name in ("",) if holder is gpremesh else ("remesh", "sample"):
        for test in finder.find(getattr(holder, name) if name else holder, name or "gpremesh", globs={}):
            runner.run(test)
    assert runner.failures == 0 and runner.tries > 5


@pytest.mark.parametrize("name", ["python.md", "series.md"])
def test_examples_in_the_documents(name):
    results = doctest.testfile(str(ROOT / "vcg_extras/docs" / name), module_relative=False)
    assert results.failed == 0 and results.attempted > 5


def test_examples_on_the_first_screen(tmp_path, monkeypatch):
    bunny = Path("/usr/share/glmark2/models/bunny.obj")
    if not bunny.exists():
        pytest.skip("glmark2-data is not installed")
    monkeypatch.chdir(tmp_path)
    gpremesh.write("scan.ply", gpremesh.read(bunny))
    results = doctest.testfile(str(ROOT / "README.md"), module_relative=False)
    assert results.failed == 0 and results.attempted == 5
    words = command_line("remesh", "scan.ply", "by_program.ply", "--faces", "7000", "--quiet")
    assert words.stdout == "" and Path("by_program.ply").read_bytes() == Path("small.ply").read_bytes()


def test_version_is_that_of_the_program():
    assert command_line("--version").stdout.split() == ["gpremesh", gpremesh.__version__]


def test_module_as_a_program(tmp_path):
    (tmp_path / "cube.off").write_text("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
    words = [sys.executable, "-m", "gpremesh"]
    done = subprocess.run([*words, "info", "--json", tmp_path / "cube.off"], capture_output=True, text=True)
    assert done.returncode == 0 and json.loads(done.stdout)["input"]["faces"] == 4
    assert subprocess.run([*words, "remesh"], capture_output=True).returncode == 2


def test_errors_can_be_pickled():
    error = pickle.loads(pickle.dumps(gpremesh.Error("Too few.", "count too small", 7)))
    assert (str(error), error.status, error.smallest_count) == ("Too few.", "count too small", 7)


def test_hosts_are_imported_only_when_used():
    code = "import sys, gpremesh; print([name for name in ('pyvista', 'trimesh', 'open3d') if name in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"
    with pytest.raises(AttributeError):
        gpremesh.no_such_host
