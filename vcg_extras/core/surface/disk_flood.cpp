// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "disk_flood.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Cosine of about 37°: beyond, the chord says too little about the distance.
constexpr float flatCosine = 0.8f;

/// A settled vertex is visited again if a way shorter by this share turns up.
constexpr float worthAnotherVisit = 1e-3f;
/// Most repeated visits of vertices in a flood: among needles a way could get shorter bit by bit,
/// nearly without end. On scans a flood revisits some per cent of its few dozen vertices.
constexpr int maxVisitsAgain = 48;

} // namespace

/// The triangle (v, b, a) is laid into the plane with v at 0 and b on the axis; the source lies
/// below the axis, a above it.
///
///               a
///             /   \.
///     v -----x-----> b        The straight line from the source to a must cross v-b.
///         \  |  /
///          source
float unfoldedDistance(float d1, float d2, float lengthVB, float lengthVA, float lengthAB)
{
	const float half   = 0.5f / lengthVB;
	const float sx     = (d1 * d1 - d2 * d2 + lengthVB * lengthVB) * half;
	const float ax     = (lengthVA * lengthVA - lengthAB * lengthAB + lengthVB * lengthVB) * half;
	const float sy     = std::sqrt(std::max(0.0f, d1 * d1 - sx * sx));
	const float ay     = std::sqrt(std::max(0.0f, lengthVA * lengthVA - ax * ax));
	const float height = sy + ay;
	if (!(height > 0)) return HUGE_VALF;
	const float crossing = sx + (ax - sx) * sy / height;
	if (!(crossing >= 0 && crossing <= lengthVB)) return HUGE_VALF;
	return std::sqrt((ax - sx) * (ax - sx) + height * height);
}

void DiskFlood::explore(const Sample& sample)
{
	scale_ = stretch_ == nullptr ? 1 / sample.size : 1.0f; // a stretch contains the size
	if (!useChords_ || !exploreFlat(sample)) exploreUnfolding(sample);
}

void DiskFlood::commit(int id)
{
	for (int v : queue_) {
		NearestField::Nearest& n = field_.nearest[v];
		if (field_.trial[v].distance < n.distance) n = {field_.trial[v].distance, id};
	}
}

void DiskFlood::meet(int vertex)
{
	const NearestField::Nearest& n = field_.nearest[vertex];
	if (n.sample < 0 || n.distance > radius_) return;
	// Neighbours mostly have the same sample. Other samples are a dozen at most, and a linear
	// search is faster than any set.
	if (!met_.empty() && met_.back() == n.sample) return;
	if (std::find(met_.begin(), met_.end(), n.sample) == met_.end()) met_.push_back(n.sample);
}

/// False: the disk is not flat.
bool DiskFlood::exploreFlat(const Sample& sample)
{
	const int stamp = 2 * ++flood_;
	queue_.clear();
	met_.clear();
	// The begins of the arrays are read once: the compiler cannot know that no write to the arrays
	// changes their begins.
	NearestField::Trial* const         trial    = field_.trial.data();
	const NearestField::Nearest* const nearest  = field_.nearest.data();
	const Vec3f* const                 position = m_.position.data();
	const Vec3f                        centre = sample.point.position, normal = sample.normal;

	const auto reach = [&](int v) {
		if (trial[v].stamp >= stamp) return;
		trial[v].stamp = stamp;
		queue_.push_back(v);
	};
	for (int k = 0; k < 3; ++k)
		reach(m_.origin[3 * sample.point.face + k]);
	for (std::size_t i = 0; i < queue_.size(); ++i) {
		const int   v      = queue_[i];
		const float cosine = dot(normal_[v].unpack(), normal);
		if (!(cosine >= flatCosine)) return false;
		const float chord    = length(position[v] - centre) * scale_;
		const float distance = chord * (1 + (1 - std::min(cosine, 1.0f)) * (1 / 12.0f));
		trial[v].distance    = distance;
		if (distance > radius_ || distance >= nearest[v].distance) continue;
		forEachNeighbour(m_, v, reach);
	}
	for (int v : queue_)
		meet(v);
	return true;
}

void DiskFlood::exploreUnfolding(const Sample& sample)
{
	++flood_;
	queue_.clear();
	met_.clear();
	heap_.clear();
	visitedAgainNum_ = 0;
	for (int k = 0; k < 3; ++k) {
		const int v = m_.origin[3 * sample.point.face + k];
		tryDistance(v, wayFrom(sample, v) * scale_);
	}
	while (!heap_.empty()) {
		const HeapEntry            e = popHeap();
		const NearestField::Trial& t = field_.trial[e.vertex];
		if (e.distance > t.distance) continue;
		settle(e.vertex, e.distance, sample);
	}
}

/// The length from the sample straight to a corner of its face.
float DiskFlood::wayFrom(const Sample& sample, int corner) const
{
	const float straight = length(m_.position[corner] - sample.point.position);
	float       sum      = 3 * stretchAt(corner);
	for (int k = 0; k < 3; ++k)
		sum += stretchAt(m_.origin[3 * sample.point.face + k]);
	return straight * (sum / 6); // in this order a stretch of 1 keeps the length to the bit
}

void DiskFlood::tryDistance(int vertex, float distance)
{
	NearestField::Trial& t = field_.trial[vertex];
	if (t.stamp == 2 * flood_ && distance >= t.distance) return;
	if (t.stamp == 2 * flood_ + 1) {
		if (distance >= t.distance * (1 - worthAnotherVisit)) return;
		if (visitedAgainNum_ >= maxVisitsAgain) return;
		++visitedAgainNum_;
		t.distance = distance;
	}
	else {
		t = {distance, 2 * flood_};
	}
	pushHeap({distance, vertex});
}

void DiskFlood::settle(int v, float distance, const Sample& sample)
{
	const int stamp = 2 * flood_;
	if (field_.trial[v].stamp == stamp) {
		field_.trial[v].stamp = stamp + 1;
		queue_.push_back(v);
		meet(v);
	}
	if (!(distance < field_.nearest[v].distance) || distance > radius_) return;

	// Along the edges, and across every triangle with another settled corner.
	ring_.clear();
	forEachNeighbour(m_, v, [&](int w) {
		ring_.push_back({w, length(m_.position[w] - m_.position[v]) * scale_});
	});
	for (const Spoke& s : ring_)
		tryDistance(s.vertex, distance + s.length * 0.5f * (stretchAt(v) + stretchAt(s.vertex)));
	const bool isClosed = !m_.isBorderVertex(v);
	for (std::size_t i = 0; i + !isClosed < ring_.size(); ++i)
		unfoldBetween(v, ring_[i], ring_[i + 1 < ring_.size() ? i + 1 : 0], sample);
}

/// Tries the ways over the triangle of v and two consecutive neighbours.
void DiskFlood::unfoldBetween(int v, const Spoke& a, const Spoke& b, const Sample& sample)
{
	const int  settled  = 2 * flood_ + 1;
	const bool aSettled = field_.trial[a.vertex].stamp == settled;
	const bool bSettled = field_.trial[b.vertex].stamp == settled;
	if (!aSettled && !bSettled) return;
	const float between = length(m_.position[b.vertex] - m_.position[a.vertex]) * scale_;
	if (aSettled) unfoldOver(v, a, b, between, sample);
	if (bSettled) unfoldOver(v, b, a, between, sample);
}

/// Tries the way to the third corner of a triangle over the edge between two settled corners, v and
/// `known`. All edges of the triangle take the mean stretch of the triangle: stretched by the means
/// of their own ends, three edges need not make a triangle.
void DiskFlood::unfoldOver(int v, const Spoke& known, const Spoke& wanted, float between,
						   const Sample& sample)
{
	const float d1 = field_.trial[v].distance, d2 = field_.trial[known.vertex].distance;
	const float s =
		(stretchAt(v) + stretchAt(known.vertex) + stretchAt(wanted.vertex)) * (1 / 3.0f);
	const float d = unfoldedDistance(d1, d2, s * known.length, s * wanted.length, s * between);
	if (!(d < HUGE_VALF)) return;
	// No way on the surface is shorter than the chord, as every stretch is at least 1.
	const float chord = length(m_.position[wanted.vertex] - sample.point.position) * scale_;
	tryDistance(wanted.vertex, std::max(d, chord));
}

void DiskFlood::pushHeap(HeapEntry e)
{
	std::size_t i = heap_.size();
	heap_.push_back(e);
	while (i > 0) {
		const std::size_t parent = (i - 1) / 2;
		if (heap_[parent].distance <= e.distance) break;
		heap_[i] = heap_[parent];
		i        = parent;
	}
	heap_[i] = e;
}

DiskFlood::HeapEntry DiskFlood::popHeap()
{
	const HeapEntry top  = heap_.front();
	const HeapEntry last = heap_.back();
	heap_.pop_back();
	const std::size_t n = heap_.size();
	std::size_t       i = 0;
	while (n > 0) {
		std::size_t child = 2 * i + 1;
		if (child >= n) break;
		if (child + 1 < n && heap_[child + 1].distance < heap_[child].distance) ++child;
		if (heap_[child].distance >= last.distance) break;
		heap_[i] = heap_[child];
		i        = child;
	}
	if (n > 0) heap_[i] = last;
	return top;
}

} // namespace gpr
