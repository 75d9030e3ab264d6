// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_filling.h"

#include "cube_decimation.h"
#include "face_sets.h"
#include "guarded_relaxation.h"

#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/surface/local_nearest.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace gpr {

namespace {

/// Rings of vertices round patches that may move too.
constexpr int ringsRelaxed = 2;
/// Weight of an edge's length in patches, against the distance from the input.
constexpr double patchLengthWeight = 0.3;
/// A collapse with a smaller move, in edges, is not tested for contacts: the rounding of
/// coordinates moves as far. Most collapses in a plane are such. Rounds::isBetter tests the whole
/// patch.
constexpr double untestedMove = 1e-5;

/// Number of vertex v in the result, or -1 inside patches.
int oldVertex(const RefilledMesh& made, int v)
{
	return made.resultVertex[made.guarded->vertex[v].anchor];
}

/// The record of vertex v: of the result if the vertex has not moved; else new, on no curve, with
/// the nearest point in a search on the surface. A fixed vertex is pinned.
ResultVertex recordOf(const Surface& surface, const ResultMesh& result, const RefilledMesh& made,
					  int v)
{
	const GuardedMesh& g    = *made.guarded;
	const int          old  = oldVertex(made, v);
	int                near = made.inputVertex[g.vertex[v].anchor];
	ResultVertex       record;
	record.isMade = true;
	if (old >= 0) {
		const ResultVertex& before = result.vertex[old];
		if (g.mesh.position[v] == result.mesh.position[old]) return before;
		near          = surface.mesh.origin[3 * before.point.face];
		record.sample = before.sample;
		record.isMade = before.isMade;
	}
	record.point    = nearestByDescent(surface.mesh, near, g.mesh.position[v]);
	record.normal   = surface.mesh.faceNormal(record.point.face);
	record.isPinned = g.isFixed(v);
	return record;
}

/// The number of vertices with marked faces only.
int insideNum(const HalfEdgeMesh& m, const std::vector<char>& marked)
{
	int num = 0;
	for (int v = 0; v < m.vertexNum; ++v)
		num += m.outgoing[v] >= 0 && hasOnlyMarked(m, v, marked);
	return num;
}

} // namespace

GuardedSettings settingsFor(const MakingOfVertices& making, const ResultMesh& result,
							double lengthWeight)
{
	GuardedSettings settings;
	settings.targetNum        = result.mesh.vertexNum;
	settings.keepsBorder      = result.keepsBorder;
	settings.idealEdge        = double(result.idealEdge);
	settings.lengthWeight     = lengthWeight;
	settings.mayLeaveVertices = making.mayLeaveSurface;
	return settings;
}

Filled takeFilled(const Surface& surface, const ResultMesh& result, RefilledMesh& made)
{
	Filled filled;
	for (int v = 0; v < made.guarded->mesh.vertexNum; ++v) {
		filled.vertex.push_back(recordOf(surface, result, made, v));
		filled.oldVertex.push_back(oldVertex(made, v));
	}
	filled.mesh = std::move(made.guarded->mesh);
	return filled;
}

bool PatchFilling::fill(std::vector<char>& marked, const HasRoom& hasRoom)
{
	if (!refillPatches(making_.surface, result_, making_.kept, marked, workers_, refilled_,
					   hasRoom))
		return false;
	GuardedMesh&    guarded  = *refilled_.guarded;
	GuardedSettings settings = settingsFor(making_, result_, patchLengthWeight);
	settings.untested        = untestedMove;
	if (making_.finer > 1)
		settings.targetNum = std::min<std::int64_t>(
			settings.targetNum + (making_.finer - 1) * insideNum(result_.mesh, marked),
			guarded.mesh.vertexNum);
	// A patch enclosed by few border cells goes to these cells, so a small patch may end with fewer
	// vertices than before.
	if (guarded.mesh.vertexNum < settings.targetNum ||
		!decimateGuarded(settings, guarded, workers_))
		return true;
	freeAround();
	relaxGuarded(settings.idealEdge, making_.mayLeaveSurface, guarded, workers_);
	isSound_ = zeroAreaFaceNum(guarded.mesh, workers_) == 0;
	return true;
}

std::vector<char> PatchFilling::changed() const
{
	std::vector<char> isChanged(mesh().faceNum);
	for (int f = 0; f < mesh().faceNum; ++f)
		isChanged[f] = !refilled_.guarded->isFixedFace(f);
	return isChanged;
}

void PatchFilling::markAround(const std::vector<FacePair>& pairs, std::vector<char>& marked) const
{
	std::vector<int> labels;
	for (int v : verticesOf(mesh(), facesOf(pairs))) {
		const int anchor = refilled_.guarded->vertex[v].anchor;
		labels.push_back(refilled_.label[anchor]);
	}
	for (int f : widened(result_.mesh, facesRound(result_.mesh, labels), ringsAround))
		marked[f] = 1;
}

/// Frees vertices next to patches, so that shapes change gradually.
void PatchFilling::freeAround()
{
	GuardedMesh& g = *refilled_.guarded;
	for (int ring = 0; ring < ringsRelaxed; ++ring) {
		std::vector<int> freed;
		for (int v = 0; v < g.mesh.vertexNum; ++v) {
			if (!g.isFixed(v) || !mayFree(v)) continue;
			if (anyNeighbour(g.mesh, v, [&](int w) { return !g.isFixed(w); })) freed.push_back(v);
		}
		for (int v : freed)
			g.vertex[v].isFixed = false;
	}
}

bool PatchFilling::mayFree(int v) const
{
	const int old = oldVertex(refilled_, v);
	if (old < 0) return false;
	const ResultVertex& vertex = result_.vertex[old];
	return !vertex.isPinned && !vertex.isShared && !vertex.isCorner && vertex.curve < 0;
}

} // namespace gpr
