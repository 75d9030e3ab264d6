// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_filling.h"

#include "face_sets.h"
#include "guarded_relaxation.h"
#include "made_vertex.h"

#include <vcg_extras/core/mesh/measure.h>

#include <utility>

namespace gpr {

namespace {

/// Rings of vertices round patches that may move too.
constexpr int ringsRelaxed = 2;
/// Weight of an edge's length in patches, against the distance from the input.
constexpr double patchLengthWeight = 0.3;

} // namespace

bool PatchFilling::fill(std::vector<char>& marked, const HasRoom& hasRoom)
{
	if (!refillPatches(making_.surface, result_, making_.kept, marked, workers_, refilled_,
					   hasRoom))
		return false;
	GuardedMesh&    guarded = *refilled_.guarded;
	GuardedSettings settings;
	settings.targetNum        = result_.mesh.vertexNum;
	settings.keepsBorder      = result_.keepsBorder;
	settings.idealEdge        = double(result_.idealEdge);
	settings.lengthWeight     = patchLengthWeight;
	settings.mayLeaveVertices = making_.mayLeaveSurface;
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

void PatchFilling::markAround(const std::vector<FacePair>& pairs, std::vector<char>& marked) const
{
	std::vector<int> labels;
	for (int v : verticesOf(mesh(), facesOf(pairs))) {
		const int anchor = refilled_.guarded->vertex[std::size_t(v)].anchor;
		labels.push_back(refilled_.label[std::size_t(anchor)]);
	}
	for (int f : widened(result_.mesh, facesRound(result_.mesh, labels), ringsAround))
		marked[std::size_t(f)] = 1;
}

bool PatchFilling::isChanged(int face) const
{
	return !refilled_.guarded->isFixedFace(face);
}

Filled PatchFilling::take()
{
	Filled filled;
	for (int v = 0; v < mesh().vertexNum; ++v) {
		filled.vertex.push_back(recordOf(v));
		filled.oldVertex.push_back(oldVertex(v));
	}
	filled.mesh = std::move(refilled_.guarded->mesh);
	return filled;
}

/// Number of vertex v in the result, or -1 inside patches.
int PatchFilling::oldVertex(int v) const
{
	return refilled_.resultVertex[std::size_t(refilled_.guarded->vertex[std::size_t(v)].anchor)];
}

/// Frees vertices next to patches, so that shapes change gradually.
void PatchFilling::freeAround()
{
	GuardedMesh& g = *refilled_.guarded;
	for (int ring = 0; ring < ringsRelaxed; ++ring) {
		std::vector<int> freed;
		for (int v = 0; v < g.mesh.vertexNum; ++v) {
			if (!g.isFixed(v) || !mayFree(v)) continue;
			bool isNext = false;
			forEachNeighbour(g.mesh, v, [&](int w) { isNext = isNext || !g.isFixed(w); });
			if (isNext) freed.push_back(v);
		}
		for (int v : freed)
			g.vertex[std::size_t(v)].isFixed = false;
	}
}

bool PatchFilling::mayFree(int v) const
{
	const int old = oldVertex(v);
	if (old < 0) return false;
	const ResultVertex& vertex = result_.vertex[std::size_t(old)];
	return !vertex.isPinned && !vertex.isShared && !vertex.isCorner && vertex.curve < 0;
}

ResultVertex PatchFilling::recordOf(int v) const
{
	const int old = oldVertex(v);
	if (old < 0) {
		const int anchor = refilled_.guarded->vertex[std::size_t(v)].anchor;
		const int near   = refilled_.inputVertex[std::size_t(anchor)];
		return madeVertex(making_.surface, near, *refilled_.guarded, v);
	}
	const ResultVertex& before = result_.vertex[std::size_t(old)];
	if (mesh().position[v] == result_.mesh.position[old]) return before;
	const int    near  = making_.surface.mesh.origin[3 * before.point.face];
	ResultVertex moved = madeVertex(making_.surface, near, *refilled_.guarded, v);
	moved.sample       = before.sample;
	moved.isMade       = before.isMade;
	return moved;
}

} // namespace gpr
