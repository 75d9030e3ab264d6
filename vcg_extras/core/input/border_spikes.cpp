// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "border_spikes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace gpr {

namespace {

/// What sticks out less stays whole, what sticks out more goes down to the rest but for a little:
/// in widths.
constexpr float leastHeight = 0.35f, leftHeight = 0.05f;

/// Distances along the surface from many vertices at once, by Dijkstra's search that also unfolds
/// triangles over the edges whose ends it has passed.
class DistanceSearch {
public:
	explicit DistanceSearch(const HalfEdgeMesh& mesh) :
			m_(mesh), distance_(mesh.vertexNum, HUGE_VALF), source_(mesh.vertexNum, -1),
			isDone_(mesh.vertexNum, 0)
	{
	}

	void begin(int v, float distance) { reach(v, distance, v); }

	/// Passes the vertices nearer than `farthest` for which mayPass(v). Their neighbours get
	/// distances, too.
	template <class MayPass>
	void run(float farthest, const MayPass& mayPass)
	{
		while (!queue_.empty()) {
			const Entry e = queue_.top();
			queue_.pop();
			if (isDone_[e.second] || e.first >= farthest || !mayPass(e.second)) continue;
			isDone_[e.second] = 1;
			spreadFrom(e.second);
		}
	}

	float at(int v) const { return distance_[v]; }
	/// The vertex that v's distance is counted from, or one beside it.
	int sourceOf(int v) const { return source_[v]; }

private:
	using Entry = std::pair<float, int>;

	const HalfEdgeMesh&                                                 m_;
	std::vector<float>                                                  distance_;
	std::vector<int>                                                    source_;
	std::vector<char>                                                   isDone_;
	std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;

	float edge(int a, int b) const { return length(m_.position[a] - m_.position[b]); }

	void reach(int v, float distance, int source)
	{
		if (!(distance < distance_[v])) return;
		distance_[v] = distance;
		source_[v]   = source;
		queue_.push({distance, v});
	}

	void spreadFrom(int v)
	{
		forEachNeighbour(m_, v, [&](int w) { reach(w, distance_[v] + edge(v, w), source_[v]); });
		forEachOutgoing(m_, v, [&](int h) {
			unfold(v, m_.target(h), m_.apex(h));
			unfold(v, m_.apex(h), m_.target(h));
		});
	}

	/// The way to `a` over the edge between v and b, if both were passed. The front is taken for a
	/// straight line: the distance grows in one direction of the triangle's plane. This fits a
	/// border, all of whose points are sources, better than a single source would.
	void unfold(int v, int b, int a)
	{
		const float base = edge(v, b);
		if (!isDone_[b] || !(base > 0)) return;
		reach(a, acrossEdge(v, b, a, base), source_[v]);
	}

	float acrossEdge(int v, int b, int a, float base) const
	{
		const float slope = (distance_[b] - distance_[v]) / base;
		if (!(std::abs(slope) < 1)) return HUGE_VALF;
		const Vec3f along = (m_.position[b] - m_.position[v]) * (1 / base);
		const Vec3f way   = m_.position[a] - m_.position[v];
		const float x     = dot(way, along);
		const float y     = length(way - along * x);
		const float rise  = std::sqrt(1 - slope * slope);
		const float foot  = x - y * slope / rise; // where the way to a crosses the edge
		if (!(foot >= 0 && foot <= base)) return HUGE_VALF;
		return distance_[v] + x * slope + y * rise;
	}
};

class SpikeFinder {
public:
	SpikeFinder(const HalfEdgeMesh& mesh, float width) :
			m_(mesh), width_(width), regionOf_(mesh.faceNum, -1), isGone_(mesh.faceNum, 0)
	{
	}

	std::vector<int> run()
	{
		measure();
		std::vector<int> spikes;
		int              region = 0;
		for (int f = 0; f < m_.faceNum; ++f) {
			if (regionOf_[f] >= 0 || !sticksOut(f)) continue;
			collect(f, region);
			if (highest_ > leastHeight * width_ && isSpike(region)) {
				spikes.insert(spikes.end(), faces_.begin(), faces_.end());
				for (int g : faces_)
					isGone_[g] = 1;
			}
			++region;
		}
		std::sort(spikes.begin(), spikes.end());
		return spikes;
	}

private:
	const HalfEdgeMesh& m_;
	float               width_;
	std::vector<float>  height_;          ///< per vertex: how far it lies beyond the opened surface
	std::vector<int>    regionOf_;        ///< per face
	std::vector<char>   isGone_;          ///< per face: part of a spike
	std::vector<int>    faces_;           ///< of the region at hand
	std::vector<char>   fan_;             ///< see readFan
	bool                isCut_   = false; ///< of these faces, some have gone
	float               highest_ = 0;

	/// Heights are distances from where the distance from the border is half the width, less half
	/// the width. On a straight border they are 0.
	void measure()
	{
		const float    half = 0.5f * width_;
		DistanceSearch fromBorder(m_);
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (m_.outgoing[v] >= 0 && m_.isBorderVertex(v)) fromBorder.begin(v, 0);
		}
		fromBorder.run(half, [](int) { return true; });

		DistanceSearch fromCore(m_);
		const auto     isNear = [&](int v) { return fromBorder.at(v) < half; };
		height_.assign(m_.vertexNum, -width_);
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (isNear(v)) seedBeside(v, half, fromBorder, fromCore);
		}
		fromCore.run(HUGE_VALF, isNear);
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (isNear(v)) height_[v] = fromCore.at(v) - half;
		}
	}

	/// Where the distance from the border gets to half the width along an edge from v, there the
	/// core begins. It may be in the middle of an edge whose ends are near to two sides of a spike.
	void seedBeside(int v, float half, const DistanceSearch& fromBorder, DistanceSearch& fromCore)
	{
		const Vec3f at  = m_.position[v];
		const float low = fromBorder.at(v);
		forEachNeighbour(m_, v, [&](int w) {
			const Vec3f way  = m_.position[w] - at;
			const float edge = length(way), high = std::min(fromBorder.at(w), low + edge);
			const float middle = distanceOf(at + way * 0.5f, v, w, fromBorder);
			if (high >= half)
				seedOnWay(v, edge, high, half, fromBorder, fromCore);
			else if (middle >= half)
				seedOnWay(v, 0.5f * edge, middle, half, fromBorder, fromCore);
		});
	}

	/// `far` is the distance at the end of a way from v.
	void seedOnWay(int v, float way, float far, float half, const DistanceSearch& fromBorder,
				   DistanceSearch& fromCore)
	{
		const float low = fromBorder.at(v);
		if (far > low) fromCore.begin(v, way * std::min(1.0f, (half - low) / (far - low)));
	}

	/// Of the middle of the edge between v and w from the border, about.
	float distanceOf(const Vec3f& middle, int v, int w, const DistanceSearch& fromBorder) const
	{
		float nearest = HUGE_VALF;
		for (int end : {v, w}) {
			const int source = fromBorder.sourceOf(end);
			if (source >= 0) nearest = std::min(nearest, length(middle - m_.position[source]));
		}
		return nearest;
	}

	float heightOf(int f) const
	{
		const int* v = &m_.origin[3 * f];
		return (height_[v[0]] + height_[v[1]] + height_[v[2]]) / 3;
	}

	bool sticksOut(int f) const { return heightOf(f) > leftHeight * width_; }

	/// All faces that stick out and are joined to f over edges.
	void collect(int f, int region)
	{
		faces_.assign(1, f);
		regionOf_[f] = region;
		highest_     = 0;
		for (std::size_t i = 0; i < faces_.size(); ++i) {
			for (int h = 3 * faces_[i]; h < 3 * faces_[i] + 3; ++h) {
				highest_    = std::max(highest_, height_[m_.origin[h]]);
				const int g = m_.opposite[h] < 0 ? -1 : m_.opposite[h] / 3;
				if (g < 0 || regionOf_[g] >= 0 || !sticksOut(g)) continue;
				regionOf_[g] = region;
				faces_.push_back(g);
			}
		}
	}

	bool isIn(int h, int region) const { return h >= 0 && regionOf_[h / 3] == region; }

	/// Whether the region is a disk that meets what is left of the rest along one line, whose inner
	/// vertices are inner ones of the mesh.
	bool isSpike(int region)
	{
		const std::vector<int> vertices    = verticesOf(m_, faces_);
		int                    innerHalves = 0, lineEnds = 0;
		for (int f : faces_) {
			for (int h = 3 * f; h < 3 * f + 3; ++h)
				innerHalves += isIn(m_.opposite[h], region);
		}
		const int edges = int(3 * faces_.size()) - innerHalves / 2;
		if (int(vertices.size()) - edges + int(faces_.size()) != 1) return false;
		for (int v : vertices) {
			const Fan fan = fanOf(v, region);
			if (!fan.isSound) return false;
			lineEnds += fan.isLineEnd;
		}
		return lineEnds == 2;
	}

	/// How the region's faces lie among those round a vertex.
	struct Fan {
		bool isSound   = false; ///< both the region's and the others are side by side
		bool isLineEnd = false; ///< of a border vertex, some are the region's and some are not
	};

	Fan fanOf(int v, int region)
	{
		readFan(v, region);
		const bool isBorder = m_.isBorderVertex(v) || isCut_;
		int        changes = 0, own = 0;
		for (std::size_t i = 0; i < fan_.size(); ++i) {
			own += fan_[i];
			changes += i > 0 && fan_[i] != fan_[i - 1];
		}
		if (!isBorder) changes += fan_.front() != fan_.back();
		Fan fan;
		fan.isSound   = changes <= (isBorder ? 1 : 2);
		fan.isLineEnd = isBorder && own < int(fan_.size());
		return fan;
	}

	/// Which of the faces round a vertex are the region's, in order. Those that have gone with
	/// other spikes are left out; where they lay inside, the order begins behind them.
	void readFan(int v, int region)
	{
		fan_.clear();
		isCut_            = false;
		std::size_t first = 0;
		forEachOutgoing(m_, v, [&](int h) {
			if (isGone_[h / 3]) {
				isCut_ = true;
				first  = fan_.size();
				return;
			}
			fan_.push_back(isIn(h, region));
		});
		std::rotate(fan_.begin(), fan_.begin() + std::ptrdiff_t(first), fan_.end());
	}
};

} // namespace

std::vector<int> findBorderSpikes(const HalfEdgeMesh& mesh, float width)
{
	return SpikeFinder(mesh, width).run();
}

} // namespace gpr
