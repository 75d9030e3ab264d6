// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_REMESHING_H
#define VCG_EXTRAS_CORE_RUN_REMESHING_H

#include "input_stages.h"
#include "plan.h"
#include "products.h"
#include "reporting.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/base/stage_clock.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/progress.h>
#include <vcg_extras/core/results.h>
#include <vcg_extras/core/sampling/fine_spots.h>

#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gpr {

/// A call of the engine.
struct Call {
	const MeshView&         input;
	const RemeshOptions&    options;
	const ProgressCallback& progress;
	const StopRequest*      stop  = nullptr;
	InputCache*             cache = nullptr; ///< null: of a single run
};

/// What every pipeline has: options in force, threads, and what they tell.
struct Setup {
	const RemeshOptions options;
	Workers             workers;
	RunContext          run;

	Setup(const Call& call, Pipeline pipeline);
};

/// A pipeline without a plan: its context and what it makes.
struct PlainRun {
	Setup    setup;
	Products made;

	PlainRun(const Call& call, Pipeline pipeline) : setup(call, pipeline) {}
	Told told() { return tellOf(setup.run, made, Decisions()); }
};

/// Hands over what a run tells at the end of a scope, whether there is a result or not.
template <class Run, class Result>
struct TellAtEnd {
	Run&    run;
	Result& out;

	/// Where memory has run out, nothing is told: what ended the run must reach the caller.
	~TellAtEnd()
	{
		try {
			run.told().handOver(out);
		}
		catch (const std::bad_alloc&) {
			out.notes.clear();
		}
	}
};
template <class Run, class Result>
TellAtEnd(Run&, Result&) -> TellAtEnd<Run, Result>;

/// One run through the steps of a plan, with the products that they make.
class Remeshing {
public:
	Remeshing(const Call& call, Pipeline pipeline, const Request& request);

	const std::vector<Vec3d>* given   = nullptr; ///< samples in the place of our own
	SamplingResult*           samples = nullptr; ///< where samples go that are wanted alone

	Step next() const { return plan_.next(); }
	bool isDone() const { return next() == Step::Done; }
	/// Takes the next step. Where a fact makes the plan go back, what later steps made is dropped.
	/// Throws Failure where the run ends without a result.
	void takeStep();
	/// With a goal, at the end: tells what its trials came to. Throws Failure where none met it.
	void endTrials();

	const Products&  made() const { return made_; }
	const Decisions& decisions() const { return plan_.decisions(); }
	RemeshResult     takeResult() { return std::move(best_); }
	Told             told();

private:
	Setup                    setup_;
	std::vector<std::string> firstNotes_; ///< of the options
	InputCache*              cache_;
	InputCache               ownCache_; ///< for the trials of one call
	Request                  request_;
	Plan                     plan_;
	Products                 made_;
	FineSpots                spots_; ///< where the trials so far were beyond the error
	RemeshResult             best_;
	Told                     bestTold_;
	double                   trialSeconds_ = 0; ///< of the stages of all trials
	std::optional<Told>      refused_;          ///< of the run whose count was refused

	template <class Facts>
	void judge(const Facts& facts)
	{
		setup_.run.tell(plan_.judge(facts));
	}
	void beginRun();
	void fail(const Failure& failure);
	void exportAll();
	void exportSamples();
};

// The pipelines. Each runs through the steps of a Plan (plan.h), and throws Failure where there is
// no result; the report and the notes of `out` tell how far it came.

/// The whole way from the input to the result.
void remeshInput(const Call& call, RemeshResult& out);
/// With TargetMode::Detail: the number of vertices that its error is forecast to take.
std::int64_t forecastVertexNum(const Call& call);
/// As far as the samples.
void sampleInput(const Call& call, SamplingResult& out);
/// From given points to a mesh of them.
void meshGivenSamples(const Call& call, const std::vector<Vec3d>& points, RemeshResult& out);
/// The features alone.
void detectOnly(const Call& call, FeatureResult& out);
/// Fills the cache of the call with what runs with these options have in common.
void prepareInput(const Call& call, RemeshResult& out);

} // namespace gpr

#endif
