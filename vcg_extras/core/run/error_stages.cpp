// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_stages.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/optimization/goal_refinement.h>
#include <vcg_extras/core/output/distance_proof.h>
#include <vcg_extras/core/sampling/sizing.h>
#include <vcg_extras/core/sampling/target.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// How strongly the next trial reacts to places beyond the error bound.
struct Effort {
	double reachInEdges; ///< radius of smaller triangles round a place, in ideal edges
	/// Factor on the size that would suffice if the error were proportional to the size, as on
	/// creases and rims. Below 1, because each trial places samples elsewhere.
	double caution;
};

/// The first trial leaves many far places, the second fewer; later trials shall leave none.
constexpr Effort first = {1.2, 0.75}, second = {1.5, 0.6}, later = {1.5, 0.5};
constexpr double leastOfTrial = 0.3, mostOfTrial = 0.8;

const Effort& effortAfter(std::size_t missedNum)
{
	if (missedNum == 0) return first;
	return missedNum == 1 ? second : later;
}

FineSpot spotAt(const FarPlace& place, const Effort& effort, double goal, double edge,
				const Surface& surface)
{
	FineSpot spot;
	spot.position = surface.frame.toCaller(Vec3f(place.position));
	spot.reach    = (effort.reachInEdges * edge + place.distance) / surface.frame.scale;
	spot.factor   = std::clamp(effort.caution * goal / place.distance, leastOfTrial, mostOfTrial);
	return spot;
}

double areaOf(const std::vector<FarPlace>& places)
{
	double area = 0;
	for (const FarPlace& p : places)
		area += p.area;
	return area;
}

/// The factor by which smaller triangles at the spots raise the number of triangles.
double growthBy(const FineSpots& spots, const Surface& surface, Workers& workers)
{
	return meanSquaredStretch(surface, factorsOf(spots, surface, workers), workers);
}

/// Finds the places at which the result is farther from the surface than the bound.
ErrorFacts findPlacesBeyond(RunContext& run, double goal, const ComparedSurfaces& both,
							FineSpots& spots, const Products& made)
{
	const Surface& surface  = made.surface;
	const double   limit    = goal * surface.frame.scale;
	const Effort&  effort   = effortAfter(spots.size());
	const auto     ofInput  = placesBeyond(both.input, both.result, limit, run.workers);
	const auto     ofResult = placesBeyond(both.result, both.input, limit, run.workers);
	const double   total    = surfaceArea(surface.mesh, run.workers);
	ErrorFacts     facts;
	facts.share         = std::min(1.0, areaOf(ofInput) / std::max(total, 1e-300));
	const double before = growthBy(spots, surface, run.workers);
	spots.emplace_back();
	for (const std::vector<FarPlace>* places : {&ofInput, &ofResult})
		for (const FarPlace& p : *places)
			spots.back().push_back(
				spotAt(p, effort, limit, double(made.result.idealEdge), surface));
	facts.growth = growthBy(spots, surface, run.workers) / before;
	return facts;
}

} // namespace

ErrorGoal errorGoalOf(const MeshView& input, const RemeshOptions& options, const MeshExtent& extent)
{
	ErrorGoal goal;
	goal.largest = largestError(options, extent.diagonal);
	goal.most    = std::min<std::int64_t>(200000000, 10000 + 10 * std::int64_t(input.vertexNum));
	const double edge = edgePerError * goal.largest;
	const double n    = edge > 0 ? vertexNumForEdgeLength(extent.area, edge) : 1;
	goal.start        = std::int64_t(std::min(double(goal.most), std::max(4.0, n)));
	return goal;
}

RefinementFacts refineResult(RunContext& run, const ErrorGoal& goal, Products& made)
{
	// Before came the removal of contacts. Where it found none the mesh is as it was refined.
	const bool isSame = made.guarded.foundPairNum == 0 && !made.surface.mesh.meetsAtPlaces;
	if (made.keepsGoal && isSame) return {};
	run.clock.enter(Stage::Fit);
	const double       largest = goal.largest * made.surface.frame.scale;
	const std::int64_t before  = made.result.vertexNum();
	made.keepsGoal = refineToGoal(made.surface, made.curves, largest, made.result, run.workers);
	return {int(made.result.vertexNum() - before), true};
}

ErrorFacts measureError(RunContext& run, const ErrorGoal& goal, FineSpots& spots, Products& made)
{
	run.clock.enter(Stage::Error);
	const ComparedSurfaces both(made.surface, made.result, run.workers);
	made.verified.proof = proveDistance(run, made.surface, made.surface.figures.diagonal, both);
	const double error  = made.verified.proof.bounds.hausdorff().upper;
	ErrorFacts   facts;
	if (error > goal.largest) facts = findPlacesBeyond(run, goal.largest, both, spots, made);
	facts.error = error;
	return facts;
}

} // namespace gpr
