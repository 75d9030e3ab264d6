// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_guard.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>

namespace gpr {

ContactGuard::ContactGuard(const HalfEdgeMesh& mesh, bool hadContacts, Workers& workers) :
		m_(mesh), hadContacts_(hadContacts), workers_(workers),
		goneIn_(std::size_t(mesh.faceNum), 0)
{
	build();
}

void ContactGuard::build()
{
	boxes_ = std::make_unique<FaceBoxes>(m_, workers_);
	placeOf_.assign(std::size_t(m_.faceNum), -1);
	for (int i = 0; i < boxes_->faceNum(); ++i)
		placeOf_[std::size_t(boxes_->face(i))] = i;
}

void ContactGuard::follow(const std::vector<int>& changed)
{
	for (int f : changed)
		boxes_->grow(placeOf_[std::size_t(f)], boxOfFace(m_, f));
}

bool ContactGuard::allows(const std::vector<NamedTriangle>& made, const std::vector<int>& gone)
{
	++call_;
	for (int f : gone)
		goneIn_[std::size_t(f)] = call_;
	boxOfMade_.clear();
	Box<float> all;
	for (const NamedTriangle& t : made) {
		boxOfMade_.push_back(Box<float>::ofPoints(t.at));
		all += boxOfMade_.back();
	}
	if (comesToMirrorImage(made, gone)) return false;
	return boxes_->forEachMeeting(all, [&](int place) {
		const int f = boxes_->face(place);
		return isDeadFace(m_, f) || goneIn_[std::size_t(f)] == call_ || isApartFrom(f, made, gone);
	}) && areApart(made, gone);
}

/// Whether a new triangle reaches the mirror image, unless a face to replace already did.
bool ContactGuard::comesToMirrorImage(const std::vector<NamedTriangle>& made,
									  const std::vector<int>&           gone) const
{
	const auto comes   = [&](const NamedTriangle& t) { return reachesMirrorImage(m_, t); };
	const auto reached = [&](int f) { return reachesMirrorImage(m_, f); };
	return std::any_of(made.begin(), made.end(), comes) &&
		   !(hadContacts_ && std::any_of(gone.begin(), gone.end(), reached));
}

bool ContactGuard::isApartFrom(int face, const std::vector<NamedTriangle>& made,
							   const std::vector<int>& gone) const
{
	const Box<float> box = boxOfFace(m_, face);
	for (std::size_t i = 0; i < made.size(); ++i) {
		if (!boxOfMade_[i].meets(box)) continue;
		if (!doTouch(made[i], triangleOf(m_, face))) continue;
		return hadContacts_ && touchedBefore(face, gone);
	}
	return true;
}

bool ContactGuard::areApart(const std::vector<NamedTriangle>& made,
							const std::vector<int>&           gone) const
{
	for (std::size_t i = 0; i < made.size(); ++i) {
		for (std::size_t k = i + 1; k < made.size(); ++k) {
			if (doTouch(made[i], made[k])) return hadContacts_ && touchedEachOther(gone);
		}
	}
	return true;
}

bool ContactGuard::touchedBefore(int face, const std::vector<int>& gone) const
{
	const NamedTriangle t = triangleOf(m_, face);
	return std::any_of(gone.begin(), gone.end(),
					   [&](int f) { return doTouch(triangleOf(m_, f), t); });
}

bool ContactGuard::touchedEachOther(const std::vector<int>& gone) const
{
	for (std::size_t i = 0; i < gone.size(); ++i) {
		for (std::size_t k = i + 1; k < gone.size(); ++k) {
			if (doTouch(triangleOf(m_, gone[i]), triangleOf(m_, gone[k]))) return true;
		}
	}
	return false;
}

} // namespace gpr
