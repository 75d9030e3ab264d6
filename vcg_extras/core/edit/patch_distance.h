// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_PATCH_DISTANCE_H
#define VCG_EXTRAS_CORE_EDIT_PATCH_DISTANCE_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace gpr {

/// Which vertices of the input belong to which face of the result, while the faces change: by a map
/// of the faces as they were, and what was handed from face to face since.
class Assignment {
public:
	/// mapFace: per face, the face of the map that it was, -1 where there was none; empty: its own
	/// number.
	Assignment(const Surface& surface, const ClosestFaceMap& map, int mapFaceNum,
			   std::vector<int> mapFace = {});

	/// What belongs to a face that is no more belongs to the nearest one of these from here on.
	void transfer(int from, const std::array<Vec3f, 3>& triangle, const HalfEdgeMesh& mesh,
				  const std::vector<int>& faces);

	/// Calls visit(place) for the vertices that belong to a face, until it returns false. Of many
	/// vertices some hundred, evenly taken, stand for all.
	template <class Visit>
	bool forEach(int f, const Visit& visit) const
	{
		const int own = mapFaceOf(f);
		if (own >= 0 && !forEachOfMap(own, visit)) return false;
		const auto found = further_.find(f);
		if (found == further_.end()) return true;
		for (int other : found->second) {
			if (!forEachOfMap(other, visit)) return false;
		}
		return true;
	}

private:
	static constexpr int maxOfFace = 64; ///< vertices that are looked at

	const Surface&                  surface_;
	const ClosestFaceMap&           map_;
	int                             mapFaceNum_;
	std::vector<int>                mapFace_;
	std::map<int, std::vector<int>> further_; ///< per face: faces of the map besides its own

	int mapFaceOf(int f) const
	{
		if (!mapFace_.empty()) return f < int(mapFace_.size()) ? mapFace_[f] : -1;
		return f < mapFaceNum_ ? f : -1;
	}

	template <class Visit>
	bool forEachOfMap(int f, const Visit& visit) const
	{
		const int*           first = map_.begin(f);
		const std::ptrdiff_t num   = map_.end(f) - first;
		for (std::ptrdiff_t k = 0; k < num; k += 1 + num / maxOfFace) {
			if (!visit(surface_.mesh.position[first[k]])) return false;
		}
		return true;
	}
};

/// Faces as they are at one moment.
using Triangles = std::vector<std::array<Vec3f, 3>>;
Triangles trianglesOf(const HalfEdgeMesh& mesh, const std::vector<int>& faces);

/// How far the vertices of the input that belong to a patch lie from its triangles.
class PatchDistance {
public:
	struct Settings {
		float enough;              ///< smaller distances are as good as none
		float guarded = HUGE_VALF; ///< see isKeptBy
	};

	/// Of the vertices that belong to `faces` from the nearest of the triangles, which may be
	/// others than these. Cost: the product of both, mostly far less, since the triangle that was
	/// nearest last time is tried first.
	PatchDistance(const Assignment& assignment, std::vector<int> faces, const Triangles& triangles,
				  const Settings& settings);

	/// Whether other triangles may take the place of these. No vertex may come to lie farther away
	/// than `enough`, or than the farthest before. Of the vertices beyond `guarded` the sum of the
	/// fourth powers may not grow: a tip must not be cut off because one beside it is. Cost:
	/// as above, up to the first vertex that tells.
	bool isKeptBy(const Triangles& triangles) const;

	/// Distances from single triangles that measuring took; a comparison takes about as many.
	std::int64_t work() const { return work_; }

private:
	const Assignment& assignment_;
	std::vector<int>  faces_;
	float             squaredEnough_, squaredGuarded_;
	float             farthest_; ///< squared, or what is near enough
	double            fourthPowers_ = 0;
	std::int64_t      work_         = 0;

	float surelyNear() const;
	/// What a vertex adds to the sum of fourth powers; all that are not guarded count alike.
	double guardedPower(float squared) const;
};

} // namespace gpr

#endif
