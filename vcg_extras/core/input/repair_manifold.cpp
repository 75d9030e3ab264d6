// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair_manifold.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/union_find.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// A mesh and its links: link[h] is the half-edge on the other side of h, or -1.
struct Linked {
	IndexedMesh& mesh;
	Buffer<int>& link;
	Workers&     workers;
	CleanCounts& counts;
	JunctionMode junctions;
	bool         keepsPlaces;

	std::size_t halfEdgeNum() const { return std::size_t(3) * mesh.faceNum; }
	bool        runAlike(int g, int h) const { return mesh.triangle[g] == mesh.triangle[h]; }

	void join(int g, int h)
	{
		link[g] = h;
		link[h] = g;
	}
	/// Makes a border at h, and at the other side of h.
	void cut(int h)
	{
		if (link[h] >= 0) link[link[h]] = -1;
		link[h] = -1;
	}

	/// The sides of these half-edges, sorted by edge.
	Buffer<EdgeSide> sorted(const std::vector<int>& halfEdges) const
	{
		return sortedByBuckets<EdgeSide>(
			halfEdges.size(), std::size_t(mesh.vertexNum),
			[&](std::size_t i) { return edgeSide(mesh, halfEdges[i]); },
			[](const EdgeSide& s) { return s.low; }, workers);
	}
};

// ---- duplicate faces

/// Whether f may have the same corners as another face. Each edge of two such faces either has no
/// other faces and may link the two faces, or has no link.
bool mayBeDuplicate(const Linked& m, int f)
{
	bool isAlone = true;
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		if (m.link[h] < 0) continue;
		if (m.mesh.triangle[prevInFace(h)] == m.mesh.triangle[prevInFace(m.link[h])]) return true;
		isAlone = false;
	}
	return isAlone;
}

/// All faces with the same corners as an earlier face.
std::vector<int> findDuplicateFaces(const Linked& m)
{
	using Corners = std::array<int, 4>; // in order, and the face
	const std::vector<int> suspects =
		m.workers.collectIf(m.mesh.faceNum, [&](int f) { return mayBeDuplicate(m, f); });
	const auto cornersOf = [&](std::size_t i) {
		const int* t = &m.mesh.triangle[3 * suspects[i]];
		Corners    c = {t[0], t[1], t[2], suspects[i]};
		std::sort(c.begin(), c.begin() + 3);
		return c;
	};
	const Buffer<Corners> faces = sortedByBuckets<Corners>(
		suspects.size(), std::size_t(m.mesh.vertexNum), cornersOf,
		[](const Corners& c) { return c[0]; }, m.workers);
	return m.workers.collectEach<int>(faces.size(), [&](std::size_t i, auto& out) {
		if (i > 0 && std::equal(faces[i].begin(), faces[i].begin() + 3, faces[i - 1].begin()))
			out.push_back(faces[i][3]);
	});
}

void dropDuplicateFaces(Linked& m)
{
	const std::vector<int> duplicates = findDuplicateFaces(m);
	if (duplicates.empty()) return;
	m.counts.duplicateFaces += std::int64_t(duplicates.size());
	Buffer<char> isDropped(m.mesh.faceNum, 0);
	for (int f : duplicates) {
		isDropped[f] = 1;
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			m.cut(h);
	}
	const std::vector<int> kept =
		m.workers.collectIf(m.mesh.faceNum, [&](int f) { return !isDropped[f]; });
	const Buffer<int> newFace = keepFaces(m.mesh, kept, m.workers);
	Buffer<int>       link(m.halfEdgeNum());
	m.workers.forEach(link.size(), [&](int h) {
		const int g = m.link[3 * kept[h / 3] + h % 3];
		link[h]     = g < 0 ? -1 : 3 * newFace[g / 3] + g % 3;
	});
	m.link.swap(link);
}

// ---- edges

/// Links the sides of edges with more than two faces, and of edges with two sides in the same
/// direction.
class Linker {
public:
	Linker(Linked& linked, std::vector<int>& faulty) : m_(linked), faulty_(faulty) {}

	/// Collects the faces of edges with more than two faces. Returns whether any linked faces have
	/// opposite orientations.
	bool run()
	{
		const std::vector<int> open =
			m_.workers.collectIf(m_.halfEdgeNum(), [&](int h) { return m_.link[h] < 0; });
		const Buffer<EdgeSide> sides = m_.sorted(open);
		Poller                 poller(m_.workers);
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			poller.count();
			if (end - begin > 2) noteFaulty(sides, begin, end);
			if (end - begin > 2 && m_.junctions == JunctionMode::Cut) {
				for (std::size_t i = begin; i < end; i += mostCompared)
					joinSmoothest(sides, i, std::min(i + mostCompared, end));
			}
			if (end - begin == 2) join(sides[begin].halfEdge, sides[begin + 1].halfEdge);
		});
		m_.counts.longestJunction = std::max(m_.counts.longestJunction, longestJunction());
		sortUnique(sources_);
		m_.counts.nonManifoldEdges += std::int64_t(sources_.size());
		return joinedReversed_;
	}

private:
	/// More faces at an edge are rare, and are paired in groups of this even number, because the
	/// cost of a group grows with the third power.
	static constexpr std::size_t mostCompared = 64;

	Linked&                          m_;
	std::vector<int>&                faulty_;
	bool                             joinedReversed_ = false;
	std::vector<std::pair<int, int>> cutEnds_; ///< of edges with more than two faces
	/// Two faces of the input at each: an edge of the input may be in parts.
	std::vector<std::pair<int, int>> sources_;

	/// The largest total length of such edges that are connected.
	double longestJunction() const
	{
		std::map<int, int>    parent;
		std::map<int, double> extent;
		for (const auto& [a, b] : cutEnds_) {
			parent.insert({a, a});
			parent.insert({b, b});
			joinSets(parent, a, b);
		}
		double most = 0;
		for (const auto& [a, b] : cutEnds_) {
			double& sum = extent[rootOf(parent, a)];
			sum += double(length(m_.mesh.position[b] - m_.mesh.position[a]));
			most = std::max(most, sum);
		}
		return most;
	}

	void join(int g, int h)
	{
		m_.join(g, h);
		joinedReversed_ |= m_.runAlike(g, h);
	}

	/// Small for faces that continue each other smoothly; at least 1 for faces with opposite
	/// orientations.
	float bend(int g, int h) const
	{
		return dot(inward(m_.mesh, g), inward(m_.mesh, h)) + (m_.runAlike(g, h) ? 2.0f : 0.0f);
	}

	void noteFaulty(const Buffer<EdgeSide>& sides, std::size_t begin, std::size_t end)
	{
		cutEnds_.push_back({sides[begin].low, sides[begin].high});
		std::vector<int> sources;
		for (std::size_t i = begin; i < end; ++i) {
			faulty_.push_back(sides[i].halfEdge / 3);
			sources.push_back(m_.mesh.sourceFace[faulty_.back()]);
		}
		std::sort(sources.begin(), sources.end());
		sources_.push_back({sources[0], sources[1]});
	}

	/// Joins the pairs that bend least first; equal pairs in their order.
	void joinSmoothest(const Buffer<EdgeSide>& sides, std::size_t begin, std::size_t end)
	{
		std::vector<std::tuple<float, int, int>> pairs; // bend and half-edges
		for (std::size_t i = begin; i < end; ++i) {
			for (std::size_t k = i + 1; k < end; ++k) {
				const int g = sides[i].halfEdge, h = sides[k].halfEdge;
				pairs.push_back({bend(g, h), g, h});
			}
		}
		sortPolled(pairs.begin(), pairs.end(), m_.workers);
		for (const auto& [bent, g, h] : pairs) {
			if (m_.link[g] < 0 && m_.link[h] < 0) join(g, h);
		}
	}
};

// ---- orientation

/// Orients faces consistently over the links, component by component; the side with more area keeps
/// its orientation.
class Orienter {
public:
	Orienter(Linked& linked, std::vector<int>& faulty) :
			m_(linked), faulty_(faulty), poller_(linked.workers),
			turned_(linked.mesh.faceNum, unseen)
	{
	}

	/// Collects the faces of edges that are cut.
	void run()
	{
		for (int f = 0; f < m_.mesh.faceNum; ++f) {
			if (turned_[f] == unseen) orientComponent(f);
		}
		std::vector<int> sources; // a face of the input may be in parts
		for (int f = 0; f < m_.mesh.faceNum; ++f) {
			poller_.count();
			if (!turned_[f]) continue;
			turn(f);
			sources.push_back(m_.mesh.sourceFace[f]);
		}
		sortUnique(sources);
		m_.counts.reorientedFaces += std::int64_t(sources.size());
	}

private:
	static constexpr char unseen = 2;

	Linked&           m_;
	std::vector<int>& faulty_;
	Poller            poller_;
	std::vector<char> turned_;

	void orientComponent(int seed)
	{
		std::vector<int> faces{seed};
		turned_[seed] = 0;
		for (std::size_t i = 0; i < faces.size(); ++i) {
			poller_.count();
			for (int h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
				visitAcross(h, faces);
			}
		}
		double turnedArea = 0, keptArea = 0;
		for (int f : faces)
			(turned_[f] ? turnedArea : keptArea) += double(length(m_.mesh.faceCross(f)));
		if (turnedArea <= keptArea) return;
		for (int f : faces)
			turned_[f] = !turned_[f];
	}

	void visitAcross(int h, std::vector<int>& faces)
	{
		const int g = m_.link[h];
		if (g < 0) return;
		const char wanted    = char(turned_[h / 3] ^ char(m_.runAlike(g, h)));
		char&      neighbour = turned_[g / 3];
		if (neighbour == unseen) {
			neighbour = wanted;
			faces.push_back(g / 3);
		}
		else if (neighbour != wanted) {
			// The way round came back with the opposite orientation: a one-sided surface. Cut here.
			m_.cut(h);
			faulty_.insert(faulty_.end(), {g / 3, h / 3});
			++m_.counts.nonOrientableCuts;
		}
	}

	/// (a, b, c) becomes (a, c, b): half-edges 0 and 2 change places.
	void turn(int f)
	{
		std::swap(m_.mesh.triangle[3 * f + 1], m_.mesh.triangle[3 * f + 2]);
		std::swap(m_.link[3 * f], m_.link[3 * f + 2]);
		for (int h = 3 * f; h < 3 * f + 3; h += 2) {
			if (m_.link[h] >= 0) m_.link[m_.link[h]] = h;
		}
	}
};

// ---- vertices

std::vector<Vec3f> distinctPlaces(std::vector<Vec3f> places)
{
	std::sort(places.begin(), places.end(), isBefore<float>);
	places.erase(std::unique(places.begin(), places.end()), places.end());
	return places;
}

/// Draws the tips of closed fans at split vertices towards their rings, by a small share of the
/// way. At the same place the fans would touch: a self-intersection of the input, where the result
/// may intersect itself too. corners: of all fans at split vertices.
void drawTipsApart(Linked& m, const std::vector<int>& corners)
{
	constexpr float share = 1 / 32.0f;
	struct Tip {
		bool  isClosed  = true;
		int   cornerNum = 0;
		Vec3f way; ///< sum of the ways to the ring
	};
	IndexedMesh&       mesh = m.mesh;
	std::map<int, Tip> tips; // by vertex
	Poller             poller(m.workers);
	for (int h : corners) {
		poller.count();
		const int v   = mesh.triangle[h];
		Tip&      tip = tips[v];
		tip.isClosed  = tip.isClosed && m.link[h] >= 0 && m.link[prevInFace(h)] >= 0;
		tip.way += mesh.position[mesh.triangle[nextInFace(h)]] - mesh.position[v];
		++tip.cornerNum;
	}
	for (const auto& [v, tip] : tips) {
		if (tip.isClosed) mesh.position[v] += tip.way * (share / float(tip.cornerNum));
	}
}

/// Gives every fan of faces at a vertex a vertex of its own; the fan with the first corner keeps
/// the vertex.
void separateFans(Linked& m)
{
	const int              oldNum   = m.mesh.vertexNum;
	Buffer<char>           isShared = findNotManifold(m.mesh, m.link, m.workers);
	const std::vector<int> corners  = m.workers.collectIf(
		 m.halfEdgeNum(), [&](int h) { return isShared[m.mesh.triangle[h]] != 0; });
	Poller             poller(m.workers);
	std::vector<Vec3f> added;
	const auto         after  = [&](int h) { return m.link[prevInFace(h)]; };
	const auto         before = [&](int h) { return m.link[h] < 0 ? -1 : nextInFace(m.link[h]); };

	for (int corner : corners) {
		poller.count();
		const int v = m.mesh.triangle[corner];
		if (v < 0 || v >= oldNum) continue; // of a finished fan
		int first = corner, name = ~v;
		while (before(first) >= 0 && before(first) != corner)
			first = before(first);
		if (!isShared[v]) {
			name = oldNum + int(added.size());
			added.push_back(m.mesh.position[v]);
		}
		isShared[v] = 0;
		for (int h = first; h >= 0 && m.mesh.triangle[h] == v; h = after(h))
			m.mesh.triangle[h] = name;
	}
	for (int corner : corners) {
		int& v = m.mesh.triangle[corner];
		v      = std::max(v, ~v);
	}
	m.counts.nonManifoldVertices += std::int64_t(added.size());
	if (m.junctions == JunctionMode::Keep) m.mesh.meetings = distinctPlaces(added);
	makeRoom(m.mesh.position, oldNum + added.size(), m.workers);
	std::copy(added.begin(), added.end(), m.mesh.position.begin() + oldNum);
	m.mesh.vertexNum += int(added.size());
	if (!m.keepsPlaces) drawTipsApart(m, corners);
}

/// Splits edges between the same two vertices. Two borders, or two linked pairs of faces, may run
/// between the same vertices (a slit of one edge; sheets with a common inner edge). The following
/// stages identify edges by vertices, so all but one such edge get a vertex in the middle.
class SlitOpener {
public:
	explicit SlitOpener(Linked& linked) : m_(linked), mesh_(linked.mesh) {}

	/// Splits such edges of the given faces.
	void run(const std::vector<int>& faces)
	{
		findSlits(faces);
		if (m_.junctions == JunctionMode::Keep) addBordersBeside(faces);
		if (slits_.empty()) return;
		const std::size_t faceNum = mesh_.faceNum + slits_.size();
		makeRoom(mesh_.triangle, 3 * faceNum, m_.workers);
		makeRoom(mesh_.sourceFace, faceNum, m_.workers);
		makeRoom(mesh_.position, mesh_.vertexNum + slits_.size(), m_.workers);
		int last = -1;
		for (const auto& slit : slits_) {
			if (std::exchange(last, slit.first / 3) != slit.first / 3) splitFace(slit.first);
		}
	}

private:
	Linked&      m_;
	IndexedMesh& mesh_;
	/// Half-edges to split, each with the new vertex or -1; the same vertex on both linked sides.
	std::map<int, int> slits_;

	void findSlits(const std::vector<int>& faces)
	{
		std::vector<int> halfEdges;
		for (int f : faces)
			halfEdges.insert(halfEdges.end(), {3 * f, 3 * f + 1, 3 * f + 2});
		const Buffer<EdgeSide> sides = m_.sorted(halfEdges);
		Poller                 poller(m_.workers);
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			poller.count();
			// The first linked pair keeps the edge, else the first border.
			int keeper = sides[begin].halfEdge;
			for (std::size_t i = end; i-- > begin;) {
				if (m_.link[sides[i].halfEdge] >= 0) keeper = sides[i].halfEdge;
			}
			for (std::size_t i = begin; i < end; ++i) {
				const int h = sides[i].halfEdge;
				if (h != keeper && m_.link[h] != keeper) slits_[h] = -1;
			}
		});
	}

	using Place = std::array<float, 6>;

	Place placeOf(int h) const
	{
		Vec3f a = mesh_.position[mesh_.triangle[h]];
		Vec3f b = mesh_.position[mesh_.triangle[nextInFace(h)]];
		if (isBefore(b, a)) std::swap(a, b);
		return {a.x, a.y, a.z, b.x, b.y, b.z};
	}

	/// Adds all borders at the place of a slit, also the border that kept its edge, so that all
	/// have the same vertices.
	void addBordersBeside(const std::vector<int>& faces)
	{
		std::set<Place> places;
		for (const auto& slit : slits_)
			places.insert(placeOf(slit.first));
		if (places.empty()) return;
		Poller poller(m_.workers);
		for (int f : faces) {
			poller.count();
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				if (m_.link[h] < 0 && places.count(placeOf(h)) > 0) slits_[h] = -1;
			}
		}
	}

	/// Splits a face into a fan of triangles, with the new vertices in its outline. first: the
	/// first slit of the face.
	void splitFace(int first)
	{
		const int        f = first / 3;
		std::vector<int> outline;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			outline.push_back(mesh_.triangle[h]);
			if (slits_.count(h) > 0) outline.push_back(middleOf(h));
		}
		// The fan starts at a new vertex, so that no triangle has three points on an edge.
		std::rotate(outline.begin(), outline.begin() + 1 + first % 3, outline.end());
		for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
			const int face               = k == 1 ? f : mesh_.faceNum++;
			mesh_.triangle[3 * face]     = outline[0];
			mesh_.triangle[3 * face + 1] = outline[k];
			mesh_.triangle[3 * face + 2] = outline[k + 1];
			mesh_.sourceFace[face]       = mesh_.sourceFace[f];
		}
	}

	int middleOf(int h)
	{
		const int other = m_.link[h];
		if (other >= 0 && slits_.at(other) >= 0) return slits_.at(other);
		const Vec3f a                   = mesh_.position[mesh_.triangle[h]];
		const Vec3f b                   = mesh_.position[mesh_.triangle[nextInFace(h)]];
		mesh_.position[mesh_.vertexNum] = (a + b) * 0.5f;
		return slits_.at(h)             = mesh_.vertexNum++;
	}
};

} // namespace

void repairManifold(IndexedMesh& mesh, Buffer<int>& link, JunctionMode junctions, bool keepsPlaces,
					Workers& workers, CleanCounts& counts)
{
	Linked           linked{mesh, link, workers, counts, junctions, keepsPlaces};
	std::vector<int> faulty; // faces with a changed edge
	dropDuplicateFaces(linked);
	if (Linker(linked, faulty).run()) Orienter(linked, faulty).run();
	separateFans(linked);
	sortUnique(faulty);
	SlitOpener(linked).run(faulty);
}

} // namespace gpr
