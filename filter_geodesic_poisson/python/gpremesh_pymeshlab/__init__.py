# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geodesic Poisson-disk remeshing for PyMeshLab 2025.7.

Importing this module loads the plugin that lies beside it, or the one that the environment variable
GPREMESH_PLUGIN names, and gives pymeshlab.MeshSet a method for each of its filters:

    import pymeshlab
    import gpremesh_pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh("scan.ply")
    figures = meshes.meshing_geodesic_poisson_disk_remeshing(targetvertexnum=20000)
    meshes.save_current_mesh("regular.ply")
"""

import os
import pathlib

import pymeshlab

#: The filters, by their names in Python.
FILTERS = (
    "meshing_geodesic_poisson_disk_remeshing",
    "generate_sampling_geodesic_poisson_disk",
    "meshing_retriangulate_from_samples",
    "compute_features_by_second_order_difference",
    "generate_geodesic_poisson_disk_vs_quadric_edge_collapse",
)


def plugin_file():
    """The plugin that is loaded: it must be built for this PyMeshLab's version and scalar."""
    beside = pathlib.Path(__file__).resolve().parent / "libfilter_geodesic_poisson.so"
    return os.environ.get("GPREMESH_PLUGIN", str(beside))


# PyMeshLab 2025.7 writes its next messages into the log of the MeshSet whose filter failed last, also
# when that is gone, which ends in a crash. So it is kept until a filter has done its work.
_failed = None


def _method(name):
    def apply(self, **parameters):
        global _failed
        _failed = self
        figures = self.apply_filter(name, **parameters)
        _failed = None
        return figures

    apply.__name__ = name
    return apply


def _load():
    # Loaded by hand before, or this module again: a plugin can be loaded once only.
    if FILTERS[0] not in pymeshlab.filter_list():
        pymeshlab.load_plugin(plugin_file())
    for name in FILTERS:
        setattr(pymeshlab.MeshSet, name, _method(name))


_load()
