// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_changer.h"

#include "constraint.h"
#include "edge_middle.h"

#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>

namespace gpr {

namespace {

/// Passes of flips and moves after a split or collapse.
constexpr int settlePasses = 2;

} // namespace

PatchChanger::PatchChanger(const Surface& surface, const BoundaryCurves& curves, float angle,
						   ResultMesh& result, Workers& workers, const CellsOfFaces& cells,
						   int mostNew) :
		PatchMover(surface, curves, angle, result, workers, cells, mostNew)
{
}

std::vector<PatchChanger::Operation> PatchChanger::operationsAt(int f) const
{
	std::vector<Operation> all;
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		for (Operation::Kind kind :
			 {Operation::Split, Operation::Attach, Operation::Collapse, Operation::CollapseBack})
			all.push_back({kind, h});
	}
	return all;
}

std::vector<int> PatchChanger::patchRound(int f) const
{
	std::vector<int> patch;
	for (const Operation& op : operationsAt(f)) {
		const std::vector<int> one = patchOf(op);
		patch.insert(patch.end(), one.begin(), one.end());
	}
	return patch;
}

std::vector<int> PatchChanger::patchOf(const Operation& op) const
{
	const int        h = op.halfEdge;
	std::vector<int> patch;
	if (op.isCollapse()) {
		addStar(op.kind == Operation::Collapse ? m_.origin[h] : m_.target(h), patch);
	}
	else {
		addQuadHalf(h, patch);
		if (m_.opposite[h] >= 0) addQuadHalf(m_.opposite[h], patch);
		if (op.kind == Operation::Attach) addStar(m_.apex(h), patch);
	}
	sortUnique(patch);
	return patch;
}

PatchChanger::Snapshot PatchChanger::remember(const std::vector<int>& patch) const
{
	return {PatchBackup(m_, patch), placesOf(patch), m_.vertexNum};
}

std::vector<int> PatchChanger::patchNow(const Snapshot& before) const
{
	return livingSince(before.vertexNum, before.backup.vertices());
}

void PatchChanger::takeBack(const Snapshot& before)
{
	before.backup.restore(m_);
	r_.vertex.resize(m_.vertexNum);
	for (std::size_t i = 0; i < before.places.size(); ++i)
		put(before.backup.vertices()[i], before.places[i]);
}

bool PatchChanger::make(const Operation& op)
{
	const std::vector<int> patch     = patchOf(op);
	const int              vertexNum = m_.vertexNum;
	if (!apply(op)) return false;
	settle(livingSince(vertexNum, patch));
	return true;
}

std::vector<int> PatchChanger::makeForGood(const std::vector<Operation>& ops,
										   const std::vector<int>&       patch)
{
	const int                vertexNum = m_.vertexNum;
	const std::vector<int>   faces     = facesRound(m_, patch);
	const std::vector<Vec3f> centres   = centresOf(faces);
	for (const Operation& op : ops) {
		make(op);
		r_.splitNum += op.isSplit();
		r_.collapseNum += op.kind != Operation::Split;
	}
	std::vector<int>       now   = livingSince(vertexNum, patch);
	const std::vector<int> heirs = facesRound(m_, now);
	for (std::size_t i = 0; i < faces.size(); ++i) {
		if (isDeadFace(m_, faces[i])) handCellsOn(faces[i], nearestOf(heirs, centres[i]));
	}
	return now;
}

std::vector<int> PatchChanger::livingSince(int vertexNum, const std::vector<int>& vertices) const
{
	std::vector<int> patch = livingOf(vertices);
	for (int v = vertexNum; v < m_.vertexNum; ++v) {
		if (m_.outgoing[v] >= 0) patch.push_back(v);
	}
	return patch;
}

std::vector<int> PatchChanger::livingOf(const std::vector<int>& vertices) const
{
	std::vector<int> living;
	for (int v : vertices) {
		if (m_.outgoing[v] >= 0) living.push_back(v);
	}
	return living;
}

std::vector<PatchMover::Place> PatchChanger::placesOf(const std::vector<int>& vertices) const
{
	std::vector<Place> places;
	places.reserve(vertices.size());
	for (int v : vertices)
		places.push_back(placeOf(v));
	return places;
}

void PatchChanger::addStar(int v, std::vector<int>& patch) const
{
	patch.push_back(v);
	forEachNeighbour(m_, v, [&](int w) { patch.push_back(w); });
}

void PatchChanger::addQuadHalf(int h, std::vector<int>& patch) const
{
	for (int corner = 3 * (h / 3); corner < 3 * (h / 3) + 3; ++corner)
		patch.push_back(m_.origin[corner]);
	for (int side : {nextInFace(h), prevInFace(h)}) {
		if (m_.opposite[side] >= 0) patch.push_back(m_.apex(m_.opposite[side]));
	}
}

std::vector<Vec3f> PatchChanger::centresOf(const std::vector<int>& faces) const
{
	std::vector<Vec3f> centres;
	centres.reserve(faces.size());
	for (int f : faces)
		centres.push_back(m_.faceCentre(f));
	return centres;
}

int PatchChanger::nearestOf(const std::vector<int>& faces, const Vec3f& p) const
{
	return *std::min_element(faces.begin(), faces.end(), [&](int f, int g) {
		return squaredLength(m_.faceCentre(f) - p) < squaredLength(m_.faceCentre(g) - p);
	});
}

bool PatchChanger::apply(const Operation& op)
{
	const int h = op.halfEdge;
	if (op.kind == Operation::Split) return split(h);
	if (op.kind == Operation::Attach) return attach(h);
	if (m_.opposite[h] < 0) return collapseBorder(h, op.kind == Operation::Collapse);
	return collapseInside(op.kind == Operation::Collapse ? h : m_.opposite[h]);
}

bool PatchChanger::split(int h)
{
	const int    a = m_.origin[h], b = m_.target(h);
	ResultVertex middle;
	if (m_.opposite[h] < 0 && r_.keepsBorder) return false;
	const bool found = m_.isCurveEdge(h) ? findMiddleOnCurve(surface_, curves_, r_, a, b, middle)
										 : findMiddle(surface_, r_, a, b, middle);
	if (!found) return false;
	const Vec3f height = (heightOf(a) + heightOf(b)) * 0.5f;
	const int   v      = m_.vertexNum++;
	r_.vertex.push_back(middle);
	m_.position[v] = startPosition_[v] = middle.anchor.position + height;
	if (m_.opposite[h] < 0)
		splitBorderEdge(m_, h, v);
	else
		splitEdge(m_, h, v);
	normal_[v] = startNormal_[v] = normalAt(v, middle.anchor);
	return true;
}

bool PatchChanger::attach(int h)
{
	const int v = m_.apex(h);
	if (!mayGo(v) || !split(h)) return false;
	int toMiddle = -1;
	forEachOutgoing(m_, v, [&](int x) {
		if (m_.target(x) == m_.vertexNum - 1) toMiddle = x;
	});
	return m_.opposite[toMiddle] >= 0 && collapseInside(toMiddle);
}

Vec3f PatchChanger::heightOf(int v) const
{
	return m_.position[v] - r_.vertex[v].anchor.position;
}

bool PatchChanger::mayGo(int v) const
{
	if (r_.vertex[v].isCorner || r_.vertex[v].isPinned) return false;
	return !m_.isCurveVertex(v) || mayLeaveCurve(r_, curves_, v);
}

bool PatchChanger::collapseBorder(int h, bool forward)
{
	const int v = forward ? m_.origin[h] : m_.target(h);
	if (r_.keepsBorder || !mayGo(v)) return false;
	if (!canCollapseAlongBorder(m_, v, forward, scratch_)) return false;
	collapseAlongBorder(m_, v, forward);
	return true;
}

bool PatchChanger::collapseInside(int h)
{
	if (!mayGo(m_.origin[h])) return false;
	if (!canCollapse(m_, h, scratch_) && !canCollapseAlongCrease(m_, h, scratch_)) return false;
	collapse(m_, h);
	return true;
}

void PatchChanger::settle(const std::vector<int>& patch)
{
	std::vector<int> sorted = patch;
	std::sort(sorted.begin(), sorted.end());
	for (int pass = 0; pass < settlePasses; ++pass) {
		for (int f : facesRound(m_, patch)) {
			for (int h = 3 * f; h < 3 * f + 3; ++h)
				flipIfBetter(h, sorted);
		}
		for (int v : patch)
			moveToBest(v);
	}
}

void PatchChanger::flipIfBetter(int h, const std::vector<int>& patch)
{
	const int g = m_.opposite[h];
	if (g < 0) return;
	for (int v : cornersAt(h)) {
		if (!std::binary_search(patch.begin(), patch.end(), v)) return;
	}
	const std::vector<int> pair   = {h / 3, g / 3};
	const Quality          before = patchQuality(pair);
	if (before.cost == 0 || !mayFlip(h)) return;
	flip(m_, h);
	if (!patchQuality(pair).beats(before)) flip(m_, nextInFace(h));
}

} // namespace gpr
