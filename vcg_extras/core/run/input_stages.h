// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_INPUT_STAGES_H
#define VCG_EXTRAS_CORE_RUN_INPUT_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/feature_detection.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gpr {

// From the caller's mesh to a connected surface whose edges are short enough for the sampling.

/// The cleaned input, ordered and connected.
struct ConnectedInput {
	bool    mustSewFirst = false; ///< it has seams that are to be sewn; there is no surface then
	Surface surface;
	CleanCounts counts; ///< up to here
};

/// The detected features of an input, and what detection told.
struct DetectedRegion {
	FeatureThresholds        thresholds;
	FeatureMarks             marks;
	std::vector<std::string> notes, caps;
};

/// What all runs on one input have in common, whatever their counts, sizes, presets and seeds. A
/// run looks here first, and leaves here what it had to make. Nothing half-made is ever here.
class InputCache {
public:
	struct OfSewing {
		std::shared_ptr<CleanedInput> cleaned;
		std::optional<ConnectedInput> connected;
	};

	/// What was made with these options; what was made with others is forgotten.
	OfSewing& of(const RemeshOptions& options, Sewing sewing);
	/// The same of the feature region.
	std::optional<DetectedRegion>& region(const RemeshOptions& options);

private:
	/// What of the options decides how the input is cleaned.
	bool                          sew_                 = true;
	std::int64_t                  dropComponentsBelow_ = 0;
	bool                          keepsJunctions_      = false;
	std::array<OfSewing, 3>       of_; ///< by Sewing
	std::optional<DetectedRegion> region_;

	void fitTo(const RemeshOptions& options);
};

// The cache of each function below is null where a run is the only one on its input. Then the input
// belongs to the run alone and is handed over, so that the run needs no memory for it.

/// Finds the features on the caller's own mesh, before any edge is split. The mesh becomes
/// `surface`.
FeatureEdges detectOnInput(RunContext& run, WorkingSurface& surface);

/// Stage InputFigures: counts the working surface.
void countInput(RunContext& run, WorkingSurface& surface);

/// Step Region: finds the features for the feature region where the options ask for them, the same
/// as detectFeatures.
NoFacts findRegion(RunContext& run, InputCache* cache, Products& made);

/// Step Input: takes the caller's mesh over without faulty faces, with seams sewn where that is
/// decided, and without the components that the options drop. They must go before the area is
/// found, and with it the radius. Throws Failure where nothing with an area is left.
InputFacts makeInput(RunContext& run, const Decisions& decisions, InputCache* cache,
					 Products& made);

/// Step Surface: splits edges that are too long for the sampling, orders the mesh in space,
/// connects its faces, and repairs it where it is not manifold. Throws Failure where memory would
/// not do.
SurfaceFacts makeSurface(RunContext& run, const Decisions& decisions, InputCache* cache,
						 Products& made);

/// Makes and keeps all that runs with these options have in common.
void fillCache(RunContext& run, InputCache& cache, Products& made);

} // namespace gpr

#endif
