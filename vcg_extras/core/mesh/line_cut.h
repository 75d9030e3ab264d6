// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_LINE_CUT_H
#define VCG_EXTRAS_CORE_MESH_LINE_CUT_H

#include "connect.h"

#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// A surface cut along feature lines, which are borders as long as this object lives. Each vertex
/// of a line gets a copy for each further sector between lines, after the old vertices. Faces and
/// half-edges keep their numbers. The cut changes the mesh in place, because a copy would take as
/// much memory as the mesh; positions, outgoing half-edges and rings get room for the copies.
class LineCut {
public:
	/// lines: per half-edge, set at both halves of an edge; empty: nothing is cut. Cost: a pass
	/// over the marks and the positions, parallel.
	LineCut(Surface& surface, const Buffer<char>& lines, Workers& workers);
	~LineCut() { close(); }
	LineCut(const LineCut&)            = delete;
	LineCut& operator=(const LineCut&) = delete;

	/// Per copy: its old vertex.
	const std::vector<int>& copyOf() const { return copyOf_; }
	/// Makes the surface as it was before, but for the room.
	void close();

private:
	/// What the cut changes at a half-edge and at a vertex of a line.
	struct Side {
		int halfEdge, opposite;
	};
	struct LineVertex {
		int     vertex, outgoing;
		RingSum ring;
	};
	Surface&                surface_;
	std::vector<Side>       side_;
	std::vector<LineVertex> onLine_;
	std::vector<int>        copyOf_;

	void addCopies(const std::vector<int>& first);
	void measureRings();
};

} // namespace gpr

#endif
