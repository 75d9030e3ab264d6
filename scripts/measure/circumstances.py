# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a reader must know to judge figures: machine, compiler, commit, date, load."""

import datetime
import os
import re
import subprocess
from pathlib import Path

SOURCES = ("CMakeLists.txt", *(f"vcg_extras/{folder}" for folder in ("core", "complex", "io", "apps", "bench")))
LEAST_LOAD_TO_TELL = 0.5  # of the last minute; an idle machine stays below it


def circumstances(build, commit):
    """To be taken right before the first run, so that the load is that of other programs."""
    return {
        "processor": _first_match("/proc/cpuinfo", r"model name\s*: (.*)"),
        "cores": len(os.sched_getaffinity(0)),
        "memory": f"{int(_first_match('/proc/meminfo', r'MemTotal: *([0-9]+)')) / 1e6:.0f} GB",
        "compiler": re.sub(r" \(.*\)", "", _output("c++", "--version").splitlines()[0]),
        "build_type": _first_match(build / "CMakeCache.txt", r"CMAKE_BUILD_TYPE:STRING=(.*)"),
        "meshlab": version_of_package("meshlab"),
        "meshoptimizer": version_of_package("libmeshoptimizer-dev"),
        "commit": commit,
        "date": datetime.date.today().isoformat(),
        "load": os.getloadavg()[0],
    }


def commit_of_sources():
    """A commit says nothing where the programs were built from other sources."""
    commit = _output("git", "rev-parse", "--short=10", "HEAD") or "no git checkout"
    changed = _output("git", "status", "--porcelain", "--", *SOURCES)
    return commit + (" with local changes" if changed else "")


def version_of_package(name):
    return _output("dpkg-query", "-W", "-f=${Version}", name)


def version_in_python(python, name):
    """Of a package of PyPI; an empty string where that Python cannot use it."""
    if not Path(python).is_file():
        return ""
    return _output(python, "-c", f"import {name}, importlib.metadata as m; print(m.version('{name}'))")


def sentence_on_machine(facts):
    return f"{facts['processor']}, {facts['cores']} cores"


def sentence_on_build(facts):
    return f"{facts['compiler']}, {facts['build_type']}"


def sentence_on_load(facts):
    """A line, or nothing where the machine was idle."""
    if facts["load"] <= LEAST_LOAD_TO_TELL:
        return ""
    return (f"The machine was busy (load {facts['load']:.2f} before the first run): "
            "read the seconds as upper bounds.\n")


def _output(*command):
    outcome = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return outcome.stdout.strip()


def _first_match(path, pattern):
    with open(path) as file:
        found = re.search(pattern, file.read())
    return found.group(1) if found else "unknown"
