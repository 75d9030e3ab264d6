# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the measurement of speed compares: each method is one program run on a file."""

import hashlib
import json
import os
from dataclasses import dataclass

from .commands import PERCENT, measured, touch_memory

# Keys of the report's "seconds" that are no stages of the engine.
NO_STAGES = ("read", "remesh", "write", "total")


@dataclass
class Method:
    key: str
    label: str
    threads: int
    bytes_per_face: int  # of the input, about what a run needs
    preset: str = ""  # of gpremesh; empty: another simplifier
    remesher: str = ""  # of simulation_tasks.REMESHERS, in Python; empty: a program
    most_faces: float = float("inf")  # of the input; larger ones take too long

    def run(self, programs, mesh, face_num, goal):
        """One run; goal is the number of faces that other simplifiers are to reach."""
        touch_memory(self.bytes_per_face * face_num)
        if self.preset:
            return self._run_gpremesh(programs, mesh)
        return self._run_baseline(programs, mesh, goal)

    def command(self, programs, mesh, result, goal):
        """gpremesh writes its report beside."""
        if not self.preset:
            return [*self._baseline(programs), mesh, result, str(goal)]
        return [programs.path("gpremesh"), "remesh", mesh, result, "--percent", str(PERCENT),
                "--preset", self.preset, "--threads", str(self.threads), "--quiet",
                "--report", programs.work / "report.json"]

    def _run_gpremesh(self, programs, mesh):
        result = programs.work / "result.ply"
        outside = measured(self.command(programs, mesh, result, 0))
        report = json.loads((programs.work / "report.json").read_text())
        seconds = report["seconds"]
        stages = {key: value for key, value in seconds.items() if key not in NO_STAGES}
        return _record(seconds["remesh"], outside, report["result"], result, stages)

    def _run_baseline(self, programs, mesh, goal):
        result = programs.work / "result.ply"
        output = programs.work / "baseline.json"
        with output.open("w") as told:
            outside = measured(self.command(programs, mesh, result, goal), told)
        figures = json.loads(output.read_text())
        return _record(figures["seconds"], outside, figures, result, {})

    def _baseline(self, programs):
        if self.remesher:
            return [programs.python, "-m", "measure.package_baseline", self.remesher]
        return [programs.path("gpr_bench_baseline"), self.key]


def _record(seconds, outside, counts, result, stages):
    return {
        "seconds": seconds,
        "wall": outside.wall,
        "processor": outside.processor,
        "peak": outside.peak,
        "vertices": counts["vertices"],
        "faces": counts["faces"],
        "stages": stages,
        "digest": taken_digest(result),
    }


def taken_digest(result):
    """Of a file, which is deleted."""
    digest = hashlib.sha256(result.read_bytes()).hexdigest()
    result.unlink()
    return digest


def thread_nums():
    """2, 1, and as many as there are cores by doubling."""
    more = [2 ** i for i in range(2, 10) if 2 ** i <= len(os.sched_getaffinity(0))]
    return [2, 1, *more]


def all_methods():
    """The default first: its number of faces is the goal of the other simplifiers."""
    ours = [Method(f"{preset}-{threads}", f"gpremesh, {preset}", threads, 80, preset)
            for preset in ("default", "fast") for threads in thread_nums()]
    return ours + [
        Method("meshoptimizer", "meshoptimizer of Debian", 1, 150, most_faces=40e6),
        Method("meshoptimizer-pypi", "meshoptimizer of PyPI", 1, 180, most_faces=40e6, remesher="meshoptimizer"),
        Method("meshoptimizer-pypi-regular", "meshoptimizer of PyPI, regularised", 1, 180, most_faces=40e6,
               remesher="meshoptimizer-regular"),
        Method("quadric", "Quadric Edge Collapse", 1, 400, most_faces=10e6),
    ]
