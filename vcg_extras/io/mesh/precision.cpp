// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "precision.h"

#include <algorithm>
#include <cmath>

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

void settlePrecision(InputMesh& mesh)
{
	const MeshView view = mesh.view();
	if (floatResolves(largestCoordinate(view), meanEdgeLength(view))) roundToFloat(mesh);
}

} // namespace gpr::app
