// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_CLOSEST_FACE_MAP_H
#define VCG_EXTRAS_CORE_SURFACE_CLOSEST_FACE_MAP_H

#include "result_mesh.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

namespace gpr {

/// The vertices of the working surface that belong to each face of the result. Each vertex belongs
/// to its nearest face, as found by a walk over the faces from its face before the last update: so
/// a nearby face of another sheet is never taken. 8 B per vertex of the working surface.
class ClosestFaceMap {
public:
	/// Finds the map by a flood over the working surface from the result's surface points. Cost:
	/// linear in the working surface, parallel.
	ClosestFaceMap(const Surface& surface, const ResultMesh& result, Workers& workers);

	/// Updates the map after moves of the result's vertices. The faces must be the same. Cost: a
	/// look at every vertex of the working surface, and a walk for the few vertices that change
	/// their face; parallel.
	void update(const ResultMesh& result, Workers& workers);

	/// The vertices that belong to face f of the result, in the same order for any number of
	/// threads. Vertices reached by no surface point belong to no face.
	const int* begin(int f) const { return item_.data() + start_[f]; }
	const int* end(int f) const { return item_.data() + start_[f + 1]; }

private:
	const Surface& surface_;
	Buffer<int>    start_; ///< per face of the result: the begin of its list in item_
	Buffer<int>    item_;
};

} // namespace gpr

#endif
