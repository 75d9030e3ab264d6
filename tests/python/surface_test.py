# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface that is prepared once: the bytes of single runs, whatever ran before."""

import copy
import pickle
import threading

import numpy as np
import pytest

import gpremesh
from meshes import cube, sheet, torus

RUNS = [
    dict(vertex_count=200),
    dict(vertex_count=400, preset="fast"),
    dict(percent=20, seed=7),
    dict(vertex_count=200, adapt=1),
    dict(vertex_count=300, preset="paper"),
    dict(vertex_count=200, sew=False),
    dict(max_error="5%", preset="fast"),
    dict(vertex_count=200),
]


def assert_same(ours, theirs):
    assert ours.vertices.tobytes() == theirs.vertices.tobytes()
    assert ours.faces.tobytes() == theirs.faces.tobytes()
    assert ours.report["notes"] == theirs.report["notes"]


@pytest.mark.parametrize("mesh", [torus(), cube(), sheet()], ids=["torus", "cube", "sheet"])
def test_runs_have_the_bytes_of_single_runs(mesh):
    surface = gpremesh.Surface(*mesh)
    for parameters in RUNS:
        assert_same(surface.remesh(**parameters), gpremesh.remesh(*mesh, **parameters))


def test_marks_may_differ_from_run_to_run():
    vertices, faces = torus()
    surface = gpremesh.Surface(vertices, faces)
    half = vertices[faces[:, 0], 0] > 0
    region = vertices[:, 1] > 0
    sizes = 0.2 + 0.1 * (vertices[:, 0] > 0)
    for marks in (dict(selected=half), dict(selected=~half), dict(region=region), dict(sizes=sizes), dict()):
        parameters = dict(marks, vertex_count=1000)
        assert_same(surface.remesh(**parameters), gpremesh.remesh(vertices, faces, **parameters))


def test_a_failed_run_leaves_the_surface_as_it_was():
    mesh = torus()
    surface = gpremesh.Surface(*mesh)
    with pytest.raises(gpremesh.Error):
        surface.remesh(vertex_count=2)
    with pytest.raises(gpremesh.Error):
        surface.remesh(vertex_count=250, progress=lambda share, stage: False)
    with pytest.raises(ValueError):
        surface.remesh(vertex_count=-1)
    with pytest.raises(TypeError):
        surface.remesh(vertex_number=5)
    assert_same(surface.remesh(vertex_count=250), gpremesh.remesh(*mesh, vertex_count=250))


def test_copies_are_prepared_anew():
    surface = gpremesh.Surface(*torus())
    expected = surface.remesh(vertex_count=200)
    for copied in (copy.deepcopy(surface), pickle.loads(pickle.dumps(surface))):
        assert_same(copied.remesh(vertex_count=200), expected)


def test_a_run_inside_of_a_run_is_refused():
    surface = gpremesh.Surface(*torus())
    with pytest.raises(RuntimeError, match="progress"):
        surface.remesh(vertex_count=100, progress=lambda share, stage: surface.remesh(vertex_count=50))
    assert len(surface.remesh(vertex_count=100).vertices) == 100


def test_threads_wait_for_each_other():
    mesh = torus()
    surface = gpremesh.Surface(*mesh)
    counts = [150, 200, 250, 300]
    made = {}

    def run(count):
        made[count] = surface.remesh(vertex_count=count)

    threads = [threading.Thread(target=run, args=(count,)) for count in counts]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for count in counts:
        assert_same(made[count], gpremesh.remesh(*mesh, vertex_count=count))


def test_levels_are_those_of_single_runs():
    mesh = torus()
    told = []
    made = gpremesh.levels(*mesh, vertex_count=[300, 200], progress=lambda share, stage: told.append(share))
    for level, count in zip(made, (300, 200)):
        assert_same(level, gpremesh.remesh(*mesh, vertex_count=count, check=True))
    assert made[0].report["error"]["hausdorff"]["upper"] < made[1].report["error"]["hausdorff"]["upper"]
    assert told == sorted(told) and told[-1] <= 1


@pytest.mark.parametrize("sizes", [{}, {"percent": []}, {"percent": [5], "face_count": [200]}, {"percent": 10}])
def test_levels_need_sizes_of_one_kind(sizes):
    with pytest.raises(ValueError, match="levels needs one of|percent must be a list"):
        gpremesh.levels(*torus(), **sizes)


def test_a_symmetric_result():
    vertices, faces = torus()
    result = gpremesh.remesh(vertices, faces, vertex_count=251, symmetry="x")
    assert len(result.vertices) == 251
    rows = {row.tobytes() for row in result.vertices + 0.0}
    assert all(row.tobytes() in rows for row in result.vertices * [-1, 1, 1] + 0.0)
    surface = gpremesh.Surface(vertices, faces)
    assert_same(surface.remesh(vertex_count=251, symmetry="x"), result)
    with pytest.raises(gpremesh.Error, match="not symmetric"):
        gpremesh.remesh(vertices + 0.2 * vertices[:, 1:2] ** 2 * [1, 0, 0] + vertices[:, 1:2] * [0.1, 0, 0], faces,
                        vertex_count=200, symmetry="x")


def test_detail_off_is_no_size():
    vertices, faces = torus()
    parameters = dict(percent=20)
    assert_same(gpremesh.remesh(vertices, faces, detail="off", **parameters),
                gpremesh.remesh(vertices, faces, **parameters))
    sizes = np.full(len(vertices), 0.3)
    assert_same(gpremesh.remesh(vertices, faces, detail="off", sizes=sizes),
                gpremesh.remesh(vertices, faces, sizes=sizes))
