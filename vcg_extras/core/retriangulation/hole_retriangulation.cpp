// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "hole_retriangulation.h"

#include "vertex_removal.h"

#include <vcg_extras/core/base/portable_math.h>

#include <algorithm>

namespace gpr {

namespace {

/// The rules of a kind of rounds.
struct RoundRules {
	float minCosine;
	bool  sparesNeighbours; ///< a vertex waits for the next round after a neighbour was removed
	int   maxRounds;
};

constexpr RoundRules roundRules[] = {
	{0.1f, true, 40}, {0.1f, false, 20}, {-0.5f, false, 10}, {-2.0f, false, 10}};

/// The vertices still to be removed, block by block.
class Removal {
public:
	Removal(FusedMesh& fused, const OctreeBlocks& partition, Workers& workers) :
			m_(fused.mesh), partition_(partition), workers_(workers),
			lastTouch_(fused.mesh.vertexNum, 0)
	{
		std::vector<char> isSample(m_.vertexNum, 0);
		for (int v : fused.sampleVertex) {
			if (v >= 0) isSample[v] = 1;
		}
		todo_.resize(partition.blocks.size());
		workers.forTasks(todo_.size(), [&](std::size_t b, int) {
			for (int v = partition.blocks[b].begin; v < partition.blocks[b].end; ++v) {
				if (!isSample[v]) todo_[b].push_back(v);
			}
		});
	}

	/// Runs all rounds of a block in a row, so that the block stays in the cache.
	void runInBlocks()
	{
		// No edit in a block may reach half-way to the next block of the same colour.
		const float longestSquared = 0.0625f * partition_.cellSize * partition_.cellSize;
		std::vector<HoleRetriangulator> removers(workers_.threadNum(), HoleRetriangulator(m_));
		for (const RoundRules& kind : roundRules) {
			for (const std::vector<int>& ids : partition_.byColour) {
				workers_.forTasks(ids.size(), [&](std::size_t i, int worker) {
					runRounds(todo_[ids[i]], removers[worker], kind, longestSquared);
				});
				firstRound_ += kind.maxRounds;
			}
		}
	}

	/// Removes the remaining vertices serially, without a bound on edges.
	std::vector<int> runRest()
	{
		std::vector<int> rest;
		for (const std::vector<int>& vertices : todo_)
			rest.insert(rest.end(), vertices.begin(), vertices.end());
		HoleRetriangulator remover(m_);
		for (const RoundRules& kind : roundRules) {
			workers_.poll();
			runRounds(rest, remover, kind, HUGE_VALF);
			firstRound_ += kind.maxRounds;
		}
		return rest;
	}

private:
	HalfEdgeMesh&                 m_;
	const OctreeBlocks&           partition_;
	Workers&                      workers_;
	std::vector<int>              lastTouch_; ///< per vertex: the last round that changed its star
	std::vector<std::vector<int>> todo_;
	int                           firstRound_ = 1; ///< number of the next round, for lastTouch_

	void runRounds(std::vector<int>& vertices, HoleRetriangulator& remover, const RoundRules& kind,
				   float longestSquared)
	{
		const HoleRules rules = {kind.minCosine, longestSquared};
		for (int i = 0; i < kind.maxRounds && !vertices.empty(); ++i) {
			const std::size_t before = vertices.size();
			runRound(vertices, remover, rules, kind.sparesNeighbours ? firstRound_ + i : 0);
			if (vertices.size() == before) return;
		}
	}

	/// Tries each vertex once; vertices that stay remain in the list. round = 0: no vertex waits.
	void runRound(std::vector<int>& vertices, HoleRetriangulator& remover, const HoleRules& rules,
				  int round)
	{
		std::size_t left = 0;
		for (int v : vertices) {
			const bool waits = round > 0 && lastTouch_[v] == round;
			if (waits || !remover.remove(v, rules)) {
				vertices[left++] = v;
				continue;
			}
			for (int w : remover.star().ring)
				lastTouch_[w] = round;
		}
		vertices.resize(left);
	}
};

} // namespace

Vec3d flattenStar(const HalfEdgeMesh& m, const VertexStar& star, std::vector<Vec2d>& flat)
{
	const int   n = star.placeNum();
	const Vec3d p(m.position[star.vertex]);
	flat.resize(n);
	// First x is the angle from the first place, y the distance.
	const Vec3d first  = Vec3d(m.position[star.ring[0]]) - p;
	Vec3d       last   = first, normal;
	double      sum    = 0;
	const auto  turnTo = [&](const Vec3d& spoke) {
        const Vec3d doubled = cross(last, spoke);
        sum += portable::angle(length(doubled), dot(last, spoke));
        normal += doubled;
        last = spoke;
	};
	flat[0] = {0, length(first)};
	for (int i = 1; i < n; ++i) {
		turnTo(Vec3d(m.position[star.ring[i]]) - p);
		flat[i] = {sum, length(last)};
	}
	if (star.isClosed) turnTo(first);
	const double scale = sum > 0 ? (star.isClosed ? 2 : 1) * pi / sum : 0;
	for (Vec2d& q : flat) {
		const double angle = q.x * scale, distance = q.y;
		q = {distance * portable::cos(angle), distance * portable::sin(angle)};
	}
	return normalized(normal);
}

bool HoleRetriangulator::remove(int v, const HoleRules& rules)
{
	collectStar(m_, v, star_);
	if (star_.placeNum() > maxPlaces) return false;
	const Vec3f normal(flattenStar(m_, star_, flat_));
	delaunay_.forbidden.clear();
	if (!delaunay_.triangulate(flat_, patch_)) return false;
	if (!keeps(rules, normal)) return false;
	if (!canRemoveVertex(m_, star_, patch_, scratch_)) {
		forbidPresentEdges();
		if (delaunay_.forbidden.empty() || !delaunay_.triangulate(flat_, patch_)) return false;
		if (!keeps(rules, normal) || !canRemoveVertex(m_, star_, patch_, scratch_)) return false;
	}
	removeVertex(m_, star_, patch_, scratch_);
	return true;
}

/// Forbids edges between places of the ring that exist outside the star.
void HoleRetriangulator::forbidPresentEdges()
{
	const int n = star_.placeNum();
	for (int i = 0; i < n; ++i) {
		for (int j = i + 2; j < n; ++j) {
			const bool isRingEdge = i == 0 && j == n - 1;
			if (!isRingEdge && m_.areNeighbours(star_.ring[i], star_.ring[j]))
				delaunay_.forbidden.push_back({i, j});
		}
	}
}

bool HoleRetriangulator::keeps(const HoleRules& rules, const Vec3f& normal) const
{
	for (int x = 0; x < int(patch_.corner.size()); x += 3) {
		const Vec3f a = m_.position[star_.ring[patch_.corner[x]]];
		const Vec3f b = m_.position[star_.ring[patch_.corner[x + 1]]];
		const Vec3f c = m_.position[star_.ring[patch_.corner[x + 2]]];
		const Vec3f n = cross(b - a, c - a);
		if (dot(n, normal) < rules.minCosine * length(n)) return false;
		const float longest =
			std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
		if (longest > rules.longestSquared) return false;
	}
	return true;
}

ResultMesh removeOriginalVertices(FusedMesh&& fused, const Surface& surface,
								  const Sampling& sampling, const BoundaryCurves& boundary,
								  const OctreeBlocks& partition, Workers& workers)
{
	Removal removal(fused, partition, workers);
	removal.runInBlocks();
	std::vector<int> rest = removal.runRest();
	collapseRest(fused.mesh, {}, rest, workers);
	Retriangulated removed{
		std::move(fused.mesh), std::move(fused.sampleVertex), {}, std::move(rest)};
	return resultOfSamples(std::move(removed), surface, sampling, boundary, workers);
}

} // namespace gpr
