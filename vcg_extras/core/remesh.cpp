// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh.h"

#include "prepared_surface.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/pages.h>
#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/input/selected_part.h>
#include <vcg_extras/core/output/part_joining.h>
#include <vcg_extras/core/run/error_goal_run.h>
#include <vcg_extras/core/run/kept_input.h>
#include <vcg_extras/core/run/partial_runs.h>
#include <vcg_extras/core/run/remesh_run.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <new>
#include <optional>
#include <random>
#include <utility>

namespace gpr {

namespace {

/// Of the exception being handled, if it is a std::exception or one of ours.
Failure failureAtHand()
{
	try {
		throw;
	}
	catch (const Failure& failure) {
		return failure;
	}
	catch (const CancelledError&) {
		return {Status::Cancelled, "Cancelled."};
	}
	catch (const OutOfTimeError&) {
		return {Status::OutOfTime, "Not done within the time limit."};
	}
	catch (const std::bad_alloc&) {
		return {Status::OutOfMemory, "There is not enough memory."};
	}
	catch (const std::exception& e) {
		return {Status::InternalError, std::string("Internal error: ") + e.what()};
	}
}

void nameSmallest(const Failure& failure, RemeshResult& result)
{
	result.smallestVertexNum = failure.smallestVertexNum;
}

template <class Result>
void nameSmallest(const Failure&, Result&)
{
}

/// A result without anything but the reason, the report and the notes.
template <class Result>
Result failed(const Failure& failure, Result&& soFar)
{
	Result result;
	result.status  = failure.status;
	result.message = failure.message;
	result.report  = std::move(soFar.report);
	result.notes   = std::move(soFar.notes);
	nameSmallest(failure, result);
	return result;
}

/// Calls body(result) and turns what it throws into status and message.
template <class Result, class Body>
Result guarded(const Body& body)
{
	Result result;
	try {
		body(result);
		return result;
	}
	catch (...) {
		return failed(failureAtHand(), std::move(result));
	}
}

void requireValid(const RemeshOptions& options)
{
	const std::vector<std::string> complaints = validate(options);
	if (!complaints.empty()) throw Failure(Status::BadOptions, complaints.front());
}

/// The options in force.
RemeshOptions resolved(const MeshView& input, Pipeline pipeline, RemeshOptions options)
{
	resolveFeatureRegion(input.anySelected(), options);
	if (options.seed == 0) options.seed = std::max(1u, std::uint32_t(std::random_device()()));
	options.adapt = resolveAdapt(options, pipeline == Pipeline::Remeshing);
	return options;
}

/// A call of the engine.
struct Call {
	const MeshView&         input;
	const RemeshOptions&    options;
	const ProgressCallback& progress;
	const StopRequest*      stop  = nullptr;
	KeptInput*              kept  = nullptr; ///< null: of a single run
	WorkShare               whole = {};      ///< of the progress that is told
};

/// Runs a pipeline: body(run, result) with threads, a clock and a seed.
template <class Result, class Body>
Result runPipeline(const Call& call, Pipeline pipeline, const Body& body)
{
	using Clock      = std::chrono::steady_clock;
	const auto start = Clock::now();
	Result     made  = guarded<Result>([&](Result& result) {
        requireValid(call.options);
        {
            const RemeshOptions options = resolved(call.input, pipeline, call.options);
            Workers workers(options.threads, call.progress, options.timeLimitSeconds, call.stop);
            result.report.seed    = options.seed;
            result.report.adapt   = *options.adapt;
            result.report.threads = workers.threadNum();
            if (pipeline != Pipeline::Detection) result.notes = optionsWithoutEffect(call.options);
            RunContext run{call.input,   options,
                           workers,      result.report,
                           result.notes, StageClock(workers, result.report, pipeline, call.whole)};
            run.kept = call.kept;
            body(run, result);
        }
        result.status               = Status::Ok;
        result.report.remeshSeconds = std::chrono::duration<double>(Clock::now() - start).count();
    });
	returnReleasedMemory(); // the caller may need it
	return made;
}

RemeshResult remeshWhole(Call call)
{
	return runPipeline<RemeshResult>(call, Pipeline::Remeshing,
									 [&](RunContext& run, RemeshResult& result) {
										 if (call.options.targetMode == TargetMode::MaxError)
											 result = remeshForError(run);
										 else
											 remeshInput(run, LargestDistance::IsOneOfMany, result);
									 });
}

/// What a surface keeps of its selected faces.
struct KeptPart {
	SelectedPart part;
	KeptInput    ofRuns;
};

/// Preparation without a run.
RemeshResult prepareOnly(Call call)
{
	// It does about a fifth of the stages of a run, and nothing after.
	const bool detects = call.options.featureRegion == FeatureRegion::Detected;
	call.whole         = {0, detects ? 1.0 : 5.0};
	return runPipeline<RemeshResult>(call, Pipeline::Remeshing,
									 [](RunContext& run, RemeshResult&) { keepInput(run); });
}

/// What is done with a mesh, whole or cut out.
using MeshCall = RemeshResult (*)(Call call);

RemeshResult onSelected(const Call& call, const SelectedPart& part, KeptInput* kept, MeshCall run)
{
	const RemeshOptions inside = optionsInside(call.options);
	const MeshView      view   = part.view();
	RemeshResult        made   = run({view, inside, call.progress, call.stop, kept});
	if (made.status != Status::Ok || run == prepareOnly) return made;
	return joinPart(call.input, part, call.options, std::move(made));
}

} // namespace

RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress)
{
	const Call call{input, options, progress};
	if (!options.selectedOnly) return remeshWhole(call);
	return guarded<RemeshResult>([&](RemeshResult& result) {
		result = onSelected(call, cutOutSelected(input), nullptr, remeshWhole);
	});
}

struct PreparedSurface::Kept {
	MeshView                input;
	std::mutex              oneRun; ///< runs leave here what they made, one after the other
	KeptInput               ofRuns;
	std::optional<KeptPart> selected;

	RemeshResult call(const RemeshOptions& options, const ProgressCallback& progress,
					  const StopRequest* stop, MeshCall run)
	{
		const std::lock_guard<std::mutex> lock(oneRun);
		const Call                        whole{input, options, progress, stop, &ofRuns};
		if (!options.selectedOnly) return run(whole);
		return guarded<RemeshResult>([&](RemeshResult& result) {
			if (!selected) selected = KeptPart{cutOutSelected(input), {}};
			result = onSelected(whole, selected->part, &selected->ofRuns, run);
		});
	}
};

PreparedSurface::PreparedSurface(const MeshView& input) : kept_(new Kept)
{
	kept_->input = input;
}

PreparedSurface::~PreparedSurface()                                     = default;
PreparedSurface::PreparedSurface(PreparedSurface&&) noexcept            = default;
PreparedSurface& PreparedSurface::operator=(PreparedSurface&&) noexcept = default;

RemeshResult PreparedSurface::prepare(const RemeshOptions&    options,
									  const ProgressCallback& progress, const StopRequest* stop)
{
	return kept_->call(options, progress, stop, prepareOnly);
}

RemeshResult PreparedSurface::remesh(const RemeshOptions& options, const ProgressCallback& progress,
									 const StopRequest* stop)
{
	return kept_->call(options, progress, stop, remeshWhole);
}

void PreparedSurface::setInput(const MeshView& sameMesh)
{
	const std::lock_guard<std::mutex> lock(kept_->oneRun);
	kept_->input = sameMesh;
	kept_->selected.reset();
}

const MeshView& PreparedSurface::input() const
{
	return kept_->input;
}

SamplingResult samplePoissonDisks(const MeshView& input, const RemeshOptions& options,
								  const ProgressCallback& progress)
{
	return runPipeline<SamplingResult>({input, options, progress}, Pipeline::Sampling, sampleInput);
}

RemeshResult retriangulate(const MeshView& input, const std::vector<Vec3d>& samples,
						   const RemeshOptions& options, const ProgressCallback& progress)
{
	return runPipeline<RemeshResult>(
		{input, options, progress}, Pipeline::Retriangulation,
		[&](RunContext& run, RemeshResult& result) { meshGivenSamples(run, samples, result); });
}

FeatureResult detectFeatures(const MeshView& input, const RemeshOptions& options,
							 const ProgressCallback& progress)
{
	return runPipeline<FeatureResult>({input, options, progress}, Pipeline::Detection, detectOnly);
}

} // namespace gpr
