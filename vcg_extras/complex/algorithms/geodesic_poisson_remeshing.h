// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_GEODESIC_POISSON_REMESHING_H
#define VCG_EXTRAS_GEODESIC_POISSON_REMESHING_H

#include <vcg_extras/complex/algorithms/attribute_transfer.h>
#include <vcg_extras/complex/algorithms/geodesic_poisson_base.h>
#include <vcg_extras/complex/algorithms/mesh_conversion.h>

namespace vcg {
namespace tri {

/** \brief Remeshes a surface with about-equilateral triangles of equal size and a given number of
vertices, keeping its topology.

After "Fast Edge-based geodesic Poisson Disk Remeshing", section 3: geodesic Poisson-disk samples
become the vertices, the input vertices are removed, flips and relaxation follow. Differs from the
paper: see GeodesicPoissonSampling and Retriangulation; splits and collapses of the result meet the
vertex count exactly; relaxation moves vertices along the input surface.

Works on any tri::TriMesh with coordinates in float or double; a minimal mesh type needs only
coordinates, flags and vertex references. For example:
\code
tri::GeodesicPoissonRemeshing<MyMesh>::Params params;
params.SetTargetVertexNum(5000);
if (!tri::GeodesicPoissonRemeshing<MyMesh>::Do(m, params).IsOk())
	...                                       // m is as it was
\endcode
*/
template <class MeshType>
class GeodesicPoissonRemeshing {
public:
	typedef typename MeshType::ScalarType ScalarType;
	typedef typename MeshType::CoordType  CoordType;

	typedef GeodesicPoissonResult Result;

	/// The number of vertices and all other choices: see GeodesicPoissonParams.
	struct Params : public GeodesicPoissonParams {
		typedef gpr::RemeshReport Stat;
		using GeodesicPoissonParams::GeodesicPoissonParams;
	};
	typedef typename Params::Stat Stat;

	/** \brief Remeshes a surface into another mesh.

	Source: paper section 3; the radius by equation (1).

	Needs: per-vertex and per-face flags; deleted elements are left out, parts that are not
	2-manifold are repaired or cut and counted in stat->cleaned.

	\param in      the surface, any number of components, open or closed; not modified
	\param out     receives the mesh in place of its former content; may be in.
	Attributes that both meshes have are carried over: colour, quality, radius and texture
	coordinates of vertices, colour and quality of faces, texture coordinates of wedges. Edges of
	the result follow the seams of wedge textures if possible. Named attributes of numbers, points,
	colours and strings are carried over too, and added to out if missing; a note names attributes
	of other types. Normals, bounding box, face-face and vertex-face adjacency are computed anew if
	out has such data; all other components of out get fresh values, edges are dropped. Optional
	(ocf) components count if enabled.
	\param params  the wanted size and how to reach this size, see Params
	\param stat    null, or receives the report of the run, on failure too
	\param cb      null, or progress in percent; returning false cancels

	\return Ok; or the reason of the failure, with out unchanged. CountTooSmall names the smallest
	count

	\throw MissingComponentException if in has no flags

	Cost: linear in the faces of in; threads never change the result. Time and memory:
	docs/measurements_speed.md. */
	static Result Do(const MeshType& in, MeshType& out, const Params& params = Params(),
					 Stat* stat = nullptr, vcg::CallBackPos* cb = nullptr)
	{
		return gpr_detail::WriteResultOf(
			in, out, params, stat,
			[&](const gpr::MeshView& view, const gpr::RemeshOptions& options) {
				return gpr::remesh(view, options, gpr_detail::ProgressOf(cb));
			});
	}

	/** \brief Remeshes a surface in place: Do(m, m, ...). Unless Ok is returned, m is unchanged. */
	static Result Do(MeshType& m, const Params& params = Params(), Stat* stat = nullptr,
					 vcg::CallBackPos* cb = nullptr)
	{
		return Do(m, m, params, stat, cb);
	}
};

} // namespace tri
} // namespace vcg

#endif
