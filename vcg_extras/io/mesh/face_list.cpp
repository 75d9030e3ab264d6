// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_list.h"

#include "polygon.h"

#include <vcg_extras/io/base/exit_code.h>

#include <algorithm>
#include <limits>

namespace gpr::app {

namespace {

std::int32_t narrowed(std::int64_t index)
{
	return index >= 0 && index <= std::numeric_limits<std::int32_t>::max() ? std::int32_t(index)
																		   : -1;
}

/// Throws for a negative index, or an index not below vertexNum. A pass without branches: the
/// maximum over the indices as unsigned numbers, so that -1 counts as huge.
void checkRange(const std::int32_t* indices, std::size_t indexNum, std::size_t vertexNum)
{
	std::uint32_t largest = 0;
	for (std::size_t i = 0; i < indexNum; ++i) {
		largest = std::max(largest, std::uint32_t(indices[i]));
	}
	if (indexNum == 0 || largest < vertexNum) return;
	failNoSuchVertex(vertexNum);
}

} // namespace

void failNoSuchVertex(std::uint64_t vertexNum)
{
	failInput("a face names a vertex that does not exist (the file has " +
			  std::to_string(vertexNum) + " vertices)");
}

std::string tooSmallFacesNote(std::uint64_t faceNum)
{
	return std::to_string(faceNum) + " faces with fewer than three corners were left out.";
}

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

void FaceList::addStrip(const std::vector<std::int64_t>& strip)
{
	std::size_t begin = 0;
	for (std::size_t i = 0; i < strip.size(); ++i) {
		if (strip[i] == -1) {
			begin = i + 1;
			continue;
		}
		if (i < begin + 2) continue;
		const bool         turned  = (i - begin) % 2 == 1;
		const std::int64_t third[] = {turned ? strip[i - 1] : strip[i - 2],
									  turned ? strip[i - 2] : strip[i - 1], strip[i]};
		if (third[0] == third[1] || third[1] == third[2] || third[2] == third[0]) continue;
		add(third, 3);
	}
}

void FaceList::append(const FaceList& other)
{
	const std::size_t begin = polygonCorners_.size();
	triangles.insert(triangles.end(), other.triangles.begin(), other.triangles.end());
	polygonCorners_.insert(polygonCorners_.end(), other.polygonCorners_.begin(),
						   other.polygonCorners_.end());
	for (const std::size_t end : other.polygonEnds_)
		polygonEnds_.push_back(begin + end);
	tooSmallNum_ += other.tooSmallNum_;
}

void FaceList::cutPolygons(const InputMesh& mesh)
{
	const MeshView           view = mesh.view();
	std::vector<Vec3d>       corners;
	std::vector<std::size_t> cut;
	std::size_t              begin = 0;
	for (const std::size_t end : polygonEnds_) {
		corners.clear();
		for (std::size_t k = begin; k < end; ++k) {
			corners.push_back(view.position(std::size_t(polygonCorners_[k])));
		}
		cutPolygon(corners, cut);
		for (const std::size_t c : cut)
			triangles.push_back(polygonCorners_[begin + c]);
		begin = end;
	}
}

void FaceList::finish(InputMesh& mesh)
{
	checkRange(triangles.data(), triangles.size(), mesh.vertexNum());
	checkRange(polygonCorners_.data(), polygonCorners_.size(), mesh.vertexNum());
	cutPolygons(mesh);
	if (tooSmallNum_ > 0) mesh.notes.push_back(tooSmallFacesNote(tooSmallNum_));
	mesh.triangles = std::move(triangles);
}

} // namespace gpr::app
