// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_boxes.h"

#include "mesh_edit.h"
#include "space_grid.h"
#include "spatial_order.h"

#include <vcg_extras/core/base/counting_sort.h>

#include <algorithm>
#include <cstdint>

namespace gpr {

namespace {

/// Places of faces that are not in the tree.
constexpr int nowhere = -1, inList = -2;
/// After so few changes the tree is not made anew, however small the mesh.
constexpr std::size_t fewChanges = 256;

/// Depth of the blocks: at most about twice as many blocks as faces; a surface fills few of the
/// blocks.
int depthFor(std::int64_t faceNum)
{
	int depth = 1;
	while (depth < 7 && std::int64_t(8) << 3 * depth <= 2 * (faceNum + 1))
		++depth;
	return depth;
}

/// Marks living faces that may meet a wanted face.
Buffer<char> findCounting(const HalfEdgeMesh& m, const MortonGrid& grid,
						  const std::vector<char>& wanted, Workers& workers)
{
	MarkedCells cells(grid.low, grid.cubeSize);
	for (int f = 0; f < int(wanted.size()); ++f) {
		if (wanted[f]) cells.mark(boxOfFace(m, f));
	}
	Buffer<char> counts(m.faceNum);
	workers.forEach(m.faceNum, [&](int f) {
		counts[f] = !isDeadFace(m, f) && (wanted.empty() || cells.mayMeet(boxOfFace(m, f)));
	});
	return counts;
}

} // namespace

Box<float> boxOfFace(const HalfEdgeMesh& m, int f)
{
	const auto [a, b, c] = m.corners(f);
	Box<float> box       = {a, a};
	box.add(b);
	box.add(c);
	return box;
}

Box<float> boxOfAll(const HalfEdgeMesh& m, Workers& workers)
{
	return workers.sumEach<Box<float>>(m.vertexNum, [&](int v, Box<float>& part) {
		if (m.outgoing[v] >= 0) part.add(m.position[v]);
	});
}

Box<float> boxOfFaces(const HalfEdgeMesh& m, const std::vector<int>& faces)
{
	Box<float> all;
	for (int f : faces) {
		if (!isDeadFace(m, f)) all += boxOfFace(m, f);
	}
	return all;
}

FaceBoxes::FaceBoxes(const HalfEdgeMesh& m, const std::vector<char>& wanted, Workers& workers)
{
	const MortonGrid   grid   = gridAround(boxOfAll(m, workers));
	const Buffer<char> counts = findCounting(m, grid, wanted, workers);
	const auto         num    = std::count(counts.begin(), counts.end(), 1);
	const int          depth  = depthFor(num);
	Buffer<int>        start, cell(std::size_t(m.vertexNum));
	workers.forEach(cell.size(), [&](int v) { cell[v] = int(grid.cell(m.position[v], depth)); });
	const auto blockOf = [&](std::size_t f) { return counts[f] ? cell[m.origin[3 * f]] : -1; };
	sortIntoBuckets(m.faceNum, std::size_t(1) << 3 * depth, blockOf, workers, start, face_);
	level_.emplace_back(face_.size());
	workers.forEach(face_.size(), [&](int i) { level_[0][i] = boxOfFace(m, face_[i]); });
	constexpr std::size_t minLevels = 3; // FacePairs needs this many for groups of faces
	while (level_.size() < minLevels || level_.back().size() > 1)
		addLevel(workers);
}

void FaceBoxes::addLevel(Workers& workers)
{
	const Buffer<Box<float>>& below = level_.back();
	Buffer<Box<float>>        here((below.size() + fanOut - 1) / fanOut);
	workers.forEach(here.size(), [&](int i) {
		Box<float>        box;
		const std::size_t last = std::min(below.size(), std::size_t(i + 1) * fanOut);
		for (std::size_t k = i * fanOut; k < last; ++k)
			box += below[k];
		here[i] = box;
	});
	level_.push_back(std::move(here));
}

void FaceBoxes::grow(int i, const Box<float>& box)
{
	for (Buffer<Box<float>>& level : level_) {
		level[i] += box;
		i /= fanOut;
	}
}

// ---- while the mesh changes

FacesInSpace::FacesInSpace(const HalfEdgeMesh& mesh, Workers& workers) :
		m_(mesh), workers_(workers), boxes_(mesh, workers)
{
	findPlaces();
}

void FacesInSpace::findPlaces()
{
	placeOf_.assign(std::size_t(m_.faceNum), nowhere);
	for (int i = 0; i < boxes_.faceNum(); ++i)
		placeOf_[boxes_.face(i)] = i;
	added_.clear();
	changedNum_ = 0;
}

std::vector<int> FacesInSpace::near(const Box<float>& box) const
{
	std::vector<int> faces;
	forEachNear(box, [&](int f) {
		faces.push_back(f);
		return true;
	});
	return faces;
}

void FacesInSpace::follow(const std::vector<int>& changed)
{
	for (int f : changed) {
		if (f >= int(placeOf_.size())) placeOf_.resize(std::size_t(f) + 1, nowhere);
		if (placeOf_[f] >= 0) boxes_.grow(placeOf_[f], boxOfFace(m_, f));
		if (placeOf_[f] != nowhere) continue;
		placeOf_[f] = inList;
		added_.push_back(f);
	}
	changedNum_ += changed.size();
	if (changedNum_ <= std::max(fewChanges, std::size_t(boxes_.faceNum()))) return;
	boxes_ = FaceBoxes(m_, workers_);
	findPlaces();
}

} // namespace gpr
