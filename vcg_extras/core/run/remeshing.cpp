// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing.h"

#include "result_stages.h"
#include "sample_stages.h"
#include "surface_stages.h"

#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/sampling/target.h>
#include <vcg_extras/core/surface/barycentric_point.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gpr {

namespace {

/// The options of the user with all defaults resolved.
RemeshOptions resolved(const MeshView& input, Pipeline pipeline, RemeshOptions options)
{
	const std::vector<std::string> complaints = validate(options);
	if (!complaints.empty()) throw Failure(Status::BadOptions, complaints.front());
	resolveFeatureRegion(input.anySelected(), options);
	if (options.seed == 0) options.seed = std::max(1u, std::uint32_t(std::random_device()()));
	const bool hasSizes = input.wantedEdge != nullptr;
	if (hasSizes && !options.adapt) options.adapt = 0;
	options.adapt = resolveAdapt(options, pipeline == Pipeline::Remeshing);
	if (options.targetMode == TargetMode::Sizes && !hasSizes && !(options.maxEdge > 0)) {
		throw Failure(Status::BadOptions,
					  "The size of the triangles is missing: give a number, a length, wanted edge "
					  "lengths of the vertices, or the largest edge.");
	}
	return options;
}

/// A sampling is not corrected: borders, lines and small components need samples of their own.
void tellSampleNum(RunContext& run, std::int64_t wanted, std::size_t num)
{
	if (wanted == 0 || std::abs(double(num) / double(wanted) - 1) <= 0.1) return;
	run.tell("The sampling has " + std::to_string(num) + " points instead of " +
			 std::to_string(wanted) + ".");
}

/// The error bound of the options, and the vertex counts allowed in trials.
ErrorGoal errorGoalOf(const MeshView& input, const RemeshOptions& options, const MeshExtent& extent)
{
	ErrorGoal goal;
	goal.largest = largestError(options, extent.diagonal);
	goal.most    = std::min<std::int64_t>(200000000, 10000 + 10 * std::int64_t(input.vertexNum));
	const double edge = edgePerError * goal.largest;
	const double n    = edge > 0 ? vertexNumForEdgeLength(extent.area, edge) : 1;
	goal.start        = std::int64_t(std::min(double(goal.most), std::max(4.0, n)));
	return goal;
}

Request requestOf(const Call& call)
{
	Request          request;
	const TargetMode mode = call.options.targetMode;
	if (mode == TargetMode::MaxError || mode == TargetMode::Detail) {
		MeshExtent extent = extentOf(call.input);
		if (call.whole != nullptr) extent.diagonal = extentOf(*call.whole).diagonal;
		request.purpose  = Purpose::Forecast;
		request.goal     = errorGoalOf(call.input, call.options, extent);
		request.diagonal = extent.diagonal;
	}
	return request;
}

} // namespace

RemeshOptions Call::optionsForMesh(std::size_t vertexNum) const
{
	RemeshOptions inside = options;
	if (inside.timeLimitSeconds > 0) {
		inside.timeLimitSeconds =
			std::max(1e-3, inside.timeLimitSeconds - StageClock::secondsSince(start));
	}
	if (inside.targetMode == TargetMode::Percent)
		inside.targetPercent *= double(input.vertexNum) / double(vertexNum);
	return inside;
}

Setup::Setup(const Call& call, Pipeline pipeline) :
		options(resolved(call.input, pipeline, call.options)),
		workers(options.threads, call.progress, options.timeLimitSeconds, call.stop),
		run{call.input, options, workers, StageClock(workers, pipeline, {}, call.start), {}, {}}
{
	if (pipeline != Pipeline::Detection) run.notes = optionsWithoutEffect(call.options);
}

Remeshing::Remeshing(const Call& call, Pipeline pipeline, const Request& request) :
		setup_(call, pipeline), firstNotes_(setup_.run.notes), cache_(call.cache),
		plan_(setup_.options, std::int64_t(call.input.vertexNum), request), start_(call.start)
{
	if (cache_ == nullptr && request.goal) cache_ = &ownCache_;
	if (cache_ != nullptr) cache_->fitTo(setup_.options);
}

void Remeshing::takeStep()
{
	const Step       step = plan_.next();
	RunContext&      run  = setup_.run;
	const Decisions& d    = plan_.decisions();
	if (plan_.beginsRun()) beginRun();
	try {
		// clang-format off
		switch (step) {
		case Step::Region:       findRegion(run, cache_, made_); plan_.goOn(); break;
		case Step::Input:        judge(makeInput(run, d, cache_, made_)); break;
		case Step::Surface:      judge(makeSurface(run, d, cache_, made_)); break;
		case Step::Sizes:        judge(makeSizes(run, d, made_)); break;
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
		case Step::Angles:       repairAngles(run, made_); plan_.goOn(); break;
		case Step::Contacts:     judge(removeContacts(run, d, made_)); break;
		case Step::Refinement:   judge(refineResult(run, plan_.goal(), made_)); break;
		case Step::Error:        judge(measureError(run, plan_.goal(), made_)); break;
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

Outcome Remeshing::told()
{
	if (refused_) return *refused_;
	Outcome told = isDone() ? bestTold_ : tellOf(setup_.run, made_, plan_.decisions());
	if (runNum_ > 1) addOtherRuns(start_, told);
	return told;
}

void Remeshing::endTrials()
{
	bestTold_.notes.push_back(plan_.outcomeForError());
	bestTold_.report.errorGoal     = plan_.goal().largest;
	bestTold_.report.errorTrialNum = plan_.trialNum();
}

void Remeshing::beginRun()
{
	++runNum_;
	made_            = Products();
	setup_.run.notes = firstNotes_;
	setup_.run.capsReached.clear();
	setup_.run.clock.restart(plan_.share());
}

/// Report and notes come from the run that was refused first; later runs only search a possible
/// count.
void Remeshing::fail(const Failure& failure)
{
	if (plan_.decisions().purpose == Purpose::Answer)
		refused_ = tellOf(setup_.run, made_, plan_.decisions());
	plan_.judge(failure);
}

void Remeshing::exportAll()
{
	RemeshResult result;
	ExportFacts  facts;
	if (samples != nullptr)
		exportSamples();
	else
		facts = exportMesh(setup_.run, made_, result);
	if (given != nullptr) nameSamples(*given, made_.samples.given.isMoved, made_.result, result);
	Outcome told = tellOf(setup_.run, made_, plan_.decisions());
	if (given != nullptr) told.report.targetVertexNum = facts.vertexNum;
	plan_.judge(facts);
	if (!plan_.isBest()) return;
	best_     = std::move(result);
	bestTold_ = std::move(told);
}

void Remeshing::exportSamples()
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
	tellSampleNum(setup_.run, plan_.decisions().vertexNum, samples->points.size());
}

std::int64_t forecastVertexNum(const Call& call)
{
	Remeshing remeshing(call, Pipeline::Remeshing, requestOf(call));
	while (remeshing.decisions().purpose == Purpose::Forecast)
		remeshing.takeStep();
	return remeshing.decisions().vertexNum;
}

void remeshInput(const Call& call, RemeshResult& out)
{
	if (call.input.wantedEdge != nullptr && isPaper(call.options))
		throw Failure(Status::BadOptions,
					  "Wanted edge lengths are not possible with the preset paper.");
	Remeshing       remeshing(call, Pipeline::Remeshing, requestOf(call));
	const TellAtEnd teller{[&] { return remeshing.told(); }, out};
	while (!remeshing.isDone())
		remeshing.takeStep();
	if (call.options.targetMode == TargetMode::MaxError) remeshing.endTrials();
	out = remeshing.takeResult();
}

void sampleInput(const Call& call, SamplingResult& out)
{
	Remeshing remeshing(call, Pipeline::Sampling, {Purpose::SamplesOnly});
	remeshing.samples = &out;
	const TellAtEnd teller{[&] { return remeshing.told(); }, out};
	while (!remeshing.isDone())
		remeshing.takeStep();
}

void meshGivenSamples(const Call& call, const std::vector<Vec3d>& points, RemeshResult& out)
{
	const std::int64_t num = std::int64_t(points.size());
	Remeshing          remeshing(call, Pipeline::Retriangulation, {Purpose::OfGivenSamples, num});
	remeshing.given = &points;
	const TellAtEnd teller{[&] { return remeshing.told(); }, out};
	if (points.empty()) throw Failure(Status::BadOptions, "There are no samples.");
	while (!remeshing.isDone())
		remeshing.takeStep();
	out = remeshing.takeResult();
}

void detectOnly(const Call& call, FeatureResult& out)
{
	Setup              plain(call, Pipeline::Detection);
	const TellAtEnd    teller{[&] { return plain.told(); }, out};
	WorkingSurface&    surface = plain.made.surface;
	const FeatureEdges found   = detectOnInput(plain.run, surface);
	countInput(plain.run, surface);
	plain.run.clock.enter(Stage::Export);
	exportFeatures(call.input, surface, found, out);
}

void prepareInput(const Call& call, RemeshResult& out)
{
	// Without detection, the cached stages take about a fifth of the work of a run.
	const bool      detects = call.options.featureRegion == FeatureRegion::Detected;
	Setup           plain(call, Pipeline::Remeshing);
	const TellAtEnd teller{[&] { return plain.told(); }, out};
	plain.run.clock.restart({0, detects ? 1.0 : 5.0});
	fillCache(plain.run, *call.cache, plain.made);
}

} // namespace gpr
