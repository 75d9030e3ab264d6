// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_editor.h"

#include "constraint.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/features/curve_slide.h>
#include <vcg_extras/core/features/edge_middle.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>

namespace gpr {

namespace {

/// A vertex slides at most this share of the way to the next vertex of its curve in a step, so that
/// a few slides cannot reach the neighbour.
constexpr float longestSlide = 0.5f;
/// The diagonals of a gentle flip are at most this share of an edge apart: this gap is the move of
/// the surface.
constexpr float largestDiagonalGap = 0.5f;
/// The most faces a step may cross; longer ways, among needles, are not worth their time.
constexpr int maxFacesOfStep = 256;

/// Whether v, less a face, keeps at least four faces, or is on the border. Of three faces round a
/// vertex, some angle is at most 30°.
bool maySpareFace(const HalfEdgeMesh& m, int v)
{
	return m.isBorderVertex(v) || m.valence(v) > 4;
}

void addStar(const HalfEdgeMesh& m, int v, std::vector<int>& patch)
{
	patch.push_back(v);
	forEachNeighbour(m, v, [&](int w) { patch.push_back(w); });
}

/// Adds the corners of h's face, and the corners beyond its other edges.
void addHalfOfEdge(const HalfEdgeMesh& m, int h, std::vector<int>& patch)
{
	patch.insert(patch.end(), {m.origin[h], m.target(h), m.apex(h)});
	for (int side : {nextInFace(h), prevInFace(h)}) {
		if (m.opposite[side] >= 0) patch.push_back(m.apex(m.opposite[side]));
	}
}

} // namespace

std::vector<Operation> operationsAt(const HalfEdgeMesh& m, int face,
									const std::vector<Operation::Kind>& kinds)
{
	std::vector<Operation> all;
	for (int h = 3 * face; h < 3 * face + 3; ++h) {
		for (Operation::Kind kind : kinds) {
			all.push_back({kind, h});
			const bool hasBeyond = kind == Operation::Move && m.opposite[h] >= 0;
			if (hasBeyond) all.push_back({kind, prevInFace(m.opposite[h])});
		}
	}
	return all;
}

PatchEditor::PatchEditor(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result,
						 Workers& workers, int spareVertexNum) :
		surface_(surface),
		curves_(curves), r_(result), m_(result.mesh),
		startNormal_(normalsWithoutLips(surface, result, workers)),
		startPosition_(std::size_t(m_.vertexNum + spareVertexNum))
{
	reserve(m_, m_.vertexNum + spareVertexNum, m_.faceNum + 2 * spareVertexNum);
	startNormal_.resize(startPosition_.size());
	std::copy(m_.position.data(), m_.position.data() + m_.vertexNum, startPosition_.data());
	normal_ = copyOf(startNormal_, workers);
}

float PatchEditor::agreement(int f) const
{
	return normalAgreement(m_, normal_, f);
}

float PatchEditor::agreementAtCreases(int f) const
{
	float least = 1;
	for (int h = 3 * f; m_.hasCreases() && h < 3 * f + 3; ++h)
		least = std::min(least, creaseAgreement(surface_, curves_, r_, h));
	return least;
}

// ---- vertices

void PatchEditor::put(int v, const VertexState& state)
{
	m_.position[v] = state.position;
	normal_[v]     = state.normal;
	r_.vertex[v]   = state.record;
}

float PatchEditor::meanEdge(int v) const
{
	float sum = 0;
	int   num = 0;
	forEachNeighbour(m_, v, [&](int w) {
		sum += length(m_.position[w] - m_.position[v]);
		++num;
	});
	return sum / float(num);
}

bool PatchEditor::mayMove(int v, bool mayCrowd) const
{
	const ResultVertex& r = r_.vertex[v];
	if (mayCrowd && r.curve >= 0 && m_.isBorderVertex(v)) return !r.isPinned && !r.isShared;
	const Constraint constraint = constraintOf(r_, v);
	return constraint == Constraint::Curve || constraint == Constraint::Free;
}

std::vector<PatchEditor::VertexState> PatchEditor::statesAround(int v, float reach,
																bool mayCrowd) const
{
	std::vector<VertexState> states;
	const ResultVertex&      here = r_.vertex[v];
	if (here.curve >= 0) {
		const SlideRoom room = slideRoom(r_, curves_, v);
		for (float by : {-reach, reach}) {
			if (reach > longestSlide * (by < 0 ? room.backward : room.forward)) continue;
			if (mayCrowd || (slideKeepsToCurve(r_, curves_, v, room, by) &&
							 slideKeepsSpacing(r_, curves_, v, room, by)))
				states.push_back(movedTo(v, slid(surface_, curves_, here, by)));
		}
		return states;
	}
	for (const Vec3f& direction : compassDirections(here.normal)) {
		ResultVertex there = here;
		if (!walk(surface_.mesh, there.point, direction * reach, maxFacesOfStep)) continue;
		there.normal = surface_.mesh.faceNormal(there.point.face);
		states.push_back(movedTo(v, there));
	}
	return states;
}

PatchEditor::VertexState PatchEditor::movedTo(int v, const ResultVertex& record) const
{
	return {record.point.position + heightOf(v), normalAt(v, record.point), record};
}

bool PatchEditor::isNearStart(int v, const VertexState& state, float share, float minCosine) const
{
	const Vec3f& normal = startNormal_[v];
	const float  scale  = length(state.normal) * length(normal);
	if (dot(state.normal, normal) < minCosine * scale) return false;
	return length(state.position - startPosition_[v]) <= share * meanEdge(v);
}

Vec3f PatchEditor::normalAt(int v, const SurfacePoint& at) const
{
	const Vec3f own = smoothNormal(surface_, at);
	return m_.isBorderVertex(v) ? withoutLip(m_, normal_, v, own) : own;
}

// ---- edges

std::array<int, 4> PatchEditor::cornersAt(int h) const
{
	return {m_.origin[h], m_.target(h), m_.apex(h), m_.apex(m_.opposite[h])};
}

bool PatchEditor::isGentleFlip(int h) const
{
	const std::array<int, 4> corner = cornersAt(h);
	if (!maySpareFace(m_, corner[0]) || !maySpareFace(m_, corner[1])) return false;
	// Edges between kept vertices are most likely the reason to keep the vertices.
	if (r_.vertex[corner[0]].isPinned && r_.vertex[corner[1]].isPinned) return false;
	const float gap = lineDistance(m_.position[corner[0]], m_.position[corner[1]],
								   m_.position[corner[2]], m_.position[corner[3]]);
	return gap <= largestDiagonalGap * meanEdge(corner[0]);
}

std::vector<int> PatchEditor::patchOf(const Operation& op) const
{
	const int        h = op.halfEdge;
	std::vector<int> patch;
	if (op.kind == Operation::Move) return {m_.origin[h]};
	if (op.isCollapse()) {
		addStar(m_, op.kind == Operation::Collapse ? m_.origin[h] : m_.target(h), patch);
	}
	else if (op.kind == Operation::Flip) {
		if (m_.opposite[h] < 0) return {};
		const std::array<int, 4> corners = cornersAt(h);
		patch.assign(corners.begin(), corners.end());
	}
	else {
		addHalfOfEdge(m_, h, patch);
		if (m_.opposite[h] >= 0) addHalfOfEdge(m_, m_.opposite[h], patch);
		if (op.kind == Operation::Attach) addStar(m_, m_.apex(h), patch);
	}
	sortUnique(patch);
	return patch;
}

bool PatchEditor::make(const Operation& op)
{
	const int h = op.halfEdge;
	switch (op.kind) {
	case Operation::Flip:
		if (!mayFlip(h)) return false;
		flip(h);
		return true;
	case Operation::Split:
		return split(h);
	case Operation::Attach:
		return attach(h);
	case Operation::Collapse:
		return m_.opposite[h] < 0 ? collapseOnBorder(h, true) : collapseInside(h);
	case Operation::CollapseBack:
		return m_.opposite[h] < 0 ? collapseOnBorder(h, false) : collapseInside(m_.opposite[h]);
	default:
		return false;
	}
}

bool PatchEditor::split(int h)
{
	const int a = m_.origin[h], b = m_.target(h);
	if (m_.opposite[h] < 0 && !maySplitBorder(r_, h)) return false;
	if (std::size_t(m_.vertexNum) >= normal_.size()) return false; // no room is left
	ResultVertex middle;
	const bool   found = m_.isCurveEdge(h) ? findMiddleOnCurve(surface_, curves_, r_, a, b, middle)
										   : findMiddle(surface_, r_, a, b, middle);
	if (!found) return false;
	const Vec3f height = (heightOf(a) + heightOf(b)) * 0.5f;
	const int   v      = m_.vertexNum++;
	r_.vertex.push_back(middle);
	m_.position[v] = startPosition_[v] = middle.point.position + height;
	if (m_.opposite[h] < 0)
		splitBorderEdge(m_, h, v);
	else
		splitEdge(m_, h, v);
	normal_[v] = startNormal_[v] = normalAt(v, middle.point);
	return true;
}

bool PatchEditor::attach(int h)
{
	const int v = m_.apex(h);
	if (!mayGo(v) || !split(h)) return false;
	const int toMiddle = m_.findHalfEdge(v, m_.vertexNum - 1);
	return toMiddle >= 0 && m_.opposite[toMiddle] >= 0 && collapseInside(toMiddle);
}

bool PatchEditor::mayGo(int v) const
{
	if (r_.vertex[v].isCorner || r_.vertex[v].isPinned) return false;
	return !m_.isCurveVertex(v) || mayLeaveCurve(r_, curves_, v);
}

bool PatchEditor::collapseOnBorder(int h, bool forward)
{
	const int v = forward ? m_.origin[h] : m_.target(h);
	if (r_.keepsBorder || !mayGo(v)) return false;
	if (!canCollapseAlongBorder(m_, v, forward, scratch_)) return false;
	collapseAlongBorder(m_, v, forward);
	return true;
}

bool PatchEditor::collapseInside(int h)
{
	if (!mayGo(m_.origin[h])) return false;
	if (!canCollapse(m_, h, scratch_) && !canCollapseAlongCrease(m_, h, scratch_)) return false;
	collapse(m_, h);
	return true;
}

// ---- undoing

PatchEditor::Snapshot PatchEditor::remember(const std::vector<int>& patch) const
{
	return snapshotOf(PatchBackup(m_, patch, facesRound(m_, patch)));
}

PatchEditor::Snapshot PatchEditor::rememberFlip(int h) const
{
	std::vector<int> faces;
	for (int face : {h / 3, m_.opposite[h] / 3}) {
		faces.push_back(face);
		for (int side = 3 * face; side < 3 * face + 3; ++side) {
			if (m_.opposite[side] >= 0) faces.push_back(m_.opposite[side] / 3);
		}
	}
	sortUnique(faces);
	const std::array<int, 4> corners = cornersAt(h);
	return snapshotOf(PatchBackup(m_, {corners.begin(), corners.end()}, std::move(faces)));
}

PatchEditor::Snapshot PatchEditor::snapshotOf(PatchBackup backup) const
{
	Snapshot snapshot = {std::move(backup), {}, m_.vertexNum};
	for (int v : snapshot.backup.vertices())
		snapshot.states.push_back(stateOf(v));
	return snapshot;
}

void PatchEditor::undo(const Snapshot& before)
{
	before.backup.restore(m_);
	r_.vertex.resize(m_.vertexNum);
	for (std::size_t i = 0; i < before.states.size(); ++i)
		put(before.backup.vertices()[i], before.states[i]);
}

std::vector<int> PatchEditor::patchNow(const std::vector<int>& patch, int vertexNum) const
{
	std::vector<int> left;
	for (int v : patch) {
		if (m_.outgoing[v] >= 0) left.push_back(v);
	}
	for (int v = vertexNum; v < m_.vertexNum; ++v) {
		if (m_.outgoing[v] >= 0) left.push_back(v);
	}
	return left;
}

void PatchEditor::countDone(const Operation& op)
{
	r_.flipNum += op.kind == Operation::Flip;
	r_.splitNum += op.isSplit();
	r_.collapseNum += op.isCollapse() || op.kind == Operation::Attach;
}

void PatchEditor::forgetLinesAt(int f)
{
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		if (m_.isCreaseEdge(h)) m_.crease[h] = m_.crease[m_.opposite[h]] = 0;
	}
}

} // namespace gpr
