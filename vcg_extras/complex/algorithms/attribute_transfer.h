// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_ATTRIBUTE_TRANSFER_H
#define VCG_EXTRAS_ATTRIBUTE_TRANSFER_H

// Internal: carries the attributes of vertices, faces and wedges from a mesh to points anchored on
// its faces, and writes a remeshed surface with them.

#include <vcg_extras/complex/algorithms/mesh_conversion.h>
#include <vcg_extras/complex/algorithms/user_attributes.h>
#include <vcg_extras/core/texture_transfer.h>

#include <memory>
#include <string>
#include <vector>

namespace vcg {
namespace tri {
namespace gpr_detail {

/// The wedge texture of a mesh, for a flat view of the mesh. The view must outlive the result.
template <class MeshType, class FaceOfType>
gpr::TextureSource WedgeTextureOf(const gpr::MeshView& view, const FaceOfType& faceOf)
{
	gpr::CornerTexture texture;
	texture.uv.reserve(6 * view.faceNum);
	texture.image.reserve(view.faceNum);
	for (std::size_t f = 0; f < view.faceNum; ++f) {
		const typename MeshType::ConstFacePointer face = faceOf(std::int32_t(f));
		for (int k = 0; k < 3; ++k) {
			const auto t = face->cWT(k);
			texture.uv.push_back(float(t.U()));
			texture.uv.push_back(float(t.V()));
		}
		texture.image.push_back(face->cWT(0).N());
	}
	return gpr::TextureSource(view, std::move(texture));
}

/** \brief Attributes of a mesh, read at surface points on its faces.

Vertex attributes: colour, quality, radius and texture coordinates, as means over the corners of the
face. Face attributes, if the result has surface points of its faces: colour and quality of the
input face below the middle of the new face; wedge texture coordinates from one side of the seams
(see TextureSource). All attributes are read first and written later: both meshes may be the same.
An attribute is carried over if both meshes have the attribute; optional (ocf) components only if
enabled. Cost: linear in the surface points.
*/
template <class MeshType>
class AttributesAtPoints {
public:
	typedef typename MeshType::VertexType       VertexType;
	typedef typename MeshType::FaceType         FaceType;
	typedef typename MeshType::ConstFacePointer ConstFacePointer;
	typedef typename VertexType::ColorType      ColorType;
	typedef typename VertexType::QualityType    QualityType;
	typedef typename VertexType::RadiusType     RadiusType;
	typedef typename VertexType::TexCoordType   TexCoordType;
	typedef std::vector<gpr::BarycentricPoint>  PointVector;

	/// Reads the vertex attributes that `to` has. faceOf(i): face of `from` with number i in
	/// surface points.
	template <class FaceOfType>
	void ReadVertices(const MeshType& from, const MeshType& to, const PointVector& surfacePoints,
					  const FaceOfType& faceOf)
	{
		if (HasPerVertexColor(from) && HasPerVertexColor(to))
			Read(surfacePoints, faceOf, _color,
				 [](ConstFacePointer f, const gpr::BarycentricPoint& at) {
					 const ColorType c[3] = {f->cV(0)->cC(), f->cV(1)->cC(), f->cV(2)->cC()};
					 return ValueAt<ColorType>(at, [&](int k) -> const ColorType& { return c[k]; });
				 });
		if (HasPerVertexQuality(from) && HasPerVertexQuality(to))
			Read(surfacePoints, faceOf, _quality,
				 [](ConstFacePointer f, const gpr::BarycentricPoint& at) {
					 return gpr::meanAs<QualityType>(
						 gpr::meanOfCorners(at, [&](int k) { return f->cV(k)->cQ(); }));
				 });
		if (HasPerVertexRadius(from) && HasPerVertexRadius(to))
			Read(surfacePoints, faceOf, _radius,
				 [](ConstFacePointer f, const gpr::BarycentricPoint& at) {
					 return gpr::meanAs<RadiusType>(
						 gpr::meanOfCorners(at, [&](int k) { return f->cV(k)->cR(); }));
				 });
		if (HasPerVertexTexCoord(from) && HasPerVertexTexCoord(to))
			Read(surfacePoints, faceOf, _texCoord, TexCoordAt);
	}

	/// Reads the face attributes that `to` has. texture: texture of `from`, or null.
	template <class FaceOfType>
	void ReadFaces(const MeshType& from, const MeshType& to, const gpr::RemeshResult& run,
				   const gpr::TextureSource* texture, const FaceOfType& faceOf)
	{
		const auto own = [](auto valueOf) {
			return
				[valueOf](ConstFacePointer f, const gpr::BarycentricPoint&) { return valueOf(f); };
		};
		if (HasPerFaceColor(from) && HasPerFaceColor(to))
			Read(run.facePoints, faceOf, _faceColor,
				 own([](ConstFacePointer f) { return f->cC(); }));
		if (HasPerFaceQuality(from) && HasPerFaceQuality(to))
			Read(run.facePoints, faceOf, _faceQuality,
				 own([](ConstFacePointer f) { return f->cQ(); }));
		if (texture != nullptr && HasPerWedgeTexCoord(to)) _wedge = texture->carriedTo(run);
	}

	/// Writes to the first vertices and faces of m, in the order of the surface points.
	void Write(MeshType& m) const
	{
		for (std::size_t v = 0; v < _color.size(); ++v)
			m.vert[v].C() = _color[v];
		for (std::size_t v = 0; v < _quality.size(); ++v)
			m.vert[v].Q() = _quality[v];
		for (std::size_t v = 0; v < _radius.size(); ++v)
			m.vert[v].R() = _radius[v];
		for (std::size_t v = 0; v < _texCoord.size(); ++v)
			m.vert[v].T() = _texCoord[v];
		for (std::size_t f = 0; f < _faceColor.size(); ++f)
			m.face[f].C() = _faceColor[f];
		for (std::size_t f = 0; f < _faceQuality.size(); ++f)
			m.face[f].Q() = _faceQuality[f];
		for (std::size_t f = 0; f < _wedge.uv.size() / 6; ++f)
			WriteWedges(f, m.face[f]);
	}

private:
	typedef typename FaceType::ColorType   FaceColorType;
	typedef typename FaceType::QualityType FaceQualityType;

	template <class FaceOfType, class ValueType, class ValueAtType>
	static void Read(const PointVector& surfacePoints, const FaceOfType& faceOf,
					 std::vector<ValueType>& values, const ValueAtType& valueAt)
	{
		values.reserve(surfacePoints.size());
		for (const gpr::BarycentricPoint& at : surfacePoints)
			values.push_back(valueAt(faceOf(at.face), at));
	}

	static TexCoordType TexCoordAt(ConstFacePointer f, const gpr::BarycentricPoint& at)
	{
		const auto mean = [&](const auto& valueOf) {
			return float(gpr::meanOfCorners(at, [&](int k) { return valueOf(f->cV(k)->cT()); }));
		};
		TexCoordType t;
		t.U() = mean([](const TexCoordType& c) { return c.U(); });
		t.V() = mean([](const TexCoordType& c) { return c.V(); });
		t.N() = f->cV(gpr::nearestCorner(at))->cT().N();
		return t;
	}

	void WriteWedges(std::size_t f, FaceType& face) const
	{
		for (int k = 0; k < 3; ++k) {
			face.WT(k).U() = _wedge.uv[6 * f + 2 * std::size_t(k)];
			face.WT(k).V() = _wedge.uv[6 * f + 2 * std::size_t(k) + 1];
			face.WT(k).N() = short(_wedge.image[f]);
		}
	}

	std::vector<ColorType>       _color;
	std::vector<QualityType>     _quality;
	std::vector<RadiusType>      _radius;
	std::vector<TexCoordType>    _texCoord;
	std::vector<FaceColorType>   _faceColor;
	std::vector<FaceQualityType> _faceQuality;
	gpr::CornerTexture           _wedge; ///< empty: not carried
};

/// A sentence that names the lost attributes; empty if nothing was lost.
inline std::string SentenceOfLost(const std::vector<std::string>& names)
{
	std::string list;
	for (const std::string& name : names)
		list += (list.empty() ? "" : ", ") + (name.empty() ? "a nameless attribute" : name);
	return list.empty() ? list : "Not carried over to the result: " + list + ".";
}

/// The texture of `in` if `out` has wedge texture coordinates, else null.
template <class MeshType>
std::unique_ptr<gpr::TextureSource> TextureFor(const MeshType& in, const MeshType& out,
											   const FlatMesh<MeshType>& flat)
{
	if (!HasPerWedgeTexCoord(in) || !HasPerWedgeTexCoord(out)) return nullptr;
	const auto faceOf = [&](std::int32_t f) { return flat.Face(f); };
	return std::make_unique<gpr::TextureSource>(WedgeTextureOf<MeshType>(flat.View(), faceOf));
}

/// Whether the attributes that `in` and `out` share need the surface points of the result's faces.
template <class MeshType>
bool NeedsFacePoints(const MeshType& in, const MeshType& out)
{
	return (HasPerWedgeTexCoord(in) && HasPerWedgeTexCoord(out)) ||
		   (HasPerFaceColor(in) && HasPerFaceColor(out)) ||
		   (HasPerFaceQuality(in) && HasPerFaceQuality(out)) || !in.face_attr.empty();
}

/** \brief Runs an engine function on `in` and writes its mesh with carried attributes to `out`.

`out` may be `in`: all is read before the first write, and a run that is not Ok writes nothing.
engine: takes a view of `in` and the options, with the surface points needed by the attributes. */
template <class MeshType, class EngineFunctionType>
GeodesicPoissonResult WriteResultOf(const MeshType& in, MeshType& out, gpr::RemeshOptions options,
									gpr::RemeshReport* stat, EngineFunctionType engine)
{
	RequireReadableTriangles(in);
	try {
		FlatMesh<MeshType>                        flat(in);
		const std::unique_ptr<gpr::TextureSource> texture  = TextureFor(in, out, flat);
		const bool                                hasSeams = texture && texture->hasSeams();
		flat.ReadUsedBy(options, hasSeams ? texture->seams().data() : nullptr);
		options.surfacePointsOfVertices = true;
		options.surfacePointsOfFaces    = NeedsFacePoints(in, out);
		const gpr::RemeshResult run     = engine(flat.View(), options);
		if (stat != nullptr) *stat = run.report;
		GeodesicPoissonResult result = ResultOf(run);
		result.smallestVertexNum     = run.smallestVertexNum;
		if (run.status != gpr::Status::Ok) return result;

		const auto                      faceOf = [&](std::int32_t f) { return flat.Face(f); };
		AttributesAtPoints<MeshType>    attributes;
		CarriedUserAttributes<MeshType> user;
		attributes.ReadVertices(in, out, run.surfacePoints, faceOf);
		attributes.ReadFaces(in, out, run, texture.get(), faceOf);
		user.ReadVertices(in, run.surfacePoints, faceOf);
		user.ReadFaces(in, run.facePoints, faceOf);
		const std::string lost = SentenceOfLost(user.Lost());
		if (!lost.empty()) result.notes.push_back(lost);
		WriteMesh(run.mesh, out);
		attributes.Write(out);
		user.Write(out);
		RefreshDerived(out);
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
