# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with all values of their files, by the readers and writers of the command line."""

import json
import os
import warnings

import numpy as np

from . import _api, _arrays, _core
from ._errors import check
from ._results import RemeshResult
from ._table import with_parameters


class FileMesh:
    """A mesh with all values that a file can hold.

    Parameters
    ----------
    vertices, faces : array_like
        As for `gpremesh.remesh`.
    uv : array_like (n, 2) or (f, c, 2), optional
        Texture coordinates of the vertices, or of the corners of the faces, from the lower left corner
        of the image; c is the most corners of a face.
    image : array_like (f,) of int, optional
        With `uv`: the number of the material of each face.
    vertex_values, face_values : dict of str to array_like, optional
        A number for each vertex or face, by the names of PLY files: red, green, blue and alpha (uint8),
        nx, ny and nz, quality, and any other name without spaces.
    materials : FileMesh, optional
        A mesh from which the new mesh gets materials and images.

    Attributes
    ----------
    vertices, faces, uv, image, vertex_values, face_values
        As above. All may be changed.
    region : ndarray (n,) of bool, or None
        The vertices that a PLY file marks as selected; None if no vertex is selected.
    notes : list of str
        Sentences about oddities of the file.
    result : RemeshResult or None
        For a result of `remesh`: the place of each vertex on the input, and the report.
    """

    vertices: np.ndarray
    faces: np.ndarray
    uv: "np.ndarray | None"
    image: "np.ndarray | None"
    vertex_values: "dict[str, np.ndarray]"
    face_values: "dict[str, np.ndarray]"
    region: "np.ndarray | None"
    notes: "list[str]"
    result: "RemeshResult | None"

    def __init__(self, vertices, faces, *, uv=None, image=None, vertex_values=None, face_values=None,
                 materials=None):
        self.vertices = vertices
        self.faces = faces
        self.uv = uv
        self.image = image
        self.vertex_values = dict(vertex_values or {})
        self.face_values = dict(face_values or {})
        self.region = None
        self.notes = []
        self.result = None
        self._materials = _core.FileAttributes() if materials is None else materials._materials

    def __repr__(self):
        return f"<gpremesh.FileMesh: {len(self.vertices)} vertices, {len(self.faces)} faces>"

    @with_parameters("remesh")
    def remesh(self, vertex_count=None, *, selected=None, region=None, feature_edges=None, regions=None,
               sizes=None, periodic=None, progress=None, **parameters):
        """Remeshes the mesh and transfers all values, by the rules of the command line.

        Parameters
        ----------
        vertex_count : int, optional
            Number of vertices of the result.
        selected, region, feature_edges, regions, sizes, periodic, progress
            As for `gpremesh.remesh`. The default of `region` is the region of the file. The default of
            `regions` are the face values whose names tell regions, as region and label; given labels are
            the face values "region" of the new mesh.
        PARAMETERS

        Returns
        -------
        FileMesh
            The new mesh, with places and report as `result`. The old mesh is not changed.

        Raises
        ------
        ValueError, gpremesh.Error, KeyboardInterrupt
            As `gpremesh.remesh`.
        """
        _api.check_progress(progress)
        parameters = _api.without_none(dict(parameters, vertex_count=vertex_count))
        if region is None and self.region is not None and parameters.get("feature_region") == "selection":
            region = np.asarray(self.region, bool)
        mesh = _arrays.Mesh(self.vertices, self.faces)
        extras = _api.all_extras(mesh, parameters, selected=selected, region=region, feature_edges=feature_edges,
                                 regions=regions, sizes=sizes, periodic=periodic)
        if region is None:  # selected vertices of the file are the default
            extras.region = self._marked(mesh)
        outcome = _core.remesh_mesh_of_file(mesh.vertices, mesh.faces, extras, self._attributes(mesh), parameters,
                                            progress)
        check(outcome)
        made = self._of_result(mesh, outcome)
        if regions is not None:
            made.face_values["region"] = made.result.regions
        return made

    def _of_result(self, mesh, outcome):
        # Like the command line: doubles replace floats that would not resolve the result.
        is_double = mesh.vertices.dtype == np.float64 or outcome["is_coarse"]
        vertices = outcome["vertices"].astype(np.float64 if is_double else np.float32, copy=False)
        result = RemeshResult(mesh, outcome, json.loads(outcome["report"]))
        made = _with_attributes(vertices, result.faces, outcome["attributes"])
        result.vertices, result.uv, result.image = vertices, made.uv, made.image
        made.result = result
        return made

    def _marked(self, mesh):
        """The region as a byte for each vertex, or None."""
        marked = None if self.region is None else np.asarray(self.region, bool)
        return _arrays.mask("region", marked, len(mesh.vertices), "vertices")

    def _attributes(self, mesh):
        """The attributes of the file mesh, for its triangles in `mesh`."""
        attributes = _core.FileAttributes()
        attributes.take_materials(self._materials)
        for name, values in self.vertex_values.items():
            _check_name("vertex_values", name)
            attributes.add_vertex_values(name, _column(f"vertex_values[{name!r}]", values, len(mesh.vertices)))
        for name, values in self.face_values.items():
            _check_name("face_values", name)
            column = _column(f"face_values[{name!r}]", values, mesh.face_num)
            attributes.add_face_values(name, mesh.per_triangle(column))
        if self.image is not None and self.uv is None:
            raise ValueError("image needs uv.")
        if self.uv is not None:
            attributes.set_texture(mesh.corner_uv("uv", self.uv), mesh.images("image", self.image))
        return attributes


def _with_attributes(vertices, faces, attributes):
    mesh = FileMesh(vertices, faces, uv=attributes.uv(), image=attributes.image(),
                    vertex_values=attributes.vertex_values(), face_values=attributes.face_values())
    mesh._materials.take_materials(attributes)
    return mesh


_TAKEN = {"vertex_values": ("x", "y", "z", "flags", "selected"),
          "face_values": ("vertex_indices", "texcoord", "texnumber", "flags", "selected")}


def _check_name(argument, name):
    """Refuses names that PLY files cannot hold."""
    if not isinstance(name, str) or name.split() != [name] or not name.isprintable():
        raise ValueError(f"{argument} has the name {name!r}; a name must be text without spaces.")
    if name in _TAKEN[argument]:
        raise ValueError(f"{argument} has the name {name!r}, which means other data in PLY files.")


def _column(name, values, length):
    """Numbers in a type of PLY files."""
    array = np.asarray(values)
    if array.shape != (length,):
        raise ValueError(f"{name} must have the shape ({length},), not {array.shape}.")
    if array.dtype.kind not in "biuf":
        raise ValueError(f"{name} must be numbers, not {array.dtype}.")
    if array.dtype == bool:
        array = array.astype(np.uint8)
    elif array.dtype.kind in "iu" and array.dtype.itemsize > 4:
        fits = array.size == 0 or (array.min() >= -2**31 and array.max() < 2**31)
        array = array.astype(np.int32 if fits else np.float64)
    elif array.dtype.kind == "f" and array.dtype.itemsize not in (4, 8):
        array = array.astype(np.float32 if array.dtype.itemsize < 4 else np.float64)
    return np.ascontiguousarray(array, array.dtype.newbyteorder("="))


def read(path):
    """Reads a mesh with all values of its file, by the reader of the command line.

    Parameters
    ----------
    path : str or path-like
        A file in a format of the command line, by extension, such as .ply or .glb.

    Returns
    -------
    FileMesh
        Polygons are cut into triangles. A scene of binary glTF becomes a single mesh.

    Raises
    ------
    ValueError
        For another extension.
    OSError
        If the file does not exist or is not readable.
    gpremesh.Error
        If the file is no mesh, with the status "unusable input". Compressed binary glTF and morph
        targets are refused.

    Examples
    --------
    >>> import gpremesh
    >>> mesh = gpremesh.read("statue.glb")                # doctest: +SKIP
    >>> gpremesh.write("small.glb", mesh.remesh(5000))    # doctest: +SKIP
    """
    path = os.fsdecode(path)
    with open(path, "rb"):  # Python raises errors about the path
        pass
    outcome = _core.read_mesh(path)
    check(outcome)
    mesh = _with_attributes(outcome["vertices"], outcome["faces"], outcome["attributes"])
    mesh.region = outcome["selected"]
    mesh.notes = outcome["notes"]
    return mesh


def _values_of(mesh):
    """What a RemeshResult has beside vertices and faces, for a FileMesh."""
    if not isinstance(mesh, RemeshResult):
        return {}
    return dict(uv=mesh.uv, image=mesh.image, face_values={} if mesh.regions is None else {"region": mesh.regions})


def write(path, mesh):
    """Writes a mesh, by the writer of the command line.

    Parameters
    ----------
    path : str or path-like
        A file to write or replace, in a format of the command line, by extension, such as .ply or .glb.
        After a failure an older file is unchanged.
    mesh : FileMesh, RemeshResult, a pair (vertices, faces), or an object with both as attributes
        A FileMesh is written with all values that the format can hold, a RemeshResult with its texture
        coordinates, numbers of images, and regions (as values "region" of faces). A warning names the
        values that the format cannot hold.

    Raises
    ------
    ValueError
        For another extension, and for arrays of different lengths.
    OSError
        If the file cannot be written.
    """
    path = os.fsdecode(path)
    if not isinstance(mesh, FileMesh):
        mesh = FileMesh(*_api.vertices_and_faces("mesh", mesh), **_values_of(mesh))
    arrays = _arrays.Mesh(mesh.vertices, mesh.faces, ("mesh.vertices", "mesh.faces"))
    attributes = mesh._attributes(arrays)
    if mesh.region is not None:
        attributes.add_vertex_values("selected", mesh._marked(arrays))
    lost = _core.write_mesh(path, arrays.vertices, arrays.faces, attributes)
    if lost:
        warnings.warn(f"Not written to {path!r}: {', '.join(lost)}.", stacklevel=2)
