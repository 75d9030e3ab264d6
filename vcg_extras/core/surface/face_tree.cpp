// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_tree.h"

#include "surface_point.h"

#include <vcg_extras/core/base/triangle.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gpr {

namespace {

/// Faces that are looked at one by one: as many boxes above them would cost as much.
constexpr int leafSize = 4;

Vec3f lower(const Vec3f& a, const Vec3f& b)
{
	return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3f upper(const Vec3f& a, const Vec3f& b)
{
	return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

} // namespace

FaceTree::FaceTree(const HalfEdgeMesh& mesh, Workers* workers) :
		m_(mesh), workers_(workers), face_(mesh.faceNum)
{
	std::iota(face_.begin(), face_.end(), 0);
	build(0, mesh.faceNum);
}

int FaceTree::build(int begin, int end)
{
	if (workers_ != nullptr) workers_->poll();
	Node node;
	node.begin = begin;
	node.end   = end;
	node.low   = Vec3f(HUGE_VALF, HUGE_VALF, HUGE_VALF);
	node.high  = Vec3f(-HUGE_VALF, -HUGE_VALF, -HUGE_VALF);
	for (int i = begin; i < end; ++i) {
		for (int k = 0; k < 3; ++k) {
			const Vec3f p = m_.position[m_.origin[3 * face_[i] + k]];
			node.low      = lower(node.low, p);
			node.high     = upper(node.high, p);
		}
	}
	const int index = int(node_.size());
	node_.push_back(node);
	if (end - begin <= leafSize) {
		// The library may leave a leaf in any order; of faces equally near the first is taken.
		std::sort(face_.begin() + begin, face_.begin() + end);
		return index;
	}

	const Vec3f size   = node.high - node.low;
	const auto  centre = [&](int f) {
        const Vec3f sum = m_.position[m_.origin[3 * f]] + m_.position[m_.origin[3 * f + 1]] +
                          m_.position[m_.origin[3 * f + 2]];
        if (size.x >= size.y && size.x >= size.z) return sum.x;
        return size.y >= size.z ? sum.y : sum.z;
	};
	const int   middle        = begin + (end - begin) / 2;
	std::size_t comparisonNum = 0;
	std::nth_element(face_.begin() + begin, face_.begin() + middle, face_.begin() + end,
					 [&](int f, int g) {
						 if ((++comparisonNum & 0xffff) == 0 && workers_ != nullptr)
							 workers_->poll();
						 const float x = centre(f), y = centre(g);
						 return x != y ? x < y : f < g;
					 });
	const int left     = build(begin, middle);
	const int right    = build(middle, end);
	node_[index].left  = left;
	node_[index].right = right;
	return index;
}

float FaceTree::squaredDistance(const Node& n, const Vec3f& p) const
{
	const Vec3f inside = lower(upper(p, n.low), n.high);
	return squaredLength(p - inside);
}

SurfacePoint FaceTree::nearest(const Vec3f& p) const
{
	SurfacePoint     best;
	float            bestSquared = HUGE_VALF;
	std::vector<int> stack{0};
	while (!stack.empty()) {
		const Node& n = node_[stack.back()];
		stack.pop_back();
		if (squaredDistance(n, p) >= bestSquared) continue;
		if (n.left >= 0) {
			const bool leftFirst =
				squaredDistance(node_[n.left], p) <= squaredDistance(node_[n.right], p);
			stack.push_back(leftFirst ? n.right : n.left);
			stack.push_back(leftFirst ? n.left : n.right);
			continue;
		}
		for (int i = n.begin; i < n.end; ++i) {
			const int   f = face_[i];
			const Vec3f q = nearestOnTriangle(p, m_.position[m_.origin[3 * f]],
											  m_.position[m_.origin[3 * f + 1]],
											  m_.position[m_.origin[3 * f + 2]]);
			const float d = squaredLength(p - q);
			if (d < bestSquared) {
				bestSquared = d;
				best        = {q, f};
			}
		}
	}
	return best;
}

} // namespace gpr
