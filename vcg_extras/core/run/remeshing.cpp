// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing.h"

#include "error_stages.h"
#include "plan.h"
#include "products.h"
#include "result_stages.h"
#include "sample_stages.h"
#include "surface_stages.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/sampling/target.h>
#include <vcg_extras/core/surface/barycentric_point.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <utility>

namespace gpr {

namespace {

void requireValid(const RemeshOptions& options)
{
	const std::vector<std::string> complaints = validate(options);
	if (!complaints.empty()) throw Failure(Status::BadOptions, complaints.front());
}

/// The options in force.
RemeshOptions resolved(const MeshView& input, Pipeline pipeline, RemeshOptions options)
{
	requireValid(options);
	resolveFeatureRegion(input.anySelected(), options);
	if (options.seed == 0) options.seed = std::max(1u, std::uint32_t(std::random_device()()));
	options.adapt = resolveAdapt(options, pipeline == Pipeline::Remeshing);
	return options;
}

/// What every pipeline has: options in force, threads, and what they tell.
struct Setup {
	const RemeshOptions options;
	Workers             workers;
	RunContext          run;

	Setup(const Call& call, Pipeline pipeline) :
			options(resolved(call.input, pipeline, call.options)),
			workers(options.threads, call.progress, options.timeLimitSeconds, call.stop),
			run{call.input, options, workers, StageClock(workers, pipeline), {}, {}}
	{
		if (pipeline != Pipeline::Detection) run.notes = optionsWithoutEffect(call.options);
	}
};

/// Whatever a run has to tell, in its report and its notes.
struct Told {
	RemeshReport             report;
	std::vector<std::string> notes;

	template <class Result>
	void handOver(Result& out)
	{
		out.report = std::move(report);
		out.notes  = std::move(notes);
	}
};

Told tellOf(RunContext& run, const Products& made, const Decisions& decisions)
{
	return {reportOf(run, made, decisions), run.notes};
}

/// Hands over what a run tells at the end of a scope, whether there is a result or not.
template <class Run, class Result>
struct TellAtEnd {
	Run&    run;
	Result& out;

	~TellAtEnd() { run.told().handOver(out); }
};
template <class Run, class Result>
TellAtEnd(Run&, Result&) -> TellAtEnd<Run, Result>;

double secondsOf(const std::vector<StageTime>& stages)
{
	double sum = 0;
	for (const StageTime& s : stages)
		sum += s.seconds;
	return sum;
}

/// One run through the steps of a plan.
class Remeshing {
public:
	Remeshing(const Call& call, Pipeline pipeline, const Request& request) :
			setup_(call, pipeline), firstNotes_(setup_.run.notes),
			cache_(call.cache), request_{setup_.options,  std::int64_t(call.input.vertexNum),
										 request.purpose, request.sampleNum,
										 request.goal,    request.diagonal},
			plan_(request_)
	{
		if (cache_ == nullptr && request.goal) cache_ = &ownCache_;
	}

	const std::vector<Vec3d>* given   = nullptr; ///< samples in the place of our own
	SamplingResult*           samples = nullptr; ///< where samples go that are wanted alone

	/// The run on one screen. Where a fact makes the plan go back, what later steps made is
	/// dropped.
	void run()
	{
		RunContext&      run = setup_.run;
		const Decisions& d   = plan_.decisions();
		while (plan_.next() != Step::Done) {
			const Step step = plan_.next();
			if (plan_.beginsRun()) beginRun();
			try {
				// clang-format off
				switch (step) {
				case Step::Region:       findRegion(run, cache_, made_); plan_.goOn(); break;
				case Step::Input:        judge(makeInput(run, d, cache_, made_)); break;
				case Step::Surface:      judge(makeSurface(run, d, cache_, made_)); break;
				case Step::Sizes:        judge(makeSizes(run, d, spots_, made_)); break;
				case Step::Forecast:     judge(forecastCount(run, d, plan_.goal(), made_)); break;
				case Step::Lines:        judge(findLines(run, d, made_)); break;
				case Step::GivenLines:   followGivenLines(run, d, made_); plan_.goOn(); break;
				case Step::Samples:      judge(placeSamples(run, d, made_)); break;
				case Step::GivenSamples: takeGivenSamples(run, d, *given, made_); plan_.goOn(); break;
				case Step::Triangles:    connectSamples(run, d, made_); plan_.goOn(); break;
				case Step::Count:        reachCount(run, d, made_); plan_.goOn(); break;
				case Step::Relaxation:   judge(relaxTriangles(run, made_)); break;
				case Step::Fit:          judge(fitResult(run, d, made_)); break;
				case Step::Release:      releaseLinesAndFit(run, d, made_); plan_.goOn(); break;
				case Step::Contacts:     judge(removeContacts(run, d, made_)); break;
				case Step::Refinement:   judge(refineResult(run, plan_.goal(), made_)); break;
				case Step::Error:        judge(measureError(run, plan_.goal(), spots_, made_)); break;
				case Step::Check:        checkResult(run, d, made_); plan_.goOn(); break;
				case Step::Export:       exportAll(); break;
				case Step::Done:         break;
				}
				// clang-format on
			}
			catch (const Failure& failure) {
				fail(failure);
			}
			if (plan_.next() <= step && !plan_.beginsRun()) made_.dropFrom(plan_.next());
		}
		if (request_.goal) endTrials();
	}

	RemeshResult takeResult() { return std::move(best_); }
	Told         told()
	{
		if (refused_) return *refused_;
		return plan_.next() == Step::Done ? bestTold_ : tellOf(plan_.decisions());
	}

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

	/// With a goal: tells what its trials came to. Throws Failure where none met it.
	void endTrials()
	{
		const std::string outcome = plan_.outcomeForError();
		RemeshReport&     report  = bestTold_.report;
		report.stages.push_back({"otherTrials", trialSeconds_ - secondsOf(report.stages)});
		report.errorGoal     = plan_.goal().largest;
		report.errorTrialNum = plan_.trialNum();
		bestTold_.notes.push_back(outcome);
	}

	template <class Facts>
	void judge(const Facts& facts)
	{
		setup_.run.tell(plan_.judge(facts));
	}

	void judge(const ContactFacts& facts)
	{
		setup_.run.tell(plan_.judge(facts));
		if (facts.hasMade) tellMadeVertices(setup_.run, made_);
	}

	void beginRun()
	{
		made_            = Products();
		setup_.run.notes = firstNotes_;
		setup_.run.capsReached.clear();
		setup_.run.clock.restart(plan_.share());
	}

	/// A later run only looks for a count that can be had: what is told is of the one that failed.
	void fail(const Failure& failure)
	{
		if (plan_.decisions().purpose == Purpose::Answer) refused_ = tellOf(plan_.decisions());
		plan_.judge(failure);
	}

	Told tellOf(const Decisions& decisions) { return gpr::tellOf(setup_.run, made_, decisions); }

	void exportAll()
	{
		RemeshResult result;
		ExportFacts  facts;
		if (samples != nullptr)
			exportSamples();
		else
			facts = exportMesh(setup_.run, made_, result);
		if (given != nullptr) nameSamples(*given, made_.samples.isMoved, made_.result, result);
		Told told = tellOf(plan_.decisions());
		if (given != nullptr) told.report.targetVertexNum = facts.vertexNum;
		trialSeconds_ += secondsOf(told.report.stages);
		plan_.judge(facts);
		if (!plan_.isBest()) return;
		best_     = std::move(result);
		bestTold_ = std::move(told);
	}

	void exportSamples()
	{
		setup_.run.clock.enter(Stage::Export);
		const Surface& surface = made_.surface;
		const double   radius  = double(made_.samples.radius) / surface.frame.scale;
		for (const Sample& s : made_.samples.sampling.samples) {
			samples->points.push_back(surface.frame.toCaller(s.point.position));
			samples->surfacePoints.push_back(barycentricPoint(setup_.run.input, surface, s.point));
			samples->radii.push_back(radius * double(s.size));
		}
		samples->diskRadius = radius;
	}
};

} // namespace

void remeshInput(const Call& call, RemeshResult& out)
{
	Request request{call.options, std::int64_t(call.input.vertexNum)};
	if (call.options.targetMode == TargetMode::MaxError) {
		const MeshExtent extent = extentOf(call.input);
		request.purpose         = Purpose::Forecast;
		request.goal            = errorGoalOf(call.input, call.options, extent);
		request.diagonal        = extent.diagonal;
	}
	Remeshing       remeshing(call, Pipeline::Remeshing, request);
	const TellAtEnd teller{remeshing, out};
	remeshing.run();
	out = remeshing.takeResult();
}

void sampleInput(const Call& call, SamplingResult& out)
{
	Remeshing remeshing(call, Pipeline::Sampling, {call.options, 0, Purpose::SamplesOnly});
	remeshing.samples = &out;
	const TellAtEnd teller{remeshing, out};
	remeshing.run();
}

void meshGivenSamples(const Call& call, const std::vector<Vec3d>& points, RemeshResult& out)
{
	const std::int64_t num = std::int64_t(points.size());
	Remeshing          remeshing(call, Pipeline::Retriangulation,
								 {call.options, 0, Purpose::OfGivenSamples, num});
	remeshing.given = &points;
	const TellAtEnd teller{remeshing, out};
	if (points.empty()) throw Failure(Status::BadOptions, "There are no samples.");
	remeshing.run();
	out = remeshing.takeResult();
}

namespace {

/// A pipeline without a plan: its context and what it makes.
struct PlainRun {
	Setup    setup;
	Products made;

	PlainRun(const Call& call, Pipeline pipeline) : setup(call, pipeline) {}
	Told told() { return tellOf(setup.run, made, Decisions()); }
};

} // namespace

void detectOnly(const Call& call, FeatureResult& out)
{
	PlainRun           plain(call, Pipeline::Detection);
	const TellAtEnd    teller{plain, out};
	RunContext&        run   = plain.setup.run;
	Products&          made  = plain.made;
	const FeatureEdges found = detectOnInput(run, made.surface);
	countInput(run, made.surface);
	run.clock.enter(Stage::Export);
	exportFeatures(call.input, made.surface, found, out);
}

void prepareInput(const Call& call, RemeshResult& out)
{
	// It does about a fifth of the stages of a run, and nothing after.
	const bool      detects = call.options.featureRegion == FeatureRegion::Detected;
	PlainRun        plain(call, Pipeline::Remeshing);
	const TellAtEnd teller{plain, out};
	plain.setup.run.clock.restart({0, detects ? 1.0 : 5.0});
	fillCache(plain.setup.run, *call.cache, plain.made);
}

} // namespace gpr
