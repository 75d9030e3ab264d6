// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_KEPT_INPUT_H
#define VCG_EXTRAS_CORE_RUN_KEPT_INPUT_H

#include "detection.h"
#include "loading.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/report.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gpr {

/// The input without faults, before its edges are split.
struct CleanedInput {
	IndexedMesh mesh;
	FaceExtents extents;
	CleanCounts counts; ///< of what cleaning did
};

/// The same, ordered and connected.
struct ConnectedInput {
	bool    mustSewFirst = false; ///< it has seams that are to be sewn; there is no surface then
	Surface surface;
	CleanCounts counts; ///< up to here
};

/// The detected features of an input, and what detection told.
struct KeptFeatures {
	FeatureThresholds        thresholds;
	FeatureMarks             marks;
	std::vector<std::string> notes, caps;
};

/// What all runs on one input have in common, whatever their counts, sizes, presets and seeds. A
/// run looks here first, and leaves here what it had to make. Nothing half-made is ever here.
struct KeptInput {
	/// What of the options decides how the input is cleaned.
	bool         sew                 = true;
	std::int64_t dropComponentsBelow = 0;

	struct OfSewing {
		std::optional<CleanedInput>   cleaned;
		std::optional<ConnectedInput> connected;
	};
	std::array<OfSewing, 3>     of; ///< by Sewing
	std::optional<KeptFeatures> features;

	/// Forgets what was made with other options.
	void fitTo(const RemeshOptions& options);
};

/// The cleaned input of a run. Where nothing is kept (RunContext::kept is null) it belongs to the
/// run alone and is handed over, so that a single run needs no memory for it.
class InputOfRun {
public:
	/// Cleans the input, unless that was kept. Tells the report what was cleaned.
	InputOfRun(RunContext& run, Sewing sewing);

	const CleanedInput& cleaned() const { return *cleaned_; }
	/// The cleaned mesh, to be changed; not to be called twice.
	IndexedMesh takeMesh();
	/// The whole input, connected and without pieces that have no area. False where seams must be
	/// sewn first. Not to be called after takeMesh.
	bool takeSurface(Surface& surface);

private:
	RunContext&         run_;
	Sewing              sewing_;
	CleanedInput        own_;
	const CleanedInput* cleaned_ = &own_;

	KeptInput::OfSewing& kept() { return run_.kept->of[std::size_t(sewing_)]; }
};

/// Orders and connects a mesh, which is used up, and drops pieces without area. False where its
/// seams must be sewn first: most meshes have none, which is soon seen where the border is known.
/// To look for them before would take a tenth of a quick run.
bool connectCleaned(RunContext& run, Sewing sewing, IndexedMesh& mesh, Surface& surface);

/// The features for the feature region, as detectRegion finds them.
FeatureMarks regionOfRun(RunContext& run);

/// Makes and keeps all that runs with these options have in common. Needs RunContext::kept.
void keepInput(RunContext& run);

} // namespace gpr

#endif
