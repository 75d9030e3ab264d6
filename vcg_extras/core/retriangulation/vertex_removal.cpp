// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_removal.h"

#include "sampled_result.h"
#include "voronoi_dual.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/coloured_grid.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// The rules of a pass.
struct PassRules {
	bool  sameLabelOnly;
	float minCosine; ///< of a new face's normal with the ring's mean normal; -2 = any
	int   tries;     ///< targets tried per vertex, best first
};

constexpr PassRules passRules[] = {
	{true, 0.1f, 3},   {true, 0.1f, 3},    {false, 0.1f, 3},
	{false, -0.5f, 3}, {false, -2.0f, 64}, {false, -2.0f, 64},
};

constexpr float noScore = -2;
/// Width of the cubes of space in which threads work, in r.
constexpr float workWidth = 20;

/// Removes vertices of a mesh; every thread has an object of its own.
class Remover {
public:
	/// label: per vertex, its Voronoi cell; read only by passes with sameLabelOnly.
	Remover(HalfEdgeMesh& mesh, const std::vector<int>& label, float longestEdge) :
			m_(mesh), label_(label), longestSquared_(longestEdge * longestEdge)
	{
	}

	/// Tries to merge v into a neighbour. Returns false if v stays for now.
	bool remove(int v, const PassRules& rules)
	{
		if (m_.isBorderVertex(v)) return removeAtBorder(v, rules);
		return m_.isCreaseVertex(v) ? removeOnCrease(v, rules) : removeInside(v, rules);
	}

private:
	struct Spoke {
		int   halfEdge;
		int   target;
		Vec3f place;
	};
	/// A way to merge a vertex into a neighbour: a half-edge, or for a border vertex whether to go
	/// forward.
	struct Way {
		int   way;
		float score;
	};

	HalfEdgeMesh&           m_;
	const std::vector<int>& label_;
	float                   longestSquared_;
	std::vector<Spoke>      ring_;
	std::vector<Way>        ways_;
	EditScratch             scratch_;

	bool isAllowed(int v, int target, const PassRules& rules) const
	{
		return !rules.sameLabelOnly || label_[target] == label_[v];
	}

	/// Tries the ways, the best first. Returns whether tryToMerge(way) was true for a way.
	template <class Merge>
	bool mergeBest(const PassRules& rules, const Merge& tryToMerge)
	{
		const auto isWorse = [](const Way& a, const Way& b) { return a.score < b.score; };
		for (int attempt = 0; attempt < rules.tries; ++attempt) {
			const auto best = std::max_element(ways_.begin(), ways_.end(), isWorse);
			if (best == ways_.end() || best->score <= noScore) return false;
			if (tryToMerge(best->way)) return true;
			best->score = noScore;
		}
		return false;
	}

	bool removeInside(int v, const PassRules& rules)
	{
		const Vec3f normal = collectRing(v);
		ways_.clear();
		for (const Spoke& s : ring_) {
			if (isAllowed(v, s.target, rules))
				ways_.push_back({s.halfEdge, scoreOf(s, normal, rules.minCosine)});
		}
		return mergeBest(rules, [&](int h) {
			if (!canCollapse(m_, h, scratch_)) return false;
			collapse(m_, h);
			return true;
		});
	}

	/// Fills ring_ and returns the mean normal.
	Vec3f collectRing(int v)
	{
		ring_.clear();
		forEachOutgoing(m_, v, [&](int h) {
			const int w = m_.target(h);
			ring_.push_back({h, w, m_.position[w]});
		});
		const Vec3f p = m_.position[v];
		Vec3f       sum;
		for (std::size_t i = 0, last = ring_.size() - 1; i < ring_.size(); last = i++)
			sum += cross(ring_[last].place - p, ring_[i].place - p);
		return normalized(sum);
	}

	/// The worst shape of the triangles after a move of v to t.
	float scoreOf(const Spoke& t, const Vec3f& normal, float minCosine) const
	{
		float worst = 1;
		for (std::size_t i = 0, last = ring_.size() - 1; i < ring_.size(); last = i++) {
			if (&ring_[i] == &t || &ring_[last] == &t) continue;
			const Vec3f e = ring_[last].place - t.place, g = ring_[i].place - t.place;
			const Vec3f n        = cross(e, g);
			const float doubled  = length(n);
			const float eSquared = squaredLength(e), gSquared = squaredLength(g);
			if (dot(n, normal) < minCosine * doubled) return noScore;
			if (eSquared > longestSquared_ || gSquared > longestSquared_) return noScore;
			const float edges =
				eSquared + gSquared + squaredLength(ring_[i].place - ring_[last].place);
			worst = std::min(worst, 3.4641016f * doubled / (edges + 1e-30f));
		}
		return worst;
	}

	/// Merges v into one of the two neighbours on the feature line.
	bool removeOnCrease(int v, const PassRules& rules)
	{
		ways_.clear();
		forEachOutgoing(m_, v, [&](int h) {
			if (m_.isCreaseEdge(h)) ways_.push_back({h, scoreOnCrease(h, rules)});
		});
		return mergeBest(rules, [&](int h) {
			if (!canCollapseAlongCrease(m_, h, scratch_)) return false;
			collapse(m_, h);
			return true;
		});
	}

	/// The worst shape after origin(h) is merged into target(h). Normals are compared face by face,
	/// as the two sides of a crease have no common normal.
	float scoreOnCrease(int h, const PassRules& rules) const
	{
		const int v = m_.origin[h], b = m_.target(h);
		if (!isAllowed(v, b, rules)) return noScore;
		const Vec3f p = m_.position[v];
		return worstAfter(v, b, [&](const Vec3f& now, const Vec3f& s, const Vec3f& t) {
			const Vec3f then  = cross(s - p, t - p);
			const float scale = length(then) * length(now);
			return dot(then, now) < rules.minCosine * scale;
		});
	}

	/// The worst shape after v is merged into b, or noScore if a face turns or has too long edges.
	template <class Turns>
	float worstAfter(int v, int b, const Turns& turns) const
	{
		const Vec3f q     = m_.position[b];
		float       worst = 1;
		forEachOutgoing(m_, v, [&](int h) {
			if (m_.target(h) == b || m_.apex(h) == b) return;
			const Vec3f s = m_.position[m_.target(h)], t = m_.position[m_.apex(h)];
			const bool  tooLong =
				squaredLength(s - q) > longestSquared_ || squaredLength(t - q) > longestSquared_;
			if (tooLong || turns(cross(s - q, t - q), s, t)) worst = noScore;
			worst = std::min(worst, triangleShape(q, s, t));
		});
		return worst;
	}

	bool removeAtBorder(int v, const PassRules& rules)
	{
		ways_ = {{1, scoreAlongBorder(v, true, rules)}, {0, scoreAlongBorder(v, false, rules)}};
		return mergeBest(rules, [&](int forward) {
			if (!canCollapseAlongBorder(m_, v, forward != 0, scratch_)) return false;
			collapseAlongBorder(m_, v, forward != 0);
			return true;
		});
	}

	float scoreAlongBorder(int v, bool forward, const PassRules& rules) const
	{
		const int b = borderNeighbour(m_, v, forward);
		if (!isAllowed(v, b, rules)) return noScore;
		const Vec3f p = m_.position[v];
		Vec3f       normal;
		forEachOutgoing(m_, v, [&](int h) {
			normal += cross(m_.position[m_.target(h)] - p, m_.position[m_.apex(h)] - p);
		});
		normal = normalized(normal);
		return worstAfter(v, b, [&](const Vec3f& now, const Vec3f&, const Vec3f&) {
			return dot(now, normal) < rules.minCosine * length(now);
		});
	}
};

bool reachesRing(const GridCell& cell, const HalfEdgeMesh& m, int v)
{
	return !anyNeighbour(m, v, [&](int w) { return !cell.reaches(m.position[w]); });
}

/// Runs a pass, grid cell by grid cell, over the vertices still to be removed with all neighbours
/// within reach of the cell.
void runPass(const HalfEdgeMesh& m, const ColouredGrid& cells, const PassRules& rules,
			 std::vector<Remover>& removers, std::vector<char>& isThere, Workers& workers)
{
	cells.forEachCell(workers, [&](const GridCell& cell, int worker) {
		for (int k = cell.begin; k < cell.end; ++k) {
			const int v = cells.vertices[k];
			if (k % 1024 == 0) workers.pollFrom(worker); // a cell may be the whole surface
			if (isThere[k] && reachesRing(cell, m, v) && removers[worker].remove(v, rules))
				isThere[k] = 0;
		}
	});
}

} // namespace

ResultMesh removeVertices(const Surface& surface, const Sampling& sampling,
						  const BoundaryCurves& boundary, const MeshFigures& input,
						  Workers& workers)
{
	VoronoiDual          cells = makeVoronoiDual(surface, sampling, boundary, input, workers);
	HalfEdgeMesh&        m     = cells.mesh;
	const ColouredGrid   work  = cutIntoGridCells(m, cells.todo, workWidth * sampling.radius);
	std::vector<char>    isThere(work.vertices.size(), 1);
	std::vector<Remover> removers(workers.threadNum(),
								  Remover(m, cells.label, 0.25f * workWidth * sampling.radius));
	for (const PassRules& rules : passRules)
		runPass(m, work, rules, removers, isThere, workers);
	cells.todo.clear();
	for (std::size_t k = 0; k < isThere.size(); ++k) {
		if (isThere[k]) cells.todo.push_back(work.vertices[k]);
	}
	std::sort(cells.todo.begin(), cells.todo.end());
	collapseRest(m, cells.label, cells.todo, workers);
	return resultOfSamples(std::move(cells), surface, sampling, boundary, workers);
}

void collapseRest(HalfEdgeMesh& m, const std::vector<int>& label, std::vector<int>& rest,
				  Workers& workers)
{
	Remover remover(m, label, HUGE_VALF);
	for (const PassRules& rules : passRules) {
		if (rest.empty()) return;
		if (rules.sameLabelOnly && label.empty()) continue;
		std::size_t left = 0;
		for (int v : rest) {
			workers.poll();
			if (!remover.remove(v, rules)) rest[left++] = v;
		}
		rest.resize(left);
	}
}

} // namespace gpr
