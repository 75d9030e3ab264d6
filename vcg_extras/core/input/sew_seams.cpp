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
#include <vector>

namespace gpr {

namespace {

std::uint64_t numberOf(int v)
{
	return mixedBits(std::uint64_t(v) + 0x9e3779b97f4a7c15ull);
}

// ---- the border

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
			const EdgeSide e = edgeSide(mesh, h);
			if (unpaired[e.low] != 0 && unpaired[e.high] != 0) out.push_back(e);
		});
	sortPolled(sides.begin(), sides.end(), workers);
	std::vector<int> border;
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		if (end - begin == 1) border.push_back(sides[begin].halfEdge);
	});
	return border;
}

// ---- seams

/// Two border edges at the same place.
struct Seam {
	int  halfEdge[2];
	bool sameDirection;
};

/// Joins faces a and b, turned over against each other or not. False if a and b are already joined
/// with the other value of `turned`. parts: for union_find.h, two items a face: as it is, and
/// turned over.
bool joinTurned(std::vector<int>& parts, int a, int b, bool turned)
{
	const int same = 2 * b + turned, other = 2 * b + !turned;
	if (rootOf(parts, 2 * a) == rootOf(parts, other)) return false;
	joinSets(parts, 2 * a, same);
	joinSets(parts, 2 * a + 1, other);
	return true;
}

/// Sews a mesh with a known border.
class Sewing {
public:
	Sewing(IndexedMesh& mesh, const std::vector<int>& border, Workers& workers,
		   CleanCounts& counts) :
			mesh_(mesh),
			border_(border), workers_(workers), counts_(counts)
	{
	}

	void run()
	{
		if (!findPlaces()) return;
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
	std::vector<int>        vertices_; ///< of the border, ascending
	Buffer<int>             place_;    ///< per border vertex: the first vertex at its place
	std::vector<Seam>       seams_;
	std::vector<int>        coinciding_;        ///< vertices at the ends of edges at the same place
	std::int64_t            coincidingNum_ = 0; ///< of such edges
	Buffer<int>             name_;              ///< per vertex: its vertex after joining

	/// Returns whether two border vertices lie at the same place.
	bool findPlaces()
	{
		Poller poller(workers_);
		for (int h : border_) {
			poller.count();
			vertices_.push_back(mesh_.triangle[h]);
			vertices_.push_back(mesh_.triangle[nextInFace(h)]);
		}
		sortPolled(vertices_.begin(), vertices_.end(), workers_);
		vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
		SamePlaceTable table(vertices_.size());
		bool           isAnyShared = false;
		place_.reset(std::size_t(mesh_.vertexNum));
		for (int v : vertices_) {
			poller.count();
			place_[v] = table.findOrPut(mesh_.position[v], v);
			isAnyShared |= place_[v] != v;
		}
		return isAnyShared;
	}

	void findSeams()
	{
		std::vector<EdgeSide> sides;
		Poller                poller(workers_);
		for (int h : border_) {
			poller.count();
			const int a = place_[mesh_.triangle[h]], b = place_[mesh_.triangle[nextInFace(h)]];
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
		seams_.push_back({{g, h}, place_[mesh_.triangle[g]] == place_[mesh_.triangle[h]]});
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
		std::vector<int> parts = numbersBelow(2 * std::size_t(mesh_.faceNum));
		joinNeighbours(parts);
		// Seams without turning come first.
		for (bool turning : {false, true}) {
			const auto isOneSided = [&](const Seam& s) {
				return s.sameDirection == turning &&
					   !joinTurned(parts, s.halfEdge[0] / 3, s.halfEdge[1] / 3, turning);
			};
			seams_.erase(std::remove_if(seams_.begin(), seams_.end(), isOneSided), seams_.end());
		}
	}

	void joinNeighbours(std::vector<int>& parts) const
	{
		const Buffer<EdgeSide> sides = sortedByBuckets<EdgeSide>(
			3 * std::size_t(mesh_.faceNum), std::size_t(mesh_.vertexNum),
			[&](std::size_t h) { return edgeSide(mesh_, int(h)); },
			[](const EdgeSide& s) { return s.low; }, workers_);
		Poller poller(workers_);
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			poller.count();
			if (end - begin != 2) return;
			const int g = sides[begin].halfEdge, h = sides[begin + 1].halfEdge;
			joinTurned(parts, g / 3, h / 3, mesh_.triangle[g] == mesh_.triangle[h]);
		});
	}

	// ---- the effect of joining on edges

	void joinAlongSeams()
	{
		name_.reset(std::size_t(mesh_.vertexNum));
		workers_.forEach(name_.size(), [&](int v) { name_[v] = v; });
		Poller poller(workers_);
		for (const Seam& s : seams_) {
			poller.count();
			const int g = s.halfEdge[0], h = s.halfEdge[1];
			const int otherStart = s.sameDirection ? h : nextInFace(h);
			const int otherEnd   = s.sameDirection ? nextInFace(h) : h;
			joinSets(name_, mesh_.triangle[g], mesh_.triangle[otherStart]);
			joinSets(name_, mesh_.triangle[nextInFace(g)], mesh_.triangle[otherEnd]);
		}
		for (int v : vertices_)
			name_[v] = rootOf(name_, v);
	}

	/// Per vertex of the mesh whether it is joined to another vertex.
	Buffer<char> joinedOnes() const
	{
		Buffer<char> isJoined(mesh_.vertexNum, 0);
		for (int v : vertices_) {
			if (name_[v] != v) isJoined[v] = isJoined[name_[v]] = 1;
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
		const auto isBad   = [&](int v) { return placeIn(bad, name_[v]) >= 0; };
		const auto touches = [&](const Seam& s) {
			const int g = s.halfEdge[0];
			return isBad(mesh_.triangle[g]) || isBad(mesh_.triangle[nextInFace(g)]);
		};
		seams_.erase(std::remove_if(seams_.begin(), seams_.end(), touches), seams_.end());
		return true;
	}

	/// The joined vertices, by new numbers, at the ends of edges that would get too many faces.
	/// Ascending.
	std::vector<int> findConflicts() const
	{
		const Buffer<char>    isJoined = joinedOnes();
		std::vector<EdgeSide> sides =
			workers_.collectEach<EdgeSide>(3 * std::size_t(mesh_.faceNum), [&](int h, auto& out) {
				const int a = mesh_.triangle[h], b = mesh_.triangle[nextInFace(h)];
				if (isJoined[a] || isJoined[b]) out.push_back(edgeSide(name_[a], name_[b], h));
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
		const EdgeSide before = edgeSide(mesh_, sides[begin].halfEdge);
		for (std::size_t i = begin; i < end; ++i) {
			if (!edgeSide(mesh_, sides[i].halfEdge).isOfSameEdge(before)) return true;
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
			mesh_.position[v] = mesh_.position[place_[v]];
	}

	void renameVertices()
	{
		workers_.forEach(3 * std::size_t(mesh_.faceNum),
						 [&](int i) { mesh_.triangle[i] = name_[mesh_.triangle[i]]; });
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
	const std::vector<int> border = findBorder(mesh, workers);
	Sewing(mesh, border, workers, counts).run();
}

} // namespace gpr
