// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_list.h"

#include "exit_code.h"

#include <algorithm>
#include <limits>
#include <string>

namespace gpr::app {

namespace {

std::int32_t narrowed(std::int64_t index)
{
	return index >= 0 && index <= std::numeric_limits<std::int32_t>::max() ? std::int32_t(index)
																		   : -1;
}

/// Throws when an index is negative or not below vertexNum. One branch-free pass: the maximum over
/// the indices seen as unsigned numbers, so that -1 counts as huge.
void checkRange(const std::int32_t* indices, std::size_t indexNum, std::size_t vertexNum)
{
	std::uint32_t largest = 0;
	for (std::size_t i = 0; i < indexNum; ++i) {
		largest = std::max(largest, std::uint32_t(indices[i]));
	}
	if (indexNum == 0 || largest < vertexNum) return;
	throw AppError(ExitCode::BadInput, "a face names a vertex that does not exist (the file has " +
										   std::to_string(vertexNum) + " vertices)");
}

/// Twice the area vector of a polygon (Newell), robust for corners that are not in one plane.
Vec3d areaVector(const std::vector<Vec3d>& corners)
{
	Vec3d sum;
	for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
		sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
	}
	return sum;
}

/// True when every triangle of the fan around this corner faces the same way as the polygon.
bool fanFits(const std::vector<Vec3d>& corners, std::size_t apex, const Vec3d& normal)
{
	const std::size_t n = corners.size();
	for (std::size_t i = 1; i + 1 < n; ++i) {
		const Vec3d a = corners[(apex + i) % n] - corners[apex];
		const Vec3d b = corners[(apex + i + 1) % n] - corners[apex];
		if (!(dot(cross(a, b), normal) > 0)) return false;
	}
	return true;
}

/// The corner around which a fan covers the polygon without folding; the first one where there is
/// none such.
std::size_t fanApex(const std::vector<Vec3d>& corners)
{
	// The search is quadratic; a polygon of thousands of corners is given up on.
	constexpr std::size_t searchLimit = 1000;
	if (corners.size() > searchLimit) return 0;
	const Vec3d normal = areaVector(corners);
	for (std::size_t apex = 0; apex < corners.size(); ++apex) {
		if (fanFits(corners, apex, normal)) return apex;
	}
	return 0;
}

} // namespace

void FaceList::add(const std::int64_t* corners, std::size_t cornerNum)
{
	if (cornerNum < 3) {
		++tooSmallNum_;
		return;
	}
	if (cornerNum == 3) {
		for (int k = 0; k < 3; ++k)
			triangles.push_back(narrowed(corners[k]));
		return;
	}
	for (std::size_t k = 0; k < cornerNum; ++k)
		polygonCorners_.push_back(narrowed(corners[k]));
	polygonEnds_.push_back(polygonCorners_.size());
}

void FaceList::cutPolygons(const InputMesh& mesh)
{
	const MeshView     view = mesh.view();
	std::vector<Vec3d> corners;
	std::size_t        begin = 0;
	for (const std::size_t end : polygonEnds_) {
		corners.clear();
		for (std::size_t k = begin; k < end; ++k) {
			corners.push_back(view.position(std::size_t(polygonCorners_[k])));
		}
		const std::size_t n    = end - begin;
		const std::size_t apex = fanApex(corners);
		for (std::size_t i = 1; i + 1 < n; ++i) {
			triangles.push_back(polygonCorners_[begin + apex]);
			triangles.push_back(polygonCorners_[begin + (apex + i) % n]);
			triangles.push_back(polygonCorners_[begin + (apex + i + 1) % n]);
		}
		begin = end;
	}
}

void FaceList::finish(InputMesh& mesh)
{
	checkRange(triangles.data(), triangles.size(), mesh.vertexNum());
	checkRange(polygonCorners_.data(), polygonCorners_.size(), mesh.vertexNum());
	cutPolygons(mesh);
	if (tooSmallNum_ > 0) {
		mesh.notes.push_back(std::to_string(tooSmallNum_) +
							 " faces with fewer than three corners were left out.");
	}
	mesh.triangles = std::move(triangles);
}

} // namespace gpr::app
