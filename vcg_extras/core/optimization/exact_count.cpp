// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_count.h"

#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/edit/acceptance.h>
#include <vcg_extras/core/features/edge_middle.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/sectors.h>
#include <vcg_extras/core/surface/local_nearest.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <optional>
#include <tuple>

namespace gpr {

namespace {

/// The care about shapes and the corners of the border, from most careful to topology only.
enum class Care { FlatGroundOnly, SoundShapes, TopologyAndCorners, TopologyOnly };

/// The flips that accompany a split: the four edges of the quadrilateral w-c-x-d round the new
/// vertex, a bit each.
enum QuadEdge { WC = 1, XC = 2, WD = 4, XD = 8 };
/// Two flips at c, or two at d, are missing: c or d would lose two faces at once.
constexpr int splitPatterns[] = {0, WC, XC, WD, XD, WC | WD, XC | XD, WC | XD, XC | WD};

struct CountChange {
	int   energy; ///< change of Σ(valence - 6)²
	float rank;   ///< smaller first among equal energies
	int   halfEdge;
	int   pattern; ///< of the split

	bool operator<(const CountChange& o) const
	{
		return std::tie(energy, rank, halfEdge) < std::tie(o.energy, o.rank, o.halfEdge);
	}
};

/// The facts of a vertex that decide the order of operations.
struct Facts {
	float size    = 1; ///< local size
	int   valence = 6; ///< corrected
	bool  isFlat  = false;
};

class CountCorrector {
public:
	CountCorrector(const Surface& surface, const BoundaryCurves& boundary,
				   const CountTarget& target, ResultMesh& result, Workers& workers) :
			surface_(surface),
			boundary_(boundary), r_(result), m_(result.mesh), workers_(workers),
			byFaces_(target.faceNum > 0), innerStep_((byFaces_ ? 2 : 1) * m_.sideNum()),
			wanted_(byFaces_ ? target.faceNum : target.vertexNum),
			num_(byFaces_ ? result.faceNum() : result.vertexNum())
	{
	}

	bool run(std::initializer_list<Care> cares)
	{
		if (m_.mirrorAxis >= 0) {
			splitBorderAtMirror();
			splitOwnImages();
		}
		if ((wanted_ - num_) % innerStep_ != 0) changeBorderByOne();
		for (Care care : cares) {
			care_ = care;
			while (num_ != wanted_) {
				workers_.poll();
				const std::int64_t before = num_;
				changeRound();
				if (num_ == before) break;
			}
		}
		return num_ == wanted_;
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& boundary_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	bool                  byFaces_;   ///< the target counts faces, not vertices
	std::int64_t          innerStep_; ///< the change of the number by an inner vertex
	std::int64_t          wanted_;
	std::int64_t          num_; ///< of the result now
	Care                  care_ = Care::FlatGroundOnly;
	std::vector<Facts>    facts_; ///< per vertex
	std::vector<char>     used_;  ///< vertices whose surroundings changed in this round
	std::vector<int>      stale_; ///< vertices whose facts changed in this round
	EditScratch           scratch_;
	const Acceptance      limits_ = acceptanceOf(Driver::Count);

	// ---- common to both

	/// The change of the number by a split or collapse of an edge.
	std::int64_t stepOf(int h) const
	{
		if (!m_.isBorderEdge(h)) return innerStep_;
		if (byFaces_) return m_.sideNum();
		return isAlongMirror(h) ? 1 : innerStep_;
	}
	bool isAlongMirror(int h) const
	{
		return m_.isOnMirror(m_.origin[h]) && m_.isOnMirror(m_.target(h));
	}
	/// The number of vertices still to add or remove; a smaller last step is at the border.
	std::int64_t leftNum() const
	{
		return (std::abs(wanted_ - num_) + innerStep_ - 1) / innerStep_;
	}
	bool fits(int h) const { return std::abs(wanted_ - num_) >= stepOf(h); }

	/// Only facts that changed are found anew: a mesh of many pieces needs hundreds of rounds.
	void beginRound()
	{
		const int known = int(facts_.size());
		facts_.resize(std::size_t(m_.vertexNum));
		workers_.forEach(std::size_t(m_.vertexNum - known), [&](int i) { findFacts(known + i); });
		sortUniqueBelow(m_.vertexNum, stale_); // no two threads find the facts of the same vertex
		workers_.forEach(stale_.size(), [&](int i) { findFacts(stale_[i]); });
		stale_.clear();
		used_.assign(m_.vertexNum, 0);
	}

	void findFacts(int v)
	{
		facts_[v] = {sizeAt(surface_, r_.vertex[v].point), correctedValence(m_, v), isFlat(m_, v)};
	}

	/// The star of v changed.
	void use(int v)
	{
		used_[v] = 1;
		stale_.push_back(v);
	}

	/// The operations of a round, in order. Expensive operations at the end are cut off, because
	/// fresh valences offer cheaper operations in the next round.
	std::vector<CountChange> chosen(std::vector<CountChange>&& all) const
	{
		const std::int64_t left = leftNum();
		// With topology only, the order must not depend on the wanted number.
		const std::size_t most = std::size_t(4 * left + 64);
		if (!isByTopology() && all.size() > most) {
			std::nth_element(all.begin(), all.begin() + most, all.end());
			all.resize(most);
		}
		if (care_ == Care::FlatGroundOnly && !all.empty()) {
			const auto few = all.begin() + std::min(all.size() - 1, std::size_t(left / 8));
			std::nth_element(all.begin(), few, all.end());
			const int  last   = std::max(0, few->energy);
			const auto isOver = [&](const CountChange& op) { return op.energy > last; };
			all.erase(std::remove_if(all.begin(), all.end(), isOver), all.end());
		}
		sortPolled(all.begin(), all.end(), workers_);
		return std::move(all);
	}

	/// Whether shapes do not count.
	bool isByTopology() const { return care_ >= Care::TopologyAndCorners; }

	bool isUsed(int v) const { return v >= int(used_.size()) || used_[v]; }

	int valence(int v) const { return facts_[v].valence; }

	bool allFlat(int a, int b, int c, int d) const
	{
		return facts_[a].isFlat && facts_[b].isFlat && facts_[c].isFlat && facts_[d].isFlat;
	}

	/// The length of an edge over the local size.
	float relativeLength(int h) const
	{
		const int   a = m_.origin[h], b = m_.target(h);
		const float straight = length(m_.position[b] - m_.position[a]);
		return straight / (0.5f * (facts_[a].size + facts_[b].size));
	}

	/// The operations that find(h, mostEnergy) returns for all half-edges, up to that energy.
	template <class Find>
	std::vector<CountChange> collectUpTo(int mostEnergy, const Find& find) const
	{
		return workers_.collectEach<CountChange>(m_.halfEdgeNum(), [&](int h, auto& out) {
			if (isDeadFace(m_, h / 3)) return;
			const std::optional<CountChange> op = find(h, mostEnergy);
			if (op && op->energy <= mostEnergy) out.push_back(*op);
		});
	}

	/// The operations of a round. On flat ground there are mostly enough operations of energy 0;
	/// then the many other operations, which would all be cut off, are not collected.
	template <class Find>
	std::vector<CountChange> operationsOfRound(const Find& find) const
	{
		if (care_ == Care::FlatGroundOnly) {
			std::vector<CountChange> free = collectUpTo(0, find);
			if (std::int64_t(free.size()) > leftNum() / 8) return chosen(std::move(free));
		}
		return chosen(collectUpTo(std::numeric_limits<int>::max(), find));
	}

	/// Splits edges, or collapses edges, until the number is reached or no operation is left.
	void changeRound()
	{
		beginRound();
		const bool toSplit = num_ < wanted_;
		const auto find    = [&](int h, int most) {
            return toSplit ? findSplit(h, most) : findCollapse(h);
		};
		const std::vector<CountChange> operations = operationsOfRound(find);
		const int                      left       = int(std::abs(wanted_ - num_));
		if (toSplit) reserve(m_, m_.vertexNum + left, m_.faceNum + 2 * left);
		for (const CountChange& op : operations) {
			if (num_ == wanted_) return;
			workers_.poll();
			if (!isDeadFace(m_, op.halfEdge / 3) && fits(op.halfEdge)) make(op, toSplit);
		}
	}

	/// Splits or collapses an edge. False if this is not allowed now.
	bool make(const CountChange& op, bool toSplit)
	{
		const std::int64_t step   = stepOf(op.halfEdge);
		const bool         isMade = toSplit ? split(op) : collapse(op.halfEdge);
		if (isMade) num_ += toSplit ? step : -step;
		return isMade;
	}

	// ---- splitting

	bool split(const CountChange& op)
	{
		return m_.isBorderEdge(op.halfEdge) ? splitAtBorder(op.halfEdge) : splitInside(op);
	}

	bool isSplittableBorder(int h) const
	{
		return isByTopology() && m_.opposite[h] < 0 && maySplitBorder(r_, h) &&
			   r_.vertex[m_.origin[h]].curve >= 0 && r_.vertex[m_.target(h)].curve >= 0;
	}

	/// Finds the best split of an edge. Valences are tested first, because few edges pass if little
	/// energy is allowed.
	std::optional<CountChange> findSplit(int h, int mostEnergy) const
	{
		if (m_.isCreaseEdge(h)) return {};
		if (isSplittableBorder(h)) return CountChange{1000, -relativeLength(h), h, 0};
		if (m_.opposite[h] <= h) return {};
		const SplitEnergies energies = energiesOf(h);
		if (energies.least() > mostEnergy) return {};
		CountChange best{energies.of(0), 0, h, 0};
		if (care_ == Care::FlatGroundOnly) {
			for (int pattern : splitPatterns) {
				const int energy = energies.of(pattern);
				if (energy >= best.energy || !patternAllowed(h, pattern)) continue;
				best.energy  = energy;
				best.pattern = pattern;
			}
		}
		if (best.energy > mostEnergy) return {};
		const int c = m_.apex(h), d = m_.apex(m_.opposite[h]);
		if (care_ == Care::FlatGroundOnly && !allFlat(m_.origin[h], m_.target(h), c, d)) return {};
		best.rank = -relativeLength(h);
		return best;
	}

	/// The vertex beyond the edge of a bit, before the split; or -1.
	int beyond(int h, int bit) const
	{
		const int g       = m_.opposite[h];
		const int edges[] = {prevInFace(h), nextInFace(h), nextInFace(g), prevInFace(g)};
		const int out     = m_.opposite[edges[bit]];
		return out < 0 ? -1 : m_.apex(out);
	}

	bool patternAllowed(int h, int pattern) const
	{
		for (int bit = 0; bit < 4; ++bit) {
			if (!(pattern >> bit & 1)) continue;
			const int y = beyond(h, bit);
			if (y < 0 || !facts_[y].isFlat) return false;
		}
		const int lostW = !!(pattern & WC) + !!(pattern & WD);
		const int lostX = !!(pattern & XC) + !!(pattern & XD);
		return (lostW == 0 || valence(m_.origin[h]) - lostW >= 5) &&
			   (lostX == 0 || valence(m_.target(h)) - lostX >= 5);
	}

	/// The change of Σ(valence - 6)² by a split of an edge, separately for each vertex involved.
	struct SplitEnergies {
		int ends[2][3];   ///< w and x after the loss of 0, 1 or 2 neighbours
		int apexes[2][2]; ///< c and d, with 1 or 0 neighbours more
		int beyond[4];    ///< the vertices beyond WC, XC, WD, XD, with 1 neighbour more

		int of(int pattern) const
		{
			const int wc = pattern & 1, xc = pattern >> 1 & 1, wd = pattern >> 2 & 1,
					  xd = pattern >> 3;
			return squaredDefect(4 + wc + xc + wd + xd) + ends[0][wc + wd] + ends[1][xc + xd] +
				   apexes[0][wc + xc] + apexes[1][wd + xd] + wc * beyond[0] + xc * beyond[1] +
				   wd * beyond[2] + xd * beyond[3];
		}

		/// A lower bound for all patterns, which have at most two flips.
		int least() const
		{
			const auto leastOf = [](const int(&e)[3]) { return std::min({e[0], e[1], e[2]}); };
			const int  flip    = std::min({beyond[0], beyond[1], beyond[2], beyond[3]});
			return leastOf(ends[0]) + leastOf(ends[1]) + std::min(apexes[0][0], apexes[0][1]) +
				   std::min(apexes[1][0], apexes[1][1]) +
				   std::min({squaredDefect(4), squaredDefect(5) + flip, 2 * flip});
		}
	};

	SplitEnergies energiesOf(int h) const
	{
		const auto by = [](int before, int more) {
			return squaredDefect(before + more) - squaredDefect(before);
		};
		SplitEnergies e;
		for (int k = 0; k < 2; ++k) {
			const int side = k == 0 ? h : m_.opposite[h];
			const int end = valence(m_.origin[side]), apex = valence(m_.apex(side));
			for (int less = 0; less < 3; ++less)
				e.ends[k][less] = by(end, -less);
			e.apexes[k][0] = by(apex, 1);
			e.apexes[k][1] = 0;
		}
		for (int k = 0; k < 4; ++k) {
			const int y = beyond(h, k);
			e.beyond[k] = y < 0 ? 0 : by(valence(y), 1); // no flip is allowed there
		}
		return e;
	}

	bool splitInside(const CountChange& op)
	{
		const int h = op.halfEdge;
		const int w = m_.origin[h], x = m_.target(h), c = m_.apex(h), d = m_.apex(m_.opposite[h]);
		std::vector<int> touched = {w, x, c, d};
		for (int bit = 0; bit < 4; ++bit) {
			if (op.pattern >> bit & 1) touched.push_back(beyond(h, bit));
		}
		if (std::any_of(touched.begin(), touched.end(), [&](int u) { return isUsed(u); }))
			return false;
		ResultVertex middle;
		if (!findMiddle(surface_, r_, w, x, middle)) return false;

		const int g = m_.opposite[h], added = m_.halfEdgeNum();
		splitEdge(m_, h, append(middle));
		const int edges[] = {prevInFace(h), added + 1, nextInFace(g), added + 5};
		for (int bit = 0; bit < 4; ++bit) {
			if (op.pattern >> bit & 1) flipAfterSplit(edges[bit]);
		}
		for (int u : touched)
			use(u);
		return true;
	}

	void flipAfterSplit(int h)
	{
		if (m_.opposite[h] < 0 || !canFlip(m_, h)) return;
		if (flipKeepsShape(m_, h)) flip(m_, h);
	}

	/// The middle of a border edge and its place: on the curve, or straight between vertices made
	/// by the guard, which are on no curve.
	ResultVertex middleOfBorderEdge(int h, Vec3f& place) const
	{
		const int           a = m_.origin[h], b = m_.target(h);
		const ResultVertex &ra = r_.vertex[a], &rb = r_.vertex[b];
		ResultVertex        middle;
		if (ra.curve < 0 || rb.curve < 0) {
			place         = (m_.position[a] + m_.position[b]) * 0.5f;
			middle.isMade = true;
			middle.point =
				nearestByDescent(surface_.mesh, surface_.mesh.origin[3 * ra.point.face], place);
		}
		else {
			const Curve& c = boundary_.curves[ra.curve];
			middle.curve   = ra.curve;
			middle.arc     = c.wrap(ra.arc + 0.5f * c.wrap(rb.arc - ra.arc));
			middle.point   = {c.at(middle.arc), c.faceAt(middle.arc)};
			place          = middle.point.position;
		}
		middle.normal = surface_.mesh.faceNormal(middle.point.face);
		return middle;
	}

	bool splitAtBorder(int h)
	{
		const int a = m_.origin[h], b = m_.target(h);
		if (isUsed(a) || isUsed(b) || isUsed(m_.apex(h))) return false;
		Vec3f              place;
		const ResultVertex middle = middleOfBorderEdge(h, place);
		if (place == m_.position[a] || place == m_.position[b]) return false;
		stale_.push_back(m_.apex(h));
		splitBorderEdge(m_, h, append(middle, place));
		use(a);
		use(b);
		return true;
	}

	int append(const ResultVertex& vertex) { return append(vertex, vertex.point.position); }
	int append(const ResultVertex& vertex, const Vec3f& place)
	{
		const int v    = m_.vertexNum++;
		m_.position[v] = place;
		r_.vertex.push_back(vertex);
		++r_.splitNum;
		return v;
	}

	/// Finds the middle of an edge above the mirror plane. On a surface that bends over the edge,
	/// like a thin tube along the plane, no walk along the edge finds the middle; a descent from a
	/// point above does.
	bool findMiddleAboveMirror(int a, int b, ResultVertex& middle) const
	{
		const auto height = [&] { return coordinate(middle.point.position, m_.mirrorAxis); };
		if (findMiddle(surface_, r_, a, b, middle) && height() > 0) return true;
		const Vec3f pa = m_.position[a], pb = m_.position[b];
		Vec3f       above = (pa + pb) * 0.5f;
		setCoordinate(above, m_.mirrorAxis, 0.5f * length(pb - pa));
		middle        = ResultVertex();
		middle.point  = nearestByDescent(surface_.mesh,
										 surface_.mesh.origin[3 * r_.vertex[a].point.face], above);
		middle.normal = surface_.mesh.faceNormal(middle.point.face);
		return height() > 0;
	}

	/// Whether a face has all its edges on the border at the mirror plane.
	bool isFlatHalf(int f) const
	{
		const auto isCut = [&](int h) { return m_.isBorderEdge(h) && isAlongMirror(h); };
		return isCut(3 * f) && isCut(3 * f + 1) && isCut(3 * f + 2);
	}

	/// Splits the border edges that need a vertex between two vertices on the mirror plane: edges
	/// of a border that leaves the plane between the vertices, and an edge of each component that
	/// is a single face on the plane.
	void splitBorderAtMirror()
	{
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			if (isDeadFace(m_, h / 3) || !m_.isBorderEdge(h) || !isAlongMirror(h)) continue;
			Vec3f middle;
			middleOfBorderEdge(h, middle);
			if (m_.multiplicity(middle) == 1 && !isFlatHalf(h / 3)) continue;
			reserve(m_, m_.vertexNum + 1, m_.faceNum + 1);
			used_.assign(m_.vertexNum, 0);
			if (splitAtBorder(h)) num_ += byFaces_ ? m_.sideNum() : m_.multiplicity(middle);
		}
	}

	/// Splits inner edges between two vertices on the mirror plane, left by the neighbourhood of
	/// the samples: see mesh_edit.h.
	void splitOwnImages()
	{
		const auto isOwnImage = [&](int h) {
			return !isDeadFace(m_, h / 3) && !m_.isBorderEdge(h) && isAlongMirror(h);
		};
		const int mostNum =
			int(workers_.collectIf(std::size_t(m_.halfEdgeNum()), isOwnImage).size());
		reserve(m_, m_.vertexNum + mostNum, m_.faceNum + 2 * mostNum);
		for (int h = 0; h < m_.halfEdgeNum(); ++h) { // a split moves edges to later half-edges
			ResultVertex middle;
			if (!isOwnImage(h)) continue;
			if (!findMiddleAboveMirror(m_.origin[h], m_.target(h), middle)) continue;
			splitEdge(m_, h, append(middle));
			num_ += innerStep_;
		}
	}

	// ---- collapsing

	bool collapse(int h) { return m_.isBorderEdge(h) ? collapseAtBorder(h) : collapseInside(h); }

	std::optional<CountChange> findCollapse(int h) const
	{
		if (m_.opposite[h] < 0) {
			constexpr int       energy = 1000; // after inner edges
			const ResultVertex& v      = r_.vertex[m_.origin[h]];
			// A junction needs the vertex on every sheet.
			const bool isHeld = v.isPinned || (m_.meetsAtPlaces && v.isShared) ||
								(v.isCorner && care_ == Care::TopologyAndCorners);
			if (isByTopology() && !isHeld) return CountChange{energy, relativeLength(h), h, 0};
			return {};
		}
		const int a = m_.origin[h], b = m_.target(h), c = m_.apex(h), d = m_.apex(m_.opposite[h]);
		if (!isFree(r_, a)) return {};
		const bool seenFromOtherSide = isFree(r_, b) && m_.opposite[h] < h;
		if (seenFromOtherSide && !isByTopology()) return {};
		if (care_ == Care::FlatGroundOnly && !allFlat(a, b, c, d)) return {};
		if (!isByTopology() && (valence(c) <= 4 || valence(d) <= 4)) return {};
		const int energy = squaredDefect(valence(a) + valence(b) - 4) +
						   squaredDefect(valence(c) - 1) + squaredDefect(valence(d) - 1) -
						   squaredDefect(valence(a)) - squaredDefect(valence(b)) -
						   squaredDefect(valence(c)) - squaredDefect(valence(d));
		return CountChange{energy, relativeLength(h), h, 0};
	}

	bool ringIsUnused(int v) const
	{
		return !isUsed(v) && !anyNeighbour(m_, v, [&](int w) { return isUsed(w); });
	}

	void markRing(int v)
	{
		use(v);
		forEachNeighbour(m_, v, [&](int w) { use(w); });
	}

	bool collapseInside(int h)
	{
		const int a = m_.origin[h], b = m_.target(h);
		if (!ringIsUnused(a) || !ringIsUnused(b) || !canCollapse(m_, h, scratch_)) return false;
		ResultVertex survivor = r_.vertex[b];
		if (isFree(r_, b)) {
			ResultVertex middle;
			if (findMiddle(surface_, r_, a, b, middle))
				survivor = middle;
			else if (care_ == Care::FlatGroundOnly)
				return false;
		}
		if (!shapesAllowCollapse(a, b, survivor.point.position)) return false;
		markRing(a);
		markRing(b);
		gpr::collapse(m_, h);
		r_.vertex[b]   = survivor;
		m_.position[b] = survivor.point.position;
		++r_.collapseNum;
		return true;
	}

	/// Whether the remaining faces of both rings are sound with a and b at p.
	bool shapesAllowCollapse(int a, int b, const Vec3f& p) const
	{
		if (isByTopology()) return true;
		return !spoilsRing(limits_, m_, a, p, b) && !spoilsRing(limits_, m_, b, p, a);
	}

	bool collapseAtBorder(int h)
	{
		const int v = m_.origin[h];
		if (!ringIsUnused(v) || !ringIsUnused(m_.target(h))) return false;
		if (!canCollapseAlongBorder(m_, v, true, scratch_)) return false;
		markRing(v);
		markRing(m_.target(h));
		collapseAlongBorder(m_, v, true);
		++r_.collapseNum;
		return true;
	}

	// ---- the border

	bool isCollapsibleBorder(int h) const
	{
		const ResultVertex& v = r_.vertex[m_.origin[h]];
		return !r_.keepsBorder && !v.isPinned && !v.isCorner && !v.isShared;
	}

	/// The split or collapse of a border edge that changes the number by less than an inner edge.
	std::optional<CountChange> findBorderChange(int h, bool toSplit) const
	{
		if (!m_.isBorderEdge(h) || stepOf(h) == innerStep_) return {};
		if (!(toSplit ? isSplittableBorder(h) : isCollapsibleBorder(h))) return {};
		return CountChange{0, toSplit ? -relativeLength(h) : relativeLength(h), h, 0};
	}

	/// Splits or collapses a border edge, if any border edge allows that.
	void changeBorderByOne()
	{
		care_ = Care::TopologyOnly;
		beginRound();
		reserve(m_, m_.vertexNum + 1, m_.faceNum + 1);
		for (const bool toSplit : {true, false}) {
			const auto find = [&](int h, int) { return findBorderChange(h, toSplit); };
			for (const CountChange& op : operationsOfRound(find)) {
				if (make(op, toSplit)) return;
			}
		}
	}
};

} // namespace

bool reachExactCount(const Surface& surface, const BoundaryCurves& boundary,
					 const CountTarget& target, ResultMesh& result, Workers& workers)
{
	const bool isReached = changeCount(surface, boundary, target, result, workers);
	compactResult(result, workers);
	return isReached;
}

bool changeCount(const Surface& surface, const BoundaryCurves& boundary, const CountTarget& target,
				 ResultMesh& result, Workers& workers)
{
	return CountCorrector(surface, boundary, target, result, workers)
		.run({Care::FlatGroundOnly, Care::SoundShapes, Care::TopologyAndCorners,
			  Care::TopologyOnly});
}

bool reachCountByTopology(const Surface& surface, const BoundaryCurves& boundary,
						  const CountTarget& target, ResultMesh& result, Workers& workers)
{
	CountCorrector corrector(surface, boundary, target, result, workers);
	const bool     isReached = corrector.run({Care::TopologyAndCorners, Care::TopologyOnly});
	compactResult(result, workers);
	return isReached;
}

} // namespace gpr
