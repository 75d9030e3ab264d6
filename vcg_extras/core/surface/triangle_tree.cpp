// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_tree.h"

#include <vcg_extras/core/mesh/edge_sides.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Triangles of a leaf at most: more boxes would cost as much as a look at each triangle.
constexpr int leafSize = 4;
/// More than the depth of a tree of 2^31 triangles.
constexpr int maxDepth = 32;

double squaredDistanceToSegment(const Vec3d& p, const Vec3d& a, const Vec3d& b)
{
	return squaredLength(p - a - (b - a) * shareOnSegment(p, a, b));
}

Box<float> roundedOut(const Box<double>& box)
{
	const auto toward = [](const Vec3d& p, float end) {
		return Vec3f(std::nextafter(float(p.x), end), std::nextafter(float(p.y), end),
					 std::nextafter(float(p.z), end));
	};
	return {toward(box.low, -HUGE_VALF), toward(box.high, HUGE_VALF)};
}

/// A face during the ordering.
struct Placed {
	float        centre[3]; ///< times three
	std::int32_t face;
};

Placed placed(const MeshView& mesh, int face, const Vec3d& origin)
{
	const auto  t   = mesh.triangle(std::size_t(face));
	const Vec3d sum = (mesh.position(std::size_t(t[0])) - origin) +
					  (mesh.position(std::size_t(t[1])) - origin) +
					  (mesh.position(std::size_t(t[2])) - origin);
	return {{float(sum.x), float(sum.y), float(sum.z)}, face};
}

/// The axis with the largest extent of the centres.
int longestAxis(const Placed* begin, const Placed* end)
{
	Box<float> box;
	for (const Placed* p = begin; p < end; ++p)
		box.add({p->centre[0], p->centre[1], p->centre[2]});
	const Vec3f size = box.high - box.low;
	if (size.x >= size.y && size.x >= size.z) return 0;
	return size.y >= size.z ? 1 : 2;
}

void splitAt(Placed* begin, Placed* middle, Placed* end)
{
	const int k = longestAxis(begin, end);
	std::nth_element(begin, middle, end, [k](const Placed& a, const Placed& b) {
		return a.centre[k] != b.centre[k] ? a.centre[k] < b.centre[k] : a.face < b.face;
	});
}

/// Per edge, three a triangle, the triangle beyond; -1 unless exactly two triangles share the edge.
Buffer<int> neighboursOf(const MeshView& mesh, const std::vector<int>& face, Workers& workers)
{
	const auto sideOf = [&](std::size_t edge) {
		const EdgeSide side = edgeSide(mesh, 3 * std::size_t(face[edge / 3]) + edge % 3);
		return EdgeSide{side.low, side.high, int(edge)};
	};
	const Buffer<EdgeSide> sides = sortedByBuckets<EdgeSide>(
		3 * face.size(), mesh.vertexNum, sideOf, [](const EdgeSide& s) { return s.low; }, workers);
	Buffer<int> neighbour(sides.size());
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		const bool arePair = end - begin == 2;
		for (std::size_t i = begin; i < end; ++i) {
			const EdgeSide& other        = sides[begin + end - 1 - i];
			neighbour[sides[i].halfEdge] = arePair ? other.halfEdge / 3 : -1;
		}
	});
	return neighbour;
}

} // namespace

bool hasPlaces(const MeshView& mesh, std::size_t face)
{
	for (const std::int32_t v : mesh.triangle(face)) {
		if (v < 0 || std::size_t(v) >= mesh.vertexNum) return false;
		if (!isFinite(mesh.position(std::size_t(v)))) return false;
	}
	return true;
}

bool isUsableFace(const MeshView& mesh, std::size_t face)
{
	const auto t = mesh.triangle(face);
	return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && hasPlaces(mesh, face);
}

double squaredDistance(const Vec3d& p, const Triangle& t)
{
	// Sine of the smallest angle below which the normal is lost in rounding.
	constexpr double needle = 1e-8;
	const Vec3d      ab = t[1] - t[0], bc = t[2] - t[1], ca = t[0] - t[2], n = cross(bc, ca);
	const double     longest = std::max({squaredLength(ab), squaredLength(bc), squaredLength(ca)});
	const double     nn      = squaredLength(n);
	double           outside[3] = {-1, -1, -1};
	if (nn > needle * needle * longest * longest) {
		const Vec3d  ap     = p - t[0];
		const double height = dot(ap, n) / nn;
		const Vec3d  q      = ap - n * height; // the foot of p, seen from the first corner
		outside[0]          = dot(cross(ab, q), n);
		outside[1]          = dot(cross(bc, q - ab), n);
		outside[2]          = dot(cross(ca, q + ca), n);
		if (outside[0] > 0 && outside[1] > 0 && outside[2] > 0) return height * height * nn;
	}
	// The nearest point lies on an edge with the foot beyond the edge.
	double best = HUGE_VAL;
	for (std::size_t k = 0; k < 3; ++k)
		if (!(outside[k] > 0))
			best = std::min(best, squaredDistanceToSegment(p, t[k], t[(k + 1) % 3]));
	return best;
}

TriangleTree::TriangleTree(const MeshView& mesh, const Vec3d& origin, Workers& workers)
{
	face_ = workers.collectIf(mesh.faceNum, [&](int f) { return isUsableFace(mesh, f); });
	if (face_.empty()) return;
	while ((face_.size() >> depth_) > leafSize)
		++depth_;
	triangle_.reset(face_.size());
	order(mesh, origin, workers);
	neighbour_ = neighboursOf(mesh, face_, workers);
	workers.forEach(face_.size(), [&](int i) {
		for (std::size_t k = 0; k < 3; ++k)
			triangle_[i][k] =
				mesh.position(std::size_t(mesh.vertexOf(3 * std::size_t(face_[i]) + k))) - origin;
	});
	fillBoxes(workers);
}

void TriangleTree::order(const MeshView& mesh, const Vec3d& origin, Workers& workers)
{
	Buffer<Placed> all(face_.size());
	workers.forEach(face_.size(), [&](int i) { all[i] = placed(mesh, face_[i], origin); });
	for (int level = 0; level < depth_; ++level) {
		workers.forTasks(std::size_t(1) << level, [&](std::size_t i, int) {
			splitAt(all.data() + groupBegin(level, int(i)),
					all.data() + groupBegin(level + 1, int(2 * i + 1)),
					all.data() + groupBegin(level, int(i) + 1));
		});
	}
	// The library may leave a leaf in any order.
	workers.forEach(std::size_t(1) << depth_, [&](int leaf) {
		const int begin = groupBegin(depth_, leaf), end = groupBegin(depth_, leaf + 1);
		std::sort(all.data() + begin, all.data() + end,
				  [](const Placed& a, const Placed& b) { return a.face < b.face; });
		for (int i = begin; i < end; ++i)
			face_[i] = all[i].face;
	});
}

void TriangleTree::fillBoxes(Workers& workers)
{
	const std::size_t leafNum = std::size_t(1) << depth_;
	node_.reset(2 * leafNum - 1);
	workers.forEach(leafNum, [&](int leaf) {
		Box<double> box;
		for (int i = groupBegin(depth_, leaf); i < groupBegin(depth_, leaf + 1); ++i)
			for (const Vec3d& p : triangle_[i])
				box.add(p);
		node_[leafNum - 1 + std::size_t(leaf)] = roundedOut(box);
	});
	for (int level = depth_ - 1; level >= 0; --level) {
		const std::size_t first = (std::size_t(1) << level) - 1;
		workers.forEach(first + 1, [&](int i) {
			const std::size_t node = first + std::size_t(i);
			Box<float>        box  = node_[2 * node + 1];
			box += node_[2 * node + 2];
			node_[node] = box;
		});
	}
	for (const Triangle& t : triangle_)
		for (const Vec3d& p : t)
			box_.add(p);
}

void TriangleTree::search(const Vec3d& p, Ties ties, Nearest& best) const
{
	struct Waiting {
		std::size_t node;
		double      squared;
	};
	const auto mayHoldBetter = [&](double squared) {
		return squared < best.squared || (ties == Ties::LowestFace && squared == best.squared);
	};
	const auto isBetter = [&](const Nearest& a) {
		return a.squared < best.squared || (mayHoldBetter(a.squared) && best.triangle >= 0 &&
											face_[a.triangle] < face_[best.triangle]);
	};
	const std::size_t firstLeaf = (std::size_t(1) << depth_) - 1;
	Waiting           stack[maxDepth];
	int               num = 0;
	stack[num++]          = {0, node_[0].squaredDistance(p)};
	while (num > 0) {
		const Waiting next = stack[--num];
		if (!mayHoldBetter(next.squared)) continue;
		std::size_t node = next.node;
		while (node < firstLeaf) {
			Waiting near = {2 * node + 1, node_[2 * node + 1].squaredDistance(p)};
			Waiting far  = {2 * node + 2, node_[2 * node + 2].squaredDistance(p)};
			if (far.squared < near.squared) std::swap(near, far);
			if (mayHoldBetter(far.squared)) stack[num++] = far;
			if (!mayHoldBetter(near.squared)) break;
			node = near.node;
		}
		if (node < firstLeaf) continue;
		const int leaf = int(node - firstLeaf);
		for (int i = groupBegin(depth_, leaf); i < groupBegin(depth_, leaf + 1); ++i) {
			const Nearest own = {i, squaredDistance(p, triangle_[i])};
			if (isBetter(own)) best = own;
		}
	}
}

TriangleTree::Nearest TriangleTree::nearest(const Vec3d& p, int hint) const
{
	Nearest best;
	if (hint >= 0) best = {hint, squaredDistance(p, triangle_[hint])};
	search(p, Ties::FirstFound, best);
	return best;
}

int TriangleTree::nearestFace(const Vec3d& p) const
{
	Nearest best;
	if (size() > 0) search(p, Ties::LowestFace, best);
	return best.triangle < 0 ? -1 : face_[best.triangle];
}

} // namespace gpr
