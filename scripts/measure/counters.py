# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What runs do, counted by valgrind's cachegrind: most virtual machines have no counters in hardware."""

import shutil
from pathlib import Path

from .commands import RunFailed, say, timed
from .methods import taken_digest
from .statistics_of_runs import spread_of

COUNTED = ("default-1", "fast-1", "meshoptimizer")
CACHES_OF_CORE = Path("/sys/devices/system/cpu/cpu0/cache")
UNITS = {"K": 1 << 10, "M": 1 << 20}


def count_all(programs, methods, mesh, commit):
    """Of a grown mesh of the study; None, and a line, where there is no valgrind, or it fails."""
    if not shutil.which("valgrind"):
        say("SKIPPED: what limits the runs (valgrind is missing)")
        return None
    try:
        chosen = [method for method in methods if method.key in COUNTED and mesh["runs"].get(method.key)]
        return {"mesh": mesh["name"], "commit": commit,
                "methods": {method.key: _count(programs, method, mesh) for method in chosen}}
    except RunFailed as failure:
        say(f"SKIPPED: what limits the runs ({failure})")
        return None


def _count(programs, method, mesh):
    """Cachegrind simulates two levels of caches. So a second run has that of the core for its last one."""
    say(f"counting {method.key} on {mesh['name']}")
    goal = mesh["runs"]["default-2"][0]["faces"]
    counters = _counters_of_run(programs, method, mesh, goal, "--branch-sim=yes")
    second = second_level_cache(CACHES_OF_CORE)
    if second:
        nearer = _counters_of_run(programs, method, mesh, goal, f"--LL={','.join(map(str, second))}")
        counters["secondMisses"] = nearer["lastMisses"]
        counters["caches"]["second"] = nearer["caches"]["last"]
    counters["sameBytes"] = counters.pop("digest") == mesh["runs"][method.key][-1]["digest"]
    return counters


def _counters_of_run(programs, method, mesh, goal, option):
    result = programs.work / "result.ply"
    output = programs.work / "cachegrind.out"
    timed(["valgrind", "--tool=cachegrind", "--cache-sim=yes", option, f"--cachegrind-out-file={output}",
           f"--log-file={programs.work / 'cachegrind.log'}",
           *method.command(programs, programs.work / f"{mesh['name']}.ply", result, goal)])
    return {**counters_in(output.read_text()), "digest": taken_digest(result)}


def counters_in(text):
    """Of what cachegrind writes: its sums, and the bytes of its caches. Without branches where it has none."""
    fields = [line.partition(": ") for line in text.splitlines()]
    lines = {name: value for name, _, value in fields if name in ("events", "summary")}
    sums = dict(zip(lines["events"].split(), map(int, lines["summary"].split())))
    sizes = dict(value.split(" cache:") for name, _, value in fields if name == "desc" and " cache:" in value)
    counters = {
        "instructions": sums["Ir"],
        "firstMisses": sums["D1mr"] + sums["D1mw"],
        "lastMisses": sums["DLmr"] + sums["DLmw"],
        "caches": {name: int(sizes[key].split()[0]) for name, key in (("first", "D1"), ("last", "LL"))},
    }
    if "Bcm" in sums:
        counters["mispredictions"] = sums["Bcm"] + sums["Bim"]
    return counters


def second_level_cache(folder):
    """Bytes, ways and bytes of a line, as the system tells them; None where it does not."""
    for cache in sorted(folder.glob("index*")):
        if _told(cache, "level") == "2":
            size, ways, line = (_told(cache, name) for name in ("size", "ways_of_associativity", "coherency_line_size"))
            if size and ways and line:
                return int(size.rstrip("KM")) * UNITS.get(size[-1], 1), int(ways), int(line)
    return None


def _told(cache, name):
    file = cache / name
    return file.read_text().strip() if file.exists() else ""


# ---- what follows from them


def instructions_a_nanosecond(mesh, counted, key):
    """Of the whole program, as they are counted."""
    return counted["instructions"] / spread_of(mesh, key, "wall").median / 1e9


def share_of_first_misses(counters, name):
    """Smallest and largest of all methods, in percent."""
    shares = [100 * counted[name] / counted["firstMisses"] for counted in counters["methods"].values()]
    return min(shares), max(shares)


def growth_of_seconds_a_face(smallest, largest, key):
    """How many times the seconds a face are in the largest mesh."""
    small, large = (spread_of(mesh, key, "seconds").median / mesh["faces"] for mesh in (smallest, largest))
    return large / small


def wrongs_of_counters(counters):
    """What cannot be right, whatever the machine."""
    for key, counted in counters["methods"].items():
        if not counted["lastMisses"] <= counted["firstMisses"] <= counted["instructions"]:
            yield f"counters of {key}: the larger cache misses more often, or more often than there are instructions"
        if not counted.get("mispredictions"):
            yield f"counters of {key}: no branch was mispredicted"
