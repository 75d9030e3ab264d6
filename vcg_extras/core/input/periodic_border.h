// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_PERIODIC_BORDER_H
#define VCG_EXTRAS_CORE_INPUT_PERIODIC_BORDER_H

#include <vcg_extras/core/mesh_view.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace gpr {

/// The vertices of a border that are translates of each other by the periods of a cell.
class PeriodicBorder {
public:
	/// Number of periods along each axis.
	using Shift = std::array<std::int8_t, 3>;
	/// The two vertices of an edge of the border.
	using Edge = std::pair<int, int>;

	/// Without a period: no vertex is a translate.
	PeriodicBorder() = default;
	/// edges: of the border of the mesh; period: lengths of the cell,
	/// mesh units, 0 along an axis without a period. Vertices are translates if they lie a period
	/// apart, within 1e-4 of the period. Throws Failure with the largest mismatch if an edge at an
	/// end of the border, along an axis with a period, has no translate, and if no edge has a
	/// translate. Cost: O(B log B) for B edges.
	PeriodicBorder(const MeshView& mesh, const std::vector<Edge>& edges, const Vec3d& period);

	bool any() const { return !root_.empty(); }
	/// The root of v: the translate of v without a translate before it; v itself if v has no
	/// translate before it.
	int rootOf(int v) const { return any() ? root_[v] : v; }
	/// The periods from the root to v.
	Shift shiftOf(int v) const { return any() ? shift_[v] : Shift{}; }
	/// The least periods of an edge's two vertices from their roots, along each axis.
	Shift shiftOf(const Edge& edge) const;
	/// The axes, as bits, along which an edge has a translate one period on.
	unsigned axesOnward(const Edge& edge) const;
	/// The translates of v, one period before and after v along each axis.
	std::vector<int> neighboursOf(int v) const;

	/// Offset of a translate by this shift.
	Vec3d times(const Shift& shift) const;

private:
	Vec3d                           period_;
	std::vector<int>                root_; ///< per vertex; empty: no period
	std::vector<Shift>              shift_;
	std::array<std::vector<int>, 3> before_, after_; ///< per vertex and axis, or -1

	void pair(int axis, const MeshView& mesh, const std::vector<int>& vertices);
	void findRoots();
	/// Edges without a translate.
	std::vector<Edge> alone(const std::vector<Edge>& edges) const;
	void              check(const MeshView& mesh, const std::vector<int>& vertices,
							const std::vector<Edge>& edges) const;
};

} // namespace gpr

#endif
