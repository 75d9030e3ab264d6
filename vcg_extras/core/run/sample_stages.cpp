// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_stages.h"

#include "feature_lines.h"
#include "improvement.h"

#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/retriangulation/hole_retriangulation.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/sampling/border_edge_sampling.h>
#include <vcg_extras/core/sampling/fuse_samples.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gpr {

namespace {

/// Least width of a block in r. Fewer, larger blocks mean fewer seams in the packing; few samples
/// fill too few of them for all threads to have work.
constexpr float        blockWidth      = 20;
constexpr float        smallBlockWidth = 12;
constexpr std::int64_t fewSamples      = 100000;

OctreeBlocks cutForRadius(RunContext& run, const Prepared& p, float radius)
{
	const float width = p.targetNum < fewSamples ? smallBlockWidth : blockWidth;
	return cutIntoBlocks(p.surface, width * radius, run.workers);
}

/// Whether it matters by how much the first go misses the count. Ridges and thin parts hold fewer
/// disks than their area lets expect, on scans up to a tenth of all. Where sizes follow the error
/// most, small disks lie just there, and the splits that make up for them would fall elsewhere.
bool mayMissCount(const RemeshOptions& options, const Prepared& p)
{
	const bool hasErrorSizes = options.adapt >= 0.5 && !p.surface.size.empty();
	return hasErrorSizes || p.surface.mesh.hasCreases() || !p.kept.empty();
}

/// Feature lines leave gaps between them and the front, all the more the nearer they are to
/// each other; so the radius is lowered by what the first go missed. Vertices to be kept are a
/// fixed number of the samples, however near to each other: the others get what they leave.
float correctedRadius(const Prepared& p, const Sampling& sampling, float radius)
{
	constexpr float aim = 0.985f; // of the wanted number
	// A few samples too many are soon merged and not worth another sampling.
	constexpr float fewest = 0.98f, most = 1.035f;
	constexpr float maxOnCurves = 0.7f;
	const float     kept        = float(p.kept.size());
	const float     wanted      = aim * float(p.targetNum) - kept;
	const float     share       = (float(sampling.samples.size()) - kept) / wanted;
	if (!(wanted > 0) || (share >= fewest && share <= most)) return radius;
	const float onCurves = float(sampling.boundarySampleNum) - kept;
	if (onCurves > maxOnCurves * (float(p.targetNum) - kept)) return radius;
	if (p.kept.empty()) return radius * std::sqrt(share);
	// Edges are cut for this radius; much smaller disks would own no vertices.
	constexpr float minRadius = 0.8f, minShare = 0.25f, maxShare = 4;
	return std::max(minRadius * p.radius,
					radius * std::sqrt(std::clamp(share, minShare, maxShare)));
}

/// The paper's placement fuses its samples into a mesh, which the removal of vertices goes on with.
void sampleOnBorderEdges(RunContext& run, const Prepared& p, float radius,
						 const Buffer<char>& first, Sampled& sampled)
{
	BorderEdgeOptions o;
	o.radius                  = radius;
	o.seed                    = run.options.seed;
	o.maxSamples              = 100000 + 10 * p.targetNum;
	o.region                  = &first;
	BorderEdgeSampling placed = sampleBorderEdges(p.surface, sampled.curves, o, run.workers);
	sampled.sampling          = std::move(placed.sampling);
	sampled.fused             = std::move(placed.fused);
}

void sampleWithRadius(RunContext& run, const Prepared& p, float radius,
					  const OctreeBlocks& partition, Sampled& sampled)
{
	const RemeshOptions& options = run.options;
	run.clock.enter(Stage::Boundary);
	sampled.curves =
		radius == p.curvesRadius ? p.curves : sampleCurves(p, radius, borderMode(options, p));
	run.clock.enter(Stage::Sampling);
	const Buffer<char>  noRegion;
	const bool          beginsInRegion = !keepsRegionVertices(options);
	const Buffer<char>& first          = beginsInRegion ? p.isFeatureVertex : noRegion;
	if (isPaper(options)) return sampleOnBorderEdges(run, p, radius, first, sampled);
	sampled.sampling =
		sampleFront(p.surface, sampled.curves, partition, radius, options.seed, run.workers, first);
}

void tellSampling(RunContext& run, const Prepared& p, const Sampling& sampling, float radius)
{
	run.report.sampleNum         = std::int64_t(sampling.samples.size());
	run.report.boundarySampleNum = sampling.boundarySampleNum;
	run.report.diskRadius        = double(radius) / p.surface.frame.scale;
	if (sampling.capped) run.tellCap("samples of a block");
}

/// The mesh that the border-edge placement fused its samples into, or one made now.
FusedMesh fusedMesh(RunContext& run, const Prepared& p, Sampled& sampled)
{
	if (!sampled.fused.sampleVertex.empty()) return std::move(sampled.fused);
	return fuseSamples(p.surface, sampled.sampling, sampled.curves, run.workers);
}

} // namespace

OctreeBlocks cutForSampling(RunContext& run, const Prepared& p)
{
	return cutForRadius(run, p, p.radius);
}

Sampled sampleSurface(RunContext& run, const Prepared& p)
{
	const bool isCorrected    = mayMissCount(run.options, p);
	const int  maxCorrections = !isCorrected ? 0 : p.kept.empty() ? 2 : 6;
	float      radius         = p.radius;
	Sampled    sampled;
	sampled.partition = cutForSampling(run, p);
	sampleWithRadius(run, p, radius, sampled.partition, sampled);
	for (int i = 0; i < maxCorrections; ++i) {
		const float corrected = correctedRadius(p, sampled.sampling, radius);
		if (corrected == radius) break;
		radius = corrected;
		if (p.kept.empty())
			sampleWithRadius(run, p, radius, sampled.partition, sampled);
		else
			sampleWithRadius(run, p, radius, cutForRadius(run, p, radius), sampled);
	}
	tellSampling(run, p, sampled.sampling, radius);
	return sampled;
}

Meshed retriangulateSamples(RunContext& run, const Prepared& p, Sampled sampled)
{
	run.clock.enter(Stage::Retriangulation);
	Meshed made;
	if (!isPaper(run.options)) {
		made.result = removeVertices(p.surface, sampled.sampling, sampled.curves,
									 run.report.cleanedInput, run.workers);
	}
	else {
		made.result =
			removeOriginalVertices(fusedMesh(run, p, sampled), p.surface, sampled.sampling,
								   sampled.curves, sampled.partition, run.workers);
	}
	made.curves = std::move(sampled.curves);
	return made;
}

Meshed sampleAndRetriangulate(RunContext& run, const Prepared& p)
{
	Meshed made             = retriangulateSamples(run, p, sampleSurface(run, p));
	made.result.idealEdge   = idealEdge(p);
	made.result.keepsBorder = run.options.boundary == BoundaryMode::Keep;
	made.result.hasSmoothBorder =
		borderMode(run.options, p) == BoundaryMode::Smooth && run.report.border.isSmooth;
	run.clock.enter(Stage::Flips);
	flipEdges(run, made.result);
	if (!repairInvertedFaces(p.surface, made.curves, true, made.result, run.workers))
		run.tellCap("changes for inverted faces");
	return made;
}

} // namespace gpr
