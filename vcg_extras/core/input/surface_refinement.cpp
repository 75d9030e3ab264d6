// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_refinement.h"

#include "split_long_edges.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/mesh/spatial_order.h>

namespace gpr {

std::int64_t refineSurface(const std::vector<int>& longFaces, float maxLength,
						   std::int64_t maxFaces, Surface& surface, Workers& workers)
{
	if (longFaces.empty()) return 0;
	IndexedMesh        mesh     = disconnect(surface);
	const std::int64_t splitNum = splitLongEdges(mesh, longFaces, maxLength, maxFaces, workers);
	Buffer<int>        faceStart;
	surface.grid = orderSpatially(mesh, workers, faceStart);
	if (!connect(mesh, faceStart, workers, surface))
		throw Failure(Status::InternalError, "The surface could not be connected anew.");
	return splitNum;
}

} // namespace gpr
