// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "border_edge_sampling.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// A sample closer to an end of its edge than this share of the edge becomes the end.
constexpr double sameAsEnd = 1e-3;
/// The most moves of a place too near to a sample; then the end of its edge is taken.
constexpr int maxMoves = 3;

constexpr NearestField::Nearest unreached = {HUGE_VALF, -1};

/// SplitMix64 (Steele et al. 2014): the same numbers on every system.
class RandomIndex {
public:
	explicit RandomIndex(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ull) {}

	/// In [0, n), n < 2³².
	std::size_t below(std::size_t n)
	{
		state_ += 0x9e3779b97f4a7c15ull;
		std::uint64_t x = state_;
		x               = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ull;
		x               = (x ^ x >> 27) * 0x94d049bb133111ebull;
		return std::size_t((x >> 32) * n >> 32);
	}

private:
	std::uint64_t state_;
};

/// An edge that fulfilled eq. (2) when it entered the cache. It is named by its ends, which splits
/// of other edges do not change.
struct BorderEdge {
	int inner; ///< d_g <= r
	int outer; ///< d_g > r
};

/// A place for a sample: on a half-edge, or at a vertex.
struct Place {
	Sample sample;      ///< its face is a face of the fused mesh
	int    halfEdge;    ///< the half-edge below the sample
	int    vertex = -1; ///< the vertex at the place; -1: none
};

class BorderEdgeSampler {
public:
	BorderEdgeSampler(const Surface& surface, const BoundaryCurves& boundary,
					  const BorderEdgeOptions& options, Workers& workers) :
			surface_(surface),
			boundary_(boundary), options_(options), workers_(workers), r_(options.radius),
			nearLimit_((1 - spacingSlack) * options.radius), random_(options.seed),
			fused_(beginFusion(surface, workers)), m_(fused_.mesh),
			flood_(FloodGround{m_, normal_, isStretched() ? &stretch_ : nullptr, false}, field_, r_)
	{
		flood_.askBy(Poller(workers));
		expected_ = expectedSampleNum();
		growTo(m_.vertexNum + int(boundary.samples.size()) + expected_);
		fillPerVertex();
		scanStart_ = int(random_.below(m_.vertexNum));
	}

	void run()
	{
		takeBorder();
		if (options_.region != nullptr && !options_.region->empty()) {
			region_ = options_.region;
			refillCache();
			sampleOpen();
			region_ = nullptr;
			refillCache();
		}
		sampleOpen();
	}

	BorderEdgeSampling finish()
	{
		BorderEdgeSampling result;
		Sampling&          s = result.sampling;
		s.radius             = r_;
		s.samples            = std::move(samples_);
		s.boundarySampleNum  = int(boundary_.samples.size());
		s.capped             = capped_;
		field_.nearest.resize(surface_.mesh.vertexNum);
		s.nearest.swap(field_.nearest);
		labelBorder(boundary_, s);
		result.fused = std::move(fused_);
		return result;
	}

private:
	const Surface&           surface_;
	const BoundaryCurves&    boundary_;
	const BorderEdgeOptions& options_;
	Workers&                 workers_;
	float                    r_;
	float                    nearLimit_;
	RandomIndex              random_;
	FusedMesh                fused_;
	HalfEdgeMesh&            m_;
	Buffer<PackedNormal>     normal_;
	Buffer<float>            stretch_;
	NearestField             field_;
	DiskFlood                flood_;
	std::vector<Sample>      samples_;
	std::vector<BorderEdge>  cache_;         ///< the paper's C
	std::vector<int>         crossed_;       ///< vertices first covered by the last disk
	std::vector<int>         labels_;        ///< samples of the vertices near an edge
	int                      expected_  = 0; ///< samples, about
	int                      scanStart_ = 0;
	int                      scanned_   = 0;    ///< vertices seen from scanStart_ on, all covered
	std::vector<char>        seen_;             ///< marks of the search for a component
	const Buffer<char>*      region_ = nullptr; ///< region for samples now; null: everywhere
	bool                     capped_ = false;

	float distanceOf(int v) const { return field_.nearest[v].distance; }
	int   sampleOf(int v) const { return field_.nearest[v].sample; }
	bool  isCovered(int v) const { return distanceOf(v) <= r_; }
	Vec3f placeOf(int sample) const { return samples_[sample].point.position; }
	bool  isStretched() const { return !surface_.size.empty(); }
	float stretchOf(int v) const { return isStretched() ? stretch_[v] : 1.0f; }

	// ---- memory

	void fillPerVertex()
	{
		const int n = m_.vertexNum;
		std::copy(surface_.normal.begin(), surface_.normal.begin() + n, normal_.begin());
		std::fill(field_.nearest.begin(), field_.nearest.begin() + n, unreached);
		std::fill(field_.mark.begin(), field_.mark.begin() + n, NearestField::Mark{0, 0});
		if (!isStretched()) return;
		for (int v = 0; v < n; ++v)
			stretch_[v] = 1 / surface_.size[v];
	}

	/// About 0.75 A / r² without stretch: random border edges reach 0.72 of the densest packing.
	int expectedSampleNum() const
	{
		const double area = surfaceArea(surface_.mesh, workers_);
		return int(std::min(0.9 * area / (double(r_) * r_) + 1024, 1e8));
	}

	void growTo(int vertexRoom)
	{
		makeRoom(fused_, vertexRoom - m_.vertexNum);
		normal_.resize(vertexRoom);
		field_.nearest.resize(vertexRoom);
		field_.mark.resize(vertexRoom);
		if (isStretched()) stretch_.resize(vertexRoom);
	}

	// ---- sources of samples

	/// Whether v may be part of a border edge now. New vertices are samples, or lie on the border.
	bool isOpen(int v) const
	{
		return region_ == nullptr || v >= surface_.mesh.vertexNum || (*region_)[v] != 0;
	}

	void refillCache()
	{
		scanned_ = 0;
		cache_.clear();
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (isCovered(v)) pushBorderEdges(v);
		}
	}

	void sampleOpen()
	{
		int start = -1;
		do {
			while (!capped_ && drawBorderEdge()) {}
			start = capped_ ? -1 : findStart();
			if (start >= 0) placeAtVertex(start);
		} while (start >= 0);
	}

	/// Fuses and floods the samples of borders and feature lines, before all others.
	void takeBorder()
	{
		const int before = m_.vertexNum;
		fuseBoundary(boundary_, fused_);
		for (int v = before; v < m_.vertexNum; ++v)
			initFromNeighbours(v);
		for (std::size_t i = 0; i < boundary_.samples.size(); ++i) {
			const SurfacePoint& a      = boundary_.samples[i].point;
			const Vec3f         normal = surface_.mesh.faceNormal(a.face);
			const int           v      = fused_.sampleVertex[i];
			flood_.explore({{a.position, m_.outgoing[v] / 3}, normal});
			samples_.push_back({a, normal, 1 / stretchOf(v)});
			takeDisk(v);
		}
	}

	/// Steps 4 to 8 for one random edge of the cache. False: the cache is empty.
	bool drawBorderEdge()
	{
		if (cache_.empty()) return false;
		const std::size_t i = random_.below(cache_.size());
		const BorderEdge  e = cache_[i];
		cache_[i]           = cache_.back();
		cache_.pop_back();
		// Covered by a later disk, or split since.
		if (isCovered(e.outer)) return true;
		const int h = m_.findEdge(e.inner, e.outer);
		if (h >= 0) placeOnEdge(e, h);
		return true;
	}

	/// Step 2: a random start vertex in a component that no sample reaches yet; -1 when all is
	/// covered.
	int findStart()
	{
		const int n = surface_.mesh.vertexNum;
		for (; scanned_ < n; ++scanned_) {
			const int v = (scanStart_ + scanned_) % n;
			if (isCovered(v) || m_.outgoing[v] < 0 || !isOpen(v)) continue;
			return samples_.empty() ? v : randomUncoveredNear(v);
		}
		return -1;
	}

	/// A random vertex among all uncovered vertices that are connected to v by uncovered vertices.
	int randomUncoveredNear(int v)
	{
		seen_.resize(m_.vertexNum, 0);
		std::vector<int> reached(1, v);
		seen_[v] = 1;
		for (std::size_t i = 0; i < reached.size(); ++i) {
			forEachNeighbour(m_, reached[i], [&](int w) {
				if (seen_[w] || isCovered(w) || !isOpen(w)) return;
				seen_[w] = 1;
				reached.push_back(w);
			});
		}
		for (int w : reached)
			seen_[w] = 0;
		return reached[random_.below(reached.size())];
	}

	// ---- placing

	/// Steps 5 to 7. If the disk of a place finds a sample too near, the place moves on along the
	/// edge.
	void placeOnEdge(const BorderEdge& e, int h)
	{
		double t = unionCrossing(e);
		for (int move = 0; move < maxMoves && t < 1 - sameAsEnd; ++move) {
			const Place place = placeAt(e, h, t);
			flood_.explore(place.sample);
			const int tooNear = findTooNear(place.sample);
			if (tooNear < 0) return accept(place);
			t = std::max(t + 0.1, exitOf(tooNear, e));
		}
		placeAtVertex(e.outer);
	}

	/// Makes the end of a border edge, or a start, a sample. If its disk finds a sample too near,
	/// the front had overrated the way to v, across folds or among needles: v then belongs to this
	/// sample.
	void placeAtVertex(int v)
	{
		const int   face = m_.outgoing[v] / 3;
		const Place place{
			{{m_.position[v], face}, normalOf(face), 1 / stretchOf(v)}, m_.outgoing[v], v};
		flood_.explore(place.sample);
		const int tooNear = findTooNear(place.sample);
		if (tooNear < 0) return accept(place);
		field_.nearest[v] = {std::min(r_, length(placeOf(tooNear) - m_.position[v])), tooNear};
		pushBorderEdges(v);
	}

	Vec3f normalOf(int face) const { return surface_.mesh.faceNormal(fused_.parentFace[face]); }

	Place placeAt(const BorderEdge& e, int h, double t) const
	{
		const Vec3f a = m_.position[e.inner], b = m_.position[e.outer];
		const bool  isStart = t < sameAsEnd && distanceOf(e.inner) > nearLimit_;
		const Vec3f p       = isStart ? a : a + (b - a) * float(t);
		const float s1 = stretchOf(e.inner), s2 = stretchOf(e.outer);
		const float size = 1 / (s1 + (s2 - s1) * float(t));
		return {{{p, h / 3}, normalOf(h / 3), size}, h, isStart ? e.inner : -1};
	}

	/// The place at which the border of the union of disks crosses the edge: the farthest end of a
	/// disk.
	double unionCrossing(const BorderEdge& e)
	{
		double t = exitSeenFrom(e.inner, e);
		labels_.assign(1, sampleOf(e.inner));
		for (int end : {e.inner, e.outer}) {
			forEachNeighbour(m_, end, [&](int w) {
				if (!isCovered(w) || isKnown(sampleOf(w))) return;
				labels_.push_back(sampleOf(w));
				t = std::max(t, exitSeenFrom(w, e));
			});
		}
		return t;
	}

	bool isKnown(int sample) const
	{
		return std::find(labels_.begin(), labels_.end(), sample) != labels_.end();
	}

	/// The place at which the disk of v's sample ends on the edge, from known distances. An end in
	/// the cell of this sample has its distance. For another end, the straight distance is
	/// stretched by the ratio at v. Negative if the disk does not reach the edge.
	double exitSeenFrom(int v, const BorderEdge& e) const
	{
		const int    s        = sampleOf(v);
		const float  straight = length(m_.position[v] - placeOf(s));
		const float  ratio    = straight > 0 ? distanceOf(v) / straight : stretchOf(v);
		const double d1 = distanceTo(e.inner, s, ratio), d2 = distanceTo(e.outer, s, ratio);
		return borderCrossing(d1, std::max(d2, double(r_)), lengthOf(e), r_);
	}

	/// The distance of an end from the sample, never less than the distance of the end from its own
	/// sample.
	double distanceTo(int end, int sample, float ratio) const
	{
		if (sampleOf(end) == sample) return distanceOf(end);
		const float near = sampleOf(end) < 0 ? 0.0f : distanceOf(end);
		return std::max(near, ratio * length(m_.position[end] - placeOf(sample)));
	}

	/// The place at which the disk of a sample met by a flood ends on the edge, from straight
	/// distances.
	double exitOf(int sample, const BorderEdge& e) const
	{
		const float  ratio = 0.5f * (stretchOf(e.inner) + stretchOf(e.outer));
		const double d1    = double(ratio * length(m_.position[e.inner] - placeOf(sample)));
		const double d2    = double(ratio * length(m_.position[e.outer] - placeOf(sample)));
		return borderCrossing(d1, std::max(d2, double(r_)), lengthOf(e), r_);
	}

	double lengthOf(const BorderEdge& e) const
	{
		const float straight = length(m_.position[e.outer] - m_.position[e.inner]);
		return double(straight * 0.5f * (stretchOf(e.inner) + stretchOf(e.outer)));
	}

	/// A sample met by the flood that is nearer than the spacing and faces the same way, or -1.
	int findTooNear(const Sample& sample) const
	{
		return gpr::findTooNear(flood_.metSamples(), samples_, sample, nearLimit_, true);
	}

	// ---- the new sample

	/// Steps 6 and 7, and step 3 for the disk, which has been explored already.
	void accept(const Place& place)
	{
		capped_ = std::int64_t(samples_.size()) >= options_.maxSamples;
		if (capped_) return;
		Sample    sample  = place.sample;
		const int face    = sample.point.face;
		const int v       = place.vertex >= 0 ? place.vertex : split(place);
		sample.point.face = fused_.parentFace[face];
		samples_.push_back(sample);
		fused_.sampleVertex.push_back(v);
		takeDisk(v);
		if (samples_.size() % 256 == 0) workers_.poll(double(samples_.size()) / expected_);
	}

	int split(const Place& place)
	{
		const int a = m_.origin[place.halfEdge], b = m_.target(place.halfEdge);
		if (field_.nearest.size() <= std::size_t(m_.vertexNum)) growTo(m_.vertexNum / 4 * 5 + 64);
		const int v = splitAt(fused_, place.halfEdge, place.sample.point.position);
		initVertex(v, normal_[a].unpack() + normal_[b].unpack(),
				   0.5f * (stretchOf(a) + stretchOf(b)));
		return v;
	}

	void initVertex(int v, const Vec3f& normal, float stretch)
	{
		field_.nearest[v] = unreached;
		field_.mark[v]    = {0, 0};
		normal_[v]        = PackedNormal(normalized(normal));
		if (isStretched()) stretch_[v] = stretch;
	}

	/// Initialises v from the neighbours made before v.
	void initFromNeighbours(int v)
	{
		Vec3f normal;
		float stretch = 0;
		int   num     = 0;
		forEachNeighbour(m_, v, [&](int w) {
			if (w > v) return;
			normal += normal_[w].unpack();
			stretch += stretchOf(w);
			++num;
		});
		initVertex(v, normal, stretch / float(std::max(num, 1)));
	}

	/// Gives the last explored disk to the newest sample, at vertex v, and puts new border edges
	/// into the cache (eq. (2)).
	void takeDisk(int v)
	{
		crossed_.assign(1, v);
		for (const DiskFlood::Reached& w : flood_.reached()) {
			if (w.vertex != v && !isCovered(w.vertex) && w.distance <= r_)
				crossed_.push_back(w.vertex);
		}
		const int id = int(samples_.size()) - 1;
		flood_.commit(id);
		field_.nearest[v] = {0, id};
		for (int w : crossed_)
			pushBorderEdges(w);
	}

	void pushBorderEdges(int v)
	{
		if (!isOpen(v)) return;
		forEachNeighbour(m_, v, [&](int w) {
			if (!isCovered(w) && isOpen(w)) cache_.push_back({v, w});
		});
	}
};

} // namespace

double borderCrossing(double d1, double d2, double edge, double r)
{
	// |p1 + t (p2 - p1)| = r with p0 = 0; p1 · (p2 - p1) follows from the three sides.
	const double a = edge * edge, halfB = 0.5 * (d2 * d2 - d1 * d1 - a), c = d1 * d1 - r * r;
	const double root = halfB * halfB - a * c;
	if (!(a > 0 && root >= 0)) return d1 <= r ? 0 : -1;
	const double t = (-halfB + std::sqrt(root)) / a;
	return t <= 1 ? t : d1 <= r && d2 >= r ? 1 : -1;
}

BorderEdgeSampling sampleBorderEdges(const Surface& surface, const BoundaryCurves& boundary,
									 const BorderEdgeOptions& options, Workers& workers)
{
	BorderEdgeSampler sampler(surface, boundary, options, workers);
	sampler.run();
	return sampler.finish();
}

} // namespace gpr
