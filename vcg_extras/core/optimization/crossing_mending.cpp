// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "crossing_mending.h"

#include "fold_repair.h"
#include "patch_mover.h"

#include <vcg_extras/core/mesh/crossing_faces.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace gpr {

namespace {

/// Rounds over all faces that cross.
constexpr int mostRounds = 4;
/// Faces that are tried in all.
constexpr int mostTries = 200;
/// Pairs of faces looked at in all. Where triangles are far larger than the surface's parts each
/// try looks at so many that it would take seconds, and mends nothing.
constexpr std::int64_t mostPairs = 4000000;
/// What measuring a face's distance costs, in pairs.
constexpr std::int64_t pairsPerDistance = 2000;
/// Lengths of moves, of the mean edge round the vertex.
constexpr float moveShares[] = {0.05f, 0.1f, 0.2f, 0.35f, 0.5f};
/// The surface may come to lie this share of an edge away.
constexpr float farthestShare = 0.1f;
/// No face may come to agree less with the surface's normals than this, or than before.
constexpr float leastAgreement = 0.3f;

class CrossingMender : PatchMover {
public:
	CrossingMender(const Surface& surface, const BoundaryCurves& curves, float angle,
				   ResultMesh& result, Workers& workers, const CellsOfFaces& cells) :
			PatchMover(surface, curves, angle, result, workers, cells)
	{
	}

	/// Returns those that still cross others.
	std::vector<int> run(std::vector<int> crossing)
	{
		for (int round = 0; round < mostRounds && !crossing.empty(); ++round) {
			const bool better = mendEach(crossing);
			crossing          = stillCrossing(crossing);
			if (!better) break;
		}
		return crossing;
	}

private:
	int              triesLeft_ = mostTries;
	std::int64_t     pairsLeft_ = mostPairs;
	std::vector<int> near_; ///< what faces of the patch at hand may cross

	/// What faces of a patch are like; the fewer crossings the better.
	struct State {
		int   crossingNum;
		float leastAngle, agreement, far;
	};

	bool mendEach(const std::vector<int>& crossing)
	{
		bool better = false;
		for (int f : crossing) {
			if (triesLeft_-- <= 0 || pairsLeft_ <= 0) return false;
			better = mend(f) || better;
		}
		return better;
	}

	std::vector<int> stillCrossing(const std::vector<int>& faces) const
	{
		return findCrossingFaces(m_, facesRound(m_, verticesOf(m_, faces)), workers_);
	}

	bool mend(int f)
	{
		workers_.poll();
		const std::vector<int> ring = facesRound(m_, verticesOf(m_, {f}));
		near_ = facesNear(m_, facesRound(m_, verticesOf(m_, ring)), meanEdge(m_.origin[3 * f]),
						  workers_);
		bool better = false;
		for (int k = 0; k < 3 && isCrossing(f); ++k)
			better = move(m_.origin[3 * f + k]) || better;
		for (int k = 0; k < 3 && isCrossing(f); ++k)
			better = flipAway(3 * f + k) || better;
		return better;
	}

	int crossingNum(const std::vector<int>& faces)
	{
		pairsLeft_ -= std::int64_t(faces.size() * near_.size());
		return countCrossingPairs(m_, faces, near_);
	}

	bool isCrossing(int f) { return crossingNum({f}) > 0; }

	State stateOf(const std::vector<int>& faces)
	{
		pairsLeft_ -= pairsPerDistance * std::int64_t(faces.size());
		return {crossingNum(faces), leastAngleOf(faces), patchQuality(faces).agreement,
				farthestFrom(faces, faces)};
	}

	/// Whether `now` may take the place of `before`, from which all began.
	bool mayReplace(const State& now, const State& before, float edge) const
	{
		return now.leastAngle >= std::min(angle_, before.leastAngle) &&
			   now.agreement >= std::min(leastAgreement, before.agreement) &&
			   now.far <= std::max(farthestShare * edge, before.far);
	}

	bool move(int v)
	{
		if (!mayMove(v)) return false;
		const std::vector<int> faces  = facesRound(m_, {v});
		const State            before = stateOf(faces);
		if (before.crossingNum == 0) return false;
		const float edge = meanEdge(v);
		Place       best = placeOf(v);
		int         num  = before.crossingNum;
		for (float share : moveShares) {
			if (pairsLeft_ <= 0) break;
			for (const Place& place : placesAt(v, share * edge, edge)) {
				put(v, place);
				if (crossingNum(faces) >= num) continue; // before the dearer rest of a state
				const State now = stateOf(faces);
				if (!mayReplace(now, before, edge)) continue;
				num  = now.crossingNum;
				best = place;
			}
			put(v, best);
			if (num < before.crossingNum) return true;
		}
		return false;
	}

	/// Along the surface, and for vertices off curves up and down.
	std::vector<Place> placesAt(int v, float reach, float edge) const
	{
		std::vector<Place> places = placesRound(v, reach, edge);
		if (r_.vertex[v].curve >= 0) return places;
		for (float by : {-reach, reach}) {
			Place place = placeOf(v);
			place.position += normalized(place.normal) * by;
			places.push_back(place);
		}
		return places;
	}

	bool flipAway(int h)
	{
		if (!mayFlip(h)) return false;
		const std::array<int, 4> corners = cornersAt(h);
		const std::vector<int>   faces   = facesRound(m_, {corners.begin(), corners.end()});
		const State              before  = stateOf(faces);
		flip(m_, h);
		const State now = stateOf(faces);
		if (now.crossingNum < before.crossingNum && mayReplace(now, before, meanEdge(corners[0]))) {
			++r_.flipNum;
			return true;
		}
		flip(m_, nextInFace(h));
		return false;
	}
};

} // namespace

std::vector<int> mendCrossings(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
							   const std::vector<int>& suspects, const Cells& cells,
							   ResultMesh& result, Workers& workers)
{
	if (suspects.empty()) return {};
	std::vector<int> crossing = findCrossingFaces(result.mesh, suspects, workers);
	if (crossing.empty()) return {};
	const CellsOfFaces own{cells, {}, 0};
	return CrossingMender(surface, curves, angleDeg * radians, result, workers, own)
		.run(std::move(crossing));
}

} // namespace gpr
