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

/// A cube of space with its vertices, and the reach of work in the cell.
struct GridCell {
	Vec3f centre;
	float reach = 0; ///< from the centre, along each axis
	int   begin = 0; ///< in ColouredGrid::vertices
	int   end   = 0;

	bool reaches(const Vec3f& p) const
	{
		return std::abs(p.x - centre.x) < reach && std::abs(p.y - centre.y) < reach &&
			   std::abs(p.z - centre.z) < reach;
	}
};

/// Some vertices of a mesh, assigned to cubes of space in eight colours.
///
/// The reaches of two cells of the same colour never overlap. So all cells of a colour can at once
/// make flips within reach of all four vertices: a flip writes to its two faces, to the opposites
/// of their outer edges, and to its vertices. A walk round a vertex within reach reads only faces
/// at this vertex, whose opposites there no other cell writes. The result depends only on the order
/// of colours and vertices.
struct ColouredGrid {
	std::vector<int>                     vertices;
	std::array<std::vector<GridCell>, 8> byColour;

	/// Calls body(cell, worker) for every cell: colour after colour, the cells of a colour in
	/// parallel.
	template <class Body>
	void forEachCell(Workers& workers, const Body& body) const
	{
		for (const std::vector<GridCell>& cells : byColour)
			workers.forTasks(cells.size(),
							 [&](std::size_t i, int worker) { body(cells[i], worker); });
	}
};

/// Assigns the vertices to cells of the given width (working units); a cell keeps their order.
/// Cost: a sort of the vertices by cell.
ColouredGrid cutIntoGridCells(const HalfEdgeMesh& mesh, const std::vector<int>& vertices,
							  float width);

} // namespace gpr

#endif
