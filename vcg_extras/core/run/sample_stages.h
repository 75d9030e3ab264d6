// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H
#define VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/blocks.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/sampling/fused_mesh.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// The paper's removal of vertices knows no curves but the border.
bool followsFeatureLines(const RemeshOptions& options);

/// Samples of border and feature lines for disks of that radius.
BoundaryCurves sampleCurves(const Prepared& p, float radius, BoundaryMode border);

/// From the surface to samples, and from samples to a mesh, by the stages that the options choose.
class SampleStages : RunPart {
public:
	explicit SampleStages(RunContext& run) : RunPart(run) {}

	BlockPartition cut(const Prepared& p);
	/// Samples of about the wanted number.
	Sampling   sampleAll(const Prepared& p, const BlockPartition& partition,
						 BoundaryCurves& boundary);
	ResultMesh sampleAndRetriangulate(const Prepared& p, BoundaryCurves& boundary);
	/// From samples to a mesh of them, in the way the options ask for.
	ResultMesh retriangulateFrom(const Prepared& p, const Sampling& sampling,
								 const BoundaryCurves& boundary, const BlockPartition& partition);

private:
	const Buffer<char> noRegion_;
	FusedMesh          fused_; ///< with the samples of the border-edge placement

	BlockPartition      cut(const Prepared& p, float radius);
	static float        correctedRadius(const Prepared& p, const Sampling& sampling, float radius);
	Sampling            sampleOnce(const Prepared& p, float radius, const BlockPartition& partition,
								   BoundaryCurves& boundary);
	const Buffer<char>& presampled(const Prepared& p) const;
	Sampling  sampleOnBorderEdges(const Prepared& p, float radius, const BoundaryCurves& boundary);
	FusedMesh takeFused(const Prepared& p, const Sampling& sampling,
						const BoundaryCurves& boundary);
};

} // namespace gpr

#endif
