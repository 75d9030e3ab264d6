// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_contacts.h"

#include "face_sets.h"

#include <algorithm>
#include <iterator>

namespace gpr {

namespace {

/// A tree of some faces.
FaceBoxes boxesOf(const HalfEdgeMesh& m, const std::vector<int>& faces, Workers& workers)
{
	return {facesAlone(m, faces, verticesOf(m, faces)), workers};
}

} // namespace

InputContacts::InputContacts(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
							 const std::vector<FacePair>& pairs, float distance, Workers& workers) :
		distance_(distance),
		touching_(findTouching(input, result, pairs, workers))
{
}

FaceBoxes InputContacts::findTouching(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
									  const std::vector<FacePair>& pairs, Workers& workers) const
{
	// Boxes of faces, since a few faces may have very many pairs.
	const FaceBoxes        places    = boxesOf(result, facesOf(pairs), workers);
	const std::vector<int> nearFaces = workers.collectIf(
		std::size_t(input.faceNum), [&](int f) { return isNearAny(places, input, f); });
	const HalfEdgeMesh near = facesAlone(input, nearFaces, verticesOf(input, nearFaces));
	// At cuts of the input, the two sides have different vertices here and touch at once.
	return boxesOf(near, findTouchingFaces(near, workers, Seams::Apart), workers);
}

/// Whether a face is nearer than the distance to a box.
bool InputContacts::isNearAny(const FaceBoxes& boxes, const HalfEdgeMesh& m, int f) const
{
	const Box<float> box = boxOfFace(m, f);
	const Vec3f      margin(distance_, distance_, distance_);
	return !boxes.forEachMeeting({box.low - margin, box.high + margin}, [](int) { return false; });
}

std::vector<FacePair> InputContacts::withoutInputs(const HalfEdgeMesh&          result,
												   const std::vector<FacePair>& pairs) const
{
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
