# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of gpremesh and of other remeshers with as many vertices, handed to TetGen, to fTetWild and to a Poisson
problem on the surface: vcg_extras/docs/measurements_simulation.md.

Each step is a process of its own with a cap on its processor time; what crashes, refuses or does not end is a row that
says so. Times are processor times, so that other programs on the machine do not change who ends in time.
simulation_tasks.py has the steps.
"""

import argparse
import concurrent.futures
import importlib.util
import os
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from . import circumstances, simulation_page, simulation_picture
from .commands import PERCENT, Programs, say
from .pages import DOCS, add_out_option, keep_record, kept_record, write_page

LONGEST_STEP_SECONDS = 120  # of processor time
WALL_SHARE = 10  # a step that sleeps or starves ends after so many times its cap
LEAST_VERTICES = 2000  # of a result; coarse models would lose their shape at 10 %
MOST_VERTICES = 5000  # more would take the meshers of volumes very long
LEAST_SHARE = 1.5  # of a model's vertices over those of its result
MOST_FACES = 300000  # of a model out of a folder
FORMATS = (".ply", ".stl", ".obj", ".off")
MADE_IN_CODE = ("stone", "box")  # by gpr_big_mesh
FACES_MADE_IN_CODE = 40000
NEEDED = ("numpy", "scipy", "pyvista", "pymeshlab", "tetgen")
PICTURE = "measurements_simulation.png"
NO_VOLUME_OFF = 0.02  # the volume of the tetrahedra may differ so much from that inside of the surface


@dataclass
class Method:
    key: str
    label: str
    package: str = ""  # of Python; empty: a program of the build folder


METHODS = (
    Method("gpremesh", "gpremesh"),
    Method("gpremesh-adapt", "gpremesh --adapt 1"),
    Method("pyacvd", "pyacvd", "pyacvd"),
    Method("cgal", "CGAL, isotropic remeshing"),
    Method("quadric", "Quadric Edge Collapse", "pymeshlab"),
    Method("meshoptimizer", "meshoptimizer", "almeshopt"),
    Method("meshoptimizer-regular", "meshoptimizer, regularised", "almeshopt"),
)
# Key, package.
TOOLS = (("tetgen-kept", "tetgen"), ("tetgen-free", "tetgen"), ("ftetwild", "pytetwild"))


def options_of(arguments):
    parser = argparse.ArgumentParser(prog="scripts/measure/run simulation")
    parser.add_argument("meshes", nargs="*", type=Path, metavar="MESH",
                        help="closed meshes; by default those in GPR_MODELS_DIR, or without it two that "
                             "are made in code")
    parser.add_argument("--vertices", type=int,
                        help=f"of the results; by default {PERCENT} %% of the model's, at least {LEAST_VERTICES}, "
                             f"at most {MOST_VERTICES}")
    parser.add_argument("--tools", default=",".join(key for key, _ in TOOLS), help="meshers of volumes (all)")
    parser.add_argument("--longest", type=int, default=LONGEST_STEP_SECONDS, metavar="SECONDS",
                        help=f"cap on the processor time of each step ({LONGEST_STEP_SECONDS})")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)), help="methods at a time (all cores)")
    parser.add_argument("--reuse", action="store_true", help="take what an earlier run has measured")
    add_out_option(parser)
    return parser.parse_args(arguments)


def is_installed(package):
    return not package or importlib.util.find_spec(package) is not None


def without_missing(wanted, label_and_package):
    """Those whose package is there; a line for each other one."""
    there = []
    for thing in wanted:
        label, package = label_and_package(thing)
        if is_installed(package):
            there.append(thing)
        else:
            say(f"SKIPPED: {label} ({package} is not installed)")
    return there


# ---- one step


# The soft limit is the one that a signal tells of.
LIMITED = ("/bin/sh", "-c", 'ulimit -c 0; ulimit -S -t "$1"; shift; exec "$@"', "step")


def outcome(command, longest):
    """Nothing where a command is done, else a sentence."""
    too_long = f"not done after {longest} s"
    try:
        done = subprocess.run([*LIMITED, str(longest), *map(str, command)], timeout=WALL_SHARE * longest,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
    except subprocess.TimeoutExpired:
        return too_long
    if done.returncode == -signal.SIGXCPU:
        return too_long
    if done.returncode < 0:
        return f"crash, signal {-done.returncode}"
    if done.returncode > 0:
        return (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
    return ""


class Steps:
    """The steps of simulation_tasks.py, and the remeshers."""

    def __init__(self, programs, longest):
        self.programs = programs
        self.longest = longest

    def task(self, file, name, *arguments):
        """Its figures, which go to the file on the way; {"failure": sentence} where there are none."""
        file.unlink(missing_ok=True)
        failure = outcome([sys.executable, "-m", "measure.simulation_tasks", file, name, *arguments], self.longest)
        return {"failure": failure} if failure else kept_record(file)

    def remesh(self, method, model, result, goal):
        """A sentence where there is no result."""
        result.unlink(missing_ok=True)
        if method.package:
            failed = self.task(result.with_suffix(".json"), "remesh", method.key, model, result, goal["vertices"],
                               goal["faces"])
            return failed.get("failure", "")
        if method.key == "cgal":
            return outcome([self.programs.path("gpr_bench_baseline"), "cgal", model, result, goal["faces"]],
                           self.longest)
        adapt = ["--adapt", 1] if method.key == "gpremesh-adapt" else []
        return outcome([self.programs.path("gpremesh"), "remesh", model, result, "--vertices", goal["vertices"],
                        "--quiet", *adapt], self.longest)

    def volume(self, tool, surface):
        """The figures of a mesh of the volume; one that has another volume than the surface is a failure."""
        figures = self.task(surface.with_suffix(".json"), "volume", tool, surface)
        share = figures.get("volumeShare", 1)
        if abs(share - 1) > NO_VOLUME_OFF:
            figures["failure"] = f"the volume is {100 * share:.0f} % of that inside"
        return figures


# ---- measuring


class Measuring:
    def __init__(self, steps, options, commit):
        self.steps = steps
        self.options = options
        self.commit = commit
        self.work = steps.programs.work
        self.methods = without_missing(METHODS, lambda method: (method.label, method.package))
        wanted = [tool for tool in TOOLS if tool[0] in options.tools.split(",")]
        self.tools = [key for key, _ in without_missing(wanted, lambda tool: tool)]

    def model(self, name, file, digests):
        """The figures of all methods on a model; None with a line where it is none for the study."""
        welded = self.work / f"{name}.model.ply"
        facts = self.steps.task(welded.with_suffix(".json"), "input", file, welded)
        complaint = complaint_on(facts, digests) or self._too_coarse(facts)
        if complaint:
            say(f"SKIPPED: {name} ({complaint})")
            return None
        goal = self._goal(welded, facts)
        if "failure" in goal:
            say(f"SKIPPED: {name} (gpremesh: {goal['failure']})")
            return None
        record = {"name": name, "commit": self.commit, "vertices": facts["vertices"], "faces": facts["faces"],
                  "digest": facts["digest"], "goal": goal}
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            results = pool.map(lambda method: self._method(name, method, welded, goal), self.methods)
            record["results"] = {method.key: result for method, result in zip(self.methods, results)}
        return record

    def _too_coarse(self, facts):
        """Whether hardly a vertex would have to go."""
        if self.options.vertices or facts["vertices"] >= LEAST_SHARE * LEAST_VERTICES:
            return ""
        return f"{facts['vertices']} vertices are too few"

    def _goal(self, model, facts):
        """What the others are asked for: the counts of gpremesh's result."""
        wanted = min(MOST_VERTICES, max(LEAST_VERTICES, round(facts["vertices"] * PERCENT / 100)))
        goal = {"vertices": self.options.vertices or wanted}
        result = self.work / "goal.ply"
        failure = self.steps.remesh(METHODS[0], model, result, goal)
        if failure:
            return {"failure": failure}
        return {**goal, "faces": self.steps.programs.info(result)["input"]["faces"]}

    def _method(self, name, method, model, goal):
        say(f"{name}, {method.label}")
        result = self.work / f"{name}.{method.key}.ply"
        failure = self.steps.remesh(method, model, result, goal)
        if failure:
            return {"failure": failure}
        figures = {"surface": self.steps.task(result.with_suffix(".json"), "surface", result, model)}
        for tool in self.tools:
            figures[tool] = self.steps.volume(tool, result)
        return figures


def complaint_on(facts, digests):
    """Why a mesh bounds no volume, or an empty string; digests are those of the models before."""
    if "failure" in facts:
        return facts["failure"]
    if facts["digest"] in digests:
        return "the same surface under another name"
    if not facts["closed"]:
        return "it is not closed and manifold"
    if facts["components"] > 1:
        return f"it has {facts['components']} components"
    return f"TetGen: {facts['refusal']}" if facts["refusal"] else ""


# ---- models


def models(options, programs):
    """Names and files."""
    if options.meshes:
        return [(file.stem, file) for file in options.meshes]
    folder = os.environ.get("GPR_MODELS_DIR")
    return models_of_folder(Path(folder), programs) if folder else models_in_code(programs)


def models_in_code(programs):
    say("GPR_MODELS_DIR is not set: meshes are made in code")
    made = []
    for kind in MADE_IN_CODE:
        file = programs.work / f"{kind}.ply"
        subprocess.run([programs.path("gpr_big_mesh"), kind, file, str(FACES_MADE_IN_CODE)], check=True,
                       stdout=subprocess.DEVNULL)
        made.append((kind, file))
    return made


def models_of_folder(folder, programs):
    """All that are not too large; whether they are closed is seen later."""
    found = []
    for file in sorted(folder.iterdir()):
        if file.suffix.lower() not in FORMATS:
            continue
        try:
            face_num = programs.info(file)["input"]["faces"]
        except subprocess.CalledProcessError:
            say(f"SKIPPED: {file.stem} (gpremesh cannot read it)")
            continue
        if face_num > MOST_FACES:
            say(f"SKIPPED: {file.stem} ({face_num} faces, more than {MOST_FACES})")
        else:
            found.append((file.stem, file))
    return found


# ---- all of it


def versions():
    from importlib import metadata

    packages = sorted({method.package for method in METHODS if method.package} | {tool[1] for tool in TOOLS}
                      | {"scipy"})
    found = {package: metadata.version(package) for package in packages if is_installed(package)}
    return {**found, "CGAL": circumstances.version_of_package("libcgal-dev")}


def measure(data, options, measuring, record):
    """Adds the models one after the other; what was measured is kept on the way."""
    known = {mesh["name"]: mesh for mesh in kept_record(record)["meshes"]} if options.reuse else {}
    for name, file in models(options, measuring.steps.programs):
        digests = [mesh["digest"] for mesh in data["meshes"]]
        mesh = known.get(name) or measuring.model(name, file, digests)
        if mesh:
            data["meshes"].append(mesh)
            known[name] = mesh
            keep_record(record, {**data, "meshes": list(known.values())})


def main(build, commit, arguments):
    options = options_of(arguments)
    missing = [package for package in NEEDED if not is_installed(package)]
    if missing:
        raise RuntimeError(f"these packages of Python are missing: {', '.join(missing)}")
    programs = Programs(build, build / "measure")
    programs.work.mkdir(parents=True, exist_ok=True)
    measuring = Measuring(Steps(programs, options.longest), options, commit)
    data = {"circumstances": circumstances.circumstances(build, commit), "versions": versions(),
            "longest": options.longest, "tools": measuring.tools, "meshes": [],
            "methods": [[method.key, method.label] for method in measuring.methods]}
    measure(data, options, measuring, programs.work / "simulation.json")
    if not data["meshes"]:
        raise RuntimeError("there was no closed mesh to measure")
    picture = (options.out or DOCS) / PICTURE
    picture.parent.mkdir(parents=True, exist_ok=True)
    drawn = simulation_picture.draw(data, picture)
    write_page(options.out, "measurements_simulation.md", simulation_page.text(data, PICTURE if drawn else ""))
