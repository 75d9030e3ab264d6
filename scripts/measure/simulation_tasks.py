# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The single steps of the study of simulation. Each one runs in a process of its own, because meshers of
volumes can crash, run without end or use up the memory.

    python3 -m measure.simulation_tasks FIGURES TASK ARGUMENTS

The figures go to the file FIGURES, as JSON; {"failure": SENTENCE} where a library refuses the mesh.

    input IN OUT                            a mesh of any format, welded, as PLY; whether it suits the study
    remesh METHOD IN OUT VERTICES FACES     one of REMESHERS
    surface IN MODEL                        angles, distance and the Poisson problem
    volume TOOL IN                          one of VOLUME_MESHERS
"""

import hashlib
import json
import os
import resource
import sys
import time
from pathlib import Path

import numpy as np

MOST_MEMORY = 12 << 30
BIN_DEGREES = 5  # of the histogram of dihedral angles


# ---- files


def read(path):
    """Of a PLY file of triangles: positions as double, faces as int32."""
    import pyvista

    mesh = pyvista.read(path)
    return np.ascontiguousarray(mesh.points, float), np.ascontiguousarray(mesh.regular_faces, np.int32)


def read_any(path):
    """Of a file of any format; MeshLab cuts what is no triangle into triangles."""
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(path)
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def only_used(vertices, faces):
    """The vertices that are in use, as float, and the faces with their new numbers."""
    used, numbers = np.unique(faces, return_inverse=True)
    return np.asarray(vertices, np.float32)[used], numbers.reshape(-1, 3)


def write(path, vertices, faces):
    import pyvista

    pyvista.PolyData.from_regular_faces(*only_used(vertices, faces)).save(path)


def welded(vertices, faces):
    """Vertices of the same place become one; a face that loses a corner by that is left out."""
    _, first, numbers = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
    faces = first[numbers.reshape(-1)][faces].astype(np.int32)
    return vertices, faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]


def is_closed(faces):
    """Whether every edge is that of two faces, once in either direction."""
    edges = np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)])
    forth = np.unique(edges, axis=0)
    back = np.unique(edges[:, ::-1], axis=0)
    return len(forth) == len(edges) and np.array_equal(forth, back)


def component_numbers(vertex_num, faces):
    """How many components there are, and that of each vertex."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    ends = (faces.ravel(), np.roll(faces, 1, axis=1).ravel())
    return connected_components(coo_matrix((np.ones(faces.size), ends), (vertex_num, vertex_num)), False)


def take_input(source, target):
    """Whether a mesh is closed, connected and free of intersections; only such a mesh bounds a volume."""
    write(target, *welded(*read_any(source)))
    vertices, faces = read(target)
    figures = {"vertices": len(vertices), "faces": len(faces), "closed": is_closed(faces),
               "components": int(component_numbers(len(vertices), faces)[0]),
               "digest": hashlib.sha256(Path(target).read_bytes()).hexdigest()}
    if figures["closed"] and figures["components"] == 1:
        figures["refusal"] = refusal_of_tetgen(vertices, faces)
    return figures


def refusal_of_tetgen(vertices, faces):
    """What TetGen says to the surface as it is; empty where it takes it."""
    try:
        by_tetgen(quality=False)(vertices, faces)
    except RuntimeError as error:
        return sentence(error)
    return ""


def sentence(error):
    words = " ".join(str(error).split())
    return words[:120] or type(error).__name__


# ---- remeshers


def by_pyacvd(vertices, faces, vertex_goal, _):
    import pyacvd
    import pyvista

    clustering = pyacvd.Clustering(pyvista.PolyData.from_regular_faces(vertices, faces))
    # Its own advice: clusters need some ten vertices each.
    pieces = int(np.ceil(np.sqrt(10 * vertex_goal / len(vertices))))
    if pieces > 1:
        clustering.subdivide(min(pieces, 3))
    clustering.cluster(vertex_goal)
    made = clustering.create_mesh()
    return made.points, made.regular_faces


def by_quadric_edge_collapse(vertices, faces, _, face_goal):
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(vertices, faces))
    meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=face_goal)
    made = meshes.current_mesh()
    return made.vertex_matrix(), made.face_matrix()


def by_meshoptimizer(regular):
    def run(vertices, faces, _, face_goal):
        import almeshopt

        indices, _ = almeshopt.simplify(
            np.ascontiguousarray(faces.ravel(), np.uint32), np.ascontiguousarray(vertices, np.float32),
            target_count=3 * face_goal, target_error=1e9,
            options=almeshopt.SIMPLIFY_REGULARIZE if regular else 0)
        return vertices, indices.reshape(-1, 3)

    return run


REMESHERS = {
    "pyacvd": by_pyacvd,
    "quadric": by_quadric_edge_collapse,
    "meshoptimizer": by_meshoptimizer(False),
    "meshoptimizer-regular": by_meshoptimizer(True),
}


def remesh(method, source, target, vertex_goal, face_goal):
    vertices, faces = REMESHERS[method](*read(source), int(vertex_goal), int(face_goal))
    if len(faces) == 0:
        return {"failure": "no face was left"}
    write(target, vertices, faces)
    return {}


# ---- surfaces


def corner_angles(vertices, faces):
    """Degrees, a row a face."""
    angles = []
    for k in range(3):
        apex, left, right = (vertices[faces[:, (k + j) % 3]] for j in range(3))
        normal = np.linalg.norm(np.cross(left - apex, right - apex), axis=1)
        angles.append(np.degrees(np.arctan2(normal, ((left - apex) * (right - apex)).sum(axis=1))))
    return np.stack(angles, axis=1)


def enclosed_volume(vertices, faces):
    """Negative where the faces look inwards."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return float((np.cross(a, b) * c).sum() / 6)


def distance_from_model(vertices, faces, model):
    """Root mean square and largest distance from samples of the model to the result, percent of the
    model's diagonal."""
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    for points, triangles in (read(model), (vertices, faces)):
        meshes.add_mesh(pymeshlab.Mesh(points, triangles))
    far = meshes.get_hausdorff_distance(sampledmesh=0, targetmesh=1, sampleface=True, samplenum=100000,
                                        maxdist=pymeshlab.PercentageValue(100))
    percent = 100 / far["diag_mesh_0"]
    return percent * far["RMS"], percent * far["max"]


def surface(source, model):
    from . import poisson

    vertices, faces = read(source)
    angles = corner_angles(vertices, faces)
    root_mean_square, largest = distance_from_model(vertices, faces, model)
    return {
        "vertices": len(vertices), "faces": len(faces), "closed": is_closed(faces),
        "smallestAngle": float(angles.min()), "largestAngle": float(angles.max()),
        "below30Percent": float(100 * (angles.min(axis=1) < 30).mean()),
        "rmsPercent": float(root_mean_square), "largestDistancePercent": float(largest),
        **poisson.figures(vertices, faces, component_numbers(len(vertices), faces))}


# ---- volumes


def by_tetgen(**options):
    def run(vertices, faces):
        import tetgen

        made = tetgen.TetGen(vertices, faces).tetrahedralize(**options)
        return made[0], made[1]

    return run


def by_ftetwild(vertices, faces):
    import pytetwild

    return pytetwild.tetrahedralize(vertices, faces, num_threads=1)


# The radius-edge ratio of TetGen's manual for good meshes, and the dihedral angle of the package's.
TETGEN_QUALITY = {"minratio": 1.414, "mindihedral": 10}
VOLUME_MESHERS = {
    "tetgen-kept": by_tetgen(nobisect=True, **TETGEN_QUALITY),
    "tetgen-free": by_tetgen(**TETGEN_QUALITY),
    "ftetwild": by_ftetwild,
}


def dihedral_angles(points, tetrahedra):
    """Degrees, six a row; the faces' normals point to one side of each tetrahedron, all in or all out."""
    corners = points[tetrahedra]
    normals = []
    for a, b, c in ((1, 3, 2), (0, 2, 3), (0, 3, 1), (0, 1, 2)):
        normal = np.cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a])
        length = np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), np.finfo(float).tiny)
        normals.append(normal / length)
    cosines = [-(normals[i] * normals[j]).sum(axis=1) for i in range(4) for j in range(i)]
    return np.degrees(np.arccos(np.clip(np.stack(cosines, axis=1), -1, 1)))


def volume_of(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, k]] for k in range(4))
    return float(np.abs((np.cross(b - a, c - a) * (d - a)).sum(axis=1)).sum() / 6)


def volume(tool, source):
    vertices, faces = read(source)
    os.chdir(Path(source).resolve().parent)  # both meshers write files of their own where they are
    start = time.process_time()
    points, tetrahedra = VOLUME_MESHERS[tool](vertices, faces)
    seconds = time.process_time() - start
    if len(tetrahedra) == 0:
        return {"failure": "no tetrahedron was made"}
    angles = dihedral_angles(points, tetrahedra)
    counts, _ = np.histogram(angles, bins=180 // BIN_DEGREES, range=(0, 180))
    return {
        "tetrahedra": len(tetrahedra), "points": len(points), "seconds": seconds,
        "smallestDihedral": float(angles.min()), "largestDihedral": float(angles.max()),
        "below10Percent": float(100 * (angles.min(axis=1) < 10).mean()),
        "volumeShare": volume_of(points, tetrahedra) / abs(enclosed_volume(vertices, faces)),
        "histogram": counts.tolist()}


# ---- the process


TASKS = {"input": take_input, "remesh": remesh, "surface": surface, "volume": volume}


def main(target, task, *arguments):
    """What a library raises is its answer to the mesh, whatever the type."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    target = Path(target).resolve()
    try:
        figures = TASKS[task](*arguments)
    except Exception as error:
        figures = {"failure": sentence(error)}
    target.write_text(json.dumps(figures))


if __name__ == "__main__":
    main(*sys.argv[1:])
