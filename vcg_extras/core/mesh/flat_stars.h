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

private:
	const HalfEdgeMesh& m_;
	Buffer<char>        isFlat_; ///< per vertex; empty where each is looked at when it is asked for

	bool looksFlat(int v) const;
};

} // namespace gpr

#endif
