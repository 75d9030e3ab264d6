# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's claims on any meshes: vcg_extras/docs/measurements_paper.md. Its Table 1 (gpremesh compare), p99.9
beside it, the count that eq. (1) comes to, the constants that would hit it, and what eq. (5) makes of the
count."""

import argparse
from pathlib import Path

from . import circumstances
from .commands import PERCENT, Programs, output_as_json, say
from .pages import add_out_option, keep_record, kept_record, page, table, write_page

LONGEST_SECONDS_WITHOUT_COUNT = 600
PERCENTS_OF_COUNTS = (1, 3, 10, 30)
# λ as the paper has it has a unit: times r of eq. (1) it says the same as without.
WEIGHTS = (0, 0.25, 0.5, 1, 2)


def options_of(arguments):
    parser = argparse.ArgumentParser(prog="scripts/measure/run paper")
    parser.add_argument("meshes", nargs="+", type=Path, metavar="MESH")
    parser.add_argument("--table-only", default="", metavar="NAME,NAME,...",
                        help="meshes for Table 1 and one count only, such as those of millions of faces")
    parser.add_argument("--preset-only", default="", metavar="NAME,NAME,...",
                        help="the same, but only the paper's preset and no distances")
    parser.add_argument("--reuse", action="store_true", help="take what an earlier run has measured")
    add_out_option(parser)
    return parser.parse_args(arguments)


# ---- measuring


class Measuring:
    def __init__(self, programs, options):
        self.programs = programs
        self.options = options
        self.result = programs.work / "out.ply"

    def mesh(self, file):
        """The rows of all tables."""
        name = file.stem
        say(name)
        preset_only = name in self.options.preset_only.split(",")
        rows = {"table1": [self._preset_row(file)]} if preset_only else self._compared_rows(file)
        if preset_only or name in self.options.table_only.split(","):
            return {**rows, "counts": [self._count_row(file, PERCENT)], "density": []}
        return {**rows, "counts": [self._count_row(file, percent) for percent in PERCENTS_OF_COUNTS],
                "density": self._density_rows(file)}

    def _paper_run(self, file, *options):
        """The report of a run with the paper's preset and without smoothing."""
        return self.programs.remesh(file, self.result, "--preset", "paper", "--relax", 0, *options,
                                    longest=LONGEST_SECONDS_WITHOUT_COUNT)

    def _our_run(self, file, *options):
        """The report of a run whose count tells what its samples alone came to."""
        return self.programs.remesh(file, self.result, "--preset", "fast", *options,
                                    longest=LONGEST_SECONDS_WITHOUT_COUNT)

    def _compared_rows(self, file):
        compared = output_as_json(self.programs.path("gpremesh"), "compare", file, "--percent", PERCENT,
                                  "--json")
        target = compared["input"]["vertices"] * PERCENT / 100
        return {"table1": [compared_row(file.stem, compared["input"]["faces"], target, method)
                           for method in compared["methods"]],
                "distances": [distance_row(file.stem, method) for method in compared["methods"]]}

    def _preset_row(self, file):
        report = self.programs.remesh(file, self.result, "--preset", "paper", "--relax", 5, "--percent",
                                      PERCENT)
        return preset_row(file.stem, report)

    def _count_row(self, file, percent):
        paper = self._paper_run(file, "--percent", percent)
        ours = self._our_run(file, "--percent", percent)
        wanted, reached = paper["counts"]["targetVertices"], paper["result"]["vertices"]
        return [file.stem, f"{percent:g} %", str(wanted), str(reached), off_target(reached / wanted),
                f"{paper['radiusConstantForTarget']:.3f}",
                f"{ours['radiusConstant'] * sampled_share(ours) ** 0.5:.3f}"]

    def _density_rows(self, file):
        radius = self._paper_run(file, "--percent", PERCENT)["diskRadius"]
        rows = []
        for weight in WEIGHTS:
            paper = self._paper_run(file, "--percent", PERCENT, "--lambda", f"{weight * radius:.6g}")
            ours = self._our_run(file, "--percent", PERCENT, "--lambda", weight)
            rows.append([file.stem, f"{weight:g}", off_target(reached_share(paper)),
                         str(paper["counts"]["curvatureClamped"]), off_target(sampled_share(ours))])
        return rows


def reached_share(report):
    return report["result"]["vertices"] / report["counts"]["targetVertices"]


def sampled_share(report):
    return report["counts"]["samples"] / report["counts"]["targetVertices"]


def off_target(share):
    return f"{100 * (share - 1):+.1f} %"


def compared_row(name, faces_before, target, method):
    return [
        name, method["name"], f"{faces_before} / {method['faces']}",
        off_target(method["vertices"] / target), f"{method['seconds']['median']:.2f}",
        f"{method['toInput']['rms']:.4g}", f"{method['fromInput']['rmsPercent']:.4f} %",
        *_triangles(method["quality"]), "kept" if method["topologyKept"] else "changed"]


def distance_row(name, method):
    return [name, method["name"], *(f"{method[way][key]:.4f} %" for key in ("p999Percent", "hausdorffPercent")
                                    for way in ("toInput", "fromInput"))]


def preset_row(name, report):
    return [
        name, "gpremesh, preset paper, five umbrella steps",
        f"{report['input']['faces']} / {report['result']['faces']}", off_target(reached_share(report)),
        f"{report['seconds']['remesh']:.2f}", "–", "–", *_triangles(report["quality"]),
        "kept" if _topology_kept(report) else "changed"]


def _triangles(quality):
    angles = quality["angles"]
    return [f"{quality['aspectRatio']['mean']:.3f}", f"{angles['min']:.1f}°",
            f"{angles['below30Percent']:.3g} %"]


def _topology_kept(report):
    return all(report["result"][key] == report["cleanedInput"][key]
               for key in ("eulerCharacteristic", "boundaryLoops", "components"))


# ---- the page


def paper_page(data):
    def rows(which):
        return [row for mesh in data["meshes"] for row in mesh.get(which, [])]

    distances = rows("distances")  # none in records of earlier versions
    return page("scripts/measure/run paper", "Figures of the paper",
                "[paper.md](paper.md) compares the paper with this program, item by item.",
                table1_text(rows("table1")), *([distances_text(distances)] if distances else []),
                counts_text(rows("counts")), density_text(rows("density")),
                _circumstances(data))


def table1_text(rows):
    titles = ("model", "method", "faces before / after", "vertices off target", "seconds",
              "E_RMS from the result to the input, model units",
              "E_RMS from the input to the result, % of the diagonal", "mean aspect ratio",
              "smallest angle", "faces below 30°", "topology")
    return f"""\
## Table 1

{PERCENT} % of the vertices; `gpremesh compare`, one run of each method after the other. Quadric Edge Collapse is
vcglib's with MeshLab's parameters, on one thread, to the number of faces of the default's result.

{table(titles, rows, 3)}
E_RMS is given in both directions, because the directions can differ much: all points of the result may lie near the input while
parts of the input are far from the result. The paper names no direction.

The paper reports for its own results an aspect ratio of 0.824 to 0.835, 1.5 times the time of Quadric Edge Collapse, and 4.7 to 4.9
times its E_RMS.
"""


def distances_text(rows):
    titles = ("model", "method", "p99.9 from the result to the input", "p99.9 from the input to the result",
              "largest distance from the result to the input", "largest distance from the input to the result")
    return f"""\
## p99.9 and the largest distance

The same runs; all in percent of the diagonal. 99.9 % of the points are nearer than p99.9. Judge a result by this
figure: the largest distance depends on a single point, and varies much with the seed.

{table(titles, rows, 2)}"""


def counts_text(rows):
    titles = ("model", "target", "wanted", "reached", "", "constant for target, border edges",
              "the same, disk intersection")
    return f"""\
## Number of vertices by eq. (1)

The paper preset without exact count. "Constant for target": the constant in place of 0.844 for the wanted number (the count goes with 1/c²).

{table(titles, rows)}"""


def density_text(rows):
    return f"""\
## Eq. (5)

Vertices off target with the density of eq. (4), without exact count: radius by eq. (5) as printed, with signed H and its
mean over the vertices, and calibrated, with |H| and the area mean of the squared stretch. k is λ in units of the r of eq.
(1), the same for both. "Clamped": vertices with 1 + λH below 0.1.

{table(("model", "k", "as printed", "clamped", "calibrated"), rows)}"""


def _circumstances(data):
    facts = data["circumstances"]
    commits = ", ".join(f"{mesh['name']} {mesh['commit']}" for mesh in data["meshes"])
    return (f"{circumstances.sentence_on_machine(facts)}, {circumstances.sentence_on_build(facts)}; "
            f"commits: {commits}; {facts['date']}.\n" + circumstances.sentence_on_load(facts))


def main(build, commit, arguments):
    options = options_of(arguments)
    programs = Programs(build, build / "measure")
    record = programs.work / "paper.json"
    earlier = {}
    if options.reuse:
        earlier = {mesh["name"]: mesh for mesh in kept_record(record)["meshes"]}
    data = {"circumstances": circumstances.circumstances(build, commit), "meshes": []}
    measuring = Measuring(programs, options)
    for file in options.meshes:
        data["meshes"].append(earlier.get(file.stem) or
                              {"name": file.stem, "commit": commit, **measuring.mesh(file)})
        keep_record(record, data)
    write_page(options.out, "measurements_paper.md", paper_page(data))
