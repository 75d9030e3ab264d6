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

/// A mesh whose border has vertices where those of a result shall be, with the way back.
struct MatchedBorder {
	/// Where a corner lies on the caller's face: on the edge from corner `from` to the next one.
	struct Corner {
		std::uint8_t from  = 0;
		float        share = 0; ///< of the way
	};

	std::vector<Vec3d>        positions; ///< the caller's vertices first
	std::vector<std::int32_t> triangles;
	std::vector<std::int32_t> faceOf;   ///< per face: the caller's that it is a part of
	std::vector<Corner>       cornerAt; ///< three a face
	std::vector<std::uint8_t> isKept;   ///< per vertex: of the border, and to be one of the result
	std::vector<std::uint8_t> selected, line;
	std::vector<std::int32_t> region;

	MeshView view() const;
};

/// Splits the faces at the border where its samples for an edge length (mesh units) lie. Borders
/// are cut at their corners, which turn by 50° over .6 edges, and where other than two of their
/// edges meet; each piece is cut into equal lengths. All is computed in double and in a direction
/// that the places of the piece's ends decide, so that meshes with a piece in common get the same
/// samples there, bit for bit. Vertices at exactly the same place are taken for one. Throws Failure
/// where a face names a vertex that does not exist. period: lengths of a periodic cell, mesh units,
/// 0 along an axis without one; vertices and samples of the border's end then lie one period from
/// those of its begin, bit for bit, and Failure is thrown where the two ends differ (see
/// PeriodicBorder). workers: asked now and then whether to go on. Cost: O(F log F), serial.
MatchedBorder matchBorder(const MeshView& input, double edgeLength, const Vec3d& period,
						  Workers& workers);

/// Says where a result of that mesh lies on the caller's.
void nameCallers(const MeshView& input, const MatchedBorder& matched, RemeshResult& result);

} // namespace gpr

#endif
