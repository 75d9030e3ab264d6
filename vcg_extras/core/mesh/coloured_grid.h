// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_COLOURED_GRID_H
#define VCG_EXTRAS_CORE_MESH_COLOURED_GRID_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <array>
#include <cmath>
#include <vector>

namespace gpr {

/// A cube of space, the vertices that lie in it, and how far work that begins there may reach.
struct GridCell {
	Vec3f centre;
	float reach = 0; ///< from the centre, along each axis
	int   begin = 0; ///< of ColouredGrid::vertices
	int   end   = 0;

	bool reaches(const Vec3f& p) const
	{
		return std::abs(p.x - centre.x) < reach && std::abs(p.y - centre.y) < reach &&
			   std::abs(p.z - centre.z) < reach;
	}
};

/// Some vertices of a mesh, shared out to cubes of space in eight colours.
///
/// What the cells of one colour reach never overlaps. So flips whose four vertices are all reached
/// can be made in all cells of a colour at once: a flip writes to its two faces, to the opposites
/// of their outer edges, and to its vertices. A turn round a reached vertex reads faces with one
/// vertex reached at least, whose opposites at that vertex no other cell writes. The outcome
/// depends on the order of colours and vertices only.
struct ColouredGrid {
	std::vector<int>                     vertices;
	std::array<std::vector<GridCell>, 8> byColour;

	/// Calls body(cell) for every cell: the colours one after the other, a colour's in parallel.
	template <class Body>
	void forEachCell(Workers& workers, const Body& body) const
	{
		for (const std::vector<GridCell>& cells : byColour)
			workers.forTasks(cells.size(), [&](std::size_t i, int) { body(cells[i]); });
	}
};

/// Shares the vertices out to cells of the given width (working units), which keep their order.
/// Cost: sorts the vertices by cell.
ColouredGrid cutIntoGridCells(const HalfEdgeMesh& mesh, const std::vector<int>& vertices,
							  float width);

} // namespace gpr

#endif
