// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_ranges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gpr {

namespace {

/// The most samples on a face. Disks of radius (1-ε) r/2 do not overlap, so a sample takes at least
/// 0.78 r² of flat ground; 0.5 r² is counted. A needle has almost no area: its length counts.
double roomOf(const Surface& surface, int f, float radius)
{
	const HalfEdgeMesh& m      = surface.mesh;
	const int*          v      = &m.origin[3 * f];
	const bool          graded = !surface.size.empty();
	const float         size =
        graded ? std::min({surface.size[v[0]], surface.size[v[1]], surface.size[v[2]]}) : 1.0f;
	const float  r  = radius * size;
	const Vec3f  a  = m.position[v[0]];
	const Vec3f  ab = m.position[v[1]] - a, ac = m.position[v[2]] - a;
	const double area = 0.5 * double(length(cross(ab, ac)));
	const double longest =
		double(std::max({squaredLength(ab), squaredLength(m.position[v[2]] - m.position[v[1]]),
						 squaredLength(ac)}));
	const double bySpace = area / (0.5 * double(r) * r);
	return area < 0.05 * longest ? bySpace + std::sqrt(longest) / (0.5 * r) : bySpace;
}

} // namespace

std::vector<BlockRange> makeRanges(const Surface& surface, const OctreeBlocks& partition,
								   float radius, int firstSample, Workers& workers)
{
	constexpr int           spareRoom = 64; // even a block of few vertices may need these
	const HalfEdgeMesh&     m         = surface.mesh;
	std::vector<BlockRange> ranges(partition.blocks.size());
	// Faces are ordered by their first corner, so the faces of a block are consecutive.
	workers.forTasks(ranges.size(), [&](std::size_t b, int) {
		const auto firstFaceFrom = [&](int vertex) {
			int low = 0, high = m.faceNum;
			while (low < high) {
				const int middle = low + (high - low) / 2;
				if (m.origin[3 * middle] < vertex)
					low = middle + 1;
				else
					high = middle;
			}
			return low;
		};
		double    room = spareRoom;
		const int end  = firstFaceFrom(partition.blocks[b].end);
		for (int f = firstFaceFrom(partition.blocks[b].begin); f < end; ++f)
			room += roomOf(surface, f, radius);
		ranges[b].room = int(std::min(room, 1e9));
	});
	std::int64_t next = firstSample;
	for (BlockRange& range : ranges) {
		range.firstSample = int(next);
		next += range.room;
	}
	return ranges;
}

} // namespace gpr
