// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kept_input.h"

#include <vcg_extras/core/input/sew_seams.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace gpr {

namespace {

/// Large arrays are copied by all threads: memory that is written to for the first time costs more
/// than the copy.
template <class T>
Buffer<T> copyOf(const Buffer<T>& from, Workers& workers)
{
	Buffer<T> to(from.size());
	workers.forRange(from.size(), [&](std::size_t begin, std::size_t end) {
		std::memcpy(static_cast<void*>(to.data() + begin), from.data() + begin,
					(end - begin) * sizeof(T));
	});
	return to;
}

IndexedMesh copyOf(const IndexedMesh& from, Workers& workers)
{
	IndexedMesh to;
	to.frame      = from.frame;
	to.vertexNum  = from.vertexNum;
	to.faceNum    = from.faceNum;
	to.position   = copyOf(from.position, workers);
	to.triangle   = copyOf(from.triangle, workers);
	to.sourceFace = copyOf(from.sourceFace, workers);
	to.size       = copyOf(from.size, workers);
	return to;
}

Surface copyOf(const Surface& from, Workers& workers)
{
	Surface to;
	to.mesh.vertexNum = from.mesh.vertexNum;
	to.mesh.faceNum   = from.mesh.faceNum;
	to.mesh.position  = copyOf(from.mesh.position, workers);
	to.mesh.origin    = copyOf(from.mesh.origin, workers);
	to.mesh.opposite  = copyOf(from.mesh.opposite, workers);
	to.mesh.outgoing  = copyOf(from.mesh.outgoing, workers);
	to.mesh.crease    = copyOf(from.mesh.crease, workers);
	to.sourceFace     = copyOf(from.sourceFace, workers);
	to.normal         = copyOf(from.normal, workers);
	to.size           = copyOf(from.size, workers);
	to.frame          = from.frame;
	to.grid           = from.grid;
	return to;
}

CleanedInput clean(RunContext& run, Sewing sewing)
{
	run.report.cleaned = CleanCounts(); // an earlier attempt may have counted
	CleanedInput cleaned;
	cleaned.mesh    = loadCleaned(run, sewing);
	cleaned.extents = measureFaces(cleaned.mesh, run.workers);
	cleaned.counts  = run.report.cleaned;
	return cleaned;
}

void connectForKeeping(RunContext& run, Sewing sewing, KeptInput::OfSewing& kept)
{
	IndexedMesh    mesh = copyOf(kept.cleaned->mesh, run.workers);
	ConnectedInput connected;
	connected.surface.frame = mesh.frame;
	connected.mustSewFirst  = !connectCleaned(run, sewing, mesh, connected.surface);
	connected.counts        = run.report.cleaned;
	if (connected.mustSewFirst) connected.surface = Surface();
	kept.connected = std::move(connected);
}

bool areSame(const FeatureThresholds& a, const FeatureThresholds& b)
{
	return a.support == b.support && a.strongDeg == b.strongDeg && a.weakDeg == b.weakDeg &&
		   a.minLength == b.minLength;
}

/// What was added behind the first `before` of them.
std::vector<std::string> addedTo(const std::vector<std::string>& all, std::size_t before)
{
	return std::vector<std::string>(all.begin() + std::ptrdiff_t(before), all.end());
}

void tellAgain(RunContext& run, const KeptFeatures& features)
{
	run.notes.insert(run.notes.end(), features.notes.begin(), features.notes.end());
	for (const std::string& cap : features.caps)
		run.tellCap(cap.c_str());
}

} // namespace

void KeptInput::fitTo(const RemeshOptions& options)
{
	if (sew == options.sew && dropComponentsBelow == options.dropComponentsBelow) return;
	*this               = KeptInput();
	sew                 = options.sew;
	dropComponentsBelow = options.dropComponentsBelow;
}

InputOfRun::InputOfRun(RunContext& run, Sewing sewing) :
		run_(run), sewing_(sewingFor(run.options, sewing))
{
	if (run_.kept == nullptr) {
		own_ = clean(run_, sewing_);
		return;
	}
	run_.kept->fitTo(run_.options);
	if (!kept().cleaned) kept().cleaned = clean(run_, sewing_);
	cleaned_            = &*kept().cleaned;
	run_.report.cleaned = cleaned_->counts;
}

IndexedMesh InputOfRun::takeMesh()
{
	return run_.kept == nullptr ? std::move(own_.mesh) : copyOf(cleaned_->mesh, run_.workers);
}

bool InputOfRun::takeSurface(Surface& surface)
{
	if (run_.kept == nullptr) return connectCleaned(run_, sewing_, own_.mesh, surface);
	if (!kept().connected) connectForKeeping(run_, sewing_, kept());
	const ConnectedInput& connected = *kept().connected;
	if (connected.mustSewFirst) return false;
	run_.report.cleaned = connected.counts;
	surface             = copyOf(connected.surface, run_.workers);
	return true;
}

bool connectCleaned(RunContext& run, Sewing sewing, IndexedMesh& mesh, Surface& surface)
{
	connectOrRepair(run, mesh, surface);
	if (sewing == Sewing::NotYet && mayHaveSeams(surface, run.workers)) return false;
	dropFlatPieces(run, surface);
	return true;
}

FeatureMarks regionOfRun(RunContext& run)
{
	if (run.kept == nullptr || run.options.featureRegion != FeatureRegion::Detected)
		return detectRegion(run);
	run.kept->fitTo(run.options);
	std::optional<KeptFeatures>& kept = run.kept->features;
	if (!kept || !areSame(kept->thresholds, run.options.featureThresholds)) {
		const std::size_t notesBefore = run.notes.size();
		const std::size_t capsBefore  = run.report.capsReached.size();
		KeptFeatures      found;
		found.thresholds = run.options.featureThresholds;
		found.marks      = detectRegion(run);
		found.notes      = addedTo(run.notes, notesBefore);
		found.caps       = addedTo(run.report.capsReached, capsBefore);
		kept             = std::move(found);
	}
	else {
		tellAgain(run, *kept);
	}
	return kept->marks;
}

void keepInput(RunContext& run)
{
	regionOfRun(run);
	Surface    surface;
	InputOfRun input(run, Sewing::NotYet);
	if (!input.takeSurface(surface)) InputOfRun(run, Sewing::First).takeSurface(surface);
}

} // namespace gpr
