# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs programs and measures them from outside."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

PERCENT = 10  # of the vertices, of all runs that are compared
LONGEST_RUN_SECONDS = 3600
# A program starts with the peak of the one that started it, which of Python is some 20 MB; GNU time
# is small.
MEMORY_WATCH = "/usr/bin/time"


class RunFailed(RuntimeError):
    pass


@dataclass
class OutsideFigures:
    """What the operating system tells about a program that has ended."""

    wall: float  # seconds, from before its start until its end was seen
    processor: float  # seconds of all threads, user and system
    peak: int  # bytes, largest resident set: pages of mapped files count


@dataclass
class Programs:
    """Where the programs are, and a folder for what they write."""

    build: Path
    work: Path
    python: str = ""  # one that has packages of PyPI

    def path(self, name):
        return self.build / "bin" / name

    def info(self, mesh):
        """What `gpremesh info` tells of a mesh."""
        return output_as_json(self.path("gpremesh"), "info", mesh, "--json")

    def remesh(self, mesh, result, *options, longest=LONGEST_RUN_SECONDS):
        """The report of a run of `gpremesh remesh`."""
        report = self.work / "report.json"
        timed([self.path("gpremesh"), "remesh", mesh, result, "--quiet", "--report", report, *options],
              longest=longest)
        return json.loads(report.read_text())


def say(words, file=None):
    print(f"measure: {words}", file=file, flush=True)


def output_as_json(*command):
    return json.loads(subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE).stdout)


def timed(command, output=subprocess.DEVNULL, errors=None, longest=LONGEST_RUN_SECONDS):
    """Wall seconds of a command. Raises RunFailed where it ends with anything but 0."""
    return _run(list(map(str, command)), output, errors, longest)[0]


def measured(command, output=subprocess.DEVNULL):
    """The same with processor time and memory."""
    with tempfile.NamedTemporaryFile("r") as peak:
        watched = [MEMORY_WATCH, "-f", "%M", "-o", peak.name, *map(str, command)]
        wall, processor = _run(watched, output)
        return OutsideFigures(wall, processor, int(peak.read()) * 1024)


def touch_memory(byte_num):
    """Takes so much memory, writes to it and gives it back. Hosts of virtual machines take away what
    lies unused for some seconds; getting it back would be counted to the next run. No more than half
    of what is free, and no harm where even that fails."""
    byte_num = min(byte_num, _free_memory() // 2)
    subprocess.run([sys.executable, "-c", f"b'1' * {byte_num}"], stderr=subprocess.DEVNULL, check=False)


def _free_memory():
    """Bytes that can be had without taking away from others."""
    with open("/proc/meminfo") as table:
        return next(int(line.split()[1]) * 1024 for line in table if line.startswith("MemAvailable"))


def _run(command, output, errors=None, longest=LONGEST_RUN_SECONDS):
    start = time.perf_counter()
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
                               start_new_session=True)
    guard = threading.Timer(longest, _end, [process])
    guard.start()
    try:
        _, status, usage = os.wait4(process.pid, 0)
    except BaseException:
        _end(process)
        raise
    finally:
        guard.cancel()
    wall = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RunFailed(f"exit code {process.returncode}: {' '.join(command)}")
    return wall, usage.ru_utime + usage.ru_stime


def _end(process):
    """Ends a program and what it has started: all of its session."""
    os.killpg(process.pid, signal.SIGKILL)
