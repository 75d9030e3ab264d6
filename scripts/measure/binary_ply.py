# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the binary PLY files that gpremesh and gpr_big_mesh write, and writes such files."""

FACE = [("n", "u1"), ("v", "<i4", 3)]


def arrays_of(path):
    """Positions and triangles of a binary PLY file without other properties than these."""
    import numpy as np

    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode().splitlines()
    count = {line.split()[1]: int(line.split()[2]) for line in header if line.startswith("element")}
    real = "<f8" if "property double x" in header else "<f4"
    vertices = np.frombuffer(data, real, 3 * count["vertex"], end).reshape(-1, 3)
    faces = np.frombuffer(data, np.dtype(FACE), count["face"], end + vertices.nbytes)
    return vertices, np.ascontiguousarray(faces["v"])


def write_arrays(path, vertices, faces):
    """Positions as float, and triangles."""
    import numpy as np

    properties = "".join(f"property float {axis}\n" for axis in "xyz")
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n{properties}"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    rows = np.empty(len(faces), np.dtype(FACE))
    rows["n"] = 3
    rows["v"] = faces
    path.write_bytes(header.encode() + vertices.astype("<f4").tobytes() + rows.tobytes())
