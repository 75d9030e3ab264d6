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

/// Stage::Load: a working copy of the caller's mesh, with what no surface can have left out:
/// vertices that are not finite (and their faces), vertices in no face, faces with a vertex twice.
/// A triangle soup (no vertex shared at all) is welded where positions agree to a millionth of the
/// box. Throws Failure{UnusableInput} for indices out of range, no face left or no area. Cost:
/// linear, parallel.
IndexedMesh loadInput(const MeshView& input, Workers& workers, CleanCounts& counts);

/// What is asked of all faces, from one pass over them.
struct FaceExtents {
	double        area = 0;       ///< sum, working units squared, in double
	Buffer<float> longestSquared; ///< edge of each facesTogether faces, working units squared

	/// So few that most are without a long edge where long edges are rare.
	static constexpr std::size_t facesTogether = 64;
};

/// The same bits for any number of threads. Cost: linear, parallel.
FaceExtents measureFaces(const IndexedMesh& mesh, Workers& workers);

} // namespace gpr

#endif
