# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of whole runs, which scripts/bench explains."""

import argparse
import os
import shlex
import subprocess
import sys
from pathlib import Path

from .bandwidth import memory_bandwidth
from .circumstances import circumstances, version_in_python
from .commands import Programs, RunFailed, say
from .counters import count_all, wrongs_of_counters
from .memory_by_stage import watch_memory
from .methods import all_methods
from .pages import DOCS, add_out_option, keep_record, kept_record, write_page
from .speed_page import speed_page
from .speed_picture import draw
from .stage_benchmarks import measure_stages
from .statistics_of_runs import has_same_bytes

FULL_SIZES = "0.27M,2.4M,7.75M,31M"
QUICK_SIZES = "30k,60k"
PACKAGE = "almeshopt"  # of PyPI, with the newest meshoptimizer that has a regularising option
BUILT_IN = ("stone", "land", "box")
MOST_FACES_FOR_STAGES = 3e6
LEAST_FACES_FOR_MEMORY = 1e6  # the program itself is too much of a smaller run's memory


def options_of(arguments):
    parser = argparse.ArgumentParser(prog="scripts/bench")
    parser.add_argument("--grow", default="stone", metavar="MESH", help="mesh to grow to the sizes")
    parser.add_argument("--sizes", metavar="N,N,...", help=f"numbers of faces ({FULL_SIZES})")
    parser.add_argument("--rounds", type=int, help="runs of each method (5; 3 above 3M faces, 1 above 40M)")
    parser.add_argument("--quick", action="store_true", help="whether it all works, in a minute")
    parser.add_argument("--page", action="store_true", help="only the page, from the last run's figures")
    parser.add_argument("--counters", action="store_true",
                        help="only what limits the runs, and the page, beside the last run's figures")
    parser.add_argument("meshes", nargs="*", type=Path, help="further meshes, as they are")
    add_out_option(parser)
    options = parser.parse_args(arguments)
    for mesh in options.meshes + [Path(options.grow)] * (options.grow not in BUILT_IN):
        if not mesh.exists():
            parser.error(f"there is no {mesh}")
    return options


def face_number(text):
    unit = {"k": 1e3, "M": 1e6}.get(text[-1], 1)
    return round(float(text.rstrip("kM")) * unit)


def methods_of(figures):
    """Without those whose package cannot be used here."""
    return [method for method in all_methods() if figures.get("package") or not method.remesher]


# ---- measuring


class Measuring:
    def __init__(self, options, programs):
        self.options = options
        self.programs = programs
        self.work = programs.work
        self.methods = all_methods()

    def all(self, figures, record):
        """Writes the record after each mesh, so that a run broken off is not lost."""
        figures["meshes"] = []
        figures["bandwidth"] = memory_bandwidth()
        self.methods = methods_of(figures)
        files = self._files()
        for name, file, grown in files:
            figures["meshes"].append(self._measure_mesh(name, file, grown))
            keep_record(record, figures)
        figures["stages"] = self._stages(figures["meshes"], files)
        keep_record(record, figures)
        add_counters(figures, self.programs, figures["circumstances"]["commit"], record)

    def _files(self):
        """Name, file, and whether it is of the family that grows."""
        sizes = self.options.sizes or (QUICK_SIZES if self.options.quick else FULL_SIZES)
        base = Path(self.options.grow)
        grown = [(f"{base.stem}_{size}", size) for size in sizes.split(",")]
        files = [(name, self._grow(name, size), True) for name, size in grown]
        return files + [(mesh.stem, mesh, False) for mesh in self.options.meshes]

    def _grow(self, name, size):
        maker = self.programs.path("gpr_big_mesh")
        file = self.work / f"{name}.ply"
        if not file.exists() or file.stat().st_mtime < maker.stat().st_mtime:
            say(f"making {name}")
            subprocess.run([maker, self.options.grow, file, str(face_number(size))], check=True,
                           stdout=subprocess.DEVNULL)
        return file

    def _measure_mesh(self, name, file, grown):
        mesh = {"name": name, "faces": self.programs.info(file)["input"]["faces"], "grown": grown, "runs": {}}
        rounds = self._rounds(mesh["faces"])
        for round_number in range(rounds):
            say(f"{name}, round {round_number + 1} of {rounds}")
            self._measure_round(mesh, file, round_number)
        if self.options.quick or mesh["faces"] >= LEAST_FACES_FOR_MEMORY:
            mesh["memory"] = {preset: watch_memory(self.programs, file, preset)
                              for preset in ("fast", "default")}
        return mesh

    def _rounds(self, face_num):
        if self.options.rounds:
            return self.options.rounds
        if self.options.quick:
            return 1
        return 5 if face_num <= 3e6 else 3 if face_num <= 40e6 else 1

    def _measure_round(self, mesh, file, round_number):
        methods = [m for m in self.methods if mesh["faces"] <= m.most_faces]
        # The goal of the others is known from the first round on, which begins with the default.
        if round_number % 2 == 1:
            methods.reverse()
        for method in methods:
            goal = mesh["runs"]["default-2"][0]["faces"] if "default-2" in mesh["runs"] else 0
            self._run_once(method, mesh, file, goal)

    def _run_once(self, method, mesh, file, goal):
        """Other simplifiers may be missing, or fail; that is no reason to measure nothing."""
        try:
            record = method.run(self.programs, file, mesh["faces"], goal)
        except RunFailed as failure:
            if method.preset:
                raise
            say(f"left out: {method.label} ({failure})")
            return
        mesh["runs"].setdefault(method.key, []).append(record)

    def _stages(self, meshes, files):
        """On the largest mesh that is not too large for them."""
        if self.options.quick:
            return {"mesh": "stone_100k", "rows": measure_stages(self.programs, "stone_100k",
                                                                 least_seconds="0")}
        fitting = [i for i, mesh in enumerate(meshes) if mesh["faces"] <= MOST_FACES_FOR_STAGES]
        if not fitting:
            return None
        chosen = max(fitting, key=lambda i: meshes[i]["faces"])
        name, file, _ = files[chosen]
        say(f"stages of {name}")
        return {"mesh": name, "rows": measure_stages(self.programs, name, file)}


def add_counters(figures, programs, commit, record):
    """Of the smallest mesh: valgrind makes runs some thirty times as long."""
    smallest = min((mesh for mesh in figures["meshes"] if mesh["grown"]), key=lambda mesh: mesh["faces"])
    figures["counters"] = count_all(programs, methods_of(figures), smallest, commit)
    keep_record(record, figures)


# ---- what is told


def complaints(figures):
    """What cannot be right, whatever the machine; for --quick."""
    found = []
    for mesh in figures["meshes"]:
        for method in methods_of(figures):
            runs = mesh["runs"].get(method.key, [])
            if not runs:
                found.append(f"{method.label} was not run on {mesh['name']}")
            found += [f"{method.label} on {mesh['name']}: {wrong}"
                      for run in runs for wrong in wrongs_of(run, mesh)]
        for preset in ("default", "fast"):
            if not has_same_bytes(mesh, preset):
                found.append(f"{preset} on {mesh['name']}: bytes depend on the threads")
    if figures.get("counters"):
        found += wrongs_of_counters(figures["counters"])
    return found


def wrongs_of(run, mesh):
    if not 0 < run["seconds"] <= run["wall"]:
        yield "takes longer inside than outside"
    if not 0 < run["faces"] < mesh["faces"]:
        yield "left as many faces as there were, or none"
    if not run["peak"] > 12 * mesh["faces"]:
        yield "needed less memory than its input"


def tell(figures, folder):
    folder.mkdir(parents=True, exist_ok=True)
    picture = folder / "measurements_speed.png"
    grown = [mesh for mesh in figures["meshes"] if mesh["grown"]]
    drawn = draw(grown, methods_of(figures), figures.get("bandwidth"), picture)
    if not drawn:
        say("no picture: matplotlib is missing (python3-matplotlib)")
    page = speed_page(figures, methods_of(figures), picture.name if drawn else "")
    write_page(folder, "measurements_speed.md", page)


def package_version(python):
    """An empty string, and a line, where it cannot be used."""
    version = version_in_python(python, PACKAGE)
    if not version:
        say(f"SKIPPED: meshoptimizer of PyPI ({PACKAGE} is not to be had here; to try again, delete the folder "
            f"{Path(python).parent.parent})" if python else f"SKIPPED: meshoptimizer of PyPI (no Python has {PACKAGE})")
    return f"{PACKAGE} {version}" if version else ""


def command_of(arguments):
    """As it was called, without the folders, which are of this machine."""
    return shlex.join(["scripts/bench"] + [Path(a).name if "/" in a else a for a in arguments])


def main(build, commit, arguments):
    options = options_of(arguments)
    programs = Programs(build, build / "bench", os.environ.get("GPR_BENCH_PYTHON", ""))
    record = programs.work / ("quick.json" if options.quick else "speed.json")
    if options.counters:
        add_counters(kept_record(record), programs, commit, record)
    elif not options.page:
        figures = {"circumstances": circumstances(build, commit), "command": command_of(arguments),
                   "package": package_version(programs.python)}
        Measuring(options, programs).all(figures, record)
    figures = kept_record(record)
    tell(figures, options.out or (programs.work if options.quick else DOCS))
    if options.quick:
        wrong = complaints(figures)
        for sentence in wrong:
            say(sentence)
        sys.exit(1 if wrong else 0)
