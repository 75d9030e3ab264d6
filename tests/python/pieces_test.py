# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that are remeshed together, and a periodic cell."""

import numpy as np
import pytest

import gpremesh
from meshes import sheet


def halves():
    """Two sheets with a border in common, the second one mirrored."""
    vertices, faces = sheet()
    mirrored = vertices * [-1, 1, 1]
    return (vertices, faces), (mirrored, faces[:, ::-1])


def rows(points):
    return {tuple(p) for p in points}


def test_common_borders_have_the_same_vertices():
    a, b = gpremesh.remesh_together(halves(), vertex_count=500)
    seam = rows(a.vertices) & rows(b.vertices)
    assert len(seam) > 10
    assert all(p[0] == 0 for p in seam)
    assert len(a.vertices) + len(b.vertices) - len(seam) == 500
    for result, (vertices, _) in zip((a, b), halves()):
        heights = result.transfer(vertices[:, 2], "vertex")
        assert np.abs(heights - result.vertices[:, 2]).max() < 0.2


def test_labels_and_texture_are_those_of_each_mesh():
    (vertices, faces), second = halves()
    label = np.where(vertices[faces].mean(axis=1)[:, 1] < 15, 4, 9)
    pieces = [dict(vertices=vertices, faces=faces, regions=label, uv=vertices[:, :2] / 30), second]
    a, b = gpremesh.remesh_together(pieces, vertex_count=500)
    assert set(a.regions) == {4, 9}
    assert b.regions is None and b.uv is None
    corner = a.vertices[a.faces][:, :, :2] / 30
    assert np.abs(a.uv - corner).max() < 0.03


@pytest.mark.parametrize("pieces", [
    [],
    [(1, 2, 3)],
    5,
    sheet(),
    [dict(vertices=sheet()[0], faces=sheet()[1], colour=1)],
    [dict(vertices=sheet()[0])],
    [dict(vertices=sheet()[0], faces=sheet()[1], sizes=np.ones(961)), sheet()],
])
def test_what_cannot_be_meant_is_refused(pieces):
    with pytest.raises(ValueError):
        gpremesh.remesh_together(pieces)


def test_a_wrong_mesh_is_named():
    with pytest.raises(ValueError, match=r"pieces\[1\] must be a pair"):
        gpremesh.remesh_together([sheet(), (*sheet(), 1)])
    with pytest.raises(ValueError, match=r"pieces\[1\].faces"):
        gpremesh.remesh_together([sheet(), (sheet()[0], [[0, 1, 5000]])])


def test_objects_with_vertices_and_faces():
    results = gpremesh.remesh_together([gpremesh.FileMesh(*half) for half in halves()], vertex_count=500)
    for result, expected in zip(results, gpremesh.remesh_together(halves(), vertex_count=500)):
        assert np.array_equal(result.vertices, expected.vertices)


def test_the_order_of_meshes_with_marks_does_not_matter():
    (vertices, faces), second = halves()
    marked = dict(vertices=vertices, faces=faces, region=vertices[:, 1] < 10)
    for pieces in ([marked, second], [second, marked]):
        assert len(gpremesh.remesh_together(pieces, vertex_count=500)) == 2
    with pytest.raises(ValueError, match="sew=False"):
        gpremesh.remesh_together(halves(), sew=False)


def test_a_periodic_cell_has_matching_borders():
    vertices, faces = sheet()
    vertices[:, 2] = np.sin(vertices[:, 0] * np.pi / 15) + np.cos(vertices[:, 1] * np.pi / 15)
    vertices[vertices[:, 0] == 30, 2] = vertices[vertices[:, 0] == 0, 2]
    vertices[vertices[:, 1] == 30, 2] = vertices[vertices[:, 1] == 0, 2]
    result = gpremesh.remesh(vertices, faces, edge_length=2, periodic=(30, 30, 0))
    points = rows(result.vertices)
    for axis in (0, 1):
        end = result.vertices[result.vertices[:, axis] == 30]
        assert len(end) > 10
        begin = end - np.eye(3)[axis] * 30
        assert rows(begin) <= points
    west = vertices[faces, 0].mean(axis=1) < 15
    a, b = gpremesh.remesh_together([(vertices, faces[west]), (vertices, faces[~west])], edge_length=2, periodic=(30, 30, 0))
    begin, end = (rows(r.vertices[r.vertices[:, 0] == x] - [x, 0, 0]) for r, x in ((a, 0), (b, 30)))
    assert len(begin) > 10 and begin == end
    assert len(rows(a.vertices) & rows(b.vertices)) > 10
    with pytest.raises(gpremesh.Error, match="not periodic"):
        gpremesh.remesh(vertices, faces, edge_length=2, periodic=(30, 25, 0))
    with pytest.raises(ValueError, match="periodic"):
        gpremesh.remesh(vertices, faces, periodic=(30, 30))
