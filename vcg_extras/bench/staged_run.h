// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_STAGED_RUN_H
#define VCG_EXTRAS_BENCH_STAGED_RUN_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/optimization/fit.h>
#include <vcg_extras/core/run/preparation.h>
#include <vcg_extras/core/run/sample_stages.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <memory>

namespace gpr::bench {

/// What the stages up to the retriangulation leave.
struct SampledState : Sampled {
	ResultMesh mesh; ///< straight from the retriangulation by label collapse
};

/// The result before and between the stages that improve it, in their order.
struct ImprovedStates {
	ResultMesh flipped;   ///< to Delaunay, inverted faces repaired
	ResultMesh counted;   ///< with the exact count
	ResultMesh glided;    ///< relaxed, dislocations glided
	ResultMesh conformal; ///< triangles made equilateral
	ResultMesh repaired;  ///< inverted faces repaired
	ResultMesh fitted;    ///< to the input
};

/// Those of a run with even triangles.
FitSettings usualFitSettings();

/// One run of the engine that can be stopped before any stage: what each of them begins with. Made
/// as far as it is asked for, by all threads, and kept.
class StagedRun {
public:
	StagedRun(const MeshView& input, const RemeshOptions& options);

	const MeshView&      input() const { return input_; }
	const RemeshOptions& options() const { return options_; }
	/// A run's context with other threads; its report and notes are gone with the next one.
	RunContext contextFor(Workers& workers);
	/// Of the surface.
	const MeshFigures& inputFigures();
	/// The surface with its feature lines.
	Prepared&             prepared();
	const SampledState&   sampled();
	const ImprovedStates& improved();

private:
	MeshView                        input_;
	RemeshOptions                   options_;
	Workers                         workers_;
	RemeshReport                    report_;
	MeshFigures                     inputFigures_;
	std::vector<std::string>        notes_;
	std::unique_ptr<Prepared>       prepared_;
	std::unique_ptr<SampledState>   sampled_;
	std::unique_ptr<ImprovedStates> improved_;
};

} // namespace gpr::bench

#endif
