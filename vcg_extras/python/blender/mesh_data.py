# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of Blender as arrays and back, with attributes."""

import numpy as np

import gpremesh

# For each type: numbers per value, name of a value in foreach_get, and dtype of the array.
TYPES = {
    "FLOAT": (1, "value", np.float32),
    "INT": (1, "value", np.int32),
    "INT8": (1, "value", np.int32),
    "BOOLEAN": (1, "value", bool),
    "FLOAT_VECTOR": (3, "vector", np.float32),
    "FLOAT2": (2, "vector", np.float32),
    "FLOAT_COLOR": (4, "color", np.float32),
    "BYTE_COLOR": (4, "color", np.float32),  # foreach_get reads numbers from 0 to 1
}
FIELDS = {"face": "faces with one value each", "vertex": "vertices with one value each"}
# Made anew with the mesh, or the shape of what is no more.
OWN = {"position", "material_index", "custom_normal", "sharp_edge"}


def numbers(collection, name, length, dtype):
    array = np.zeros(len(collection) * length, dtype)
    collection.foreach_get(name, array)
    return array.reshape(-1, length) if length > 1 else array


class Column:
    """The values of an attribute, of vertices or faces. Values of corners become means at vertices."""

    def __init__(self, attribute, of, values):
        self.name = attribute.name
        self.type = attribute.data_type
        self.domain = attribute.domain
        self.of = of
        self.values = values

    def put(self, mesh, result):
        length, name, dtype = TYPES[self.type]
        values = result.transfer(self.values, self.of)
        if self.domain == "CORNER":
            values = values[result.faces.reshape(-1)]
        attribute = mesh.attributes.get(self.name) or mesh.attributes.new(self.name, self.type, self.domain)
        attribute.data.foreach_set(name, np.ascontiguousarray(values, dtype).reshape(-1))


class TakenMesh:
    """A mesh for gpremesh, and the values to transfer to the result. Coordinates have the stretch of the object, so
    that triangles are regular in the scene."""

    def __init__(self, mesh, stretch, group_names):
        mesh.calc_loop_triangles()
        triangles = mesh.loop_triangles
        self.notes = []
        self.stretch = stretch
        self.vertices = (numbers(mesh.vertices, "co", 3, np.float32) @ stretch).astype(np.float32)
        self.faces = numbers(triangles, "vertices", 3, np.int32)
        self.corners = numbers(triangles, "loops", 3, np.int32)
        self.polygons = numbers(triangles, "polygon_index", 1, np.int32)
        self.materials = numbers(mesh.polygons, "material_index", 1, np.int32)[self.polygons]
        self.uv_name, self.uv = self._take_uv(mesh)
        self.columns = [column for attribute in mesh.attributes for column in self._column(mesh, attribute)]
        self.groups = self._take_groups(mesh)
        self.group_names = {group.name: group.index for group in group_names}
        self.sharp_edges = self._take_sharp_edges(mesh)
        self._note_marks(mesh)

    def _take_uv(self, mesh):
        layer = mesh.uv_layers.active
        if layer is None:
            return None, None
        if len(mesh.uv_layers) > 1:
            self.notes.append(f"Only the active UV map was carried over: {layer.name}.")
        return layer.name, numbers(layer.uv, "vector", 2, np.float32)[self.corners]

    def _column(self, mesh, attribute):
        if attribute.name in OWN or attribute.name.startswith(".") or attribute.name in mesh.uv_layers:
            return []
        if attribute.data_type not in TYPES or attribute.domain == "EDGE":
            if attribute.domain != "EDGE" or not attribute.is_internal:
                self.notes.append(f"The attribute {attribute.name} was not carried over.")
            return []
        length, name, dtype = TYPES[attribute.data_type]
        values = numbers(attribute.data, name, length, dtype)
        if attribute.domain == "FACE":
            return [Column(attribute, "face", values[self.polygons])]
        return [Column(attribute, "vertex", self._of_vertices(values) if attribute.domain == "CORNER" else values)]

    def _of_vertices(self, values):
        """Means over the corners of each vertex."""
        at, of_corners = self.faces.reshape(-1), values[self.corners.reshape(-1)].astype(np.float64)
        count = np.maximum(np.bincount(at, minlength=len(self.vertices)), 1)
        flat = of_corners.reshape(len(at), -1)
        sums = [np.bincount(at, flat[:, k], len(self.vertices)) / count for k in range(flat.shape[1])]
        return np.stack(sums, axis=-1).reshape((-1,) + values.shape[1:]).astype(np.float32)

    def _take_groups(self, mesh):
        """The weights of each vertex group with a vertex, by the number of the group."""
        weights = {}
        for vertex in mesh.vertices:
            for element in vertex.groups:
                column = weights.setdefault(element.group, np.zeros(len(mesh.vertices), np.float32))
                column[vertex.index] = element.weight
        return weights

    def _take_sharp_edges(self, mesh):
        sharp = mesh.attributes.get("sharp_edge")
        if sharp is None:
            return np.zeros((0, 2), np.int32)
        return numbers(mesh.edges, "vertices", 2, np.int32)[numbers(sharp.data, "value", 1, bool)]

    def _note_marks(self, mesh):
        """Notes what Blender keeps beside the attributes that have a note of their own."""
        for what, is_there in (("Edges marked sharp", len(self.sharp_edges) > 0),
                               ("Seams", numbers(mesh.edges, "use_seam", 1, bool).any()),
                               ("Custom normals", mesh.has_custom_normals)):
            if is_there:
                self.notes.append(f"{what} were lost.")

    def _column_named(self, name, of, field):
        for column in self.columns:
            if column.name == name and column.of == of and column.values.ndim == 1:
                return column.values
        raise ValueError(f"{field} names {name}, but there is no such attribute of {FIELDS[of]}.")

    def _regions(self, name):
        values = self.materials if name == "material_index" else self._column_named(name, "face", "Regions")
        if values.dtype.kind == "f" and (values != np.floor(values)).any():
            raise ValueError(f"Regions names {name}, whose values are no whole numbers.")
        return values.astype(np.int32)

    def _sizes(self, name, finest, are_exact):
        if name not in self.group_names:
            return self._column_named(name, "vertex", "Sizes")
        if are_exact:
            raise ValueError("A vertex group has shares of a length, not lengths; choose another size.")
        weights = self.groups.get(self.group_names[name], np.zeros(len(self.vertices), np.float32))
        return finest ** weights.astype(np.float64)

    def marks(self, regions, sizes, finest, are_exact, features):
        """The arguments of gpremesh.remesh that attributes and vertex groups give. Names are empty where there is
        none. A ValueError says which one is not there."""
        marks = {}
        if regions:
            marks["regions"] = self._regions(regions)
        if sizes:
            marks["sizes"] = self._sizes(sizes, finest, are_exact)
        elif are_exact:
            raise ValueError("The size is from Sizes alone, but Sizes names no attribute.")
        if features == "selected":
            if not len(self.sharp_edges):
                raise ValueError("The feature lines are the edges marked sharp, but no edge is marked sharp.")
            marks["feature_edges"] = self.sharp_edges
        return marks

    def remesh(self, progress, **parameters):
        """Edges of the result follow the seams of the texture."""
        texture = {} if self.uv is None else {"uv": self.uv, "image": self.materials}
        return gpremesh.remesh(self.vertices, self.faces, progress=progress, **texture, **parameters)

    def put(self, result, active):
        """Replaces the mesh of the object by the result. Materials stay."""
        mesh = active.data
        names = [group.name for group in active.vertex_groups]
        groups = {number: result.transfer(weights, "vertex") for number, weights in self.groups.items()}
        places = np.ascontiguousarray(result.vertices @ np.linalg.inv(self.stretch), np.float32)
        mesh.clear_geometry()
        mesh.vertices.add(len(result.vertices))
        mesh.loops.add(3 * len(result.faces))
        mesh.polygons.add(len(result.faces))
        mesh.vertices.foreach_set("co", places.reshape(-1))
        mesh.loops.foreach_set("vertex_index", np.ascontiguousarray(result.faces, np.int32).reshape(-1))
        mesh.polygons.foreach_set("loop_start", np.arange(0, 3 * len(result.faces), 3, dtype=np.int32))
        mesh.polygons.foreach_set("material_index", result.transfer(self.materials, "face"))
        mesh.update(calc_edges=True)
        if self.uv is not None:
            layer = mesh.uv_layers.new(name=self.uv_name)
            layer.uv.foreach_set("vector", result.uv.reshape(-1))
        for column in self.columns:
            column.put(mesh, result)
        _put_groups(active, names, groups)
        mesh.validate()
        mesh.update()


def _put_groups(active, names, groups):
    """Adds groups and weights. In some versions of Blender the names of groups vanish with the old geometry."""
    for name in names[len(active.vertex_groups):]:
        active.vertex_groups.new(name=name)
    for number, weights in groups.items():
        for vertex in np.flatnonzero(weights > 0):
            active.vertex_groups[number].add([int(vertex)], float(weights[vertex]), "REPLACE")


def stretch_of(matrix):
    """The symmetric matrix that gives lengths of the scene along the object's own axes: the scale, and the shear of a
    rotated child of a stretched parent."""
    linear = np.array(matrix, np.float64)[:3, :3]
    squared = linear.T @ linear
    scale = np.sqrt(np.diag(squared))
    squared[np.abs(squared) < 1e-6 * np.outer(scale, scale)] = 0  # without shear the axes stay exact
    values, axes = np.linalg.eigh(squared)
    return (axes * np.sqrt(np.maximum(values, 0))) @ axes.T


def take(active):
    """The mesh of an object. Raises a ValueError with the reason for an unusable mesh."""
    mesh = active.data
    if mesh.shape_keys is not None:
        raise ValueError("The mesh has shape keys, which cannot be carried over; apply or remove the shape keys first.")
    if not mesh.polygons:
        raise ValueError("The mesh has no faces.")
    stretch = stretch_of(active.matrix_world)
    if not np.linalg.det(stretch) > 0:
        raise ValueError("The object is scaled to nothing.")
    return TakenMesh(mesh, stretch, active.vertex_groups)


def copy_beside(context, active):
    """Copies the object and its mesh. The copy lies beside the object and becomes active."""
    copied = active.copy()
    copied.data = active.data.copy()
    for collection in active.users_collection:
        collection.objects.link(copied)
    copied.location.x += 1.1 * active.dimensions.x
    active.select_set(False)
    copied.select_set(True)
    context.view_layer.objects.active = copied
    return copied
