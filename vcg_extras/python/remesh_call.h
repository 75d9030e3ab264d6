// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_REMESH_CALL_H
#define VCG_EXTRAS_PYTHON_REMESH_CALL_H

#include "arrays.h"
#include "mesh_file.h"

#include <vcg_extras/core/prepared_surface.h>

#include <memory>
#include <nanobind/nanobind.h>
#include <vector>

namespace gpr::python {

/// What goes with a mesh beside its coordinates and triangles.
struct Extras {
	std::optional<Marks>        selectedFaces;
	std::optional<Marks>        selectedVertices;
	std::optional<Edges>        edges;
	std::optional<CornerCoords> texture;
	std::optional<Indices>      images;
	std::optional<Indices>      regions;     ///< labels of faces
	std::optional<Sizes>        wantedEdges; ///< of the vertices
	std::vector<double>         period;      ///< three lengths of a periodic cell, or none
	/// What earlier runs on the same vertices and faces have made; or null.
	std::shared_ptr<PreparedSurface> prepared;
};

/// The attributes of a file instead of a texture: they are carried over to the result, by the rules
/// of the program. The dictionary has them as `attributes`.
nb::dict remeshMeshOfFile(const Positions& positions, const Triangles& triangles,
						  const Extras& extras, const FileAttributes& attributes,
						  const nb::dict& given, nb::object progress);

/// Each runs a tool of the engine without the interpreter's lock and returns a dictionary: status,
/// message and smallest_count, then what the tool makes. `given` has the parameters of the table.
nb::dict remeshArrays(const Positions& positions, const Triangles& triangles, const Extras& extras,
					  const nb::dict& given, nb::object progress);
/// Several meshes that are remeshed together: see app::JoinedPieces. A dictionary for each, or one
/// with the reason where there is no result.
std::vector<nb::dict> remeshPieces(const std::vector<Positions>& positions,
								   const std::vector<Triangles>& triangles,
								   const std::vector<Extras>& extras, const nb::dict& given,
								   nb::object progress);
nb::dict sampleArrays(const Positions& positions, const Triangles& triangles, const Extras& extras,
					  const nb::dict& given, nb::object progress);
nb::dict detectInArrays(const Positions& positions, const Triangles& triangles,
						const nb::dict& given, nb::object progress);

} // namespace gpr::python

#endif
