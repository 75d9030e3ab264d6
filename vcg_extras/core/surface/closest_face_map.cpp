// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "closest_face_map.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>

#include <cmath>
#include <limits>

namespace gpr {

namespace {

/// What looks the other way counts as farther by this factor on squared distances.
constexpr float wrongSide = 4;
/// Triangles crossed at most on the way to the one over a vertex; then stars are searched.
constexpr int maxSteps = 8;
/// A vertex that lies over a triangle belongs to it unless it is this share of twice its area away,
/// squared: beyond a crease there may be a nearer one.
constexpr float overShare = 0.04f;
/// Farther than this share of twice the triangle's area, squared, a vertex may have strayed: half
/// an edge.
constexpr float strayShare = 0.3f;
/// Stars searched at most.
constexpr int maxHops = 4;
/// Vertices that are flooded together: pieces of fixed size, whatever the number of threads.
constexpr int pieceSize = 16384;

/// Breadth-first within pieces of consecutive vertices; from piece to piece by offers that are all
/// made before any is taken. The outcome is the same for any number of threads.
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
	struct Offer {
		int vertex, label;
	};

	const HalfEdgeMesh&             m_;
	const ResultMesh&               r_;
	Workers&                        workers_;
	std::size_t                     pieceNum_;
	Buffer<int>                     label_;
	std::vector<std::vector<int>>   left_;   ///< per piece: vertices without a label
	std::vector<std::vector<Offer>> offers_; ///< per piece

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
		for (const std::vector<Offer>& o : offers_) {
			if (!o.empty()) return true;
		}
		return false;
	}

	void takeOffers()
	{
		workers_.forTasks(pieceNum_, [&](std::size_t piece, int) {
			if (offers_[piece].empty()) return;
			std::vector<int> queue;
			for (const Offer& o : offers_[piece])
				take(o.vertex, o.label, queue);
			flood(piece, queue);
			std::vector<int>& left = left_[piece];
			left.erase(
				std::remove_if(left.begin(), left.end(), [&](int v) { return label_[v] >= 0; }),
				left.end());
		});
	}
};

/// A point in the plane of a triangle as weights of its corners.
struct Foot {
	float weight[3];

	bool isInside() const { return weight[0] > 0 && weight[1] > 0 && weight[2] > 0; }
	int  lightest() const
	{
		if (weight[0] <= weight[1]) return weight[0] <= weight[2] ? 0 : 2;
		return weight[1] <= weight[2] ? 1 : 2;
	}
	int heaviest() const
	{
		if (weight[0] >= weight[1]) return weight[0] >= weight[2] ? 0 : 2;
		return weight[1] >= weight[2] ? 1 : 2;
	}
};

Vec3f pointAt(const Foot& f, const Corners& t)
{
	return t.a * f.weight[0] + t.b * f.weight[1] + t.c * f.weight[2];
}

/// The point of the triangle's plane nearest to p; n is the triangle's cross product.
Foot footInPlane(const Vec3f& p, const Corners& t, const Vec3f& n)
{
	const float squared = squaredLength(n);
	const float second  = dot(cross(p - t.a, t.c - t.a), n) / squared;
	const float third   = dot(cross(t.b - t.a, p - t.a), n) / squared;
	return {{1 - second - third, second, third}};
}

/// The point of the triangle nearest to p.
Foot nearestFoot(const Vec3f& p, const Corners& t, const Vec3f& n)
{
	if (squaredLength(n) > 0) {
		const Foot inPlane = footInPlane(p, t, n);
		if (inPlane.isInside()) return inPlane;
	}
	// Outside: all three edges, since the triangle may be obtuse.
	const float ab = shareOnSegment(p, t.a, t.b), bc = shareOnSegment(p, t.b, t.c);
	const float ca        = shareOnSegment(p, t.c, t.a);
	const Foot  onEdge[3] = {{{1 - ab, ab, 0}}, {{0, 1 - bc, bc}}, {{ca, 0, 1 - ca}}};
	Foot        best      = onEdge[0];
	for (const Foot& f : onEdge) {
		if (squaredLength(pointAt(f, t) - p) < squaredLength(pointAt(best, t) - p)) best = f;
	}
	return best;
}

/// Finds the triangle of the result that a vertex of the input belongs to.
class TriangleSearch {
public:
	TriangleSearch(const Surface& surface, const HalfEdgeMesh& result) :
			surface_(surface), m_(result)
	{
	}

	struct Found {
		int   face;
		Foot  foot;
		float distance; ///< squared; × wrongSide where the face looks the other way
	};

	/// Whether the face looks the other way than the vertex of the input, or lies so far from it
	/// that it may stand for another part of the surface.
	bool isStray(int p, int face) const
	{
		const Corners t  = cornersOf(face);
		const Vec3f   n  = t.cross();
		const Vec3f   at = surface_.mesh.position[p];
		if (!(dot(n, surface_.normal[p].unpack()) > 0)) return true;
		return squaredLength(pointAt(nearestFoot(at, t, n), t) - at) > strayShare * length(n);
	}

	/// Walks from a face towards the one that p lies over, as in point location in the plane. Where
	/// that ends nowhere, as at creases and coneApexes, the stars on the way are searched; where it
	/// ends far off, beyond a crease perhaps, those round the face that it began with, too.
	Found locate(int p, int face) const
	{
		const Vec3f at     = surface_.mesh.position[p];
		const Vec3f normal = surface_.normal[p].unpack();
		const int   start  = face;
		Foot        foot{{1, 0, 0}};
		for (int step = 0; step < maxSteps; ++step) {
			const Corners t = cornersOf(face);
			const Vec3f   n = t.cross();
			if (!(dot(n, normal) > 0)) break;
			foot = footInPlane(at, t, n);
			if (foot.isInside()) {
				const float off = squaredLength(pointAt(foot, t) - at);
				if (off <= overShare * length(n)) return {face, foot, off};
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

	Corners cornersOf(int face) const
	{
		const int* c = &m_.origin[3 * face];
		return {m_.position[c[0]], m_.position[c[1]], m_.position[c[2]]};
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
		const Corners t        = cornersOf(face);
		const Vec3f   n        = t.cross();
		const Foot    foot     = nearestFoot(at, t, n);
		float         distance = squaredLength(pointAt(foot, t) - at);
		if (dot(n, normal) < 0) distance = wrongSide * distance + std::numeric_limits<float>::min();
		if (distance < best.distance) best = {face, foot, distance};
	}
};

/// Faces of the result for vertices of the input, and where on them.
struct FaceChoice {
	Buffer<int>&           face;
	Buffer<PackedWeights>& weights;

	void take(std::size_t p, const TriangleSearch::Found& found) const
	{
		face[p]    = found.face;
		weights[p] = PackedWeights(found.foot.weight[1], found.foot.weight[2]);
	}
};

/// The flood counts edges, not lengths: along needles it comes to the far side of a plate before
/// the near one, and the walks from there do not find back. Strays are looked for again from the
/// faces of their neighbours, ring by ring from those that have not strayed.
class StrayReturn {
public:
	StrayReturn(const HalfEdgeMesh& input, const TriangleSearch& search, const FaceChoice& choice,
				Workers& workers) :
			m_(input),
			search_(search), choice_(choice), workers_(workers)
	{
	}

	void run()
	{
		std::vector<int> front = workers_.collectIf(m_.vertexNum, [&](int p) {
			return choice_.face[p] >= 0 && search_.isStray(p, choice_.face[p]);
		});
		if (!front.empty()) isStray_.assign(std::size_t(m_.vertexNum), 0);
		for (int p : front)
			isStray_[p] = 1;
		while (!front.empty())
			front = takeRing(front);
	}

private:
	struct Back {
		int                   vertex;
		TriangleSearch::Found found;
	};

	const HalfEdgeMesh&   m_;
	const TriangleSearch& search_;
	const FaceChoice&     choice_;
	Workers&              workers_;
	std::vector<char>     isStray_;

	/// Returns the strays beside those that came back.
	std::vector<int> takeRing(const std::vector<int>& front)
	{
		// All see the faces before the round: the bits do not depend on the threads.
		const std::vector<Back> back = workers_.collect<Back>(
			front.size(), [&](std::size_t begin, std::size_t end, auto& out) {
				for (std::size_t i = begin; i < end; ++i) {
					const TriangleSearch::Found found = nearestByNeighbours(front[i]);
					if (!search_.isStray(front[i], found.face)) out.push_back({front[i], found});
				}
			});
		std::vector<int> beside;
		for (const Back& b : back) {
			choice_.take(b.vertex, b.found);
			isStray_[b.vertex] = 0;
		}
		for (const Back& b : back) {
			forEachNeighbour(m_, b.vertex, [&](int q) {
				if (isStray_[q]) beside.push_back(q);
			});
		}
		sortUnique(beside);
		return beside;
	}

	/// The nearest face that is found from those of the neighbours that have not strayed; its own
	/// where there are none.
	TriangleSearch::Found nearestByNeighbours(int p) const
	{
		TriangleSearch::Found best{choice_.face[p], {{1, 0, 0}}, HUGE_VALF};
		forEachNeighbour(m_, p, [&](int q) {
			if (choice_.face[q] < 0 || isStray_[q]) return;
			const TriangleSearch::Found found = search_.locate(p, choice_.face[q]);
			if (found.distance < best.distance) best = found;
		});
		return best;
	}
};

} // namespace

Buffer<int> floodFromPoints(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	return PointFlood(surface, result, workers).run();
}

ClosestFaceMap::ClosestFaceMap(const Surface& surface, const ResultMesh& result, Workers& workers) :
		surface_(surface), face_(floodFromPoints(surface, result, workers)),
		weights_(surface.mesh.vertexNum), area_(surface.mesh.vertexNum)
{
	workers.forRange(face_.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t p = begin; p < end; ++p) {
			if (face_[p] >= 0) face_[p] = result.mesh.outgoing[face_[p]] / 3;
		}
	});
	measureAreas(workers);
	locateAll(result, workers);
	StrayReturn(surface.mesh, TriangleSearch(surface_, result.mesh), {face_, weights_}, workers)
		.run();
	makeLists(result, workers);
}

void ClosestFaceMap::update(const ResultMesh& result, Workers& workers)
{
	locateAll(result, workers);
	makeLists(result, workers);
}

void ClosestFaceMap::locateAll(const ResultMesh& result, Workers& workers)
{
	const TriangleSearch search(surface_, result.mesh);
	const FaceChoice     choice{face_, weights_};
	workers.forRange(face_.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t p = begin; p < end; ++p) {
			if (face_[p] < 0) continue;
			choice.take(p, search.locate(int(p), face_[p]));
		}
	});
}

void ClosestFaceMap::makeLists(const ResultMesh& result, Workers& workers)
{
	const auto faceOf = [&](std::size_t p) { return face_[p]; };
	sortIntoBuckets(face_.size(), result.mesh.faceNum, faceOf, workers, start_, item_);
}

void ClosestFaceMap::keepListsOnly()
{
	face_.release();
	weights_.release();
	area_.release();
}

void ClosestFaceMap::measureAreas(Workers& workers)
{
	const HalfEdgeMesh& m = surface_.mesh;
	workers.forRange(area_.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t p = begin; p < end; ++p) {
			float sum = 0;
			forEachFaceRound(m, int(p), [&](int, const Vec3f& a, const Vec3f& b) {
				sum += length(cross(a, b));
			});
			area_[p] = PackedMeasure(sum / 6);
		}
	});
}

} // namespace gpr
