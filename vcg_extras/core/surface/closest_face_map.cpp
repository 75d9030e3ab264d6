// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "closest_face_map.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/face_plane.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpr {

namespace {

/// Factor on the squared distance of a face with the opposite orientation.
constexpr float wrongSide = 4;
/// Most triangles crossed on the way to the triangle over a vertex; then stars are searched.
constexpr int maxSteps = 8;
/// A vertex over a triangle belongs to this triangle up to this squared height, as a share of twice
/// the triangle's area: a higher vertex may have a nearer triangle beyond a crease.
constexpr float overShare = 0.04f;
/// A vertex at a larger squared distance, as a share of twice the triangle's area, may be a stray:
/// half an edge.
constexpr float strayShare = 0.3f;
/// Most stars searched.
constexpr int maxHops = 4;
/// Vertices that are flooded together: pieces of fixed size for any number of threads.
constexpr int pieceSize = 16384;
/// The entry of a vertex that has left the list of a face.
constexpr int gone = -1;

/// A vertex of the working surface, and its new label: a vertex or a face of the result.
struct Labelled {
	int vertex, label;
};

/// Labels each vertex of the working surface by a vertex of the result near by: a breadth-first
/// flood from all surface points at once, within pieces of consecutive vertices. From piece to
/// piece go offers, all made before any is taken. -1 for vertices that the flood does not reach.
/// The same labels for any number of threads.
class PointFlood {
public:
	PointFlood(const Surface& surface, const ResultMesh& result, Workers& workers) :
			m_(surface.mesh), r_(result), workers_(workers),
			pieceNum_((m_.vertexNum + pieceSize - 1) / pieceSize), label_(m_.vertexNum),
			left_(pieceNum_), offers_(pieceNum_)
	{
	}

	Buffer<int> run()
	{
		floodFromSeeds();
		// Each round but the last labels a vertex, so that the rounds end.
		while (makeOffers())
			takeOffers();
		return std::move(label_);
	}

private:
	const HalfEdgeMesh&                m_;
	const ResultMesh&                  r_;
	Workers&                           workers_;
	std::size_t                        pieceNum_;
	Buffer<int>                        label_;
	std::vector<std::vector<int>>      left_;   ///< per piece: vertices without a label
	std::vector<std::vector<Labelled>> offers_; ///< per piece

	/// Seeds are the corners of the surface points' faces, numbered by vertex of the result and
	/// corner.
	int seedVertex(std::size_t seed) const
	{
		return m_.origin[3 * r_.vertex[seed / 3].point.face + seed % 3];
	}

	int beginOf(std::size_t piece) const { return int(piece) * pieceSize; }
	int endOf(std::size_t piece) const
	{
		return std::min(m_.vertexNum, int(piece) * pieceSize + pieceSize);
	}

	void floodFromSeeds()
	{
		Buffer<int> start, seed;
		const auto  pieceOf = [&](std::size_t i) { return seedVertex(i) / pieceSize; };
		sortIntoBuckets(3 * r_.vertex.size(), pieceNum_, pieceOf, workers_, start, seed);
		workers_.forTasks(pieceNum_, [&](std::size_t piece, int) {
			std::fill(label_.data() + beginOf(piece), label_.data() + endOf(piece), -1);
			std::vector<int> queue;
			for (int i = start[piece]; i < start[piece + 1]; ++i)
				take(seedVertex(seed[i]), seed[i] / 3, queue);
			flood(piece, queue);
			for (int v = beginOf(piece); v < endOf(piece); ++v) {
				if (label_[v] < 0) left_[piece].push_back(v);
			}
		});
	}

	void take(int v, int label, std::vector<int>& queue)
	{
		if (label_[v] >= 0) return;
		label_[v] = label;
		queue.push_back(v);
	}

	void flood(std::size_t piece, std::vector<int>& queue)
	{
		const int begin = beginOf(piece), end = endOf(piece);
		for (std::size_t i = 0; i < queue.size(); ++i) {
			const int label = label_[queue[i]];
			forEachNeighbour(m_, queue[i], [&](int w) {
				if (w >= begin && w < end) take(w, label, queue);
			});
		}
	}

	bool makeOffers()
	{
		workers_.forTasks(pieceNum_, [&](std::size_t piece, int) {
			offers_[piece].clear();
			for (int v : left_[piece]) {
				int best = -1;
				forEachNeighbour(m_, v, [&](int w) { best = std::max(best, label_[w]); });
				if (best >= 0) offers_[piece].push_back({v, best});
			}
		});
		for (const std::vector<Labelled>& o : offers_) {
			if (!o.empty()) return true;
		}
		return false;
	}

	void takeOffers()
	{
		workers_.forTasks(pieceNum_, [&](std::size_t piece, int) {
			if (offers_[piece].empty()) return;
			std::vector<int> queue;
			for (const Labelled& o : offers_[piece])
				take(o.vertex, o.label, queue);
			flood(piece, queue);
			std::vector<int>& left = left_[piece];
			left.erase(
				std::remove_if(left.begin(), left.end(), [&](int v) { return label_[v] >= 0; }),
				left.end());
		});
	}
};

/// Whether a vertex lies over a triangle, and near enough to belong to the triangle.
bool isOver(const FacePlane& plane, const Vec3f& at, const Vec3f& normal)
{
	return plane.looksAlong(normal) && plane.footOf(at).isInside() &&
		   plane.squaredHeight(at) <= overShare * length(plane.areaNormal());
}

Buffer<FacePlane> planesOf(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<FacePlane> planes(std::size_t(m.faceNum));
	workers.forEach(planes.size(), [&](int f) { planes[f] = FacePlane(m, f); });
	return planes;
}

/// Finds the triangle of the result to which a vertex of the working surface belongs.
class TriangleSearch {
public:
	/// planes: of all faces, for many searches; empty: a plane is made for each look at a face.
	TriangleSearch(const Surface& surface, const HalfEdgeMesh& result,
				   Buffer<FacePlane> planes = {}) :
			surface_(surface),
			m_(result), planes_(std::move(planes))
	{
	}

	struct Found {
		int   face;
		Foot  foot;
		float distance;       ///< squared; × wrongSide for a face with the opposite orientation
		bool  isOver = false; ///< the face has the same orientation, and the vertex lies over the
							  ///< face and near
	};

	/// Whether the face has the opposite orientation, or lies so far from vertex p that the vertex
	/// may belong to another part of the result.
	bool isStray(int p, int face) const
	{
		const FacePlane plane = planeOf(face);
		const Vec3f     at    = surface_.mesh.position[p];
		if (!plane.looksAlong(surface_.normal[p].unpack())) return true;
		return plane.squaredDistance(at, plane.nearestFoot(at)) >
			   strayShare * length(plane.areaNormal());
	}

	/// Walks from a face towards the triangle over p, as point location in the plane does. Such a
	/// walk may find no triangle, as at creases and cone apexes: then the stars at its end are
	/// searched. The walk may also end far off, as beyond a crease: then the stars at the first
	/// face are searched too.
	Found locate(int p, int face) const
	{
		const Vec3f at     = surface_.mesh.position[p];
		const Vec3f normal = surface_.normal[p].unpack();
		const int   start  = face;
		Foot        foot{{1, 0, 0}};
		for (int step = 0; step < maxSteps; ++step) {
			const FacePlane plane = planeOf(face);
			if (!plane.looksAlong(normal)) break;
			foot = plane.footOf(at);
			if (foot.isInside()) {
				const float off = plane.squaredHeight(at);
				if (off <= overShare * length(plane.areaNormal())) return {face, foot, off, true};
				return nearer(searchStars(at, normal, m_.origin[3 * face + foot.heaviest()]),
							  searchStars(at, normal, m_.origin[3 * start]));
			}
			const int beyond = m_.opposite[3 * face + (foot.lightest() + 1) % 3];
			if (beyond < 0) break;
			face = beyond / 3;
		}
		return searchStars(at, normal, m_.origin[3 * face + foot.heaviest()]);
	}

private:
	const Surface&      surface_;
	const HalfEdgeMesh& m_;
	Buffer<FacePlane>   planes_;

	FacePlane planeOf(int face) const
	{
		return planes_.empty() ? FacePlane(m_, face) : planes_[face];
	}

	static Found nearer(const Found& a, const Found& b) { return b.distance < a.distance ? b : a; }

	/// The nearest triangle round a vertex, and then round the corner nearest to the point found.
	Found searchStars(const Vec3f& at, const Vec3f& normal, int vertex) const
	{
		Found best{m_.outgoing[vertex] / 3, {{1, 0, 0}}, std::numeric_limits<float>::infinity()};
		for (int hop = 0; hop < maxHops; ++hop) {
			forEachOutgoing(m_, vertex, [&](int h) { tryFace(at, normal, h / 3, best); });
			const int next = m_.origin[3 * best.face + best.foot.heaviest()];
			if (next == vertex) break;
			vertex = next;
		}
		return best;
	}

	void tryFace(const Vec3f& at, const Vec3f& normal, int face, Found& best) const
	{
		const FacePlane plane    = planeOf(face);
		const Foot      foot     = plane.nearestFoot(at);
		float           distance = plane.squaredDistance(at, foot);
		if (dot(plane.areaNormal(), normal) < 0)
			distance = wrongSide * distance + std::numeric_limits<float>::min();
		if (distance < best.distance) best = {face, foot, distance};
	}
};

/// Corrects strays of the flood, which counts edges, not lengths: along needles the flood may come
/// to the far side of a plate first, and walks from there do not return. A stray is searched again
/// from the faces of its neighbours, ring by ring, beginning beside vertices that are no strays.
class StrayReturn {
public:
	/// face: per vertex of the working surface; -1 for no face.
	StrayReturn(const HalfEdgeMesh& input, const TriangleSearch& search, Buffer<int>& face,
				Workers& workers) :
			m_(input),
			search_(search), face_(face), workers_(workers)
	{
	}

	/// front: the strays.
	void run(std::vector<int> front)
	{
		if (!front.empty()) isStray_.assign(std::size_t(m_.vertexNum), 0);
		for (int p : front)
			isStray_[p] = 1;
		while (!front.empty())
			front = takeRing(front);
	}

private:
	const HalfEdgeMesh&   m_;
	const TriangleSearch& search_;
	Buffer<int>&          face_;
	Workers&              workers_;
	std::vector<char>     isStray_;

	/// Returns the strays beside the vertices corrected now.
	std::vector<int> takeRing(const std::vector<int>& front)
	{
		// All searches read the faces of the round before: the same bits for any number of threads.
		const std::vector<Labelled> back =
			workers_.collectEach<Labelled>(front.size(), [&](int i, auto& out) {
				const int face = nearestByNeighbours(front[i]);
				if (!search_.isStray(front[i], face)) out.push_back({front[i], face});
			});
		std::vector<int> beside;
		for (const Labelled& b : back) {
			face_[b.vertex]    = b.label;
			isStray_[b.vertex] = 0;
		}
		for (const Labelled& b : back) {
			forEachNeighbour(m_, b.vertex, [&](int q) {
				if (isStray_[q]) beside.push_back(q);
			});
		}
		sortUnique(beside);
		return beside;
	}

	/// The nearest face found from the faces of neighbours that are no strays; without such
	/// neighbours the present face.
	int nearestByNeighbours(int p) const
	{
		TriangleSearch::Found best{face_[p], {{1, 0, 0}}, HUGE_VALF};
		forEachNeighbour(m_, p, [&](int q) {
			if (face_[q] < 0 || isStray_[q]) return;
			const TriangleSearch::Found found = search_.locate(p, face_[q]);
			if (found.distance < best.distance) best = found;
		});
		return best.face;
	}
};

/// The face of each vertex of the working surface; -1 for vertices reached by no surface point.
Buffer<int> findFaces(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	const HalfEdgeMesh&    m    = result.mesh;
	Buffer<int>            face = PointFlood(surface, result, workers).run();
	const TriangleSearch   search(surface, m, planesOf(m, workers));
	const std::vector<int> strays = workers.collectIf(face.size(), [&](int p) {
		if (face[p] < 0) return false;
		const TriangleSearch::Found found = search.locate(p, m.outgoing[face[p]] / 3);
		face[p]                           = found.face;
		return !found.isOver && search.isStray(p, found.face);
	});
	StrayReturn(surface.mesh, search, face, workers).run(strays);
	return face;
}

/// Takes the vertices that change their face out of the lists. Goes face by face: the terms of the
/// barycentric weights are computed once for all vertices of a face. Nearly all of these vertices
/// still lie over the face.
std::vector<Labelled> takeLeavers(const Surface& surface, const HalfEdgeMesh& result,
								  const Buffer<int>& start, Buffer<int>& item, Workers& workers)
{
	const TriangleSearch search(surface, result);
	return workers.collectEach<Labelled>(result.faceNum, [&](int f, auto& out) {
		const FacePlane plane(result, f);
		for (int i = start[f]; i < start[f + 1]; ++i) {
			const int p = item[i];
			if (isOver(plane, surface.mesh.position[p], surface.normal[p].unpack())) continue;
			const int to = search.locate(p, f).face;
			if (to == f) continue;
			out.push_back({p, to});
			item[i] = gone;
		}
	});
}

/// The new list of a face: first the vertices that stayed, then the new vertices.
void takeIn(const std::vector<Labelled>& leavers, Workers& workers, Buffer<int>& start,
			Buffer<int>& item)
{
	const std::size_t faceNum = start.size() - 1;
	Buffer<int>       comingStart, coming;
	sortIntoBuckets(
		leavers.size(), faceNum, [&](std::size_t i) { return leavers[i].label; }, workers,
		comingStart, coming);
	Buffer<int> newStart(faceNum + 1);
	workers.forEach(faceNum, [&](int f) {
		const int* const begin = item.data() + start[f];
		const int* const end   = item.data() + start[f + 1];
		newStart[f] =
			int(end - begin - std::count(begin, end, gone)) + comingStart[f + 1] - comingStart[f];
	});
	newStart[faceNum] = 0;
	workers.sumUp(newStart.data(), faceNum + 1); // now the end of each list
	Buffer<int> newItem(item.size());
	workers.forEach(faceNum, [&](int f) {
		int* to = newItem.data() + newStart[f];
		for (int i = comingStart[f + 1]; i > comingStart[f]; --i)
			*--to = leavers[coming[i - 1]].vertex;
		for (int i = start[f + 1]; i > start[f]; --i) {
			if (item[i - 1] != gone) *--to = item[i - 1];
		}
		newStart[f] = int(to - newItem.data());
	});
	start.swap(newStart);
	item.swap(newItem);
}

} // namespace

ClosestFaceMap::ClosestFaceMap(const Surface& surface, const ResultMesh& result, Workers& workers) :
		surface_(surface)
{
	const Buffer<int> face   = findFaces(surface, result, workers);
	const auto        faceOf = [&](std::size_t p) { return face[p]; };
	sortIntoBuckets(face.size(), result.mesh.faceNum, faceOf, workers, start_, item_);
}

void ClosestFaceMap::update(const ResultMesh& result, Workers& workers)
{
	takeIn(takeLeavers(surface_, result.mesh, start_, item_, workers), workers, start_, item_);
}

} // namespace gpr
