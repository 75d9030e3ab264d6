// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "disk_flood.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Cosine of about 37°: beyond, the chord says too little about the distance.
constexpr float flatCosine = 0.8f;

/// Longest edge, over the disk's radius, of a face that is small against the disk.
constexpr float fineEdge = 1 / 6.0f;
/// A vertex passes its distance on again if a way shorter by this share turns up.
constexpr float worthAnotherVisit = 1e-3f;
/// Most repeated visits of a flood, for each reached vertex: among needles a way could get shorter
/// bit by bit, nearly without end.
constexpr std::size_t mostVisitsAgain = 4;

/// The length of a way along a chord between two places whose normals have this cosine.
float bentLength(float chord, float cosine)
{
	return chord * (1 + (1 - std::min(cosine, 1.0f)) * (1 / 12.0f));
}

} // namespace

/// The triangle (v, b, a) is laid into the plane with v at 0 and b on the axis; the source lies
/// below the axis, a above it.
///
///               a
///             /   \.
///     v -----x-----> b        The straight line from the source to a must cross v-b.
///         \  |  /
///          source
UnfoldedWay unfold(float d1, float d2, float lengthVB, float lengthVA, float lengthAB)
{
	const float half   = 0.5f / lengthVB;
	const float sx     = (d1 * d1 - d2 * d2 + lengthVB * lengthVB) * half;
	const float ax     = (lengthVA * lengthVA - lengthAB * lengthAB + lengthVB * lengthVB) * half;
	const float sy     = std::sqrt(std::max(0.0f, d1 * d1 - sx * sx));
	const float ay     = std::sqrt(std::max(0.0f, lengthVA * lengthVA - ax * ax));
	const float height = sy + ay;
	if (!(height > 0)) return {};
	const float crossing = sx + (ax - sx) * sy / height;
	if (!(crossing >= 0 && crossing <= lengthVB)) return {};
	const float distance = std::sqrt((ax - sx) * (ax - sx) + height * height);
	return {distance, crossing / lengthVB, distance * sy / height};
}

void DiskFlood::explore(const Sample& sample)
{
	scale_  = stretch_ == nullptr ? 1 / sample.size : 1.0f; // a stretch contains the size
	centre_ = sample.point.position;
	isFine_ = useChords_ && isFineAt(sample.point.face);
	isFlat_ = true;
	flood_ += step_;
	met_.clear();
	reached_.clear();
	again_.clear();
	anchors_.assign(1, {centre_, sample.normal, 0});
	for (int k = 0; k < 3; ++k) {
		const int v = m_.origin[3 * sample.point.face + k];
		reach(v, wayFrom(sample, v), useChords_ ? 0 : noAnchor);
	}
	// Repeated visits come first, so that few vertices take over the longer way.
	std::size_t again = 0;
	for (std::size_t i = 0; i < reached_.size() || again < again_.size();) {
		if (poller_) poller_->count();
		passOn(again < again_.size() ? again_[again++] : int(i++));
	}
	for (const Reached& r : reached_)
		meet(r.vertex);
}

/// Whether the edges of a face are short against the disk.
bool DiskFlood::isFineAt(int face) const
{
	float longest = 0;
	for (int h = 3 * face; h < 3 * face + 3; ++h)
		longest = std::max(longest, lengthOf(m_.position[m_.origin[h]], m_.position[m_.target(h)]));
	return longest < fineEdge * radius_;
}

void DiskFlood::commit(int id)
{
	for (const Reached& r : reached_) {
		NearestField::Nearest& n = field_.nearest[r.vertex];
		if (r.distance < n.distance) n = {r.distance, id};
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

/// The length from the sample straight to a corner of its face.
float DiskFlood::wayFrom(const Sample& sample, int corner) const
{
	const float straight = lengthOf(sample.point.position, m_.position[corner]);
	if (stretch_ == nullptr) return straight;
	float sum = 3 * stretchAt(corner);
	for (int k = 0; k < 3; ++k)
		sum += stretchAt(m_.origin[3 * sample.point.face + k]);
	return straight * (sum / 6);
}

/// Passes the distance of a reached vertex on to its neighbours: straight from the vertex's anchor
/// where the anchor sees the neighbour, else along the edges and over the triangles at the vertex.
void DiskFlood::passOn(int place)
{
	reached_[place].isWaiting = false;
	const Reached from        = reached_[place];
	const float   nearest     = field_.nearest[from.vertex].distance;
	if (!(from.distance < nearest) || from.distance > radius_) return;
	// A copy, because new anchors may move the anchors in memory. Without an anchor the normal is
	// zero, and nothing is seen.
	const Anchor anchor = from.anchor == noAnchor ? Anchor() : anchors_[from.anchor];
	if (from.anchor != noAnchor && goStraight(from, anchor)) return;
	isFlat_ = false;
	goOverBends(from, anchor);
}

/// Whether the anchor sees all neighbours.
bool DiskFlood::goStraight(const Reached& from, const Anchor& anchor)
{
	bool seesAll = true;
	forEachNeighbour(m_, from.vertex, [&](int w) {
		// Each anchor gives a way once. On flat ground there is no other anchor.
		const bool isOld = isReached(w);
		if (isOld && (isFlat_ || reachedAt(w).anchor == from.anchor)) return;
		const float cosine = dot(normal_[w].unpack(), anchor.normal);
		if (!(cosine >= flatCosine)) {
			seesAll = false;
			return;
		}
		const float chord    = lengthOf(anchor.place, m_.position[w]);
		const float distance = anchor.distance + bentLength(chord, cosine);
		if (isOld)
			reachAgain(w, distance, from.anchor);
		else
			reachFirst(w, distance, from.anchor);
	});
	return seesAll;
}

void DiskFlood::goOverBends(const Reached& from, const Anchor& anchor)
{
	ring_.clear();
	forEachNeighbour(m_, from.vertex, [&](int w) {
		const float length = lengthOf(m_.position[from.vertex], m_.position[w]);
		ring_.push_back({w, length, !(dot(normal_[w].unpack(), anchor.normal) >= flatCosine)});
	});
	for (const Spoke& s : ring_) {
		if (s.isHidden) goAlong(from, s);
	}
	const bool isClosed = !m_.isBorderVertex(from.vertex);
	for (std::size_t i = 0; i + !isClosed < ring_.size(); ++i)
		goBetween(from, ring_[i], ring_[i + 1 < ring_.size() ? i + 1 : 0]);
}

void DiskFlood::goAlong(const Reached& from, const Spoke& to)
{
	const float stretch = 0.5f * (stretchAt(from.vertex) + stretchAt(to.vertex));
	const Vec3f normal  = normal_[from.vertex].unpack();
	goOn(to.vertex, from.distance + to.length * stretch,
		 {m_.position[from.vertex], normal, from.distance});
}

/// Goes over the triangle of a vertex and two consecutive neighbours.
void DiskFlood::goBetween(const Reached& from, const Spoke& a, const Spoke& b)
{
	const bool toB = b.isHidden && isReached(a.vertex), toA = a.isHidden && isReached(b.vertex);
	if (!toA && !toB) return;
	const Vec3f at     = m_.position[from.vertex];
	const Vec3f toward = m_.position[a.vertex] - at, onward = m_.position[b.vertex] - at;
	const float between = length(onward - toward) * scale_;
	const Vec3f normal  = isFine_ ? normalized(cross(toward, onward)) : Vec3f();
	if (toB) goOver(from, a, b, between, normal);
	if (toA) goOver(from, b, a, between, normal);
}

/// Goes over the edge between two reached vertices. All edges of the triangle take the mean stretch
/// of the triangle: stretched by the means of their own ends, three edges need not make a triangle.
void DiskFlood::goOver(const Reached& from, const Spoke& known, const Spoke& to, float between,
					   const Vec3f& normal)
{
	const float s =
		(stretchAt(from.vertex) + stretchAt(known.vertex) + stretchAt(to.vertex)) * (1 / 3.0f);
	const UnfoldedWay way = unfold(from.distance, reachedAt(known.vertex).distance,
								   s * known.length, s * to.length, s * between);
	if (!(way.distance < HUGE_VALF)) return;
	const Vec3f a = m_.position[from.vertex], b = m_.position[known.vertex];
	// No way on the surface is shorter than the chord, as every stretch is at least 1.
	goOn(to.vertex, std::max(way.distance, lengthOf(centre_, m_.position[to.vertex])),
		 {a + (b - a) * way.share, normal, way.toCrossing});
}

/// Reaches a vertex over a place where the way may bend: the next anchor. Among edges that are long
/// against the disk, bends far from the best place would lengthen the ways, so unfolding goes on.
void DiskFlood::goOn(int v, float distance, const Anchor& next)
{
	const int anchor = isFine_ ? int(anchors_.size()) : noAnchor;
	if (reach(v, distance, anchor) && isFine_) anchors_.push_back(next);
}

/// False if the vertex has a way as short already.
bool DiskFlood::reach(int v, float distance, int anchor)
{
	return isReached(v) ? reachAgain(v, distance, anchor) : reachFirst(v, distance, anchor);
}

bool DiskFlood::reachFirst(int v, float distance, int anchor)
{
	field_.mark[v] = {flood_, int(reached_.size())};
	reached_.push_back({v, distance, anchor, true});
	return true;
}

bool DiskFlood::reachAgain(int v, float distance, int anchor)
{
	const int   place = field_.mark[v].place;
	Reached&    r     = reached_[place];
	const float least = r.isWaiting ? r.distance : r.distance * (1 - worthAnotherVisit);
	if (!(distance < least)) return false;
	if (!r.isWaiting) {
		if (again_.size() >= mostVisitsAgain * reached_.size()) return false;
		again_.push_back(place);
	}
	r = {v, distance, anchor, true};
	return true;
}

} // namespace gpr
