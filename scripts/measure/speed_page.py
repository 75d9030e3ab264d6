# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of scripts/bench: all figures, and how to read them."""

from . import circumstances
from .counters import growth_of_seconds_a_face, instructions_a_nanosecond, share_of_first_misses
from .pages import page, table
from .statistics_of_runs import (Spread, amdahl, bandwidth_seconds, growth_of, has_same_bytes, memory_of, overhead_of,
                                parallel_share, ratio_of, spread_of)

OURS = ("fast-2", "fast-1", "default-2", "default-1")
# Key, and how ratios to it are written.
OTHERS = (("meshoptimizer", "{:.2f}"), ("meshoptimizer-pypi", "{:.2f}"), ("meshoptimizer-pypi-regular", "{:.2f}"),
          ("quadric", "{:.1f}"))
MANY_CORES = (8, 64)  # for which Amdahl's bound is told


def speed_page(data, methods, picture_name):
    methods = {method.key: method for method in methods}
    parts = [
        _how_to_read() + _left_out(methods),
        "## Ratios\n\n" + _ratios(data["meshes"], methods),
        "## Whole runs\n\n" + _whole_runs(data["meshes"], methods),
        "## Growth\n\n" + _growth(data["meshes"], methods, picture_name),
        "## Threads\n\n" + _threads(data["meshes"]),
        *_bandwidth_part(data),
        *_counters_part(data, methods),
        "## Stages of the whole runs\n\n" + _stages(data["meshes"], methods),
    ]
    if any("memory" in mesh for mesh in data["meshes"]):
        parts.append("## Memory by stages\n\n" + _memory(data["meshes"]))
    if data.get("stages"):
        parts.append("## Single stages\n\n" + _single_stages(data["stages"]))
    return page("scripts/bench", "Speed", *parts, _circumstances(data))


def _how_to_read():
    return """\
10 % of the vertices, seed 1. All methods run on a mesh one after the other, then in the opposite order, and so on (rounds). Figures are medians,
smallest and largest in brackets. Other load disturbs all methods of a round alike, so ratios are taken within a round, and
say more than seconds.

- **seconds**: the algorithm, from the mesh in memory to the result in memory. gpremesh: `seconds.remesh` of its report, with cleaning,
  ordering and audit. Quadric Edge Collapse: of vcglib, with the values of MeshLab's dialog, without assertions, from vcglib's mesh to
  vcglib's mesh. meshoptimizer: `meshopt_simplify` alone, at any error, from arrays to arrays. All three run on one thread, with the number
  of faces of gpremesh's default as their goal; the column "faces" shows earlier ends.
- **meshoptimizer of PyPI**: in the package almeshopt, compiled for AVX2; **regularised**: with `meshopt_SimplifyRegularize`, which the older
  package meshoptimizer of PyPI lacks. The time includes the array for the result and a copy by the package, and no input arrays.
- **whole program**: wall time from start to end of the process: reading a binary PLY, the algorithm, writing a binary PLY. The other simplifiers
  use gpremesh's reader and writer; meshoptimizer of PyPI uses numpy, and also starts Python. **over seconds** is the ratio to the
  seconds.
- **processor**: time of all threads, user and system, of the whole program; nearly twice the wall time if two threads are always busy.
- **peak**: the largest resident memory of the program (`ru_maxrss`), with the pages of the mapped input file, which the system may
  reclaim; **B/face** is the peak divided by the faces of the input. For the other simplifiers the peak includes the arrays of the input.
- Before each run the script allocates, writes and frees the memory of the run, because hosts of virtual machines reclaim unused memory after some
  seconds, and take long to return pages.
- A ratio of 3 means: the other simplifier takes three times as long. The triangles differ in quality:
  [measurements.md](measurements.md), [measurements_paper.md](measurements_paper.md).
"""


def _left_out(methods):
    limits = [f"{m.label} above {m.most_faces / 1e6:.0f} million faces" for m in methods.values()
              if m.most_faces != float("inf")]
    text = f"- Left out for lack of time: {', '.join(limits)}.\n"
    if not any(method.remesher for method in methods.values()):
        text += "- meshoptimizer of PyPI was not available: its rows are missing.\n"
    return text


# ---- tables


def _text(spread, number_format="{:.3f}"):
    return spread.text(number_format) if spread else "–"


def _title(mesh):
    return f"{mesh['name']}, {mesh['faces']:,} faces"


def _name(method):
    if not method.preset:
        return method.label
    return f"{method.label}, {method.threads} thread{'s' if method.threads > 1 else ''}"


def _ratios(meshes, methods):
    others = [(key, written) for key, written in OTHERS if key in methods]
    rows = []
    for mesh in meshes:
        for key in OURS:
            ratios = [_text(ratio_of(mesh, other, key), written) for other, written in others]
            rows.append([_title(mesh), _name(methods[key]), *ratios, _text(overhead_of(mesh, key), "{:.2f}")])
    titles = ["model", "method", *(f"× {methods[key].label}" for key, _ in others), "whole program over seconds"]
    return table(titles, rows, 2)


def _whole_runs(meshes, methods):
    rows = []
    for mesh in meshes:
        rows += [_whole_row(mesh, method) for method in methods.values() if mesh["runs"].get(method.key)]
    titles = ["model", "method", "vertices", "faces", "seconds", "M faces/s", "whole program", "processor",
              "peak, MB", "B/face"]
    return table(titles, rows, 2)


def _whole_row(mesh, method):
    last = mesh["runs"][method.key][-1]
    seconds = spread_of(mesh, method.key, "seconds")
    peak = spread_of(mesh, method.key, "peak").median
    return [
        _title(mesh), _name(method), str(last["vertices"]), str(last["faces"]), _text(seconds),
        f"{mesh['faces'] / seconds.median / 1e6:.2f}", _text(spread_of(mesh, method.key, "wall")),
        f"{spread_of(mesh, method.key, 'processor').median:.2f}", f"{peak / 1e6:.0f}",
        f"{peak / mesh['faces']:.0f}"]


# ---- growth


def _growth(meshes, methods, picture_name):
    grown = [mesh for mesh in meshes if mesh["grown"]]
    text = f"![Seconds by faces and by threads, memory by faces]({picture_name})\n\n" if picture_name else ""
    text += """\
Fitted over the sizes of the first model. **seconds ~ faces^b**: 1 is linear. **from size to size**: ratio of the seconds to the size before,
and ratio of the faces. **peak = offset + B/face · faces**, by least squares with equal weight for each size.

"""
    rows = [row for row in (_growth_row(grown, method) for method in methods.values()) if row]
    return text + table(["method", "b", "from size to size", "B/face", "offset, MB"], rows)


def _growth_row(grown, method):
    fitted = growth_of(grown, method.key, "seconds")
    memory = memory_of(grown, method.key)
    if fitted is None or memory is None:
        return None
    return [_name(method), f"{fitted[1]:.3f}", _steps(grown, method.key), f"{memory[1]:.1f}",
            f"{memory[0] / 1e6:.0f}"]


def _steps(grown, key):
    measured = [mesh for mesh in grown if mesh["runs"].get(key)]
    steps = []
    for before, after in zip(measured, measured[1:]):
        times = spread_of(after, key, "seconds").median / spread_of(before, key, "seconds").median
        steps.append(f"{times:.2f} for {after['faces'] / before['faces']:.2f}")
    return "; ".join(steps)


# ---- threads and bandwidth


def _threads(meshes):
    text = """\
**parallel** is the share of the work that a second thread halves. By Amdahl's law the rest of the work limits any number of
cores; **at most with 8 cores** is the ratio to one thread if 8 cores divide the parallel share evenly. A share above 100 % is noise, and counts
as 100 %.

"""
    rows = []
    for mesh in meshes:
        for preset in ("fast", "default"):
            one = spread_of(mesh, f"{preset}-1", "seconds").median
            two = spread_of(mesh, f"{preset}-2", "seconds").median
            share = parallel_share(one, two)
            rows.append([_title(mesh), preset, f"{one:.3f}", f"{two:.3f}", f"{one / two:.2f}", f"{100 * share:.0f} %",
                         *(f"{amdahl(share, cores):.1f}" for cores in MANY_CORES),
                         "yes" if has_same_bytes(mesh, preset) else "NO"])
    titles = ["model", "preset", "1 thread, s", "2 threads, s", "times faster", "parallel",
              *(f"at most with {cores} cores" for cores in MANY_CORES), "same bytes"]
    return text + table(titles, rows, 2)


def _bandwidth_part(data):
    """Earlier records have none."""
    if "bandwidth" not in data:
        return []
    text = f"""\
## Limit by memory bandwidth

The line in the picture is the time to write and read the arrays of a run once. The arrays are the peak of `fast`, with the program itself,
which counts for small meshes. Reading and writing together reach {data['bandwidth'] / 1e9:.1f} GB/s, measured by copies of a large array on all cores
before the first run. The rest of a run is arithmetic, latency of single memory accesses, and further passes over the arrays.

"""
    rows = [_bandwidth_row(mesh, data["bandwidth"]) for mesh in data["meshes"]]
    titles = ["model", "bytes a face", "limit, s", "fast, 2 threads, over it", "default, 2 threads, over it"]
    return [text + table(titles, rows)]


def _bandwidth_row(mesh, bandwidth):
    limit = bandwidth_seconds(mesh, bandwidth)
    held = spread_of(mesh, "fast-2", "peak").median / mesh["faces"]
    over = [spread_of(mesh, key, "seconds").median / limit for key in ("fast-2", "default-2")]
    return [_title(mesh), f"{held:.0f}", f"{limit:.3f}", *(f"{times:.0f}" for times in over)]


# ---- what limits the runs


def _counters_part(data, methods):
    """Earlier records have none, nor those of machines without valgrind."""
    counters = data.get("counters")
    if not counters:
        return []
    mesh = next(mesh for mesh in data["meshes"] if mesh["name"] == counters["mesh"])
    rows = [_counters_row(mesh, methods[key], counted) for key, counted in counters["methods"].items()]
    titles = ["method", "instructions", "misses of the first cache", "of the second", "of the last", "mispredictions",
              "whole program, s", "instructions a ns"]
    facts = [_fact_on_caches(counters), _fact_on_presets(mesh, counters), _fact_on_threads(mesh, counters),
             _fact_on_waiting(counters), _fact_on_size(data["meshes"], counters)]
    return ["## Instructions and caches\n\n" + _how_counted(data, mesh, counters) + table(titles, rows) + "\n"
            + "".join(f"- {fact}\n" for fact in facts if fact)]


def _how_counted(data, mesh, counters):
    same = all(counted["sameBytes"] for counted in counters["methods"].values())
    caches = next(iter(counters["methods"].values()))["caches"]
    sizes = ", ".join(f"{name} {size / 1024:,.0f} KiB" for name, size in sorted(caches.items(), key=lambda c: c[1]))
    return f"""\
Runs of each method on {_title(mesh)}, on one thread, by valgrind's cachegrind: most virtual machines have no
hardware counters. Figures are per face of the input. Data caches and branch prediction are simulated ({sizes}), without prefetch. Other
machines may share the last cache. Counters and seconds cover the whole program with reading and writing. The seconds are the medians
of the runs above, without valgrind.
Counted with commit {counters['commit']}, timed with {data['circumstances']['commit']};
the results are {'the same, byte for byte' if same else 'NOT the same'}.

"""


def _counters_row(mesh, method, counted):
    names = ("firstMisses", "secondMisses", "lastMisses", "mispredictions")
    each = [f"{counted[name] / mesh['faces']:.1f}" if name in counted else "–" for name in names]
    return [_name(method), f"{counted['instructions'] / mesh['faces']:.0f}", *each,
            _text(spread_of(mesh, method.key, "wall")), f"{instructions_a_nanosecond(mesh, counted, method.key):.1f}"]


def _fact_on_caches(counters):
    found = "Of the misses of the first cache, {:.0f} to {:.0f} % miss the last cache too."
    text = found.format(*share_of_first_misses(counters, "lastMisses"))
    if all("secondMisses" in counted for counted in counters["methods"].values()):
        text += (" {:.0f} to {:.0f} % miss the second cache, which belongs to the core."
                 .format(*share_of_first_misses(counters, "secondMisses")))
    return text


def _times(mesh, counters, slower, faster):
    """How many times the instructions, the instructions a nanosecond, and the seconds; None where one was not run."""
    pair = [counters["methods"].get(key) for key in (slower, faster)]
    if not all(pair):
        return None
    rates = [instructions_a_nanosecond(mesh, counted, key) for counted, key in zip(pair, (slower, faster))]
    instructions = pair[0]["instructions"] / pair[1]["instructions"]
    return instructions, rates[0] / rates[1], instructions * rates[1] / rates[0]


def _fact_on_presets(mesh, counters):
    times = _times(mesh, counters, "default-1", "fast-1")
    return times and (f"The default takes {times[0]:.1f} times the instructions of `fast`, and {times[2]:.1f} times its "
                      "seconds. Equal ratios mean that the number of instructions decides the time.")


def _fact_on_threads(mesh, counters):
    times = _times(mesh, counters, "default-1", "meshoptimizer")
    return times and (f"The default takes {times[0]:.1f} times the instructions of meshoptimizer, and runs {times[1]:.1f} times the "
                      f"instructions a nanosecond: {times[2]:.1f} times the seconds. Two threads reach {times[2] / 2:.1f} times at best, and "
                      f"become as fast as meshoptimizer with at most {2 * times[1]:.1f} times its instructions.")


def _fact_on_waiting(counters):
    ours, other = (counters["methods"].get(key) for key in ("default-1", "meshoptimizer"))
    if not ours or not other:
        return None
    of_1000 = [1000 * counted[name] / counted["instructions"]
               for name in ("firstMisses", "mispredictions") for counted in (other, ours)]
    return ("In 1000 instructions meshoptimizer misses the first cache {:.1f} times, the default {:.1f} times; {:.1f} and "
            "{:.1f} branches are mispredicted. The duration of each miss is not counted.".format(*of_1000))


def _fact_on_size(meshes, counters):
    """From the smallest to the largest mesh that all of them were run on."""
    keys = list(counters["methods"])
    grown = sorted((mesh for mesh in meshes if mesh["grown"] and all(mesh["runs"].get(key) for key in keys)),
                   key=lambda mesh: mesh["faces"])
    if len(grown) < 2:
        return None
    names = {"default-1": "the default", "fast-1": "`fast`"}
    factors = ", ".join(f"{growth_of_seconds_a_face(grown[0], grown[-1], key):.2f} with {names.get(key, key)}"
                        for key in keys)
    return (f"From {grown[0]['faces']:,} to {grown[-1]['faces']:,} faces the seconds a face, on one thread, grow by these "
            f"factors: {factors}. The caches hold a smaller part of a larger mesh; misses are counted on the smallest mesh.")


# ---- stages


def _stages(meshes, methods):
    text = "Seconds by the reports' stages; stages below a hundredth of the run are left out.\n"
    titles = ["stage"] + [_name(methods[key]).removeprefix("gpremesh, ") for key in OURS]
    for mesh in meshes:
        text += f"\n{_title(mesh)}:\n\n" + table(titles, _stage_rows(mesh))
    return text


def _stage_rows(mesh):
    names = list(mesh["runs"]["default-1"][0]["stages"])
    wholes = {key: spread_of(mesh, key, "seconds").median for key in OURS}
    rows = []
    for name in names:
        times = {key: _stage_seconds(mesh, key, name) for key in OURS}
        if any(times[key] > 0.01 * wholes[key] for key in OURS):
            rows.append([name] + [f"{times[key]:.3f}" for key in OURS])
    return rows + [["all"] + [f"{wholes[key]:.3f}" for key in OURS]]


def _stage_seconds(mesh, key, name):
    return Spread(run["stages"].get(name, 0) for run in mesh["runs"][key]).median


def _memory(meshes):
    text = """\
The largest resident memory during each stage, in bytes a face of the input; one run each on all cores, sampled every few
milliseconds, so short stages are missing. "read" includes the pages of the mapped file.
"""
    for mesh in meshes:
        if "memory" not in mesh:
            continue
        held = [mesh["memory"][preset] for preset in ("fast", "default")]
        rows = [[name] + [_bytes(h.get(name), mesh) for h in held]
                for name in held[1]]
        text += f"\n{_title(mesh)}:\n\n" + table(["stage", "fast", "default"], rows)
    return text


def _bytes(held, mesh):
    """A preset need not have all stages, nor need all of them have been seen."""
    return f"{held / mesh['faces']:.0f}" if held else "–"


def _single_stages(stages):
    text = f"""\
By [gpremesh_bench](../bench/README.md) on {stages['mesh']}; milliseconds, on 1 and 2 threads. Triangles of equal size, and
graded triangles of `--adapt 1`. Names with "paper" belong to the preset paper; "whole" runs from memory to memory.

"""
    columns = ["uniform-1", "uniform-2", "graded-1", "graded-2"]
    rows = [[name] + [f"{times[c]:.2f}" if c in times else "–" for c in columns]
            for name, times in stages["rows"].items()]
    return text + table(["stage", "even, 1", "even, 2", "graded, 1", "graded, 2"], rows)


def _circumstances(data):
    facts = data["circumstances"]
    package = f", {data['package']}" if data.get("package") else ""
    return f"""\
{circumstances.sentence_on_machine(facts)}, {facts['memory']}; {circumstances.sentence_on_build(facts)}; vcglib of MeshLab 2020.09;
meshoptimizer {facts['meshoptimizer']}{package}; commit {facts['commit']}; {facts['date']}. Made by `{data['command']}`.
""" + circumstances.sentence_on_load(facts)
