// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_stages.h"

#include "improvement.h"

#include <vcg_extras/core/optimization/crease_sides.h>
#include <vcg_extras/core/optimization/fold_repair.h>
#include <vcg_extras/core/retriangulation/hole_retriangulation.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/sampling/border_edge_sampling.h>
#include <vcg_extras/core/sampling/fuse_samples.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gpr {

namespace {

/// Least width of a block in r; fewer, larger blocks mean fewer seams in the packing.
constexpr float blockWidth      = 20;
constexpr float smallBlockWidth = 12;
constexpr int   smallMeshFaces  = 2000000;

} // namespace

bool followsFeatureLines(const RemeshOptions& options)
{
	return options.retriangulation == Retriangulation::LabelCollapse;
}

BoundaryCurves sampleCurves(const Prepared& p, float radius, BoundaryMode border)
{
	return sampleBoundary(p.surface, radius, borderSpacing * radius, p.tips, p.kept, border);
}

BlockPartition SampleStages::cut(const Prepared& p)
{
	return cut(p, p.radius);
}

Sampling SampleStages::sampleAll(const Prepared& p, const BlockPartition& partition,
								 BoundaryCurves& boundary)
{
	const int mostCorrections = p.kept.empty() ? 2 : 6;
	float     radius          = p.radius;
	Sampling  sampling        = sampleOnce(p, radius, partition, boundary);
	for (int i = 0; i < mostCorrections; ++i) {
		const float corrected = correctedRadius(p, sampling, radius);
		if (corrected == radius) break;
		radius   = corrected;
		sampling = sampleOnce(p, radius, p.kept.empty() ? partition : cut(p, radius), boundary);
	}
	report_.sampleNum         = std::int64_t(sampling.samples.size());
	report_.boundarySampleNum = sampling.boundarySampleNum;
	report_.diskRadius        = double(radius) / p.surface.frame.scale;
	if (sampling.capped) report_.capsReached.push_back("samples of a block");
	return sampling;
}

ResultMesh SampleStages::sampleAndRetriangulate(const Prepared& p, BoundaryCurves& boundary)
{
	const BlockPartition partition = cut(p);
	Sampling             sampling  = sampleAll(p, partition, boundary);
	clock_.enter("retriangulation", "Retriangulating", 0.8);
	ResultMesh result  = retriangulateFrom(p, sampling, boundary, partition);
	result.idealEdge   = idealEdge(p);
	result.keepsBorder = options_.boundary == BoundaryMode::Keep;
	sampling           = Sampling();
	clock_.enter("flips", "Flipping edges", 0.83);
	flipEdges(run_, result);
	mendFolds(p.surface, boundary, true, result, workers_);
	alignFacesAtCreases(p.surface, boundary, result, workers_);
	return result;
}

ResultMesh SampleStages::retriangulateFrom(const Prepared& p, const Sampling& sampling,
										   const BoundaryCurves& boundary,
										   const BlockPartition& partition)
{
	if (options_.retriangulation == Retriangulation::LabelCollapse)
		return removeVertices(p.surface, sampling, boundary, report_.cleanedInput, workers_);
	return removeOriginalVertices(takeFused(p, sampling, boundary), p.surface, sampling, boundary,
								  partition, workers_);
}

BlockPartition SampleStages::cut(const Prepared& p, float radius)
{
	const bool small = p.surface.mesh.faceNum < smallMeshFaces;
	return cutIntoBlocks(p.surface, (small ? smallBlockWidth : blockWidth) * radius, workers_);
}

/// Feature lines leave gaps between them and the front, all the more the nearer they are to
/// each other; so the radius is lowered by what the first go missed. Vertices to be kept are a
/// fixed number of the samples, however near to each other: the others get what they leave.
float SampleStages::correctedRadius(const Prepared& p, const Sampling& sampling, float radius)
{
	constexpr float aim = 0.985f; // of the wanted number
	// A few samples too many are soon merged and not worth another sampling.
	constexpr float fewest = 0.98f, most = 1.035f;
	constexpr float mostOnCurves = 0.7f;
	if (!p.surface.mesh.hasCreases() && p.kept.empty()) return radius;
	const float kept   = float(p.kept.size());
	const float wanted = aim * float(p.targetNum) - kept;
	const float share  = (float(sampling.samples.size()) - kept) / wanted;
	if (!(wanted > 0) || (share >= fewest && share <= most)) return radius;
	const float onCurves = float(sampling.boundarySampleNum) - kept;
	if (onCurves > mostOnCurves * (float(p.targetNum) - kept)) return radius;
	if (p.kept.empty()) return radius * std::sqrt(share);
	// Edges are cut for this radius; much smaller disks would own no vertices.
	constexpr float leastRadius = 0.8f, leastShare = 0.25f, mostShare = 4;
	return std::max(leastRadius * p.radius,
					radius * std::sqrt(std::clamp(share, leastShare, mostShare)));
}

Sampling SampleStages::sampleOnce(const Prepared& p, float radius, const BlockPartition& partition,
								  BoundaryCurves& boundary)
{
	clock_.enter("boundary", "Sampling the boundary", 0.24);
	boundary = radius == p.curvesRadius ? p.curves : sampleCurves(p, radius, options_.boundary);
	clock_.enter("sampling", "Sampling", 0.6);
	if (options_.placement == Placement::BorderEdge)
		return sampleOnBorderEdges(p, radius, boundary);
	return sampleFront(p.surface, boundary, partition, radius, options_.seed, workers_,
					   presampled(p));
}

/// What of the surface is sampled first.
const Buffer<char>& SampleStages::presampled(const Prepared& p) const
{
	return options_.featureSampling == FeatureSampling::Disks ? p.isFeatureVertex : noRegion_;
}

/// The paper's placement; keeps the mesh that the samples were fused into.
Sampling SampleStages::sampleOnBorderEdges(const Prepared& p, float radius,
										   const BoundaryCurves& boundary)
{
	BorderEdgeOptions o;
	o.radius                  = radius;
	o.seed                    = options_.seed;
	o.mostSamples             = 100000 + 10 * p.targetNum;
	o.region                  = &presampled(p);
	BorderEdgeSampling placed = sampleBorderEdges(p.surface, boundary, o, workers_);
	if (options_.retriangulation == Retriangulation::VertexRemoval)
		fused_ = std::move(placed.fused);
	return std::move(placed.sampling);
}

/// The mesh that the border-edge placement fused its samples into, or one made now.
FusedMesh SampleStages::takeFused(const Prepared& p, const Sampling& sampling,
								  const BoundaryCurves& boundary)
{
	FusedMesh fused;
	std::swap(fused, fused_);
	if (!fused.sampleVertex.empty()) return fused;
	return fuseSamples(p.surface, sampling, boundary, workers_);
}

} // namespace gpr
