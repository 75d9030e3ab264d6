// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_GEODESIC_POISSON_SAMPLING_H
#define VCG_EXTRAS_GEODESIC_POISSON_SAMPLING_H

#include <vcg_extras/complex/algorithms/attribute_transfer.h>
#include <vcg_extras/complex/algorithms/geodesic_poisson_base.h>
#include <vcg_extras/complex/algorithms/mesh_conversion.h>

#include <cassert>
#include <vector>

namespace vcg {
namespace tri {

/** \brief Geodesic Poisson-disk sampling of a surface: points about as dense as possible with a
distance of at least a radius between any two points, measured along the surface.

After "Fast Edge-based geodesic Poisson Disk Remeshing", section 3, steps 1 to 8. Differs from the
paper: a new sample lies at the meeting of two other disks, not on a random border edge, which packs
closer; rims are sampled first; the mesh is not split, a sample is a point of a face.
gpr::Preset::Paper has the paper's way, too.

Works on any tri::TriMesh with coordinates in float or double; a minimal mesh type needs only
coordinates, flags and vertex references. For example:
\code
std::vector<tri::GeodesicPoissonSampling<MyMesh>::SamplePoint> samples;
tri::GeodesicPoissonSampling<MyMesh>::Params                   params;
params.SetTargetVertexNum(1000);
tri::GeodesicPoissonSampling<MyMesh>::Sample(m, params, samples);
\endcode
*/
template <class MeshType>
class GeodesicPoissonSampling {
public:
	typedef typename MeshType::ScalarType  ScalarType;
	typedef typename MeshType::CoordType   CoordType;
	typedef typename MeshType::FaceType    FaceType;
	typedef typename MeshType::FacePointer FacePointer;

	typedef GeodesicPoissonResult Result;

	/// The number of points (as a number, a percentage of the vertices or a mean distance), denser
	/// regions, and all other choices: see GeodesicPoissonParams.
	struct Params : public GeodesicPoissonParams {
		typedef gpr::RemeshReport Stat;
		using GeodesicPoissonParams::GeodesicPoissonParams;
	};
	typedef typename Params::Stat Stat;

	/// A point of the surface.
	struct SamplePoint {
		CoordType   position;       ///< mesh units
		FacePointer face = nullptr; ///< the point's face of the sampled mesh
		CoordType   barycentric;    ///< weights of the face's corners; position is their mean
	};

	/** \brief Samples a surface, as points with their faces.

	Source: paper section 3, steps 1 to 8; the radius by equation (1).

	Needs: per-vertex and per-face flags; deleted elements are left out, parts that are not
	2-manifold are cut for the sampling only and counted in stat->cleaned.

	\param m       the surface, any number of components, open or closed; not modified
	\param params  the number of points, see Params; the result has this number within some percent
	\param samples receives the points in place of its former content, in a reproducible order
	\param stat    null, or receives the report of the run; diskRadius is the radius r
	\param cb      null, or progress in percent; returning false cancels

	\return Ok; or the reason of the failure, with samples unchanged

	\throw MissingComponentException if m has no flags

	Cost: about 0.1 s per million faces and core; threads never change the result. */
	static Result Sample(MeshType& m, const Params& params, std::vector<SamplePoint>& samples,
						 Stat* stat = nullptr, vcg::CallBackPos* cb = nullptr)
	{
		gpr_detail::RequireReadableTriangles(m);
		try {
			gpr_detail::FlatMesh<MeshType> flat(m);
			const gpr::SamplingResult      run = Run(flat, params, stat, cb);
			if (run.status == gpr::Status::Ok) samples = PointsOf(m, flat, run);
			return gpr_detail::ResultOf(run);
		}
		catch (const std::bad_alloc&) {
			return gpr_detail::OutOfMemoryResult();
		}
	}

	/** \brief Samples a surface, as the vertices of a mesh without faces.

	As above. As far as points has these components: quality becomes the disk radius, the normal is
	the normal of the point's face, and colour, radius and texture coordinates are carried over from
	m.

	\param points  receives a vertex per sample in place of its former content; not m itself

	\return Ok; or the reason of the failure, with points unchanged */
	static Result Sample(const MeshType& m, const Params& params, MeshType& points,
						 Stat* stat = nullptr, vcg::CallBackPos* cb = nullptr)
	{
		assert(&m != &points);
		gpr_detail::RequireReadableTriangles(m);
		try {
			gpr_detail::FlatMesh<MeshType> flat(m);
			const gpr::SamplingResult      run = Run(flat, params, stat, cb);
			if (run.status == gpr::Status::Ok) WritePoints(m, flat, run, points);
			return gpr_detail::ResultOf(run);
		}
		catch (const std::bad_alloc&) {
			return gpr_detail::OutOfMemoryResult();
		}
	}

private:
	static gpr::SamplingResult Run(gpr_detail::FlatMesh<MeshType>& flat, const Params& params,
								   Stat* stat, vcg::CallBackPos* cb)
	{
		flat.ReadUsedBy(params);
		gpr::SamplingResult run =
			gpr::samplePoissonDisks(flat.View(), params, gpr_detail::ProgressOf(cb));
		run.report.diskRadius = run.diskRadius;
		if (stat != nullptr) *stat = run.report;
		return run;
	}

	static std::vector<SamplePoint> PointsOf(MeshType&                             m,
											 const gpr_detail::FlatMesh<MeshType>& flat,
											 const gpr::SamplingResult&            run)
	{
		std::vector<SamplePoint> samples(run.points.size());
		for (std::size_t i = 0; i < samples.size(); ++i) {
			const gpr::BarycentricPoint& point = run.surfacePoints[i];
			samples[i].position                = gpr_detail::ToCoord<CoordType>(run.points[i]);
			samples[i].face                    = &m.face[Index(m, flat.Face(point.face))];
			samples[i].barycentric =
				CoordType(ScalarType(point.weight[0]), ScalarType(point.weight[1]),
						  ScalarType(point.weight[2]));
		}
		return samples;
	}

	static void WritePoints(const MeshType& m, const gpr_detail::FlatMesh<MeshType>& flat,
							const gpr::SamplingResult& run, MeshType& points)
	{
		gpr_detail::AttributesAtPoints<MeshType> attributes;
		attributes.ReadVertices(m, points, run.surfacePoints,
								[&](std::int32_t f) { return flat.Face(f); });
		gpr_detail::ReplaceElements(points, run.points.size(), 0);
		for (std::size_t i = 0; i < run.points.size(); ++i)
			points.vert[i].P() = gpr_detail::ToCoord<CoordType>(run.points[i]);
		attributes.Write(points);
		if (HasPerVertexQuality(points))
			for (std::size_t i = 0; i < run.points.size(); ++i)
				points.vert[i].Q() = typename MeshType::VertexType::QualityType(run.radii[i]);
		if (HasPerVertexNormal(points))
			for (std::size_t i = 0; i < run.points.size(); ++i)
				points.vert[i].N().Import(
					vcg::TriangleNormal(*flat.Face(run.surfacePoints[i].face)).Normalize());
		UpdateBounding<MeshType>::Box(points);
	}
};

} // namespace tri
} // namespace vcg

#endif
