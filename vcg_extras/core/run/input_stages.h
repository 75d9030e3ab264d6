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
#include <tuple>
#include <vector>

namespace gpr {

// From the input mesh to a connected surface with edges short enough for the sampling.

/// The cleaned input, connected.
struct ConnectedInput {
	bool    mustSewFirst = false; ///< the input has seams to be sewn, and there is no surface yet
	Surface surface;
	CleanCounts counts; ///< of all changes so far
};

/// The detected features of an input, with the notes and caps of the detection.
struct DetectedRegion {
	FeatureThresholds        thresholds;
	FeatureMarks             marks;
	std::vector<std::string> notes, caps;
};

/// The products that all runs on one input share, whatever the counts, sizes, presets and seeds. A
/// run takes products from the cache, and stores new products. The cache
/// holds complete products only.
struct InputCache {
	struct OfSewing {
		std::shared_ptr<CleanedInput> cleaned;
		std::optional<ConnectedInput> connected;
	};

	std::array<OfSewing, 3>       ofSewing; ///< by Sewing
	std::optional<DetectedRegion> region;
	/// The options for the cleaning of the input: see fitTo().
	std::tuple<bool, std::int64_t, bool, bool> options;

	/// Drops products for other options. For use at the begin of a run with the cache.
	void      fitTo(const RemeshOptions& wanted);
	OfSewing& of(Sewing sewing) { return ofSewing[std::size_t(sewing)]; }
};

// A null cache means that no other run uses the input. Then the run consumes the input, and needs
// no memory for a copy.

/// Finds features on the input mesh, before long edges are split. `surface` gets the connected
/// mesh.
FeatureEdges detectOnInput(RunContext& run, WorkingSurface& surface);

/// Stage InputFigures: measures the working surface.
void countInput(RunContext& run, WorkingSurface& surface);

/// Step Region: finds features for the feature region, if the options ask for detection. The
/// features are the same as of detectFeatures.
void findRegion(RunContext& run, InputCache* cache, Products& made);

/// Step Input: takes the input mesh without faulty faces and without the components that the
/// options drop; sews seams if decided. The remaining faces give area and radius. Throws Failure if
/// the remaining faces have no area.
InputFacts makeInput(RunContext& run, const Decisions& decisions, InputCache* cache,
					 Products& made);

/// Step Surface: splits edges that are too long for the sampling, orders the mesh in space,
/// connects the faces, and repairs places that are not manifold. Throws Failure if the memory does
/// not suffice.
SurfaceFacts makeSurface(RunContext& run, const Decisions& decisions, InputCache* cache,
						 Products& made);

/// Step Sizes: splits the edges of long faces, and connects the parts. New vertices get sizes, too.
void splitSurface(RunContext& run, const LongFaces& tooLong, std::int64_t vertexNum,
				  WorkingSurface& surface);

/// Makes and keeps all products that runs with these options share.
void fillCache(RunContext& run, InputCache& cache, Products& made);

} // namespace gpr

#endif
