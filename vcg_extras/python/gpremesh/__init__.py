# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geodesic Poisson-disk remeshing.

Remeshes a dense triangle mesh, such as a scan, to nearly equilateral triangles with exactly as many
vertices as you ask for. Crease edges and borders are kept.

>>> import numpy as np, gpremesh
>>> i, j = np.meshgrid(np.arange(200), np.arange(100), indexing="ij")  # a torus of quads
>>> a, b = i * np.pi / 100, j * np.pi / 50
>>> x, y, z = (3 + np.cos(b)) * np.cos(a), (3 + np.cos(b)) * np.sin(a), np.sin(b)
>>> vertices = np.stack([x, y, z], axis=-1).reshape(-1, 3)
>>> k, l = (i + 1) % 200, (j + 1) % 100
>>> quads = np.stack([i * 100 + j, k * 100 + j, k * 100 + l, i * 100 + l], axis=-1).reshape(-1, 4)
>>> result = gpremesh.remesh(vertices, quads, vertex_count=500)
>>> result.vertices.shape, result.faces.shape
((500, 3), (1000, 3))
>>> result.report["quality"]["angles"]["min"] > 25  # degrees
True
>>> heights = result.transfer(vertices[:, 2], "vertex")  # any values of the input's vertices
>>> heights.shape
(500,)
"""

import importlib

from ._api import distance, features, remesh, remesh_together, sample
from ._core import version as __version__
from ._errors import Error
from ._files import FileMesh, read, write
from ._results import Distance, Features, OneWayDistance, RemeshResult, Samples
from ._surface import Surface, levels

__all__ = [
    "Distance", "Error", "Features", "FileMesh", "OneWayDistance", "RemeshResult", "Samples", "Surface",
    "distance", "features", "levels", "read", "remesh", "remesh_together", "sample", "write",
]

for _name in __all__:  # the public module, for help texts
    globals()[_name].__module__ = __name__
del _name

_HOSTS = ("open3d", "pyvista", "trimesh")


def __getattr__(name):
    """Imports the module for another package, and so the package, on first use."""
    if name in _HOSTS:
        return importlib.import_module("." + name, __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
