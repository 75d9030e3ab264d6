// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_samples.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>
#include <vcg_extras/core/surface/nearest_samples.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>

namespace gpr {

GivenSamples takeOverSamples(const Surface& surface, const std::vector<Vec3d>& points,
							 Workers& workers)
{
	const NearestOnMesh tree(surface.mesh, workers);
	const float         onSurface = 1e-5f;
	GivenSamples        given;
	for (const Vec3d& point : points) {
		workers.poll();
		const Vec3f        q = surface.frame.toWorking(point);
		const SurfacePoint a = tree.nearest(q);
		if (a.face < 0) throw Failure(Status::BadOptions, "A sample is not finite.");
		const float moved = length(a.position - q);
		given.isMoved.push_back(moved > onSurface);
		given.movedNum += moved > onSurface;
		given.farthest = std::max(given.farthest, moved);
		given.sampling.samples.push_back({a, surface.mesh.faceNormal(a.face)});
	}
	given.sampling.nearest = assignToSamples(surface, given.sampling.samples, workers);
	return given;
}

} // namespace gpr
