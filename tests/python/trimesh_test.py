# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the real trimesh."""

import numpy as np
import pytest

trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")

import gpremesh
from meshes import command_line, torus


def mesh_of(**keywords):
    vertices, faces = torus(120, 60)
    return trimesh.Trimesh(vertices, faces, process=False, **keywords)


def colours_by(values):
    channel = np.clip(40 * values + 128, 0, 255).astype(np.uint8)
    return np.column_stack([channel, 255 - channel, channel, np.full(len(channel), 255)])


def test_a_plain_mesh():
    mesh = mesh_of(metadata={"name": "torus"})
    result = gpremesh.trimesh.remesh(mesh, 500, seed=2)
    assert isinstance(result, trimesh.Trimesh) and result.vertices.shape == (500, 3)
    assert result.is_watertight and result.is_winding_consistent and result.metadata["name"] == "torus"
    assert result.volume == pytest.approx(mesh.volume, rel=0.02)
    expected = gpremesh.remesh(*torus(120, 60), vertex_count=500, seed=2)
    assert np.array_equal(result.vertices, expected.vertices)
    assert np.array_equal(result.faces, expected.faces)


def test_colours_and_attributes():
    vertices = torus(120, 60)[0]
    mesh = mesh_of(vertex_colors=colours_by(vertices[:, 2]), vertex_attributes={"height": vertices[:, 2]},
                   face_attributes={"number": np.arange(14400)})
    result = gpremesh.trimesh.remesh(mesh, 500)
    assert result.visual.kind == "vertex"
    wanted = colours_by(result.vertices[:, 2]).astype(int)
    assert np.abs(result.visual.vertex_colors.astype(int) - wanted).max() <= 4
    assert np.abs(result.vertex_attributes["height"] - result.vertices[:, 2]).max() < 0.05
    assert result.face_attributes["number"].shape == (1000,)


def test_colours_of_faces():
    mesh = mesh_of()
    mesh.visual.face_colors = colours_by(mesh.triangles_center[:, 2])
    result = gpremesh.trimesh.remesh(mesh, 500)
    assert result.visual.kind == "face"
    difference = result.visual.face_colors.astype(int) - colours_by(result.triangles_center[:, 2])
    assert np.abs(difference).max() < 15


def plate():
    """A flat sheet with the labels 4 and 2 inside and outside of a disk."""
    i, j = np.meshgrid(np.arange(61), np.arange(61), indexing="ij")
    vertices = np.stack([i / 60 - 0.5, j / 60 - 0.5, 0 * i], axis=-1).reshape(-1, 3)
    first = (np.arange(60)[:, None] * 61 + np.arange(60)).reshape(-1, 1)
    faces = np.concatenate([first + [0, 61, 62], first + [0, 62, 1]])
    labels = np.where(np.linalg.norm(vertices[faces].mean(axis=1), axis=1) < 0.3, 4, 2)
    return vertices, faces, labels


def test_attributes_of_faces_tell_regions():
    vertices, faces, labels = plate()
    for regions in (None, "label", labels, "off"):
        mesh = trimesh.Trimesh(vertices, faces, process=False, face_attributes={"label": labels})
        wanted = mesh.area_faces[labels == 4].sum()
        result = gpremesh.trimesh.remesh(mesh, 300, regions=regions)
        off = abs(result.area_faces[result.face_attributes["label"] == 4].sum() / wanted - 1)
        assert off > 3e-3 if isinstance(regions, str) and regions == "off" else off < 2e-3
        if regions is labels:
            assert np.array_equal(result.face_attributes["region"], result.face_attributes["label"])


def test_materials_tell_regions():
    vertices, faces, labels = plate()
    materials = [trimesh.visual.material.SimpleMaterial(diffuse=[40 * k, 0, 0, 255]) for k in range(5)]
    visual = trimesh.visual.TextureVisuals(
        uv=vertices[:, :2], face_materials=labels, material=trimesh.visual.material.MultiMaterial(materials))
    mesh = trimesh.Trimesh(vertices, faces, process=False, visual=visual)
    result = gpremesh.trimesh.remesh(mesh, 300)
    inside = result.visual.face_materials == 4
    assert set(result.visual.face_materials) == {2, 4}
    assert result.area_faces[inside].sum() == pytest.approx(mesh.area_faces[labels == 4].sum(), rel=2e-3)
    assert len(result.visual.material.materials) == 5


def test_texture():
    image = pytest.importorskip("PIL.Image").new("RGB", (4, 4))
    # A tube that was cut open along a seam, whose vertices are there twice.
    i, j = np.meshgrid(np.arange(81), np.arange(41), indexing="ij")
    angle = 2 * np.pi * (i % 80) / 80
    vertices = np.stack([np.cos(angle), np.sin(angle), j / 10], axis=-1).reshape(-1, 3)
    first = (np.arange(80)[:, None] * 41 + np.arange(40)).reshape(-1, 1)
    quads = first + [0, 41, 42, 1]
    uv = np.stack([i / 80, j / 40], axis=-1).reshape(-1, 2)
    visual = trimesh.visual.TextureVisuals(uv=uv, image=image)
    mesh = trimesh.Trimesh(vertices, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]), visual=visual,
                           process=False)
    result = gpremesh.trimesh.remesh(mesh, 400)
    assert len(result.vertices) > 400  # copies along the seam
    assert result.visual.kind == "texture" and result.visual.material.image.size == (4, 4)
    assert np.ptp(result.visual.uv[result.faces][:, :, 0], axis=1).max() < 0.2
    around = np.arctan2(result.vertices[:, 1], result.vertices[:, 0]) / (2 * np.pi)
    difference = np.abs(result.visual.uv[:, 0] - around) % 1
    assert np.minimum(difference, 1 - difference).max() < 0.01
    result.merge_vertices(merge_tex=True)
    assert len(result.vertices) == 400


def test_a_material_without_texture_coordinates_and_the_density():
    mesh = mesh_of()
    material = trimesh.visual.material.PBRMaterial(baseColorFactor=[255, 0, 0, 255])
    mesh.visual = trimesh.visual.TextureVisuals(material=material)
    mesh.density = 7.8
    result = gpremesh.trimesh.remesh(mesh, 500)
    assert result.visual.kind == "texture" and result.visual.uv is None
    assert result.visual.material.baseColorFactor.tolist() == [255, 0, 0, 255]
    assert result.mass / result.volume == pytest.approx(7.8)


def test_glb_files_of_the_command_line(tmp_path):
    """Written and read by trimesh, which knows nothing of the program's own reader and writer."""
    image = pytest.importorskip("PIL.Image").effect_noise((8, 8), 60).convert("RGB")
    vertices, faces = torus(120, 60)
    material = trimesh.visual.material.PBRMaterial(name="bark", baseColorTexture=image, roughnessFactor=0.25)
    sheet = trimesh.creation.box().subdivide().subdivide().subdivide()
    sheet.visual = trimesh.visual.TextureVisuals(uv=sheet.vertices[:, :2] / 2 + 0.5, material=material)
    ring = trimesh.Trimesh(vertices, faces, process=False, vertex_colors=colours_by(vertices[:, 2]))
    moved = trimesh.transformations.rotation_matrix(0.7, [1, 2, 3])
    moved[:3, 3] = 8, 0, 0
    scene = trimesh.Scene()
    scene.add_geometry(sheet, transform=moved)
    scene.add_geometry(ring, transform=np.diag([1, 1, -1, 1]))
    scene.export(tmp_path / "in.glb")
    command_line("remesh", tmp_path / "in.glb", tmp_path / "out.glb", "--vertices", 1500)
    made = {mesh.visual.kind: mesh for mesh in trimesh.load(tmp_path / "out.glb", process=False).dump()}
    assert set(made) == {"texture", "vertex"}
    assert made["texture"].visual.material.name == "bark"
    assert made["texture"].visual.material.roughnessFactor == 0.25
    back = np.asarray(made["texture"].visual.material.baseColorTexture.convert("RGB"))
    assert np.array_equal(back, np.asarray(image))
    box, other = (made[kind].copy() for kind in ("texture", "vertex"))
    box.remove_unreferenced_vertices()
    other.remove_unreferenced_vertices()
    assert np.allclose(box.bounds, sheet.copy().apply_transform(moved).bounds, atol=0.05)
    assert box.volume == pytest.approx(1, rel=0.05) and other.volume == pytest.approx(ring.volume, rel=0.05)
    local = trimesh.transform_points(box.vertices, np.linalg.inv(moved))
    assert np.abs(box.visual.uv - (local[:, :2] / 2 + 0.5)).max() < 0.05
    difference = other.visual.vertex_colors[:, 0].astype(int) - colours_by(-other.vertices[:, 2])[:, 0]
    assert np.abs(difference).max() < 6


def test_what_is_no_mesh_is_told():
    with pytest.raises(TypeError, match="mesh must be a Trimesh of trimesh, not a Scene"):
        gpremesh.trimesh.remesh(trimesh.Scene(mesh_of()), 500)
    with pytest.raises(TypeError, match="takes no uv"):
        gpremesh.trimesh.remesh(mesh_of(), 500, uv=torus()[0][:, :2])


def test_distance_takes_meshes():
    mesh = mesh_of()
    assert gpremesh.distance(mesh, gpremesh.trimesh.remesh(mesh, 500)).largest < 0.2
