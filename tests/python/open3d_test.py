# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the real Open3D, with and without tensors."""

import numpy as np
import pytest

open3d = pytest.importorskip("open3d", reason="Open3D is not installed", exc_type=ImportError)

import gpremesh
from meshes import torus


def plain_mesh():
    vertices, faces = torus(120, 60)
    return open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(vertices),
                                        open3d.utility.Vector3iVector(faces))


def test_a_plain_mesh():
    mesh = plain_mesh()
    mesh.vertex_colors = open3d.utility.Vector3dVector(np.asarray(mesh.vertices) / 10 + 0.5)
    mesh.compute_vertex_normals()
    result = gpremesh.open3d.remesh(mesh, 500)
    points = np.asarray(result.vertices)
    assert points.shape == (500, 3) and np.asarray(result.triangles).shape == (1000, 3)
    assert result.is_watertight() and result.has_vertex_normals()
    assert np.abs(np.asarray(result.vertex_colors) - (points / 10 + 0.5)).max() < 0.01
    assert not result.has_triangle_uvs() and not result.has_triangle_material_ids()


def test_texture_of_a_plain_mesh():
    mesh = plain_mesh()
    points, faces = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    mesh.triangle_uvs = open3d.utility.Vector2dVector(points[faces][:, :, :2].reshape(-1, 2))
    images = (points[faces].mean(axis=1)[:, 0] > 0).astype(np.int32)
    mesh.triangle_material_ids = open3d.utility.IntVector(images)
    result = gpremesh.open3d.remesh(mesh, 500)
    corners = np.asarray(result.vertices)[np.asarray(result.triangles)]
    assert np.abs(np.asarray(result.triangle_uvs).reshape(-1, 3, 2) - corners[:, :, :2]).max() < 0.2
    assert set(np.asarray(result.triangle_material_ids)) == {0, 1}


def plate():
    """A flat sheet with the labels 4 and 2 inside and outside of a disk."""
    i, j = np.meshgrid(np.arange(61), np.arange(61), indexing="ij")
    vertices = np.stack([i / 60 - 0.5, j / 60 - 0.5, 0 * i], axis=-1).reshape(-1, 3)
    first = (np.arange(60)[:, None] * 61 + np.arange(60)).reshape(-1, 1)
    faces = np.concatenate([first + [0, 61, 62], first + [0, 62, 1]]).astype(np.int32)
    labels = np.where(np.linalg.norm(vertices[faces].mean(axis=1), axis=1) < 0.3, 4, 2).astype(np.int32)
    return vertices, faces, labels


def area_of(vertices, faces, where):
    a, b, c = np.moveaxis(vertices[faces[where]], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def test_materials_of_a_plain_mesh_tell_regions():
    vertices, faces, labels = plate()
    wanted = area_of(vertices, faces, labels == 4)
    for regions in (None, "material_ids", labels, "off"):
        mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(vertices), open3d.utility.Vector3iVector(faces))
        if regions is not labels:
            mesh.triangle_material_ids = open3d.utility.IntVector(labels)
        result = gpremesh.open3d.remesh(mesh, 300, regions=regions)
        inside = np.asarray(result.triangle_material_ids) == 4
        off = abs(area_of(np.asarray(result.vertices), np.asarray(result.triangles), inside) / wanted - 1)
        assert off > 3e-3 if isinstance(regions, str) and regions == "off" else off < 2e-3


def test_attributes_of_tensors_tell_regions():
    vertices, faces, labels = plate()
    wanted = area_of(vertices, faces, labels == 4)
    for name, regions in (("label", None), ("material_ids", None), ("patch", "patch"), ("patch", labels)):
        mesh = open3d.t.geometry.TriangleMesh(open3d.core.Tensor(vertices), open3d.core.Tensor(faces))
        mesh.triangle[name] = open3d.core.Tensor(labels.reshape(-1, 1))
        result = gpremesh.open3d.remesh(mesh, 300, regions=regions)
        found = result.triangle[name].numpy().reshape(-1)
        points, triangles = result.vertex["positions"].numpy(), result.triangle["indices"].numpy()
        assert area_of(points, triangles, found == 4) == pytest.approx(wanted, rel=2e-3)
        if regions is labels:
            assert np.array_equal(result.triangle["region"].numpy(), found)


def test_what_is_no_mesh_is_told():
    for wrong in (None, open3d.geometry.PointCloud()):
        with pytest.raises(TypeError, match="mesh must be a TriangleMesh of open3d"):
            gpremesh.open3d.remesh(wrong, 500)
    with pytest.raises(ValueError, match="no triangles"):
        gpremesh.open3d.remesh(open3d.t.geometry.TriangleMesh(), 500)
    with pytest.raises(TypeError, match="takes no image"):
        gpremesh.open3d.remesh(plain_mesh(), 500, image=[1])


def test_faces_without_a_material():
    mesh = plain_mesh()
    points, faces = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    mesh.triangle_uvs = open3d.utility.Vector2dVector(points[faces][:, :, :2].reshape(-1, 2))
    mesh.triangle_material_ids = open3d.utility.IntVector(np.full(len(faces), -1, np.int32))
    assert set(np.asarray(gpremesh.open3d.remesh(mesh, 500).triangle_material_ids)) == {-1}


def test_a_mesh_of_tensors():
    vertices, faces = torus(120, 60, np.float32)
    mesh = open3d.t.geometry.TriangleMesh(open3d.core.Tensor(vertices), open3d.core.Tensor(faces.astype(np.int64)))
    mesh.vertex["height"] = open3d.core.Tensor(np.ascontiguousarray(vertices[:, 2:]))
    mesh.triangle["number"] = open3d.core.Tensor(np.arange(len(faces)))
    mesh.triangle["texture_uvs"] = open3d.core.Tensor(np.ascontiguousarray(vertices[faces][:, :, :2]))
    result = gpremesh.open3d.remesh(mesh, 500)
    points, triangles = result.vertex["positions"].numpy(), result.triangle["indices"].numpy()
    assert points.shape == (500, 3) and points.dtype == np.float32 and triangles.dtype == np.int64
    assert np.abs(result.vertex["height"].numpy()[:, 0] - points[:, 2]).max() < 0.05
    assert result.triangle["number"].numpy().shape == (1000,)
    assert np.abs(result.triangle["texture_uvs"].numpy() - points[triangles][:, :, :2]).max() < 0.2
