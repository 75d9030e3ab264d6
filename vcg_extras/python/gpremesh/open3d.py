# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of Open3D, with tensors or without. Importing this imports Open3D."""

import numpy as np
import open3d

from . import _api, _regions

_POSITIONS, _INDICES, _NORMALS, _TEXTURE = "positions", "indices", "normals", "texture_uvs"
_MATERIALS = "material_ids"  # as Open3D names them where it makes tensors of a mesh


def remesh(mesh, vertex_count=None, *, regions=None, **parameters):
    """Remeshes a mesh of Open3D, with its colours, texture and attributes.

    Parameters
    ----------
    mesh : open3d.geometry.TriangleMesh or open3d.t.geometry.TriangleMesh
        The mesh is not changed. A mesh with tensors may lie on another device, and is copied to the memory
        of the processor.
    vertex_count : int, optional
        How many vertices the result has.
    regions : str or array_like of int, optional
        What tells the regions of the triangles: of a mesh with tensors, the name of an attribute of
        triangles; "material_ids" for the materials; an array of labels; or "off". If not given: the
        materials, and attributes whose names tell regions, as "region" and "label", combined. Edges of
        the result follow the borders between regions. Labels that were given as an array are the
        attribute "region" of the triangles of the result; where it has no tensors, they are its
        `triangle_material_ids`, unless `mesh` has materials.
    **parameters
        As for `gpremesh.remesh`, without `uv` and `image`, which come from the mesh.

    Returns
    -------
    As `mesh`
        The result, with colours, texture coordinates, materials and, for tensors, all attributes of
        vertices and triangles. Normals are computed anew if `mesh` has normals.

    Raises
    ------
    ValueError, TypeError, gpremesh.Error, KeyboardInterrupt
        As `gpremesh.remesh`.
    """
    tensors = open3d.t.geometry.TriangleMesh
    _api.check_mesh_of_host(mesh, (open3d.geometry.TriangleMesh, tensors), parameters)
    if isinstance(mesh, tensors):
        return _remesh_tensors(mesh, vertex_count, regions, parameters)
    return _remesh_plain(mesh, vertex_count, regions, parameters)


def _column(values):
    """Tensors may have one value a row."""
    return values.reshape(-1) if values.ndim == 2 and values.shape[1] == 1 else values


def _find_regions(columns, regions):
    """Materials tell regions under the name that the package knows, and under Open3D's."""
    if _MATERIALS in columns and regions is None:
        columns = {**columns, "material": columns[_MATERIALS]}
    return _regions.find(columns, regions)


def _remesh_plain(mesh, vertex_count, regions, parameters):
    faces = np.asarray(mesh.triangles)
    materials = np.asarray(mesh.triangle_material_ids) if mesh.has_triangle_material_ids() else None
    result = _api.remesh(
        np.asarray(mesh.vertices), faces, vertex_count=vertex_count,
        uv=np.asarray(mesh.triangle_uvs).reshape(-1, 3, 2) if mesh.has_triangle_uvs() else None,
        image=materials if mesh.has_triangle_uvs() else None,
        regions=_find_regions({} if materials is None else {_MATERIALS: materials}, regions), **parameters)
    remeshed = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(result.vertices),
                                            open3d.utility.Vector3iVector(result.faces))
    if mesh.has_vertex_colors():
        colours = result.transfer(np.asarray(mesh.vertex_colors), "vertex")
        remeshed.vertex_colors = open3d.utility.Vector3dVector(colours)
    if result.uv is not None:
        uv = result.uv.reshape(-1, 2).astype(np.float64)
        remeshed.triangle_uvs = open3d.utility.Vector2dVector(uv)
    if materials is not None:
        images = result.transfer(materials, "face") if result.image is None else result.image
        remeshed.triangle_material_ids = open3d.utility.IntVector(images)
    elif _regions.is_array(regions):
        remeshed.triangle_material_ids = open3d.utility.IntVector(result.regions)
    remeshed.textures = mesh.textures
    if mesh.has_triangle_normals():
        remeshed.compute_triangle_normals()
    if mesh.has_vertex_normals():
        remeshed.compute_vertex_normals()
    return remeshed


def _numpy(tensor):
    return tensor.cpu().numpy()


def _remesh_tensors(mesh, vertex_count, regions, parameters):
    if _POSITIONS not in mesh.vertex or _INDICES not in mesh.triangle:
        raise ValueError("The mesh has no vertices or no triangles.")
    has_texture = _TEXTURE in mesh.triangle
    columns = {name: _column(_numpy(tensor)) for name, tensor in mesh.triangle.items() if name != _INDICES}
    result = _api.remesh(_numpy(mesh.vertex[_POSITIONS]), _numpy(mesh.triangle[_INDICES]),
                         vertex_count=vertex_count,
                         uv=_numpy(mesh.triangle[_TEXTURE]) if has_texture else None,
                         regions=_find_regions(columns, regions), **parameters)
    remeshed = open3d.t.geometry.TriangleMesh(open3d.core.Tensor(result.vertices),
                                              open3d.core.Tensor(result.faces))
    for of, here, there in (("vertex", mesh.vertex, remeshed.vertex),
                            ("face", mesh.triangle, remeshed.triangle)):
        for name, tensor in here.items():
            if name not in (_POSITIONS, _INDICES, _NORMALS, _TEXTURE):
                there[name] = open3d.core.Tensor(np.ascontiguousarray(result.transfer(_numpy(tensor), of)))
    if _regions.is_array(regions):
        remeshed.triangle["region"] = open3d.core.Tensor(result.regions)
    if result.uv is not None:
        remeshed.triangle[_TEXTURE] = open3d.core.Tensor(result.uv)
    if mesh.has_valid_material():
        remeshed.material = mesh.material
    if _NORMALS in mesh.triangle:
        remeshed.compute_triangle_normals()
    if _NORMALS in mesh.vertex:
        remeshed.compute_vertex_normals()
    return remeshed.to(mesh.device)
