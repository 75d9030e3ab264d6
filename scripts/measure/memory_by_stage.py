# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Watches a run's resident memory and tells the most that each stage held."""

import json
import resource
import subprocess
import time
from pathlib import Path

from .commands import PERCENT, RunFailed
from .methods import NO_STAGES

INTERVAL_SECONDS = 0.004


def watch_memory(programs, mesh, preset):
    """Bytes by stage, in the order of the run, reading first; None for a stage too short to be
    seen."""
    result = programs.work / "result.ply"
    report_file = programs.work / "report.json"
    command = [programs.path("gpremesh"), "remesh", mesh, result, "--percent", str(PERCENT), "--preset",
               preset, "--quiet", "--report", report_file]
    samples = _samples(command)
    result.unlink()
    return by_stage(samples, json.loads(report_file.read_text())["seconds"])


def _samples(command):
    """Pairs of seconds since the start and resident bytes."""
    start = time.perf_counter()
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    status = Path(f"/proc/{process.pid}/statm")
    page = resource.getpagesize()
    samples = []
    while process.poll() is None:
        resident = int(status.read_text().split()[1]) * page
        samples.append((time.perf_counter() - start, resident))
        time.sleep(INTERVAL_SECONDS)
    if process.returncode != 0:
        raise RunFailed(f"exit code {process.returncode}: {' '.join(map(str, command))}")
    return samples


def by_stage(samples, seconds):
    stages = [("read", seconds["read"])]
    stages += [(name, length) for name, length in seconds.items() if name not in NO_STAGES]
    most = {}
    begin = 0
    for name, length in stages:
        held = [resident for when, resident in samples if begin <= when < begin + length]
        most[name] = max(held, default=None)
        begin += length
    return most
