# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the study of simulation: histograms of dihedral angles."""

from .simulation_page import TOOL_NAMES, done_by_all

BIN_DEGREES = 5  # as simulation_tasks.py counts
COLOURS = ("#1f77b4", "#17becf", "#2ca02c", "#9467bd", "#d62728", "#ff7f0e", "#bcbd22")


def pooled(data, method, tool):
    """The counts of all models that every method has done with that tool; empty where there is none."""
    histograms = [mesh["results"][method][tool]["histogram"] for mesh in done_by_all(data, tool)]
    return [sum(counts) for counts in zip(*histograms)]


def draw(data, path):
    """Shares of dihedral angles by method, a panel a tool. False where matplotlib is missing, or a model
    that all methods have done."""
    tools = [tool for tool in data["tools"] if pooled(data, data["methods"][0][0], tool)]
    try:
        import matplotlib
    except ImportError:
        return False
    if not tools:
        return False
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, panels = pyplot.subplots(1, len(tools), figsize=(4.4 * len(tools), 4.2), dpi=100, squeeze=False,
                                     sharey=True)
    for axes, tool in zip(panels[0], tools):
        _draw_tool(axes, data, tool)
    panels[0][0].set_ylabel("share of the dihedral angles, %")
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=4, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.12, 1, 1))
    figure.savefig(path, metadata={"Software": None})
    pyplot.close(figure)
    return True


def _draw_tool(axes, data, tool):
    for (key, label), colour in zip(data["methods"], COLOURS):
        counts = pooled(data, key, tool)
        edges = [BIN_DEGREES * i for i in range(len(counts) + 1)]
        axes.stairs([100 * count / sum(counts) for count in counts], edges, label=label, color=colour,
                    baseline=None, linewidth=1.6 if key == "gpremesh" else 1)
    axes.set_yscale("log")
    axes.set_xlim(0, 180)
    axes.set_xticks(range(0, 181, 30), [f"{angle}°" for angle in range(0, 181, 30)])
    axes.set_title(TOOL_NAMES[tool], fontsize=9)
    axes.grid(True, which="major", linewidth=0.4, color="#cccccc")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
