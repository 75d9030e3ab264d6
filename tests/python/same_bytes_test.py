# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same bytes as the command line, and its report."""

import json
import os
from pathlib import Path

import numpy as np
import pytest

import gpremesh
from meshes import command_line, cube, read_ply, sheet, torus, write_ply


def compare(tmp_path, vertices, faces, words, **parameters):
    """Remeshes by the command line and by the package; returns the command line's report."""
    write_ply(tmp_path / "in.ply", vertices, faces)
    command_line("remesh", tmp_path / "in.ply", tmp_path / "out.ply", "--report", tmp_path / "r.json", *words)
    result = gpremesh.remesh(vertices, faces, **parameters)
    expected_vertices, expected_faces = read_ply(tmp_path / "out.ply")
    assert result.vertices.dtype == expected_vertices.dtype
    assert result.vertices.tobytes() == expected_vertices.tobytes()
    assert result.faces.tobytes() == expected_faces.tobytes()
    report = json.loads((tmp_path / "r.json").read_text())
    compare_reports(result.report, report)
    return report


def compare_reports(ours, theirs):
    for report in (ours, theirs):  # what is the machine's, not the result's
        for key in ("seconds", "peakMemoryBytes"):
            assert report.pop(key)
        for mesh in ("input", "result"):
            report[mesh].pop("file")
    assert ours == theirs


@pytest.mark.parametrize("real", [np.float32, np.float64])
def test_a_closed_mesh(tmp_path, real):
    compare(tmp_path, *torus(dtype=real), ["--vertices", 250], vertex_count=250)


def test_sharp_edges_and_a_largest_error(tmp_path):
    report = compare(tmp_path, *cube(), ["--max-error", "2%", "--seed", 5], max_error="2%", seed=5)
    assert report["counts"]["featureEdges"] > 0


def test_quads_and_many_options(tmp_path):
    vertices, quads = sheet()
    compare(tmp_path, vertices, quads.astype(np.int32), ["--percent", 30, "--boundary", "keep", "--lambda", 1.5,
            "--sew", "off", "--check"], percent=30, boundary="keep", lambda_=1.5, sew=False, check=True)


def test_the_default_size(tmp_path):
    report = compare(tmp_path, *torus(), [])
    assert report["options"]["percent"] == 10


def test_igea(tmp_path):
    folder = os.environ.get("GPR_MODELS_DIR", "")
    model = Path(folder) / "igea_269k.ply"
    if not folder or not model.is_file():
        pytest.skip("GPR_MODELS_DIR has no igea_269k.ply")
    vertices, faces = read_ply(model)
    compare(tmp_path, vertices, faces, ["--vertices", 13434], vertex_count=13434)
