// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison.h"

#include "refusal.h"

#include <vcg_extras/complex/baselines/quadric_collapse.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <chrono>

namespace gpr_filter {

namespace {

/// Shares of the progress bar.
constexpr double kRemeshed = 0.4, kCollapsed = 0.7;

class Clock {
public:
	double seconds() const
	{
		const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - _start;
		return passed.count();
	}

private:
	std::chrono::steady_clock::time_point _start = std::chrono::steady_clock::now();
};

/// Time and progress of the whole.
class Watch {
public:
	Watch(double limitSeconds, const gpr::ProgressCallback& progress) :
			_limit(limitSeconds), _progress(progress)
	{
	}

	/// Progress of a part of the work, between two shares of the bar.
	gpr::ProgressCallback part(double from, double to) const
	{
		if (_progress == nullptr) return nullptr;
		return [this, from, to](double share, const char* phrase) {
			return _progress(from + (to - from) * share, phrase);
		};
	}
	/// For the engine; 0 means no limit. Throws Refusal if no time is left.
	double secondsLeft() const
	{
		if (_limit > 0 && _clock.seconds() >= _limit) refuse();
		return _limit > 0 ? _limit - _clock.seconds() : 0;
	}
	/// Asked while vcglib works.
	bool shallStop(double share, const char* phrase) const
	{
		if (_limit > 0 && _clock.seconds() >= _limit) return true;
		return _progress != nullptr && !_progress(share, phrase);
	}
	[[noreturn]] void refuse() const
	{
		const bool late = _limit > 0 && _clock.seconds() >= _limit;
		throw Refusal(late ? "Not done within the time limit." : "Cancelled.");
	}

private:
	Clock                        _clock;
	double                       _limit;
	const gpr::ProgressCallback& _progress;
};

void remesh(const gpr::MeshView& input, const gpr::RemeshOptions& options, const Watch& watch,
			Comparison& comparison)
{
	gpr::RemeshResult result = gpr::remesh(input, options, watch.part(0, kRemeshed));
	if (result.status != gpr::Status::Ok) throw Refusal(result.message);
	comparison.remeshed.mesh    = std::move(result.mesh);
	comparison.remeshed.seconds = result.report.remeshSeconds;
	comparison.report           = std::move(result.report);
	comparison.notes            = std::move(result.notes);
}

[[noreturn]] void refuseCount(std::size_t reached, std::size_t wanted)
{
	throw Refusal(
		"Quadric Edge Collapse ended at " + std::to_string(reached) +
		" faces and cannot reach the " + std::to_string(wanted) +
		" faces of the other result, so a comparison is not possible. Quadric Edge Collapse "
		"only removes faces: ask for another number of vertices.");
}

/// A step of Quadric Edge Collapse removes a face or two, and the clean-up some more.
bool reaches(std::size_t reached, std::size_t wanted)
{
	const std::size_t slack = std::max<std::size_t>(2, wanted / 100);
	return reached <= wanted + slack && reached + slack >= wanted;
}

void collapse(const gpr::MeshView& input, const Watch& watch, Comparison& comparison)
{
	const std::size_t               wanted = comparison.remeshed.mesh.faceNum();
	gpr::baselines::QuadricCollapse work(input);
	const Clock                     clock;
	const bool                      done = work.run(std::int64_t(wanted),
													[&] { return watch.shallStop(kRemeshed, "Quadric Edge Collapse"); });
	if (!done) watch.refuse();
	comparison.collapsed.seconds = clock.seconds();
	comparison.collapsed.mesh    = work.mesh();
	const std::size_t reached    = comparison.collapsed.mesh.faceNum();
	if (!reaches(reached, wanted)) refuseCount(reached, wanted);
}

MeasuredMesh measure(const gpr::MeshView& mesh, gpr::Workers& workers)
{
	workers.poll();
	return {gpr::measureMesh(mesh), gpr::measureQuality(mesh, workers)};
}

void measureResult(const gpr::MeshView& input, const gpr::MeasuredSurface& target, double diagonal,
				   ComparedResult& result, gpr::Workers& workers)
{
	const gpr::MeshView mesh = result.mesh.view();
	result.measured          = measure(mesh, workers);
	result.shape             = gpr::radiusRatios(mesh, workers);
	result.deviation         = target.ofFaces(mesh, workers);
	const gpr::ComparedDistance distance =
		gpr::compareSurfaces(input, target, mesh, diagonal, workers);
	result.toInput   = distance.toInput;
	result.fromInput = distance.fromInput;
	result.proven    = distance.proven.hausdorff();
}

void measureAll(const gpr::MeshView& input, int threads, const Watch& watch, Comparison& comparison)
try {
	gpr::Workers workers(threads, watch.part(kCollapsed, 1), watch.secondsLeft());
	workers.enterStage("Measuring", 0, 0.4);
	comparison.input = measure(input, workers);
	const gpr::MeasuredSurface target(input, workers);
	const double               diagonal = comparison.input.figures.diagonal;
	workers.enterStage("Measuring", 0.4, 0.7);
	measureResult(input, target, diagonal, comparison.remeshed, workers);
	workers.enterStage("Measuring", 0.7, 1);
	measureResult(input, target, diagonal, comparison.collapsed, workers);
}
catch (const gpr::CancelledError&) {
	watch.refuse();
}
catch (const gpr::OutOfTimeError&) {
	watch.refuse();
}

} // namespace

Comparison compareWithQuadricCollapse(const gpr::MeshView& input, const gpr::RemeshOptions& options,
									  const gpr::ProgressCallback& progress)
{
	const Watch watch(options.timeLimitSeconds, progress);
	Comparison  comparison;
	remesh(input, options, watch, comparison);
	collapse(input, watch, comparison);
	measureAll(input, options.threads, watch, comparison);
	return comparison;
}

} // namespace gpr_filter
