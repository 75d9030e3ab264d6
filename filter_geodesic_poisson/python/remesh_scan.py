#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remeshes a scan with PyMeshLab and says how well: load, remesh, measure, save.

    python3 remesh_scan.py SCAN RESULT [PERCENT]
"""

import sys

import pymeshlab

import gpremesh_pymeshlab  # loads the plugin


def distance(meshes, sampled, target):
    """Root mean square and largest distance from one mesh to another, in % of the diagonal."""
    found = meshes.get_hausdorff_distance(
        sampledmesh=sampled, targetmesh=target, samplenum=100000, maxdist=pymeshlab.PercentageValue(100))
    return [100 * found[key] / found["diag_mesh_0"] for key in ("RMS", "max")]


def main(scan, result, percent=10.0):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(scan)  # layer 0
    figures = meshes.meshing_geodesic_poisson_disk_remeshing(targetperc=percent, newlayer=True)
    print("{:.0f} vertices, {:.0f} faces in {:.2f} s".format(
        figures["vertex_number"], figures["face_number"], figures["seconds"]))
    print("mean 2r/R {:.4f}, angles {:.1f} to {:.1f} degrees".format(
        figures["mean_radius_ratio"], figures["min_angle"], figures["max_angle"]))
    for text, pair in (("scan to result", (0, 1)), ("result to scan", (1, 0))):
        print("{}: RMS {:.4f} %, at most {:.4f} % of the diagonal".format(text, *distance(meshes, *pair)))
    meshes.set_current_mesh(1)
    meshes.save_current_mesh(result)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], *map(float, sys.argv[3:]))
