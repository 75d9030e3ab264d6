# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the growth with size and threads."""

from .statistics_of_runs import amdahl, bandwidth_seconds, growth_of, parallel_share, spread_of

COLOURS = {"default": "#1f77b4", "fast": "#2ca02c", "meshoptimizer": "#ff7f0e", "meshoptimizer-pypi": "#9467bd",
           "meshoptimizer-pypi-regular": "#8c564b", "quadric": "#d62728"}
LIMIT = {"color": "#555555", "linestyle": ":", "linewidth": 1.4}
MOST_THREADS_BY_FACES = 2  # drawn by the number of faces; more are in the panel of the threads
THREADS_OF_AMDAHL = (1, 2, 4, 8, 16, 32, 64)


def draw(meshes, methods, bandwidth, path):
    """Seconds by faces and by threads, and bytes a face. False where matplotlib is missing. bandwidth: bytes a second,
    or None."""
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (time_axes, thread_axes, memory_axes) = pyplot.subplots(1, 3, figsize=(16, 5), dpi=100)
    for method in methods:
        if method.threads <= MOST_THREADS_BY_FACES:
            _draw_method(time_axes, memory_axes, meshes, method)
    if bandwidth:
        _draw_limit(time_axes, meshes, bandwidth)
    _draw_threads(thread_axes, meshes[-1], methods, bandwidth)
    seconds = "seconds, from mesh in memory to mesh in memory"
    _label_faces(time_axes, meshes, seconds)
    _label_threads(thread_axes, meshes[-1], seconds)
    _label_faces(memory_axes, meshes, "peak memory of the program, bytes a face of the input")
    figure.legend(*time_axes.get_legend_handles_labels(), loc="lower center", ncol=3, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.13, 1, 1))
    figure.savefig(path, metadata={"Software": None})
    pyplot.close(figure)
    return True


# ---- by faces


def _draw_method(time_axes, memory_axes, meshes, method):
    measured = [mesh for mesh in meshes if mesh["runs"].get(method.key)]
    if not measured:
        return
    faces = [mesh["faces"] for mesh in measured]
    look = {
        "color": COLOURS[method.preset or method.key],
        "linestyle": "--" if method.preset and method.threads == 1 else "-",
        "marker": "o", "markersize": 4, "linewidth": 1.4}
    seconds = [spread_of(mesh, method.key, "seconds") for mesh in measured]
    time_axes.plot(faces, [s.median for s in seconds], label=_legend(meshes, method), **look)
    time_axes.vlines(faces, [s.low for s in seconds], [s.high for s in seconds],
                     color=look["color"], linewidth=0.8)
    peaks = [spread_of(mesh, method.key, "peak").median / mesh["faces"] for mesh in measured]
    memory_axes.plot(faces, peaks, **look)


def _draw_limit(axes, meshes, bandwidth):
    axes.plot([mesh["faces"] for mesh in meshes], [bandwidth_seconds(mesh, bandwidth) for mesh in meshes],
              label="bandwidth: the arrays of fast, read and written once", **LIMIT)


def _legend(meshes, method):
    threads = f", {method.threads} thread{'s' if method.threads > 1 else ''}" if method.preset else ""
    fitted = growth_of(meshes, method.key, "seconds")
    exponent = f"  ~ faces^{fitted[1]:.2f}" if fitted else ""
    return method.label + threads + exponent


# ---- by threads


def _draw_threads(axes, mesh, methods, bandwidth):
    """What was measured as dots, Amdahl's law by the first two of them as a line."""
    for preset in ("default", "fast"):
        measured = {method.threads: spread_of(mesh, method.key, "seconds").median
                    for method in methods if method.preset == preset and mesh["runs"].get(method.key)}
        colour = COLOURS[preset]
        share = parallel_share(measured[1], measured[2])
        law = [measured[1] / amdahl(share, threads) for threads in THREADS_OF_AMDAHL]
        axes.plot(THREADS_OF_AMDAHL, law, color=colour, linestyle="--", linewidth=1)
        axes.plot(list(measured), list(measured.values()), color=colour, linestyle="", marker="o", markersize=5)
        axes.annotate(f"{preset}, {100 * min(share, 1):.0f} % parallel", (4, law[2]), xytext=(4, 4),
                      textcoords="offset points", color=colour, fontsize=8)
    if bandwidth:
        axes.axhline(bandwidth_seconds(mesh, bandwidth), **LIMIT)


# ---- axes


def _label_faces(axes, meshes, what):
    _label(axes, what)
    axes.set_xticks([mesh["faces"] for mesh in meshes],
                    [f"{mesh['faces'] / 1e6:.2g} M" for mesh in meshes])
    axes.minorticks_off()
    axes.set_xlabel("faces of the input")


def _label_threads(axes, mesh, what):
    _label(axes, what)
    axes.set_xticks(THREADS_OF_AMDAHL, list(map(str, THREADS_OF_AMDAHL)))
    axes.minorticks_off()
    axes.set_xlabel(f"threads, {mesh['faces'] / 1e6:.2g} M faces; dots measured, lines by Amdahl's law")


def _label(axes, what):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(_ticks())
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_ylabel(what, fontsize=9)
    axes.grid(True, which="major", linewidth=0.4, color="#cccccc")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _ticks():
    from matplotlib.ticker import LogLocator
    return LogLocator(subs=(1, 2, 5))
