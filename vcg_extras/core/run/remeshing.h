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

#include <functional>
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
	InputCache*             cache = nullptr; ///< null: no other run uses the input
	/// The beginning of the whole call, for the times of stages.
	StageClock::Clock::time_point start = StageClock::Clock::now();
	/// The mesh that the input is a part of; null: the input is no part. Lengths in percent are of
	/// the whole.
	const MeshView* whole = nullptr;

	/// The options for a mesh made of the input with another number of vertices: the same wanted
	/// size, and the rest of the time.
	RemeshOptions optionsForMesh(std::size_t vertexNum) const;
};

/// The common parts of all pipelines: options in force, threads, run context and products.
struct Setup {
	const RemeshOptions options;
	Workers             workers;
	RunContext          run;
	Products            made;

	Setup(const Call& call, Pipeline pipeline);
	/// Report and notes of a pipeline without a plan.
	Outcome told() { return tellOf(run, made, Decisions()); }
};

/// Hands over report and notes of a run at the end of a scope, with or without a result.
struct TellAtEnd {
	std::function<Outcome()> told; ///< by the run
	Outcome&                 out;

	/// Without memory for the report nothing is told, so that the first failure reaches the caller.
	~TellAtEnd()
	{
		try {
			out = told();
		}
		catch (const std::bad_alloc&) {
			out.notes.clear();
		}
	}
};

/// One run through the steps of a plan, with the products of the steps.
class Remeshing {
public:
	Remeshing(const Call& call, Pipeline pipeline, const Request& request);

	const std::vector<Vec3d>* given   = nullptr; ///< samples of the user; null: the run samples
	SamplingResult*           samples = nullptr; ///< output, if only samples are wanted

	Step next() const { return plan_.next(); }
	bool isDone() const { return next() == Step::Done; }
	/// Takes the next step. If the plan goes back, the products of later steps are dropped. Throws
	/// Failure if the run ends without a result.
	void takeStep();
	/// Tells the outcome of the trials for an error bound. Throws Failure if no trial met the
	/// bound.
	void endTrials();

	const Products&  made() const { return made_; }
	const Decisions& decisions() const { return plan_.decisions(); }
	RemeshResult     takeResult() { return std::move(best_); }
	Outcome          told();

private:
	Setup                         setup_;
	std::vector<std::string>      firstNotes_; ///< about the options
	InputCache*                   cache_;
	InputCache                    ownCache_; ///< for the trials of one call
	Plan                          plan_;
	Products&                     made_ = setup_.made;
	RemeshResult                  best_;
	Outcome                       bestTold_;
	std::optional<Outcome>        refused_;    ///< told by the run with the refused count
	int                           runNum_ = 0; ///< begun
	StageClock::Clock::time_point start_;

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

// The pipelines. Each pipeline takes the steps of a Plan (plan.h) and throws Failure if there is no
// result. Report and notes of `out` are set in both cases.

/// Remeshes the input: all steps from input to result.
void remeshInput(const Call& call, RemeshResult& out);
/// Forecasts the number of vertices for the detail of TargetMode::Detail.
std::int64_t forecastVertexNum(const Call& call);
/// Places samples on the input, and makes no mesh.
void sampleInput(const Call& call, SamplingResult& out);
/// Makes a mesh of given points.
void meshGivenSamples(const Call& call, const std::vector<Vec3d>& points, RemeshResult& out);
/// Detects features only.
void detectOnly(const Call& call, FeatureResult& out);
/// Fills the cache of the call with the products that all runs with these options share.
void prepareInput(const Call& call, RemeshResult& out);

} // namespace gpr

#endif
