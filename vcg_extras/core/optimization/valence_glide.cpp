// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "valence_glide.h"

#include <vcg_extras/core/mesh/coloured_grid.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/sectors.h>

namespace gpr {

namespace {

/// Limits of the valences after a flip.
constexpr int minValence = 4, maxValence = 8;
/// Width of the cells that threads share, in ideal edges: a chain of six flips seldom leaves the
/// reach of a cell.
constexpr float cellWidth = 14;
/// Vertices of more faces than this are no dislocations.
constexpr int maxNeighbours = 16;

/// Searches chains of flips within one cell.
class GlideSearch {
public:
	GlideSearch(ResultMesh& result, Buffer<int>& valence, const Buffer<char>& flat,
				const GridCell& cell) :
			m_(result.mesh),
			valence_(valence), flat_(flat), cell_(cell)
	{
	}

	/// Searches a chain from v.
	bool glide(int v, int depth)
	{
		for (int flips = 1; flips <= depth; ++flips) {
			if (goOnFrom(v, {0, flips, -1, -1})) return true;
		}
		return false;
	}

	std::int64_t flipNum() const { return flipNum_; }

private:
	/// State of a chain: the change of the energy so far, the flips left, and the last new edge,
	/// which must not be flipped back.
	struct State {
		int energy;
		int flipsLeft;
		int lastA, lastB;

		bool isLast(int a, int b) const
		{
			return (a == lastA && b == lastB) || (a == lastB && b == lastA);
		}
	};

	HalfEdgeMesh&       m_;
	Buffer<int>&        valence_;
	const Buffer<char>& flat_;
	const GridCell&     cell_;
	std::int64_t        flipNum_ = 0;

	bool isOurs(int v) const { return flat_[v] && cell_.reaches(m_.position[v]); }

	/// Tries the edges at v, a vertex with a face too many.
	bool goOnFrom(int v, const State& state)
	{
		int neighbour[maxNeighbours], halfEdge[maxNeighbours];
		int n = 0;
		forEachOutgoing(m_, v, [&](int h) {
			if (n == maxNeighbours) return;
			neighbour[n]  = m_.target(h);
			halfEdge[n++] = h;
		});
		for (int i = 0; i < n; ++i) {
			if (state.isLast(v, neighbour[i])) continue;
			// Undone flips may have renamed the half-edge: then its ends find the edge.
			int h = halfEdge[i];
			if (m_.origin[h] != v || m_.target(h) != neighbour[i])
				h = m_.findHalfEdge(v, neighbour[i]);
			if (flipAndGoOn(h, state)) return true;
		}
		return false;
	}

	bool flipAndGoOn(int h, const State& state)
	{
		if (h < 0 || m_.opposite[h] < 0) return false;
		const int a = m_.origin[h], b = m_.target(h), c = m_.apex(h), d = m_.apex(m_.opposite[h]);
		// Valences rule most flips out, and are looked at first.
		if (!valencesAllow(a, b, c, d)) return false;
		if (!isOurs(a) || !isOurs(b) || !isOurs(c) || !isOurs(d)) return false;
		const int energy = state.energy + flipEnergy(m_, valence_, h);
		if (energy > 0 || !flipKeepsShape(m_, h) || !canFlip(m_, h)) return false;
		turn(h);
		if (energy < 0) return true;
		if (state.flipsLeft > 1) {
			const State next{energy, state.flipsLeft - 1, c, d};
			for (int v : {a, b, c, d}) {
				if (valence_[v] >= 7 && goOnFrom(v, next)) return true;
			}
		}
		turn(m_.findHalfEdge(c, d));
		flipNum_ -= 2;
		return false;
	}

	bool valencesAllow(int a, int b, int c, int d) const
	{
		if (valence_[c] > 5 && valence_[d] > 5) return false;
		if (valence_[a] <= minValence || valence_[b] <= minValence) return false;
		return valence_[c] < maxValence && valence_[d] < maxValence;
	}

	void turn(int h)
	{
		--valence_[m_.origin[h]];
		--valence_[m_.target(h)];
		++valence_[m_.apex(h)];
		++valence_[m_.apex(m_.opposite[h])];
		flip(m_, h);
		++flipNum_;
	}
};

} // namespace

std::int64_t glideDislocations(ResultMesh& result, Workers& workers, int depth)
{
	const Buffer<char>     flat    = findFlatVertices(result.mesh, workers);
	Buffer<int>            valence = correctedValences(result.mesh, workers);
	const std::vector<int> crowded =
		workers.collectIf(valence.size(), [&](int v) { return valence[v] >= 7 && flat[v]; });
	const ColouredGrid cells = cutIntoGridCells(result.mesh, crowded, cellWidth * result.idealEdge);

	Buffer<std::int64_t> chains(crowded.size(), 0), flips(crowded.size(), 0);
	cells.forEachCell(workers, [&](const GridCell& cell, int) {
		GlideSearch search(result, valence, flat, cell);
		for (int i = cell.begin; i < cell.end; ++i) {
			const int v = cells.vertices[i];
			if (valence[v] >= 7) chains[cell.begin] += search.glide(v, depth);
		}
		flips[cell.begin] = search.flipNum();
	});
	std::int64_t kept = 0;
	for (std::size_t i = 0; i < crowded.size(); ++i) {
		kept += chains[i];
		result.flipNum += flips[i];
	}
	return kept;
}

} // namespace gpr
