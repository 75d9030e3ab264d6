# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin in the real PyMeshLab. ctest sets the variables:

GPREMESH_PLUGIN, GPR_PLUGIN_FLOAT, GPR_PLUGIN_2020  the plugin with double scalars, and others
GPR_GPREMESH, GPR_MESH_TOOL, GPR_SCRIPTS, GPR_WORK_DIR, GPR_ROOT, GPR_MODELS_DIR
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import numpy
import pymeshlab

ROOT = pathlib.Path(os.environ["GPR_ROOT"])
PACKAGE_DIR = ROOT / "filter_geodesic_poisson/python"
sys.path.insert(0, str(PACKAGE_DIR))
import gpremesh_pymeshlab  # noqa: E402  loads the plugin

WORK = pathlib.Path(os.environ["GPR_WORK_DIR"]) / "pymeshlab"
SCRIPTS = pathlib.Path(os.environ["GPR_SCRIPTS"])
GPREMESH = os.environ.get("GPR_GPREMESH", "")
REMESHING, SAMPLING, RETRIANGULATION, FEATURES, COMPARISON = gpremesh_pymeshlab.FILTERS


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)


def made(task):
    """A mesh of the tests' own tool, as a file, with nothing selected."""
    path = WORK / (task + ".ply")
    if not path.exists():
        raw = WORK / "raw.ply"
        subprocess.run([os.environ["GPR_MESH_TOOL"], task, str(raw)], check=True)
        meshes = opened(raw)
        meshes.set_selection_none()  # a filter's default is to do no more than what is selected
        meshes.save_current_mesh(str(path))
    return str(path)


def opened(path):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes


def contents(meshes):
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


class PluginTest(unittest.TestCase):
    def assert_same(self, one, other):
        for a, b in zip(contents(one), contents(other)):
            self.assertTrue(numpy.array_equal(a, b), "%s against %s" % (a.shape, b.shape))


class FilterTest(PluginTest):
    def test_remeshing_in_place_and_into_a_new_layer(self):
        meshes = opened(made("make"))
        figures = meshes.meshing_geodesic_poisson_disk_remeshing(targetvertexnum=700, newlayer=True)
        self.assertEqual(figures["vertex_number"], 700)
        self.assertEqual(meshes.mesh_number(), 2)
        self.assertEqual(meshes.current_mesh().vertex_number(), 700)
        self.assertGreater(figures["mean_radius_ratio"], 0.95)
        meshes.set_current_mesh(0)
        meshes.meshing_geodesic_poisson_disk_remeshing(targetvertexnum=700)
        self.assertEqual(meshes.current_mesh().face_number(), 1400)  # a torus: V - E + F = 0

    def test_samples_become_the_vertices(self):
        meshes = opened(made("make"))
        figures = meshes.generate_sampling_geodesic_poisson_disk(targetvertexnum=600)
        points = meshes.current_mesh().vertex_matrix()
        self.assertEqual(len(points), figures["point_number"])
        self.assertEqual(meshes.current_mesh().face_number(), 0)
        numpy.testing.assert_allclose(meshes.current_mesh().vertex_scalar_array(), figures["disk_radius"])
        meshes.set_current_mesh(0)
        meshes.meshing_retriangulate_from_samples(samplelayer=1)
        vertices = meshes.current_mesh().vertex_matrix()
        self.assertEqual(set(map(tuple, vertices)), set(map(tuple, points)))

    def test_features_are_marked(self):
        meshes = opened(made("roof"))
        figures = meshes.compute_features_by_second_order_difference()
        self.assertEqual((figures["edge_number"], figures["line_number"]), (40, 1))
        self.assertEqual(meshes.current_mesh().selected_vertex_number(), 41)
        self.assertEqual(meshes.current_mesh().selected_face_number(), 0)
        strength = meshes.current_mesh().vertex_scalar_array()
        self.assertAlmostEqual(strength.max(), 90, places=3)

    def test_choices_by_name_and_lengths_in_percent(self):
        meshes = opened(made("make"))
        meshes.meshing_geodesic_poisson_disk_remeshing(
            targetlen=pymeshlab.PercentageValue(3), preset="fast", lambda_=1.5, boundary="free")
        again = opened(made("make"))
        length = 0.03 * again.current_mesh().bounding_box().diagonal()
        again.meshing_geodesic_poisson_disk_remeshing(
            targetlen=pymeshlab.PureValue(length), preset=1, lambda_=1.5, boundary=2)
        self.assert_same(meshes, again)

    def test_selected_faces_only(self):
        meshes = opened(made("roof"))
        meshes.compute_selection_by_condition_per_face(condselect="(x0 < 20)")
        chosen = meshes.current_mesh().selected_face_number()
        self.assertGreater(chosen, 0)
        before = meshes.current_mesh().face_number()
        meshes.meshing_geodesic_poisson_disk_remeshing(targetvertexnum=200, selected=True)
        self.assertGreaterEqual(meshes.current_mesh().face_number(), before - chosen)

    def test_comparison_makes_two_layers_with_as_many_faces(self):
        meshes = opened(made("make"))
        getattr(meshes, COMPARISON)(targetvertexnum=700)
        self.assertEqual(meshes.mesh_number(), 3)
        self.assertEqual([meshes.mesh(i).face_number() for i in (1, 2)], [1400, 1400])
        meshes.set_current_mesh(0)
        self.assert_same(meshes, opened(made("make")))

    def test_refusal_tells_why_and_changes_nothing(self):
        meshes = opened(made("make"))
        with self.assertRaisesRegex(pymeshlab.PyMeshLabException, "cannot be meshed with 3 vertices"):
            meshes.meshing_geodesic_poisson_disk_remeshing(targetvertexnum=3)
        with self.assertRaisesRegex(pymeshlab.PyMeshLabException, "RelaxIter.* must be between"):
            meshes.meshing_geodesic_poisson_disk_remeshing(relaxiter=-1)
        with self.assertRaisesRegex(pymeshlab.PyMeshLabException, "no layer number 4"):
            meshes.meshing_retriangulate_from_samples(samplelayer=4)
        self.assert_same(meshes, opened(made("make")))

    def test_no_faces_no_layer(self):
        meshes = pymeshlab.MeshSet()
        with self.assertRaises(pymeshlab.PyMeshLabException):
            meshes.meshing_geodesic_poisson_disk_remeshing()
        meshes.add_mesh(pymeshlab.Mesh(numpy.zeros((1, 3))))
        with self.assertRaises(pymeshlab.PyMeshLabException):
            meshes.meshing_geodesic_poisson_disk_remeshing()

    def test_same_result_with_verbose_progress(self):
        quiet, verbose = opened(made("make")), pymeshlab.MeshSet(verbose=True)
        verbose.load_new_mesh(made("make"))
        for meshes in (quiet, verbose):
            meshes.meshing_geodesic_poisson_disk_remeshing()
        self.assert_same(quiet, verbose)


@unittest.skipUnless(GPREMESH, "gpremesh is not built")
class CommandLineTest(PluginTest):
    def compare(self, mesh, options, **parameters):
        out = WORK / "cli.ply"
        subprocess.run([GPREMESH, "remesh", mesh, str(out), "--quiet"] + options, check=True)
        meshes = opened(mesh)
        meshes.meshing_geodesic_poisson_disk_remeshing(**parameters)
        self.assert_same(meshes, opened(out))

    def test_same_coordinates_and_faces(self):
        torus = made("make")
        self.compare(torus, [])
        self.compare(torus, ["--vertices", "777", "--seed", "42"], targetvertexnum=777, seed=42)
        self.compare(torus, ["--percent", "12.3"], targetperc=12.3)
        self.compare(torus, ["--edge-length", "0.07"], targetlen=pymeshlab.PureValue(0.07))
        self.compare(torus, ["--lambda", "1.5"], lambda_=1.5)
        self.compare(torus, ["--adapt", "0.5"], adapt=0.5)
        self.compare(torus, ["--adapt", "auto"], adapt=-1)
        self.compare(torus, ["--preset", "paper", "--relax", "2"], preset="paper", relaxiter=2)

    @unittest.skipUnless(os.environ.get("GPR_MODELS_DIR"), "no GPR_MODELS_DIR")
    def test_same_on_scans(self):
        for model in ("igea_269k", "laurana_50k_colour_open", "facemask_62k_open"):
            self.compare("%s/%s.ply" % (os.environ["GPR_MODELS_DIR"], model), [])

    def test_doubles_come_through(self):
        """Coordinates that no float has: both are handed the same doubles."""
        meshes = opened(made("make"))
        meshes.apply_matrix_flip_or_swap_axis(flipx=True)
        matrix = meshes.current_mesh().vertex_matrix() / 3
        shifted = pymeshlab.MeshSet()
        shifted.add_mesh(pymeshlab.Mesh(matrix, meshes.current_mesh().face_matrix()))
        path = WORK / "doubles.ply"
        shifted.save_current_mesh(str(path))
        self.compare(str(path), [])


class ScriptTest(PluginTest):
    def run_script(self, meshes, path):
        meshes.load_filter_script(str(path))
        meshes.apply_filter_script()
        meshes.clear_filter_script()

    def changed(self, name, **values):
        """The shipped script of a filter with other values, as a file."""
        text = (SCRIPTS / (name + ".mlx")).read_text()
        for key, value in values.items():
            text, found = re.subn('(name="%s"[^>]* value=")[^"]*' % key, r"\g<1>%s" % value, text)
            self.assertEqual(found, 1, key)
        path = WORK / (name + ".mlx")
        path.write_text(text)
        return path

    def test_shipped_scripts_do_what_calls_do(self):
        for name in (REMESHING, FEATURES, SAMPLING):
            by_script, by_call = opened(made("roof")), opened(made("roof"))
            self.run_script(by_script, SCRIPTS / (name + ".mlx"))
            number = {} if name == FEATURES else {"targetvertexnum": 10000}
            by_call.apply_filter(name, **number)
            self.assert_same(by_script, by_call)
            self.assertEqual(by_script.mesh_number(), by_call.mesh_number())

    def test_values_of_a_script_are_taken(self):
        meshes = opened(made("make"))
        self.run_script(meshes, self.changed(REMESHING, TargetPerc=0, TargetVertexNum=777, Seed=42))
        again = opened(made("make"))
        again.meshing_geodesic_poisson_disk_remeshing(targetvertexnum=777, seed=42)
        self.assert_same(meshes, again)

    def test_retriangulation(self):
        meshes = opened(made("make"))
        self.run_script(meshes, self.changed(SAMPLING, TargetPerc=0, TargetVertexNum=600))
        points = meshes.current_mesh().vertex_number()
        meshes.set_current_mesh(0)
        self.run_script(meshes, self.changed(RETRIANGULATION, SampleLayer=1))
        self.assertEqual(meshes.current_mesh().vertex_number(), points)


class LoadTest(unittest.TestCase):
    """What a user sees who takes the wrong plugin; the troubleshooting page has the same words."""

    def expect_words(self, plugin, words):
        with self.assertRaises(pymeshlab.PyMeshLabException) as caught:
            pymeshlab.load_plugin(str(plugin))
        self.assertIn(words, str(caught.exception))
        page = (ROOT / "vcg_extras/docs/troubleshooting.md").read_text(encoding="utf-8")
        self.assertIn(words.replace("`", "\\`"), page)

    def plugin_in(self, variable):
        plugin = os.environ.get(variable)
        if not plugin or not os.path.exists(plugin):
            self.skipTest("no plugin in " + variable)
        return plugin

    def changed(self, *pair):
        """Our plugin with other bytes in the place of some."""
        content = pathlib.Path(self.plugin_in("GPREMESH_PLUGIN")).read_bytes()
        self.assertIn(pair[0], content)
        path = WORK / (self.id() + ".so")
        path.write_bytes(content.replace(*pair))
        return path

    def test_plugin_for_2020(self):
        self.expect_words(self.plugin_in("GPR_PLUGIN_2020"), "is not a MeshLab plugin")

    def test_plugin_with_floats(self):
        self.expect_words(self.plugin_in("GPR_PLUGIN_FLOAT"),
                          "has different floating point precision from the running MeshLab version")

    def test_plugin_for_2024(self):
        self.expect_words(self.changed(b"2025.07d", b"2024.07d"),
                          "has different version from the running MeshLab version")

    def test_plugin_of_a_newer_system(self):
        newer = self.changed(b"GLIBCXX_3.4.", b"GLIBCXX_9.4.")
        self.expect_words(newer, "does not seem to be a Qt Plugin")
        self.expect_words(newer, "version `GLIBC")

    def test_cut_off(self):
        path = WORK / "cut_off.so"
        path.write_bytes(pathlib.Path(self.plugin_in("GPREMESH_PLUGIN")).read_bytes()[:5000])
        self.expect_words(path, "is an invalid ELF object")

    def test_no_such_file(self):
        self.expect_words("nowhere.so", "does not exists")

    def test_loaded_twice(self):
        self.expect_words(self.plugin_in("GPREMESH_PLUGIN"), "has been already loaded")


class PackageTest(unittest.TestCase):
    def run_example(self, path, **environment):
        result = subprocess.run(
            [sys.executable, str(PACKAGE_DIR / "remesh_scan.py"), made("make"), str(WORK / "example.ply"), "5"],
            env=dict(os.environ, PYTHONPATH=str(path), **environment), capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("640 vertices, 1280 faces", result.stdout)
        self.assertRegex(result.stdout, r"scan to result: RMS 0\.\d+ %")
        saved = opened(WORK / "example.ply")  # a mesh does not live longer than its MeshSet
        self.assertEqual(saved.current_mesh().vertex_number(), 640)

    def test_example(self):
        self.run_example(PACKAGE_DIR)

    def test_example_with_the_installed_package(self):
        target, wheels = WORK / "installed", WORK / "wheel"
        for folder in (target, wheels):
            shutil.rmtree(folder, ignore_errors=True)
        subprocess.run([sys.executable, str(ROOT / "scripts/release/make_wheel"), os.environ["GPREMESH_PLUGIN"], str(wheels)],
                       check=True, capture_output=True)
        (wheel,) = wheels.glob("gpremesh_pymeshlab-*.whl")
        subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps",
                        "--disable-pip-version-check", "--target", str(target), str(wheel)], check=True)
        self.run_example(target, GPREMESH_PLUGIN=str(target / "gpremesh_pymeshlab/libfilter_geodesic_poisson.so"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
