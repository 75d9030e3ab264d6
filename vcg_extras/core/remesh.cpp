// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh.h"

#include "prepared_surface.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/pages.h>
#include <vcg_extras/core/input/matched_border.h>
#include <vcg_extras/core/input/selected_part.h>
#include <vcg_extras/core/output/part_joining.h>
#include <vcg_extras/core/run/remeshing.h>
#include <vcg_extras/core/run/symmetry.h>
#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

namespace gpr {

namespace {

/// The failure of the exception being handled, by its type.
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

/// A result with only status, message, report and notes.
template <class Result>
Result failed(const Failure& failure, Outcome&& soFar)
{
	Result result;
	static_cast<Outcome&>(result) = std::move(soFar);
	result.status                 = failure.status;
	result.message                = failure.message;
	if constexpr (std::is_same_v<Result, RemeshResult>) {
		if (failure.status == Status::CountTooSmall)
			result.smallestVertexNum = failure.possible.vertexNum;
	}
	return result;
}

/// Calls body(arguments..., result) and turns exceptions into status and message.
template <class Result, class Body, class... Arguments>
Result guarded(const Body& body, const Arguments&... arguments)
{
	const auto start = StageClock::Clock::now();
	Result     result;
	try {
		body(arguments..., result);
		result.status               = Status::Ok;
		result.report.remeshSeconds = StageClock::secondsSince(start);
	}
	catch (...) {
		result = failed<Result>(failureAtHand(), std::move(result));
	}
	returnReleasedMemory(); // the caller may need memory
	return result;
}

/// The kept work of runs on selected faces.
struct KeptPart {
	SelectedPart part;
	InputCache   ofRuns;
};

/// A function that remeshes a mesh, whole or cut out.
using MeshCall = void (*)(const Call& call, RemeshResult& out);

void onSelected(const Call& call, const SelectedPart& part, InputCache* cache, MeshCall run,
				RemeshResult& out)
{
	if (call.input.wantedEdge != nullptr) {
		throw Failure(Status::BadOptions,
					  "Wanted edge lengths are for whole meshes, not for selected faces.");
	}
	const RemeshOptions inside = optionsInside(call.options);
	const MeshView      view   = part.view();
	run({view, inside, call.progress, call.stop, cache, call.start, &call.input}, out);
	if (run != prepareInput) out = joinPart(call.input, part, call.options, std::move(out));
}

void remeshSelected(const Call& call, RemeshResult& out)
{
	onSelected(call, cutOutSelected(call.input), nullptr, remeshInput, out);
}

/// The edge length of the wanted size of the result, mesh units.
double edgeLengthOf(const Call& call)
{
	const RemeshOptions& o = call.options;
	if (o.targetMode == TargetMode::EdgeLength) return o.targetEdgeLen;
	const MeshExtent extent = extentOf(call.input);
	if (o.targetMode == TargetMode::MaxError || o.targetMode == TargetMode::Detail)
		return edgePerError * largestError(o, extent.diagonal);
	const double num = wantedVertexNum(std::int64_t(call.input.vertexNum), o, extent.area, 1);
	return diskRadius(extent.area, std::max(1.0, num), 1);
}

void remeshMatched(const Call& call, RemeshResult& out)
{
	if (call.input.wantedEdge != nullptr) {
		throw Failure(
			Status::BadOptions,
			"Wanted edge lengths are not possible with matched borders, whose edges have one "
			"length.");
	}
	const double edge = edgeLengthOf(call);
	if (!(edge > 0) || !validate(call.options).empty())
		return remeshInput(call, out); // refuses the options
	Workers             workers(1, call.progress, call.options.timeLimitSeconds, call.stop);
	const MatchedBorder matched = matchBorder(call.input, edge, call.options.period, workers);
	RemeshOptions       inside  = call.optionsForMesh(matched.vertexNum());
	inside.boundary             = BoundaryMode::Keep;
	inside.period               = {};
	MeshView view               = matched.view();
	view.regionNames            = call.input.regionNames;
	remeshInput({view, inside, call.progress, call.stop, nullptr, call.start}, out);
	nameCallers(call.input, matched, out);
	out.report.input.vertices = std::int64_t(call.input.vertexNum); // not of the split mesh
	out.report.input.faces    = std::int64_t(call.input.faceNum);
}

MeshCall callFor(const RemeshOptions& options)
{
	if (options.symmetry != Symmetry::Off) return remeshSymmetric;
	if (options.selectedOnly) return remeshSelected;
	const bool isMatched = options.boundary == BoundaryMode::Match || isPeriodic(options);
	return isMatched ? remeshMatched : remeshInput;
}

} // namespace

RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress)
{
	const RemeshOptions inUnits = inMeshUnits(input, options);
	return guarded<RemeshResult>(callFor(options), Call{input, inUnits, progress});
}

struct PreparedSurface::Kept {
	MeshView                input;
	std::mutex              oneRun; ///< held during a run: runs change the kept work in turn
	InputCache              ofRuns;
	std::optional<KeptPart> selected;

	RemeshResult call(const RemeshOptions& options, const ProgressCallback& progress,
					  const StopRequest* stop, MeshCall run)
	{
		const std::lock_guard<std::mutex> lock(oneRun);
		const RemeshOptions               inUnits = inMeshUnits(input, options);
		const Call                        whole{input, inUnits, progress, stop, &ofRuns};
		if (!options.selectedOnly || options.symmetry != Symmetry::Off)
			return guarded<RemeshResult>(run == remeshInput ? callFor(options) : run, whole);
		return guarded<RemeshResult>([&](RemeshResult& result) {
			if (!selected) selected = KeptPart{cutOutSelected(input), {}};
			onSelected(whole, selected->part, &selected->ofRuns, run, result);
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
	return kept_->call(options, progress, stop, prepareInput);
}

RemeshResult PreparedSurface::remesh(const RemeshOptions& options, const ProgressCallback& progress,
									 const StopRequest* stop)
{
	return kept_->call(options, progress, stop, remeshInput);
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
	const RemeshOptions inUnits = inMeshUnits(input, options);
	return guarded<SamplingResult>(sampleInput, Call{input, inUnits, progress});
}

RemeshResult retriangulate(const MeshView& input, const std::vector<Vec3d>& samples,
						   const RemeshOptions& options, const ProgressCallback& progress)
{
	return guarded<RemeshResult>(meshGivenSamples, Call{input, options, progress}, samples);
}

FeatureResult detectFeatures(const MeshView& input, const RemeshOptions& options,
							 const ProgressCallback& progress)
{
	return guarded<FeatureResult>(detectOnly, Call{input, options, progress});
}

} // namespace gpr
