// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "connect.h"

#include "edge_sides.h"
#include "mesh_edit.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <tuple>
#include <vector>

namespace gpr {

namespace {

/// A half-edge at its smaller end: the other end, and the direction.
struct Spoke {
	int  other;
	bool leaves;
	int  halfEdge;

	bool isOfSameEdge(const Spoke& o) const { return other == o.other; }
	bool operator<(const Spoke& o) const
	{
		return std::tie(other, leaves, halfEdge) < std::tie(o.other, o.leaves, o.halfEdge);
	}
};

/// The spokes of a vertex in one direction.
struct Spokes {
	static constexpr int few = 16; // nearly all vertices have fewer
	struct End {
		int other;
		int halfEdge;
	};
	End end[few];
	int num = 0; ///< may exceed `few`

	/// Whether two spokes have the same other end.
	bool hasTwins() const
	{
		bool twins = false;
		for (int i = 1; i < num; ++i) {
			for (int k = 0; k < i; ++k)
				twins |= end[i].other == end[k].other;
		}
		return twins;
	}
};

/// The spokes of a vertex. Up to `few` a direction lie in plain arrays.
struct SpokeFan {
	Spokes             leaving, coming;
	int                pairNum = 0; ///< pairs found in the plain arrays
	std::vector<Spoke> all;         ///< further spokes; after gatherAll() all spokes

	void clear()
	{
		leaving.num = coming.num = pairNum = 0;
		all.clear();
	}
	/// Adds a spoke to one of the two directions.
	void add(Spokes& spokes, int other, int halfEdge)
	{
		if (spokes.num < Spokes::few)
			spokes.end[spokes.num] = {other, halfEdge};
		else
			all.push_back({other, &spokes == &leaving, halfEdge});
		++spokes.num;
	}
	void gatherAll()
	{
		for (const Spokes* spokes : {&leaving, &coming}) {
			for (int i = 0; i < std::min(spokes->num, Spokes::few); ++i)
				all.push_back({spokes->end[i].other, spokes == &leaving, spokes->end[i].halfEdge});
		}
	}
	/// Appends half-edges without an opposite. Skips the search if the counts show only pairs.
	void addUnpaired(const Buffer<int>& opposite, std::vector<int>& out) const
	{
		const auto addIfUnpaired = [&](int h) {
			if (opposite[h] < 0) out.push_back(h);
		};
		for (const Spoke& s : all)
			addIfUnpaired(s.halfEdge);
		if (!all.empty() || (pairNum == leaving.num && pairNum == coming.num)) return;
		for (const Spokes* spokes : {&leaving, &coming}) {
			for (int i = 0; i < spokes->num; ++i)
				addIfUnpaired(spokes->end[i].halfEdge);
		}
	}
};

/// pairSpokes for vertices with many neighbours, and for edges with more than two faces.
bool pairSortedSpokes(std::vector<Spoke>& spokes, Buffer<int>& opposite)
{
	std::sort(spokes.begin(), spokes.end());
	bool isManifold = true;
	forEachEdge(spokes, [&](std::size_t i, std::size_t end) {
		const bool isPair = end - i == 2 && spokes[i].leaves != spokes[i + 1].leaves;
		isManifold        = isManifold && (isPair || end - i == 1);
		for (std::size_t k = i; k < end; ++k)
			opposite[spokes[k].halfEdge] = -1;
		if (!isPair) return;
		opposite[spokes[i].halfEdge]     = spokes[i + 1].halfEdge;
		opposite[spokes[i + 1].halfEdge] = spokes[i].halfEdge;
	});
	return isManifold;
}

/// Pairs the half-edges with the same smaller end. Returns false if an edge has more than two
/// faces, or two faces in the same direction. Most vertices have three edges here, for which
/// comparing every leaving with every coming half-edge is faster than sorting.
bool pairSpokes(SpokeFan& fan, Buffer<int>& opposite)
{
	const int leavingNum = fan.leaving.num, comingNum = fan.coming.num;
	if (leavingNum > Spokes::few || comingNum > Spokes::few) {
		fan.gatherAll();
		return pairSortedSpokes(fan.all, opposite);
	}
	for (int i = 0; i < leavingNum; ++i)
		opposite[fan.leaving.end[i].halfEdge] = -1;
	unsigned paired   = 0; // a bit per leaving half-edge
	bool     hasTwins = false;
	for (int k = 0; k < comingNum; ++k) {
		const Spokes::End coming  = fan.coming.end[k];
		int               partner = -1;
		for (int i = 0; i < leavingNum; ++i)
			partner = fan.leaving.end[i].other == coming.other ? i : partner;
		if (partner < 0) {
			opposite[coming.halfEdge] = -1;
			continue;
		}
		const int leaving         = fan.leaving.end[partner].halfEdge;
		opposite[coming.halfEdge] = leaving;
		opposite[leaving]         = coming.halfEdge;
		hasTwins |= (paired >> partner & 1) != 0;
		paired |= 1u << partner;
		++fan.pairNum;
	}
	// If all half-edges have partners, twins have the same partner.
	const bool allPaired = fan.pairNum == leavingNum && fan.pairNum == comingNum;
	if (!hasTwins && (allPaired || !(fan.leaving.hasTwins() || fan.coming.hasTwins()))) return true;
	fan.gatherAll();
	return pairSortedSpokes(fan.all, opposite);
}

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
		const std::vector<int> border = workers_.collect<int>(
			mesh_.vertexNum, [&](std::size_t begin, std::size_t end, auto& out) {
				SpokeFan fan;
				for (int v = int(begin); v < int(end); ++v) {
					gather(v, fan);
					if (!pairSpokes(fan, m_.opposite)) isManifold = false;
					fan.addUnpaired(m_.opposite, out);
				}
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

	/// Collects the spokes of v. Two half-edges of a face have the first corner as smaller end and
	/// are found through faceStart; only the third half-edge needs a list.
	void gather(int v, SpokeFan& fan)
	{
		fan.clear();
		for (int f = faceStart_[v]; f < faceStart_[v + 1]; ++f) {
			const int a = mesh_.triangle[3 * f + 1], b = mesh_.triangle[3 * f + 2];
			fan.add(fan.leaving, a, 3 * f);
			fan.add(fan.coming, b, 3 * f + 2);
			leaveByOther(a, 3 * f + 1);
			leaveByOther(b, 3 * f + 2);
		}
		for (int f = firstThird_[v]; f >= 0; f = nextThird_[f]) {
			const int h = 3 * f + 1;
			const int a = mesh_.triangle[h], b = mesh_.triangle[h + 1];
			if (a == v)
				fan.add(fan.leaving, b, h);
			else
				fan.add(fan.coming, a, h);
		}
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
