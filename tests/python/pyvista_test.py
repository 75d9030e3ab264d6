# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The accessor, with the real PyVista."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pyvista = pytest.importorskip("pyvista", minversion="0.48", reason="PyVista 0.48 or later is not installed")

import gpremesh.pyvista  # noqa: E402  (from a wheel PyVista finds it by itself)
from meshes import sheet, torus


def polydata():
    return pyvista.PolyData.from_regular_faces(*torus(120, 60, np.float32))


def test_point_and_cell_data_are_carried_over():
    mesh = polydata()
    mesh.point_data["height"] = mesh.points[:, 2]
    mesh.point_data["label"] = (mesh.points[:, 0] > 0).astype(int)
    mesh.cell_data["middle"] = mesh.cell_centers().points
    mesh.field_data["name"] = ["torus"]
    mesh.compute_normals(inplace=True, split_vertices=False, consistent_normals=False)
    mesh.set_active_scalars("height")
    result = mesh.gpremesh.remesh(500, seed=3)
    assert result.n_points == 500 and result.n_cells == 1000 and result.points.dtype == np.float32
    assert np.abs(result["height"] - result.points[:, 2]).max() < 0.05
    assert set(result["label"]) == {0, 1}
    assert np.linalg.norm(result.cell_data["middle"] - result.cell_centers().points, axis=1).max() < 0.2
    assert np.allclose(np.linalg.norm(result.point_data["Normals"], axis=1), 1, atol=1e-5)
    assert "Normals" not in result.cell_data
    assert result.field_data["name"][0] == "torus" and result.active_scalars_name == "height"
    assert result.is_manifold
    assert mesh.n_points == 7200


def plate():
    """A flat sheet with the labels 4 and -1 inside and outside of a disk."""
    mesh = pyvista.Plane(i_resolution=60, j_resolution=60).triangulate()
    mesh.point_data.clear()
    labels = np.where(np.linalg.norm(mesh.cell_centers().points, axis=1) < 0.3, 4, -1)
    return mesh, labels


def area_of(mesh, labels, label):
    return mesh.compute_cell_sizes()["Area"][labels == label].sum()


def test_cell_data_tell_regions():
    mesh, labels = plate()
    wanted = area_of(mesh, labels, 4)
    mesh.cell_data["CellEntityIds"] = labels.astype(float)
    mesh.cell_data["patch"] = labels
    for regions in (None, "patch", labels):
        result = mesh.gpremesh.remesh(300, regions=regions)
        assert area_of(result, result.cell_data["CellEntityIds"], 4) == pytest.approx(wanted, rel=2e-3)
        assert np.array_equal(result.cell_data["CellEntityIds"], result.cell_data["patch"])
        assert ("region" in result.cell_data) == (regions is labels)
    assert np.array_equal(result.cell_data["region"], result.cell_data["patch"])
    without = plate()[0].gpremesh.remesh(300)
    assert np.array_equal(mesh.gpremesh.remesh(300, regions="off").points, without.points)
    assert not np.array_equal(result.points, without.points)
    with pytest.raises(ValueError, match="no such values"):
        mesh.gpremesh.remesh(300, regions="path")
    mesh.cell_data["patch"] = labels + 0.5
    with pytest.raises(ValueError, match="whole numbers"):
        mesh.gpremesh.remesh(300, regions="patch")


def test_cell_data_of_two_names_are_combined():
    mesh, labels = plate()
    mesh.cell_data["region"] = labels
    mesh.cell_data["material"] = (mesh.cell_centers().points[:, 0] > 0).astype(np.uint8)
    result = mesh.gpremesh.remesh(400)
    both = {pair: ((result.cell_data["region"] == pair[0]) & (result.cell_data["material"] == pair[1]))
            for pair in ((4, 0), (4, 1), (-1, 0), (-1, 1))}
    for (label, material), where in both.items():
        here = (labels == label) & (mesh.cell_data["material"] == material)
        assert area_of(result, where, True) == pytest.approx(area_of(mesh, here, True), rel=3e-3)


def test_polygons_lines_and_strips():
    points, quads = sheet()
    faces = np.column_stack([np.full(len(quads), 4), quads]).reshape(-1)
    mesh = pyvista.PolyData(points, faces=faces, lines=[2, 0, 1, 2, 1, 2])
    mesh.cell_data["number"] = np.arange(mesh.n_cells)
    result = mesh.gpremesh.remesh(200)
    assert result.n_points == 200 and result.cell_data["number"].min() >= 2
    with pytest.raises(ValueError, match="strips"):
        pyvista.PolyData(points, strips=[4, 0, 1, 31, 32]).gpremesh.remesh(100)


def test_texture_coordinates():
    mesh = pyvista.Plane(i_resolution=40, j_resolution=40).triangulate()
    result = mesh.gpremesh.remesh(200)
    assert result.n_points == 200
    wanted = result.points[:, :2] + 0.5
    assert np.abs(result.active_texture_coordinates - wanted).max() < 1e-3


def test_names_and_active_scalars_stay():
    mesh = pyvista.Plane(i_resolution=40, j_resolution=40).triangulate()
    mesh.point_data["TCoords"] = mesh.active_texture_coordinates
    mesh.point_data.active_texture_coordinates_name = "TCoords"
    mesh.point_data["heat"], mesh.cell_data["heat"] = np.zeros(mesh.n_points), np.ones(mesh.n_cells)
    for of in ("point", "cell"):
        mesh.set_active_scalars("heat", preference=of)
        result = mesh.gpremesh.remesh(200)
        assert result.active_scalars_info == mesh.active_scalars_info
        assert result.point_data.active_texture_coordinates_name == "TCoords"
        assert set(result.point_data) == set(mesh.point_data)


def test_samples_and_features():
    mesh = polydata()
    points = mesh.gpremesh.sample(300)
    assert 270 < points.n_points < 330 and points["radius"].min() > 0
    assert pyvista.Cube().triangulate().subdivide(4).clean().gpremesh.features().n_lines == 12 * 16


def test_errors_come_out():
    with pytest.raises(gpremesh.Error):
        polydata().gpremesh.remesh(3)
    with pytest.raises(TypeError):
        polydata().gpremesh.remesh(300, sed=5)
    with pytest.raises(TypeError, match="takes no uv"):
        polydata().gpremesh.remesh(300, uv=None)


def test_pyvista_finds_it_by_itself(tmp_path):
    """By the entry point, as an installed package has it."""
    info = tmp_path / "gpremesh-0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: gpremesh\nVersion: 0\n")
    project = (Path(__file__).parents[2] / "pyproject.toml").read_text()
    head = '[project.entry-points."pyvista.accessors"]\n'
    entry = project.split(head)[1].splitlines()[0].replace('"', "")
    (info / "entry_points.txt").write_text(f"[pyvista.accessors]\n{entry}\n")
    code = (f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import pyvista; "
            "assert 'gpremesh' not in sys.modules; "
            "print(pyvista.Sphere().gpremesh.remesh(100).n_points)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.stdout.strip() == "100", done.stderr
