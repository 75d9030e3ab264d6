// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "periodic_border.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace gpr {

namespace {

constexpr int none = -1;
/// Share of the period: coordinates with five digits are exact enough.
constexpr double tolerance = 1e-4;

/// Finds vertices near a place, in the cells of a grid that meet the neighbourhood of the place.
class VertexGrid {
public:
	VertexGrid(const MeshView& mesh, const std::vector<int>& vertices, double reach) :
			mesh_(mesh), reach_(reach)
	{
		for (const int v : vertices)
			in_[cellOf(mesh.position(v))].push_back(v);
	}

	/// The nearest vertex within the reach, or none; of equally near vertices the vertex with the
	/// smallest number.
	int nearest(const Vec3d& to) const
	{
		int    best = none;
		double far  = reach_;
		for (int k = 0; k < 8; ++k) {
			const Vec3d corner = {k & 1 ? reach_ : -reach_, k & 2 ? reach_ : -reach_,
								  k & 4 ? reach_ : -reach_};
			const auto found = in_.find(cellOf(to + corner));
			if (found == in_.end()) continue;
			for (const int v : found->second) {
				const double d = length(mesh_.position(v) - to);
				if (d > far || (d == far && v >= best && best != none)) continue;
				best = v;
				far  = d;
			}
		}
		return best;
	}

private:
	using Cell = std::array<double, 3>;
	const MeshView&                  mesh_;
	double                           reach_;
	std::map<Cell, std::vector<int>> in_;

	/// Cells are as wide as the neighbourhood.
	Cell cellOf(const Vec3d& p) const
	{
		const double wide = 2 * reach_;
		return {std::floor(p.x / wide), std::floor(p.y / wide), std::floor(p.z / wide)};
	}
};

Vec3d alongAxis(int axis, double by)
{
	Vec3d v;
	setCoordinate(v, axis, by);
	return v;
}

/// A vertex without a translate, and the missing place.
struct Miss {
	int   vertex = none, axis = 0;
	Vec3d wanted;
};

/// Measures some of the misses and refuses the border with the largest. vertices: of the border.
[[noreturn]] void refuse(const std::vector<Miss>& misses, const MeshView& mesh,
						 const std::vector<int>& vertices)
{
	constexpr std::size_t mostMeasured = 500; // each against the whole border
	const std::size_t     step         = misses.size() / mostMeasured + 1;
	Miss                  worst;
	double                mismatch = -1;
	for (std::size_t i = 0; i < misses.size(); i += step) {
		double nearest = HUGE_VAL;
		for (const int v : vertices)
			nearest = std::min(nearest, length(mesh.position(v) - misses[i].wanted));
		if (nearest <= mismatch) continue;
		mismatch = nearest;
		worst    = misses[i];
	}
	const Vec3d at = mesh.position(worst.vertex);
	const bool  isMatched =
		mismatch <= tolerance * std::abs(coordinate(worst.wanted - at, worst.axis));
	const char* const format =
		isMatched ? "The border is not periodic along %c: its edges differ at (%.6g, %.6g, %.6g), "
					"although the vertices match (to %.3g)."
				  : "The border is not periodic along %c: one period from (%.6g, %.6g, %.6g) the "
					"nearest vertex of the border is %.3g away.";
	char text[240];
	std::snprintf(text, sizeof text, format, "XYZ"[worst.axis], at.x, at.y, at.z, mismatch);
	throw Failure(Status::UnusableInput, text);
}

} // namespace

PeriodicBorder::PeriodicBorder(const MeshView& mesh, const std::vector<Edge>& edges,
							   const Vec3d& period) :
		period_(period)
{
	if (period == Vec3d()) return;
	std::vector<int> vertices;
	for (const Edge& e : edges)
		vertices.insert(vertices.end(), {e.first, e.second});
	sortUnique(vertices);
	if (vertices.empty())
		throw Failure(Status::UnusableInput, "The surface has no border for a periodic cell.");
	root_ = numbersBelow(mesh.vertexNum);
	shift_.assign(mesh.vertexNum, Shift{});
	for (int axis = 0; axis < 3; ++axis)
		pair(axis, mesh, vertices);
	findRoots();
	check(mesh, vertices, edges);
}

void PeriodicBorder::pair(int axis, const MeshView& mesh, const std::vector<int>& vertices)
{
	std::vector<int>& before = before_[axis];
	std::vector<int>& after  = after_[axis];
	before.assign(mesh.vertexNum, none);
	after.assign(mesh.vertexNum, none);
	const double by = coordinate(period_, axis);
	if (by == 0) return;
	const VertexGrid grid(mesh, vertices, tolerance * by);
	for (const int v : vertices) {
		const int found = grid.nearest(mesh.position(v) + alongAxis(axis, by));
		// A period below the rounding of coordinates leads to no other vertex.
		const bool isBeyond = found != none && coordinate(mesh.position(found), axis) >
												   coordinate(mesh.position(v), axis);
		if (!isBeyond || before[found] != none) continue;
		before[found] = v;
		after[v]      = found;
	}
}

void PeriodicBorder::findRoots()
{
	for (int v = 0; v < int(root_.size()); ++v) {
		int& root = root_[v];
		for (int axis = 0; axis < 3; ++axis) {
			const int before = before_[axis][root];
			if (before == none) continue;
			root = before;
			if (++shift_[v][axis] > 1) {
				throw Failure(Status::UnusableInput,
							  "The period is shorter than the cell: more than two vertices of the "
							  "border lie in a row, one period apart.");
			}
			axis = -1; // all axes once more
		}
	}
}

PeriodicBorder::Shift PeriodicBorder::shiftOf(const Edge& edge) const
{
	Shift shift = shiftOf(edge.first), other = shiftOf(edge.second);
	for (std::size_t axis = 0; axis < 3; ++axis)
		shift[axis] = std::min(shift[axis], other[axis]);
	return shift;
}

unsigned PeriodicBorder::axesOnward(const Edge& edge) const
{
	unsigned axes = 0;
	for (std::size_t axis = 0; any() && axis < 3; ++axis) {
		const std::vector<int>& after = after_[axis];
		if (after[edge.first] != none && after[edge.second] != none) axes |= 1u << axis;
	}
	return axes;
}

std::vector<int> PeriodicBorder::neighboursOf(int v) const
{
	std::vector<int> all;
	for (std::size_t axis = 0; any() && axis < 3; ++axis) {
		for (const int other : {before_[axis][v], after_[axis][v]}) {
			if (other != none) all.push_back(other);
		}
	}
	return all;
}

Vec3d PeriodicBorder::times(const Shift& shift) const
{
	return {shift[0] * period_.x, shift[1] * period_.y, shift[2] * period_.z};
}

std::vector<PeriodicBorder::Edge> PeriodicBorder::alone(const std::vector<Edge>& edges) const
{
	std::set<Edge> known;
	for (const Edge& e : edges)
		known.insert(std::minmax({e.first, e.second}));
	const auto isAlone = [&](const Edge& e) {
		for (const auto& by : {before_, after_}) {
			for (const std::vector<int>& other : by) {
				const int a = other[e.first], b = other[e.second];
				if (a != none && b != none && known.count(std::minmax({a, b})) != 0) return false;
			}
		}
		return true;
	};
	std::vector<Edge> found;
	std::copy_if(edges.begin(), edges.end(), std::back_inserter(found), isAlone);
	return found;
}

void PeriodicBorder::check(const MeshView& mesh, const std::vector<int>& vertices,
						   const std::vector<Edge>& edges) const
{
	const std::vector<Edge> unmatched = alone(edges);
	std::vector<Miss>       misses;
	for (int axis = 0; axis < 3; ++axis) {
		const double by = coordinate(period_, axis);
		if (by == 0) continue;
		const auto at      = [&](int v) { return coordinate(mesh.position(v), axis); };
		const auto isBelow = [&](int a, int b) { return at(a) < at(b); };
		const auto ends    = std::minmax_element(vertices.begin(), vertices.end(), isBelow);
		const auto lieAt   = [&](const Edge& e, int end) {
            return std::abs(at(e.first) - at(end)) <= tolerance * by &&
                   std::abs(at(e.second) - at(end)) <= tolerance * by;
		};
		for (const Edge& e : unmatched) {
			const double sign = lieAt(e, *ends.first) ? 1 : lieAt(e, *ends.second) ? -1 : 0;
			if (sign == 0) continue;
			for (const int v : {e.first, e.second})
				misses.push_back({v, axis, mesh.position(v) + alongAxis(axis, sign * by)});
		}
	}
	if (!misses.empty()) refuse(misses, mesh, vertices);
	if (unmatched.size() == edges.size())
		throw Failure(Status::UnusableInput, "No two edges of the border lie one period apart.");
}

} // namespace gpr
