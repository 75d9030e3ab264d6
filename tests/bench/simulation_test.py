# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The study of simulation on tiny meshes. ctest sets GPR_BUILD_DIR, where the programs are.

It wants the packages that scripts/measure/run simulation installs, and skips itself without them.
"""

import importlib.util
import io
import json
import os
import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
os.environ["PYTHONPATH"] = str(SCRIPTS)  # of the steps
os.environ["PYTHONDONTWRITEBYTECODE"] = "1"

from measure import pages, simulation

for package in simulation.NEEDED:
    if importlib.util.find_spec(package) is None:
        print(f"SKIPPED: {package} is not installed")
        sys.exit(77)

import numpy as np

from measure import poisson, simulation_tasks

BUILD = Path(os.environ["GPR_BUILD_DIR"])
TETRAHEDRON = (np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float),
               np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], np.int32))


def torus(along=40, across=20, jitter=0.0):
    """Closed, of radii 1 and 0.4; vertices are displaced at random by so many edge lengths at most."""
    u = np.repeat(np.arange(along), across)
    v = np.tile(np.arange(across), along)
    off = jitter * np.random.default_rng(1).uniform(-1, 1, (2, along * across))
    big, small = 2 * np.pi * (u + off[0]) / along, 2 * np.pi * (v + off[1]) / across
    ring = 1 + 0.4 * np.cos(small)
    vertices = np.stack([ring * np.cos(big), ring * np.sin(big), 0.4 * np.sin(small)], axis=1)
    a, b = u * across + v, (u + 1) % along * across + v
    c, d = (u + 1) % along * across + (v + 1) % across, u * across + (v + 1) % across
    return vertices, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int32)


class Meshes(unittest.TestCase):
    def test_a_closed_surface_is_known_from_an_open_one_and_a_wrongly_turned_face(self):
        vertices, faces = TETRAHEDRON
        turned = faces.copy()
        turned[0] = turned[0][::-1]
        self.assertTrue(simulation_tasks.is_closed(faces))
        self.assertFalse(simulation_tasks.is_closed(faces[1:]))
        self.assertFalse(simulation_tasks.is_closed(turned))

    def test_corners_of_one_place_are_welded(self):
        vertices, faces = TETRAHEDRON
        soup = vertices[faces.ravel()], np.arange(12, dtype=np.int32).reshape(-1, 3)
        self.assertFalse(simulation_tasks.is_closed(soup[1]))
        welded = simulation_tasks.welded(*soup)
        self.assertTrue(simulation_tasks.is_closed(welded[1]))
        self.assertAlmostEqual(simulation_tasks.enclosed_volume(*welded),
                               simulation_tasks.enclosed_volume(vertices, faces))

    def test_dihedral_angles_are_those_of_the_textbook(self):
        angles = simulation_tasks.dihedral_angles(TETRAHEDRON[0], np.array([[0, 1, 2, 3]]))
        np.testing.assert_allclose(angles, np.degrees(np.arccos(1 / 3)))
        corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
        for order in ([0, 1, 2, 3], [0, 2, 1, 3]):
            angles = np.sort(simulation_tasks.dihedral_angles(corner, np.array([order])).ravel())
            np.testing.assert_allclose(angles, 3 * [np.degrees(np.arccos(3 ** -0.5))] + 3 * [90])

    def test_angles_of_corners(self):
        angles = simulation_tasks.corner_angles(np.array([[0, 0, 0], [2, 0, 0], [0, 1, 0]], float),
                                                np.array([[0, 1, 2]]))
        np.testing.assert_allclose(angles[0], [90, np.degrees(np.arctan(0.5)), np.degrees(np.arctan(2))])


class Poisson(unittest.TestCase):
    def test_the_laplacian_of_a_regular_tetrahedron(self):
        matrix, mass = poisson.cotangent_laplacian(*TETRAHEDRON)
        weight = 3 ** -0.5  # half of twice the cotangent of 60°
        np.testing.assert_allclose(matrix.toarray(), weight * (4 * np.eye(4) - np.ones((4, 4))), atol=1e-12)
        self.assertAlmostEqual(mass.sum(), 4 * 3 ** 0.5 / 4 * 8)  # of four triangles, edges √8

    def test_its_condition_number_is_1(self):
        figures = poisson.figures(*TETRAHEDRON, (1, np.zeros(4, int)))
        self.assertAlmostEqual(figures["conditionNumber"], 1, places=6)
        self.assertEqual(figures["negativeWeightsPercent"], 0)

    def test_poor_triangles_are_harder_than_good_ones(self):
        figures = []
        for jitter in (0.05, 0.48):
            vertices, faces = torus(jitter=jitter)
            figures.append(poisson.figures(vertices, faces, (1, np.zeros(len(vertices), int))))
        good, poor = figures
        self.assertGreater(poor["conditionNumber"], 3 * good["conditionNumber"])
        self.assertGreater(poor["iterations"], 1.2 * good["iterations"])
        self.assertGreater(poor["negativeWeightsPercent"], good["negativeWeightsPercent"])

    def test_a_face_without_area_is_told(self):
        vertices, faces = TETRAHEDRON
        with self.assertRaisesRegex(ValueError, "no area"):
            poisson.cotangent_laplacian(vertices * [0, 0, 1], faces)


class WholeRun(unittest.TestCase):
    """Of what is built and installed; tetrahedra by TetGen only, which takes no time."""

    def setUp(self):
        if not (BUILD / "bin" / "gpremesh").exists():
            self.skipTest("gpremesh is not built")
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.work = Path(self.folder.name)
        (self.work / "build").mkdir()
        (self.work / "build" / "bin").symlink_to((BUILD / "bin").resolve())
        (self.work / "build" / "CMakeCache.txt").write_text("CMAKE_BUILD_TYPE:STRING=Release\n")

    def study(self, *meshes):
        """What it said, its record and its page."""
        said = io.StringIO()
        with redirect_stdout(said):
            simulation.main(self.work / "build", "a commit", ["--vertices", "300", "--tools", "tetgen-kept", "--out",
                                                             str(self.work / "out"), *map(str, meshes)])
        record = json.loads((self.work / "build/measure/simulation.json").read_text())
        return said.getvalue(), record, (self.work / "out/measurements_simulation.md").read_text()

    def test_a_torus_is_meshed_and_an_open_mesh_is_left_out(self):
        vertices, faces = torus()
        simulation_tasks.write(self.work / "torus.ply", vertices, faces)
        simulation_tasks.write(self.work / "open.ply", vertices, faces[1:])
        said, record, page = self.study(self.work / "torus.ply", self.work / "open.ply")
        self.assertIn("SKIPPED: open (it is not closed", said)
        self.assertEqual([mesh["name"] for mesh in record["meshes"]], ["torus"])
        mine = record["meshes"][0]["results"]["gpremesh"]
        self.assertEqual(mine["surface"]["vertices"], 300)
        self.assertTrue(mine["surface"]["closed"])
        self.assertGreater(mine["surface"]["smallestAngle"], 25)
        self.assertGreater(mine["tetgen-kept"]["tetrahedra"], 300)
        self.assertAlmostEqual(mine["tetgen-kept"]["volumeShare"], 1, places=3)
        self.assertEqual(sum(mine["tetgen-kept"]["histogram"]), 6 * mine["tetgen-kept"]["tetrahedra"])
        self.assertTrue(pages.is_sealed(page.partition("\n")[2]))
        self.assertIn("| torus | gpremesh | yes | 300 | 600 |", page)


class Failures(unittest.TestCase):
    def test_each_kind_is_a_sentence(self):
        run = [sys.executable, "-c"]
        self.assertEqual(simulation.outcome([*run, "pass"], 60), "")
        self.assertEqual(simulation.outcome([*run, "while True: pass"], 1), "not done after 1 s")
        with mock.patch.object(simulation, "WALL_SHARE", 0.5):
            self.assertEqual(simulation.outcome([*run, "import time; time.sleep(60)"], 1), "not done after 1 s")
        self.assertEqual(simulation.outcome([*run, "import os; os.abort()"], 60), "crash, signal 6")
        self.assertEqual(simulation.outcome([*run, "import sys; sys.exit('no such mesh')"], 60), "no such mesh")
        self.assertIn("not found", simulation.outcome(["/no/such/program"], 60))

    def test_a_library_that_raises_is_a_failure_of_its_step(self):
        with tempfile.TemporaryDirectory() as folder:
            figures = Path(folder, "figures.json")
            simulation_tasks.main(figures, "volume", "tetgen-kept", Path(folder, "absent.ply"))
            self.assertIn("failure", json.loads(figures.read_text()))


if __name__ == "__main__":
    unittest.main()
