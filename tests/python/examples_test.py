# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first example of the page for each package, on another mesh."""

import importlib
import re
from pathlib import Path

import numpy as np
import pytest

import gpremesh
from meshes import torus, write_ply

DOCS = Path(__file__).resolve().parents[2] / "vcg_extras/docs"


@pytest.mark.parametrize("host", ["pyvista", "trimesh", "open3d"])
def test_first_example(host, tmp_path, monkeypatch):
    module = pytest.importorskip(host)
    if host == "pyvista":
        importlib.import_module("gpremesh.pyvista")  # found by itself only where gpremesh is installed
        monkeypatch.setattr(module.Plotter, "show", lambda plotter: plotter.close())  # there is no window
        monkeypatch.setattr(module, "OFF_SCREEN", True)
    monkeypatch.chdir(tmp_path)
    write_ply(tmp_path / "bunny.ply", *torus(120, 60, np.float32))
    text = (DOCS / f"python_{host}.md").read_text(encoding="utf-8")
    names = {}
    exec(re.search(r"```python\n(.*?)```", text, re.DOTALL).group(1), names)
    made = names["small"].points if host == "pyvista" else names["small"].vertices
    assert len(made) == 3000
    for written in tmp_path.glob("small.*"):
        assert len(gpremesh.read(written).vertices) == 3000
