// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gpr::test {

namespace {
constexpr double pi = 3.14159265358979323846;
}

NearestPair nearestPair(const std::vector<Vec3d>& points)
{
	NearestPair best;
	for (int i = 0; i < int(points.size()); ++i) {
		for (int k = i + 1; k < int(points.size()); ++k) {
			const double d = length(points[k] - points[i]);
			if (d < best.distance) best = {i, k, d};
		}
	}
	return best;
}

int pairsNearerThan(const std::vector<Vec3d>& points, double distance)
{
	int n = 0;
	for (std::size_t i = 0; i < points.size(); ++i) {
		for (std::size_t k = i + 1; k < points.size(); ++k)
			n += length(points[k] - points[i]) < distance;
	}
	return n;
}

double distanceToNearest(const std::vector<Vec3d>& points, const Vec3d& p)
{
	double best = HUGE_VAL;
	for (const Vec3d& q : points)
		best = std::min(best, squaredLength(q - p));
	return std::sqrt(best);
}

double distanceToSegment(const Vec3d& p, const Vec3d& a, const Vec3d& b)
{
	const double squared = squaredLength(b - a);
	const double t       = squared > 0 ? std::clamp(dot(p - a, b - a) / squared, 0.0, 1.0) : 0.0;
	return length(p - a - (b - a) * t);
}

double distanceToTriangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
	const Vec3d doubled = cross(b - a, c - a);
	// Without area there is no inside, and rounding alone would make the normal.
	const double sides   = squaredLength(b - a) + squaredLength(c - a);
	const bool   hasArea = squaredLength(doubled) > 1e-18 * sides * sides;
	const Vec3d  n       = normalized(doubled);
	const bool   inside  = dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
						dot(cross(a - c, p - c), n) >= 0 && hasArea;
	if (inside) return std::abs(dot(p - a, n));
	return std::min(
		{distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

double distanceToMesh(const TriangleMesh& mesh, const Vec3d& p)
{
	double best = HUGE_VAL;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const std::int32_t* t = &mesh.triangles[3 * f];
		best = std::min(best, distanceToTriangle(p, mesh.positions[t[0]], mesh.positions[t[1]],
												 mesh.positions[t[2]]));
	}
	return best;
}

std::vector<Vec3d> rimSegments(const TriangleMesh& mesh)
{
	std::map<std::pair<int, int>, int> uses;
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		const int a = mesh.triangles[i], b = mesh.triangles[i % 3 == 2 ? i - 2 : i + 1];
		++uses[{std::min(a, b), std::max(a, b)}];
	}
	std::vector<Vec3d> ends;
	for (const auto& use : uses) {
		if (use.second != 1) continue;
		ends.push_back(mesh.positions[use.first.first]);
		ends.push_back(mesh.positions[use.first.second]);
	}
	return ends;
}

double segmentDistance(const std::vector<Vec3d>& from, const std::vector<Vec3d>& to)
{
	constexpr int pointsPerEdge = 4;
	double        worst         = 0;
	for (std::size_t i = 0; i < from.size(); i += 2) {
		for (int k = 0; k < pointsPerEdge; ++k) {
			const Vec3d p    = from[i] + (from[i + 1] - from[i]) * (double(k) / pointsPerEdge);
			double      best = HUGE_VAL;
			for (std::size_t j = 0; j < to.size(); j += 2)
				best = std::min(best, distanceToSegment(p, to[j], to[j + 1]));
			worst = std::max(worst, best);
		}
	}
	return worst;
}

double rimDistance(const TriangleMesh& from, const TriangleMesh& to)
{
	return segmentDistance(rimSegments(from), rimSegments(to));
}

std::vector<Vec3d> sharpSegments(const TriangleMesh& mesh, double angleDeg)
{
	std::map<std::pair<int, int>, std::vector<Vec3d>> normals;
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		const std::int32_t* t = &mesh.triangles[i - i % 3];
		const Vec3d         a = mesh.positions[t[0]];
		const Vec3d         n = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
		const int           p = t[i % 3], q = t[(i + 1) % 3];
		normals[{std::min(p, q), std::max(p, q)}].push_back(n);
	}
	std::vector<Vec3d> ends;
	for (const auto& edge : normals) {
		const std::vector<Vec3d>& n = edge.second;
		if (n.size() != 2) continue;
		const double angle = std::atan2(length(cross(n[0], n[1])), dot(n[0], n[1]));
		if (angle <= angleDeg * pi / 180) continue;
		ends.push_back(mesh.positions[edge.first.first]);
		ends.push_back(mesh.positions[edge.first.second]);
	}
	return ends;
}

std::vector<Vec3d> withoutShortPieces(const std::vector<Vec3d>& segments, double minLength)
{
	// Pieces are named by their smallest segment and renamed until nothing changes.
	const std::size_t                            n = segments.size() / 2;
	std::vector<std::size_t>                     piece(n);
	std::map<std::array<double, 3>, std::size_t> at;
	for (std::size_t i = 0; i < n; ++i)
		piece[i] = i;
	for (bool changed = true; changed;) {
		changed = false;
		for (std::size_t i = 0; i < 2 * n; ++i) {
			const Vec3d& p = segments[i];
			std::size_t& name =
				at.emplace(std::array<double, 3>{p.x, p.y, p.z}, piece[i / 2]).first->second;
			if (name == piece[i / 2]) continue;
			name = piece[i / 2] = std::min(name, piece[i / 2]);
			changed             = true;
		}
	}
	std::map<std::size_t, double> lengthOf;
	for (std::size_t i = 0; i < n; ++i)
		lengthOf[piece[i]] += length(segments[2 * i + 1] - segments[2 * i]);
	std::vector<Vec3d> kept;
	for (std::size_t i = 0; i < n; ++i) {
		if (lengthOf[piece[i]] < minLength) continue;
		kept.push_back(segments[2 * i]);
		kept.push_back(segments[2 * i + 1]);
	}
	return kept;
}

double onSphere(const Vec3d& a, const Vec3d& b)
{
	return length(a) * std::atan2(length(cross(a, b)), dot(a, b));
}

double onCylinder(const Vec3d& a, const Vec3d& b, double radius)
{
	double turn = std::abs(std::atan2(a.y, a.x) - std::atan2(b.y, b.x));
	turn        = std::min(turn, 2 * pi - turn);
	return std::hypot(turn * radius, b.z - a.z);
}

} // namespace gpr::test
