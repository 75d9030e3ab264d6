# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender: Object > Remesh: Geodesic Poisson Disk."""

import threading

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from . import mesh_data


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
        name="Size", default="PERCENT", description="How the size of the triangles is given",
        items=[("PERCENT", "Percent of the vertices", "Of those that the mesh has now"),
               ("COUNT", "Vertices", "A number of vertices"),
               ("FACES", "Triangles", "A number of triangles, even for a closed surface"),
               ("LENGTH", "Edge length", "The mean length of the edges, in units of the scene")])
    percent: FloatProperty(name="Percent", default=10, min=0.01, max=1000, subtype="PERCENTAGE",
                           description="Vertices of the result, in percent of those of the mesh")
    vertex_count: IntProperty(name="Vertices", default=5000, min=4, soft_max=1000000,
                              description="Vertices of the result")
    face_count: IntProperty(name="Triangles", default=10000, min=4, soft_max=2000000,
                            description="Triangles of the result")
    edge_length: FloatProperty(name="Edge Length", default=0.1, min=1e-6, subtype="DISTANCE",
                               description="Mean length of the edges of the result")
    adapt: FloatProperty(name="Adapt", default=0.1, min=0, max=1,
                         description="How much smaller triangles are where the surface is finer: 0 not, 1 for the least error")
    preset: EnumProperty(
        name="Preset", default="default", description="How much is done for the quality",
        items=[("default", "Default", "Regular triangles that fit the surface"),
               ("fast", "Fast", "A third of the time: neither fitted nor made as regular"),
               ("paper", "Paper", "The method as it was published")])
    features: EnumProperty(
        name="Sharp Edges", default="auto", description="Which edges stay",
        items=[("auto", "Find", "Creases are found and kept"), ("off", "None", "Creases are rounded")])
    boundary: EnumProperty(
        name="Border", default="resample", description="What happens at borders of an open surface",
        items=[("resample", "Follow", "The border is followed by new edges"),
               ("keep", "Keep", "The border stays as it is"),
               ("smooth", "Smooth", "The border is made smooth")])
    seed: IntProperty(name="Seed", default=1, min=1, description="Another seed gives another mesh of the same quality")
    as_copy: BoolProperty(name="As Copy", default=False, description="Leave the object as it is and put the result beside it")

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
        layout.prop(self, {"PERCENT": "percent", "COUNT": "vertex_count", "FACES": "face_count",
                           "LENGTH": "edge_length"}[self.size])
        for name in ("adapt", "preset", "features", "boundary", "seed", "as_copy"):
            layout.prop(self, name)

    def parameters(self):
        size = {"PERCENT": ("percent", self.percent), "COUNT": ("vertex_count", self.vertex_count),
                "FACES": ("face_count", self.face_count),
                "LENGTH": ("edge_length", self.edge_length)}[self.size]
        parameters = {size[0]: size[1], "preset": self.preset, "features": self.features,
                      "boundary": self.boundary, "seed": self.seed}
        if self.preset == "default":  # the others have an adaptivity of their own
            parameters["adapt"] = self.adapt
        return parameters

    def begin(self, context):
        """The run, before its start; None and a message for an unusable mesh."""
        try:
            return Run(mesh_data.take(context.object), self.parameters())
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


def draw_entry(menu, context):
    menu.layout.operator(OBJECT_OT_gpremesh.bl_idname)


def register():
    bpy.utils.register_class(OBJECT_OT_gpremesh)
    bpy.types.VIEW3D_MT_object.append(draw_entry)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_entry)
    bpy.utils.unregister_class(OBJECT_OT_gpremesh)
