# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files with all that they hold: the bytes of the command line, and arrays there and back."""

import copy
import json
import pickle
import struct
import warnings

import numpy as np
import pytest

import gpremesh
from meshes import command_line, cube, sheet, torus

PIXEL = bytes.fromhex(  # an image of one pixel, as PNG
    "89504e470d0a1a0a0000000d49484452000000010000000108060000001f15c4890000000d49444154789c63f8cfc0f01f00"
    "0500010000ffff5d0db5e70000000049454e44ae426082")


def colours(vertices):
    share = (vertices - vertices.min(axis=0)) / np.ptp(vertices, axis=0)
    return dict(zip(("red", "green", "blue"), (255 * share).round().astype(np.uint8).T))


def write_glb(path, vertices, faces, uv):
    """A binary glTF file of one mesh with a material that has an image."""
    parts = [vertices.astype("<f4"), uv.astype("<f4"), faces.astype("<u4")]
    blob, views = b"", []
    for part in [*(part.tobytes() for part in parts), PIXEL]:
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(part)})
        blob += part + b"\0" * (-len(part) % 4)
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "roughnessFactor": 0.7}}],
        "textures": [{"source": 0}], "images": [{"bufferView": 3, "mimeType": "image/png"}],
        "bufferViews": views, "buffers": [{"byteLength": len(blob)}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3",
             "min": vertices.min(axis=0).tolist(), "max": vertices.max(axis=0).tolist()},
            {"bufferView": 1, "componentType": 5126, "count": len(uv), "type": "VEC2"},
            {"bufferView": 2, "componentType": 5125, "count": faces.size, "type": "SCALAR"}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob
    path.write_bytes(struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks)


def textured_glb(path):
    vertices, quads = sheet()
    write_glb(path, vertices, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]), vertices[:, :2] / 30)


def document_of(path):
    content = path.read_bytes()
    return json.loads(content[20:20 + struct.unpack_from("<I", content, 12)[0]])


@pytest.mark.parametrize("ending", ["ply", "obj", "off", "stl", "glb"])
def test_the_bytes_of_the_command_line(tmp_path, ending):
    source = tmp_path / f"in.{ending}"
    vertices, faces = torus(dtype=np.float32)
    mesh = gpremesh.FileMesh(vertices, faces, vertex_values=colours(vertices))
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        gpremesh.write(source, mesh)
    assert bool(told) == (ending in ("off", "stl"))  # these hold no colours
    command_line("remesh", source, tmp_path / f"theirs.{ending}", "--vertices", 300)
    gpremesh.write(tmp_path / f"ours.{ending}", gpremesh.read(source).remesh(300))
    assert (tmp_path / f"ours.{ending}").read_bytes() == (tmp_path / f"theirs.{ending}").read_bytes()


def test_binary_gltf_with_its_material_and_image(tmp_path):
    textured_glb(tmp_path / "in.glb")
    mesh = gpremesh.read(tmp_path / "in.glb")
    assert mesh.uv.shape == (len(mesh.faces), 3, 2) and mesh.vertices.dtype == np.float32
    small = mesh.remesh(150)
    gpremesh.write(tmp_path / "ours.glb", small)
    command_line("remesh", tmp_path / "in.glb", tmp_path / "theirs.glb", "--vertices", 150)
    content = (tmp_path / "ours.glb").read_bytes()
    assert content == (tmp_path / "theirs.glb").read_bytes()
    assert PIXEL in content
    (material,) = document_of(tmp_path / "ours.glb")["materials"]
    assert material["name"] == "paint" and material["pbrMetallicRoughness"]["roughnessFactor"] == 0.7
    # Texture coordinates are those of the places.
    corners = small.vertices[small.faces]
    assert np.abs(small.uv[..., 0] - corners[..., 0] / 30).max() < 0.01
    assert small.result.report["result"]["vertices"] == 150


def test_a_coarse_mesh_far_from_the_origin(tmp_path):
    vertices, faces = torus(dtype=np.float64)
    gpremesh.write(tmp_path / "in.ply", ((vertices + [3e5, 5e6, 0]).astype(np.float32), faces))
    command_line("remesh", tmp_path / "in.ply", tmp_path / "theirs.ply", "--vertices", 300)
    small = gpremesh.read(tmp_path / "in.ply").remesh(300)
    assert small.vertices.dtype == np.float64
    gpremesh.write(tmp_path / "ours.ply", small)
    assert (tmp_path / "ours.ply").read_bytes() == (tmp_path / "theirs.ply").read_bytes()


@pytest.mark.parametrize("real", [np.float32, np.float64])
def test_arrays_there_and_back(tmp_path, real):
    vertices, faces = cube()
    rng = np.random.default_rng(1)
    mesh = gpremesh.FileMesh(vertices.astype(real), faces, uv=rng.random((len(faces), 3, 2), np.float32), vertex_values={
        "height": vertices[:, 2], "label": np.arange(len(vertices)), **colours(vertices)},
        face_values={"part": np.arange(len(faces), dtype=np.uint16), "marked": np.arange(len(faces)) % 2 == 0})
    gpremesh.write(tmp_path / "mesh.ply", mesh)
    back = gpremesh.read(tmp_path / "mesh.ply")
    assert back.vertices.dtype == real and back.vertices.tobytes() == mesh.vertices.tobytes()
    assert back.faces.tobytes() == faces.tobytes() and back.uv.tobytes() == mesh.uv.tobytes()
    for name, values in mesh.vertex_values.items():
        assert (back.vertex_values[name] == values).all(), name
    assert back.vertex_values["red"].dtype == np.uint8 and back.vertex_values["label"].dtype == np.int32
    assert (back.face_values["part"] == np.arange(len(faces))).all()
    assert (back.face_values["marked"] == mesh.face_values["marked"]).all()
    assert back.result is None


def test_values_are_carried_over(tmp_path):
    vertices, faces = cube()
    side = np.abs(vertices[faces].mean(axis=1) - 0.5).argmax(axis=1)
    mesh = gpremesh.FileMesh(vertices, faces, vertex_values={"east": vertices[:, 0]}, face_values={"side": side})
    small = mesh.remesh(200)
    assert np.abs(small.vertex_values["east"] - small.vertices[:, 0]).max() < 0.05
    assert (small.face_values["side"] == np.abs(small.vertices[small.faces].mean(axis=1) - 0.5).argmax(axis=1)).mean() > 0.99


def test_results_and_pairs_are_written(tmp_path):
    vertices, quads = sheet()
    result = gpremesh.remesh(vertices, quads, vertex_count=200, uv=vertices[:, :2] / 30)
    gpremesh.write(tmp_path / "result.obj", result)
    assert np.allclose(gpremesh.read(tmp_path / "result.obj").uv, result.uv)
    gpremesh.write(tmp_path / "quads.off", (vertices, quads))
    assert len(gpremesh.read(tmp_path / "quads.off").faces) == 2 * len(quads)


def test_region_of_the_mesh():
    vertices, faces = torus()
    mesh = gpremesh.FileMesh(vertices, faces)
    even = mesh.remesh(300)
    mesh.region = vertices[:, 0] > 0
    near = mesh.remesh(300, feature_region="selection", feature_disk_scale=0.5)
    assert (near.vertices[:, 0] > 0).sum() > (even.vertices[:, 0] > 0).sum() + 20


def test_a_path_of_bytes(tmp_path):
    path = bytes(tmp_path / "mesh.ply")
    gpremesh.write(path, torus())
    assert len(gpremesh.read(path).vertices) == 1800


def test_the_selection_goes_from_file_to_file(tmp_path):
    vertices, faces = torus()
    mesh = gpremesh.FileMesh(vertices, faces)
    gpremesh.write(tmp_path / "none.ply", mesh)
    assert gpremesh.read(tmp_path / "none.ply").region is None
    mesh.region = vertices[:, 0] > 0
    gpremesh.write(tmp_path / "half.ply", mesh)
    back = gpremesh.read(tmp_path / "half.ply")
    assert back.region.dtype == bool and np.array_equal(back.region, mesh.region)
    assert not back.vertex_values
    near = gpremesh.remesh(vertices, faces, vertex_count=300, region=back.region)
    assert np.array_equal(near.vertices, back.remesh(300, feature_region="selection").vertices)
    with pytest.warns(UserWarning, match="selected"):
        gpremesh.write(tmp_path / "half.obj", mesh)


def two_images():
    vertices, quads = sheet()
    side = (vertices[quads].mean(axis=1)[:, 0] > 15).astype(np.int32)
    return gpremesh.FileMesh(vertices, quads, uv=vertices[:, :2] / 30, image=side)


def areas(mesh, labels):
    corners = np.asarray(mesh.vertices)[mesh.faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    return [area[labels == label].sum() for label in np.unique(labels)]


@pytest.mark.parametrize("ending, name", [("ply", None), ("obj", None), ("glb", "material")])
def test_numbers_of_images_go_to_every_format(tmp_path, ending, name):
    mesh = two_images()
    small = gpremesh.remesh(mesh.vertices, mesh.faces, vertex_count=300, uv=mesh.uv, image=mesh.image)
    for number, written in enumerate((mesh, small)):
        path = tmp_path / f"{number}.{ending}"
        gpremesh.write(path, written)
        back = gpremesh.read(path)
        image = back.image if name is None or back.image is not None else back.face_values[name]
        assert len(areas(back, image)) == 2
        if written is small:
            assert np.allclose(areas(back, image), areas(small, small.image), rtol=1e-5)


def test_lost_numbers_and_labels_are_told(tmp_path):
    mesh = two_images()
    mesh.face_values["label"] = mesh.image
    with pytest.warns(UserWarning, match="'label' of faces"):
        gpremesh.write(tmp_path / "both.glb", mesh)
    mesh.face_values = {"material": mesh.image}
    for ending in ("glb", "obj"):
        with pytest.warns(UserWarning, match="numbers of images"):
            gpremesh.write(tmp_path / f"both.{ending}", mesh)


def test_regions_of_results_are_written(tmp_path):
    mesh = two_images()
    small = gpremesh.remesh(mesh.vertices, mesh.faces, vertex_count=300, regions=mesh.image)
    gpremesh.write(tmp_path / "small.ply", small)
    assert np.array_equal(gpremesh.read(tmp_path / "small.ply").face_values["region"], small.regions)
    with pytest.warns(UserWarning, match="attribute"):
        gpremesh.write(tmp_path / "small.off", small)


@pytest.mark.parametrize("name", ["a b", "x", "a\nb", "", 5, "flags", "a\0"])
def test_names_that_files_cannot_hold(tmp_path, name):
    mesh = gpremesh.FileMesh(*torus())
    mesh.vertex_values = {name: np.zeros(1800)}
    with pytest.raises(ValueError, match="vertex_values has the name"):
        gpremesh.write(tmp_path / "mesh.ply", mesh)
    mesh.vertex_values, mesh.face_values = {"höhe": np.zeros(1800)}, {"texcoord": np.zeros(3600)}
    with pytest.raises(ValueError, match="face_values has the name 'texcoord'"):
        mesh.remesh(100)
    mesh.face_values = {}
    gpremesh.write(tmp_path / "mesh.ply", mesh)
    assert list(gpremesh.read(tmp_path / "mesh.ply").vertex_values) == ["höhe"]


def test_arguments_of_remesh_beside_the_parameters():
    vertices, quads = sheet()
    mesh, surface = gpremesh.FileMesh(vertices, quads), gpremesh.Surface(vertices, quads)
    labels = (vertices[quads, 0].mean(axis=1) > 15).astype(int)
    sizes = 1 + vertices[:, 0] / 20
    flat = vertices * [1, 1, 0]
    for given in (dict(regions=labels), dict(sizes=sizes), dict(uv=vertices[:, :2], regions=labels)):
        expected = gpremesh.remesh(vertices, quads, vertex_count=300, **given)
        assert np.array_equal(surface.remesh(vertex_count=300, **given).vertices, expected.vertices)
        mesh.uv = given.pop("uv", None)
        small = mesh.remesh(300, **given)
        assert np.array_equal(small.vertices, expected.vertices)
        assert ("region" in small.face_values) == ("regions" in given)
    given = dict(vertex_count=300, periodic=(30, 30, 0))
    expected = gpremesh.remesh(flat, quads, **given)
    assert np.array_equal(gpremesh.FileMesh(flat, quads).remesh(**given).vertices, expected.vertices)
    assert np.array_equal(gpremesh.Surface(flat, quads).remesh(**given).vertices, expected.vertices)
    (level,) = gpremesh.levels(flat, quads, vertex_count=[300], periodic=(30, 30, 0))
    assert np.array_equal(level.vertices, expected.vertices)


@pytest.mark.parametrize("copied", [copy.deepcopy, lambda mesh: pickle.loads(pickle.dumps(mesh))], ids=["copy", "pickle"])
def test_copies_have_materials_and_names(tmp_path, copied):
    textured_glb(tmp_path / "in.glb")
    write_groups(tmp_path / "in.obj")
    for ending in ("glb", "obj"):
        mesh = gpremesh.read(tmp_path / f"in.{ending}")
        for made in (mesh, mesh.remesh(150)):
            gpremesh.write(tmp_path / f"made.{ending}", made)
            gpremesh.write(tmp_path / f"copy.{ending}", copied(made))
            assert (tmp_path / f"made.{ending}").read_bytes() == (tmp_path / f"copy.{ending}").read_bytes()
    assert copied(made).result.report == made.result.report


def test_what_is_wrong_is_told(tmp_path):
    with pytest.raises(FileNotFoundError):
        gpremesh.read(tmp_path / "nothing.glb")
    (tmp_path / "mesh.xyz").write_text("0 0 0\n")
    with pytest.raises(ValueError, match="extension"):
        gpremesh.read(tmp_path / "mesh.xyz")
    (tmp_path / "bad.glb").write_bytes(b"glTF")
    with pytest.raises(gpremesh.Error, match="bad.glb") as caught:
        gpremesh.read(tmp_path / "bad.glb")
    assert caught.value.status == "unusable input"
    mesh = gpremesh.FileMesh(*torus())
    with pytest.raises(OSError):
        gpremesh.write(tmp_path / "no" / "folder.ply", mesh)
    with pytest.raises(ValueError, match="extension"):
        gpremesh.write(tmp_path / "mesh.xyz", mesh)
    with pytest.raises(TypeError, match="colour"):
        mesh.remesh(100, colour=3)
    with pytest.raises(gpremesh.Error):
        mesh.remesh(3)
    with pytest.raises(ValueError, match="mesh"):
        gpremesh.write(tmp_path / "mesh.ply", "mesh")


@pytest.mark.parametrize("name, value", [
    ("uv", np.zeros((3, 2))), ("image", np.zeros(3, int)), ("vertex_values", {"red": np.zeros(3)}),
    ("face_values", {"part": np.zeros((2, 2))}), ("vertex_values", {"name": np.array(["a"] * 1800)}),
])
def test_arrays_that_do_not_fit_are_named(tmp_path, name, value):
    mesh = gpremesh.FileMesh(*torus())
    setattr(mesh, name, value)
    with pytest.raises(ValueError, match=name):
        gpremesh.write(tmp_path / "mesh.ply", mesh)
    with pytest.raises(ValueError, match=name):
        mesh.remesh(100)
    assert not (tmp_path / "mesh.ply").exists()


def write_groups(path):
    vertices, faces = torus()
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in vertices)
    side = vertices[faces, 0].mean(axis=1) > 0
    for name, which in (("in let", side), ("wall", ~side)):
        text += f"g {name}\n" + "".join(f"f {a} {b} {c}\n" for a, b, c in faces[which] + 1)
    path.write_text(text)


def test_names_of_groups_go_from_file_to_file(tmp_path):
    write_groups(tmp_path / "in.obj")
    made = gpremesh.read(tmp_path / "in.obj").remesh(300)
    gpremesh.write(tmp_path / "out.obj", made)
    written = (tmp_path / "out.obj").read_text()
    assert "g in let\n" in written and "g wall\n" in written
    assert len(set(made.result.regions)) == 2
