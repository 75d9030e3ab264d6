// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FLAT_STARS_H
#define VCG_EXTRAS_CORE_MESH_FLAT_STARS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>

namespace gpr {

/// Tells vertices inside the surface whose faces cannot touch each other beyond what they share:
/// their normals lie within 37° of the mean, and they go round the vertex once, so that they are
/// seen side by side along the mean normal. Most vertices are such ones, and most pairs of faces
/// whose boxes meet share one. Worked out in double with a margin for rounding: a yes is certain, a
/// no may be a yes.
class FlatStars {
public:
	explicit FlatStars(const HalfEdgeMesh& mesh) : m_(mesh) {}

	/// Looks at all vertices at once: worth its time where most faces are compared. The mesh must
	/// not change any more.
	void findAll(Workers& workers);

	bool isFlat(int v) const { return isFlat_.empty() ? looksFlat(v) : isFlat_[v] != 0; }

	/// Whether two faces lie round one such vertex.
	bool areInOne(int f, int g) const
	{
		// Most pairs are told apart by this, and which corners they share is hard to foresee: three
		// branches, not nine.
		const int* const a = &m_.origin[3 * f];
		const int* const b = &m_.origin[3 * g];
		for (int k = 0; k < 3; ++k) {
			const bool isShared = (a[k] == b[0]) | (a[k] == b[1]) | (a[k] == b[2]);
			if (isShared && isFlat(a[k])) return true;
		}
		return false;
	}

private:
	const HalfEdgeMesh& m_;
	Buffer<char>        isFlat_; ///< per vertex; empty where each is looked at when it is asked for

	bool looksFlat(int v) const;
};

} // namespace gpr

#endif
