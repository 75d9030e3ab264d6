# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of trimesh. Importing this imports trimesh."""

import copy

import trimesh

from . import _api


def _attributes(result, of, attributes, vertex_index=None):
    carried = {name: result.transfer(values, of) for name, values in attributes.items()}
    if vertex_index is None:
        return carried
    return {name: values[vertex_index] for name, values in carried.items()}


def _texture(mesh):
    """Texture coordinates of the vertices, or None."""
    uv = getattr(mesh.visual, "uv", None) if mesh.visual.kind == "texture" else None
    return uv if uv is not None and len(uv) == len(mesh.vertices) else None


def _carry_colours(mesh, result, remeshed):
    if mesh.visual.kind == "vertex":
        remeshed.visual.vertex_colors = result.transfer(mesh.visual.vertex_colors, "vertex")
    elif mesh.visual.kind == "face":
        remeshed.visual.face_colors = result.transfer(mesh.visual.face_colors, "face")


def _carry_texture(mesh, result, remeshed, uv):
    materials = mesh.visual.face_materials
    remeshed.visual = trimesh.visual.TextureVisuals(
        uv=uv,
        material=copy.deepcopy(mesh.visual.material),
        face_materials=None if materials is None else result.transfer(materials, "face"),
    )


def remesh(mesh, vertex_count=None, **parameters):
    """Remeshes a mesh of trimesh, with its colours, texture and attributes.

    Parameters
    ----------
    mesh : trimesh.Trimesh
        The mesh is not changed.
    vertex_count : int, optional
        How many vertices the result has. Along the seams of a texture there are copies beyond that, as
        trimesh has one texture coordinate for each vertex.
    **parameters
        As for `gpremesh.remesh`, without `uv`, which comes from the mesh.

    Returns
    -------
    trimesh.Trimesh
        The result, with the vertex or face colours, the texture, the attributes of vertices and faces, and the
        metadata of `mesh`.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `gpremesh.remesh`.
    """
    texture = _texture(mesh)
    result = _api.remesh(mesh.vertices, mesh.faces, vertex_count=vertex_count, uv=texture, **parameters)
    vertices, faces, vertex_index, uv = result.vertices, result.faces, None, None
    if texture is not None:
        vertex_index, faces, uv = result.split_at_seams()
        vertices = vertices[vertex_index]
    remeshed = trimesh.Trimesh(
        vertices=vertices, faces=faces, process=False, metadata=copy.deepcopy(mesh.metadata),
        vertex_attributes=_attributes(result, "vertex", mesh.vertex_attributes, vertex_index),
        face_attributes=_attributes(result, "face", mesh.face_attributes))
    if texture is None:
        _carry_colours(mesh, result, remeshed)
    else:
        _carry_texture(mesh, result, remeshed, uv)
    return remeshed
