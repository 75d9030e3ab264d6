// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_RETRIANGULATION_H
#define VCG_EXTRAS_RETRIANGULATION_H

#include <vcg_extras/complex/algorithms/attribute_transfer.h>
#include <vcg_extras/complex/algorithms/geodesic_poisson_base.h>
#include <vcg_extras/complex/algorithms/mesh_conversion.h>

#include <cstdint>
#include <vector>

namespace vcg {
namespace tri {

/** \brief A mesh of the same topology with given samples of the surface as vertices.

After "Fast Edge-based geodesic Poisson Disk Remeshing", section 3, last paragraph. Differs from the
paper: the input vertices are removed by collapses into the nearest sample along the surface, which
keeps the topology by construction, instead of one by one with a local parametrization
(gpr::Preset::Paper has the paper's way, too); Delaunay flips follow. The samples may come from
anywhere: this sampling, another sampling, points picked by hand.

Works on any tri::TriMesh with coordinates in float or double.
*/
template <class MeshType>
class Retriangulation {
public:
	typedef typename MeshType::ScalarType ScalarType;
	typedef typename MeshType::CoordType  CoordType;

	typedef GeodesicPoissonResult Result;

	/// The removal of the vertices (preset), check and all other choices: see
	/// GeodesicPoissonParams. The size has no meaning here.
	struct Params : public GeodesicPoissonParams {
		typedef gpr::RemeshReport Stat;
		using GeodesicPoissonParams::GeodesicPoissonParams;
	};
	typedef typename Params::Stat Stat;

	/** \brief Retriangulates a surface from samples.

	Source: paper section 3, last paragraph.

	Needs: per-vertex and per-face flags; deleted elements are left out, parts that are not
	2-manifold are repaired or cut and counted in stat->cleaned.

	\param in      the surface; not modified
	\param samples positions in mesh units, on the surface or near; a sample off the surface first
	moves to the nearest point, see stat->samplesMoved and stat->largestSampleMove
	\param out     receives the mesh in place of its former content; may be in. Attributes and
	derived data as with GeodesicPoissonRemeshing::Do. If the topology needs more vertices than
	samples, vertices of the input stay: stat->leftoverVertexNum
	\param params  the removal of the vertices, see Params
	\param stat    null, or receives the report of the run, on failure too
	\param cb      null, or progress in percent; returning false cancels

	\return Ok; or the reason of the failure, with out unchanged

	\throw MissingComponentException if in has no flags

	Cost: about 0.3 s per million faces and core. */
	static Result Do(const MeshType& in, const std::vector<CoordType>& samples, MeshType& out,
					 const Params& params = Params(), Stat* stat = nullptr,
					 vcg::CallBackPos* cb = nullptr)
	{
		std::vector<gpr::Vec3d> points;
		points.reserve(samples.size());
		for (const CoordType& p : samples)
			points.push_back(gpr::Vec3d(double(p[0]), double(p[1]), double(p[2])));
		return Run(in, points, out, params, stat, cb);
	}

	/** \brief As above, with the vertices of a mesh as samples, without deleted vertices.

	The faces and attributes of `samples` do not count. */
	static Result Do(const MeshType& in, const MeshType& samples, MeshType& out,
					 const Params& params = Params(), Stat* stat = nullptr,
					 vcg::CallBackPos* cb = nullptr)
	{
		std::vector<gpr::Vec3d> points;
		points.reserve(samples.vert.size());
		for (const auto& v : samples.vert)
			if (!v.IsD())
				points.push_back(
					gpr::Vec3d(double(v.cP()[0]), double(v.cP()[1]), double(v.cP()[2])));
		return Run(in, points, out, params, stat, cb);
	}

private:
	static Result Run(const MeshType& in, const std::vector<gpr::Vec3d>& points, MeshType& out,
					  const Params& params, Stat* stat, vcg::CallBackPos* cb)
	{
		return gpr_detail::WriteResultOf(
			in, out, params, stat,
			[&](const gpr::MeshView& view, const gpr::RemeshOptions& options) {
				return gpr::retriangulate(view, points, options, gpr_detail::ProgressOf(cb));
			});
	}
};

} // namespace tri
} // namespace vcg

#endif
