// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_cut.h"

#include "mesh_edit.h"

#include <vcg_extras/core/base/sort_unique.h>

namespace gpr {

namespace {

/// Half-edges from v on lines or the border, counter-clockwise: the beginnings of v's sectors.
std::vector<int> sectorsAt(const HalfEdgeMesh& m, const Buffer<char>& lines, int v)
{
	std::vector<int> first;
	forEachOutgoing(m, v, [&](int h) {
		if (lines[h] || m.isBorderEdge(h)) first.push_back(h);
	});
	return first;
}

} // namespace

LineCut::LineCut(Surface& surface, const Buffer<char>& lines, Workers& workers) : surface_(surface)
{
	if (lines.empty()) return;
	HalfEdgeMesh&    m = surface.mesh;
	std::vector<int> onLine;
	for (int h : workers.collectIf(std::size_t(m.halfEdgeNum()), [&](int h) { return lines[h]; })) {
		side_.push_back({h, m.opposite[h]});
		onLine.push_back(m.origin[h]);
	}
	sortUnique(onLine);
	std::vector<int> firstOfCopy; // half-edges
	for (const int v : onLine) {
		const std::vector<int> sectors = sectorsAt(m, lines, v);
		const RingSum          ring    = surface.ring.empty() ? RingSum() : surface.ring[v];
		onLine_.push_back({v, m.outgoing[v], ring});
		m.outgoing[v] = sectors.front();
		firstOfCopy.insert(firstOfCopy.end(), sectors.begin() + 1, sectors.end());
		copyOf_.insert(copyOf_.end(), sectors.size() - 1, v);
	}
	for (const Side& side : side_)
		m.opposite[side.halfEdge] = -1;
	addCopies(firstOfCopy);
	if (!surface.ring.empty()) measureRings();
}

/// first: per copy, its first half-edge.
void LineCut::addCopies(const std::vector<int>& first)
{
	HalfEdgeMesh& m = surface_.mesh;
	reserve(m, m.vertexNum + int(first.size()), m.faceNum);
	for (std::size_t i = 0; i < first.size(); ++i) {
		const int copy   = m.vertexNum++;
		m.position[copy] = m.position[copyOf_[i]];
		m.outgoing[copy] = first[i];
		forEachOutgoing(m, copy, [&](int h) { m.origin[h] = copy; });
	}
}

void LineCut::measureRings()
{
	const HalfEdgeMesh& m = surface_.mesh;
	surface_.ring.resize(std::size_t(m.vertexNum));
	for (const LineVertex& old : onLine_)
		surface_.ring[old.vertex] = ringSum(m, old.vertex);
	for (int copy = m.vertexNum - int(copyOf_.size()); copy < m.vertexNum; ++copy)
		surface_.ring[copy] = ringSum(m, copy);
}

void LineCut::close()
{
	HalfEdgeMesh& m = surface_.mesh;
	m.vertexNum -= int(copyOf_.size());
	for (std::size_t i = 0; i < copyOf_.size(); ++i)
		forEachOutgoing(m, m.vertexNum + int(i), [&](int h) { m.origin[h] = copyOf_[i]; });
	for (const Side& side : side_)
		m.opposite[side.halfEdge] = side.opposite;
	for (const LineVertex& old : onLine_) {
		m.outgoing[old.vertex] = old.outgoing;
		if (!surface_.ring.empty()) surface_.ring[old.vertex] = old.ring;
	}
	side_.clear();
	onLine_.clear();
	copyOf_.clear();
}

} // namespace gpr
