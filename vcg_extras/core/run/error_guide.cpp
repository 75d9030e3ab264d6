// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_guide.h"

#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// How much is done about the places that are too far.
struct Effort {
	double reachInEdges; ///< triangles are made smaller so far round a place, in their own edges
	/// Over the size that would do if the error went with the size, as on creases and rims: samples
	/// fall elsewhere in every trial.
	double caution;
	double nearGoal; ///< nearer to the goal than this, a place may be beyond it in the next trial
};

/// There are many places after the first trial. Those after later ones are few, and shall be the
/// last.
constexpr Effort first = {1.2, 0.75, 0.9}, later = {1.5, 0.6, 0.8};
constexpr double leastOfTrial = 0.3, mostOfTrial = 0.8;

FineSpot spotAt(const FarPlace& place, const Effort& effort, double goal, double edge,
				const Surface& surface)
{
	FineSpot spot;
	spot.position = surface.frame.toCaller(Vec3f(place.position));
	spot.reach    = (effort.reachInEdges * edge + place.distance) / surface.frame.scale;
	spot.factor   = std::clamp(effort.caution * goal / place.distance, leastOfTrial, mostOfTrial);
	return spot;
}

double areaOf(const std::vector<FarPlace>& places, double goal)
{
	double area = 0;
	for (const FarPlace& p : places)
		if (p.distance > goal) area += p.area;
	return area;
}

double areaOf(const HalfEdgeMesh& m, Workers& workers)
{
	return workers.sum<double>(std::size_t(m.faceNum), [&](std::size_t begin, std::size_t end) {
		double area = 0;
		for (std::size_t f = begin; f < end; ++f)
			area += 0.5 * double(length(m.faceCross(int(f))));
		return area;
	});
}

/// Area mean of 1 / factor².
double meanDensity(const FineSpots& spots, const Surface& surface, Workers& workers)
{
	struct Sums {
		double weighted = 0, area = 0;
		Sums&  operator+=(const Sums& o)
		{
			weighted += o.weighted;
			area += o.area;
			return *this;
		}
	};
	const HalfEdgeMesh& m      = surface.mesh;
	const Buffer<float> factor = factorsOf(spots, surface, workers);
	const Sums          sums =
		workers.sum<Sums>(std::size_t(m.faceNum), [&](std::size_t begin, std::size_t end) {
			Sums s;
			for (std::size_t f = begin; f < end; ++f) {
				const double area = 0.5 * double(length(m.faceCross(int(f))));
				for (std::size_t k = 0; k < 3; ++k) {
					const double here = double(factor[std::size_t(m.origin[3 * f + k])]);
					s.weighted += area / (3 * here * here);
				}
				s.area += area;
			}
			return s;
		});
	return sums.area > 0 ? sums.weighted / sums.area : 1;
}

} // namespace

void findPlacesBeyond(RunContext& run, const Surface& surface, const ComparedSurfaces& both,
					  float idealEdge)
{
	ErrorGuide&   guide    = *run.guide;
	const double  goal     = guide.goal * surface.frame.scale;
	const Effort& effort   = guide.spots.empty() ? first : later;
	const double  limit    = effort.nearGoal * goal;
	const auto    ofInput  = placesBeyond(both.input, both.result, limit, run.workers);
	const auto    ofResult = placesBeyond(both.result, both.input, limit, run.workers);
	const double  total    = areaOf(surface.mesh, run.workers);
	guide.share            = std::min(1.0, areaOf(ofInput, goal) / std::max(total, 1e-300));
	guide.found.clear();
	for (const std::vector<FarPlace>* places : {&ofInput, &ofResult})
		for (const FarPlace& p : *places)
			guide.found.push_back(spotAt(p, effort, goal, double(idealEdge), surface));
	FineSpots all = guide.spots;
	all.push_back(guide.found);
	guide.growth =
		meanDensity(all, surface, run.workers) / meanDensity(guide.spots, surface, run.workers);
}

} // namespace gpr
