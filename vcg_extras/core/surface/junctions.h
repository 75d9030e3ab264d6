// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_JUNCTIONS_H
#define VCG_EXTRAS_CORE_SURFACE_JUNCTIONS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace gpr {

/// Junctions of a mesh with its sheets cut apart: places at which several borders lie with equal
/// positions, edge by edge, and the `meetings`, places at which vertices of several sheets were
/// equal in the input. The vertices at such a place are copies of each other: joining the sheets
/// turns all copies into the same vertex.
///
///     points   at the ends and forks of lines, at changes of sheets, at vertices shared by sheets
///     lines    from point to point, or loops; each with the number of sheets at the line
///
/// Two meshes have the same junctions if the points have equal positions and lines with equal
/// numbers of sheets join the same points.
class Junctions {
public:
	/// meetings: positions in ascending order, see IndexedMesh. Cost: a parallel pass over the
	/// mesh, and O(B log B) for B border vertices, serial.
	Junctions(const HalfEdgeMesh& mesh, const std::vector<Vec3f>& meetings, Workers& workers);

	bool isSameAs(const Junctions& other) const;

	/// Per vertex its first copy: for most vertices the vertex itself.
	const std::vector<int>& first() const { return first_; }
	/// Number of vertices that go when the sheets are joined.
	int copyNum() const { return copyNum_; }
	/// All copies at meetings with a copy off the junction edges, ascending: there nothing but the
	/// vertices holds the sheets together.
	std::vector<int> touchingVertices() const;
	/// Half-edges, one for each edge inside of a sheet that would coincide with another edge in the
	/// joined mesh.
	std::vector<int> falseEdges(Workers& workers) const;
	/// Whether two faces of the joined mesh would have the same vertices.
	bool hasTwinFaces(Workers& workers) const;

private:
	using Ends = std::pair<int, int>; ///< first vertices of two places, ascending
	/// The two points, the smaller first, or -1 twice for a loop; and the number of sheets.
	using Line = std::tuple<int, int, int>;
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
	std::vector<Vec3f>   points_;    ///< ascending
	std::vector<Line>    lines_;     ///< ascending
	int                  copyNum_ = 0;

	void findPlaces(const std::vector<Vec3f>& meetings, Workers& workers);
	void findEdges();
	void dropChanceMeetings();
	void findTouching();
	bool isOfPlace(int v) const { return places_.count(first_[v]) > 0; }
	bool isJunctionEdge(int v, int w) const;
	bool isPoint(const Place& place) const;
	int  sheetNum(int from, int to) const { return borderNum_.at(std::minmax(from, to)); }
	void findLines();
	Line followLine(int from, int to, std::map<Ends, bool>& seen,
					const std::map<int, int>& pointOf) const;
};

} // namespace gpr

#endif
