# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the binary PLY files that gpremesh and gpr_big_mesh write."""


def arrays_of(path):
    """Positions and triangles of a binary PLY file without other properties than these."""
    import numpy as np

    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode().splitlines()
    count = {line.split()[1]: int(line.split()[2]) for line in header if line.startswith("element")}
    real = "<f8" if "property double x" in header else "<f4"
    vertices = np.frombuffer(data, real, 3 * count["vertex"], end).reshape(-1, 3)
    faces = np.frombuffer(data, np.dtype([("n", "u1"), ("v", "<i4", 3)]), count["face"], end + vertices.nbytes)
    return vertices, np.ascontiguousarray(faces["v"])
