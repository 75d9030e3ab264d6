// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "precision.h"

#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gpr::app {

namespace {

double meanEdgeLength(const MeshView& mesh)
{
	double      sum = 0;
	std::size_t num = 0;
	for (std::size_t i = 0; i < 3 * mesh.faceNum; ++i) {
		const std::size_t  next = i % 3 == 2 ? i - 2 : i + 1;
		const std::int32_t a = mesh.vertexOf(i), b = mesh.vertexOf(next);
		const double len = length(mesh.position(std::size_t(b)) - mesh.position(std::size_t(a)));
		if (!std::isfinite(len)) continue;
		sum += len;
		++num;
	}
	return num > 0 ? sum / double(num) : 0;
}

/// Per vertex: whether a vertex at another place has the same floats.
std::vector<bool> unitedByFloat(const std::vector<Vec3d>& positions)
{
	const auto               floats = [&](std::size_t v) { return Vec3f(positions[v]); };
	std::vector<std::size_t> order(positions.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::sort(order.begin(), order.end(),
			  [&](std::size_t a, std::size_t b) { return isBefore(floats(a), floats(b)); });
	std::vector<bool> united(positions.size());
	for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
		bool apart = false;
		for (end = i + 1; end < order.size() && floats(order[end]) == floats(order[i]); ++end)
			apart = apart || !(positions[order[end]] == positions[order[i]]);
		for (std::size_t k = i; apart && k < end; ++k)
			united[order[k]] = true;
	}
	return united;
}

Vec3d normalOf(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
	return cross(b - a, c - a);
}

/// Whether a face with an area loses the area or turns by more than 60 degrees.
bool losesItsSide(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
	constexpr double leastCosine = 0.5;
	const auto       rounded     = [](const Vec3d& p) { return Vec3d(Vec3f(p)); };
	const Vec3d  before = normalOf(a, b, c), after = normalOf(rounded(a), rounded(b), rounded(c));
	const double both = length(before) * length(after);
	return length(before) > 0 && !(both > 0 && dot(before, after) >= leastCosine * both);
}

} // namespace

double largestCoordinate(const MeshView& mesh)
{
	double largest = 0;
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		const Vec3d p = mesh.position(v);
		for (const double c : {p.x, p.y, p.z}) {
			if (std::isfinite(c)) largest = std::max(largest, std::abs(c));
		}
	}
	return largest;
}

bool floatResolves(double largest, double edgeLen)
{
	constexpr double floatEpsilon = 1.0 / (1 << 23); // distance of neighbouring floats around 1
	constexpr double largestFloat = 3e38;
	return largest < largestFloat && largest * floatEpsilon <= edgeLen / 1000;
}

void roundToFloat(InputMesh& mesh)
{
	mesh.floats.assign(mesh.doubles.begin(), mesh.doubles.end());
	CoordinateArray<double>().swap(mesh.doubles);
	mesh.doublePrecision = false;
}

std::size_t facesSpoiledByFloat(const TriangleMesh& mesh)
{
	const std::vector<bool> united = unitedByFloat(mesh.positions);
	std::size_t             num    = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		std::size_t v[3];
		for (std::size_t k = 0; k < 3; ++k)
			v[k] = std::size_t(mesh.triangles[3 * f + k]);
		const std::vector<Vec3d>& p = mesh.positions;
		num +=
			united[v[0]] || united[v[1]] || united[v[2]] || losesItsSide(p[v[0]], p[v[1]], p[v[2]]);
	}
	return num;
}

void settlePrecision(InputMesh& mesh)
{
	const MeshView view = mesh.view();
	if (floatResolves(largestCoordinate(view), meanEdgeLength(view))) roundToFloat(mesh);
}

} // namespace gpr::app
