// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_contacts.h"

#include "face_sets.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <iterator>

namespace gpr {

namespace {

/// Some boxes as faces, for a tree: each face has two corners of its box.
HalfEdgeMesh diagonalsOf(const std::vector<Box<float>>& boxes)
{
	HalfEdgeMesh m;
	const int    num = int(boxes.size());
	reserve(m, 2 * num, num);
	m.vertexNum = 2 * num;
	m.faceNum   = num;
	for (int i = 0; i < num; ++i) {
		m.position[2 * i]     = boxes[i].low;
		m.position[2 * i + 1] = boxes[i].high;
		for (int k = 0; k < 3; ++k) {
			m.origin[3 * i + k]   = 2 * i + (k > 0);
			m.opposite[3 * i + k] = -1;
		}
		m.outgoing[2 * i] = m.outgoing[2 * i + 1] = -1;
	}
	return m;
}

} // namespace

InputContacts::InputContacts(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
							 const std::vector<FacePair>& pairs, float distance, Workers& workers) :
		distance_(distance)
{
	// Boxes of faces, since a few faces may have very many pairs.
	std::vector<Box<float>> places;
	for (int f : facesOf(pairs))
		places.push_back(surroundings(result, f));
	const HalfEdgeMesh     diagonals = diagonalsOf(places);
	const FaceBoxes        tree(diagonals, workers);
	const std::vector<int> nearFaces = workers.collectIf(std::size_t(input.faceNum), [&](int f) {
		return !tree.forEachMeeting(boxOfFace(input, f), [](int) { return false; });
	});
	const HalfEdgeMesh     near      = facesAlone(input, nearFaces, verticesOf(input, nearFaces));
	// At cuts of the input, the two sides have different vertices here and touch at once.
	const std::vector<int> touching = findTouchingFaces(near, workers, Seams::Apart);
	if (touching.empty()) return;
	touching_ = std::make_unique<FaceBoxes>(facesAlone(near, touching, verticesOf(near, touching)),
											workers);
}

Box<float> InputContacts::surroundings(const HalfEdgeMesh& result, int f) const
{
	const Box<float> box = boxOfFace(result, f);
	const Vec3f      margin(distance_, distance_, distance_);
	return {box.low - margin, box.high + margin};
}

bool InputContacts::isNear(const HalfEdgeMesh& result, int f) const
{
	return touching_ &&
		   !touching_->forEachMeeting(surroundings(result, f), [](int) { return false; });
}

std::vector<FacePair> InputContacts::withoutInputs(const HalfEdgeMesh&          result,
												   const std::vector<FacePair>& pairs) const
{
	if (!touching_) return pairs;
	std::vector<char> nearInput(std::size_t(result.faceNum), 0);
	for (int f : facesOf(pairs))
		nearInput[f] = isNear(result, f);
	std::vector<FacePair> others;
	std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(others), [&](const FacePair& pair) {
		return !nearInput[pair.first] && !nearInput[pair.second];
	});
	return others;
}

std::vector<FacePair> InputContacts::othersIn(const HalfEdgeMesh&      result,
											  const std::vector<char>& wanted,
											  Workers&                 workers) const
{
	return withoutInputs(result, findTouchingPairs(result, workers, Seams::Joined, wanted));
}

} // namespace gpr
