// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_result.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <unordered_map>

namespace gpr {

namespace {

/// Curve and arc length of each vertex on a curve; -1 for the other vertices.
std::unordered_map<int, std::pair<int, float>> findOnCurves(const BoundaryCurves&   boundary,
															const std::vector<int>& vertices)
{
	std::unordered_map<int, std::pair<int, float>> place;
	for (int v : vertices)
		place[v] = {-1, 0.0f};
	if (place.empty()) return place;
	for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
		const Curve& curve = boundary.curves[c];
		for (int i = 0; i < curve.pointNum(); ++i) {
			const auto found = place.find(curve.vertex[i]);
			if (found != place.end()) found->second = {int(c), curve.arc[i]};
		}
	}
	return place;
}

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
	result.leftoverNum = std::int64_t(removed.leftover.size());
	for (std::size_t s = 0; s < removed.sampleVertex.size(); ++s) {
		if (removed.sampleVertex[s] < 0) continue;
		result.vertex[newIndex[removed.sampleVertex[s]]] = recordOf(int(s), sampling, boundary);
	}
	std::vector<int> stayed = removed.leftover;
	if (!removed.surfaceVertex.empty()) {
		for (int& v : stayed)
			v = removed.surfaceVertex[v];
	}
	const auto onCurve = findOnCurves(boundary, stayed);
	for (std::size_t i = 0; i < stayed.size(); ++i) {
		const int     old = stayed[i];
		ResultVertex& r   = result.vertex[newIndex[removed.leftover[i]]];
		r.curve           = onCurve.at(old).first;
		r.arc             = onCurve.at(old).second;
		r.point           = {surface.mesh.position[old], surface.mesh.outgoing[old] / 3};
		r.normal          = surface.mesh.faceNormal(r.point.face);
	}
	workers.forEach(m.vertexNum, [&](int v) { m.position[v] = result.vertex[v].point.position; });
	result.mesh = std::move(m);
	return result;
}

} // namespace gpr
