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

/// The data of a mesh beside coordinates and triangles.
struct Extras {
	std::optional<Marks>        selectedFaces;
	std::optional<Marks>        selectedVertices;
	std::optional<Edges>        edges;
	std::optional<CornerCoords> texture;
	std::optional<Indices>      images;
	std::optional<Indices>      regions;     ///< labels of faces
	std::optional<Sizes>        wantedEdges; ///< of the vertices
	std::vector<double>         period;      ///< three lengths of a periodic cell, or none
	/// The products of earlier runs on the same vertices and faces; or null.
	std::shared_ptr<PreparedSurface> prepared;
};

/// Remeshes a mesh with the attributes of a file in place of a texture. The attributes are
/// transferred to the result by the rules of the program, as `attributes` of the dictionary.
nb::dict remeshMeshOfFile(const Positions& positions, const Triangles& triangles,
						  const Extras& extras, const FileAttributes& attributes,
						  const nb::dict& given, nb::object progress);

/// These functions run a tool of the engine without the interpreter's lock. They return a
/// dictionary: status, message and smallest_count, then the products of the tool. `given` has the
/// parameters of the table.
nb::dict remeshArrays(const Positions& positions, const Triangles& triangles, const Extras& extras,
					  const nb::dict& given, nb::object progress);
/// Remeshes several meshes together: see app::JoinedPieces. Returns a dictionary for each mesh, or
/// a single dictionary with the reason if there is no result.
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
