// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_samples.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>
#include <vcg_extras/core/surface/nearest_samples.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>

namespace gpr {

GivenSamples takeOverSamples(RunContext& run, const Prepared& p, const std::vector<Vec3d>& points)
{
	run.clock.enter(Stage::GivenSamples);
	const NearestOnMesh tree(p.surface.mesh, run.workers);
	const float         onSurface = 1e-5f;
	GivenSamples        given;
	Sampling&           sampling = given.sampling;
	sampling.radius              = p.radius;
	float farthest               = 0;
	for (const Vec3d& point : points) {
		run.workers.poll();
		const Vec3f        q = p.surface.frame.toWorking(point);
		const SurfacePoint a = tree.nearest(q);
		if (a.face < 0) throw Failure(Status::BadOptions, "A sample is not finite.");
		const float moved = length(a.position - q);
		given.isMoved.push_back(moved > onSurface);
		run.report.samplesMoved += moved > onSurface;
		farthest = std::max(farthest, moved);
		sampling.samples.push_back({a, p.surface.mesh.faceNormal(a.face)});
	}
	run.report.largestSampleMove = double(farthest) / p.surface.frame.scale;
	run.report.sampleNum         = std::int64_t(points.size());
	sampling.nearest             = assignToSamples(p.surface, sampling.samples, run.workers);
	return given;
}

void nameSamples(const std::vector<Vec3d>& points, const std::vector<char>& isMoved,
				 const ResultMesh& result, RemeshResult& out)
{
	out.sampleOf.resize(result.vertex.size());
	for (std::size_t v = 0; v < result.vertex.size(); ++v) {
		const int s     = result.vertex[v].sample;
		out.sampleOf[v] = s;
		if (s >= 0 && !isMoved[s]) out.mesh.positions[v] = points[s];
	}
}

} // namespace gpr
