// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "crease_lines.h"

#include "boundary_curves.h"
#include "close_lines.h"
#include "crease_clearance.h"

#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gpr {

namespace {

/// A connected set of lines is noise if the set is shorter than clearLength mean edges and has
/// fewer edges than clearEdgeNum. The length is not enough: on a part with long needles, the rim of
/// a pin of 60 edges is shorter than three mean edges.
constexpr float       clearLength  = 4;
constexpr std::size_t clearEdgeNum = 8;
/// Least share of the sharp length that is clear of noise: CAD models have 0.77 and more, scans up
/// to 0.47.
constexpr float clearShare = 0.7f;
/// Least cosine between a line and the edge that continues it.
constexpr float goOnCosine = 0.5f;
/// The angle defects of neighbours of a cone apex are at most this share of its own defect.
constexpr float apexContrast = 0.2f;

/// The lines under way: a graph of edges, each named by its smaller half-edge.
class CreaseGraph {
public:
	CreaseGraph(Surface& surface, const CreaseRules& rules, Workers& workers) :
			surface_(surface), m_(surface.mesh), rules_(rules), workers_(workers)
	{
	}

	CreaseFindings run()
	{
		CreaseFindings   found;
		std::vector<int> sharp = findSharpEdges();
		if (!sharp.empty()) {
			markAll(sharp);
			if (rules_.mode == FeatureMode::Auto && looksLikeNoise(among(sharp, false))) {
				m_.crease.release();
				sharp = among(sharp, true);
				if (sharp.empty()) return found;
				markAll(sharp);
			}
			growFromEnds(sharp);
			found.creaseNum = std::int64_t(edges_.size());
			dropShortOnes();
		}
		// Before close lines go: their corners are no cone apexes.
		found.coneApexes = workers_.collectIf(m_.vertexNum, [&](int v) { return isConeApex(v); });
		if (rules_.mode == FeatureMode::Auto && rules_.minGap > 0) dropCloseOnes();
		found.edgeNum        = std::int64_t(edges_.size());
		found.spareDoublings = spareDoublings_;
		if (edges_.empty()) m_.crease.release();
		return found;
	}

private:
	const Surface&     surface_;
	HalfEdgeMesh&      m_;
	const CreaseRules& rules_;
	Workers&           workers_;
	std::vector<int>   edges_;                          ///< the marked edges
	int                spareDoublings_ = mostDoublings; ///< see CreaseFindings

	// ---- crease edges

	/// The edges sharper than strongDeg, each by its smaller half-edge, ascending. If every edge
	/// sought makes its vertices rough, only rough vertices are visited; a degree is left for
	/// rounding.
	std::vector<int> findSharpEdges() const
	{
		const float      cosine = float(portable::cos(double(rules_.strongDeg * radians)));
		const bool       atAll  = rules_.strongDeg < roughDeg + 1;
		std::vector<int> sharp  = workers_.collectEach<int>(m_.vertexNum, [&](int v, auto& out) {
            if (!atAll && !surface_.normal[v].isRough()) return;
            forEachOutgoing(m_, v, [&](int h) {
                if (m_.opposite[h] > h && isSharpEdge(m_, h, cosine)) out.push_back(h);
            });
        });
		std::sort(sharp.begin(), sharp.end());
		return sharp;
	}

	void markAll(const std::vector<int>& edges)
	{
		m_.crease.reset(m_.halfEdgeNum());
		workers_.forEach(m_.halfEdgeNum(), [&](int h) { m_.crease[h] = 0; });
		for (int h : edges)
			mark(h, true);
		edges_ = edges;
	}

	void mark(int h, bool on) { m_.crease[h] = m_.crease[m_.opposite[h]] = char(on); }

	// ---- seams

	/// The edges that are seams, or all other edges.
	std::vector<int> among(const std::vector<int>& edges, bool areSeams) const
	{
		std::vector<int> found;
		std::copy_if(edges.begin(), edges.end(), std::back_inserter(found),
					 [&](int h) { return (placeIn(rules_.seams, h) >= 0) == areSeams; });
		return found;
	}

	// ---- noise

	/// Whether the edges found look like noise. Components are built only if the single edges do
	/// not show noise: a scan has many crease edges, and there the single edges show noise.
	bool looksLikeNoise(const std::vector<int>& sharp) const
	{
		if (sharp.empty()) return false;
		std::vector<char> isClear = clearEdges(surface_, isSplit(), sharp, workers_);
		if (areNoise(sharp, isClear)) return true;
		const float            least    = clearLength * meanEdge();
		const std::vector<int> longOnes = edgesOfLines([&](const std::vector<int>& line) {
			return line.size() >= clearEdgeNum || lengthOf(line) >= least;
		});
		for (std::size_t i = 0; i < sharp.size(); ++i)
			isClear[i] = isClear[i] && placeIn(longOnes, sharp[i]) >= 0;
		return areNoise(sharp, isClear);
	}

	/// The edges of the connected lines that pass a test, ascending.
	template <class Test>
	std::vector<int> edgesOfLines(const Test& test) const
	{
		std::vector<int> edges;
		for (const std::vector<int>& line : connectedLines(m_, edges_)) {
			if (test(line)) edges.insert(edges.end(), line.begin(), line.end());
		}
		std::sort(edges.begin(), edges.end());
		return edges;
	}

	/// The total length of a line, added up in the order of the edges.
	float lengthOf(std::vector<int> line) const
	{
		std::sort(line.begin(), line.end());
		double sum = 0;
		for (int h : line)
			sum += double(m_.edgeLength(h));
		return float(sum);
	}

	/// Whether too little of the length of some edges is clear of noise.
	bool areNoise(const std::vector<int>& edges, const std::vector<char>& isClear) const
	{
		const auto   lengthOf = [&](int i) { return double(m_.edgeLength(edges[i])); };
		const double all =
			workers_.sumEach<double>(edges.size(), [&](int i, double& sum) { sum += lengthOf(i); });
		const double clear = workers_.sumEach<double>(edges.size(), [&](int i, double& sum) {
			if (isClear[i]) sum += lengthOf(i);
		});
		return clear < clearShare * all;
	}

	bool isSplit() const { return rules_.callersMeanEdge > 0; }

	/// Mean edge of the input, measured on about a million half-edges, or on all if there are
	/// fewer.
	float meanEdge() const
	{
		if (isSplit()) return rules_.callersMeanEdge;
		const int         stride = 1 + m_.halfEdgeNum() / 1000000;
		const std::size_t num    = std::size_t((m_.halfEdgeNum() + stride - 1) / stride);
		const double      sum    = workers_.sumEach<double>(
            num, [&](int i, double& s) { s += double(m_.edgeLength(i * stride)); });
		return float(sum / double(num));
	}

	// ---- growing

	/// Lines fade out: continues each free end along weaker edges.
	void growFromEnds(const std::vector<int>& sharp)
	{
		std::vector<int> vertices;
		for (int h : sharp)
			vertices.insert(vertices.end(), {m_.origin[h], m_.target(h)});
		sortUnique(vertices);
		for (int v : vertices)
			growFrom(v);
		std::sort(edges_.begin(), edges_.end());
	}

	void growFrom(int v)
	{
		while (isFreeEnd(v)) {
			const int on = bestContinuation(v);
			if (on < 0) return;
			mark(on, true);
			edges_.push_back(std::min(on, m_.opposite[on]));
			v = m_.target(on);
		}
	}

	/// The sharpest edge that continues the line at its end v, within 60° of its direction; -1 if
	/// none.
	int bestContinuation(int v) const
	{
		Vec3f ahead;
		forEachOutgoing(m_, v, [&](int h) {
			if (m_.isCreaseEdge(h)) ahead = normalized(m_.position[v] - m_.position[m_.target(h)]);
		});
		int   best     = -1;
		float sharpest = rules_.weakDeg * radians;
		forEachOutgoing(m_, v, [&](int h) {
			if (m_.isCurveEdge(h)) return;
			const Vec3f along = normalized(m_.position[m_.target(h)] - m_.position[v]);
			const float angle = dihedralAngle(m_, h);
			if (dot(along, ahead) < goOnCosine || angle < sharpest) return;
			sharpest = angle;
			best     = h;
		});
		return best;
	}

	// ---- short lines

	void dropShortOnes()
	{
		drop(edgesOfLines([&](const std::vector<int>& line) {
			const int spare = spareDoublingsOf(line);
			if (spare >= 0) spareDoublings_ = std::min(spareDoublings_, spare);
			return spare < 0;
		}));
		std::vector<int> spurs;
		for (int h : edges_) {
			for (int e : {h, m_.opposite[h]}) {
				if (isFreeEnd(m_.origin[e])) collectSpur(e, spurs);
			}
		}
		drop(spurs);
	}

	void dropCloseOnes()
	{
		const std::vector<int> close = findCloseLines(surface_, rules_.minGap, workers_);
		if (close.empty()) return;
		drop(close);
		dropShortOnes();
	}

	void drop(const std::vector<int>& edges)
	{
		for (int h : edges)
			mark(h, false);
		const auto isGone = [&](int h) { return !m_.isCreaseEdge(h); };
		edges_.erase(std::remove_if(edges_.begin(), edges_.end(), isGone), edges_.end());
	}

	/// So often the least lengths may double, and the line stays; -1 for a line that is too short.
	int spareDoublingsOf(const std::vector<int>& line) const
	{
		const float all        = lengthOf(line);
		const auto  hasFreeEnd = [&](int h) {
            return isFreeEnd(m_.origin[h]) || isFreeEnd(m_.target(h));
		};
		const int  byLength = doublingsWithin(all, rules_.minLength);
		const bool isLoop   = std::none_of(line.begin(), line.end(), hasFreeEnd);
		return isLoop ? std::max(byLength, doublingsWithin(all, rules_.minLoop)) : byLength;
	}

	static constexpr int mostDoublings = 30;

	/// So often `least` may double within a length; -1 if the length is below `least`.
	static int doublingsWithin(float length, float least)
	{
		int num = -1;
		for (; num < mostDoublings && length >= least; least *= 2)
			++num;
		return num;
	}

	bool isFreeEnd(int v) const { return !m_.isBorderVertex(v) && m_.creaseNum(v) == 1; }

	/// Collects the chain from e if it is shorter than minSpur and ends at a fork. Without the
	/// chain, the fork is a plain vertex of the line.
	void collectSpur(int e, std::vector<int>& spurs) const
	{
		std::vector<int> chain;
		float            sum = 0;
		int              h   = e;
		while (h >= 0) {
			chain.push_back(std::min(h, m_.opposite[h]));
			sum += m_.edgeLength(h);
			if (sum >= rules_.minSpur) return;
			h = isCreaseNode(m_, m_.target(h)) ? -1 : nextOnCrease(m_, h);
		}
		spurs.insert(spurs.end(), chain.begin(), chain.end());
	}

	// ---- cone apexes

	/// The angle defect, 2π less the angles at v: 0 on flat ground.
	float defect(int v) const
	{
		float sum = float(2 * pi);
		forEachOutgoing(m_, v, [&](int h) {
			const Vec3f a = m_.position[m_.target(h)] - m_.position[v];
			const Vec3f b = m_.position[m_.apex(h)] - m_.position[v];
			sum -= angleBetween(a, b);
		});
		return sum;
	}

	/// Cheap test passed by the apex of every cone with such a defect: the normals round it spread,
	/// with n·axis = 1 - defect / 2π.
	bool isPointed(int v) const
	{
		const float spread = spreadAtApex(rules_.strongDeg);
		if (spread <= pointedSpread && !surface_.normal[v].isPointed()) return false;
		const RingSum ring = ringSum(m_, v);
		return length(ring.normal) < spread * ring.area;
	}

	bool isConeApex(int v) const
	{
		if (m_.isBorderVertex(v) || !isPointed(v) || m_.isCreaseVertex(v)) return false;
		const float own = defect(v);
		if (own < rules_.strongDeg * radians) return false;
		return !anyNeighbour(m_, v, [&](int w) {
			return !m_.isCurveVertex(w) && !(std::abs(defect(w)) <= apexContrast * own);
		});
	}
};

} // namespace

CreaseFindings markCreases(const CreaseRules& rules, Workers& workers, Surface& surface)
{
	if (rules.mode == FeatureMode::Off || rules.mode == FeatureMode::Given) return {};
	return CreaseGraph(surface, rules, workers).run();
}

} // namespace gpr
