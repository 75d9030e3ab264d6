# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a program and measures it from outside."""

import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import dataclass

LONGEST_RUN_SECONDS = 3600
# A program starts with the peak of the one that started it, which of Python is some 20 MB; GNU time
# is small.
MEMORY_WATCH = "/usr/bin/time"


@dataclass
class OutsideFigures:
    """What the operating system tells about a program that has ended."""

    wall: float  # seconds, from before its start until its end was seen
    processor: float  # seconds of all threads, user and system
    peak: int  # bytes, largest resident set: pages of mapped files count


class RunFailed(RuntimeError):
    pass


def measured(command, standard_output=subprocess.DEVNULL):
    """Runs a command to its end. Raises RunFailed where it ends with anything but 0."""
    with tempfile.NamedTemporaryFile("r") as peak:
        watched = [MEMORY_WATCH, "-f", "%M", "-o", peak.name, *map(str, command)]
        wall, processor = _run(watched, standard_output)
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


def _run(command, standard_output):
    start = time.perf_counter()
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=standard_output,
                               start_new_session=True)
    guard = threading.Timer(LONGEST_RUN_SECONDS, _end, [process])
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
