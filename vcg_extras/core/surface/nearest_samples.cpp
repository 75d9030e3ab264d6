// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_samples.h"

#include "surface_point.h"

#include <cmath>
#include <queue>

namespace gpr {

Buffer<NearestField::Nearest> assignToSamples(const Surface&             surface,
											  const std::vector<Sample>& samples, Workers& workers)
{
	// Dijkstra from all samples at once, by edges: cells only need to be sensible, not exact.
	const HalfEdgeMesh&           m = surface.mesh;
	Buffer<NearestField::Nearest> nearest(m.vertexNum, {HUGE_VALF, -1});
	std::priority_queue<Reach>    front;
	for (std::size_t s = 0; s < samples.size(); ++s) {
		const SurfacePoint& a = samples[s].point;
		for (int k = 0; k < 3; ++k) {
			const int v = m.origin[3 * a.face + k];
			front.push({length(m.position[v] - a.position), v, int(s)});
		}
	}
	for (std::int64_t popped = 0; !front.empty(); ++popped) {
		const Reach e = front.top();
		front.pop();
		if (popped % 65536 == 0) workers.poll();
		if (nearest[e.vertex].sample >= 0) continue;
		nearest[e.vertex] = {e.distance, e.label};
		forEachNeighbour(m, e.vertex, [&](int w) {
			if (nearest[w].sample >= 0) return;
			const float d = e.distance + length(m.position[w] - m.position[e.vertex]);
			front.push({d, w, e.label});
		});
	}
	return nearest;
}

} // namespace gpr
