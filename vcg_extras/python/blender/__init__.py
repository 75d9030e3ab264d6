# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender: Object > Remesh: Geodesic Poisson Disk."""

import threading

import bpy
import numpy as np
from bpy.props import (BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty,
                       StringProperty)
from gpremesh import _core

from . import mesh_data

TABLE = _core.parameters("remesh")
# The parameter that gives the size, by the choice of the field Size.
SIZES = {"PERCENT": "percent", "COUNT": "vertex_count", "FACES": "face_count", "LENGTH": "edge_length",
         "ERROR": "max_error", "DETAIL": "detail"}
# What the fields of a size show at first; the table has no defaults for sizes.
PROPOSED = {"percent": 10, "vertex_count": 5000, "face_count": 10000, "edge_length": 0.1, "max_error": 0.01,
            "detail": "normal"}
AUTOMATIC = -1  # Blender's numbers have no word for it; MeshLab's filter takes the same
LARGEST = 3.4e38  # of Blender's numbers


def property_of(entry):
    """The field for a row of the engine's parameter table."""
    default = PROPOSED[entry["name"]] if entry["is_size"] else entry["default"]
    name, about = entry["label"].replace(" (0 = off)", ""), entry["about"].rstrip(".")
    if entry["name"] == "features":
        about += ". The selected edges are the edges marked sharp"
    if entry["kind"] == "switch":
        return BoolProperty(name=name, description=about, default=default)
    if entry["kind"] == "choice":
        # No field selects a feature region, and no size is off.
        left_out = {"feature_region": "selection", "detail": "off"}.get(entry["name"])
        items = [(choice, choice.capitalize(), "") for choice in entry["choices"] if choice != left_out]
        return EnumProperty(name=name, description=about, default=default, items=items)
    least, most = entry["minimum"], min(entry["maximum"], LARGEST)
    if entry["kind"] == "count":
        return IntProperty(name=name, description=about, default=default, min=int(least), max=int(most))
    if default == "auto":
        return FloatProperty(name=f"{name} ({AUTOMATIC} = auto)", description=about, default=AUTOMATIC, min=AUTOMATIC, max=most)
    unit = {"subtype": "DISTANCE"} if entry["kind"] == "length" else {}
    return FloatProperty(name=name, description=about, default=default, min=least, max=most, **unit)


def typed(number):
    """The number that a user meant whose digits Blender keeps as a float of 32 bits."""
    return float(str(np.float32(number)))


def value_of(entry, value):
    """A value of a field as the engine takes it."""
    if not isinstance(value, float):
        return value
    return "auto" if entry["default"] == "auto" and value == AUTOMATIC else typed(value)


class Run(threading.Thread):
    """A remeshing in a thread beside Blender, which uses nothing of Blender."""

    def __init__(self, taken, parameters):
        super().__init__()
        self.taken = taken
        self.parameters = parameters
        self.share = 0.0
        self.stage = ""
        self.is_cancelled = False
        self.result = None
        self.error = None

    def run(self):
        try:
            self.result = self.taken.remesh(self._progress, **self.parameters)
        except Exception as error:  # the operator reports the error in Blender's thread
            self.error = error

    def _progress(self, share, stage):
        self.share, self.stage = share, stage
        return not self.is_cancelled


class OBJECT_OT_gpremesh(bpy.types.Operator):
    """Replace the mesh by nearly equilateral triangles, with exactly as many vertices as asked for"""

    bl_idname = "object.gpremesh"
    bl_label = "Remesh: Geodesic Poisson Disk"
    bl_options = {"REGISTER", "UNDO"}

    size: EnumProperty(
        name="Size", default="PERCENT", description="Measure for the size of the triangles",
        items=[("PERCENT", "Percent of the vertices", "Percent of the vertices of the mesh"),
               ("COUNT", "Vertices", "A number of vertices"),
               ("FACES", "Triangles", "A number of triangles, even for a closed surface"),
               ("LENGTH", "Edge length", "The mean length of the edges, in units of the scene"),
               ("ERROR", "Largest error", "The proven largest distance from the mesh"),
               ("DETAIL", "Detail", "A level of detail, by a forecast of the distance from the mesh"),
               ("SIZES", "Sizes alone", "The lengths of the attribute named by Sizes, without scaling")])
    regions: StringProperty(
        name="Regions", default="material_index",
        description="Attribute of faces with whole numbers, the labels of regions. New edges follow the region borders. "
                    "material_index is the number of the material. Without a name, no border is followed")
    sizes: StringProperty(
        name="Sizes", description="Attribute of vertices with the wanted edge lengths, or a vertex group: edges at "
                                  "weight 1 have the share Finest of the length at weight 0")
    finest: FloatProperty(name="Finest", default=0.25, min=0.02, max=1,
                          description="Edge length at weight 1 of the vertex group, divided by the length at weight 0")
    periodic: FloatVectorProperty(
        name="Periodic Cell", size=3, min=0, subtype="XYZ_LENGTH",
        description="Lengths of a periodic cell in units of the scene, 0 along an axis without a period. Vertices at "
                    "opposite borders match")
    as_copy: BoolProperty(name="As Copy", default=False, description="Keep the object and make a new object from the result")
    advanced: BoolProperty(name="More", default=False, description="Show all other parameters")

    _run = None
    _timer = None

    @classmethod
    def poll(cls, context):
        active = context.object
        return active is not None and active.type == "MESH" and active.mode == "OBJECT" and active.data.is_editable

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "size")
        if self.size in SIZES:
            layout.prop(self, SIZES[self.size])
        for entry in TABLE:
            if not entry["expert"] and not entry["is_size"]:
                layout.prop(self, entry["name"])
        for name in ("regions", "sizes", "finest", "periodic", "as_copy", "advanced"):
            layout.prop(self, name)
        for entry in TABLE:
            if self.advanced and entry["expert"] and not entry["is_size"]:
                layout.prop(self, entry["name"])

    def parameters(self):
        """The arguments of gpremesh.remesh: the size, and the values that are no defaults."""
        given = {entry["name"]: value_of(entry, getattr(self, entry["name"])) for entry in TABLE if not entry["is_size"]}
        parameters = {entry["name"]: given[entry["name"]] for entry in TABLE
                      if not entry["is_size"] and given[entry["name"]] != entry["default"]}
        if self.size in SIZES:
            entry = next(entry for entry in TABLE if entry["name"] == SIZES[self.size])
            parameters[entry["name"]] = value_of(entry, getattr(self, entry["name"]))
        if any(self.periodic):
            parameters["periodic"] = tuple(typed(length) for length in self.periodic)
        return parameters

    def begin(self, context):
        """The run, before its start; None and a message for an unusable mesh."""
        try:
            taken = mesh_data.take(context.object)
            marks = taken.marks(self.regions, self.sizes, typed(self.finest), self.size == "SIZES", self.features)
            return Run(taken, {**marks, **self.parameters()})
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return None

    def end(self, context, run):
        if run.error is not None:
            self.report({"ERROR"}, str(run.error))
            return {"CANCELLED"}
        target = mesh_data.copy_beside(context, context.object) if self.as_copy else context.object
        run.taken.put(run.result, target)
        vertices, faces = len(run.result.vertices), len(run.result.faces)
        self.report({"INFO"}, f"{vertices:,} vertices, {faces:,} triangles")
        for note in run.taken.notes + list(run.result.report["notes"]):
            self.report({"INFO"}, note)
        return {"FINISHED"}

    def execute(self, context):
        run = self.begin(context)
        if run is None:
            return {"CANCELLED"}
        manager = context.window_manager
        manager.progress_begin(0, 100)
        run.start()
        while run.is_alive():
            run.join(0.05)
            manager.progress_update(100 * run.share)
        manager.progress_end()
        return self.end(context, run)

    def invoke(self, context, event):
        # In a window Blender stays usable during the run, and Escape cancels.
        self._run = self.begin(context)
        if self._run is None:
            return {"CANCELLED"}
        self._run.start()
        self._timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.progress_begin(0, 100)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        run = self._run
        if event.type == "ESC":
            run.is_cancelled = True
        if event.type == "TIMER":
            context.window_manager.progress_update(100 * run.share)
            context.workspace.status_text_set(f"Remeshing: {run.stage}, {round(100 * run.share)} % (Esc cancels)")
        if run.is_alive():
            return {"RUNNING_MODAL"}  # other events wait, so that the object does not change
        self.stop_showing(context)
        return self.end(context, run)

    def stop_showing(self, context):
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def cancel(self, context):
        """Blender ends during the run."""
        self._run.is_cancelled = True
        self._run.join()
        self.stop_showing(context)


OBJECT_OT_gpremesh.__annotations__.update({entry["name"]: property_of(entry) for entry in TABLE})


def draw_entry(menu, context):
    menu.layout.operator(OBJECT_OT_gpremesh.bl_idname)


def register():
    bpy.utils.register_class(OBJECT_OT_gpremesh)
    bpy.types.VIEW3D_MT_object.append(draw_entry)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_entry)
    bpy.utils.unregister_class(OBJECT_OT_gpremesh)
