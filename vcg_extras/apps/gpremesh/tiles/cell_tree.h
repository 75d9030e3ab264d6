// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_CELL_TREE_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_CELL_TREE_H

#include <vcg_extras/core/vec.h>

#include <vector>

namespace gpr::app {

/// Cuts space into cells with about as many points in each: a kd-tree. The same points give the
/// same tree on every machine.
class CellTree {
public:
	struct Node {
		int    axis  = 0;            ///< 0 to 2
		double value = 0;            ///< points with a smaller coordinate are below
		int    below = 0, above = 0; ///< a node, or -1 - cell
	};

	CellTree() = default;
	/// points: a sample, reordered; cellNum: at least 1. Cost: O(n log cellNum).
	CellTree(std::vector<Vec3d>& points, int cellNum);
	CellTree(std::vector<Node> nodes, int cellNum) : nodes_(std::move(nodes)), cellNum_(cellNum) {}

	int                      cellNum() const { return cellNum_; }
	const std::vector<Node>& nodes() const { return nodes_; }

	/// The cell of a point, in [0, cellNum). Equal points have equal cells. Cost: O(log cellNum).
	int cellOf(const Vec3d& p) const;

private:
	std::vector<Node> nodes_; ///< the first is the root
	int               cellNum_ = 1;

	int build(std::vector<Vec3d>& points, std::size_t begin, std::size_t end, int firstCell,
			  int cellNum);
};

} // namespace gpr::app

#endif
