// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "connect.h"

#include "edge_sides.h"
#include "mesh_edit.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace gpr {

namespace {

/// The half-edges at their smaller end in one direction. Nearly all vertices have fewer than there
/// is room for.
struct Spokes {
	static constexpr int room = 16;
	struct Spoke {
		int other; ///< the larger end
		int halfEdge;
	};
	Spoke at[room];
	int   num = 0; ///< may exceed the room

	void add(int other, int halfEdge)
	{
		if (num < room) at[num] = {other, halfEdge};
		++num;
	}
	/// Whether two spokes have the same other end.
	bool hasTwins() const
	{
		bool twins = false;
		for (int i = 1; i < num; ++i) {
			for (int k = 0; k < i; ++k)
				twins |= at[i].other == at[k].other;
		}
		return twins;
	}
	/// Appends half-edges without an opposite.
	void addUnpaired(const Buffer<int>& opposite, std::vector<int>& out) const
	{
		for (int i = 0; i < num; ++i) {
			if (opposite[at[i].halfEdge] < 0) out.push_back(at[i].halfEdge);
		}
	}
};

void lowerTo(int& place, int value)
{
	int seen = __atomic_load_n(&place, __ATOMIC_RELAXED);
	while ((seen < 0 || value < seen) &&
		   !__atomic_compare_exchange_n(&place, &seen, value, true, __ATOMIC_RELAXED,
										__ATOMIC_RELAXED)) {}
}

/// Pairs half-edges at their smaller ends, and finds a half-edge leaving each vertex, in one pass:
/// a border half-edge, if any; else a half-edge of the vertex' own faces; for a vertex without own
/// faces the smallest half-edge.
class HalfEdgePairing {
public:
	HalfEdgePairing(const IndexedMesh& mesh, const Buffer<int>& faceStart, Workers& workers,
					HalfEdgeMesh& m) :
			mesh_(mesh),
			faceStart_(faceStart), workers_(workers), m_(m)
	{
	}

	/// Fills m.opposite. If the mesh is manifold, fills m.outgoing too and returns true.
	bool run()
	{
		listThirds();
		m_.opposite.reset(std::size_t(3) * mesh_.faceNum);
		leaveByOwnFaces();

		std::atomic<bool>      isManifold{true};
		const std::vector<int> border =
			workers_.collectEach<int>(mesh_.vertexNum, [&](int v, std::vector<int>& out) {
				if (!pairFew(v, out) && !pairMany(v, out)) isManifold = false;
			});
		for (int h : border)
			m_.outgoing[mesh_.triangle[h]] = h;
		return isManifold;
	}

private:
	const IndexedMesh& mesh_;
	const Buffer<int>& faceStart_; ///< per vertex: its own faces, with the vertex as first corner
	Workers&           workers_;
	HalfEdgeMesh&      m_;
	/// Lists of the faces by the smaller end of their second half-edge: the first face per vertex,
	/// and the next per face, or -1. The pairs do not depend on the order of a list.
	Buffer<int> firstThird_, nextThird_;

	bool hasOwnFaces(int v) const { return faceStart_[v] < faceStart_[v + 1]; }

	void listThirds()
	{
		firstThird_.reset(mesh_.vertexNum);
		nextThird_.reset(mesh_.faceNum);
		workers_.forEach(mesh_.vertexNum, [&](int v) { firstThird_[v] = -1; });
		workers_.forEach(mesh_.faceNum, [&](int f) {
			const int end = std::min(mesh_.triangle[3 * f + 1], mesh_.triangle[3 * f + 2]);
			nextThird_[f] = __atomic_exchange_n(&firstThird_[end], f, __ATOMIC_RELAXED);
		});
	}

	void leaveByOwnFaces()
	{
		m_.outgoing.reset(mesh_.vertexNum);
		workers_.forEach(mesh_.vertexNum,
						 [&](int v) { m_.outgoing[v] = hasOwnFaces(v) ? 3 * faceStart_[v] : -1; });
	}

	/// For a vertex without own faces, which several threads may visit.
	void leaveByOther(int v, int h)
	{
		if (!hasOwnFaces(v)) lowerTo(m_.outgoing[v], h);
	}

	/// Calls visit(leaves, other, halfEdge) for the half-edges with smaller end v. Two half-edges
	/// of a face have the first corner as smaller end and are found through faceStart; only the
	/// third half-edge needs a list.
	template <class Visit>
	void forEachSpoke(int v, const Visit& visit)
	{
		for (int f = faceStart_[v]; f < faceStart_[v + 1]; ++f) {
			const int a = mesh_.triangle[3 * f + 1], b = mesh_.triangle[3 * f + 2];
			visit(true, a, 3 * f);
			visit(false, b, 3 * f + 2);
			leaveByOther(a, 3 * f + 1);
			leaveByOther(b, 3 * f + 2);
		}
		for (int f = firstThird_[v]; f >= 0; f = nextThird_[f]) {
			const int h = 3 * f + 1;
			const int a = mesh_.triangle[h], b = mesh_.triangle[h + 1];
			visit(a == v, a == v ? b : a, h);
		}
	}

	/// Pairs the half-edges with smaller end v, and appends the half-edges of the border. Returns
	/// false, and leaves the pairs to pairMany, at vertices with many neighbours and at edges with
	/// more than two faces, or two faces in the same direction.
	bool pairFew(int v, std::vector<int>& border)
	{
		Spokes leaving, coming;
		forEachSpoke(
			v, [&](bool leaves, int other, int h) { (leaves ? leaving : coming).add(other, h); });
		if (leaving.num > Spokes::room || coming.num > Spokes::room) return false;
		bool      hasTwins = false;
		const int pairNum  = pairAll(leaving, coming, hasTwins);
		// If all half-edges have partners, twins have the same partner.
		if (pairNum == leaving.num && pairNum == coming.num) return !hasTwins;
		if (hasTwins || leaving.hasTwins() || coming.hasTwins()) return false;
		leaving.addUnpaired(m_.opposite, border);
		coming.addUnpaired(m_.opposite, border);
		return true;
	}

	/// Returns the number of half-edges that come from a leaving half-edge's other end; hasTwins:
	/// whether two come from the same. Most vertices have three edges here, for which comparing
	/// every leaving with every coming half-edge is faster than sorting.
	int pairAll(const Spokes& leaving, const Spokes& coming, bool& hasTwins)
	{
		for (int i = 0; i < leaving.num; ++i)
			m_.opposite[leaving.at[i].halfEdge] = -1;
		unsigned paired  = 0; // a bit per leaving half-edge
		int      pairNum = 0;
		for (int k = 0; k < coming.num; ++k) {
			const Spokes::Spoke& spoke   = coming.at[k];
			int                  partner = -1;
			for (int i = 0; i < leaving.num; ++i)
				partner = leaving.at[i].other == spoke.other ? i : partner;
			m_.opposite[spoke.halfEdge] = partner < 0 ? -1 : leaving.at[partner].halfEdge;
			if (partner < 0) continue;
			m_.opposite[leaving.at[partner].halfEdge] = spoke.halfEdge;
			hasTwins |= (paired >> partner & 1) != 0;
			paired |= 1u << partner;
			++pairNum;
		}
		return pairNum;
	}

	/// As pairFew, for any vertex; false if an edge has more than two faces, or two faces in the
	/// same direction.
	bool pairMany(int v, std::vector<int>& border)
	{
		std::vector<EdgeSide> sides;
		forEachSpoke(v, [&](bool, int other, int h) { sides.push_back(edgeSide(v, other, h)); });
		std::sort(sides.begin(), sides.end());
		bool isManifold = true;
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			const int  g = sides[begin].halfEdge, h = sides[end - 1].halfEdge;
			const bool isPair = end - begin == 2 && mesh_.triangle[g] != mesh_.triangle[h];
			for (std::size_t k = begin; k < end; ++k)
				m_.opposite[sides[k].halfEdge] = isPair ? g + h - sides[k].halfEdge : -1;
			if (end - begin == 1) border.push_back(g);
			isManifold = isManifold && (isPair || end - begin == 1);
		});
		return isManifold;
	}
};

/// The findings of a walk round a vertex, face by face.
class Turn {
public:
	/// Adds the next face, given by its two edges from the vertex.
	void add(const Float4& a, const Float4& b)
	{
		const Float4    normal = cross(a, b);
		const Face      face   = {normal, length(normal)};
		const float     longer = std::max(dot(a, a), dot(b, b));
		constexpr float narrow = 2 * roughWidth; // the third edge may be twice as long
		isRough_ |= face.area * face.area <= narrow * narrow * longer;
		isRough_ |= meetSharply(last_, face);
		sum_ += face.cross;
		area_ += face.area;
		if (cornerNum_++ == 0) first_ = face;
		last_ = face;
	}

	int  cornerNum() const { return cornerNum_; }
	bool isPointed() const { return length(sum_) < pointedSpread * area_; }
	/// Compares the last and first face even at a border: a needless mark does no harm.
	bool isRough() const { return isRough_ || meetSharply(last_, first_); }

	PackedNormal normal() const
	{
		PackedNormal packed(normalized(sum_.xyz()));
		if (isPointed()) packed.markPointed();
		if (isRough()) packed.markRough();
		return packed;
	}
	/// A third of the area of the faces.
	PackedMeasure area() const { return PackedMeasure(area_ / 6); }
	RingSum       ring() const { return {sum_.xyz(), area_}; }

private:
	struct Face {
		Float4 cross;
		float  area = 0; ///< twice
	};
	Face   first_, last_;
	Float4 sum_;
	float  area_      = 0;
	int    cornerNum_ = 0;
	bool   isRough_   = false;

	static bool meetSharply(const Face& a, const Face& b)
	{
		constexpr float cosine = 0.8660254f; // of roughDeg
		static_assert(roughDeg == 30);
		return dot(a.cross, b.cross) < cosine * a.area * b.area;
	}
};

/// Computes vertex normals, marks and areas by walks round every vertex. Returns whether every
/// vertex has a single fan: the walks then visit all corners. Marking here saves a second pass,
/// which would cost as much.
bool measureVertices(Workers& workers, Surface& surface, bool keepsRings)
{
	const HalfEdgeMesh& m = surface.mesh;
	surface.normal.reset(m.vertexNum);
	surface.area.reset(m.vertexNum);
	if (keepsRings) surface.ring.reset(m.vertexNum);
	const std::int64_t seen = workers.sumEach<std::int64_t>(
		m.vertexNum, [&](int v, std::int64_t& corners) { corners += measureVertex(v, surface); });
	return seen == std::int64_t(m.halfEdgeNum());
}

} // namespace

bool connect(IndexedMesh& mesh, const Buffer<int>& faceStart, Workers& workers, Surface& surface,
			 bool keepsRings)
{
	HalfEdgeMesh& m = surface.mesh;
	if (!HalfEdgePairing(mesh, faceStart, workers, m).run()) return false;
	m.vertexNum = mesh.vertexNum;
	m.faceNum   = mesh.faceNum;
	m.position.swap(mesh.position);
	m.origin.swap(mesh.triangle);
	if (!measureVertices(workers, surface, keepsRings)) {
		m.position.swap(mesh.position);
		m.origin.swap(mesh.triangle);
		return false;
	}
	surface.sourceFace.swap(mesh.sourceFace);
	surface.size.swap(mesh.size);
	surface.meetings.swap(mesh.meetings);
	surface.frame = mesh.frame;
	return true;
}

Buffer<char> findNotManifold(const IndexedMesh& mesh, const Buffer<int>& opposite, Workers& workers)
{
	// A walk begins at a border half-edge, if any. With several fans any begin will do.
	const std::size_t halfEdgeNum = std::size_t(3) * mesh.faceNum;
	Buffer<int>       outgoing(mesh.vertexNum, -1);
	Buffer<char>      seen(halfEdgeNum), bad(mesh.vertexNum, 0);
	workers.forEach(halfEdgeNum, [&](int h) {
		seen[h] = 0;
		__atomic_store_n(&outgoing[mesh.triangle[h]], h, __ATOMIC_RELAXED);
	});
	workers.forEach(halfEdgeNum, [&](int h) {
		if (opposite[h] < 0) __atomic_store_n(&outgoing[mesh.triangle[h]], h, __ATOMIC_RELAXED);
	});
	workers.forEach(mesh.vertexNum, [&](int v) {
		for (int h = outgoing[v]; h >= 0 && !seen[h]; h = opposite[prevInFace(h)])
			seen[h] = 1;
	});
	workers.forEach(halfEdgeNum, [&](int h) {
		if (!seen[h]) __atomic_store_n(&bad[mesh.triangle[h]], char(1), __ATOMIC_RELAXED);
	});
	return bad;
}

int measureVertex(int v, Surface& surface)
{
	Turn turn;
	forEachFaceRound(surface.mesh, v,
					 [&](int, const Float4& a, const Float4& b) { turn.add(a, b); });
	surface.normal[v] = turn.normal();
	surface.area[v]   = turn.area();
	if (!surface.ring.empty()) surface.ring[v] = turn.ring();
	return turn.cornerNum();
}

IndexedMesh disconnect(Surface& surface)
{
	IndexedMesh mesh;
	mesh.frame      = surface.frame;
	mesh.vertexNum  = surface.mesh.vertexNum;
	mesh.faceNum    = surface.mesh.faceNum;
	mesh.position   = std::move(surface.mesh.position);
	mesh.triangle   = std::move(surface.mesh.origin);
	mesh.sourceFace = std::move(surface.sourceFace);
	mesh.size       = std::move(surface.size);
	mesh.meetings   = std::move(surface.meetings);
	surface         = Surface();
	surface.frame   = mesh.frame;
	return mesh;
}

Surface copyOf(const Surface& from, Workers& workers)
{
	Surface to;
	to.mesh       = copyMesh(from.mesh, workers);
	to.sourceFace = copyOf(from.sourceFace, workers);
	to.normal     = copyOf(from.normal, workers);
	to.area       = copyOf(from.area, workers);
	to.size       = copyOf(from.size, workers);
	to.meetings   = from.meetings;
	to.frame      = from.frame;
	to.grid       = from.grid;
	return to;
}

} // namespace gpr
