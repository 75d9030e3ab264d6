// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_MATCHED_BORDER_H
#define VCG_EXTRAS_CORE_INPUT_MATCHED_BORDER_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/results.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// A mesh with border vertices at the future places of the result's border vertices, and the way
/// back to the input mesh.
struct MatchedBorder : MarkedMesh {
	/// Place of a corner on a face of the input: on the edge from corner `from` to the next corner.
	struct Corner {
		std::uint8_t from  = 0;
		float        share = 0; ///< of the way
	};

	// The vertices of the input mesh come first.
	std::vector<std::int32_t> faceOf;   ///< per face: the whole face of the input mesh
	std::vector<Corner>       cornerAt; ///< three a face
	std::vector<std::uint8_t> isKept;   ///< per vertex: border vertex of the future result

	MeshView view() const;
};

/// Splits the faces at the border at the samples of the border for an edge length (mesh units).
/// Edges with more than two faces get samples like borders, the same for all faces: the run cuts
/// the surface there, or keeps the junction.
/// Borders are cut into pieces at corners, which turn by 50° over .6 edges, and at places with
/// other than two border edges; each piece gets samples at equal lengths. All is computed in double
/// and in a direction given by the places of the piece's ends: meshes with a common piece get the
/// same samples there, bit for bit. Vertices at exactly the same place count as equal. period:
/// lengths of a periodic cell, mesh units, 0 along an axis without a period. Vertices and samples
/// at the border's far end then lie one period from their partners at the near end, bit for bit.
/// Throws Failure for a vertex number out of range, and if the two ends differ (see
/// PeriodicBorder). Polls workers now and then. Cost: O(F log F), serial.
MatchedBorder matchBorder(const MeshView& input, double edgeLength, const Vec3d& period,
						  Workers& workers);

/// Renames faces and vertices of a result of the matched mesh to faces and vertices of the input
/// mesh.
void nameCallers(const MeshView& input, const MatchedBorder& matched, RemeshResult& result);

} // namespace gpr

#endif
