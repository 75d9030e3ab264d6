// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_distance.h"

#include "face_tree.h"
#include "surface_distance.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Spacing of the points in mean edges of the coarser mesh.
constexpr float spacingShare = 0.34f;
/// Bounds of the number of points spread evenly. Of the most, 200 are beyond the p99.9.
constexpr std::int64_t leastEvenPoints = 20000, mostEvenPoints = 200000;
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

float spacingBetween(const HalfEdgeMesh& a, const HalfEdgeMesh& b, Workers& workers)
{
	return spacingShare * std::max(meanEdge(a, workers), meanEdge(b, workers));
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

Largest largestOfLattices(const HalfEdgeMesh& from, const FaceTree& to, float spacing,
						  Workers& workers)
{
	return workers.sum<Largest>(from.faceNum, [&](std::size_t begin, std::size_t end) {
		Largest largest;
		for (std::size_t f = begin; f < end; ++f)
			forEachInnerPoint(from, int(f), spacing,
							  [&](const Vec3f& p) { largest += {distance(p, to)}; });
		return largest;
	});
}

/// Distances of one mesh from the tree of another.
class OneWay {
public:
	OneWay(const HalfEdgeMesh& from, const FaceTree& to, float spacing, Workers& workers) :
			from_(from), to_(to), spacing_(spacing), workers_(workers),
			ofVertices_(largestOfVertices(from, to, workers).value)
	{
	}

	float ofVertices() const { return ofVertices_; }

	SurfaceDistance ofSurface(std::int64_t evenNum) const
	{
		const auto ofPoint     = [this](const Vec3d& p) { return double(distance(Vec3f(p), to_)); };
		SurfaceDistance d      = distanceOfEvenPoints(viewOf(from_), evenNum, ofPoint, workers_);
		const float     inside = largestOfLattices(from_, to_, spacing_, workers_).value;
		d.max                  = std::max({d.max, double(inside), double(ofVertices_)});
		return d;
	}

private:
	const HalfEdgeMesh& from_;
	const FaceTree&     to_;
	float               spacing_;
	Workers&            workers_;
	float               ofVertices_;
};

} // namespace

SampledDistance sampledDistance(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
								Workers& workers)
{
	if (input.faceNum == 0 || result.faceNum == 0) return {};
	const float    spacing = spacingBetween(input, result, workers);
	const FaceTree inputTree(input, &workers), resultTree(result, &workers);
	const auto     evenNum = std::clamp<std::int64_t>(10 * std::int64_t(result.faceNum),
                                                  leastEvenPoints, mostEvenPoints);
	const OneWay   there(result, inputTree, spacing, workers);
	const OneWay   back(input, resultTree, spacing, workers);
	return {{there.ofSurface(evenNum), back.ofSurface(evenNum)}, there.ofVertices()};
}

} // namespace gpr
