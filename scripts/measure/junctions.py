#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of the junctions of a mesh: compares input and result of `--junctions keep`.

    scripts/measure/junctions.py IN OUT

Reads PLY (binary little endian or ASCII) and OBJ. Prints the edges by their number of faces, the length of
all edges with more than two, the open edges and faces of each label pair's bodies, and the angles.
"""
import sys
from collections import Counter

import numpy as np

SIZES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
         "float": "f4", "double": "f8", "int32": "i4", "uint8": "u1", "float32": "f4", "float64": "f8"}


def read_obj(path):
    points, faces = [], []
    for line in open(path):
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(w) for w in words[1:4]])
        elif words[:1] == ["f"]:
            faces.append([int(w.split("/")[0]) - 1 for w in words[1:4]])
    return np.array(points), np.array(faces), {}


def read_ply(path):
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + 11
    elements = []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    offset, out = end, {}
    for name, num, properties in elements:
        fields = []
        for p in properties:
            if p[0] == "list":
                fields += [("n", SIZES[p[1]]), ("corner", SIZES[p[2]], 3)]
            else:
                fields.append((p[1], "<" + SIZES[p[0]]))
        table = np.frombuffer(data, np.dtype(fields), num, offset)
        offset += table.nbytes
        out[name] = table
    v, f = out["vertex"], out["face"]
    labels = {n: f[n] for n in f.dtype.names if n not in ("n", "corner")}
    return np.stack([v["x"], v["y"], v["z"]], 1).astype(float), f["corner"].astype(int), labels


def read(path):
    return read_obj(path) if path.endswith(".obj") else read_ply(path)


def edges_of(faces):
    e = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.sort(e, 1)


def junctions(points, faces):
    edges, num = np.unique(edges_of(faces), axis=0, return_counts=True)
    of_many = edges[num > 2]
    length = np.linalg.norm(points[of_many[:, 0]] - points[of_many[:, 1]], axis=1).sum()
    return {"edges by faces": dict(sorted(Counter(num.tolist()).items())),
            "junction length": float(length), "junction vertices": len(np.unique(of_many))}


def smallest_angle(points, faces):
    worst = 180.0
    for k in range(3):
        a, b, c = (points[faces[:, (k + i) % 3]] for i in range(3))
        u, w = b - a, c - a
        cosine = (u * w).sum(1) / np.linalg.norm(u, axis=1) / np.linalg.norm(w, axis=1)
        worst = min(worst, float(np.degrees(np.arccos(np.clip(cosine, -1, 1))).min()))
    return worst


def bodies(points, faces, labels):
    """Open edges, edges with two faces of one direction, and volume of each grain."""
    inner, outer = labels["label_in"], labels["label_out"]
    out = {}
    for label in sorted(set(inner.tolist()) | set(outer.tolist())):
        own = np.concatenate([faces[inner == label], faces[outer == label][:, ::-1]])
        directed = np.concatenate([own[:, [0, 1]], own[:, [1, 2]], own[:, [2, 0]]])
        balance = Counter(map(tuple, directed.tolist()))
        unpaired = sum(max(0, n - balance.get((b, a), 0)) for (a, b), n in balance.items())
        t = points[own]
        volume = np.einsum("ij,ij->i", t[:, 0], np.cross(t[:, 1], t[:, 2])).sum() / 6
        out[label] = (unpaired, round(float(volume), 1))
    return out


def main():
    for path in sys.argv[1:]:
        points, faces, labels = read(path)
        print(path, len(points), "vertices", len(faces), "faces")
        for key, value in junctions(points, faces).items():
            print("   ", key, value)
        print("    smallest angle", round(smallest_angle(points, faces), 2))
        if "label_in" in labels:
            print("    (unpaired edges, volume) by label", bodies(points, faces, labels))


main()
