// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sew_seams.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/union_find.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>
#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace gpr {

namespace {

std::uint64_t numberOf(int v)
{
	return mixedBits(std::uint64_t(v) + 0x9e3779b97f4a7c15ull);
}

EdgeSide sideAt(const IndexedMesh& mesh, int h)
{
	return edgeSide(mesh.triangle[h], mesh.triangle[nextInFace(h)], h);
}

// ---- the border

struct Parity {
	std::uint64_t bits = 0;
	Parity&       operator+=(const Parity& other)
	{
		bits ^= other.bits;
		return *this;
	}
};

/// Whether every edge has an even number of faces. Then the random numbers of the edges' sides
/// cancel out in any order; the probability of a false answer is 2^-64.
bool isClosed(const IndexedMesh& mesh, Workers& workers)
{
	const auto addParity = [&](int h, Parity& parity) {
		const EdgeSide e = sideAt(mesh, h);
		parity.bits ^= mixedBits(std::uint64_t(e.low) << 32 | std::uint64_t(e.high));
	};
	return workers.sumEach<Parity>(3 * std::size_t(mesh.faceNum), addParity).bits == 0;
}

/// Per vertex the xor of the random numbers of its neighbours, each repeated for every face at the
/// edge to the neighbour. Not 0 at the ends of border edges.
Buffer<std::uint64_t> unpairedNeighbours(const IndexedMesh& mesh, Workers& workers)
{
	Buffer<std::uint64_t> unpaired(mesh.vertexNum, 0);
	workers.forEach(mesh.faceNum, [&](int f) {
		const int*          corner    = &mesh.triangle[3 * f];
		const std::uint64_t number[3] = {numberOf(corner[0]), numberOf(corner[1]),
										 numberOf(corner[2])};
		for (int k = 0; k < 3; ++k)
			__atomic_fetch_xor(&unpaired[corner[k]], number[(k + 1) % 3] ^ number[(k + 2) % 3],
							   __ATOMIC_RELAXED);
	});
	return unpaired;
}

/// The half-edges at edges with a single face.
std::vector<int> findBorder(const IndexedMesh& mesh, Workers& workers)
{
	const Buffer<std::uint64_t> unpaired = unpairedNeighbours(mesh, workers);
	std::vector<EdgeSide>       sides =
		workers.collectEach<EdgeSide>(3 * std::size_t(mesh.faceNum), [&](int h, auto& out) {
			const EdgeSide e = sideAt(mesh, h);
			if (unpaired[e.low] != 0 && unpaired[e.high] != 0) out.push_back(e);
		});
	sortPolled(sides.begin(), sides.end(), workers);
	std::vector<int> border;
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		if (end - begin == 1) border.push_back(sides[begin].halfEdge);
	});
	return border;
}

// ---- places

/// The vertices of the border, numbered consecutively.
class BorderVertices {
public:
	BorderVertices(const IndexedMesh& mesh, const std::vector<int>& border, Workers& workers)
	{
		Poller poller(workers);
		for (int h : border) {
			poller.count();
			vertex_.push_back(mesh.triangle[h]);
			vertex_.push_back(mesh.triangle[nextInFace(h)]);
		}
		sortPolled(vertex_.begin(), vertex_.end(), workers);
		vertex_.erase(std::unique(vertex_.begin(), vertex_.end()), vertex_.end());
		SamePlaceTable table(vertex_.size());
		for (int v : vertex_) {
			poller.count();
			place_.push_back(table.findOrPut(mesh.position[v], v));
			isAnyShared_ |= place_.back() != v;
		}
	}

	int  num() const { return int(vertex_.size()); }
	int  vertex(int i) const { return vertex_[std::size_t(i)]; }
	bool isAnyShared() const { return isAnyShared_; } ///< whether two lie at the same place
	int  indexOf(int v) const { return placeIn(vertex_, v); }
	/// The first vertex at the place of v.
	int placeOf(int v) const { return place_[std::size_t(indexOf(v))]; }

private:
	std::vector<int> vertex_, place_;
	bool             isAnyShared_ = false;
};

// ---- seams

/// Two border edges at the same place.
struct Seam {
	int  halfEdge[2];
	bool sameDirection;
};

/// Disjoint sets of numbers; each number is turned over or not against the first number of its set.
class TurnableSets {
public:
	explicit TurnableSets(std::size_t num) : parent_(num), turned_(num, 0)
	{
		std::iota(parent_.begin(), parent_.end(), 0);
	}

	/// Joins a and b, turned over against each other or not. False if a and b are already joined
	/// with the other value of `turned`.
	bool join(int a, int b, bool turned)
	{
		const auto [rootA, turnedA] = find(a);
		const auto [rootB, turnedB] = find(b);
		const bool differs          = turnedA != turnedB;
		if (rootA == rootB) return differs == turned;
		const int low                             = std::min(rootA, rootB);
		parent_[std::size_t(rootA)]               = low;
		parent_[std::size_t(rootB)]               = low;
		turned_[std::size_t(rootA ^ rootB ^ low)] = char(differs != turned);
		return true;
	}

private:
	std::vector<int>  parent_;
	std::vector<char> turned_; ///< against the parent

	std::pair<int, bool> find(int a)
	{
		int  root   = a;
		bool turned = false;
		for (; parent_[std::size_t(root)] != root; root = parent_[std::size_t(root)])
			turned ^= turned_[std::size_t(root)] != 0;
		const std::pair<int, bool> found{root, turned};
		while (a != root) {
			const int  next         = parent_[std::size_t(a)];
			const bool after        = turned != (turned_[std::size_t(a)] != 0);
			parent_[std::size_t(a)] = root;
			turned_[std::size_t(a)] = char(turned);
			turned                  = after;
			a                       = next;
		}
		return found;
	}
};

/// Sews a mesh with a known border.
class Sewing {
public:
	Sewing(IndexedMesh& mesh, const std::vector<int>& border, Workers& workers,
		   CleanCounts& counts) :
			mesh_(mesh),
			border_(border), workers_(workers), counts_(counts), vertices_(mesh, border, workers)
	{
	}

	void run()
	{
		if (!vertices_.isAnyShared()) return;
		findSeams();
		leaveOutOneSided();
		while (leaveOutConflicts()) {}
		counts_.sewnEdges         = std::int64_t(seams_.size());
		counts_.sharedBorderEdges = coincidingNum_ - 2 * counts_.sewnEdges;
		moveTogether();
		if (!seams_.empty()) renameVertices();
	}

private:
	IndexedMesh&            mesh_;
	const std::vector<int>& border_;
	Workers&                workers_;
	CleanCounts&            counts_;
	BorderVertices          vertices_;
	std::vector<Seam>       seams_;
	std::vector<int>        coinciding_;        ///< vertices at the ends of edges at the same place
	std::int64_t            coincidingNum_ = 0; ///< of such edges
	std::vector<int>        joined_; ///< per border vertex: index of the border vertex after
									 ///< joining

	void findSeams()
	{
		std::vector<EdgeSide> sides;
		Poller                poller(workers_);
		for (int h : border_) {
			poller.count();
			const int a = vertices_.placeOf(mesh_.triangle[h]);
			const int b = vertices_.placeOf(mesh_.triangle[nextInFace(h)]);
			if (a != b) sides.push_back(edgeSide(a, b, h));
		}
		sortPolled(sides.begin(), sides.end(), workers_);
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			if (end - begin < 2) return;
			noteCoinciding(sides, begin, end);
			if (end - begin == 2) addSeam(sides[begin].halfEdge, sides[begin + 1].halfEdge);
		});
	}

	void noteCoinciding(const std::vector<EdgeSide>& sides, std::size_t begin, std::size_t end)
	{
		coincidingNum_ += std::int64_t(end - begin);
		for (std::size_t i = begin; i < end; ++i) {
			coinciding_.push_back(mesh_.triangle[sides[i].halfEdge]);
			coinciding_.push_back(mesh_.triangle[nextInFace(sides[i].halfEdge)]);
		}
	}

	void addSeam(int g, int h)
	{
		if (g / 3 == h / 3 || lieOnOneAnother(g, h)) return;
		const int atG = vertices_.placeOf(mesh_.triangle[g]);
		const int atH = vertices_.placeOf(mesh_.triangle[h]);
		seams_.push_back({{g, h}, atG == atH});
	}

	static constexpr float cosineOfLeast = 0.9998477f;
	static_assert(leastSeamAngleDeg == 1);

	bool lieOnOneAnother(int g, int h) const
	{
		// A degenerate face has no direction, and lies on no other face.
		return dot(inward(mesh_, g), inward(mesh_, h)) > cosineOfLeast;
	}

	/// Edges with the same direction need whole parts of the mesh turned over. Leaves out seams at
	/// which the same part would have to be turned and not turned.
	void leaveOutOneSided()
	{
		const auto isReverse = [](const Seam& s) { return s.sameDirection; };
		if (std::none_of(seams_.begin(), seams_.end(), isReverse)) return;
		TurnableSets parts(std::size_t(mesh_.faceNum));
		joinNeighbours(parts);
		// Seams without turning come first.
		for (bool turning : {false, true}) {
			const auto isOneSided = [&](const Seam& s) {
				return s.sameDirection == turning &&
					   !parts.join(s.halfEdge[0] / 3, s.halfEdge[1] / 3, turning);
			};
			seams_.erase(std::remove_if(seams_.begin(), seams_.end(), isOneSided), seams_.end());
		}
	}

	void joinNeighbours(TurnableSets& parts) const
	{
		const Buffer<EdgeSide> sides = sortedByBuckets<EdgeSide>(
			3 * std::size_t(mesh_.faceNum), std::size_t(mesh_.vertexNum),
			[&](std::size_t h) { return sideAt(mesh_, int(h)); },
			[](const EdgeSide& s) { return s.low; }, workers_);
		Poller poller(workers_);
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			poller.count();
			if (end - begin != 2) return;
			const int g = sides[begin].halfEdge, h = sides[begin + 1].halfEdge;
			parts.join(g / 3, h / 3, mesh_.triangle[g] == mesh_.triangle[h]);
		});
	}

	// ---- the effect of joining on edges

	void joinVertices(int v, int w)
	{
		joinSets(joined_, vertices_.indexOf(v), vertices_.indexOf(w));
	}

	void joinAlongSeams()
	{
		joined_.resize(std::size_t(vertices_.num()));
		std::iota(joined_.begin(), joined_.end(), 0);
		Poller poller(workers_);
		for (const Seam& s : seams_) {
			poller.count();
			const int g = s.halfEdge[0], h = s.halfEdge[1];
			const int otherStart = s.sameDirection ? h : nextInFace(h);
			const int otherEnd   = s.sameDirection ? nextInFace(h) : h;
			joinVertices(mesh_.triangle[g], mesh_.triangle[otherStart]);
			joinVertices(mesh_.triangle[nextInFace(g)], mesh_.triangle[otherEnd]);
		}
		for (int i = 0; i < vertices_.num(); ++i)
			joined_[std::size_t(i)] = rootOf(joined_, i);
	}

	/// Per vertex of the mesh its vertex after joining.
	Buffer<int> newNames() const
	{
		Buffer<int> name(mesh_.vertexNum);
		workers_.forEach(name.size(), [&](int v) { name[v] = v; });
		for (int i = 0; i < vertices_.num(); ++i)
			name[vertices_.vertex(i)] = vertices_.vertex(joined_[std::size_t(i)]);
		return name;
	}

	/// Per vertex of the mesh whether it is joined to another vertex.
	Buffer<char> joinedOnes() const
	{
		Buffer<char> isJoined(mesh_.vertexNum, 0);
		for (int i = 0; i < vertices_.num(); ++i) {
			const int root = joined_[std::size_t(i)];
			if (root == i) continue;
			isJoined[vertices_.vertex(i)] = isJoined[vertices_.vertex(root)] = 1;
		}
		return isJoined;
	}

	/// Joining may give edges far apart the same ends, and a face two equal corners. Leaves out the
	/// seams at such places. Returns whether there were any.
	bool leaveOutConflicts()
	{
		if (seams_.empty()) return false;
		joinAlongSeams();
		const std::vector<int> bad = findConflicts();
		if (bad.empty()) return false;
		const auto touches = [&](const Seam& s) {
			for (int h : {s.halfEdge[0], nextInFace(s.halfEdge[0])}) {
				const int i = joined_[std::size_t(vertices_.indexOf(mesh_.triangle[h]))];
				if (std::binary_search(bad.begin(), bad.end(), vertices_.vertex(i))) return true;
			}
			return false;
		};
		seams_.erase(std::remove_if(seams_.begin(), seams_.end(), touches), seams_.end());
		return true;
	}

	/// The joined vertices, by new numbers, at the ends of edges that would get too many faces.
	/// Ascending.
	std::vector<int> findConflicts() const
	{
		const Buffer<int>     name     = newNames();
		const Buffer<char>    isJoined = joinedOnes();
		std::vector<EdgeSide> sides =
			workers_.collectEach<EdgeSide>(3 * std::size_t(mesh_.faceNum), [&](int h, auto& out) {
				const int a = mesh_.triangle[h], b = mesh_.triangle[nextInFace(h)];
				if (isJoined[a] || isJoined[b]) out.push_back(edgeSide(name[a], name[b], h));
			});
		sortPolled(sides.begin(), sides.end(), workers_);
		std::vector<int> bad;
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			if (!isConflict(sides, begin, end)) return;
			for (int v : {sides[begin].low, sides[begin].high}) {
				if (isJoined[v]) bad.push_back(v);
			}
		});
		sortUnique(bad);
		return bad;
	}

	bool isConflict(const std::vector<EdgeSide>& sides, std::size_t begin, std::size_t end) const
	{
		if (sides[begin].low == sides[begin].high) return true;
		if (end - begin <= 2) return false;
		const EdgeSide before = sideAt(mesh_, sides[begin].halfEdge);
		for (std::size_t i = begin; i < end; ++i) {
			if (!sideAt(mesh_, sides[i].halfEdge).isOfSameEdge(before)) return true;
		}
		return false; // the edge had as many faces before
	}

	// ---- the outcome

	/// Gives the ends of edges at the same place equal coordinates, sewn or not: points computed
	/// from both edges later, such as their middles, then lie at the same place too.
	void moveTogether()
	{
		sortUnique(coinciding_);
		for (int v : coinciding_)
			mesh_.position[v] = mesh_.position[vertices_.placeOf(v)];
	}

	void renameVertices()
	{
		const Buffer<int> name = newNames();
		workers_.forEach(3 * std::size_t(mesh_.faceNum),
						 [&](int i) { mesh_.triangle[i] = name[mesh_.triangle[i]]; });
		dropUnusedVertices(mesh_, workers_);
	}
};

} // namespace

bool mayHaveSeams(const Surface& surface, Workers& workers)
{
	const HalfEdgeMesh&    m      = surface.mesh;
	const std::vector<int> border = workers.collectIf(
		std::size_t(m.vertexNum), [&](int v) { return m.outgoing[v] >= 0 && m.isBorderVertex(v); });
	SamePlaceTable table(border.size());
	Poller         poller(workers);
	return std::any_of(border.begin(), border.end(), [&](int v) {
		poller.count();
		return table.findOrPut(m.position[v], v) != v;
	});
}

void sewSeams(IndexedMesh& mesh, Workers& workers, CleanCounts& counts)
{
	if (isClosed(mesh, workers)) return;
	const std::vector<int> border = findBorder(mesh, workers);
	Sewing(mesh, border, workers, counts).run();
}

} // namespace gpr
