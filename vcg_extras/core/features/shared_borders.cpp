// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared_borders.h"

#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <set>

namespace gpr {

SharedBorders::SharedBorders(const HalfEdgeMesh& mesh, const std::vector<Curve>& curves)
{
	numberPlaces(mesh, curves);
	for (int c = 0; c < int(place_.size()); ++c) {
		for (int i = 0; i < int(place_[c].size()); ++i)
			line_[endsOf(c, i)].curves.push_back(c);
	}
	findStops();
}

void SharedBorders::numberPlaces(const HalfEdgeMesh& mesh, const std::vector<Curve>& curves)
{
	PlaceMap<int> number(isBefore<float>);
	place_.resize(curves.size());
	for (std::size_t c = 0; c < curves.size(); ++c) {
		if (!mesh.isBorderEdge(curves[c].halfEdge[0])) continue;
		for (const Vec3f& p : curves[c].point)
			place_[c].push_back(number.insert({p, int(number.size())}).first->second);
	}
	isStop_.assign(number.size(), 0);
}

/// Makes stops of the ends and forks of shared stretches. A point is a stop if a different set of
/// curves runs along the next segment than along the last, if a curve turns back there, or if
/// shared segments lead from its place to one place or to more than two.
void SharedBorders::findStops()
{
	std::map<int, std::set<int>> next; ///< per place: other ends of shared segments
	for (const auto& [ends, line] : line_) {
		if (line.curves.size() < 2) continue;
		next[ends.first].insert(ends.second);
		next[ends.second].insert(ends.first);
	}
	for (const auto& [place, others] : next)
		isStop_[place] = others.size() != 2;
	for (int c = 0; c < int(place_.size()); ++c) {
		const int n = int(place_[c].size());
		for (int i = 0; i < n; ++i) {
			if (!isOnShared(c, i)) continue;
			const bool turnsBack = placeAt(c, i + n - 1) == placeAt(c, i + 1);
			if (turnsBack || lineOf(c, i + n - 1).curves != lineOf(c, i).curves) addStop(c, i);
		}
	}
}

int SharedBorders::placeAt(int curve, int i) const
{
	const std::vector<int>& place = place_[curve];
	return place[std::size_t(i) % place.size()];
}

std::pair<int, int> SharedBorders::endsOf(int curve, int segment) const
{
	return std::minmax({placeAt(curve, segment), placeAt(curve, segment + 1)});
}

bool SharedBorders::isShared(int curve, int segment) const
{
	return !place_[curve].empty() && lineOf(curve, segment).curves.size() > 1;
}

bool SharedBorders::isAnyShared(int curve) const
{
	for (int i = 0; i < int(place_[curve].size()); ++i) {
		if (isShared(curve, i)) return true;
	}
	return false;
}

bool SharedBorders::isOnShared(int curve, int i) const
{
	const int n = int(place_[curve].size());
	return n > 0 && (isShared(curve, i) || isShared(curve, i + n - 1));
}

bool SharedBorders::isStop(int curve, int i) const
{
	return !place_[curve].empty() && isStop_[placeAt(curve, i)] != 0;
}

void SharedBorders::addStop(int curve, int i)
{
	isStop_[placeAt(curve, i)] = 1;
}

void SharedBorders::addSample(int curve, int segment, float share, const Vec3f& position)
{
	const float fromSmaller = runsForward(curve, segment) ? share : 1 - share;
	lineOf(curve, segment).samples.push_back({fromSmaller, position});
}

void equalizeSizes(Surface& surface)
{
	const HalfEdgeMesh& m = surface.mesh;
	PlaceMap<float>     least(isBefore<float>);
	const auto          isBorder = [&](int v) { return m.outgoing[v] >= 0 && m.isBorderVertex(v); };
	for (int v = 0; v < m.vertexNum; ++v) {
		if (!isBorder(v)) continue;
		float& size = least.insert({m.position[v], surface.size[v]}).first->second;
		size        = std::min(size, surface.size[v]);
	}
	for (int v = 0; v < m.vertexNum; ++v) {
		if (isBorder(v)) surface.size[v] = least.at(m.position[v]);
	}
}

} // namespace gpr
