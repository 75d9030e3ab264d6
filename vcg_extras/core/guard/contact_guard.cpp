// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_guard.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>

namespace gpr {

ContactGuard::ContactGuard(const HalfEdgeMesh& mesh, bool hadContacts, Workers& workers) :
		m_(mesh), hadContacts_(hadContacts), space_(mesh, workers),
		goneIn_(std::size_t(mesh.faceNum), 0)
{
}

bool ContactGuard::allows(const std::vector<NamedTriangle>& made, const std::vector<int>& gone)
{
	++call_;
	before_.clear();
	for (int f : gone) {
		goneIn_[f] = call_;
		if (hadContacts_) before_.push_back(triangleOf(m_, f));
	}
	boxOfMade_.clear();
	Box<float> all;
	for (const NamedTriangle& t : made) {
		boxOfMade_.push_back(Box<float>::ofPoints(t.at));
		all += boxOfMade_.back();
	}
	if (reachMirrorImage(made) && !reachMirrorImage(before_)) return false;
	return space_.forEachNear(all, [&](int f) {
		return isDeadFace(m_, f) || goneIn_[f] == call_ || isApartFrom(f, made);
	}) && (!touchEachOther(made) || touchEachOther(before_));
}

bool ContactGuard::reachMirrorImage(const std::vector<NamedTriangle>& triangles) const
{
	return std::any_of(triangles.begin(), triangles.end(),
					   [&](const NamedTriangle& t) { return reachesMirrorImage(m_, t); });
}

/// Whether no new triangle touches a face, unless a face to replace already did.
bool ContactGuard::isApartFrom(int face, const std::vector<NamedTriangle>& made) const
{
	const Box<float>    box       = boxOfFace(m_, face);
	const NamedTriangle t         = triangleOf(m_, face);
	const auto          doesTouch = [&](const NamedTriangle& s) { return doTouch(s, t); };
	for (std::size_t i = 0; i < made.size(); ++i) {
		if (boxOfMade_[i].meets(box) && doesTouch(made[i]))
			return std::any_of(before_.begin(), before_.end(), doesTouch);
	}
	return true;
}

bool ContactGuard::touchEachOther(const std::vector<NamedTriangle>& triangles) const
{
	for (std::size_t i = 0; i < triangles.size(); ++i) {
		for (std::size_t k = i + 1; k < triangles.size(); ++k) {
			if (doTouch(triangles[i], triangles[k])) return true;
		}
	}
	return false;
}

} // namespace gpr
