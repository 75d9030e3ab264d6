# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks arguments and makes arrays for the engine, without a copy if possible: float32 or float64 coordinates
and int32 indices in C order. Other types are converted. An unusable argument raises a ValueError with the name of
the argument."""

import numpy as np

from . import _core

_MOST = 2**31 - 1  # vertices or faces, as the engine counts with int32


def _array(name, values):
    try:
        return np.asarray(values)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} is no array: {error}") from None


def _in_order(array, dtype):
    """The array in C order with the dtype; the same array if nothing changes."""
    return np.require(array, dtype=dtype, requirements=("C_CONTIGUOUS", "ALIGNED"))


def _numbers(name, values, shape, dtype):
    """Finite real numbers; `shape`, checked by the caller, is text for the message."""
    if values.dtype.kind not in "fiu":
        raise ValueError(f"{name} must be real numbers of shape {shape}, not {values.dtype}.")
    # Minimum and maximum are finite only if all values are; this test makes no array.
    if values.size and not (np.isfinite(values.min()) and np.isfinite(values.max())):
        raise ValueError(f"{name} has values that are not finite.")
    with np.errstate(over="ignore"):
        numbers = _in_order(values, dtype)
    if numbers.dtype != values.dtype and numbers.size and not np.isfinite(np.abs(numbers).max()):
        raise ValueError(f"{name} has values too large for {numbers.dtype}.")
    return numbers


def coordinates(name, values):
    """Points as rows of three."""
    array = _array(name, values)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} must have the shape (n, 3), not {array.shape}.")
    if len(array) > _MOST:
        raise ValueError(f"{name} has more than {_MOST} rows.")
    dtype = np.float32 if array.dtype == np.float32 else np.float64
    return _numbers(name, array, "(n, 3)", dtype)


def indices(name, values, limit):
    """Whole numbers from 0 to limit - 1, as int32."""
    if values.size == 0:
        return np.zeros(values.shape, np.int32)
    if values.dtype.kind not in "iu":
        raise ValueError(f"{name} must be whole numbers, not {values.dtype}.")
    least, most = int(values.min()), int(values.max())
    if least < 0 or most >= limit:
        wrong = least if least < 0 else most
        raise ValueError(f"{name} has the index {wrong}; there are {limit} vertices.")
    return _in_order(values, np.int32)


def mask(name, values, length, what):
    """A bool for each of the elements named by `what`, as bytes for the engine; None stays None."""
    if values is None:
        return None
    array = _array(name, values)
    if array.dtype != bool or array.shape != (length,):
        raise ValueError(f"{name} must be a mask with a bool for each of the {length} {what}, "
                         f"not an array of shape {array.shape} and type {array.dtype}.")
    return _in_order(array, bool).view(np.uint8)


def lengths(name, values, length):
    """A length above 0 for each vertex, as float32; None stays None."""
    if values is None:
        return None
    array = _array(name, values)
    if array.shape != (length,):
        raise ValueError(f"{name} must have a number for each of the {length} vertices, "
                         f"not an array of shape {array.shape}.")
    numbers = _numbers(name, array, "(n,)", np.float32)
    if not (numbers > 0).all():
        raise ValueError(f"{name} must be lengths above 0 in float32.")
    return numbers


def period(name, values):
    """The three lengths of a periodic cell, as a list; None becomes an empty list."""
    if values is None:
        return []
    array = _array(name, values)
    numbers = _numbers(name, array, "(3,)", np.float64)
    if array.shape != (3,) or (numbers < 0).any() or not (numbers > 0).any():
        raise ValueError(f"{name} must be three lengths, at least one length above 0.")
    return numbers.tolist()


def edges(name, values, vertex_num):
    """Edges as pairs of vertices; None stays None."""
    if values is None:
        return None
    array = _array(name, values)
    if array.shape == (0,):  # an empty list
        array = array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"{name} must have the shape (n, 2), not {array.shape}.")
    return indices(name, array, vertex_num)


def _table(faces):
    """Faces with equal numbers of corners, as an array; None for other faces. An empty list means triangles."""
    try:
        array = np.asarray(faces)
    except (TypeError, ValueError):
        return None
    if array.ndim == 1 and array.size == 0:
        return array.reshape(0, 3)
    return array if array.ndim == 2 and array.dtype != object and array.shape[1] else None


def _rows(table):
    return table.reshape(-1), np.full(len(table), table.shape[1])


def _ragged(name, faces):
    """Polygons of several sizes: all corners one after the other, and the sizes."""
    try:
        rows = [np.asarray(face) for face in faces]
    except (TypeError, ValueError):
        rows = []
    if not rows or any(row.ndim != 1 for row in rows):
        raise ValueError(f"{name} must have the shape (n, 3), or be a list of polygons.")
    filled = [row for row in rows if row.size]
    corners = np.concatenate(filled) if filled else np.zeros(0, np.int32)
    return corners, np.array([row.size for row in rows])


class Mesh:
    """The mesh of a caller, as triangles for the engine.

    vertices, faces : float32 or float64 (n, 3), int32 (t, 3): triangles
    index_dtype : dtype of the caller's faces
    face_num : number of the caller's faces
    corners : for each corner of a triangle, the corner of the caller's faces; None: the same corners
    sizes : with `corners`, the number of corners of each of the caller's faces
    face_of : for each triangle, the face of the caller; None: the same faces
    """

    def __init__(self, vertices, faces, names=("vertices", "faces")):
        name = names[1]
        self.vertices = coordinates(names[0], vertices)
        self.corners = self.sizes = self.face_of = None
        table = _table(faces)
        if table is not None and table.shape[1] == 3:
            self.face_num = len(table)
            self._check_corners(name, table)
            self.faces = indices(name, table, len(self.vertices))
        else:
            corners, sizes = _ragged(name, faces) if table is None else _rows(table)
            self.face_num = len(sizes)
            self._check_corners(name, corners)
            if sizes.size and sizes.min() < 3:
                raise ValueError(f"{name} has a face of {int(sizes.min())} corners.")
            self._cut(indices(name, corners, len(self.vertices)), sizes)

    def _check_corners(self, name, corners):
        if corners.size > 3 * _MOST:
            raise ValueError(f"{name} has too many corners.")
        if corners.size and corners.dtype.kind not in "iu":
            raise ValueError(f"{name} must be whole numbers, not {corners.dtype}.")
        self.index_dtype = np.dtype(np.int64 if corners.dtype.itemsize > 4 else np.int32)

    def _cut(self, corners, sizes):
        self.sizes = sizes
        self.corners = _core.cut_polygons(self.vertices, corners, sizes.astype(np.int32))
        face_of_corner = np.repeat(np.arange(len(sizes), dtype=np.int32), sizes)
        self.faces = corners[self.corners].reshape(-1, 3)
        self.face_of = face_of_corner[self.corners[::3]]

    def per_triangle(self, values):
        """Values of the caller's faces for the triangles; None stays None."""
        return values if values is None or self.face_of is None else values[self.face_of]

    def callers_face(self, triangles):
        """The caller's faces of triangles, -1 for -1, in the caller's dtype."""
        if self.face_of is not None:
            triangles = np.where(triangles < 0, -1, self.face_of[triangles])
        return triangles.astype(self.index_dtype, copy=False)

    def corner_uv(self, name, values):
        """Texture coordinates of vertices (n, 2) or of the faces' corners (f, c, 2), for each corner of
        the triangles; None stays None. c is the most corners of a face; the rest of a row is unused."""
        if values is None:
            return None
        array = _array(name, values)
        width = 3 if self.sizes is None else int(self.sizes.max(initial=0))
        if array.shape == (len(self.vertices), 2):
            of_corners = _numbers(name, array, "(n, 2)", np.float32)[self.faces]
        elif array.shape == (self.face_num, width, 2):
            of_corners = _numbers(name, self._of_corners(array), "(f, c, 2)", np.float32)
        else:
            raise ValueError(f"{name} must have the shape ({len(self.vertices)}, 2) for vertices or "
                             f"({self.face_num}, {width}, 2) for corners of faces, not {array.shape}.")
        return _in_order(of_corners.reshape(-1, 3, 2), np.float32)

    def _of_corners(self, array):
        if self.corners is None:
            return array
        is_used = np.arange(array.shape[1]) < self.sizes[:, None]
        return array[is_used][self.corners]

    def images(self, name, values):
        """The number of the image for each triangle, -1 without an image; None stays None."""
        return self.labels(name, values, -1)

    def labels(self, name, values, least=-_MOST):
        """A whole number for each triangle; None stays None."""
        if values is None:
            return None
        array = _array(name, values)
        if array.shape != (self.face_num,) or array.dtype.kind not in "iu":
            raise ValueError(f"{name} must be a whole number for each of the {self.face_num} faces.")
        if array.size and not (least <= array.min() and array.max() <= _MOST):
            raise ValueError(f"{name} must be from {least} to {_MOST}.")
        return _in_order(self.per_triangle(array), np.int32)
