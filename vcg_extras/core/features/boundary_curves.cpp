// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary_curves.h"

#include "shared_borders.h"
#include "smooth_border.h"

#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace gpr {

namespace {

/// A turn within a window that makes a corner of a curve. A smaller turn is a bend that chords of
/// the wanted length can follow: they leave an arc of 50° by about a tenth of their length.
constexpr float cornerTurn = 50 * radians;
/// A turn at one point that makes it a corner of a feature line.
constexpr float kinkTurn = 25 * radians;

void addPoint(const HalfEdgeMesh& m, int h, Curve& c)
{
	c.vertex.push_back(m.origin[h]);
	c.point.push_back(m.position[m.origin[h]]);
	c.halfEdge.push_back(h);
	c.arc.push_back(c.length);
	c.length += m.edgeLength(h);
}

/// Traces a loop of the border, or a feature line to the next node or once round.
Curve traceFrom(const HalfEdgeMesh& m, int first, std::vector<bool>& seen)
{
	Curve c;
	int   h = first;
	do {
		addPoint(m, h, c);
		const int end = m.target(h);
		seen[h]       = true;
		if (m.isBorderEdge(h)) {
			h = m.outgoing[end];
			continue;
		}
		seen[m.opposite[h]] = true;
		if (isCreaseNode(m, end)) {
			c.isClosed = false;
			c.vertex.push_back(end);
			c.point.push_back(m.position[end]);
			c.arc.push_back(c.length);
			return c;
		}
		h = nextOnCrease(m, h);
	} while (h != first);
	return c;
}

/// The vertices of feature lines, ascending. Edges of lines are few: a pass over the marks does not
/// read the rings of other vertices.
std::vector<int> creaseVertices(const HalfEdgeMesh& m)
{
	std::vector<int> vertices;
	for (std::size_t h = 0; h < m.crease.size(); ++h) {
		if (m.crease[h] != 0) vertices.push_back(m.origin[h]);
	}
	sortUnique(vertices);
	return vertices;
}

/// Angle between the chords to the points `window` before and behind, per point; 0 at the ends of
/// an open curve. The angle at the vertex itself says nothing on the zigzag rims of range maps.
std::vector<float> turnsOver(const Curve& c, float window)
{
	std::vector<float> turn(c.pointNum());
	for (int i = 0; i < c.pointNum(); ++i) {
		const Vec3f in  = c.point[i] - c.at(c.arc[i] - window);
		const Vec3f out = c.at(c.arc[i] + window) - c.point[i];
		turn[i]         = angleBetween(in, out);
	}
	return turn;
}

/// Calls visit(k) for the other points within `window` of point i along the curve, until visit
/// returns false.
template <class Visit>
bool forEachWithin(const Curve& c, int i, float window, const Visit& visit)
{
	const int n = c.pointNum();
	for (int direction : {-1, 1}) {
		int   k    = i;
		float walk = 0;
		while (true) {
			if (!c.isClosed && (k + direction < 0 || k + direction >= n)) break;
			const int next = (k + direction + n) % n;
			walk += length(c.point[next] - c.point[k]);
			k = next;
			if (walk > window || k == i) break;
			if (!visit(k)) return false;
		}
	}
	return true;
}

/// Whether no point within `window` along the curve turns more than point i (ties: the first point
/// wins).
bool isLargestTurn(const Curve& c, const std::vector<float>& turn, int i, float window)
{
	return forEachWithin(
		c, i, window, [&](int k) { return !(turn[k] > turn[i] || (turn[k] == turn[i] && k < i)); });
}

/// Whether every other point within `window` turns by less than half of the turn at point i.
bool standsOut(const Curve& c, const std::vector<float>& turn, int i, float window)
{
	return forEachWithin(c, i, window, [&](int k) { return turn[k] < 0.5f * turn[i]; });
}

/// Marks the points at which the curve turns by more than cornerTurn, its ends left out.
std::vector<char> findTurns(const Curve& c, float window)
{
	const std::vector<float> turn = turnsOver(c, window);
	std::vector<char>        turns(c.pointNum(), 0);
	for (int i = 0; i < c.pointNum(); ++i)
		turns[i] = turn[i] > cornerTurn && isLargestTurn(c, turn, i, window);
	return turns;
}

/// Angles between the two segments at each point; 0 at the ends of an open curve.
std::vector<float> turnsAtPoints(const Curve& c)
{
	const int          n = c.pointNum(), skip = c.isClosed ? 0 : 1;
	std::vector<float> turn(n, 0.0f);
	for (int i = skip; i < n - skip; ++i) {
		const Vec3f in  = c.point[i] - c.point[(i + n - 1) % n];
		const Vec3f out = c.point[(i + 1) % n] - c.point[i];
		turn[i]         = angleBetween(in, out);
	}
	return turn;
}

/// Marks the corners of a feature line: points whose own turn stands out from the points round,
/// which never happens on a tessellated arc, and points away from these with a turn above
/// cornerTurn.
std::vector<char> findCreaseCorners(const Curve& c, float window)
{
	const std::vector<float> ownTurn = turnsAtPoints(c);
	std::vector<char>        kinks(c.pointNum(), 0);
	for (int i = 0; i < c.pointNum(); ++i)
		kinks[i] = ownTurn[i] > kinkTurn && standsOut(c, ownTurn, i, window);
	std::vector<char> corners = findTurns(c, window);
	for (int i = 0; i < c.pointNum(); ++i) {
		const bool alone = forEachWithin(c, i, window, [&](int k) { return !kinks[k]; });
		corners[i]       = kinks[i] || (corners[i] && alone);
	}
	return corners;
}

/// Whether the border leaves the mirror plane at a vertex on the plane.
bool leavesMirror(const HalfEdgeMesh& m, int v)
{
	return m.isOnMirror(v) && m.isBorderVertex(v) &&
		   !(m.isOnMirror(borderNeighbour(m, v, true)) &&
			 m.isOnMirror(borderNeighbour(m, v, false)));
}

using ChainEnds = std::map<std::pair<int, int>, int>;

std::pair<int, int> endsOf(const Curve& c)
{
	return std::minmax({c.vertex.front(), c.vertex.back()});
}

ChainEnds countChainEnds(const std::vector<Curve>& curves)
{
	ChainEnds number;
	for (const Curve& c : curves) {
		if (!c.isClosed) ++number[endsOf(c)];
	}
	return number;
}

/// The least number of edges on a chain: three if it returns to its own node, two if another chain
/// has the same two nodes.
int minPieces(const Curve& c, const ChainEnds& chainEnds)
{
	if (c.vertex.front() == c.vertex.back()) return 3;
	return chainEnds.at(endsOf(c)) > 1 ? 2 : 1;
}

/// The arc of a sample on the curve at hand, and the sample.
using Mark = std::pair<float, int>;

/// The stops of a curve, from the first to the last or once round, and the arcs of the samples
/// between each stop and the next.
struct SpacedStops {
	std::vector<float>              stop;
	std::vector<std::vector<float>> between;
	bool                            areCorners = true; ///< the stops inside the curve
};

/// Samples the curves in turn; remembers the samples of shared nodes.
class CurveSampler {
public:
	CurveSampler(const HalfEdgeMesh& mesh, float diskRadius, float spacing,
				 const std::vector<int>& kept, BoundaryMode border, BoundaryCurves& out,
				 Workers& workers) :
			m_(mesh),
			out_(out), workers_(workers), border_(border), diskRadius_(diskRadius),
			wantedChord_(spacing), isKept_(std::size_t(mesh.vertexNum), 0)
	{
		for (int v : kept)
			isKept_[v] = 1;
	}

	/// Finds borders at the same place. Called before any curve is sampled and after smoothBorders.
	void shareBorders()
	{
		shared_ = std::make_unique<SharedBorders>(m_, out_.curves);
		for (int c = 0; c < int(out_.curves.size()); ++c) {
			if (shared_->isAnyShared(c)) addSharedStops(c);
		}
	}

	/// Smooths the border loops, before any curve is sampled. Ends of feature lines and kept
	/// vertices stay in place, and so do shared borders, if asked.
	void smoothBorders(bool keepsShared)
	{
		const SharedBorders before(m_, keepsShared ? out_.curves : std::vector<Curve>());
		for (Curve& c : out_.curves) {
			if (!isOfBorder(c) || isTooShort(c)) continue;
			std::vector<char> isFixed(std::size_t(c.pointNum()));
			const int         index = int(&c - out_.curves.data());
			for (int i = 0; i < c.pointNum(); ++i)
				isFixed[i] = isStop(c.vertex[i]) || (keepsShared && before.isOnShared(index, i));
			smoothLoop(wantedChord_, isFixed, c);
		}
	}

	/// Spaces the samples of all curves that share no border with other curves: each curve by
	/// itself, so in parallel.
	void spaceSamples()
	{
		const ChainEnds chainEnds = countChainEnds(out_.curves);
		spaced_.resize(out_.curves.size());
		workers_.forTasks(spaced_.size(), [&](std::size_t i, int worker) {
			const Curve& c = out_.curves[i];
			if (!c.isClosed)
				spaced_[i] = stopsOfChain(c, minPieces(c, chainEnds), worker);
			else if (!keepsAll(c) && !isShared(int(i)) && !isTooShort(c))
				spaced_[i] = stopsOfLoop(c, worker);
		});
	}

	void sample(int index)
	{
		workers_.poll();
		index_         = index;
		firstSample_   = out_.samples.size();
		const Curve& c = out_.curves[index];
		finish(c, c.isClosed ? sampleClosed(c) : sampleChain(c));
	}

	/// Adds vertex v, on no curve, as a sample.
	void addPoint(int v)
	{
		CurveSample& sample = out_.samples.emplace_back();
		sample.isCorner     = true;
		sample.isPinned     = isKept(v);
		sample.point        = {m_.position[v], m_.outgoing[v] / 3};
		sample.vertex       = v;
	}

private:
	const HalfEdgeMesh&            m_;
	BoundaryCurves&                out_;
	Workers&                       workers_;
	BoundaryMode                   border_;
	float                          diskRadius_;
	float                          wantedChord_;
	int                            index_       = 0;
	std::size_t                    firstSample_ = 0; ///< of the curve at hand
	std::vector<SpacedStops>       spaced_;          ///< per curve; empty if sampled in another way
	std::map<int, int>             sampleOfNode_;
	std::vector<char>              isKept_; ///< per vertex
	std::unique_ptr<SharedBorders> shared_; ///< or null

	bool isKept(int v) const { return isKept_[v]; }
	bool isStop(int v) const { return isCreaseNode(m_, v) || isKept(v) || leavesMirror(m_, v); }
	/// Whether the curve is too short for three samples.
	bool isTooShort(const Curve& c) const
	{
		return c.pointNum() <= 3 || c.length < 1.8f * wantedChord_ * c.smallestSize();
	}
	bool isOfBorder(const Curve& c) const { return m_.isBorderEdge(c.halfEdge[0]); }

	/// The arc length on either side of a point over which turns are measured.
	float windowOf(const Curve& c) const
	{
		return std::min(diskRadius_ * c.smallestSize(), c.length / 6);
	}

	bool keepsAll(const Curve& loop) const
	{
		const auto isKeptVertex = [&](int v) { return isKept(v); };
		return border_ == BoundaryMode::Keep && isOfBorder(loop) &&
			   std::count_if(loop.vertex.begin(), loop.vertex.end(), isKeptVertex) >= 3;
	}
	bool isShared(int loop) const { return shared_ != nullptr && shared_->isAnyShared(loop); }

	std::vector<Mark> sampleClosed(const Curve& c)
	{
		if (keepsAll(c))
			keepAll(c);
		else if (isShared(index_))
			sampleSharedLoop(c);
		else if (isTooShort(c))
			keepThree(c);
		else
			sampleFrom(c, 0);
		// A loop shares no sample with other curves.
		std::stable_sort(out_.samples.begin() + std::ptrdiff_t(firstSample_), out_.samples.end(),
						 [](const CurveSample& a, const CurveSample& b) { return a.arc < b.arc; });
		return {};
	}

	std::vector<Mark> sampleChain(const Curve& c)
	{
		const int front = nodeSample(c.vertex.front(), c, 0);
		sampleFrom(c, 1);
		return {{0, front}, {c.length, nodeSample(c.vertex.back(), c, c.length)}};
	}

	/// Makes samples of the stops from the given stop on, and of the arcs between all stops.
	void sampleFrom(const Curve& c, std::size_t firstStop)
	{
		const SpacedStops& spaced = spaced_[index_];
		for (std::size_t i = 0; i < spaced.between.size(); ++i) {
			if (i >= firstStop) put(c, spaced.stop[i], spaced.areCorners);
			putAll(c, spaced.between[i]);
		}
	}

	/// minSteps: the least number of parts of the chain, so that it does not coincide with another
	/// chain.
	SpacedStops stopsOfChain(const Curve& c, int minSteps, int worker) const
	{
		const std::vector<char> turns  = findTurns(c, windowOf(c));
		SpacedStops             spaced = {{0}, {}};
		for (int i = 0; i < c.pointNum(); ++i) {
			const bool inside = i > 0 && i + 1 < c.pointNum();
			if (turns[i] || (inside && isKept(c.vertex[i]))) spaced.stop.push_back(c.arc[i]);
		}
		const int pieceNum = int(spaced.stop.size());
		spaceBetween(c, c.length, std::max(1, minSteps - pieceNum + 1), worker, spaced);
		return spaced;
	}

	/// Spaces samples between the stops. end: of the last piece.
	void spaceBetween(const Curve& c, float end, int minSteps, int worker,
					  SpacedStops& spaced) const
	{
		for (std::size_t i = 0; i < spaced.stop.size(); ++i) {
			workers_.pollFrom(worker);
			const float to = i + 1 < spaced.stop.size() ? spaced.stop[i + 1] : end;
			spaced.between.push_back(spaceOut(c, spaced.stop[i], to, wantedChord_, minSteps));
		}
	}

	CurveSample& put(const Curve& c, float s, bool isCorner)
	{
		CurveSample& sample = out_.samples.emplace_back();
		sample.arc          = c.wrap(s);
		sample.curve        = index_;
		sample.isCorner     = isCorner;
		sample.point        = {c.at(sample.arc), c.faceAt(sample.arc)};
		return sample;
	}

	void putAll(const Curve& c, const std::vector<float>& arcs)
	{
		for (float s : arcs)
			put(c, s, false);
	}

	int nodeSample(int v, const Curve& c, float s)
	{
		const auto [found, isNew] = sampleOfNode_.insert({v, int(out_.samples.size())});
		if (isNew) {
			CurveSample& sample = put(c, s, true);
			sample.vertex       = v;
			sample.isPinned     = isKept(v);
		}
		return found->second;
	}

	/// Makes samples of the kept vertices only.
	void keepAll(const Curve& c)
	{
		for (int i = 0; i < c.pointNum(); ++i) {
			if (isKept(c.vertex[i])) put(c, c.arc[i], true);
		}
	}

	/// Makes samples of three vertices of the loop, as evenly spaced as possible; nodes come first.
	/// A loop that touches itself has two vertices at a place: only one of these is taken.
	void keepThree(const Curve& c)
	{
		std::vector<int> taken;
		const auto       take = [&](int i) {
            taken.push_back(i);
            put(c, c.arc[i], true);
		};
		for (int i = 0; i < c.pointNum(); ++i) {
			if (isStop(c.vertex[i])) take(i);
		}
		for (int k = int(taken.size()); k < 3; ++k)
			take(nearestPoint(c, c.length * float(k) / 3, taken));
	}

	/// Marks the corners and nodes on the loop.
	std::vector<char> cornersOfLoop(const Curve& c) const
	{
		const float window       = windowOf(c);
		const bool  followsTurns = border_ != BoundaryMode::Free && border_ != BoundaryMode::Smooth;
		std::vector<char> corners(c.pointNum(), 0);
		if (!isOfBorder(c))
			corners = findCreaseCorners(c, window);
		else if (followsTurns)
			corners = findTurns(c, window);
		for (int i = 0; i < c.pointNum(); ++i)
			corners[i] = corners[i] || isStop(c.vertex[i]);
		return corners;
	}

	SpacedStops stopsOfLoop(const Curve& c, int worker) const
	{
		const std::vector<char> isCorner = cornersOfLoop(c);
		SpacedStops             spaced;
		for (int i = 0; i < c.pointNum(); ++i) {
			if (isCorner[i]) spaced.stop.push_back(c.arc[i]);
		}
		spaced.areCorners = !spaced.stop.empty();
		if (!spaced.areCorners) { // the loop begins at its sharpest turn
			const std::vector<float> turn = turnsOver(c, windowOf(c));
			spaced.stop.push_back(c.arc[std::max_element(turn.begin(), turn.end()) - turn.begin()]);
		}
		const std::size_t n = spaced.stop.size();
		// Even with few corners, three samples must come out.
		const int minSteps = n == 1 ? 3 : n == 2 ? 2 : 1;
		spaceBetween(c, spaced.stop[0] + c.length, minSteps, worker, spaced);
		return spaced;
	}

	// ---- shared borders

	/// Makes the corners of the curve stops of all curves at the same place, and adds stops until
	/// three samples are certain.
	void addSharedStops(int index)
	{
		const Curve&            c        = out_.curves[index];
		const std::vector<char> isCorner = cornersOfLoop(c);
		int                     stopNum  = 0;
		for (int i = 0; i < c.pointNum(); ++i) {
			if (isCorner[i] && shared_->isOnShared(index, i)) shared_->addStop(index, i);
			stopNum += shared_->isStop(index, i);
		}
		for (int k = 0; stopNum < 3 && k < 3; ++k) {
			const int i = nearestPoint(c, c.length * float(k) / 3, {});
			stopNum += !shared_->isStop(index, i);
			shared_->addStop(index, i);
		}
	}

	/// The point nearest to an arc that is not taken; if possible, at another place than the taken
	/// points.
	static int nearestPoint(const Curve& c, float arc, const std::vector<int>& taken)
	{
		const auto cost = [&](int i) {
			float sum = c.arcDistance(c.arc[i], arc);
			for (int k : taken)
				sum += k == i ? HUGE_VALF : c.point[k] == c.point[i] ? c.length : 0;
			return sum;
		};
		int best = 0;
		for (int i = 1; i < c.pointNum(); ++i) {
			if (cost(i) < cost(best)) best = i;
		}
		return best;
	}

	/// Points at which the loop must have a sample: the shared stops, and its own corners off
	/// shared segments.
	std::vector<int> sharedStops(const Curve& c) const
	{
		const std::vector<char> isCorner = cornersOfLoop(c);
		std::vector<int>        stops;
		for (int i = 0; i < c.pointNum(); ++i) {
			const bool isOwn = isCorner[i] && !shared_->isOnShared(index_, i);
			if (isOwn || shared_->isStop(index_, i)) stops.push_back(i);
		}
		return stops;
	}

	void sampleSharedLoop(const Curve& c)
	{
		const std::vector<int> stops = sharedStops(c);
		for (std::size_t k = 0; k < stops.size(); ++k) {
			const int from = stops[k];
			const int to   = k + 1 < stops.size() ? stops[k + 1] : stops[0] + c.pointNum();
			workers_.poll();
			CurveSample& stop   = put(c, c.arc[from], true);
			stop.isShared       = shared_->isOnShared(index_, from);
			stop.point.position = c.point[from];
			if (!shared_->isShared(index_, from))
				putAll(c, spaceOut(c, c.arcOf(from), c.arcOf(to), wantedChord_, 1));
			else if (shared_->isSampled(index_, from))
				takeShared(c, from, to);
			else
				sampleShared(c, from, to);
		}
	}

	/// Samples the points from `from` to `to` for all curves that share this stretch.
	void sampleShared(const Curve& c, int from, int to)
	{
		for (float s : spaceOut(c, c.arcOf(from), c.arcOf(to), wantedChord_, 1)) {
			const int    segment = c.segmentAt(s);
			const float  extent  = c.lengthOf(segment);
			CurveSample& sample  = put(c, s, true);
			sample.isShared      = true;
			const float along    = extent > 0 ? (sample.arc - c.arc[segment]) / extent : 0.0f;
			shared_->addSample(index_, segment, std::min(1.0f, std::max(0.0f, along)),
							   sample.point.position);
		}
		for (int i = from; i < to; ++i)
			shared_->markSampled(index_, i);
	}

	/// Takes over the samples made on this stretch before, by another curve or by this curve on its
	/// way there.
	void takeShared(const Curve& c, int from, int to)
	{
		for (int i = from; i < to; ++i) {
			const int   segment = i % c.pointNum();
			const float extent  = c.lengthOf(segment);
			shared_->forEachSample(index_, segment, [&](float share, const Vec3f& position) {
				CurveSample& sample   = put(c, c.arc[segment] + share * extent, true);
				sample.isShared       = true;
				sample.point.position = position;
				sample.point.face     = c.halfEdge[segment] / 3;
			});
		}
	}

	/// Index of the mark nearest to arc s; the marks are sorted by arc.
	static int nearestMark(const Curve& c, const std::vector<Mark>& marks, float s)
	{
		const auto above = std::lower_bound(marks.begin(), marks.end(), Mark{s, 0});
		const int  n     = int(marks.size());
		const int  high  = int(above - marks.begin());
		const int  next = high % n, last = (high + n - 1) % n;
		return c.arcDistance(marks[next].first, s) < c.arcDistance(marks[last].first, s) ? next
																						 : last;
	}

	/// Assigns to every point of the curve its nearest sample, and to every sample the nearest of
	/// its points. marks: of the nodes at the ends of an open curve.
	void finish(const Curve& c, std::vector<Mark> marks)
	{
		for (std::size_t s = firstSample_; s < out_.samples.size(); ++s)
			marks.push_back({out_.samples[s].arc, int(s)});
		std::sort(marks.begin(), marks.end());
		std::vector<int>   owner(c.pointNum());
		std::vector<float> distance(marks.size(), HUGE_VALF);
		for (int i = 0; i < c.pointNum(); ++i) {
			const int k            = nearestMark(c, marks, c.arc[i]);
			const auto& [arc, own] = marks[k];
			CurveSample& sample    = out_.samples[own];
			const float  d         = c.arcDistance(arc, c.arc[i]);
			owner[i]               = own;
			if (d >= distance[k] || sampleOfNode_.count(sample.vertex) != 0) continue;
			distance[k]     = d;
			sample.vertex   = c.vertex[i];
			sample.isPinned = sample.isCorner && d == 0 && isKept(c.vertex[i]);
			if (isCreaseNode(m_, c.vertex[i])) sampleOfNode_[c.vertex[i]] = owner[i];
		}
		out_.sampleOfPoint.push_back(std::move(owner));
	}
};

/// The edges of the feature lines connected to v. seen: per vertex.
std::vector<int> lineAt(const HalfEdgeMesh& m, int v, std::vector<char>& seen)
{
	std::vector<int> line, front = {v};
	seen[v] = 1;
	for (std::size_t i = 0; i < front.size(); ++i) {
		forEachOutgoing(m, front[i], [&](int h) {
			if (!m.isCreaseEdge(h)) return;
			if (m.opposite[h] > h) line.push_back(h);
			const int w = m.target(h);
			if (seen[w]) return;
			seen[w] = 1;
			front.push_back(w);
		});
	}
	return line;
}

} // namespace

bool isCreaseNode(const HalfEdgeMesh& m, int v)
{
	const int n = m.creaseNum(v);
	return n > 0 && (n != 2 || m.isBorderVertex(v));
}

int nextOnCrease(const HalfEdgeMesh& m, int h)
{
	int next = -1;
	forEachOutgoing(m, m.target(h), [&](int x) {
		if (m.isCreaseEdge(x) && x != m.opposite[h]) next = x;
	});
	return next;
}

std::vector<std::vector<int>> connectedLines(const HalfEdgeMesh& m, const std::vector<int>& edges)
{
	std::vector<std::vector<int>> lines;
	std::vector<char>             seen(std::size_t(m.vertexNum), 0);
	for (int h : edges) {
		if (!seen[m.origin[h]]) lines.push_back(lineAt(m, m.origin[h], seen));
	}
	return lines;
}

/// Border loops; then feature lines from node to node, then closed feature lines; each in the order
/// of their first vertex.
std::vector<Curve> traceCurves(const HalfEdgeMesh& m, Workers& workers)
{
	std::vector<Curve> curves;
	std::vector<bool>  seen(m.halfEdgeNum(), false);
	const auto         trace = [&](int h) {
        workers.poll();
        if (!seen[h]) curves.push_back(traceFrom(m, h, seen));
	};
	for (int v = 0; v < m.vertexNum; ++v) {
		if (m.outgoing[v] >= 0 && m.isBorderVertex(v)) trace(m.outgoing[v]);
	}
	const std::vector<int> onCreases = creaseVertices(m);
	for (bool fromNodes : {true, false}) {
		for (int v : onCreases) {
			if (isCreaseNode(m, v) != fromNodes) continue;
			forEachOutgoing(m, v, [&](int h) {
				if (m.isCreaseEdge(h)) trace(h);
			});
		}
	}
	return curves;
}

BoundaryCurves sampleBoundary(const Surface& surface, float diskRadius, float spacing,
							  Workers& workers, const std::vector<int>& coneApexes,
							  const std::vector<int>& kept, BoundaryMode border, bool sharesBorders)
{
	const HalfEdgeMesh& m = surface.mesh;
	BoundaryCurves      result;
	result.curves = traceCurves(m, workers);

	for (Curve& c : result.curves) {
		workers.poll();
		if (surface.size.empty()) continue;
		for (int v : c.vertex)
			c.size.push_back(surface.size[v]);
	}
	CurveSampler sampler(m, diskRadius, spacing, kept, border, result, workers);
	if (border == BoundaryMode::Smooth) sampler.smoothBorders(sharesBorders);
	if (sharesBorders && border != BoundaryMode::Keep) sampler.shareBorders();
	sampler.spaceSamples();
	for (std::size_t i = 0; i < result.curves.size(); ++i)
		sampler.sample(int(i));
	for (int v : coneApexes)
		sampler.addPoint(v);
	const std::set<int> isConeApex(coneApexes.begin(), coneApexes.end());
	for (int v : kept) {
		if (!m.isCurveVertex(v) && isConeApex.count(v) == 0) sampler.addPoint(v);
	}
	return result;
}

} // namespace gpr
