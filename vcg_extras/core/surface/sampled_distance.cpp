// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_distance.h"

#include "face_tree.h"
#include "surface_distance.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Bounds of the number of points spread evenly. Of the most, 200 are beyond the p99.9.
constexpr std::int64_t leastEvenPoints = 20000, mostEvenPoints = 200000;

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

/// Distances of one mesh from the tree of another.
class OneWay {
public:
	OneWay(const HalfEdgeMesh& from, const FaceTree& to, Workers& workers) :
			from_(from), to_(to), workers_(workers),
			ofVertices_(largestOfVertices(from, to, workers).value)
	{
	}

	float ofVertices() const { return ofVertices_; }

	SurfaceDistance ofSurface(std::int64_t evenNum) const
	{
		const auto ofPoint = [this](const Vec3d& p) { return double(distance(Vec3f(p), to_)); };
		SurfaceDistance d  = distanceOfEvenPoints(viewOf(from_), evenNum, ofPoint, workers_);
		d.max              = std::max(d.max, double(ofVertices_));
		return d;
	}

private:
	const HalfEdgeMesh& from_;
	const FaceTree&     to_;
	Workers&            workers_;
	float               ofVertices_;
};

} // namespace

SampledDistance sampledDistance(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
								Workers& workers)
{
	if (input.faceNum == 0 || result.faceNum == 0) return {};
	const FaceTree inputTree(input, &workers), resultTree(result, &workers);
	const auto     evenNum = std::clamp<std::int64_t>(10 * std::int64_t(result.faceNum),
                                                  leastEvenPoints, mostEvenPoints);
	const OneWay   there(result, inputTree, workers);
	const OneWay   back(input, resultTree, workers);
	return {{there.ofSurface(evenNum), back.ofSurface(evenNum)}, there.ofVertices()};
}

} // namespace gpr
