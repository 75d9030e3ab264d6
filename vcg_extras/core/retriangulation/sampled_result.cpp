// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_result.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <unordered_map>

namespace gpr {

namespace {

/// A sample, with its curve if the sample is on the border.
ResultVertex recordOf(int s, const Sampling& sampling, const BoundaryCurves& boundary)
{
	ResultVertex r;
	r.point  = sampling.samples[s].point;
	r.normal = sampling.samples[s].normal;
	r.sample = s;
	if (s < sampling.boundarySampleNum && std::size_t(s) < boundary.samples.size()) {
		r.curve    = boundary.samples[s].curve;
		r.arc      = boundary.samples[s].arc;
		r.isCorner = boundary.samples[s].isCorner;
		r.isShared = boundary.samples[s].isShared;
		r.isPinned = boundary.samples[s].isPinned;
	}
	return r;
}

/// Looks up the curves of some vertices of the surface; stayed: their records.
void putOnCurves(const BoundaryCurves&                         boundary,
				 const std::unordered_map<int, ResultVertex*>& stayed)
{
	if (stayed.empty()) return;
	for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
		const Curve& curve = boundary.curves[c];
		for (int i = 0; i < curve.pointNum(); ++i) {
			const auto found = stayed.find(curve.vertex[i]);
			if (found == stayed.end()) continue;
			found->second->curve = int(c);
			found->second->arc   = curve.arc[i];
		}
	}
}

} // namespace

ResultMesh resultOfSamples(Retriangulated&& removed, const Surface& surface,
						   const Sampling& sampling, const BoundaryCurves& boundary,
						   Workers& workers)
{
	ResultMesh    result;
	HalfEdgeMesh& m = removed.mesh;
	Buffer<int>   newIndex;
	compact(m, workers, newIndex);
	result.vertex.resize(m.vertexNum);
	result.leftoverNum = std::int64_t(removed.todo.size());
	for (std::size_t s = 0; s < removed.sampleVertex.size(); ++s) {
		if (removed.sampleVertex[s] < 0) continue;
		result.vertex[newIndex[removed.sampleVertex[s]]] = recordOf(int(s), sampling, boundary);
	}
	std::unordered_map<int, ResultVertex*> stayed;
	for (int v : removed.todo) {
		const int     old = removed.surfaceVertex.empty() ? v : removed.surfaceVertex[v];
		ResultVertex& r   = result.vertex[newIndex[v]];
		r.point           = pointOfVertex(surface, old);
		r.normal          = surface.mesh.faceNormal(r.point.face);
		stayed[old]       = &r;
	}
	putOnCurves(boundary, stayed);
	workers.forEach(m.vertexNum, [&](int v) { m.position[v] = result.vertex[v].point.position; });
	result.mesh = std::move(m);
	return result;
}

} // namespace gpr
