// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "even_points.h"

#include <cmath>

namespace gpr {

namespace {

/// The running area behind each face of a mesh.
std::vector<double> runningArea(const MeshView& mesh)
{
	std::vector<double> behind(mesh.faceNum);
	double              area = 0;
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		if (isUsableFace(mesh, f)) area += 0.5 * length(mesh.faceCross(f));
		behind[f] = area;
	}
	return behind;
}

} // namespace

bool isUsableFace(const MeshView& mesh, std::size_t face)
{
	const auto t = mesh.triangle(face);
	for (const std::int32_t v : t)
		if (v < 0 || std::size_t(v) >= mesh.vertexNum) return false;
	if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
	return isFinite(mesh.position(t[0])) && isFinite(mesh.position(t[1])) &&
		   isFinite(mesh.position(t[2]));
}

EvenPoints::EvenPoints(const MeshView& mesh, std::int64_t wantedNum) :
		mesh_(mesh), area_(runningArea(mesh))
{
	if (area_.empty() || !(area_.back() > 0)) return;
	num_     = std::size_t(wantedNum);
	spacing_ = area_.back() / double(wantedNum);
}

/// Point number j of the R2 sequence (Roberts 2018: the additive recurrence by the plastic number)
/// in the triangle; the upper half of the unit square is folded onto the lower.
Vec3d EvenPoints::pointInFace(std::size_t face, std::size_t j) const
{
	constexpr double stepU = 0.7548776662466927, stepV = 0.5698402909980532;
	const auto       t = mesh_.triangle(face);
	double           u = stepU * double(j), v = stepV * double(j);
	u -= std::floor(u);
	v -= std::floor(v);
	if (u + v > 1) {
		u = 1 - u;
		v = 1 - v;
	}
	const Vec3d a = mesh_.position(t[0]);
	return a + (mesh_.position(t[1]) - a) * u + (mesh_.position(t[2]) - a) * v;
}

} // namespace gpr
