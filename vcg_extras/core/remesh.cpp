// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/run/error_goal_run.h>
#include <vcg_extras/core/run/partial_runs.h>
#include <vcg_extras/core/run/remesh_run.h>
#include <vcg_extras/core/run/selected_part.h>

#include <algorithm>
#include <chrono>
#include <new>
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
};

/// Runs a pipeline: body(run, result) with threads, a clock and a seed.
template <class Result, class Body>
Result runPipeline(const Call& call, Pipeline pipeline, const Body& body)
{
	using Clock      = std::chrono::steady_clock;
	const auto start = Clock::now();
	return guarded<Result>([&](Result& result) {
		requireValid(call.options);
		{
			const RemeshOptions options = resolved(call.input, pipeline, call.options);
			Workers             workers(options.threads, call.progress, options.timeLimitSeconds);
			result.report.seed    = options.seed;
			result.report.adapt   = options.adapt;
			result.report.threads = workers.threadNum();
			if (pipeline != Pipeline::Detection) result.notes = optionsWithoutEffect(call.options);
			RunContext run{call.input,   options,
						   workers,      result.report,
						   result.notes, StageClock(workers, result.report, pipeline)};
			body(run, result);
		}
		result.status               = Status::Ok;
		result.report.remeshSeconds = std::chrono::duration<double>(Clock::now() - start).count();
	});
}

RemeshResult remeshWhole(const Call& call)
{
	return runPipeline<RemeshResult>(call, Pipeline::Remeshing,
									 [&](RunContext& run, RemeshResult& result) {
										 if (call.options.targetMode == TargetMode::MaxError)
											 result = remeshForError(run);
										 else
											 remeshInput(run, LargestDistance::IsOneOfMany, result);
									 });
}

} // namespace

RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress)
{
	if (!options.selectedOnly) return remeshWhole({input, options, progress});
	return guarded<RemeshResult>([&](RemeshResult& result) {
		const auto remeshPart = [&](const MeshView& part, const RemeshOptions& o) {
			return remeshWhole({part, o, progress});
		};
		result = remeshSelected(input, options, remeshPart);
	});
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
