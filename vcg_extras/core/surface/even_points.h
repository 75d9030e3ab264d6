// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_EVEN_POINTS_H
#define VCG_EXTRAS_CORE_SURFACE_EVEN_POINTS_H

#include <vcg_extras/core/mesh_view.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpr {

/// Whether a face has three different corners that exist and are finite.
bool isUsableFace(const MeshView& mesh, std::size_t face);

/// Points spread evenly over the area of a surface, for measurements (Cignoni, Rocchini, Scopigno
/// 1998: Metro). The points depend on the mesh only.
class EvenPoints {
public:
	/// Faces that are not usable get no points. The mesh must stay in memory. Cost: linear.
	EvenPoints(const MeshView& mesh, std::int64_t wantedNum);

	/// The wanted number, or 0 for a surface without area.
	std::size_t num() const { return num_; }

	/// Calls visit(point) for points begin to end, in order along the faces.
	template <class Visit>
	void forEach(std::size_t begin, std::size_t end, const Visit& visit) const
	{
		// Systematic sampling: point j lies at the share (j + 1/2) / num of the running area.
		auto face =
			std::upper_bound(area_.begin(), area_.end() - 1, (double(begin) + 0.5) * spacing_);
		for (std::size_t j = begin; j < end; ++j) {
			while (*face <= (double(j) + 0.5) * spacing_ && face != area_.end() - 1)
				++face;
			visit(pointInFace(std::size_t(face - area_.begin()), j));
		}
	}

private:
	MeshView            mesh_;
	std::vector<double> area_; ///< running sum behind each face
	std::size_t         num_     = 0;
	double              spacing_ = 0; ///< area from one point to the next

	Vec3d pointInFace(std::size_t face, std::size_t j) const;
};

} // namespace gpr

#endif
