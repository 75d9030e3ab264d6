// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_STAGED_RUN_H
#define VCG_EXTRAS_BENCH_STAGED_RUN_H

#include <vcg_extras/core/run/remeshing.h>

#include <memory>

namespace gpr::bench {

/// The results before and between the stages of improvement, in their order.
struct ImprovedStates {
	ResultMesh flipped;  ///< to Delaunay, inverted faces repaired
	ResultMesh counted;  ///< with the exact count
	ResultMesh glided;   ///< relaxed, dislocations moved
	ResultMesh repaired; ///< triangles made equilateral, inverted faces repaired
	ResultMesh fitted;   ///< fitted to the input
};

/// A run of the engine that can be stopped before any step, for the input of the step. Made by the
/// engine's own steps on demand, by all threads, and kept.
class StagedRun {
public:
	StagedRun(const MeshView& input, const RemeshOptions& options);

	const MeshView&      input() const { return input_; }
	const RemeshOptions& options() const { return options_; }
	/// A run's context with other threads.
	RunContext contextFor(Workers& workers) const;
	/// A run after all steps before this step.
	std::unique_ptr<Remeshing> runUntil(Step step, int threads = 0) const;

	/// With the surface, its feature lines and samples.
	const Products&       sampled();
	const Decisions&      decisions();
	const ImprovedStates& improved();

private:
	MeshView                        input_;
	RemeshOptions                   options_;
	Workers                         workers_;
	std::unique_ptr<Remeshing>      sampled_;
	std::unique_ptr<ImprovedStates> improved_;
};

} // namespace gpr::bench

#endif
