# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians, spreads, ratios and growth of what was measured."""

import math
from statistics import linear_regression, median


class Spread:
    """Median, smallest and largest of some figures."""

    def __init__(self, values):
        self.values = list(values)
        self.median = median(self.values)
        self.low = min(self.values)
        self.high = max(self.values)

    def text(self, number_format="{:.3f}"):
        middle, low, high = (number_format.format(x) for x in (self.median, self.low, self.high))
        return middle if len(self.values) == 1 else f"{middle} ({low}–{high})"


def spread_of(mesh, method, figure):
    """None where the method was not run on the mesh."""
    runs = mesh["runs"].get(method, [])
    return Spread(run[figure] for run in runs) if runs else None


def ratio_of(mesh, slower, faster):
    """How many times the seconds of `faster` those of `slower` are, round by round: what changes on
    the machine from round to round changes both."""
    pairs = list(zip(mesh["runs"].get(slower, []), mesh["runs"].get(faster, [])))
    return Spread(a["seconds"] / b["seconds"] for a, b in pairs) if pairs else None


def has_same_bytes(mesh, preset):
    """Whether all runs of a preset of gpremesh, with any number of threads, made the same file."""
    runs = [run for key, runs in mesh["runs"].items() if key.startswith(f"{preset}-") for run in runs]
    return len({run["digest"] for run in runs}) == 1


def overhead_of(mesh, method):
    """Wall time of the whole program over the engine's own seconds."""
    runs = mesh["runs"].get(method, [])
    return Spread(run["wall"] / run["seconds"] for run in runs) if runs else None


def parallel_share(one, two):
    """The share of the work that a second thread halves, by Amdahl's law; 0 where it was none."""
    return max(0, 2 * (1 - two / one))


def amdahl(share, core_num):
    """How many times faster so many cores are at most, if they divide this share of the work evenly. A share above 1
    is noise."""
    share = min(share, 1)
    return 1 / (1 - share + share / core_num)


def bandwidth_seconds(mesh, bandwidth):
    """The time in which memory of so many bytes a second writes once and reads once what fast holds at its peak."""
    return 2 * spread_of(mesh, "fast-2", "peak").median / bandwidth


def growth(points):
    """(a, b) of a · x^b through the points by least squares of the logarithms; None for fewer than
    two of them."""
    if len(points) < 2:
        return None
    line = linear_regression([math.log(x) for x, _ in points], [math.log(y) for _, y in points])
    return math.exp(line.intercept), line.slope


def growth_of(meshes, method, figure):
    points = [(mesh["faces"], spread_of(mesh, method, figure).median)
              for mesh in meshes if mesh["runs"].get(method)]
    return growth(points)


def line_through(points):
    """(offset, slope) by least squares, weighted so that each point counts for its share: peak memory
    is what the program needs anyway, and something for every face."""
    if len(points) < 2:
        return None
    weights = [1 / (y * y) for _, y in points]
    total = sum(weights)
    mean_x = sum(w * x for w, (x, _) in zip(weights, points)) / total
    mean_y = sum(w * y for w, (_, y) in zip(weights, points)) / total
    across = sum(w * (x - mean_x) ** 2 for w, (x, _) in zip(weights, points))
    along = sum(w * (x - mean_x) * (y - mean_y) for w, (x, y) in zip(weights, points))
    return mean_y - along / across * mean_x, along / across


def memory_of(meshes, method):
    points = [(mesh["faces"], spread_of(mesh, method, "peak").median)
              for mesh in meshes if mesh["runs"].get(method)]
    return line_through(points)
