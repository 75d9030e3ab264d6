// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CREASE_CLEARANCE_H
#define VCG_EXTRAS_CORE_FEATURES_CREASE_CLEARANCE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <vector>

namespace gpr {

/// Angle between the normals of the two faces of h, radians; 0 at a border and beside faces without
/// area.
float dihedralAngle(const HalfEdgeMesh& mesh, int h);

/// Tells the edges of a crease, which stand out from what is beside them, from those of noise,
/// which have others nearly as sharp beside them.
///
/// Where long edges have been split, the edges beside one are those of the caller's two faces that
/// meet there: the new ones inside of these are flat, and any noise would stand out from them.
class CreaseClearance {
public:
	/// For the edges that are creases now. `edges`: one half-edge of each, or more than these; only
	/// their clearance is known. isSplit: whether faces are only parts of the caller's. Cost:
	/// nothing unless isSplit, else a parallel pass over the faces.
	CreaseClearance(const Surface& surface, bool isSplit, const std::vector<int>& edges,
					Workers& workers);

	/// Whether h is three times as sharp as all edges beside it that are no creases, and there is
	/// one: a crease beside it, as at the corner of a cube, says nothing.
	bool isClear(int h) const;

private:
	const Surface&      surface_;
	const HalfEdgeMesh& m_;
	/// Per face of the caller that is asked for: the largest angle at its edges that are no
	/// creases. Empty if nothing was split.
	std::vector<float> steepest_;

	void  findSteepest(const std::vector<int>& edges, Workers& workers);
	bool  isBeside(int h, const std::vector<bool>& isAsked) const;
	float steepestBeside(int h) const;
};

} // namespace gpr

#endif
