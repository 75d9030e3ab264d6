# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of trimesh. Importing this imports trimesh."""

import copy

import trimesh

from . import _api, _regions


def _attributes(result, of, attributes, vertex_index=None):
    carried = {name: result.transfer(values, of) for name, values in attributes.items()}
    if vertex_index is None:
        return carried
    return {name: values[vertex_index] for name, values in carried.items()}


def _texture(mesh):
    """Texture coordinates of the vertices, or None."""
    uv = getattr(mesh.visual, "uv", None) if mesh.visual.kind == "texture" else None
    return uv if uv is not None and len(uv) == len(mesh.vertices) else None


def _materials(mesh):
    """The number of the material of each face, or None."""
    materials = getattr(mesh.visual, "face_materials", None) if mesh.visual.kind == "texture" else None
    return materials if materials is not None and len(materials) == len(mesh.faces) else None


def _columns_of_faces(mesh):
    materials = _materials(mesh)
    return {**mesh.face_attributes, **({} if materials is None else {"material": materials})}


def _carry_visual(mesh, result, remeshed, uv):
    if mesh.visual.kind == "vertex":
        remeshed.visual.vertex_colors = result.transfer(mesh.visual.vertex_colors, "vertex")
    elif mesh.visual.kind == "face":
        remeshed.visual.face_colors = result.transfer(mesh.visual.face_colors, "face")
    elif mesh.visual.kind == "texture":  # a material may have no texture coordinates
        materials = _materials(mesh)
        remeshed.visual = trimesh.visual.TextureVisuals(
            uv=uv,
            material=copy.deepcopy(mesh.visual.material),
            face_materials=None if materials is None else result.transfer(materials, "face"),
        )


def remesh(mesh, vertex_count=None, *, regions=None, **parameters):
    """Remeshes a mesh of trimesh, with its colours, texture and attributes.

    Parameters
    ----------
    mesh : trimesh.Trimesh
        The mesh is not changed. `scene.to_mesh()` makes a mesh of a scene.
    vertex_count : int, optional
        How many vertices the result has. Along the seams of a texture there are copies beyond that, as
        trimesh has one texture coordinate for each vertex.
    regions : str or array_like of int, optional
        What tells the regions of the faces: the name of an attribute of faces, "material" for the
        materials of a texture, an array of labels, or "off". If not given: these materials, and
        attributes whose names tell regions, as "region", "label" and "group", combined. Edges of the
        result follow the borders between regions. Labels that were given as an array are the face
        attribute "region" of the result.
    **parameters
        As for `gpremesh.remesh`, without `uv`, which comes from the mesh.

    Returns
    -------
    trimesh.Trimesh
        The result, with the vertex or face colours, the material and texture, the attributes of vertices and
        faces, the density and the metadata of `mesh`.

    Raises
    ------
    ValueError, TypeError, gpremesh.Error, KeyboardInterrupt
        As `gpremesh.remesh`.
    """
    _api.check_mesh_of_host(mesh, (trimesh.Trimesh,), parameters)
    texture = _texture(mesh)
    result = _api.remesh(mesh.vertices, mesh.faces, vertex_count=vertex_count, uv=texture,
                         regions=_regions.find(_columns_of_faces(mesh), regions), **parameters)
    vertices, faces, vertex_index, uv = result.vertices, result.faces, None, None
    if texture is not None:
        vertex_index, faces, uv = result.split_at_seams()
        vertices = vertices[vertex_index]
    remeshed = trimesh.Trimesh(
        vertices=vertices, faces=faces, process=False, metadata=copy.deepcopy(mesh.metadata),
        vertex_attributes=_attributes(result, "vertex", mesh.vertex_attributes, vertex_index),
        face_attributes=_attributes(result, "face", mesh.face_attributes))
    if _regions.is_array(regions):
        remeshed.face_attributes["region"] = result.regions
    _carry_visual(mesh, result, remeshed, uv)
    if "density" in mesh._data.data:  # mesh.density computes the volume
        remeshed.density = mesh.density
    return remeshed
