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
        Triangles as rows of `vertices`, counter-clockwise as those of the input, in its dtype
        (int32 or int64).
    face_index : ndarray (n,)
        The input's face that each vertex lies on, or that it was moved off by the fit.
    barycentric : ndarray (n, 3) of float32
        The weights of the corners of that face; their sum is 1.
    corner_index : ndarray (n, 3)
        Those corners, as vertices of the input. Of a polygon, the corners of one of the triangles it
        was cut into.
    middle_face_index : ndarray (m,)
        The input's face that the middle of each face lies on.
    kept_vertex : ndarray (n,) or None
        Which vertex of the input each one is, bit for bit, or -1; None where none had to stay.
    kept_face : ndarray (m,) or None
        With `selected`: which face of the input each one is, or -1 for the new ones.
    uv : ndarray (m, 3, 2) of float32, or None
        Texture coordinates of the corners of the faces, where `uv` was given.
    image : ndarray (m,) of int32, or None
        The number of the image of each face, where `image` was given.
    regions : ndarray (m,) of int32, or None
        The label of each face, where the input's faces have labels.
    report : dict
        What was done and how well, as the command line's `--report` has it. Times are in seconds,
        lengths in the input's unit, angles in degrees. The names of files are empty.
    """

    vertices: np.ndarray
    faces: np.ndarray
    face_index: np.ndarray
    barycentric: np.ndarray
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
        self._triangle_index = outcome["face_index"]
        self._triangles = mesh.faces
        self._input_sizes = {"vertex": len(mesh.vertices), "face": mesh.face_num}
        self._index_dtype = mesh.index_dtype

    def __repr__(self):
        return f"<gpremesh.RemeshResult: {len(self.vertices)} vertices, {len(self.faces)} faces>"

    @property
    def corner_index(self) -> np.ndarray:
        return self._triangles[self._triangle_index].astype(self._index_dtype, copy=False)

    def split_at_seams(self) -> "tuple[np.ndarray, np.ndarray, np.ndarray]":
        """The mesh with as many copies of each vertex as it has texture coordinates, for formats and
        packages whose texture coordinates belong to vertices.

        Returns
        -------
        vertex_index : ndarray (k,)
            For each new vertex, which row of `vertices` it is a copy of. Without seams there are no
            copies, and the order stays.
        faces : ndarray (m, 3)
            The faces by new vertices.
        uv : ndarray (k, 2) of float32
            The texture coordinates of the new vertices.

        Raises
        ------
        ValueError
            Where the result has no texture coordinates.
        """
        if self.uv is None:
            raise ValueError("The result has no texture coordinates; give remesh the argument uv.")
        uv = self.uv.reshape(-1, 2) + np.float32(0)  # -0 and 0 are one place
        corners = np.empty(len(uv), dtype=[("vertex", np.int64), ("u", np.float32), ("v", np.float32)])
        corners["vertex"], corners["u"], corners["v"] = self.faces.reshape(-1), uv[:, 0], uv[:, 1]
        own, faces = np.unique(corners, return_inverse=True)
        return (own["vertex"].astype(self._index_dtype),
                faces.reshape(-1, 3).astype(self._index_dtype),
                np.column_stack([own["u"], own["v"]]))

    def transfer(self, values, of: 'Literal["vertex", "face"]' = "vertex") -> np.ndarray:
        """Carries values of the input over to the result, by the rule of the command line.

        Parameters
        ----------
        values : array_like, (input's vertices, ...) or (input's faces, ...)
            One value or one row for each vertex or face of the input, of any dtype.
        of : {'vertex', 'face'}
            What the values belong to.

        Returns
        -------
        ndarray, (n, ...) or (m, ...), of the dtype of `values`
            Of vertices, the mean over the corners of the face that each vertex lies on, for real
            numbers and for uint8, which is rounded: colours. Other values, such as labels, are those
            of the corner with the largest weight. Of faces, those of the face that the middle of each
            face lies on.

        Raises
        ------
        ValueError
            Where `values` has another number of rows than the input.
        """
        if of not in ("vertex", "face"):
            raise ValueError(f"of takes 'vertex' or 'face', not {of!r}.")
        array = np.asarray(values)
        if array.ndim == 0 or len(array) != self._input_sizes[of]:
            raise ValueError(f"values must have {self._input_sizes[of]} rows, one for each {of} of the "
                             f"input; its shape is {array.shape}.")
        if of == "face":
            return array[self.middle_face_index]
        corners = self._triangles[self._triangle_index]
        if array.dtype.kind == "f" or array.dtype == np.uint8:
            return _mean_of_corners(array, corners, self.barycentric)
        nearest = np.argmax(self.barycentric, axis=1)
        return array[corners[np.arange(len(corners)), nearest]]


def _mean_of_corners(values, corners, weights):
    """Corners without weight are left out, so that a NaN there does no harm."""
    total = np.zeros((len(corners),) + values.shape[1:])
    for k in range(3):
        weight = weights[:, k].astype(np.float64).reshape((-1,) + (1,) * (values.ndim - 1))
        with np.errstate(invalid="ignore"):
            total += np.where(weight != 0, weight * values[corners[:, k]].astype(np.float64), 0)
    if values.dtype == np.uint8:
        return np.clip(np.floor(total + 0.5), 0, 255).astype(np.uint8)
    return total.astype(values.dtype, copy=False)


@dataclass(frozen=True, eq=False)
class Samples:
    """Points of a geodesic Poisson-disk sampling.

    Attributes
    ----------
    points : ndarray (n, 3)
        Their coordinates, in the unit and the dtype of the input.
    face_index : ndarray (n,)
        The input's face that each lies on.
    barycentric : ndarray (n, 3) of float32
        The weights of the corners of that face.
    radius : ndarray (n,) of float64
        The radius of the disk of each, in the input's unit.
    disk_radius : float
        That of the largest disks.
    seed : int
        The seed that was taken.
    notes : list of str
        Sentences worth reading although all went well.
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
        How sharp the surface is at each vertex, degrees from 0 to 180.
    vertex : ndarray (n,) of uint8
        What each vertex is, as bits: 1 on a line, 2 a corner, 4 the apex of a cone.
    face : ndarray (m,) of bool
        Whether a face has a marked vertex.
    edges : ndarray (e, 2)
        The feature edges, as pairs of vertices: `feature_edges` of `remesh`.
    edge_strength : ndarray (e,) of float32
        Their strength in degrees.
    report : dict
        The numbers, as the report of the command line's `gpremesh features` has them.
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
        99.9 % of the area is nearer than this.
    largest : float
        The largest distance that was found.
    lower, upper : float
        The largest distance lies between these. This is proven.
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
        Of the points of the first surface from the second, and the other way.
    rms, mean, p999, largest, lower, upper : float
        The larger one of both directions; `largest` is the Hausdorff distance, as far as it was
        found, and lies between `lower` and `upper`.
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
