// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_call.h"
#include "distance_call.h"
#include "mesh_file.h"
#include "parameter_values.h"
#include "polygon_call.h"
#include "remesh_call.h"

#include <vcg_extras/io/mesh/face_regions.h>

#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace nb = nanobind;
using namespace nb::literals;
using namespace gpr::python;

namespace {

gpr::Tool toolOf(const std::string& name)
{
	if (name == "remesh") return gpr::RemeshTool;
	if (name == "sample") return gpr::SamplingTool;
	if (name == "features") return gpr::FeatureTool;
	throw nb::value_error(("There is no tool " + name + ".").c_str());
}

} // namespace

/// The compiled part of the package; only the Python part of the package calls this module.
NB_MODULE(_core, module)
{
	module.attr("version") = GPR_VERSION;

	nb::class_<gpr::PreparedSurface>(module, "PreparedSurface")
		.def("__init__",
			 [](gpr::PreparedSurface* self) { new (self) gpr::PreparedSurface(gpr::MeshView()); });

	nb::class_<Extras>(module, "Extras")
		.def(nb::init<>())
		.def_rw("sizes", &Extras::wantedEdges, nb::arg().none())
		.def_rw("selected", &Extras::selectedFaces, nb::arg().none())
		.def_rw("region", &Extras::selectedVertices, nb::arg().none())
		.def_rw("feature_edges", &Extras::edges, nb::arg().none())
		.def_rw("uv", &Extras::texture, nb::arg().none())
		.def_rw("images", &Extras::images, nb::arg().none())
		.def_rw("regions", &Extras::regions, nb::arg().none())
		.def_rw("period", &Extras::period)
		.def_rw("prepared", &Extras::prepared, nb::arg().none());

	nb::class_<FileAttributes>(module, "FileAttributes")
		.def(nb::init<>())
		.def("add_vertex_values", &FileAttributes::addVertexValues, "name"_a, "array"_a)
		.def("add_face_values", &FileAttributes::addFaceValues, "name"_a, "array"_a)
		.def("set_texture", &FileAttributes::setTexture, "uv"_a, "image"_a.none())
		.def("take_materials", &FileAttributes::takeMaterials, "other"_a)
		.def("__getstate__", &FileAttributes::materialState)
		.def("__setstate__",
			 [](FileAttributes& self, const nb::list& state) {
				 new (&self) FileAttributes();
				 self.setMaterialState(state);
			 })
		.def("vertex_values", &FileAttributes::vertexValues)
		.def("face_values", &FileAttributes::faceValues)
		.def("uv", &FileAttributes::uv)
		.def("image", &FileAttributes::image);

	module.def(
		"parameters", [](const std::string& tool) { return parameterList(toolOf(tool)); },
		"tool"_a);
	module.def("remesh", &remeshArrays, "vertices"_a, "faces"_a, "extras"_a, "parameters"_a,
			   "progress"_a.none());
	module.def("remesh_pieces", &remeshPieces, "vertices"_a, "faces"_a, "extras"_a, "parameters"_a,
			   "progress"_a.none());
	module.def("remesh_mesh_of_file", &remeshMeshOfFile, "vertices"_a, "faces"_a, "extras"_a,
			   "attributes"_a, "parameters"_a, "progress"_a.none());
	module.def("tells_regions", &gpr::app::tellsRegions, "name"_a);
	module.def("read_mesh", &readMeshFile, "path"_a);
	module.def("write_mesh", &writeMeshFile, "path"_a, "vertices"_a, "faces"_a, "attributes"_a);
	module.def("sample", &sampleArrays, "vertices"_a, "faces"_a, "extras"_a, "parameters"_a,
			   "progress"_a.none());
	module.def("features", &detectInArrays, "vertices"_a, "faces"_a, "parameters"_a,
			   "progress"_a.none());
	module.def("distance", &measureDistance, "vertices_a"_a, "faces_a"_a, "vertices_b"_a,
			   "faces_b"_a, "samples"_a, "threads"_a, "progress"_a.none());
	module.def("command_names", [] { return gpr::app::commandNames; });
	module.def("remesh_command_texts", &remeshCommandTexts);
	module.def("with_command", &gpr::app::withCommand, "words"_a);
	module.def("run_remesh_command", &runRemeshWords, "files"_a, "options"_a);
	module.def("cut_polygons", &cutPolygons, "vertices"_a, "corners"_a, "sizes"_a);
}
