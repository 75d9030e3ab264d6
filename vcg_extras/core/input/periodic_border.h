// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_PERIODIC_BORDER_H
#define VCG_EXTRAS_CORE_INPUT_PERIODIC_BORDER_H

#include <vcg_extras/core/vec.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace gpr {

/// Which vertices of a border are translates of which others by the periods of a cell.
class PeriodicBorder {
public:
	/// How many periods along each axis.
	using Shift = std::array<std::int8_t, 3>;
	/// The two vertices of an edge of the border.
	using Edge = std::pair<int, int>;

	/// Without a period: no vertex is a translate.
	PeriodicBorder() = default;
	/// position: of all vertices of the mesh; edges: of its border; period: lengths of the cell,
	/// mesh units, 0 along an axis without one. Vertices are translates where they lie a period
	/// apart within 1e-4 of the period. Throws Failure with the largest mismatch where an edge at
	/// the end of the border along an axis with a period has no translate, and where no edge has
	/// one. Cost: O(B log B) for B edges.
	PeriodicBorder(const std::vector<Vec3d>& position, const std::vector<Edge>& edges,
				   const Vec3d& period);

	bool any() const { return !root_.empty(); }
	/// The vertex that v is a translate of, which is a translate of none; v where there is none.
	int rootOf(int v) const { return any() ? root_[std::size_t(v)] : v; }
	/// The periods from there to v.
	Shift shiftOf(int v) const { return any() ? shift_[std::size_t(v)] : Shift{}; }
	/// Those that both vertices of an edge are away from their roots.
	Shift shiftOf(const Edge& edge) const;
	/// The axes, as bits, along which an edge has a translate one period on.
	unsigned axesOnward(const Edge& edge) const;
	/// The translates of v, one period before and after it along each axis.
	std::vector<int> neighboursOf(int v) const;

	/// By that much a translate is away.
	Vec3d times(const Shift& shift) const;

private:
	Vec3d                           period_;
	std::vector<int>                root_; ///< per vertex; empty: no period
	std::vector<Shift>              shift_;
	std::array<std::vector<int>, 3> before_, after_; ///< per vertex and axis, or -1

	void pair(int axis, const std::vector<Vec3d>& position, const std::vector<int>& vertices);
	void findRoots();
	/// Edges without a translate.
	std::vector<Edge> alone(const std::vector<Edge>& edges) const;
	void              check(const std::vector<Vec3d>& position, const std::vector<int>& vertices,
							const std::vector<Edge>& edges) const;
};

} // namespace gpr

#endif
