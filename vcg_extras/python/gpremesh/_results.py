# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
from dataclasses import dataclass
from typing import Literal

import numpy as np


class RemeshResult:
    """A remeshed surface.

    Attributes
    ----------
    vertices : ndarray (n, 3)
        Coordinates, in the unit and the dtype of the input (float32 or float64).
    faces : ndarray (m, 3)
        Triangles as rows of `vertices`, counter-clockwise like the input, in the dtype of the input
        faces (int32 or int64).
    face_index : ndarray (n,)
        The input face below each vertex. A fit moves vertices a little off the face.
    barycentric : ndarray (n, 3) of float64
        The weights of the three corners of the input face; the sum is 1.
    corner_index : ndarray (n, 3)
        The three corners, as vertices of the input. For a polygon, the corners of the triangle below the
        vertex, after the polygon was cut.
    middle_face_index : ndarray (m,)
        The input face below the middle of each face.
    kept_vertex : ndarray (n,) or None
        The vertex of the input with the same place, bit for bit, or -1; None if no vertex had to stay.
    kept_face : ndarray (m,) or None
        With `selected`: the same face of the input, or -1 for new faces.
    uv : ndarray (m, 3, 2) of float32, or None
        Texture coordinates of the corners of the faces, if `uv` was given.
    image : ndarray (m,) of int32, or None
        The number of the image of each face, if `image` was given.
    regions : ndarray (m,) of int32, or None
        The label of each face, if the input faces have labels.
    report : dict
        Changes and quality, as in `--report` of the command line. Times are in seconds, lengths in the
        unit of the input, angles in degrees. The names of files are empty.
    """

    vertices: np.ndarray
    faces: np.ndarray
    face_index: np.ndarray
    barycentric: np.ndarray
    corner_index: np.ndarray
    middle_face_index: np.ndarray
    kept_vertex: "np.ndarray | None"
    kept_face: "np.ndarray | None"
    uv: "np.ndarray | None"
    image: "np.ndarray | None"
    regions: "np.ndarray | None"
    report: dict

    def __init__(self, mesh, outcome, report):
        faces = outcome["faces"]
        self.vertices = outcome["vertices"].astype(mesh.vertices.dtype, copy=False)
        self.faces = faces.astype(mesh.index_dtype, copy=False)
        self.barycentric = outcome["barycentric"]
        self.face_index = mesh.callers_face(outcome["face_index"])
        self.middle_face_index = mesh.callers_face(outcome["middle_face_index"])
        kept_vertex, kept_face = outcome["kept_vertex"], outcome["kept_face"]
        self.kept_vertex = kept_vertex.astype(mesh.index_dtype, copy=False) if kept_vertex.size else None
        self.kept_face = mesh.callers_face(kept_face) if kept_face.size else None
        self.uv = outcome.get("uv")
        image = outcome.get("image")
        self.image = image if image is not None and image.size else None
        self.regions = outcome["regions"] if outcome["regions"].size else None
        self.report = report
        self.corner_index = mesh.faces[outcome["face_index"]].astype(mesh.index_dtype, copy=False)
        self._input_sizes = {"vertex": len(mesh.vertices), "face": mesh.face_num}
        self._index_dtype = mesh.index_dtype

    def __repr__(self):
        return f"<gpremesh.RemeshResult: {len(self.vertices)} vertices, {len(self.faces)} faces>"

    def split_at_seams(self) -> "tuple[np.ndarray, np.ndarray, np.ndarray]":
        """The mesh with a copy of each vertex for each of its texture coordinates, for formats and packages
        with texture coordinates at vertices.

        Returns
        -------
        vertex_index : ndarray (k,)
            For each new vertex, the row of `vertices` to copy. Without seams there are no copies, and the
            order stays.
        faces : ndarray (m, 3)
            The faces by new vertices.
        uv : ndarray (k, 2) of float32
            The texture coordinates of the new vertices.

        Raises
        ------
        ValueError
            If the result has no texture coordinates.
        """
        if self.uv is None:
            raise ValueError("The result has no texture coordinates; give remesh the argument uv.")
        uv = self.uv.reshape(-1, 2) + np.float32(0)  # -0 and 0 are the same place
        corners = np.empty(len(uv), dtype=[("vertex", np.int64), ("u", np.float32), ("v", np.float32)])
        corners["vertex"], corners["u"], corners["v"] = self.faces.reshape(-1), uv[:, 0], uv[:, 1]
        own, faces = np.unique(corners, return_inverse=True)
        return (own["vertex"].astype(self._index_dtype),
                faces.reshape(-1, 3).astype(self._index_dtype),
                np.column_stack([own["u"], own["v"]]))

    def transfer(self, values, of: 'Literal["vertex", "face"]' = "vertex") -> np.ndarray:
        """Transfers values of the input to the result, by the rule of the command line.

        Parameters
        ----------
        values : array_like, (input's vertices, ...) or (input's faces, ...)
            A value or a row for each vertex or face of the input, of any dtype.
        of : {'vertex', 'face'}
            Whether the values belong to vertices or to faces.

        Returns
        -------
        ndarray, (n, ...) or (m, ...), of the dtype of `values`
            For vertices, real numbers and uint8 (colours, rounded) become the weighted mean over the
            corners of the input face below the vertex. Other values, such as labels, come from the corner
            with the largest weight. For faces, values come from the input face below the middle of the
            face.

        Raises
        ------
        ValueError
            If `values` has another number of rows than the input.
        """
        if of not in ("vertex", "face"):
            raise ValueError(f"of takes 'vertex' or 'face', not {of!r}.")
        array = np.asarray(values)
        if array.ndim == 0 or len(array) != self._input_sizes[of]:
            raise ValueError(f"values must have {self._input_sizes[of]} rows, a row for each {of} of the "
                             f"input; its shape is {array.shape}.")
        if of == "face":
            return array[self.middle_face_index]
        corners = self.corner_index
        if array.dtype.kind == "f" or array.dtype == np.uint8:
            return _mean_of_corners(array, corners, self.barycentric)
        nearest = np.argmax(self.barycentric, axis=1)
        return array[corners[np.arange(len(corners)), nearest]]


def _mean_of_corners(values, corners, weights):
    """The weighted mean. Corners without weight are left out, so that a NaN there does no harm. The limits keep
    a constant the same in spite of rounding."""
    at = values[corners].astype(np.float64)
    weights = weights.reshape(weights.shape + (1,) * (values.ndim - 1))
    with np.errstate(invalid="ignore"):
        total = np.where(weights != 0, weights * at, 0).sum(axis=1)
    total = np.clip(total, np.fmin.reduce(at, axis=1), np.fmax.reduce(at, axis=1))
    if values.dtype == np.uint8:
        return np.clip(np.floor(total + 0.5), 0, 255).astype(np.uint8)
    return total.astype(values.dtype, copy=False)


@dataclass(frozen=True, eq=False)
class Samples:
    """Points of a geodesic Poisson-disk sampling.

    Attributes
    ----------
    points : ndarray (n, 3)
        Coordinates, in the unit and the dtype of the input.
    face_index : ndarray (n,)
        The input face of each point.
    barycentric : ndarray (n, 3) of float64
        The weights of the corners of the input face; the sum is 1.
    radius : ndarray (n,) of float64
        The disk radius of each point, in the unit of the input.
    disk_radius : float
        The radius of the largest disks.
    seed : int
        The seed of the run.
    notes : list of str
        Sentences about the run that are worth reading.
    """

    points: np.ndarray
    face_index: np.ndarray
    barycentric: np.ndarray
    radius: np.ndarray
    disk_radius: float
    seed: int
    notes: list


@dataclass(frozen=True, eq=False)
class Features:
    """Creases and cone apexes of a mesh.

    Attributes
    ----------
    strength : ndarray (n,) of float32
        The sharpness of the surface at each vertex, degrees from 0 to 180.
    vertex : ndarray (n,) of uint8
        The kind of each vertex, as bits: 1 on a line, 2 corner, 4 cone apex.
    face : ndarray (m,) of bool
        Whether a face has a marked vertex.
    edges : ndarray (e, 2)
        The crease edges, as pairs of vertices: `feature_edges` of `remesh`.
    edge_strength : ndarray (e,) of float32
        The strength of the edges in degrees.
    report : dict
        The figures, as in the report of `gpremesh features`.
    """

    strength: np.ndarray
    vertex: np.ndarray
    face: np.ndarray
    edges: np.ndarray
    edge_strength: np.ndarray
    report: dict


@dataclass(frozen=True)
class OneWayDistance:
    """Distances of the points of one surface from another, in the unit of the coordinates.

    Attributes
    ----------
    rms, mean : float
        Root mean square and mean over the area.
    p999 : float
        99.9 % of the area is nearer than this distance.
    largest : float
        The largest distance found.
    lower, upper : float
        Proven bounds of the largest distance.
    """

    rms: float
    mean: float
    p999: float
    largest: float
    lower: float
    upper: float


@dataclass(frozen=True)
class Distance:
    """Distances of two surfaces from each other, in the unit of the coordinates.

    Attributes
    ----------
    a_to_b, b_to_a : OneWayDistance
        Distances of the first surface from the second, and of the second from the first.
    rms, mean, p999, largest, lower, upper : float
        The larger figure of both directions; `largest` is the Hausdorff distance, as far as found, and
        lies between `lower` and `upper`.
    """

    a_to_b: OneWayDistance
    b_to_a: OneWayDistance

    @property
    def rms(self) -> float:
        return self._larger("rms")

    @property
    def mean(self) -> float:
        return self._larger("mean")

    @property
    def p999(self) -> float:
        return self._larger("p999")

    @property
    def largest(self) -> float:
        return self._larger("largest")

    @property
    def lower(self) -> float:
        return self._larger("lower")

    @property
    def upper(self) -> float:
        return self._larger("upper")

    def _larger(self, name):
        return max(getattr(self.a_to_b, name), getattr(self.b_to_a, name))
