# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in and out: types, shapes, no copies, and what is refused."""

import gc
import tracemalloc
import weakref

import numpy as np
import pytest

import gpremesh
from meshes import is_closed_manifold, sheet, torus


@pytest.mark.parametrize("real", [np.float32, np.float64])
@pytest.mark.parametrize("index", [np.int32, np.int64])
def test_types_of_the_result_are_those_given(real, index):
    vertices, faces = torus(dtype=real)
    result = gpremesh.remesh(vertices, faces.astype(index), vertex_count=200)
    assert result.vertices.shape == (200, 3) and result.vertices.dtype == real
    assert result.faces.shape == (400, 3) and result.faces.dtype == index
    assert result.face_index.dtype == index and result.corner_index.dtype == index
    assert is_closed_manifold(result.faces)


def test_types_that_are_converted():
    vertices, faces = torus(dtype=np.float32)
    expected = gpremesh.remesh(vertices, faces, vertex_count=200)
    for other in (faces.astype(np.uint16), faces.astype(">i4"), np.asfortranarray(faces), faces.tolist()):
        assert np.array_equal(gpremesh.remesh(vertices, other, vertex_count=200).faces, expected.faces)
    for other in (np.asfortranarray(vertices), np.repeat(vertices, 2, axis=0)[::2]):
        assert np.array_equal(gpremesh.remesh(other, faces, vertex_count=200).vertices, expected.vertices)
    whole = np.rint(100 * vertices).astype(np.int16)
    assert gpremesh.remesh(whole, faces, vertex_count=200).vertices.dtype == np.float64


def test_input_is_left_alone_and_may_be_read_only():
    vertices, faces = torus()
    before = vertices.copy(), faces.copy()
    vertices.flags.writeable = faces.flags.writeable = False
    gpremesh.remesh(vertices, faces, vertex_count=200)
    assert np.array_equal(vertices, before[0]) and np.array_equal(faces, before[1])


def peak_of_python(vertices, faces):
    tracemalloc.start()
    gpremesh.remesh(vertices, faces, vertex_count=100, preset="fast")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak


def test_arrays_in_order_are_not_copied():
    vertices, faces = torus(400, 200)
    assert peak_of_python(vertices, faces) < 0.1 * vertices.nbytes
    assert peak_of_python(np.asfortranarray(vertices), faces) > vertices.nbytes  # the means can tell
    assert peak_of_python(vertices, faces.astype(np.int64)) > faces.nbytes


def test_points_lie_where_the_result_says():
    vertices, faces = torus()
    result = gpremesh.remesh(vertices, faces, vertex_count=300, preset="paper")
    points = (vertices[result.corner_index] * result.barycentric[:, :, None]).sum(axis=1)
    assert np.abs(points - result.vertices).max() < 1e-5
    assert np.array_equal(result.corner_index, faces[result.face_index])


def test_a_note_where_float32_is_coarse():
    vertices, faces = torus()
    for real, is_told in ((np.float32, True), (np.float64, False)):
        notes = gpremesh.remesh((vertices + 1e5).astype(real), faces, vertex_count=200).report["notes"]
        assert any("float32" in note for note in notes) == is_told


def test_polygons_are_those_of_the_triangles_they_are_cut_into():
    vertices, quads = sheet()
    result = gpremesh.remesh(vertices, quads, vertex_count=200)
    assert result.faces.dtype == np.int64 and result.face_index.max() < len(quads)
    corners = np.take_along_axis(quads[result.face_index], np.argsort(quads[result.face_index]), axis=1)
    assert all(set(three) <= set(four) for three, four in zip(result.corner_index, corners))
    ragged = [list(map(int, quad)) for quad in quads[1:]]
    ragged += [[int(v) for v in quads[0][[0, 1, 2]]], [int(v) for v in quads[0][[0, 2, 3]]]]
    mixed = gpremesh.remesh(vertices, ragged, vertex_count=200)
    assert mixed.vertices.shape == (200, 3) and mixed.face_index.max() < len(ragged)


WRONG = [
    ("vertices", dict(vertices=np.zeros((5, 2)))),
    ("vertices", dict(vertices=np.zeros(5))),
    ("vertices", dict(vertices="points")),
    ("vertices", dict(vertices=np.zeros((4, 3), complex))),
    ("vertices", dict(vertices=[[0, 0], [1, 2, 3]])),
    ("vertices", dict(vertices=np.full((4, 3), np.nan))),
    ("vertices", dict(vertices=np.full((4, 3), -np.inf))),
    ("faces", dict(faces=np.zeros((5, 2), int))),
    ("faces", dict(faces=np.zeros((5, 3)))),
    ("faces", dict(faces=[[0, 1, 2], [0, 1]])),
    ("faces", dict(faces=[[0, 1, 1800]])),
    ("faces", dict(faces=[[0, 1, -1]])),
    ("faces", dict(faces=np.array([[0, 1, 2**40]]))),
    ("faces", dict(faces=7)),
    ("faces", dict(faces=None)),
    ("selected", dict(selected=np.ones(7, bool))),
    ("selected", dict(selected=np.arange(3600))),
    ("region", dict(region=np.zeros(3600, bool))),
    ("feature_edges", dict(feature_edges=[[0, 1, 2]])),
    ("feature_edges", dict(feature_edges=[[0, 1800]])),
    ("feature_edges", dict(feature_edges=[[0, 1], [0, 900]])),
    ("uv", dict(uv=np.zeros((7, 2)))),
    ("uv", dict(uv=np.full((1800, 2), np.inf))),
    ("image", dict(image=np.zeros(3600, int))),
    ("image", dict(image=np.zeros(3600), uv=np.zeros((1800, 2)))),
    *(("sizes", dict(sizes=np.full(1800, size))) for size in (np.nan, np.inf, -1, 0, 1e50, 1e-50, "1")),
    *(("periodic", dict(periodic=(size, 0, 0))) for size in (np.nan, np.inf, -1, 0, "1")),
    ("periodic", dict(periodic=(1, 1))),
    ("periodic", dict(periodic=(1, -1, 0))),
    ("vertex_count", dict(vertex_count=0)),
    ("vertex_count", dict(vertex_count=2.5)),
    ("vertex_count", dict(vertex_count=True)),
    ("vertex_count", dict(vertex_count=10**30)),
    ("percent", dict(percent=-1)),
    ("edge_length", dict(edge_length=float("nan"))),
    ("max_error", dict(max_error="2")),
    ("max_error", dict(max_error="-2%")),
    ("max_edge", dict(max_edge="-2%")),
    ("min_edge", dict(min_edge="two%")),
    ("only one of vertex_count, face_count, percent", dict(vertex_count=100, percent=10)),
    ("preset", dict(preset="quickly")),
    ("sew", dict(sew="yes")),
    ("seed", dict(seed=-1)),
    ("seed", dict(seed="1")),
    ("adapt", dict(adapt=2)),
    ("threads", dict(threads=5000)),
    ("adapt", dict(adapt="much")),
    ("features", dict(features="selected")),
    ("feature_region", dict(feature_region="selection")),
    ("progress", dict(progress=5)),
]


@pytest.mark.parametrize("name, arguments", WRONG, ids=lambda part: part if isinstance(part, str) else "")
def test_wrong_arguments_are_named(name, arguments):
    vertices, faces = torus()
    with pytest.raises(TypeError if name == "progress" else ValueError, match=name):
        gpremesh.remesh(**{"vertices": vertices, "faces": faces, **arguments})


def test_names_that_are_no_parameters():
    with pytest.raises(TypeError, match="vertexcount"):
        gpremesh.remesh(*torus(), vertexcount=5)
    with pytest.raises(TypeError, match="max_error"):
        gpremesh.sample(*torus(), max_error=5)


def test_a_number_of_faces():
    assert len(gpremesh.remesh(*torus(), face_count=1024).faces) == 1024
    with pytest.raises(gpremesh.Error, match="1024 and 1026"):
        gpremesh.remesh(*torus(), face_count=1025)
    assert len(gpremesh.remesh(*torus(), face_count=1025, allow_nearest=True).faces) == 1024
    with pytest.raises(ValueError, match="face_count"):
        gpremesh.remesh(*torus(), face_count=1024, vertex_count=100)


def test_sizes_in_the_unit_of_the_coordinates():
    vertices, faces = torus()
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    result = gpremesh.remesh(vertices, faces, sizes=np.full(len(vertices), diagonal / 40))
    corners = result.vertices[result.faces]
    assert abs(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=-1).mean() * 40 / diagonal - 1) < 0.04
    assert len(gpremesh.remesh(vertices, faces, sizes=np.ones(len(vertices)), vertex_count=500).vertices) == 500
    with pytest.raises(ValueError, match="sizes"):
        gpremesh.remesh(vertices, faces, sizes=np.ones(3))


def test_what_the_engine_refuses():
    with pytest.raises(gpremesh.Error) as refused:
        gpremesh.remesh(*torus(), vertex_count=4)
    assert refused.value.status == "count too small"
    smallest = refused.value.smallest_count
    assert smallest > 4 and str(smallest) in str(refused.value)
    assert len(gpremesh.remesh(*torus(), vertex_count=smallest).vertices) == smallest
    with pytest.raises(gpremesh.Error) as refused:
        gpremesh.remesh(np.zeros((4, 3)), [[0, 1, 2]], vertex_count=4)
    assert refused.value.status == "unusable input" and refused.value.smallest_count is None
    for vertices, faces in ((np.zeros((0, 3)), np.zeros((0, 3), int)), (np.zeros((3, 3)), []),
                            (np.zeros((3, 3)), np.zeros((0, 4), int))):
        with pytest.raises(gpremesh.Error, match="face"):
            gpremesh.remesh(vertices, faces)


def test_nothing_is_kept_alive_or_leaks():
    vertices, faces = torus(20, 10)
    result = gpremesh.remesh(vertices, faces, vertex_count=60)
    kept = weakref.ref(result.vertices), weakref.ref(vertices), weakref.ref(faces)
    del result, vertices, faces
    gc.collect()
    assert [reference() for reference in kept] == [None, None, None]
    vertices, faces = torus(20, 10)
    for i in range(30):
        many_calls(vertices, faces, i)
    before = resident_bytes()
    for i in range(150):
        many_calls(vertices, faces, i)
    assert resident_bytes() - before < 1_000_000


def many_calls(vertices, faces, i):
    gpremesh.remesh(vertices, faces, vertex_count=300, uv=vertices[:, :2], threads=1, progress=lambda *_: True)
    too_few = [dict(vertex_count=4)] if i % 10 == 0 else []  # the smallest count is searched for half a second
    for wrong in (*too_few, dict(seed="x"), dict(feature_edges=[[0, 100]]),
                  dict(progress=lambda *_: False)):
        with pytest.raises((ValueError, gpremesh.Error)):
            gpremesh.remesh(vertices, faces, **{"vertex_count": 60, "threads": 1, **wrong})


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096


def test_regions_stay_connected_and_may_have_any_labels():
    vertices, faces = torus()
    labels = np.where(vertices[faces, 0].mean(axis=1) > 0, -3, 70000)
    result = gpremesh.remesh(vertices, faces, vertex_count=300, regions=labels)
    middle = result.vertices[result.faces, 0].mean(axis=1)
    assert set(result.regions) == {-3, 70000}
    assert np.array_equal(result.regions == -3, middle > 0)
    assert np.array_equal(result.regions, labels[result.middle_face_index])
    assert gpremesh.remesh(vertices, faces, vertex_count=300).regions is None
    with pytest.raises(ValueError, match="regions"):
        gpremesh.remesh(vertices, faces, regions=labels[1:])
