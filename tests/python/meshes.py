# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes made in code, and PLY files as the command line reads and writes them."""

import subprocess
from pathlib import Path

import numpy as np

import gpremesh.__main__


def torus(around=60, across=30, dtype=np.float64):
    """A closed mesh with one handle: vertices and triangles (int32)."""
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * i / around, 2 * np.pi * j / across
    points = np.stack([(3 + np.cos(b)) * np.cos(a), (3 + np.cos(b)) * np.sin(a), np.sin(b)], axis=-1)
    k, l = (i + 1) % around, (j + 1) % across
    quads = np.stack([i * across + j, k * across + j, k * across + l, i * across + l], axis=-1)
    return points.reshape(-1, 3).astype(dtype), triangles_of(quads.reshape(-1, 4))


def sheet(side=30):
    """An open mesh, a wavy square of quads: vertices and quads (int64)."""
    x, y = np.meshgrid(np.arange(side + 1.0), np.arange(side + 1.0), indexing="ij")
    points = np.stack([x, y, np.sin(x / 6) + np.cos(y / 5)], axis=-1).reshape(-1, 3)
    first = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).reshape(-1, 1)
    return points, first + np.array([0, side + 1, side + 2, 1])


def cube(steps=12):
    """A cube with sharp edges, of squares of its sides: vertices and triangles (int32)."""
    i, j = np.meshgrid(np.arange(steps), np.arange(steps), indexing="ij")
    corners = np.stack([np.stack([i + a, j + b], -1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))], -2)
    quads = corners.reshape(-1, 4, 2)
    sides = []
    for axis in range(3):
        for level in (0, steps):
            points = np.insert(quads, axis, level, axis=2)
            sides.append(points if (level == 0) == (axis == 1) else points[:, ::-1])
    points, index = np.unique(np.concatenate(sides).reshape(-1, 3), axis=0, return_inverse=True)
    return points / steps, triangles_of(index.reshape(-1, 4))


def triangles_of(quads):
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int32, order="C")


def write_ply(path, vertices, faces):
    real = "double" if vertices.dtype == np.float64 else "float"
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
            f"property {real} x\nproperty {real} y\nproperty {real} z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    rows = np.zeros(len(faces), dtype=[("size", "u1"), ("corner", "<i4", (faces.shape[1],))])
    rows["size"], rows["corner"] = faces.shape[1], faces
    Path(path).write_bytes(head.encode() + vertices.tobytes() + rows.tobytes())


def read_ply(path):
    """Coordinates and triangles of a binary PLY file that has nothing else."""
    content = Path(path).read_bytes()
    end = content.index(b"end_header\n") + len(b"end_header\n")
    head = content[:end].decode()
    vertex_num, face_num = (int(head.split(f"element {name} ")[1].split()[0]) for name in ("vertex", "face"))
    real = np.dtype("<f8" if "property double x" in head else "<f4")
    vertices = np.frombuffer(content, real, 3 * vertex_num, offset=end).reshape(-1, 3)
    row = np.dtype([("size", "u1"), ("corner", "<i4", (3,))])
    faces = np.frombuffer(content, row, face_num, offset=end + vertices.nbytes)
    return vertices, np.ascontiguousarray(faces["corner"])


def command_line(*words):
    """Runs the program that the package brings."""
    return subprocess.run([gpremesh.__main__.program(), *map(str, words)], check=True, capture_output=True,
                          text=True, timeout=300)


def is_closed_manifold(faces):
    """Whether each edge has one face on each side."""
    halves = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    once = len(np.unique(halves, axis=0)) == len(halves)
    return once and {tuple(e) for e in halves} == {tuple(e[::-1]) for e in halves}
