# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the growth with size."""

from .statistics_of_runs import growth_of, spread_of

COLOURS = {"default": "#1f77b4", "fast": "#2ca02c", "meshoptimizer": "#ff7f0e", "quadric": "#d62728"}


def draw(meshes, methods, path):
    """Seconds and bytes a face over the number of faces. False where matplotlib is missing."""
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (time_axes, memory_axes) = pyplot.subplots(1, 2, figsize=(11, 4.6), dpi=100)
    for method in methods:
        _draw_method(time_axes, memory_axes, meshes, method)
    _label(time_axes, meshes, "seconds, from mesh in memory to mesh in memory")
    _label(memory_axes, meshes, "peak memory of the program, bytes a face of the input")
    figure.legend(loc="lower center", ncol=3, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.1, 1, 1))
    figure.savefig(path, metadata={"Software": None})
    pyplot.close(figure)
    return True


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


def _legend(meshes, method):
    threads = f", {method.threads} thread{'s' if method.threads > 1 else ''}" if method.preset else ""
    fitted = growth_of(meshes, method.key, "seconds")
    exponent = f"  ~ faces^{fitted[1]:.2f}" if fitted else ""
    return method.label + threads + exponent


def _label(axes, meshes, what):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xticks([mesh["faces"] for mesh in meshes],
                    [f"{mesh['faces'] / 1e6:.2g} M" for mesh in meshes])
    axes.minorticks_off()
    axes.yaxis.set_major_locator(_ticks())
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_xlabel("faces of the input")
    axes.set_ylabel(what, fontsize=9)
    axes.grid(True, which="major", linewidth=0.4, color="#cccccc")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _ticks():
    from matplotlib.ticker import LogLocator
    return LogLocator(subs=(1, 2, 5))
