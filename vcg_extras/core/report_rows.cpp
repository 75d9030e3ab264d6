// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_rows.h"

namespace gpr {

std::vector<CountRow> describe(const CleanCounts& c)
{
	return {
		{"nonFiniteVertices", c.nonFiniteVertices, "vertex without finite coordinates dropped",
		 "vertices without finite coordinates dropped"},
		{"unreferencedVertices", c.unreferencedVertices, "unused vertex dropped",
		 "unused vertices dropped"},
		{"weldedVertices", c.weldedVertices, "vertex welded", "vertices welded"},
		{"contractedEdges", c.contractedEdges, "edge without length contracted",
		 "edges without length contracted"},
		{"sewnEdges", c.sewnEdges, "edge of seams sewn", "edges of seams sewn"},
		{"sharedBorderEdges", c.sharedBorderEdges,
		 "border edge left cut at a place of several borders",
		 "border edges left cut at a place of several borders"},
		{"repeatedIndexFaces", c.repeatedIndexFaces, "face with a repeated vertex dropped",
		 "faces with a repeated vertex dropped"},
		{"zeroAreaFaces", c.zeroAreaFaces, "degenerate face dropped", "degenerate faces dropped"},
		{"duplicateFaces", c.duplicateFaces, "duplicate face dropped", "duplicate faces dropped"},
		{"reorientedFaces", c.reorientedFaces, "face reoriented", "faces reoriented"},
		{"nonManifoldEdges", c.nonManifoldEdges, "non-manifold edge cut", "non-manifold edges cut"},
		{"nonManifoldVertices", c.nonManifoldVertices, "non-manifold vertex cut",
		 "non-manifold vertices cut"},
		{"nonOrientableCuts", c.nonOrientableCuts, "edge cut to make the surface orientable",
		 "edges cut to make the surface orientable"},
		{"droppedComponents", c.droppedComponents, "small component dropped",
		 "small components dropped"},
		{"droppedFaces", c.droppedFaces},
		{"longEdgesSplit", c.longEdgesSplit},
	};
}

} // namespace gpr
