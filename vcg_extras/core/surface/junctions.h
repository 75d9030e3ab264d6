// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_JUNCTIONS_H
#define VCG_EXTRAS_CORE_SURFACE_JUNCTIONS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <map>
#include <utility>
#include <vector>

namespace gpr {

/// Junctions of a mesh whose sheets were cut apart: where several borders lie at one place, edge by
/// edge with equal numbers, and at the `meetings`, where vertices of several sheets were one. The
/// vertices there are copies of each other, and become one when the sheets are joined.
///
///     points   where junction lines end, fork or change their sheets, and where sheets touch
///     lines    from point to point, or loops; each with the number of sheets that meet there
///
/// Two meshes have the same junctions where the points lie at the same places and the lines join
/// them alike.
class Junctions {
public:
	struct Line {
		int from = -1, to = -1; ///< points, the smaller first; -1: a loop
		int sheetNum = 0;

		bool operator<(const Line& o) const;
		bool operator==(const Line& o) const;
	};

	/// meetings: places in ascending order, see IndexedMesh. Cost: a parallel pass over the mesh,
	/// and O(B log B) for B vertices of the border, serial.
	Junctions(const HalfEdgeMesh& mesh, const std::vector<Vec3f>& meetings, Workers& workers);

	const std::vector<Vec3f>& points() const { return points_; } ///< ascending
	const std::vector<Line>&  lines() const { return lines_; }   ///< ascending
	int                       edgeNum() const { return edgeNum_; }
	bool                      isSameAs(const Junctions& other) const;

	/// Per vertex the first one that becomes one with it: itself for most.
	const std::vector<int>& first() const { return first_; }
	/// How many vertices go when the sheets are joined.
	int copyNum() const { return copyNum_; }
	/// The copies at meetings of which some do not lie on a junction's edges, ascending: nothing
	/// but these vertices themselves holds the sheets together there.
	std::vector<int> touchingVertices() const;
	/// Half-edges, one for each edge inside of a sheet, that would become one with an edge of
	/// another when the sheets are joined.
	std::vector<int> falseEdges(Workers& workers) const;
	/// Whether two faces would have the same vertices.
	bool hasTwinFaces(Workers& workers) const;

private:
	using Ends = std::pair<int, int>; ///< first vertices of two places, ascending
	/// A place with copies.
	struct Place {
		std::vector<int> vertices;
		std::vector<int> next; ///< the other ends of junction edges
		bool             isMeeting  = false;
		bool             isTouching = false; ///< see touchingVertices
	};

	const HalfEdgeMesh&  m_;
	std::vector<int>     first_;
	std::map<int, Place> places_;    ///< by the first vertex
	std::map<Ends, int>  borderNum_; ///< of borders between two places with copies
	std::vector<Vec3f>   points_;
	std::vector<Line>    lines_;
	int                  edgeNum_ = 0, copyNum_ = 0;

	void findPlaces(const std::vector<Vec3f>& meetings, Workers& workers);
	void findEdges();
	void dropChanceMeetings();
	void findTouching();
	bool isJunctionEdge(int v, int w) const;
	bool isPoint(const Place& place) const;
	int  sheetNum(int from, int to) const { return borderNum_.at(std::minmax(from, to)); }
	void findLines();
	Line followLine(int from, int to, std::map<Ends, bool>& seen,
					const std::map<int, int>& pointOf) const;
};

} // namespace gpr

#endif
