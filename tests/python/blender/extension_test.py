# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension in Blender without a window. Run by a Python with Blender as a module (bpy of PyPI).

    extension_test.py               the sources, with a gpremesh that can be imported
    extension_test.py EXTENSION.zip the extension as a user installs it, with the gpremesh that it brings
"""

import importlib.util
import os
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[3] / "vcg_extras/python/blender"
home = tempfile.TemporaryDirectory()
os.environ["BLENDER_USER_RESOURCES"] = home.name  # not the user's own settings

import bpy  # noqa: E402
import numpy as np  # noqa: E402


def enable(zip_file):
    """Registers the extension. Returns what takes it away again."""
    if zip_file is None:
        where = SOURCES / "__init__.py"
        spec = importlib.util.spec_from_file_location("gpremesh_extension", where, submodule_search_locations=[str(SOURCES)])
        sys.modules[spec.name] = module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        module.register()
        return module.unregister
    bpy.ops.preferences.addon_enable(module="bl_pkg")
    done = bpy.ops.extensions.package_install_files(filepath=zip_file, repo="user_default", enable_on_install=True)
    assert done == {"FINISHED"}, done
    assert "bl_ext.user_default.gpremesh" in bpy.context.preferences.addons.keys()
    import gpremesh
    assert home.name in gpremesh.__file__, gpremesh.__file__
    return lambda: bpy.ops.preferences.addon_disable(module="bl_ext.user_default.gpremesh")


def read(collection, name, length, dtype=np.float32):
    values = np.zeros(len(collection) * length, dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, length) if length > 1 else values


class Extension(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        enable_again()

    def sphere(self, **more):
        bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, **more)
        return bpy.context.object

    def remesh(self, **parameters):
        return bpy.ops.object.gpremesh(**parameters)

    def test_count_and_shape(self):
        thing = self.sphere()
        self.assertEqual(self.remesh(size="COUNT", vertex_count=700), {"FINISHED"})
        mesh = thing.data
        self.assertEqual((len(mesh.vertices), len(mesh.polygons), len(mesh.edges)), (700, 1396, 2094))
        self.assertFalse(mesh.validate())
        radius = np.linalg.norm(read(mesh.vertices, "co", 3), axis=1)
        self.assertLess(np.abs(radius - 1).max(), 0.02)
        normals = read(mesh.polygons, "normal", 3)
        middles = read(mesh.polygons, "center", 3)
        self.assertGreater((normals * middles).sum(axis=1).min(), 0.8)  # to the outside

    def test_texture_coordinates_and_materials_stay(self):
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=60, y_subdivisions=60, size=2)
        thing = bpy.context.object
        for name in ("left", "right"):
            thing.data.materials.append(bpy.data.materials.new(name))
        middles = read(thing.data.polygons, "center", 3)
        thing.data.polygons.foreach_set("material_index", (middles[:, 0] > 0).astype(np.int32))
        name = thing.data.uv_layers.active.name
        self.remesh(size="PERCENT", percent=20)
        mesh = thing.data
        self.assertEqual([material.name for material in mesh.materials], ["left", "right"])
        corners = read(mesh.vertices, "co", 3)[read(mesh.loops, "vertex_index", 1, np.int32)]
        uv = read(mesh.uv_layers[name].uv, "vector", 2)
        self.assertLess(np.abs(uv - (corners[:, :2] + 1) / 2).max(), 1e-3)
        # The border between the materials is an edge of the result.
        at_left = read(mesh.polygons, "material_index", 1, np.int32) == 0
        of_faces = corners.reshape(-1, 3, 3)[:, :, 0]
        self.assertLess(of_faces[at_left].max(), 1e-4)
        self.assertGreater(of_faces[~at_left].min(), -1e-4)

    def test_seams_of_a_texture_stay(self):
        thing = self.sphere()
        self.remesh(size="COUNT", vertex_count=900)
        uv = read(thing.data.uv_layers.active.uv, "vector", 2).reshape(-1, 3, 2)
        self.assertLess(np.ptp(uv[..., 0], axis=1).max(), 0.5)  # no triangle goes around the whole sphere

    def test_materials_without_texture_coordinates(self):
        thing = self.sphere(calc_uvs=False)
        for name in ("low", "high"):
            thing.data.materials.append(bpy.data.materials.new(name))
        rings = read(thing.data.polygons, "center", 3)[:, 2] > 0
        thing.data.polygons.foreach_set("material_index", rings.astype(np.int32))
        self.remesh(size="COUNT", vertex_count=900)
        mesh = thing.data
        height = read(mesh.vertices, "co", 3)[read(mesh.loops, "vertex_index", 1, np.int32)].reshape(-1, 3, 3)[..., 2]
        high = read(mesh.polygons, "material_index", 1, np.int32) == 1
        self.assertGreater(height[high].min(), -0.01)
        self.assertLess(height[~high].max(), 0.01)

    def grid(self):
        """A flat square from -1 to 1 without a texture: no line but its border."""
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=60, y_subdivisions=60, size=2, calc_uvs=False)
        return bpy.context.object

    def disk(self, thing, name):
        """Labels -3 and 7 on the faces of a disk and around it."""
        mesh = thing.data
        inside = np.linalg.norm(read(mesh.polygons, "center", 3), axis=1) < 0.6
        mesh.attributes.new(name, "INT", "FACE").data.foreach_set("value", np.where(inside, -3, 7).astype(np.int32))

    def area_of(self, mesh, name, label):
        areas = read(mesh.polygons, "area", 1)
        return areas[read(mesh.attributes[name].data, "value", 1, np.int32) == label].sum()

    def test_an_attribute_of_faces_tells_regions(self):
        places = {}
        for regions, is_labelled in (("patch", True), ("", True), ("material_index", False)):
            thing = self.grid()
            if is_labelled:
                self.disk(thing, "patch")
                wanted = self.area_of(thing.data, "patch", -3)
            self.remesh(size="COUNT", vertex_count=300, regions=regions)
            mesh = thing.data
            places[regions] = read(mesh.vertices, "co", 3)
            if regions == "patch":
                self.assertEqual(set(read(mesh.attributes["patch"].data, "value", 1, np.int32)), {-3, 7})
                self.assertAlmostEqual(self.area_of(mesh, "patch", -3) / wanted, 1, delta=0.002)
        self.assertTrue(np.array_equal(places[""], places["material_index"]))
        self.assertFalse(np.array_equal(places["patch"], places[""]))

    def test_sizes_of_an_attribute_and_of_a_group(self):
        for kind in ("attribute", "group", "exact"):
            thing = self.grid()
            places = read(thing.data.vertices, "co", 3)
            right = (places[:, 0] > 0).astype(np.float32)
            if kind == "group":
                thing.vertex_groups.new(name="wanted").add([int(v) for v in np.flatnonzero(right)], 1, "REPLACE")
            else:
                lengths = (0.12 - 0.06 * right).astype(np.float32)
                thing.data.attributes.new("wanted", "FLOAT", "POINT").data.foreach_set("value", lengths)
            size = {"size": "SIZES"} if kind == "exact" else {"size": "COUNT", "vertex_count": 700}
            self.remesh(sizes="wanted", finest=0.5, **size)
            mesh = thing.data
            if kind != "exact":
                self.assertEqual(len(mesh.vertices), 700)
            ends = read(mesh.vertices, "co", 3)[read(mesh.edges, "vertices", 2, np.int32)]
            lengths, middle = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1), ends[:, :, 0].mean(axis=1)
            fine, coarse = lengths[middle > 0.3].mean(), lengths[middle < -0.5].mean()
            self.assertAlmostEqual(fine / coarse, 0.5, delta=0.06, msg=kind)
            if kind == "exact":
                self.assertAlmostEqual(fine, 0.06, delta=0.005)

    def test_a_periodic_cell(self):
        thing = self.grid()
        self.remesh(size="COUNT", vertex_count=200, periodic=(2, 0, 0))
        places = read(thing.data.vertices, "co", 3)
        left, right = (np.sort(places[places[:, 0] == x][:, 1]) for x in (-1, 1))
        self.assertGreater(len(left), 5)
        self.assertTrue(np.array_equal(left, right))

    def test_junctions_stay(self):
        self.grid()
        self.grid().rotation_euler = (0, np.pi / 2, 0)
        bpy.ops.object.select_all(action="SELECT")
        bpy.ops.object.join()
        thing = bpy.context.object
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.remove_doubles(threshold=1e-5)
        bpy.ops.object.mode_set(mode="OBJECT")
        self.remesh(size="COUNT", vertex_count=600, junctions="keep")
        mesh = thing.data
        self.assertEqual(len(mesh.vertices), 600)
        edges = np.sort(read(mesh.loops, "vertex_index", 1, np.int32).reshape(-1, 3)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2))
        self.assertGreater((np.unique(edges, axis=0, return_counts=True)[1] == 4).sum(), 8)

    def test_edges_marked_sharp(self):
        thing = self.grid()
        mesh = thing.data
        places = read(mesh.vertices, "co", 3)
        ends = read(mesh.edges, "vertices", 2, np.int32)
        on_line = (np.abs(places[ends][:, :, 0]) < 1e-5).all(axis=1)
        with self.assertRaisesRegex(RuntimeError, "marked sharp"):
            self.remesh(size="COUNT", vertex_count=300, features="selected")
        mesh.attributes.new("sharp_edge", "BOOLEAN", "EDGE").data.foreach_set("value", on_line)
        self.remesh(size="COUNT", vertex_count=300, features="selected")
        of_faces = read(mesh.vertices, "co", 3)[read(mesh.loops, "vertex_index", 1, np.int32)].reshape(-1, 3, 3)[..., 0]
        self.assertFalse(((of_faces.min(axis=1) < -1e-4) & (of_faces.max(axis=1) > 1e-4)).any())

    def test_fields_are_the_rows_of_the_engine(self):
        import gpremesh._core
        fields = bpy.ops.object.gpremesh.get_rna_type().properties
        for entry in gpremesh._core.parameters("remesh"):
            self.assertIn(entry["name"], fields.keys())
        self.assertEqual({item.identifier for item in fields["boundary"].enum_items},
                         {"resample", "keep", "free", "smooth", "match"})
        thing = self.sphere()
        self.remesh(size="DETAIL", detail="coarse", symmetry="z")
        places = read(thing.data.vertices, "co", 3)
        mirrored = places * np.array([1, 1, -1], np.float32)
        self.assertLess(max(np.abs(places - p).max(axis=1).min() for p in mirrored), 1e-6)
        self.assertLess(len(places), 100)

    def test_names_that_are_not_there(self):
        self.grid()
        for names in ({"regions": "patch"}, {"sizes": "patch"}):
            with self.assertRaisesRegex(RuntimeError, "names patch"):
                self.remesh(size="COUNT", vertex_count=300, **names)
        with self.assertRaisesRegex(RuntimeError, "names no attribute"):
            self.remesh(size="SIZES")

    def test_colours_attributes_and_vertex_groups(self):
        thing = self.sphere()
        mesh = thing.data
        places = read(mesh.vertices, "co", 3)
        colours = np.column_stack([(places + 1) / 2, np.ones(len(places))]).astype(np.float32)
        mesh.color_attributes.new("paint", "FLOAT_COLOR", "POINT").data.foreach_set("color", colours.reshape(-1))
        corner_colours = colours[read(mesh.loops, "vertex_index", 1, np.int32)]
        mesh.color_attributes.new("corners", "BYTE_COLOR", "CORNER").data.foreach_set("color", corner_colours.reshape(-1))
        mesh.attributes.new("height", "FLOAT", "POINT").data.foreach_set("value", places[:, 2].copy())
        upper = read(mesh.polygons, "center", 3)[:, 2] > 0
        mesh.attributes.new("upper", "BOOLEAN", "FACE").data.foreach_set("value", upper)
        group = thing.vertex_groups.new(name="half")
        group.add([int(v) for v in np.flatnonzero(places[:, 0] > 0)], 0.75, "REPLACE")
        bpy.ops.object.shade_smooth()
        self.remesh(size="COUNT", vertex_count=1500)
        places = read(mesh.vertices, "co", 3)
        expected = np.column_stack([(places + 1) / 2, np.ones(len(places))])
        paint = mesh.color_attributes["paint"]
        self.assertEqual((paint.data_type, paint.domain), ("FLOAT_COLOR", "POINT"))
        self.assertLess(np.abs(read(paint.data, "color", 4) - expected).max(), 0.03)
        corners = mesh.color_attributes["corners"]
        self.assertEqual((corners.data_type, corners.domain), ("BYTE_COLOR", "CORNER"))
        at = read(mesh.loops, "vertex_index", 1, np.int32)
        self.assertLess(np.abs(read(corners.data, "color", 4) - expected[at]).max(), 0.05)
        self.assertLess(np.abs(read(mesh.attributes["height"].data, "value", 1) - places[:, 2]).max(), 0.03)
        upper = read(mesh.attributes["upper"].data, "value", 1, bool)
        self.assertGreater(np.mean(upper == (read(mesh.polygons, "center", 3)[:, 2] > 0)), 0.95)
        weights = [sum(element.weight for element in vertex.groups if element.group == 0) for vertex in mesh.vertices]
        far = np.abs(places[:, 0]) > 0.1
        self.assertLess(np.abs(np.array(weights) - 0.75 * (places[:, 0] > 0))[far].max(), 1e-3)
        self.assertFalse(read(mesh.attributes["sharp_face"].data, "value", 1, bool).any() if "sharp_face" in mesh.attributes else False)

    def test_a_copy_beside(self):
        thing = self.sphere()
        self.remesh(size="COUNT", vertex_count=400, as_copy=True)
        made = bpy.context.object
        self.assertIsNot(made, thing)
        self.assertEqual((len(thing.data.vertices), len(made.data.vertices)), (96 * 47 + 2, 400))
        self.assertGreater(made.location.x - thing.location.x, 2)
        self.assertTrue(made.select_get() and not thing.select_get())

    def test_undo(self):
        bpy.context.preferences.edit.use_global_undo = True
        self.sphere()
        bpy.ops.ed.undo_push(message="sphere")
        self.remesh(size="COUNT", vertex_count=400)
        bpy.ops.ed.undo_push(message="remesh")
        self.assertEqual(len(bpy.context.object.data.vertices), 400)
        bpy.ops.ed.undo()
        self.assertEqual(len(bpy.context.object.data.vertices), 96 * 47 + 2)
        bpy.ops.ed.redo()
        self.assertEqual(len(bpy.context.object.data.vertices), 400)

    def test_triangles_are_regular_in_a_scaled_scene(self):
        thing = self.sphere(calc_uvs=False)
        thing.scale = (4, 1, -1)
        bpy.context.view_layer.update()
        self.remesh(size="LENGTH", edge_length=0.2, adapt=0)
        mesh = thing.data
        places = read(mesh.vertices, "co", 3) * np.array([4, 1, 1])
        ends = places[read(mesh.edges, "vertices", 2, np.int32)]
        lengths = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
        self.assertAlmostEqual(lengths.mean(), 0.2, delta=0.01)
        self.assertLess(lengths.std(), 0.04)

    def test_triangles_are_regular_under_a_stretched_parent(self):
        bpy.ops.object.empty_add()
        parent = bpy.context.object
        thing = self.sphere(calc_uvs=False)
        thing.parent, parent.scale, thing.rotation_euler = parent, (4, 1, 1), (0, 0, 0.7)
        bpy.context.view_layer.update()
        self.remesh(size="LENGTH", edge_length=0.2, adapt=0)
        mesh = thing.data
        linear = np.array(thing.matrix_world)[:3, :3]
        ends = (read(mesh.vertices, "co", 3) @ linear.T)[read(mesh.edges, "vertices", 2, np.int32)]
        lengths = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
        self.assertAlmostEqual(lengths.mean(), 0.2, delta=0.01)
        self.assertLess(lengths.std(), 0.04)
        self.assertLess(np.abs(np.linalg.norm(read(mesh.vertices, "co", 3), axis=1) - 1).max(), 0.03)

    def test_marks_that_are_lost_are_told(self):
        thing = self.sphere()
        mesh = thing.data
        self.assertEqual(self.notes_of(thing), [])
        mesh.attributes.new("sharp_edge", "BOOLEAN", "EDGE").data[0].value = True
        mesh.edges[0].use_seam = True
        mesh.normals_split_custom_set_from_vertices([(0, 0, 1)] * len(mesh.vertices))
        notes = " ".join(self.notes_of(thing))
        for what in ("Edges marked sharp", "Seams", "Custom normals"):
            self.assertIn(what, notes)

    def notes_of(self, thing):
        module = next(module for name, module in sys.modules.items() if name.endswith(".mesh_data"))
        return module.take(thing).notes

    def test_refusals_leave_the_mesh(self):
        bpy.ops.mesh.primitive_torus_add()
        thing = bpy.context.object
        before = read(thing.data.vertices, "co", 3).tobytes()
        with self.assertRaisesRegex(RuntimeError, "smallest"):
            self.remesh(size="COUNT", vertex_count=4)
        thing.shape_key_add(name="Basis")
        with self.assertRaisesRegex(RuntimeError, "shape keys"):
            self.remesh(size="COUNT", vertex_count=400)
        self.assertEqual(read(thing.data.vertices, "co", 3).tobytes(), before)
        bpy.ops.object.mode_set(mode="EDIT")
        self.assertFalse(bpy.ops.object.gpremesh.poll())

    def test_the_menu_has_it(self):
        entries = [function.__module__ for function in bpy.types.VIEW3D_MT_object.draw._draw_funcs]
        self.assertTrue(any(name.startswith(("gpremesh_extension", "bl_ext.")) for name in entries), entries)


def enable_again():
    """Factory settings take add-ons away."""
    global disable
    if not hasattr(bpy.types, "OBJECT_OT_gpremesh"):
        disable = enable(ZIP)


def tearDownModule():
    """Blender as a module crashes when its process ends with a class registered, of whatever add-on."""
    disable()


if __name__ == "__main__":
    ZIP = str(Path(sys.argv.pop(1)).resolve()) if len(sys.argv) > 1 and sys.argv[1].endswith(".zip") else None
    unittest.main()
