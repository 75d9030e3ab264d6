// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_distance.h"

#include "face_tree.h"

#include <cmath>

namespace gpr {

namespace {

/// Spacing of the points in mean edges of the coarser mesh.
constexpr float spacingShare = 0.34f;
/// Points along the edge of a face at most.
constexpr float maxSteps = 1000;

float meanEdge(const HalfEdgeMesh& m, Workers& workers)
{
	const double sum =
		workers.sum<double>(m.halfEdgeNum(), [&](std::size_t begin, std::size_t end) {
			double part = 0;
			for (std::size_t h = begin; h < end; ++h)
				part += double(length(m.position[m.target(int(h))] - m.position[m.origin[h]]));
			return part;
		});
	return float(sum / std::max(1, m.halfEdgeNum()));
}

/// Calls visit(p) for a lattice of points on a face, without its corners.
template <class Visit>
void forEachInnerPoint(const HalfEdgeMesh& m, int f, float spacing, const Visit& visit)
{
	const Vec3f a  = m.position[m.origin[3 * f]];
	const Vec3f ab = m.position[m.origin[3 * f + 1]] - a, ac = m.position[m.origin[3 * f + 2]] - a;
	const float longest =
		std::sqrt(std::max({squaredLength(ab), squaredLength(ac), squaredLength(ac - ab)}));
	const int n = int(std::min(maxSteps, std::ceil(longest / spacing)));
	for (int i = 0; i < n; ++i) {
		for (int k = i == 0 ? 1 : 0; i + k <= n; ++k) {
			if (k < n) visit(a + ab * (float(i) / float(n)) + ac * (float(k) / float(n)));
		}
	}
}

struct Largest {
	float    value = 0;
	Largest& operator+=(const Largest& o)
	{
		value = std::max(value, o.value);
		return *this;
	}
};

float distance(const Vec3f& p, const FaceTree& to)
{
	return length(to.nearest(p).position - p);
}

Largest largestOfVertices(const HalfEdgeMesh& from, const FaceTree& to, Workers& workers)
{
	return workers.sum<Largest>(from.vertexNum, [&](std::size_t begin, std::size_t end) {
		Largest largest;
		for (std::size_t v = begin; v < end; ++v) {
			if (from.outgoing[v] >= 0) largest += {distance(from.position[v], to)};
		}
		return largest;
	});
}

float largestFrom(const HalfEdgeMesh& from, const FaceTree& to, float spacing, Workers& workers)
{
	Largest all = workers.sum<Largest>(from.faceNum, [&](std::size_t begin, std::size_t end) {
		Largest largest;
		for (std::size_t f = begin; f < end; ++f)
			forEachInnerPoint(from, int(f), spacing,
							  [&](const Vec3f& p) { largest += {distance(p, to)}; });
		return largest;
	});
	all += largestOfVertices(from, to, workers);
	return all.value;
}

} // namespace

float largestSampledDistance(const HalfEdgeMesh& a, const HalfEdgeMesh& b, Workers& workers)
{
	if (a.faceNum == 0 || b.faceNum == 0) return 0;
	const float    spacing = spacingShare * std::max(meanEdge(a, workers), meanEdge(b, workers));
	const FaceTree treeA(a, &workers), treeB(b, &workers);
	return std::max(largestFrom(a, treeB, spacing, workers),
					largestFrom(b, treeA, spacing, workers));
}

float largestVertexDistance(const HalfEdgeMesh& from, const HalfEdgeMesh& to, Workers& workers)
{
	if (to.faceNum == 0) return 0;
	return largestOfVertices(from, FaceTree(to, &workers), workers).value;
}

} // namespace gpr
