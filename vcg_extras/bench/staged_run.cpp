// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "staged_run.h"

#include <vcg_extras/core/run/result_stages.h>

namespace gpr::bench {

StagedRun::StagedRun(const MeshView& input, const RemeshOptions& options) :
		input_(input), options_(options), workers_(0, nullptr)
{
}

RunContext StagedRun::contextFor(Workers& workers) const
{
	return {input_, options_, workers, StageClock(workers, Pipeline::Remeshing), {}, {}};
}

std::unique_ptr<Remeshing> StagedRun::runUntil(Step step, int threads) const
{
	RemeshOptions options                = options_;
	options.threads                      = threads;
	static const ProgressCallback silent = nullptr;
	auto                          run =
		std::make_unique<Remeshing>(Call{input_, options, silent}, Pipeline::Remeshing, Request{});
	while (run->next() < step)
		run->takeStep();
	return run;
}

const Products& StagedRun::sampled()
{
	if (!sampled_) sampled_ = runUntil(Step::Triangles);
	return sampled_->made();
}

const Decisions& StagedRun::decisions()
{
	sampled();
	return sampled_->decisions();
}

const ImprovedStates& StagedRun::improved()
{
	if (improved_) return *improved_;
	auto       states = std::make_unique<ImprovedStates>();
	const auto run    = runUntil(Step::Count);
	const auto copy   = [&] { return copyResult(run->made().result, workers_); };
	states->flipped   = copy();
	run->takeStep();
	states->counted    = copy();
	RunContext context = contextFor(workers_);
	ResultMesh glided  = copy();
	relaxAndGlide(context, run->made().surface, run->made().curves, glided);
	states->glided = std::move(glided);
	run->takeStep();
	states->repaired = copy();
	states->fitted   = copy();
	fitToInput(run->made().surface, run->made().curves, fitSettings(options_, false),
			   states->fitted, workers_);
	improved_ = std::move(states);
	return *improved_;
}

} // namespace gpr::bench
