# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command of a package that was built without the program, beside the program: same bytes, messages, exit codes."""

import json
import os
import re
import signal
import subprocess
import sys
import time

import pytest

import gpremesh.__main__
from meshes import sheet, torus, triangles_of, write_ply

BY_PYTHON = [sys.executable, "-c", "import sys; from gpremesh._command import run; sys.exit(run(sys.argv[1:]))"]
BY_PROGRAM = [gpremesh.__main__.program()]


@pytest.fixture
def folders(tmp_path):
    """Two folders with the same meshes: one for each command."""
    made = [tmp_path / "program", tmp_path / "python"]
    vertices, quads = sheet()
    for folder in made:
        folder.mkdir()
        write_ply(folder / "in.ply", *torus())
        write_ply(folder / "sheet.ply", vertices, triangles_of(quads))
        (folder / "car.obj").write_text("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 1 1 1 1\n"
                                        "g side\nf 1 3 2\nf 1 2 4\ng top\nf 2 3 4\nf 3 1 4\n")
        (folder / "broken.ply").write_text("ply\nnonsense")
    return made


def run(command, words, folder):
    return subprocess.run([*command, *words], cwd=folder, capture_output=True, text=True, timeout=300)


def without_times(text):
    text = re.sub(r"seconds  .*", "seconds", text)
    return re.sub(r'"(read|remesh|write|total|peakMemoryBytes)": [0-9.e+-]+', r'"\1": 0', text)


def content(folder):
    files = {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    for path in [path for path in files if path.suffix == ".json"]:
        report = json.loads(files[path])
        for key in ("seconds", "peakMemoryBytes"):
            report.pop(key, None)
        report.pop("stages", None)  # times
        files[path] = report
    return files


CALLS = [
    "remesh in.ply out.ply",
    "in.ply -o out.ply --faces 900",
    "remesh in.ply --output out.obj --vertices 300 --seed 7 --quiet",
    "remesh in.ply out.stl --max-error 2% --report report.json",
    "remesh --percent=30 sheet.ply --boundary keep out.off --check --lambda 1.5",
    "remesh sheet.ply out.ply --selected",
    "remesh car.obj out.glb --vertices 60 --regions off --transfer nearest",
    "remesh sheet.ply in.ply --out-dir made --percent 20",
    "remesh in.ply tiles --tiles-out 2 --vertices 400",
    "remesh in.ply out.ply --memory 8G",
    "remesh in.ply in.ply --preset fast",
    "remesh in.ply out.ply --vertices 2",
    "remesh broken.ply out.ply",
    "remesh nowhere.ply out.ply",
    "remesh in.ply missing/out.ply",
    "remesh in.ply out.xyz",
    "remesh in.ply out.ply --faces 10 --vertices 10",
    "remesh in.ply out.ply --faces -3",
    "remesh in.ply out.ply --faces -x",
    "remesh in.ply out.ply --faces many",
    "remesh in.ply out.ply --faces",
    "remesh in.ply out.ply --faces=",
    "remesh in.ply out.ply --faces 10 --faces 12",
    "remesh in.ply out.ply --fac 10",
    "remesh in.ply out.ply --bogus",
    "remesh in.ply out.ply third.ply",
    "remesh in.ply out.ply -o other.ply",
    "remesh in.ply -o out.ply --out-dir made",
    "remesh in.ply out.ply --report in.ply",
    "remesh in.ply out.ply --periodic 1,2",
    "remesh in.ply out.ply --transfer mode",
    "remesh in.ply out.ply --memory many",
    "remesh in.ply out.ply --tiles-out 0",
    "remesh in.ply out.ply --sizes nothing",
    "remesh",
    "remesh in.ply",
    "frobnicate",
    "",
    "--version",
]


@pytest.mark.parametrize("call", CALLS)
def test_same_bytes_messages_and_exit_codes(folders, call):
    by_program, by_python = (run(command, call.split(), folder) for command, folder in zip((BY_PROGRAM, BY_PYTHON), folders))
    assert by_python.returncode == by_program.returncode
    assert by_python.stderr == by_program.stderr
    assert without_times(by_python.stdout) == without_times(by_program.stdout)
    assert content(folders[1]) == content(folders[0])


def options_and_groups(command, flag):
    text = run(command, ["remesh", flag], None).stdout
    return re.findall(r"^  (?:-[oh](?: OUT)?, ?)?(--[a-z-]+)", text, re.M), re.findall(r"^(\w.*):$", text, re.M)


def test_every_option_is_in_the_help_of_both():
    options, groups = options_and_groups(BY_PROGRAM, "--help-all")
    by_python = options_and_groups(BY_PYTHON, "--help-all")
    assert by_python[0] == options and len(options) > 30
    assert groups[1:-1] == [group for group in by_python[1] if group[0].isupper()] and len(groups) > 6


def test_the_help_of_both_has_the_everyday_options():
    everyday, _ = options_and_groups(BY_PROGRAM, "--help")
    assert options_and_groups(BY_PYTHON, "--help")[0] == everyday
    assert 12 <= len(everyday) <= 17 and "--seed" not in everyday and "--faces" in everyday


@pytest.mark.parametrize("name", ["info", "features", "compare", "levels", "tile"])
def test_other_commands_say_that_they_need_the_program(name):
    done = run(BY_PYTHON, [name], None)
    assert done.returncode == 1 and done.stdout == ""
    assert name in done.stderr and "CLI11" in done.stderr


def test_the_entry_takes_it_where_there_is_no_program(folders, monkeypatch):
    code = ("import sys, gpremesh.__main__ as entry\nentry.program = lambda: '/nowhere/gpremesh'\n"
            "sys.argv[1:] = ['in.ply', '-o', 'out.ply', '--quiet']\nentry.main()")
    assert run([sys.executable, "-c", code], [], folders[1]).returncode == 0
    assert run(BY_PROGRAM, ["in.ply", "-o", "out.ply", "--quiet"], folders[0]).returncode == 0
    assert content(folders[1]) == content(folders[0])


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_a_signal_ends_it(folders):
    write_ply(folders[1] / "large.ply", *torus(1500, 700))
    long = ["large.ply", "out.ply", "--quiet", "--percent", "40", "--check"]  # eight seconds on a fast machine
    with subprocess.Popen([*BY_PYTHON, "remesh", *long], cwd=folders[1], text=True,
                          stderr=subprocess.PIPE) as running:
        time.sleep(1.5)
        running.send_signal(signal.SIGINT)
        told = running.stderr.read()
    assert running.returncode == 5, told
    assert told.startswith("gpremesh: ") and not (folders[1] / "out.ply").exists()
