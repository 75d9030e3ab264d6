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

/// Assigns vertices of the working surface to faces of the result while the faces change: a map
/// from closest faces, and the later transfers from face to face.
class Assignment {
public:
	/// mapFace: per face, its number in the map, -1: none; further faces have none.
	Assignment(const Surface& surface, const ClosestFaceMap& map, std::vector<int> mapFace);

	/// Hands the vertices of the removed face `from`, once at `triangle`, to the nearest face of
	/// `faces`.
	void transfer(int from, const std::array<Vec3f, 3>& triangle, const HalfEdgeMesh& mesh,
				  const std::vector<int>& faces);

	/// Calls visit(place) for the vertices assigned to a face, until visit returns false. Of a
	/// large number of vertices, an evenly taken part of about a hundred is visited.
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
	static constexpr int maxOfFace = 64; ///< most vertices of a map face to visit, about

	const Surface&                  surface_;
	const ClosestFaceMap&           map_;
	std::vector<int>                mapFace_;
	std::map<int, std::vector<int>> further_; ///< per face: faces of the map besides its own

	int mapFaceOf(int f) const { return f < int(mapFace_.size()) ? mapFace_[f] : -1; }

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

/// Positions of faces at a moment.
using Triangles = std::vector<std::array<Vec3f, 3>>;
Triangles trianglesOf(const HalfEdgeMesh& mesh, const std::vector<int>& faces);

/// The distances of the vertices assigned to a patch from the triangles of the patch.
class PatchDistance {
public:
	/// Measures the distances of the vertices assigned to `faces` from `triangles`, which need not
	/// be the triangles of `faces`. enough: a distance that counts as zero; guarded: see isKeptBy,
	/// HUGE_VALF: none. Cost: the product of both, usually far less, since the last
	/// nearest triangle is tried first.
	PatchDistance(const Assignment& assignment, std::vector<int> faces, const Triangles& triangles,
				  float enough, float guarded);

	/// Whether other triangles may replace the measured triangles. No vertex may lie farther away
	/// than `enough`, or than the farthest vertex before. The sum of fourth powers of the distances
	/// beyond `guarded` may not grow: a tip must not be cut off because of a farther tip beside it.
	/// Cost: as for the constructor, up to the first vertex that decides.
	bool isKeptBy(const Triangles& triangles) const;

	/// The number of triangles looked at in the measurement; a comparison looks at about as many.
	std::int64_t work() const { return work_; }

private:
	const Assignment& assignment_;
	std::vector<int>  faces_;
	float             squaredEnough_, squaredGuarded_;
	float             farthest_; ///< squared; at least squaredEnough_
	double            fourthPowers_ = 0;
	std::int64_t      work_         = 0;

	float surelyNear() const;
	/// The share of a vertex in the sum of fourth powers; all vertices that are not guarded count
	/// alike.
	double guardedPower(float squared) const;
};

} // namespace gpr

#endif
