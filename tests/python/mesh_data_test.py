# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes with a mesh: selections, sizes, edges, texture, and what is carried over."""

import numpy as np
import pytest

import gpremesh
from meshes import cube, sheet, torus


def edge_lengths(vertices, faces):
    sides = vertices[faces] - vertices[np.roll(faces, 1, axis=1)]
    return np.linalg.norm(sides, axis=2).mean(axis=1)


def test_selected_faces_alone():
    vertices, quads = sheet()
    selected = vertices[quads].mean(axis=1)[:, 0] < 15
    result = gpremesh.remesh(vertices, quads, selected=selected, vertex_count=150)
    kept = result.kept_face
    assert set(kept[kept >= 0]) == set(np.flatnonzero(~selected))
    stay = result.kept_vertex >= 0
    assert np.array_equal(result.vertices[stay], vertices[result.kept_vertex[stay]])
    assert (kept < 0).sum() < 2 * selected.sum() and result.report["options"]["selectedOnly"]


def test_region_has_smaller_triangles():
    vertices, faces = torus(120, 60)
    region = vertices[:, 0] > 0
    result = gpremesh.remesh(vertices, faces, vertex_count=800, region=region, feature_disk_scale=0.4)
    assert result.report["options"]["featureRegion"] == "selection"
    middle = result.vertices[result.faces].mean(axis=1)[:, 0]
    lengths = edge_lengths(result.vertices, result.faces)
    assert lengths[middle > 0.5].mean() < 0.7 * lengths[middle < -0.5].mean()


def test_given_edges_become_edges_of_the_result():
    vertices, quads = sheet(32)
    across = np.flatnonzero(vertices[:, 0] == 16)
    line = np.column_stack([across[:-1], across[1:]])
    result = gpremesh.remesh(vertices, quads, vertex_count=200, feature_edges=line)
    assert result.report["options"]["features"] == "selected"
    assert result.report["counts"]["featureEdges"] == len(line)
    below = result.vertices[result.faces][:, :, 0] < 15.5
    above = result.vertices[result.faces][:, :, 0] > 16.5
    assert not (below.any(axis=1) & above.any(axis=1)).any()
    crossing = gpremesh.remesh(vertices, quads, vertex_count=200, features="off")
    corners = crossing.vertices[crossing.faces][:, :, 0]
    assert ((corners.min(axis=1) < 15.5) & (corners.max(axis=1) > 16.5)).any()


def test_an_empty_list_of_edges():
    vertices, faces = cube()
    result = gpremesh.remesh(vertices, faces, vertex_count=300, feature_edges=[])
    assert result.report["counts"]["featureEdges"] == 0


def test_edges_found_beside_edges_given():
    vertices, faces = cube()
    middle = np.flatnonzero((vertices[:, 2] == 0) & (vertices[:, 0] == 0.5))
    line = np.column_stack([middle[:-1], middle[1:]])
    found = gpremesh.remesh(vertices, faces, vertex_count=300).report["counts"]["featureEdges"]
    both = gpremesh.remesh(vertices, faces, vertex_count=300, feature_edges=line, features="auto")
    assert found == 12 * 12 and both.report["counts"]["featureEdges"] == found + len(line)


def test_detected_edges_can_be_given():
    vertices, faces = cube()
    found = gpremesh.features(vertices, faces)
    assert found.edges.dtype == faces.dtype and len(found.edges) == 12 * 12
    assert found.strength.shape == (len(vertices),) and found.strength.max() > 60
    assert (found.vertex[(np.isin(vertices, (0, 1))).all(axis=1)] & 2).all()
    assert found.report["features"]["edges"] == 144 and found.face.dtype == bool
    result = gpremesh.remesh(vertices, faces, vertex_count=300, feature_edges=found.edges)
    assert result.report["counts"]["featureEdges"] == 144


def test_transfer_of_vertices():
    vertices, faces = torus()
    result = gpremesh.remesh(vertices, faces, vertex_count=300)
    expected = (vertices[result.corner_index] * result.barycentric[:, :, None].astype(float)).sum(axis=1)
    assert np.abs(result.transfer(vertices, "vertex") - expected).max() < 1e-12
    assert result.transfer(vertices[:, 0].astype(np.float32)).dtype == np.float32
    colour = np.full((len(vertices), 4), 200, np.uint8)
    assert (result.transfer(colour) == 200).all() and result.transfer(colour).dtype == np.uint8
    labels = np.array(["left", "right"])[(vertices[:, 0] > 0).astype(int)]
    assert set(result.transfer(labels)) == {"left", "right"}
    nearest = np.take_along_axis(result.corner_index, result.barycentric.argmax(axis=1)[:, None], 1)[:, 0]
    assert np.array_equal(result.transfer(np.arange(len(vertices))), nearest)


def test_constants_and_places_of_map_coordinates_stay():
    vertices, faces = torus()
    vertices += [4.5e5, 5.4e6, 300]
    result = gpremesh.remesh(vertices, faces, vertex_count=300)
    for constant in (5.4e6, 0.1, np.inf):
        assert (result.transfer(np.full(len(vertices), constant)) == constant).all()
    assert np.abs(result.barycentric.sum(axis=1) - 1).max() < 1e-15
    points = (vertices[result.corner_index] * result.barycentric[:, :, None]).sum(axis=1)
    assert np.linalg.norm(result.transfer(vertices) - points, axis=1).max() < 1e-8
    samples = gpremesh.sample(vertices, faces, count=300)
    points = (vertices[faces[samples.face_index]] * samples.barycentric[:, :, None]).sum(axis=1)
    assert np.linalg.norm(points - samples.points, axis=1).max() < 1e-6
    values = {"height": np.full(len(vertices), 5.4e6)}
    carried = gpremesh.FileMesh(vertices, faces, vertex_values=values).remesh(300)
    assert (carried.vertex_values["height"] == 5.4e6).all()


def test_results_do_not_depend_on_later_changes():
    vertices, faces = torus()
    result = gpremesh.remesh(vertices, faces, vertex_count=300)
    corners, heights = result.corner_index.copy(), result.transfer(vertices[:, 2])
    faces[:] = 0
    assert np.array_equal(result.corner_index, corners)
    assert np.array_equal(result.transfer(vertices[:, 2]), heights)


def test_transfer_of_faces():
    vertices, quads = sheet()
    result = gpremesh.remesh(vertices, quads, vertex_count=400)
    middles = vertices[quads].mean(axis=1)
    carried = result.transfer(middles, "face")
    assert np.linalg.norm(carried - result.vertices[result.faces].mean(axis=1), axis=1).max() < 1.5
    with pytest.raises(ValueError, match="rows"):
        result.transfer(middles, "vertex")
    with pytest.raises(ValueError, match="edge"):
        result.transfer(middles, "edge")


def test_a_value_that_is_no_number_stays_where_it_is():
    vertices, faces = torus()
    values = np.zeros(len(vertices))
    values[0] = np.nan
    result = gpremesh.remesh(vertices, faces, vertex_count=300)
    touches = ((result.corner_index == 0) & (result.barycentric != 0)).any(axis=1)
    assert np.array_equal(np.isnan(result.transfer(values)), touches)


def texture_of(vertices):
    """Texture coordinates that go once around the torus."""
    return np.column_stack([np.arctan2(vertices[:, 1], vertices[:, 0]) / (2 * np.pi) % 1, vertices[:, 2]])


def test_texture_coordinates_with_a_seam():
    vertices, faces = torus(120, 60)
    corners = texture_of(vertices)[faces]
    beyond = np.ptp(corners[:, :, 0], axis=1) > 0.5
    corners[beyond, :, 0] = np.where(corners[beyond, :, 0] < 0.5, corners[beyond, :, 0] + 1, corners[beyond, :, 0])
    result = gpremesh.remesh(vertices, faces, vertex_count=600, uv=corners)
    assert result.uv.shape == (1200, 3, 2) and result.uv.dtype == np.float32
    assert np.ptp(result.uv[:, :, 0], axis=1).max() < 0.2  # no face lies across the seam
    wanted = texture_of(result.vertices)[result.faces]
    difference = np.abs(result.uv[:, :, 0] - wanted[:, :, 0]) % 1
    assert np.minimum(difference, 1 - difference).max() < 0.01
    vertex_index, split, uv = result.split_at_seams()
    assert len(vertex_index) > 600 and np.array_equal(vertex_index[split], result.faces)
    assert np.array_equal(uv[split], result.uv)


def test_texture_coordinates_of_vertices_and_images():
    vertices, quads = sheet()
    image = (vertices[quads].mean(axis=1)[:, 0] > 15).astype(int)
    result = gpremesh.remesh(vertices, quads, vertex_count=300, uv=vertices[:, :2], image=image)
    assert np.abs(result.uv - result.vertices[result.faces][:, :, :2]).max() < 0.5
    assert set(result.image) == {0, 1}
    vertex_index, split, uv = gpremesh.remesh(vertices, quads, vertex_count=300, uv=vertices[:, :2]).split_at_seams()
    assert np.array_equal(vertex_index, np.arange(300))
    with pytest.raises(ValueError, match="uv"):
        gpremesh.remesh(vertices, quads, vertex_count=300).split_at_seams()


def test_texture_coordinates_of_polygons_corners():
    vertices, quads = sheet()
    flat = vertices[:, :2] / 30
    expected = gpremesh.remesh(vertices, quads, vertex_count=200, uv=flat)
    assert np.array_equal(gpremesh.remesh(vertices, quads, vertex_count=200, uv=flat[quads]).uv, expected.uv)
    for width in (3, 5):
        with pytest.raises(ValueError, match="uv must have .* 4, 2"):
            gpremesh.remesh(vertices, quads, vertex_count=200, uv=np.zeros((len(quads), width, 2)))
    mixed = [list(quad) for quad in quads[1:]] + [list(quads[0][[0, 1, 2]]), list(quads[0][[0, 2, 3]])]
    padded = np.full((len(mixed), 4, 2), np.nan)
    for row, polygon in zip(padded, mixed):
        row[:len(polygon)] = flat[polygon]
    expected = gpremesh.remesh(vertices, mixed, vertex_count=200, uv=flat)
    assert np.array_equal(gpremesh.remesh(vertices, mixed, vertex_count=200, uv=padded).uv, expected.uv)
    assert np.array_equal(gpremesh.FileMesh(vertices, mixed, uv=padded).remesh(200).uv, expected.uv)


def test_samples():
    vertices, faces = torus(120, 60, np.float32)
    samples = gpremesh.sample(vertices, faces, count=1000)
    number = len(samples.points)
    assert 900 < number < 1100 and samples.points.dtype == np.float32
    assert samples.radius.shape == (number,) and samples.face_index.shape == (number,)
    points = (vertices[faces[samples.face_index]] * samples.barycentric[:, :, None]).sum(axis=1)
    assert np.abs(points - samples.points).max() < 1e-5
    apart = np.linalg.norm(points[:, None] - points[None], axis=2) + 10 * np.eye(number)
    assert apart.min() > 0.6 * samples.disk_radius


def test_distances():
    vertices, faces = torus(120, 60)
    moved = gpremesh.distance((vertices, faces), (vertices * 1.01, faces))
    assert moved.lower <= moved.largest <= moved.upper < 0.0401 and moved.upper > 0.0399
    assert moved.rms >= moved.mean > 0.01 and moved.p999 <= moved.largest
    result = gpremesh.remesh(vertices, faces, vertex_count=600, check=True)
    measured = gpremesh.distance((vertices, faces), result)
    check = result.report["check"]
    assert abs(measured.a_to_b.rms / check["fromInput"]["rms"] - 1) < 0.05
    assert abs(measured.b_to_a.rms / check["toInput"]["rms"] - 1) < 0.05
    one, two = (gpremesh.distance((vertices, faces), result, threads=threads) for threads in (1, 2))
    assert one == two
    for wrong in (5, (vertices,), (vertices, faces + 10000)):
        with pytest.raises(ValueError, match="^b"):
            gpremesh.distance((vertices, faces), wrong)
    with pytest.raises(ValueError, match="samples"):
        gpremesh.distance(result, result, samples=-1)
