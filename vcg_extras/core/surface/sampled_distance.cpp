// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_distance.h"

#include "surface_distance.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Bounds of the number of points spread evenly. Of the most, 200 are beyond the p99.9.
constexpr std::int64_t leastEvenPoints = 20000, mostEvenPoints = 200000;

struct Largest {
	double   value = 0;
	Largest& operator+=(const Largest& o)
	{
		value = std::max(value, o.value);
		return *this;
	}
};

/// Distances of one mesh from the tree of another.
class OneWay {
public:
	OneWay(const HalfEdgeMesh& from, const CertifiedSurface& to, Workers& workers) :
			from_(from), to_(to), workers_(workers), ofVertices_(largestOfVertices())
	{
	}

	double ofVertices() const { return ofVertices_; }

	SurfaceDistance ofSurface(std::int64_t evenNum) const
	{
		const auto      ofPoint = [this](const Vec3d& p) { return distance(p); };
		SurfaceDistance d       = distanceOfEvenPoints(viewOf(from_), evenNum, ofPoint, workers_);
		d.max                   = std::max(d.max, ofVertices_);
		return d;
	}

private:
	const HalfEdgeMesh&     from_;
	const CertifiedSurface& to_;
	Workers&                workers_;
	double                  ofVertices_;

	double distance(const Vec3d& p) const
	{
		return std::sqrt(to_.tree().nearest(p - to_.origin()).squared);
	}

	double largestOfVertices() const
	{
		const auto largest = [this](std::size_t begin, std::size_t end) {
			Largest part;
			for (int v = int(begin); v < int(end); ++v) {
				if (from_.outgoing[v] >= 0) part += {distance(Vec3d(from_.position[v]))};
			}
			return part;
		};
		return workers_.sum<Largest>(from_.vertexNum, largest).value;
	}
};

} // namespace

SampledDistance sampledDistance(const MeasuredMesh& input, const MeasuredMesh& result,
								Workers& workers)
{
	if (input.mesh.faceNum == 0 || result.mesh.faceNum == 0) return {};
	const auto   evenNum = std::clamp<std::int64_t>(10 * std::int64_t(result.mesh.faceNum),
                                                  leastEvenPoints, mostEvenPoints);
	const OneWay there(result.mesh, input.surface, workers);
	const OneWay back(input.mesh, result.surface, workers);
	return {{there.ofSurface(evenNum), back.ofSurface(evenNum)}, there.ofVertices()};
}

} // namespace gpr
