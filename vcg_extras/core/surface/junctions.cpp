// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "junctions.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <array>

namespace gpr {

Junctions::Junctions(const HalfEdgeMesh& mesh, const std::vector<Vec3f>& meetings,
					 Workers& workers) :
		m_(mesh)
{
	findPlaces(meetings, workers);
	findEdges();
	dropChanceMeetings();
	findTouching();
	findLines();
}

void Junctions::findPlaces(const std::vector<Vec3f>& meetings, Workers& workers)
{
	const auto isMeeting = [&](int v) {
		return std::binary_search(meetings.begin(), meetings.end(), m_.position[v],
								  isBefore<float>);
	};
	std::vector<int> vertices = workers.collectIf(std::size_t(m_.vertexNum), [&](int v) {
		return m_.outgoing[v] >= 0 && (m_.isBorderVertex(v) || isMeeting(v));
	});
	std::stable_sort(vertices.begin(), vertices.end(),
					 [&](int v, int w) { return isBefore(m_.position[v], m_.position[w]); });
	first_ = numbersBelow(std::size_t(m_.vertexNum));
	for (std::size_t i = 0; i < vertices.size();) {
		const int   v   = vertices[i];
		std::size_t end = i + 1;
		while (end < vertices.size() && m_.position[vertices[end]] == m_.position[v])
			++end;
		if (end - i > 1) {
			Place& place = places_[v];
			place.vertices.assign(vertices.begin() + std::ptrdiff_t(i),
								  vertices.begin() + std::ptrdiff_t(end));
			place.isMeeting = isMeeting(v);
			for (int w : place.vertices)
				first_[w] = v;
		}
		i = end;
	}
}

void Junctions::findEdges()
{
	for (const auto& [first, place] : places_) {
		for (int v : place.vertices) {
			if (!m_.isBorderVertex(v)) continue;
			const int w = first_[m_.target(m_.outgoing[v])];
			if (places_.count(w) > 0) ++borderNum_[std::minmax(first, w)];
		}
	}
	for (const auto& [ends, num] : borderNum_) {
		if (num < 2) continue;
		places_[ends.first].next.push_back(ends.second);
		places_[ends.second].next.push_back(ends.first);
	}
}

/// Drops border vertices that lie at the same place by chance: these vertices are no copies.
void Junctions::dropChanceMeetings()
{
	for (auto it = places_.begin(); it != places_.end();) {
		const Place& place = it->second;
		if (place.isMeeting || !place.next.empty()) {
			copyNum_ += int(place.vertices.size()) - 1;
			++it;
			continue;
		}
		for (int v : place.vertices)
			first_[v] = v;
		it = places_.erase(it);
	}
}

bool Junctions::isJunctionEdge(int v, int w) const
{
	const auto found = borderNum_.find(std::minmax({first_[v], first_[w]}));
	return found != borderNum_.end() && found->second > 1;
}

void Junctions::findTouching()
{
	const auto isOnJunction = [&](int v) {
		if (!m_.isBorderVertex(v)) return false;
		return isJunctionEdge(v, m_.target(m_.outgoing[v])) ||
			   isJunctionEdge(m_.origin[m_.incomingBorder(v)], v);
	};
	for (auto& [first, place] : places_) {
		const auto& all  = place.vertices;
		place.isTouching = place.isMeeting && !std::all_of(all.begin(), all.end(), isOnJunction);
	}
}

bool Junctions::isPoint(const Place& place) const
{
	if (place.isTouching || place.next.size() != 2) return true;
	const int first = first_[place.vertices[0]];
	return sheetNum(first, place.next[0]) != sheetNum(first, place.next[1]);
}

Junctions::Line Junctions::followLine(int from, int to, std::map<Ends, bool>& seen,
									  const std::map<int, int>& pointOf) const
{
	const int start = from, sheets = sheetNum(from, to);
	while (true) {
		seen[std::minmax(from, to)] = true;
		if (pointOf.count(to) > 0 || to == start) break;
		const std::vector<int>& next = places_.at(to).next;
		const int               on   = next[0] == from ? next[1] : next[0];
		from                         = to;
		to                           = on;
	}
	if (pointOf.count(start) == 0) return {-1, -1, sheets};
	const auto [least, most] = std::minmax(pointOf.at(start), pointOf.at(to));
	return {least, most, sheets};
}

void Junctions::findLines()
{
	std::vector<int> pointVertices;
	for (const auto& [first, place] : places_) {
		if (isPoint(place)) pointVertices.push_back(first);
	}
	std::sort(pointVertices.begin(), pointVertices.end(),
			  [&](int v, int w) { return isBefore(m_.position[v], m_.position[w]); });
	std::map<int, int> pointOf;
	for (int v : pointVertices) {
		pointOf[v] = int(points_.size());
		points_.push_back(m_.position[v]);
	}
	std::map<Ends, bool> seen;
	const auto           follow = [&](int v) {
        for (int w : places_.at(v).next) {
            if (!seen[std::minmax(v, w)]) lines_.push_back(followLine(v, w, seen, pointOf));
        }
	};
	for (int v : pointVertices)
		follow(v);
	for (const auto& [first, place] : places_)
		follow(first);
	std::sort(lines_.begin(), lines_.end());
}

bool Junctions::isSameAs(const Junctions& other) const
{
	return points_ == other.points_ && lines_ == other.lines_;
}

std::vector<int> Junctions::touchingVertices() const
{
	std::vector<int> all;
	for (const auto& [first, place] : places_) {
		if (place.isTouching) all.insert(all.end(), place.vertices.begin(), place.vertices.end());
	}
	std::sort(all.begin(), all.end());
	return all;
}

bool Junctions::hasTwinFaces(Workers& workers) const
{
	std::vector<std::array<int, 3>> faces =
		workers.collectEach<std::array<int, 3>>(std::size_t(m_.faceNum), [&](int f, auto& out) {
			const int* v = &m_.origin[3 * f];
			if (!isOfPlace(v[0]) && !isOfPlace(v[1]) && !isOfPlace(v[2])) return;
			out.push_back({first_[v[0]], first_[v[1]], first_[v[2]]});
			std::sort(out.back().begin(), out.back().end());
		});
	std::sort(faces.begin(), faces.end());
	return std::adjacent_find(faces.begin(), faces.end()) != faces.end();
}

std::vector<int> Junctions::falseEdges(Workers& workers) const
{
	const std::vector<int> chords = workers.collectIf(std::size_t(m_.halfEdgeNum()), [&](int h) {
		return !isDeadFace(m_, h / 3) && h < m_.opposite[h] &&
			   (isOfPlace(m_.origin[h]) || isOfPlace(m_.target(h)));
	});
	std::map<Ends, bool>   seen;
	std::vector<int>       found;
	for (int h : chords) {
		const Ends ends   = std::minmax({first_[m_.origin[h]], first_[m_.target(h)]});
		const bool isSeen = std::exchange(seen[ends], true);
		if (isSeen || borderNum_.count(ends) > 0) found.push_back(h);
	}
	return found;
}

} // namespace gpr
