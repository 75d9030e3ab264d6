// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PREPARATION_H
#define VCG_EXTRAS_CORE_RUN_PREPARATION_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/features/feature_detection.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/sampling/sizing.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Everything before the sampling: the input loaded, cleaned, cut, ordered and connected, with its
/// target, sizes, feature region and feature lines.
class Preparation : RunPart {
public:
	explicit Preparation(RunContext& run) : RunPart(run) {}

	/// Finds the features on the caller's own mesh, before any split, so that they are those which
	/// detectFeatures finds.
	void         detectRegion();
	FeatureEdges detectOn(Surface& surface, double until);
	/// Loads, cleans, splits, orders and connects. fixedTarget replaces the options' target if
	/// above 0.
	Prepared prepare(std::int64_t fixedTarget);
	Prepared prepareAgain(std::int64_t targetNum);
	/// Marks the feature lines; from here on the surface does not change any more. Where there are
	/// more of them than the wanted vertices can follow, the shorter ones are left out, and where
	/// one runs close beside another the weaker one. The
	/// caller's own lines are added where they leave enough vertices to the surface between them.
	void findFeatureLines(Prepared& p);
	void forgetFeatureLines(Prepared& p);
	void describeInput(const Surface& surface);

private:
	std::vector<std::uint8_t> detected_; ///< per caller's vertex: of the detected features

	static std::int64_t mostFacesFor(std::int64_t targetNum, std::int64_t faceNum);
	void                setSizes(Prepared& p);
	Sizing              findSizes(Prepared& p);
	void                refine(Prepared& p, float longest);
	void                findFeatureRegion(Prepared& p);
	void                keepBorder(Prepared& p);
	/// Of the wanted vertices, that borders and feature lines take.
	static double shareOf(const BoundaryCurves& curves, const Prepared& p);
	double        followCreases(const CreaseRules& rules, Prepared& p);
	void          connectOrRepair(IndexedMesh& mesh, Surface& surface);
	void          dropFlatPieces(Surface& surface);
	IndexedMesh   loadCleaned();
	IndexedMesh   withoutUseless(IndexedMesh mesh);
	void          dropSmallComponents(Surface& surface);
	void          followGivenLines(Prepared& p);
	bool          namesSources(const Prepared& p) const;
	std::int64_t splitAsFarAsMemoryGoes(IndexedMesh& mesh, const FaceExtents& extents, Prepared& p);
	void         noteStrayFaces(const IndexedMesh& mesh, const std::vector<int>& longFaces);
	void         noteDetection(const FeatureEdges& features);
};

} // namespace gpr

#endif
