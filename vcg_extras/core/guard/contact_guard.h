// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_CONTACT_GUARD_H
#define VCG_EXTRAS_CORE_GUARD_CONTACT_GUARD_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/mesh/face_contact.h>

#include <vector>

namespace gpr {

/// Predicts whether a change of a mesh would make new contacts. A mesh without contacts gets none
/// if every change is allowed here. Exact: see mesh/face_contact.h. Holds a tree of the mesh's
/// faces. 50 B per face.
class ContactGuard {
public:
	/// hadContacts: the mesh has contacts. The mesh must stay in memory and get no more faces.
	ContactGuard(const HalfEdgeMesh& mesh, bool hadContacts, Workers& workers);

	/// Whether the triangles `made` may replace the living faces `gone`: the triangles touch
	/// another face, the mirror image or each other only if `gone` did. Cost: O(log F) and some
	/// hundred nanoseconds per nearby face.
	bool allows(const std::vector<NamedTriangle>& made, const std::vector<int>& gone);

	/// Needed after each change. changed: the living faces that moved.
	void follow(const std::vector<int>& changed) { space_.follow(changed); }

private:
	const HalfEdgeMesh&        m_;
	bool                       hadContacts_;
	FacesInSpace               space_;
	std::vector<unsigned>      goneIn_; ///< per face: the last call with the face in `gone`
	unsigned                   call_ = 0;
	std::vector<Box<float>>    boxOfMade_;
	std::vector<NamedTriangle> before_; ///< the triangles of `gone` if the mesh had contacts

	bool doTouch(const NamedTriangle& s, const NamedTriangle& t) const
	{
		return touch(s, t, m_.meetsAtPlaces);
	}
	bool reachMirrorImage(const std::vector<NamedTriangle>& triangles) const;
	bool touchEachOther(const std::vector<NamedTriangle>& triangles) const;
	bool isApartFrom(int face, const std::vector<NamedTriangle>& made) const;
};

} // namespace gpr

#endif
