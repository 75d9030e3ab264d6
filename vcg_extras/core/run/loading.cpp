// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "loading.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/input/contract_edges.h>
#include <vcg_extras/core/input/flat_pieces.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/input/repair_manifold.h>
#include <vcg_extras/core/input/sew_seams.h>
#include <vcg_extras/core/input/small_components.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/spatial_order.h>

#include <string>
#include <utility>
#include <vector>

namespace gpr {

namespace {

void dropSmallComponents(RunContext& run, Surface& surface)
{
	const std::int64_t    least = run.options.dropComponentsBelow;
	const SmallComponents small = findSmallComponents(surface.mesh, least, run.workers);
	if (small.num == 0) return;
	if (int(small.faces.size()) == surface.mesh.faceNum) {
		throw Failure(Status::UnusableInput, "Nothing would be left: every component has fewer "
											 "than " +
												 std::to_string(least) + " faces.");
	}
	run.report.cleaned.droppedComponents = small.num;
	IndexedMesh mesh = withoutFaces(surface, small.faces, run.report.cleaned.droppedFaces);
	connectOrRepair(run, mesh, surface);
}

/// A detour, as it takes a second ordering and connecting.
IndexedMesh withoutUselessPieces(RunContext& run, IndexedMesh mesh)
{
	Surface surface;
	connectOrRepair(run, mesh, surface);
	dropFlatPieces(run, surface);
	dropSmallComponents(run, surface);
	return disconnect(surface);
}

} // namespace

Sewing sewingFor(const RemeshOptions& options, Sewing wanted)
{
	if (!options.sew || wanted == Sewing::Never) return Sewing::Never;
	return options.dropComponentsBelow > 1 ? Sewing::First : wanted;
}

IndexedMesh loadCleaned(RunContext& run, Sewing sewing)
{
	run.clock.enter(Stage::Load);
	IndexedMesh mesh = loadInput(run.input, run.workers, run.report.cleaned);
	contractEdgesWithoutLength(mesh, run.workers, run.report.cleaned);
	if (sewingFor(run.options, sewing) == Sewing::First) {
		run.clock.enter(Stage::Sew);
		sewSeams(mesh, run.workers, run.report.cleaned);
	}
	if (run.options.dropComponentsBelow <= 1 && !allFacesThin(mesh, run.workers)) return mesh;
	return withoutUselessPieces(run, std::move(mesh));
}

void connectOrRepair(RunContext& run, IndexedMesh& mesh, Surface& surface)
{
	Buffer<int> faceStart;
	run.clock.enter(Stage::Order);
	surface.grid = orderSpatially(mesh, run.workers, faceStart);
	run.clock.enter(Stage::Connect);
	if (connect(mesh, faceStart, run.workers, surface)) return;
	run.clock.enter(Stage::Repair);
	repairManifold(mesh, run.workers, run.report.cleaned);
	surface.grid = orderSpatially(mesh, run.workers, faceStart);
	if (!connect(mesh, faceStart, run.workers, surface)) {
		throw Failure(Status::InternalError, "The surface could not be made manifold.");
	}
}

void dropFlatPieces(RunContext& run, Surface& surface)
{
	const std::vector<int> flat = findFlatPieces(surface, run.workers);
	if (flat.empty()) return;
	if (int(flat.size()) == surface.mesh.faceNum)
		throw Failure(Status::UnusableInput, "The surface has no area.");
	IndexedMesh mesh = withoutFaces(surface, flat, run.report.cleaned.zeroAreaFaces);
	connectOrRepair(run, mesh, surface);
}

void describeInput(RunContext& run, const Surface& surface)
{
	run.clock.enter(Stage::InputFigures);
	run.report.cleanedInput   = figuresOf(surface.mesh, 1 / surface.frame.scale, run.workers);
	run.report.input          = run.report.cleanedInput;
	run.report.input.vertices = std::int64_t(run.input.vertexNum);
	run.report.input.faces    = std::int64_t(run.input.faceNum);
}

} // namespace gpr
