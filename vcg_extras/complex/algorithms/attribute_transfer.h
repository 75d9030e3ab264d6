// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_ATTRIBUTE_TRANSFER_H
#define VCG_EXTRAS_ATTRIBUTE_TRANSFER_H

// Internal: carries vertex colour and quality from a mesh to points anchored on its faces, and
// writes a remeshed surface with them.

#include <type_traits>
#include <vcg_extras/complex/algorithms/mesh_conversion.h>
#include <vector>

namespace vcg {
namespace tri {
namespace gpr_detail {

/** \brief Vertex attributes read at anchors: Σ w·(value at the corner).

Read first and written later, so that the mesh read and the mesh written may be the same.
An attribute is carried where both meshes have it, optional (ocf) components only where enabled.
Cost: linear in the anchors; 4 B (colour) and one quality value per anchor.
*/
template <class MeshType>
class AnchoredAttributes {
public:
	typedef typename MeshType::VertexType       VertexType;
	typedef typename VertexType::ColorType      ColorType;
	typedef typename VertexType::QualityType    QualityType;
	typedef typename MeshType::ConstFacePointer ConstFacePointer;

	/// Reads from `flat`, a view of `from`, what `to` has room for.
	AnchoredAttributes(const FlatMesh<MeshType>&             flat,
					   const std::vector<gpr::SurfacePoint>& anchors, const MeshType& from,
					   const MeshType& to)
	{
		if (HasPerVertexColor(from) && HasPerVertexColor(to)) Read(flat, anchors, _color, ColorAt);
		if (HasPerVertexQuality(from) && HasPerVertexQuality(to))
			Read(flat, anchors, _quality, QualityAt);
	}

	/// Writes to the first vertices of m, in the order of the anchors.
	void Write(MeshType& m) const
	{
		for (std::size_t v = 0; v < _color.size(); ++v)
			m.vert[v].C() = _color[v];
		for (std::size_t v = 0; v < _quality.size(); ++v)
			m.vert[v].Q() = _quality[v];
	}

private:
	template <class ValueType>
	static void Read(const FlatMesh<MeshType>& flat, const std::vector<gpr::SurfacePoint>& anchors,
					 std::vector<ValueType>& values,
					 ValueType (*valueAt)(ConstFacePointer, const float (&)[3]))
	{
		values.reserve(anchors.size());
		for (const gpr::SurfacePoint& a : anchors)
			values.push_back(valueAt(flat.Face(a.face), a.weight));
	}

	static ColorType ColorAt(ConstFacePointer f, const float (&weight)[3])
	{
		typedef typename ColorType::ScalarType ChannelType;
		const ColorType c[3] = {f->cV(0)->cC(), f->cV(1)->cC(), f->cV(2)->cC()};
		// Whole-number channels are rounded: cut off, a constant colour would come out one darker.
		const double half = std::is_integral<ChannelType>::value ? 0.5 : 0.0;
		ColorType    mixed;
		for (int k = 0; k < 4; ++k)
			mixed[k] = ChannelType(weight[0] * double(c[0][k]) + weight[1] * double(c[1][k]) +
								   weight[2] * double(c[2][k]) + half);
		return mixed;
	}

	static QualityType QualityAt(ConstFacePointer f, const float (&weight)[3])
	{
		double sum = 0;
		for (int k = 0; k < 3; ++k)
			sum += weight[k] * double(f->cV(k)->cQ());
		return QualityType(sum);
	}

	std::vector<ColorType>   _color;
	std::vector<QualityType> _quality;
};

/** \brief Runs an engine function on `in` and writes its mesh with carried attributes to `out`.

`out` may be `in`: it is written only when everything has been read, and only when the run is Ok. */
template <class MeshType, class EngineFunctionType>
GeodesicPoissonResult WriteResultOf(const MeshType& in, MeshType& out, gpr::RemeshReport* stat,
									EngineFunctionType engine)
{
	try {
		const FlatMesh<MeshType> flat(in);
		const gpr::RemeshResult  run = engine(flat.View());
		if (stat != nullptr) *stat = run.report;
		if (run.status == gpr::Status::Ok) {
			const AnchoredAttributes<MeshType> attributes(flat, run.anchors, in, out);
			WriteMesh(run.mesh, out);
			attributes.Write(out);
			RefreshDerived(out);
		}
		GeodesicPoissonResult result = ResultOf(run);
		result.smallestVertexNum     = run.smallestVertexNum;
		return result;
	}
	catch (const std::bad_alloc&) {
		return OutOfMemoryResult();
	}
}

} // namespace gpr_detail
} // namespace tri
} // namespace vcg

#endif
