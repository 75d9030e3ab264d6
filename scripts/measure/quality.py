# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles and time beside MeshLab's own Quadric Edge Collapse: vcg_extras/docs/measurements.md, and its
main rows in README.md.

What is timed, in memory for both: of gpremesh `seconds.remesh` of its report; of Quadric Edge Collapse
the wall time of meshlabserver, which tells no times, less that of the same command with the filter
"Select None". Neither command writes a mesh.
"""

import argparse
import os
from pathlib import Path

from . import circumstances
from .commands import PERCENT, Programs, say
from .meshlab import MeshLab
from .pages import (add_out_option, keep_record, kept_record, page, table, write_into_readme,
                    write_page)
from .statistics_of_runs import Spread

# All of them can be had: vcg_extras/docs/models.md.
MODELS = ("igea_269k", "rockerarm_20k", "rangemap_lato315_121k_open_32comp", "terrain_N44W072_2.9M_open")
THREADS = (1, 0)  # 0: all there are
TITLES = ("model", "method", "vertices", "faces", "seconds", "mean 2r/R", "mean aspect ratio",
          "smallest angle", "faces below 30°")


def options_of(arguments):
    parser = argparse.ArgumentParser(prog="scripts/measure/run quality")
    parser.add_argument("--repeats", type=int, default=5, help="runs of each method (5)")
    parser.add_argument("--page", action="store_true", help="only the page, from the last run's figures")
    add_out_option(parser)
    return parser.parse_args(arguments)


# ---- measuring


class Measuring:
    def __init__(self, programs, repeats):
        self.programs = programs
        self.repeats = repeats
        self.meshlab = MeshLab(programs.build / "meshlab")

    def mesh(self, name, file):
        """The first run is not timed: it tells the number of faces for the other method."""
        ours = self.programs.work / f"{name}.ours.ply"
        report = self._remesh(file, ours, 0)
        goal = report["result"]["faces"]
        runs = {"quadric": [], **{str(threads): [] for threads in THREADS}}
        for round_number in range(self.repeats):
            say(f"{name}, round {round_number + 1} of {self.repeats}")
            self._round(name, file, goal, runs)
        quadric = self.programs.work / f"{name}.quadric.ply"
        self.meshlab.quadric_edge_collapse(file, goal, self._stem(name, "quadric"), quadric)
        return {
            "name": name,
            "threads": report["threads"],
            "seconds": runs,
            "figures": {"input": self._figures(file), "ours": self._figures(ours),
                        "quadric": self._figures(quadric)},
        }

    def _round(self, name, file, goal, runs):
        """Everything once, one after the other."""
        for threads in THREADS:
            report = self._remesh(file, self.programs.work / f"{name}.ours.ply", threads)
            runs[str(threads)].append(report["seconds"]["remesh"])
        without = self.meshlab.nothing(file, self._stem(name, "idle"))
        whole = self.meshlab.quadric_edge_collapse(file, goal, self._stem(name, "quadric"))
        runs["quadric"].append(whole - without)

    def _remesh(self, file, result, threads):
        return self.programs.remesh(file, result, "--percent", PERCENT, "--threads", threads)

    def _stem(self, name, what):
        return self.programs.work / f"{name}.{what}"

    def _figures(self, file):
        info = self.programs.info(file)
        quality = info["quality"]
        return {
            "vertices": info["input"]["vertices"],
            "faces": info["input"]["faces"],
            "radiusRatio": quality["radiusRatio"]["mean"],
            "aspectRatio": quality["aspectRatio"]["mean"],
            "smallestAngle": quality["angles"]["min"],
            "below30Percent": quality["angles"]["below30Percent"],
        }


def models(work):
    """Names and files of those that are here."""
    folder = Path(os.environ.get("GPR_MODELS_DIR", ""))
    found = [("bunny", work / "bunny.ply")]
    for name in MODELS:
        file = folder / f"{name}.ply"
        if os.environ.get("GPR_MODELS_DIR") and file.exists():
            found.append((name, file))
        else:
            say(f"SKIPPED: {name} (no such file in GPR_MODELS_DIR)")
    return found


# ---- the page


def rows_of(mesh, for_readme=False):
    """All rows of a mesh, or the two that are compared."""
    figures, seconds = mesh["figures"], mesh["seconds"]
    input_row = _row(mesh, "input", figures["input"], None)
    quadric = _row(mesh, "Quadric Edge Collapse", figures["quadric"], seconds["quadric"])
    on_one = _row(mesh, "gpremesh, 1 thread", figures["ours"], seconds["1"])
    on_all = _row(mesh, f"gpremesh, {mesh['threads']} threads", figures["ours"], seconds["0"])
    return [quadric, on_all] if for_readme else [input_row, quadric, on_one, on_all]


def _row(mesh, method, figures, seconds):
    return [
        mesh["name"], method, str(figures["vertices"]), str(figures["faces"]),
        Spread(seconds).text() if seconds else "–", f"{figures['radiusRatio']:.4f}",
        f"{figures['aspectRatio']:.4f}", f"{figures['smallestAngle']:.1f}°",
        f"{figures['below30Percent']:.3g} %"]


def table_of(meshes, for_readme=False):
    return table(TITLES, [row for mesh in meshes for row in rows_of(mesh, for_readme)], 2)


def how_measured(data):
    facts = data["circumstances"]
    return (f"Medians of {data['repeats']} runs in alternation, smallest and largest in brackets; {PERCENT} % of the "
            "vertices, default options, seed 1.\n"
            f"{circumstances.sentence_on_machine(facts)}, {circumstances.sentence_on_build(facts)}; "
            f"MeshLab {facts['meshlab']}; commit {facts['commit']}; {facts['date']}.\n"
            + circumstances.sentence_on_load(facts))


HOW_TO_READ = """\
- **seconds**: from the mesh in memory to the result in memory. gpremesh: `seconds.remesh` of its report, with cleaning, ordering
  and audit. Quadric Edge Collapse: the wall time of MeshLab's own `meshlabserver` on one thread, minus the wall time with the filter
  "Select None", because meshlabserver prints no times. The parameters are the defaults of the dialog, with the number of
  faces of gpremesh's result.
- **mean 2r/R**: 2 · inradius / circumradius; **mean aspect ratio**: 2√3 · inradius / longest edge, the measure of the paper. Both are means
  over the faces, and 1 for equilateral triangles. `gpremesh info` computes all figures of meshes.
- [Sources of the models](models.md).

## Other measurements

| question | page |
|---|---|
| distance from the input, beside Quadric Edge Collapse and the paper | [Figures of the paper](measurements_paper.md) |
| distance, time and shape beside other Python packages | [Python packages](measurements_python.md) |
| presets, adaptivity, feature lines, feature regions | [Effect of options](measurements_options.md) |
| time and memory up to millions of faces, threads | [Speed](measurements_speed.md) |
| meshes that are larger than the memory | [Large meshes](measurements_tiles.md) |
| tetrahedra and the Poisson problem on the results | [Simulation](measurements_simulation.md) |
| the gain of each mechanism of the engine | [Mechanisms](measurements_ablation.md) |
| counts, sizes in mesh units and largest errors against their goals | [Counts and sizes](measurements_sizes.md) |
| geodesic distances of the sampling | [Accuracy of distances](accuracy_of_distances.md) |
| faulty input, cancelling, other systems | [Robustness](robustness.md) |
"""


def quality_page(data):
    return page("scripts/measure/run quality", "Measurements", table_of(data["meshes"]),
                how_measured(data), HOW_TO_READ)


def main(build, commit, arguments):
    options = options_of(arguments)
    programs = Programs(build, build / "measure")
    record = programs.work / "quality.json"
    if not options.page:
        data = {"circumstances": circumstances.circumstances(build, commit), "repeats": options.repeats,
                "meshes": []}
        measuring = Measuring(programs, options.repeats)
        for name, file in models(programs.work):
            data["meshes"].append(measuring.mesh(name, file))
            keep_record(record, data)
    data = kept_record(record)
    write_page(options.out, "measurements.md", quality_page(data))
    write_into_readme(options.out, table_of(data["meshes"], True) + "\n" + how_measured(data))
    print("\n" + table_of(data["meshes"]) + "\n" + how_measured(data))
