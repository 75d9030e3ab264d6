// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cleaning.h"

#include "contract_edges.h"
#include "flat_pieces.h"
#include "repair_manifold.h"
#include "sew_seams.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/mesh/components.h>
#include <vcg_extras/core/mesh/spatial_order.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace gpr {

namespace {

void dropFaces(RunContext& run, const std::vector<int>& faces, std::int64_t& droppedNum,
			   CleanCounts& counts, Surface& surface)
{
	const bool  keepsRings = !surface.ring.empty();
	IndexedMesh mesh       = withoutFaces(surface, faces, run.workers, droppedNum);
	connectOrRepair(run, mesh, keepsRings, counts, surface);
}

void dropSmallComponents(RunContext& run, CleanCounts& counts, Surface& surface)
{
	const Components          found = findComponents(surface.mesh, run.workers);
	std::vector<std::int64_t> faceNum(std::size_t(found.num), 0);
	Poller                    poller(run.workers);
	for (int component : found.ofFace) {
		poller.count();
		++faceNum[component];
	}
	const std::int64_t least    = run.options.dropComponentsBelow;
	const auto         isSmall  = [&](std::int64_t num) { return num < least; };
	const auto         smallNum = std::count_if(faceNum.begin(), faceNum.end(), isSmall);
	if (smallNum == 0) return;
	if (smallNum == found.num) {
		throw Failure(Status::UnusableInput,
					  "Nothing would be left: every component has fewer than " +
						  std::to_string(least) + " faces.");
	}
	counts.droppedComponents     = smallNum;
	const std::vector<int> faces = run.workers.collectIf(
		found.ofFace.size(), [&](int f) { return isSmall(faceNum[found.ofFace[f]]); });
	dropFaces(run, faces, counts.droppedFaces, counts, surface);
}

/// Drops useless pieces of the mesh. A detour: takes a second ordering and connecting.
IndexedMesh withoutUselessPieces(RunContext& run, IndexedMesh mesh, CleanCounts& counts)
{
	Surface surface;
	connectOrRepair(run, mesh, false, counts, surface);
	dropFlatPieces(run, counts, surface);
	dropSmallComponents(run, counts, surface);
	return disconnect(surface);
}

} // namespace

Sewing sewingFor(const RemeshOptions& options, Sewing wanted)
{
	if (!options.sew || wanted == Sewing::Never) return Sewing::Never;
	// Sheets that are cut apart must not be sewn as seams.
	const bool isFirst = options.dropComponentsBelow > 1 || keepsJunctions(options);
	return isFirst ? Sewing::First : wanted;
}

void connectOrRepair(RunContext& run, IndexedMesh& mesh, bool keepsRings, CleanCounts& counts,
					 Surface& surface)
{
	Buffer<int> faceStart;
	run.clock.enter(Stage::Order);
	surface.grid = orderSpatially(mesh, run.workers, faceStart);
	run.clock.enter(Stage::Connect);
	if (connect(mesh, faceStart, run.workers, surface, keepsRings)) return;
	run.clock.enter(Stage::Repair);
	const JunctionMode junctions =
		keepsJunctions(run.options) ? JunctionMode::Keep : JunctionMode::Cut;
	const bool keepsPlaces = keepsJunctions(run.options) || keepsRegionVertices(run.options);
	repairManifold(mesh, surface.mesh.opposite, junctions, keepsPlaces, run.workers, counts);
	surface.grid = orderSpatially(mesh, run.workers, faceStart);
	if (!connect(mesh, faceStart, run.workers, surface, keepsRings)) {
		throw Failure(Status::InternalError, "The surface could not be made manifold.");
	}
}

void dropFlatPieces(RunContext& run, CleanCounts& counts, Surface& surface)
{
	// Pieces along the border of a sheet are shared with other sheets.
	if (!surface.meetings.empty()) return;
	const std::vector<int> flat = findFlatPieces(surface, run.workers);
	if (flat.empty()) return;
	if (int(flat.size()) == surface.mesh.faceNum)
		throw Failure(Status::UnusableInput, "The surface has no area.");
	dropFaces(run, flat, counts.zeroAreaFaces, counts, surface);
}

bool connectCleaned(RunContext& run, Sewing sewing, IndexedMesh& mesh, CleanCounts& counts,
					Surface& surface)
{
	const bool keepsRings = run.options.adapt > 0; // for the sizes by the error
	connectOrRepair(run, mesh, keepsRings, counts, surface);
	if (sewing == Sewing::NotYet && mayHaveSeams(surface, run.workers)) return false;
	dropFlatPieces(run, counts, surface);
	return true;
}

std::shared_ptr<CleanedInput> clean(RunContext& run, Sewing sewing, CleanCounts& counts)
{
	counts = CleanCounts(); // an earlier attempt may have counted
	run.clock.enter(Stage::Load);
	IndexedMesh mesh = loadInput(run.input, run.workers, counts);
	contractEdgesWithoutLength(mesh, run.workers, counts);
	if (sewing == Sewing::First) {
		run.clock.enter(Stage::Sew);
		sewSeams(mesh, run.workers, counts);
	}
	if (run.options.dropComponentsBelow > 1 || allFacesThin(mesh, run.workers))
		mesh = withoutUselessPieces(run, std::move(mesh), counts);
	auto cleaned     = std::make_shared<CleanedInput>();
	cleaned->extents = measureFaces(mesh, run.workers);
	cleaned->mesh    = std::move(mesh);
	cleaned->counts  = counts;
	return cleaned;
}

} // namespace gpr
