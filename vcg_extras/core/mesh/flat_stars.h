// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FLAT_STARS_H
#define VCG_EXTRAS_CORE_MESH_FLAT_STARS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>

namespace gpr {

/// A test for inner vertices whose faces cannot touch beyond shared corners and edges. The normals
/// lie within 37° of their mean, and the faces wind round the vertex once: seen along the mean
/// normal, the faces lie side by side. Most vertices pass, and most pairs of faces with meeting
/// boxes share a vertex. Computed in double with a margin for rounding: true is certain, false is
/// not.
class FlatStars {
public:
	/// Tests all vertices, in parallel. The mesh must not change afterwards.
	FlatStars(const HalfEdgeMesh& mesh, Workers& workers);

	/// Whether two faces share a flat vertex.
	bool areInOne(int f, int g) const
	{
		// This test separates most pairs, and the shared corners are hard to predict: three
		// branches instead of nine.
		const int* const a = &m_.origin[3 * f];
		const int* const b = &m_.origin[3 * g];
		for (int k = 0; k < 3; ++k) {
			const bool isShared = (a[k] == b[0]) | (a[k] == b[1]) | (a[k] == b[2]);
			if (isShared && isFlat_[a[k]]) return true;
		}
		return false;
	}

private:
	const HalfEdgeMesh& m_;
	Buffer<char>        isFlat_; ///< per vertex
};

} // namespace gpr

#endif
