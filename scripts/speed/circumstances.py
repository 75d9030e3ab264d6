# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a reader must know to judge figures: machine, compiler, commit, date, load."""

import datetime
import os
import re
import subprocess

SOURCES = ("CMakeLists.txt", "vcg_extras/core", "vcg_extras/apps", "vcg_extras/bench")


def circumstances(build, command):
    return {
        "processor": _first_match("/proc/cpuinfo", r"model name\s*: (.*)"),
        "cores": len(os.sched_getaffinity(0)),
        "memory": f"{int(_first_match('/proc/meminfo', r'MemTotal: *([0-9]+)')) / 1e6:.0f} GB",
        "compiler": re.sub(r" \(.*\)", "", _output("c++", "--version").splitlines()[0]),
        "build_type": _first_match(build / "CMakeCache.txt", r"CMAKE_BUILD_TYPE:STRING=(.*)"),
        "meshoptimizer": _output("dpkg-query", "-W", "-f=${Version}", "libmeshoptimizer-dev"),
        "commit": _commit(),
        "date": datetime.date.today().isoformat(),
        "load": os.getloadavg()[0],
        "command": command,
    }


def _output(*command):
    outcome = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return outcome.stdout.strip()


def _first_match(path, pattern):
    with open(path) as file:
        found = re.search(pattern, file.read())
    return found.group(1) if found else "unknown"


def _commit():
    """A commit says nothing where the programs were built from other sources."""
    commit = _output("git", "rev-parse", "--short=10", "HEAD") or "no git checkout"
    changed = _output("git", "status", "--porcelain", "--", *SOURCES)
    return commit + (" with local changes" if changed else "")
