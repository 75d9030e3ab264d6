// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_INPUT_CONTACTS_H
#define VCG_EXTRAS_CORE_GUARD_INPUT_CONTACTS_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Contacts of the input near contacts of a result: such contacts of the result come from the
/// input.
class InputContacts {
public:
	/// Tests the input's faces nearer than `distance` to the box of a face in contact. Cost: a pass
	/// over the input's faces, and the test of the near faces.
	InputContacts(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
				  const std::vector<FacePair>& pairs, float distance, Workers& workers);

	/// Faces of the input found in contact.
	std::int64_t faceNum() const { return touching_.faceNum(); }

	/// Whether a face of the result is near a contact of the input.
	bool isNear(const HalfEdgeMesh& result, int f) const { return isNearAny(touching_, result, f); }
	/// The pairs of the result that are not near contacts of the input.
	std::vector<FacePair> withoutInputs(const HalfEdgeMesh&          result,
										const std::vector<FacePair>& pairs) const;
	/// All such contacts of a result with a wanted face. Cost: of findTouchingPairs.
	std::vector<FacePair> othersIn(const HalfEdgeMesh& result, const std::vector<char>& wanted,
								   Workers& workers) const;

private:
	float     distance_;
	FaceBoxes touching_; ///< faces of the input with contacts

	FaceBoxes findTouching(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
						   const std::vector<FacePair>& pairs, Workers& workers) const;
	bool      isNearAny(const FaceBoxes& boxes, const HalfEdgeMesh& mesh, int f) const;
};

} // namespace gpr

#endif
