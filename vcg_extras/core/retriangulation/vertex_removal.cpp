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

	/// Tries to merge v into a neighbour, if all neighbours are within reach of the grid cell (or
	/// `cell` is null). Returns false if v stays for now.
	bool remove(int v, const PassRules& rules, const GridCell* cell)
	{
		if (cell != nullptr && !reachesRing(*cell, v)) return false;
		if (m_.isBorderVertex(v)) return removeAtBorder(v, rules);
		return m_.isCreaseVertex(v) ? removeOnCrease(v, rules) : removeInside(v, rules);
	}

private:
	struct Spoke {
		int   halfEdge;
		int   target;
		Vec3f place;
		float score;
	};

	HalfEdgeMesh&           m_;
	const std::vector<int>& label_;
	float                   longestSquared_;
	std::vector<Spoke>      ring_;
	EditScratch             scratch_;

	int labelOf(int v) const { return label_[v]; }

	bool reachesRing(const GridCell& cell, int v) const
	{
		bool all = true;
		forEachNeighbour(m_, v, [&](int w) { all = all && cell.reaches(m_.position[w]); });
		return all;
	}

	bool removeInside(int v, const PassRules& rules)
	{
		const Vec3f normal = collectRing(v);
		scoreTargets(rules.sameLabelOnly ? labelOf(v) : -1, normal, rules);
		for (int attempt = 0; attempt < rules.tries; ++attempt) {
			Spoke* best = nullptr;
			for (Spoke& s : ring_) {
				if (s.score > noScore && (best == nullptr || s.score > best->score)) best = &s;
			}
			if (best == nullptr) return false;
			if (canCollapse(m_, best->halfEdge, scratch_)) {
				collapse(m_, best->halfEdge);
				return true;
			}
			best->score = noScore;
		}
		return false;
	}

	/// Fills ring_ and returns the mean normal.
	Vec3f collectRing(int v)
	{
		ring_.clear();
		forEachOutgoing(m_, v, [&](int h) {
			const int w = m_.target(h);
			ring_.push_back({h, w, m_.position[w], noScore});
		});
		const Vec3f p = m_.position[v];
		Vec3f       sum;
		for (std::size_t i = 0, last = ring_.size() - 1; i < ring_.size(); last = i++)
			sum += cross(ring_[last].place - p, ring_[i].place - p);
		return normalized(sum);
	}

	void scoreTargets(int label, const Vec3f& normal, const PassRules& rules)
	{
		for (Spoke& t : ring_) {
			const bool allowed = !rules.sameLabelOnly || labelOf(t.target) == label;
			t.score            = allowed ? scoreOf(t, normal, rules.minCosine) : noScore;
		}
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

	/// A way to merge a vertex into a neighbour on its curve.
	struct Way {
		int   way;
		float score;
	};

	/// Tries the ways in turn, the best first.
	template <class Merge>
	static bool mergeBest(std::vector<Way> ways, const Merge& tryToMerge)
	{
		std::stable_sort(ways.begin(), ways.end(),
						 [](const Way& a, const Way& b) { return a.score > b.score; });
		return std::any_of(ways.begin(), ways.end(),
						   [&](const Way& w) { return w.score > noScore && tryToMerge(w.way); });
	}

	/// Merges v into one of the two neighbours on the feature line.
	bool removeOnCrease(int v, const PassRules& rules)
	{
		std::vector<Way> ways;
		forEachOutgoing(m_, v, [&](int h) {
			if (m_.isCreaseEdge(h)) ways.push_back({h, scoreOnCrease(h, rules)});
		});
		return mergeBest(std::move(ways), [&](int h) {
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
		if (rules.sameLabelOnly && labelOf(b) != labelOf(v)) return noScore;
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
		const auto merge = [&](int forward) {
			if (!canCollapseAlongBorder(m_, v, forward != 0, scratch_)) return false;
			collapseAlongBorder(m_, v, forward != 0);
			return true;
		};
		return mergeBest(
			{{1, scoreAlongBorder(v, true, rules)}, {0, scoreAlongBorder(v, false, rules)}}, merge);
	}

	float scoreAlongBorder(int v, bool forward, const PassRules& rules) const
	{
		const int b = borderNeighbour(m_, v, forward);
		if (rules.sameLabelOnly && labelOf(b) != labelOf(v)) return noScore;
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

/// Runs a pass over the vertices still to be removed, grid cell by grid cell.
void runPass(const ColouredGrid& cells, const PassRules& rules, std::vector<Remover>& removers,
			 std::vector<char>& isThere, Workers& workers)
{
	for (const std::vector<GridCell>& sameColour : cells.byColour) {
		workers.forTasks(sameColour.size(), [&](std::size_t i, int worker) {
			const GridCell& cell = sameColour[i];
			for (int k = cell.begin; k < cell.end; ++k) {
				const int v = cells.vertices[k];
				if (isThere[k] && removers[worker].remove(v, rules, &cell)) isThere[k] = 0;
			}
		});
	}
}

/// Removes the remaining vertices serially, without a bound on edges. Without labels, passes with
/// sameLabelOnly are skipped.
void removeRest(HalfEdgeMesh& m, const std::vector<int>& label, std::vector<int>& rest,
				Workers& workers)
{
	Remover remover(m, label, HUGE_VALF);
	for (const PassRules& rules : passRules) {
		if (rest.empty()) return;
		if (rules.sameLabelOnly && label.empty()) continue;
		std::size_t left = 0;
		for (int v : rest) {
			workers.poll();
			if (!remover.remove(v, rules, nullptr)) rest[left++] = v;
		}
		rest.resize(left);
	}
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
		runPass(work, rules, removers, isThere, workers);
	Retriangulated removed;
	for (std::size_t k = 0; k < isThere.size(); ++k) {
		if (isThere[k]) removed.leftover.push_back(work.vertices[k]);
	}
	std::sort(removed.leftover.begin(), removed.leftover.end());
	removeRest(m, cells.label, removed.leftover, workers);
	removed.mesh          = std::move(cells.mesh);
	removed.sampleVertex  = std::move(cells.sampleVertex);
	removed.surfaceVertex = std::move(cells.surfaceVertex);
	return resultOfSamples(std::move(removed), surface, sampling, boundary, workers);
}

void collapseRest(HalfEdgeMesh& m, std::vector<int>& rest, Workers& workers)
{
	const std::vector<int> noLabels;
	removeRest(m, noLabels, rest, workers);
}

} // namespace gpr
