// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "front_sampling.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gpr {

namespace {

/// Pairs of samples beyond these distances, over r, have no useful intersection.
constexpr float widestPair  = 1.98f;
constexpr float closestPair = 0.3f;

/// An intersection of the disks of two samples, in the plane of the first, with its fit. The fit is
/// smaller the closer a third disk touches the intersection, and the nearer the distance of the
/// pair is to r. Its place on the surface is found only when its turn comes: more than half of all
/// intersections are taken by then, and the plane shows this for most of the taken intersections.
struct Candidate {
	int   a, b;
	int   fan;  ///< of a: the samples near when the intersection was found
	float side; ///< 1 or -1
	Vec3f guess;
	float size; ///< assumed there
	float fit;
};

/// The samples near a sample when its intersections were searched, and the samples placed near it
/// since. So an intersection can be rejected as taken without a look at the surface.
struct Fan {
	std::vector<int> samples; ///< the near samples, then those placed since
	std::size_t      nearNum;
	int              maxCrossings; ///< the most faces of a walk to an intersection
};

/// Two neighbouring samples, and the plane of the first.
struct Pair {
	int   a, b;
	Vec3f u;        ///< unit vector from a towards b
	Vec3f w;        ///< perpendicular to u
	float distance; ///< straight from a to b
};

/// The third corner of a triangle over a pair, seen from the first sample of the pair.
struct Apex {
	float size        = 1; ///< assumed there
	float length      = 0; ///< distance from a
	float otherLength = 0; ///< distance from b
	float cosine      = 0; ///< of the angle at a between corner and b
	float sine        = 0;
};

bool fitsWorse(const Candidate& a, const Candidate& b)
{
	if (a.fit != b.fit) return a.fit > b.fit;
	return std::tie(a.a, a.b, a.fan, a.side) > std::tie(b.a, b.b, b.fan, b.side);
}

std::uint32_t mix(std::uint32_t x)
{
	x ^= x >> 16;
	x *= 0x7feb352du;
	x ^= x >> 15;
	x *= 0x846ca68bu;
	return x ^ x >> 16;
}

/// The range of sample numbers of a block while blocks are sampled in parallel.
struct BlockRange {
	int firstSample = 0; ///< [firstSample, firstSample + room) belong to the block
	int room        = 0;
	int used        = 0;
};

struct SharedState {
	const Surface&          surface;
	float                   radius;
	std::uint32_t           seed;
	const Buffer<char>&     region; ///< sampled first, per vertex; empty: none
	NearestField            field;
	Buffer<Sample>          samples;
	std::vector<BlockRange> ranges;
};

/// Samples blocks in turn; each thread has its own sampler.
class BlockSampler {
public:
	BlockSampler(SharedState& shared, Workers& workers, int worker) :
			shared_(shared), workers_(workers), worker_(worker), m_(shared.surface.mesh),
			flood_(shared.surface, shared.field, shared.radius), r_(shared.radius),
			nearLimit_((1 - spacingSlack) * shared.radius)
	{
		flood_.numberFrom(worker, workers.threadNum());
		flood_.askBy(Poller(workers, worker));
	}

	bool capped() const { return capped_; }

	/// Floods from a sample on a curve, which has its place already.
	void floodGiven(int s)
	{
		workers_.pollFrom(worker_);
		flood_.run(s, shared_.samples[s]);
	}

	/// Samples a block. inRegion: only the part of the block in the region.
	void run(const Block& block, int blockIndex, bool inRegion)
	{
		region_ = inRegion ? shared_.region.data() : nullptr;
		if (inRegion && !reachesInto(block)) return;
		block_ = &block;
		range_ = &shared_.ranges[blockIndex];
		heap_.clear();
		borderEdges_.clear();
		nextBorderEdge_ = 0;
		random_         = mix(shared_.seed * 2654435761u + std::uint32_t(blockIndex));
		scanned_        = 0;
		scanStart_      = int(random_ % std::uint32_t(block.end - block.begin));
		takeUpNeighbours();
		Sample place;
		bool   isUncovered = false;
		while (findPlace(place, isUncovered)) {
			workers_.pollFrom(worker_);
			if (!improvesAVertex(place)) continue;
			if (range_->used == range_->room) {
				capped_ = true;
				return;
			}
			tryToPlace(place, isUncovered);
		}
	}

private:
	SharedState&           shared_;
	Workers&               workers_;
	int                    worker_; ///< the thread that samples the blocks
	const HalfEdgeMesh&    m_;
	DiskFlood              flood_;
	float                  r_;
	float                  nearLimit_;
	const Block*           block_  = nullptr;
	const char*            region_ = nullptr; ///< region for samples now; null: everywhere
	BlockRange*            range_  = nullptr;
	std::vector<Candidate> heap_;
	std::vector<int> borderEdges_; ///< half-edges out of the covered part: the paper's cache C
	std::size_t      nextBorderEdge_ = 0;
	std::vector<int> earlier_;      ///< samples that reach into the block from elsewhere, ascending
	int              firstNew_ = 0; ///< the first sample after these
	std::vector<Fan> fans_; ///< of the earlier samples, then of the new samples of the block
	int              scanned_   = 0; ///< vertices of the block seen by the scan
	int              scanStart_ = 0;
	std::uint32_t    random_    = 1; ///< of the block, from the seed
	bool             capped_    = false;

	float distanceOf(int v) const { return shared_.field.nearest[v].distance; }
	int   sampleOf(int v) const { return shared_.field.nearest[v].sample; }
	Vec3f placeOf(int sample) const { return shared_.samples[sample].point.position; }
	float sizeOf(int sample) const { return shared_.samples[sample].size; }

	/// Whether the sample is nearer to p than `limit` times the mean of both sizes.
	bool isNearer(const Vec3f& p, float size, int sample, float limit) const
	{
		const float wanted = limit * (0.5f * (size + sizeOf(sample)));
		return squaredLength(p - placeOf(sample)) < wanted * wanted;
	}
	bool isTooNear(const Vec3f& p, float size, int sample) const
	{
		return isNearer(p, size, sample, nearLimit_);
	}

	bool reachesInto(const Block& block) const
	{
		const char* const end = region_ + block.end;
		return std::find(region_ + block.begin, end, char(1)) != end;
	}
	bool isOpen(int v) const { return region_ == nullptr || region_[v] != 0; }
	bool isOpenFace(int f) const
	{
		const int* v = &m_.origin[3 * f];
		return isOpen(v[0]) && isOpen(v[1]) && isOpen(v[2]);
	}

	/// A sample without its normal, as are all samples up to tryToPlace.
	Sample placeAt(const SurfacePoint& point) const
	{
		return {point, {}, sizeAt(shared_.surface, point)};
	}

	/// A face belongs to the block that holds its smallest vertex, its first corner.
	bool isMine(int face) const
	{
		const int v = m_.origin[3 * face];
		return v >= block_->begin && v < block_->end;
	}

	/// Takes up samples of other blocks and of the border that reach into this block: the front of
	/// the block begins at their intersections and border edges.
	void takeUpNeighbours()
	{
		earlier_.clear();
		for (int v = block_->begin; v < block_->end; ++v) {
			const int s = sampleOf(v);
			if (s >= 0) earlier_.push_back(s);
		}
		sortUnique(earlier_);
		firstNew_ = range_->firstSample + range_->used;
		fans_.clear();
		addForeignIntersections();
		for (int v = block_->begin; v < block_->end; ++v) {
			if (sampleOf(v) >= 0) addBorderEdges(v);
		}
	}

	/// Adds the intersections of earlier samples. On a surface about twenty disks reach into one
	/// disk. Among a dust of tiny components with sampled borders there are far more; border edges
	/// serve as well there, without the cube of the number as cost.
	void addForeignIntersections()
	{
		// A disk meets about six disks; ten times six is a dust of components.
		constexpr std::size_t maxSamples = 4096, maxNear = 64;
		const bool            areTooMany = earlier_.size() > maxSamples;
		std::vector<int>      near;
		for (int s : earlier_) {
			workers_.pollFrom(worker_);
			near.clear();
			for (int t : earlier_) {
				if (areTooMany) break;
				if (t != s && isNearer(placeOf(s), sizeOf(s), t, 2 * r_)) near.push_back(t);
			}
			fans_.push_back({near, near.size(), maxFacesCrossed});
			if (near.size() > maxNear) continue;
			for (int t : near) {
				if (t > s) addIntersections(s, t);
			}
		}
	}

	void addBorderEdges(int v)
	{
		if (distanceOf(v) > r_) return;
		forEachOutgoing(m_, v, [&](int h) {
			if (distanceOf(m_.target(h)) > r_) borderEdges_.push_back(h);
		});
	}

	/// Finds the next place for a sample: the best intersection, else a border edge, else an
	/// uncovered vertex.
	bool findPlace(Sample& place, bool& isUncovered)
	{
		isUncovered = false;
		while (!heap_.empty()) {
			std::pop_heap(heap_.begin(), heap_.end(), fitsWorse);
			const Candidate c = heap_.back();
			heap_.pop_back();
			if (!isTakenByNewcomer(c) && findIntersection(c, place) && !isTaken(place)) return true;
		}
		while (nextBorderEdge_ < borderEdges_.size()) {
			const int h = borderEdges_[nextBorderEdge_++];
			if (placeOnBorderEdge(h, place) && !isTaken(place)) return true;
		}
		borderEdges_.clear();
		nextBorderEdge_ = 0;
		isUncovered     = true;
		return findUncoveredVertex(place);
	}

	bool findUncoveredVertex(Sample& place)
	{
		const int n = block_->end - block_->begin;
		for (; scanned_ < n; ++scanned_) {
			const int v = block_->begin + (scanStart_ + scanned_) % n;
			if (distanceOf(v) <= r_ || m_.outgoing[v] < 0 || !isOpen(v)) continue;
			place = placeAt({m_.position[v], m_.outgoing[v] / 3});
			++scanned_;
			return true;
		}
		return false;
	}

	/// Eq. (3): the point of a border edge (eq. (2)) at which the disk of the inner end's sample
	/// ends.
	bool placeOnBorderEdge(int h, Sample& place) const
	{
		const int a = m_.origin[h], b = m_.target(h);
		if (!(distanceOf(a) <= r_ && distanceOf(b) > r_) || !isMine(h / 3)) return false;
		if (!isOpen(a) || !isOpen(b)) return false;
		const Vec3f  edge = m_.position[b] - m_.position[a];
		const Vec3f  w    = m_.position[a] - placeOf(sampleOf(a));
		const double qa = squaredLength(edge), qb = 2 * double(dot(edge, w));
		const double radius = double(r_) * sizeOf(sampleOf(a));
		const double qc     = double(squaredLength(w)) - radius * radius;
		const double root   = qb * qb - 4 * qa * qc;
		double       t      = root > 0 && qa > 0 ? (-qb + std::sqrt(root)) / (2 * qa) : 0.5;
		t                   = std::min(1.0, std::max(0.0, t));
		place               = placeAt({m_.position[a] + edge * float(t), h / 3});
		return true;
	}

	/// Whether a sample that owns a vertex near the place is too close by now. With many vertices a
	/// cell, the corners of the face are enough: the flood has met every sample too close further
	/// out. Among large faces two rings are checked.
	bool isTaken(const Sample& place) const
	{
		const Vec3f p    = place.point.position;
		const int   face = place.point.face;
		for (int k = 0; k < 3; ++k) {
			const int s = sampleOf(m_.origin[3 * face + k]);
			if (s >= 0 && isTooNear(p, place.size, s)) return true;
		}
		return isCoarse(face, place.size) && isTakenFarther(place);
	}

	bool isTakenFarther(const Sample& place) const
	{
		bool       taken = false;
		const auto look  = [&](int w) {
            const int s = sampleOf(w);
            taken       = taken || (s >= 0 && isTooNear(place.point.position, place.size, s));
		};
		for (int k = 0; k < 3 && !taken; ++k) {
			forEachNeighbour(m_, m_.origin[3 * place.point.face + k], [&](int w) {
				look(w);
				if (!taken) forEachNeighbour(m_, w, look);
			});
		}
		return taken;
	}

	bool isCoarse(int face, float size) const
	{
		constexpr float coarseEdge = 0.5f; // of the disk's radius
		const float     limit      = coarseEdge * coarseEdge * r_ * r_ * (size * size);
		for (int h = 3 * face; h < 3 * face + 3; ++h) {
			if (squaredLength(m_.edgeVector(h)) > limit) return true;
		}
		return false;
	}

	/// Whether the place is nearer to some vertex than the sample of the vertex. A sample without
	/// vertices could be inserted again and again.
	bool improvesAVertex(const Sample& place) const
	{
		for (int k = 0; k < 3; ++k) {
			const int   v        = m_.origin[3 * place.point.face + k];
			const float distance = length(m_.position[v] - place.point.position);
			if (distance * 1.02f < distanceOf(v) * place.size) return true;
		}
		return false;
	}

	/// Places a sample unless its disk meets a sample too near. If no disk covered the vertex, the
	/// front had overrated the way to it, across folds or among needles: the vertex then belongs to
	/// the sample met.
	void tryToPlace(Sample sample, bool isUncovered)
	{
		sample.normal = m_.faceNormal(sample.point.face);
		flood_.explore(sample);
		const int tooNear =
			findTooNear(flood_.metSamples(), shared_.samples, sample, nearLimit_, isUncovered);
		if (tooNear >= 0) {
			if (isUncovered) cover(sample.point, tooNear);
			return;
		}
		const int s        = range_->firstSample + range_->used++;
		shared_.samples[s] = sample;
		flood_.commit(s);
		extendFront(s);
	}

	void cover(const SurfacePoint& place, int sample)
	{
		for (int k = 0; k < 3; ++k) {
			const int v = m_.origin[3 * place.face + k];
			if (!(m_.position[v] == place.position)) continue;
			shared_.field.nearest[v] = {length(place.position - placeOf(sample)) / sizeOf(sample),
										sample};
		}
	}

	/// Adds the intersections and border edges of a new sample to the front.
	void extendFront(int s)
	{
		// A straight way through a disk of n vertices crosses about √n faces. Among needles it can
		// cross thousands; then border edges serve better.
		const std::vector<int>& met = flood_.metSamples();
		const int maxCrossings      = 32 + 8 * int(std::sqrt(double(flood_.reached().size())));
		fans_.push_back({met, met.size(), maxCrossings});
		for (int t : met) {
			if (t == s) continue;
			addIntersections(s, t);
			const int fan = fanOf(t);
			if (fan >= 0) fans_[fan].samples.push_back(s);
		}
		// Border edges are only needed when the front has no intersections.
		if (heap_.empty()) {
			for (const DiskFlood::Reached& v : flood_.reached()) {
				if (sampleOf(v.vertex) == s) addBorderEdges(v.vertex);
			}
		}
	}

	/// The fan of a sample; -1: none.
	int fanOf(int sample) const
	{
		const int own = int(earlier_.size()) + sample - firstNew_;
		if (sample >= firstNew_ && own < int(fans_.size())) return own;
		return placeIn(earlier_, sample);
	}

	/// Adds the two points at the wanted distance from both samples, if the samples near s leave
	/// room. The fan of s is the last fan.
	void addIntersections(int s, int t)
	{
		Pair pair;
		if (!makePair(s, t, pair)) return;
		const float misfit = std::abs(pair.distance - wantedDistance(s, t));
		for (float side : {-1.0f, 1.0f})
			addIntersection(pair, side, misfit);
	}

	float wantedDistance(int s, int t) const { return r_ * (0.5f * (sizeOf(s) + sizeOf(t))); }

	/// False if the two samples have no useful intersection.
	bool makePair(int s, int t, Pair& pair) const
	{
		const Sample& a       = shared_.samples[s];
		const Vec3f   between = placeOf(t) - a.point.position;
		const float   wanted  = wantedDistance(s, t);
		pair                  = {s, t, {}, {}, length(between)};
		if (pair.distance > widestPair * wanted || pair.distance < closestPair * wanted)
			return false;
		pair.u = normalized(tangential(between, a.normal));
		pair.w = cross(a.normal, pair.u);
		return true;
	}

	void addIntersection(const Pair& pair, float side, float misfit)
	{
		const Sample& a = shared_.samples[pair.a];
		// The mean size of the pair serves until the place is known.
		const Apex  apex = apexOf(pair, 0.5f * (a.size + sizeOf(pair.b)));
		const Vec3f guess =
			a.point.position + (pair.u * apex.cosine + pair.w * (side * apex.sine)) * apex.length;
		float third = 0;
		if (!isRoughlyFree(guess, apex.size, pair, third)) return;
		// Pairs closer than the ideal leave room for a whole triangle. Distant pairs would start a
		// square lattice, which is as saturated but not wanted. Both terms are divided by the local
		// size, or dense places would always come first.
		const float fit = (third + misfit) / apex.size + smallChance();
		heap_.push_back({pair.a, pair.b, int(fans_.size()) - 1, side, guess, apex.size, fit});
		std::push_heap(heap_.begin(), heap_.end(), fitsWorse);
	}

	/// Whether a sample placed since the intersection was found is near, in the plane.
	bool isTakenByNewcomer(const Candidate& c) const
	{
		const Fan& fan = fans_[c.fan];
		const auto end = fan.samples.rend() - std::ptrdiff_t(fan.nearNum);
		return std::any_of(fan.samples.rbegin(), end,
						   [&](int s) { return isNearer(c.guess, c.size, s, roughLimit()); });
	}

	/// Finds the place of the intersection on the surface; false if it lies in another block or is
	/// not free.
	bool findIntersection(const Candidate& c, Sample& place) const
	{
		Pair pair;
		makePair(c.a, c.b, pair);
		const int  maxCrossings = fans_[c.fan].maxCrossings;
		const Apex apex         = apexOf(pair, c.size);
		if (!walkToIntersection(pair, c.side, apex, maxCrossings, place.point)) return false;
		place.size = sizeAt(shared_.surface, place.point);
		if (std::abs(place.size - apex.size) > 0.01f * apex.size) {
			const Apex better = apexOf(pair, place.size);
			if (!walkToIntersection(pair, c.side, better, maxCrossings, place.point)) return false;
			place.size = sizeAt(shared_.surface, place.point);
		}
		const int face = place.point.face;
		return isMine(face) && isOpenFace(face) && isFree(place, pair, fans_[c.fan]);
	}

	/// The triangle of a pair and a neighbouring place of given size, by the law of cosines.
	Apex apexOf(const Pair& pair, float size) const
	{
		Apex apex;
		apex.size           = size;
		apex.length         = r_ * (0.5f * (sizeOf(pair.a) + size));
		apex.otherLength    = r_ * (0.5f * (sizeOf(pair.b) + size));
		const float unequal = (apex.length - apex.otherLength) * (apex.length + apex.otherLength);
		const float cosine =
			pair.distance / (2 * apex.length) + unequal / (2 * pair.distance * apex.length);
		apex.cosine = std::clamp(cosine, -1.0f, 1.0f);
		apex.sine   = std::sqrt(1 - apex.cosine * apex.cosine);
		return apex;
	}

	/// A random length up to a hundredth of r. The seed so decides between places with equal fit,
	/// frequent when the front begins at a straight border.
	float smallChance()
	{
		random_ = random_ * 1664525u + 1013904223u;
		return 0.01f * r_ * float(random_ >> 8) * (1 / 16777216.0f);
	}

	/// A sample nearer in the plane than this is too near on the surface as well.
	float roughLimit() const { return nearLimit_ - 0.05f * r_; }

	/// Cheap test in the tangent plane among the samples of the last fan. Also finds the distance
	/// to the nearest third sample, relative to the mean of the two sizes.
	bool isRoughlyFree(const Vec3f& p, float size, const Pair& pair, float& third) const
	{
		const float limit   = roughLimit() * roughLimit();
		float       nearest = HUGE_VALF;
		for (int other : fans_.back().samples) {
			if (other == pair.a || other == pair.b) continue;
			const float relative = 2 * size / (size + sizeOf(other));
			nearest = std::min(nearest, squaredLength(p - placeOf(other)) * (relative * relative));
			if (nearest < limit * (size * size)) return false;
		}
		third = std::sqrt(nearest);
		return true;
	}

	bool isFree(const Sample& place, const Pair& pair, const Fan& fan) const
	{
		const auto isInTheWay = [&](int other) {
			return other != pair.a && isTooNear(place.point.position, place.size, other);
		};
		return !isInTheWay(pair.b) &&
			   std::none_of(fan.samples.begin(), fan.samples.end(), isInTheWay);
	}

	/// Walks from a at the angle from the plane. If a bend of the surface leaves the other sample
	/// off by more than 1 %, walks again at the angle of a secant step.
	bool walkToIntersection(const Pair& pair, float side, const Apex& apex, int maxCrossings,
							SurfacePoint& place) const
	{
		const Sample& a      = shared_.samples[pair.a];
		const float   cosine = apex.cosine, sine = apex.sine;
		if (!walkFrom(a, (pair.u * cosine + pair.w * (side * sine)) * apex.length, maxCrossings,
					  place))
			return false;
		const float error = length(place.position - placeOf(pair.b)) - apex.otherLength;
		if (std::abs(error) <= 0.01f * apex.otherLength) return true;
		const float lever = pair.distance * sine * (apex.length / apex.otherLength);
		const float turn  = std::clamp(-error / (lever + 1e-20f), -0.3f, 0.3f);
		// Turns by a small angle without trigonometric functions of libm: their last bits differ
		// between systems.
		const float ct = 1 - 0.5f * turn * turn + turn * turn * turn * turn * (1 / 24.0f);
		const float st = turn - turn * turn * turn * (1 / 6.0f);
		const float c2 = cosine * ct - sine * st, s2 = sine * ct + cosine * st;
		return walkFrom(a, (pair.u * c2 + pair.w * (side * s2)) * apex.length, maxCrossings, place);
	}

	bool walkFrom(const Sample& a, const Vec3f& step, int maxCrossings, SurfacePoint& place) const
	{
		place = a.point;
		return walk(m_, place, step, maxCrossings);
	}
};

/// The most samples on a face. Disks of radius (1-ε) r/2 do not overlap, so a sample takes at least
/// 0.78 r² of flat ground; 0.5 r² is counted. A needle has almost no area: its length counts.
double roomOf(const Surface& surface, int f, float radius)
{
	const HalfEdgeMesh&  m    = surface.mesh;
	const Buffer<float>& size = surface.size;
	float                r    = radius;
	if (!size.empty())
		r *= std::min({size[m.origin[3 * f]], size[m.target(3 * f)], size[m.apex(3 * f)]});
	const double area = 0.5 * double(length(m.faceCross(f)));
	const double longest =
		double(std::max({squaredLength(m.edgeVector(3 * f)), squaredLength(m.edgeVector(3 * f + 1)),
						 squaredLength(m.edgeVector(3 * f + 2))}));
	const double bySpace = area / (0.5 * double(r) * r);
	return area < 0.05 * longest ? bySpace + std::sqrt(longest) / (0.5 * r) : bySpace;
}

/// Makes a range for each block, from firstSample on, with room for all samples that disks of
/// radius r leave on the faces of the block, and a few more. Cost: a parallel pass over the faces.
std::vector<BlockRange> makeRanges(const Surface& surface, const OctreeBlocks& partition,
								   float radius, int firstSample, Workers& workers)
{
	constexpr int           spareRoom = 64; // even a block of few vertices may need these
	const HalfEdgeMesh&     m         = surface.mesh;
	std::vector<BlockRange> ranges(partition.blocks.size());
	// Faces are ordered by their first corner, so the faces of a block are consecutive.
	workers.forTasks(ranges.size(), [&](std::size_t b, int) {
		const auto firstFaceFrom = [&](int vertex) {
			return firstOf(m.faceNum, [&](int f) { return m.origin[3 * f] >= vertex; });
		};
		double    room = spareRoom;
		const int end  = firstFaceFrom(partition.blocks[b].end);
		for (int f = firstFaceFrom(partition.blocks[b].begin); f < end; ++f)
			room += roomOf(surface, f, radius);
		ranges[b].room = int(std::min(room, 1e9));
	});
	std::int64_t next = firstSample;
	for (BlockRange& range : ranges) {
		range.firstSample = int(next);
		next += range.room;
	}
	return ranges;
}

/// Marks samples that own a vertex. A sample whose vertices were all taken by later samples is of
/// no use.
Buffer<char> findOwners(const SharedState& shared, const Sampling& result, Workers& workers)
{
	Buffer<char> owns(shared.samples.size(), 0);
	workers.forEach(result.nearest.size(), [&](int v) {
		const int s = result.nearest[v].sample;
		if (s >= 0) __atomic_store_n(&owns[s], char(1), __ATOMIC_RELAXED);
	});
	return owns;
}

/// Joins the samples of all blocks in one list and renames the samples in the vertices' entries.
void compact(const SharedState& shared, Workers& workers, Sampling& result)
{
	const int          given = result.boundarySampleNum;
	const Buffer<char> owns  = findOwners(shared, result, workers);
	Buffer<int>        rename(shared.samples.size());
	for (int s = 0; s < given; ++s) {
		rename[s] = s;
		result.samples.push_back(shared.samples[s]);
	}
	for (const BlockRange& range : shared.ranges) {
		for (int s = range.firstSample; s < range.firstSample + range.used; ++s) {
			if (!owns[s]) continue;
			rename[s] = int(result.samples.size());
			result.samples.push_back(shared.samples[s]);
		}
	}
	workers.forEach(result.nearest.size(), [&](int v) {
		int& s = result.nearest[v].sample;
		if (s >= 0) s = rename[s];
	});
}

/// Calls body(sampler, block) once for every block, colour by colour.
template <class Body>
void forBlocks(const OctreeBlocks& partition, Workers& workers, std::vector<BlockSampler>& samplers,
			   const Body& body)
{
	for (const std::vector<int>& ids : partition.byColour)
		workers.forTasks(ids.size(),
						 [&](std::size_t i, int worker) { body(samplers[worker], ids[i]); });
}

void sampleBlocks(const OctreeBlocks& partition, bool inRegion, Workers& workers,
				  std::vector<BlockSampler>& samplers)
{
	forBlocks(partition, workers, samplers, [&](BlockSampler& sampler, int block) {
		sampler.run(partition.blocks[block], block, inRegion);
	});
}

/// Floods from the samples of curves, each with the samples of its block. Fast since these blocks
/// are small, so that threads find several of a colour on small parts, too: without new samples no
/// seams arise. A flood reaches one edge, at most 1.1 r, beyond its disk of radius r, and its
/// sample lies on a face that may reach as far beyond the block: together less than half a block.
void floodGiven(const BoundaryCurves& boundary, const Surface& surface, float radius,
				Workers& workers, std::vector<BlockSampler>& samplers)
{
	if (boundary.samples.empty()) return;
	constexpr float           blockWidth = 7; // in radii
	const HalfEdgeMesh&       m          = surface.mesh;
	const OctreeBlocks        partition  = cutIntoBlocks(surface, blockWidth * radius, workers);
	const std::vector<Block>& blocks     = partition.blocks;
	const auto                blockOf    = [&](std::size_t s) {
        const int v = m.origin[3 * boundary.samples[s].point.face];
        return firstOf(int(blocks.size()), [&](int b) { return v < blocks[b].end; });
	};
	Buffer<int> start, given;
	sortIntoBuckets(boundary.samples.size(), blocks.size(), blockOf, workers, start, given);
	forBlocks(partition, workers, samplers, [&](BlockSampler& sampler, int block) {
		for (int i = start[block]; i < start[block + 1]; ++i)
			sampler.floodGiven(given[i]);
	});
}

} // namespace

void labelBorder(const BoundaryCurves& boundary, Sampling& result)
{
	for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
		const Curve& curve = boundary.curves[c];
		for (int i = 0; i < curve.pointNum(); ++i)
			result.nearest[curve.vertex[i]] = {0.0f, boundary.sampleOfPoint[c][i]};
	}
	for (std::size_t s = 0; s < boundary.samples.size(); ++s) {
		const CurveSample& sample = boundary.samples[s];
		if (sample.curve < 0) result.nearest[sample.vertex] = {0.0f, int(s)};
	}
}

Sampling sampleFront(const Surface& surface, const BoundaryCurves& boundary,
					 const OctreeBlocks& partition, float radius, std::uint32_t seed,
					 Workers& workers, const Buffer<char>& region)
{
	const HalfEdgeMesh& m = surface.mesh;
	Sampling            result;
	result.radius            = radius;
	result.boundarySampleNum = int(boundary.samples.size());

	SharedState shared{surface, radius, seed, region, {}, {}, {}};
	shared.ranges = makeRanges(surface, partition, radius, result.boundarySampleNum, workers);
	shared.samples.reset(std::size_t(shared.ranges.back().firstSample) + shared.ranges.back().room);
	shared.field.nearest.reset(m.vertexNum);
	shared.field.mark.reset(m.vertexNum);
	workers.forEach(m.vertexNum, [&](int v) {
		shared.field.nearest[v] = {HUGE_VALF, -1};
		shared.field.mark[v]    = {0, 0};
	});

	std::vector<BlockSampler> samplers;
	samplers.reserve(std::size_t(workers.threadNum()));
	for (int worker = 0; worker < workers.threadNum(); ++worker)
		samplers.emplace_back(shared, workers, worker);
	for (int s = 0; s < result.boundarySampleNum; ++s) {
		const SurfacePoint& a = boundary.samples[s].point;
		shared.samples[s]     = {a, m.faceNormal(a.face), sizeAt(surface, a)};
	}
	floodGiven(boundary, surface, radius, workers, samplers);
	if (!region.empty()) sampleBlocks(partition, true, workers, samplers);
	sampleBlocks(partition, false, workers, samplers);
	for (const BlockSampler& s : samplers)
		result.capped = result.capped || s.capped();
	result.nearest.swap(shared.field.nearest);
	compact(shared, workers, result);
	labelBorder(boundary, result);
	return result;
}

} // namespace gpr
