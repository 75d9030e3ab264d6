// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_LOAD_H
#define VCG_EXTRAS_CORE_INPUT_LOAD_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/mesh/same_place.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Stage::Load: a copy of the input mesh in working units, without vertices that are not finite
/// (and their faces), vertices of no face, and faces with a repeated vertex. In a triangle soup (no
/// two faces share a vertex) vertices with the same position, to a millionth of the box, are
/// welded. Throws Failure{UnusableInput} for indices out of range, no face left or no area. Cost:
/// linear, parallel.
IndexedMesh loadInput(const MeshView& input, Workers& workers, CleanCounts& counts);

/// Throws Failure{UnusableInput} for a vertex number out of range. Cost: linear, parallel.
void requireVertexNumbers(const MeshView& input, Workers& workers);

/// Figures over all faces, from a single pass.
struct FaceExtents {
	double        area = 0;       ///< sum, working units squared, in double
	Buffer<float> longestSquared; ///< longest edge per facesTogether faces, working units squared

	/// Small, so that with rare long edges most groups of faces have no long edge.
	static constexpr std::size_t facesTogether = 64;
};

/// The same bits for any number of threads. Cost: linear, parallel.
FaceExtents measureFaces(const IndexedMesh& mesh, Workers& workers);

} // namespace gpr

#endif
