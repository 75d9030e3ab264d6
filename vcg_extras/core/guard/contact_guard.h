// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_CONTACT_GUARD_H
#define VCG_EXTRAS_CORE_GUARD_CONTACT_GUARD_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/mesh/face_contact.h>

#include <memory>
#include <vector>

namespace gpr {

/// Says before a mesh is changed whether faces would touch that did not. A mesh whose every change
/// it allowed has no pair of touching faces but those that it had at first. Exact: see
/// mesh/face_contact.h. Holds a tree of boxes of the mesh's faces, which grows with them, and is
/// built anew when half of the faces have gone. 45 B a face.
class ContactGuard {
public:
	/// hadContacts: some faces of the mesh touch already. The mesh must stay where it is.
	ContactGuard(const HalfEdgeMesh& mesh, bool hadContacts, Workers& workers);

	/// Whether the triangles `made` may take the places of the living faces `gone`: they touch no
	/// other face, nor each other, or only what one of `gone` touched. Cost: O(log F) and some
	/// hundred nanoseconds a face nearby.
	bool allows(const std::vector<NamedTriangle>& made, const std::vector<int>& gone);

	/// To be called after each change with the faces that lie elsewhere now.
	void follow(const std::vector<int>& changed);

private:
	const HalfEdgeMesh&        m_;
	bool                       hadContacts_;
	Workers&                   workers_;
	std::unique_ptr<FaceBoxes> boxes_;
	std::vector<int>           placeOf_; ///< per face: in the tree, or -1
	std::vector<unsigned>      goneIn_;  ///< per face: the call in which it was to go
	unsigned                   call_ = 0;
	std::vector<Box<float>>    boxOfMade_;

	void build();
	bool comesToMirrorImage(const std::vector<NamedTriangle>& made,
							const std::vector<int>&           gone) const;
	bool doTouch(const NamedTriangle& s, const NamedTriangle& t) const
	{
		return touch(s, t, m_.meetsAtPlaces);
	}
	bool areApart(const std::vector<NamedTriangle>& made, const std::vector<int>& gone) const;
	bool isApartFrom(int face, const std::vector<NamedTriangle>& made,
					 const std::vector<int>& gone) const;
	bool touchedBefore(int face, const std::vector<int>& gone) const;
	bool touchedEachOther(const std::vector<int>& gone) const;
};

} // namespace gpr

#endif
