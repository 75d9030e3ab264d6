// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "staged_run.h"

#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/optimization/relaxation.h>
#include <vcg_extras/core/optimization/valence_glide.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/run/feature_lines.h>

namespace gpr::bench {

namespace {

class ImprovementSteps {
public:
	ImprovementSteps(const Prepared& prepared, const SampledState& sampled, Workers& workers) :
			prepared_(prepared), sampled_(sampled), workers_(workers)
	{
	}

	ResultMesh flipped(ResultMesh result)
	{
		flipToDelaunay(result, workers_);
		repairInvertedFaces(prepared_.surface, sampled_.curves, true, result, workers_);
		return result;
	}

	ResultMesh counted(ResultMesh result)
	{
		collapseShortEdges(prepared_.surface, result, workers_);
		reachExactCount(prepared_.surface, sampled_.curves, prepared_.targetNum, result, workers_);
		return result;
	}

	ResultMesh glided(ResultMesh result)
	{
		relaxOnce(prepared_.surface, result, workers_);
		glideDislocations(result, workers_);
		return result;
	}

	ResultMesh conformal(ResultMesh result)
	{
		relaxConformally(prepared_.surface, sampled_.curves, conformalSteps(2 * relaxationSteps),
						 result, workers_);
		return result;
	}

	ResultMesh repaired(ResultMesh result)
	{
		repairInvertedFaces(prepared_.surface, sampled_.curves, false, result, workers_);
		return result;
	}

	ResultMesh fitted(ResultMesh result)
	{
		fitToInput(prepared_.surface, sampled_.curves, usualFitSettings(), result, workers_);
		return result;
	}

private:
	const Prepared&     prepared_;
	const SampledState& sampled_;
	Workers&            workers_;
};

} // namespace

FitSettings usualFitSettings()
{
	FitSettings settings;
	settings.rounds = 3;
	return settings;
}

StagedRun::StagedRun(const MeshView& input, const RemeshOptions& options) :
		input_(input), options_(options), workers_(0, nullptr)
{
}

RunContext StagedRun::contextFor(Workers& workers)
{
	report_              = RemeshReport();
	report_.cleanedInput = inputFigures_;
	notes_.clear();
	return {input_,  options_, workers,
			report_, notes_,   StageClock(workers, report_, Pipeline::Remeshing)};
}

const MeshFigures& StagedRun::inputFigures()
{
	prepared();
	return inputFigures_;
}

Prepared& StagedRun::prepared()
{
	if (!prepared_) {
		RunContext run = contextFor(workers_);
		prepared_      = std::make_unique<Prepared>(prepare(run, {}));
		findFeatureLines(run, *prepared_);
		inputFigures_ = report_.cleanedInput;
	}
	return *prepared_;
}

const SampledState& StagedRun::sampled()
{
	if (!sampled_) {
		const Prepared& p     = prepared();
		RunContext      run   = contextFor(workers_);
		auto            state = std::make_unique<SampledState>();
		Sampled&        s     = *state;
		s                     = sampleSurface(run, p);
		state->mesh = removeVertices(p.surface, s.sampling, s.curves, inputFigures_, workers_);
		state->mesh.idealEdge = idealEdge(p);
		sampled_              = std::move(state);
	}
	return *sampled_;
}

const ImprovedStates& StagedRun::improved()
{
	if (!improved_) {
		const SampledState& s = sampled();
		ImprovementSteps    steps(prepared(), s, workers_);
		const auto          copy   = [&](const ResultMesh& r) { return copyResult(r, workers_); };
		auto                states = std::make_unique<ImprovedStates>();
		states->flipped            = steps.flipped(copy(s.mesh));
		states->counted            = steps.counted(copy(states->flipped));
		states->glided             = steps.glided(copy(states->counted));
		states->conformal          = steps.conformal(copy(states->glided));
		states->repaired           = steps.repaired(copy(states->conformal));
		states->fitted             = steps.fitted(copy(states->repaired));
		improved_                  = std::move(states);
	}
	return *improved_;
}

} // namespace gpr::bench
