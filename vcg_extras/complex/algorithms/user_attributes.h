// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_USER_ATTRIBUTES_H
#define VCG_EXTRAS_USER_ATTRIBUTES_H

// Internal: carries vcglib's named per-vertex and per-face attributes from a mesh to points
// anchored on its faces.

#include <vcg_extras/core/carry_over.h>

// vcglib's headers need complex.h before them.
// clang-format off
#include <vcg/complex/complex.h>
#include <vcg/space/color4.h>
#include <vcg/space/point2.h>
#include <vcg/space/point3.h>
#include <vcg/space/point4.h>
// clang-format on

#include <memory>
#include <string>
#include <type_traits>
#include <typeindex>
#include <vector>

namespace vcg {
namespace tri {
namespace gpr_detail {

/// Numbers and vectors of them have a mean: `componentNum` components of type ComponentType.
/// Whatever else there is (0 components) comes from the nearest corner.
template <class T>
struct MeanOf {
	static const int componentNum = 0;
};
template <>
struct MeanOf<float> {
	static const int componentNum = 1;
	typedef float    ComponentType;
};
template <>
struct MeanOf<double> {
	static const int componentNum = 1;
	typedef double   ComponentType;
};
template <class S, int num>
struct MeanOfPoint {
	static const int componentNum = num;
	typedef S        ComponentType;
};
template <class S>
struct MeanOf<vcg::Point2<S>> : MeanOfPoint<S, 2> {
};
template <class S>
struct MeanOf<vcg::Point3<S>> : MeanOfPoint<S, 3> {
};
template <class S>
struct MeanOf<vcg::Point4<S>> : MeanOfPoint<S, 4> {
};
template <class S>
struct MeanOf<vcg::Color4<S>> : MeanOfPoint<S, 4> {
};

/// Component k of a number or vector.
template <class T>
auto& ComponentOf(T& value, int k)
{
	if constexpr (std::is_arithmetic<std::remove_const_t<T>>::value)
		return value;
	else
		return value[k];
}

/// The mean of a value over the corners of a face, or the nearest corner's where it has none;
/// valueOf(k) returns a reference to the value at corner k.
template <class T, class ValueOfType>
T ValueAt(const gpr::SurfacePoint& at, const ValueOfType& valueOf)
{
	if constexpr (MeanOf<T>::componentNum > 0) {
		typedef typename MeanOf<T>::ComponentType ComponentType;
		T                                         mean = T();
		for (int i = 0; i < MeanOf<T>::componentNum; ++i)
			ComponentOf(mean, i) = gpr::meanAs<ComponentType>(
				gpr::meanOfCorners(at, [&](int k) { return ComponentOf<const T>(valueOf(k), i); }));
		return mean;
	}
	else {
		return valueOf(gpr::nearestCorner(at));
	}
}

/// The values of one named attribute at the elements of a mesh still to be written.
template <class MeshType>
class UserColumn {
public:
	explicit UserColumn(const std::string& name) : _name(name) {}
	virtual ~UserColumn() {}
	const std::string& Name() const { return _name; }
	/// Gives the first elements of m their values; an attribute that m lacks is made.
	virtual void Write(MeshType& m) const = 0;

private:
	std::string _name;
};

/// Whether there is an attribute of that name and of another type than T.
template <class T, class AttributesType>
bool HasOtherType(const AttributesType& attributes, const std::string& name)
{
	for (const PointerToAttribute& a : attributes)
		if (a._name == name) return a._type != std::type_index(typeid(T));
	return false;
}

/// As a struct, so that a vector of bool is a vector of bools.
template <class T>
struct Kept {
	T value;
};

template <class MeshType, class T>
class VertexColumn : public UserColumn<MeshType> {
public:
	using UserColumn<MeshType>::UserColumn;
	std::vector<Kept<T>> values;

	void Write(MeshType& m) const override
	{
		if (HasOtherType<T>(m.vert_attr, this->Name()))
			Allocator<MeshType>::DeletePerVertexAttribute(m, this->Name());
		auto handle = Allocator<MeshType>::template GetPerVertexAttribute<T>(m, this->Name());
		for (std::size_t v = 0; v < values.size(); ++v)
			handle[v] = values[v].value;
	}
};

template <class MeshType, class T>
class FaceColumn : public UserColumn<MeshType> {
public:
	using UserColumn<MeshType>::UserColumn;
	std::vector<Kept<T>> values;

	void Write(MeshType& m) const override
	{
		if (HasOtherType<T>(m.face_attr, this->Name()))
			Allocator<MeshType>::DeletePerFaceAttribute(m, this->Name());
		auto handle = Allocator<MeshType>::template GetPerFaceAttribute<T>(m, this->Name());
		for (std::size_t f = 0; f < values.size(); ++f)
			handle[f] = values[f].value;
	}
};

template <class... Ts>
struct TypeList {
};
typedef TypeList<float, double, Point2f, Point2d, Point3f, Point3d, Point4f, Point4d, Color4b,
				 Color4f, bool, char, signed char, unsigned char, short, unsigned short, int,
				 unsigned int, long, unsigned long, long long, unsigned long long, std::string>
	UserTypes;

/** \brief The named attributes of a mesh, read at anchors on its faces.

Attributes of vertices: means of numbers, points and colours over the corners of the anchor's face;
of other types (UserTypes) the nearest corner's value. Attributes of faces: that of the face that
the middle of the result's face lies on. `Lost()` names those of types that are not known here.
Read first and written later, so that the mesh read and the mesh written may be the same. */
template <class MeshType>
class CarriedUserAttributes {
public:
	typedef typename MeshType::ConstFacePointer            ConstFacePointer;
	typedef std::unique_ptr<UserColumn<MeshType>>          ColumnPointer;
	typedef typename std::vector<ColumnPointer>::size_type SizeType;

	/// faceOf(i) is the face of `from` that anchors mean by the number i.
	template <class FaceOfType>
	void ReadVertices(const MeshType& from, const std::vector<gpr::SurfacePoint>& anchors,
					  const FaceOfType& faceOf)
	{
		for (const PointerToAttribute& a : from.vert_attr)
			if (!TryVertex(from, a, anchors, faceOf, UserTypes())) _lost.push_back(a._name);
	}
	template <class FaceOfType>
	void ReadFaces(const MeshType& from, const std::vector<gpr::SurfacePoint>& faceAnchors,
				   const FaceOfType& faceOf)
	{
		for (const PointerToAttribute& a : from.face_attr)
			if (!TryFace(from, a, faceAnchors, faceOf, UserTypes())) _lost.push_back(a._name);
	}
	void Write(MeshType& m) const
	{
		for (const ColumnPointer& column : _vertex)
			column->Write(m);
		for (const ColumnPointer& column : _face)
			column->Write(m);
	}

	bool HasVertex(const std::string& name) const { return Has(_vertex, name); }
	bool HasFace(const std::string& name) const { return Has(_face, name); }
	const std::vector<std::string>& Lost() const { return _lost; }

private:
	std::vector<ColumnPointer> _vertex, _face;
	std::vector<std::string>   _lost;

	static bool Has(const std::vector<ColumnPointer>& columns, const std::string& name)
	{
		for (const ColumnPointer& column : columns)
			if (column->Name() == name) return true;
		return false;
	}

	template <class FaceOfType>
	static bool TryVertex(const MeshType&, const PointerToAttribute&,
						  const std::vector<gpr::SurfacePoint>&, const FaceOfType&, TypeList<>)
	{
		return false;
	}
	template <class FaceOfType, class T, class... Rest>
	bool TryVertex(const MeshType& from, const PointerToAttribute& a,
				   const std::vector<gpr::SurfacePoint>& anchors, const FaceOfType& faceOf,
				   TypeList<T, Rest...>)
	{
		if (!IsOf<T>(a)) return TryVertex(from, a, anchors, faceOf, TypeList<Rest...>());
		auto column = std::make_unique<VertexColumn<MeshType, T>>(a._name);
		column->values.reserve(anchors.size());
		for (const gpr::SurfacePoint& at : anchors) {
			const ConstFacePointer f       = faceOf(at.face);
			const auto             valueOf = [&](int k) -> const T& {
                return ValueOf<T>(a, Index(from, f->cV(k)));
			};
			column->values.push_back({ValueAt<T>(at, valueOf)});
		}
		_vertex.push_back(std::move(column));
		return true;
	}

	template <class FaceOfType>
	static bool TryFace(const MeshType&, const PointerToAttribute&,
						const std::vector<gpr::SurfacePoint>&, const FaceOfType&, TypeList<>)
	{
		return false;
	}
	template <class FaceOfType, class T, class... Rest>
	bool TryFace(const MeshType& from, const PointerToAttribute& a,
				 const std::vector<gpr::SurfacePoint>& faceAnchors, const FaceOfType& faceOf,
				 TypeList<T, Rest...>)
	{
		if (!IsOf<T>(a)) return TryFace(from, a, faceAnchors, faceOf, TypeList<Rest...>());
		auto column = std::make_unique<FaceColumn<MeshType, T>>(a._name);
		column->values.reserve(faceAnchors.size());
		for (const gpr::SurfacePoint& at : faceAnchors)
			column->values.push_back({ValueOf<T>(a, Index(from, faceOf(at.face)))});
		_face.push_back(std::move(column));
		return true;
	}

	/// Nameless attributes are somebody's scratch space; padded ones have another layout.
	template <class T>
	static bool IsOf(const PointerToAttribute& a)
	{
		return !a._name.empty() && a._padding == 0 && a._type == std::type_index(typeid(T));
	}
	template <class T>
	static const T& ValueOf(const PointerToAttribute& a, std::size_t element)
	{
		const SimpleTempDataBase* data = a._handle;
		return *static_cast<const T*>(data->At(element));
	}
};

} // namespace gpr_detail
} // namespace tri
} // namespace vcg

#endif
