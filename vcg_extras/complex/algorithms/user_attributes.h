// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_USER_ATTRIBUTES_H
#define VCG_EXTRAS_USER_ATTRIBUTES_H

// Internal: carries vcglib's named per-vertex and per-face attributes from a mesh to points on its
// faces.

#include <vcg_extras/core/carry_over.h>

// vcglib's headers need complex.h first.
// clang-format off
#include <vcg/complex/complex.h>
#include <vcg/space/color4.h>
#include <vcg/space/point2.h>
#include <vcg/space/point3.h>
#include <vcg/space/point4.h>
// clang-format on

#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace vcg {
namespace tri {
namespace gpr_detail {

/// Numbers and vectors of numbers have a mean: `componentNum` components of type ComponentType. All
/// other types have 0 components; their values come from the nearest corner.
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

/// The mean of a value over the corners of a face; for types without a mean the nearest corner's
/// value. valueOf(k) returns a reference to the value at corner k.
template <class T, class ValueOfType>
T ValueAt(const gpr::BarycentricPoint& at, const ValueOfType& valueOf)
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

/// A struct, so that a vector of bool is a vector of bools.
template <class T>
struct Kept {
	T value;
};

// The compiler needs memory for each function that depends on both the type of the mesh and the
// type of the values, of over twenty types. So reading, keeping and copying values depends on their
// type alone, and finding or adding an attribute depends on the mesh alone.

/// The values of a named attribute for the elements of a future mesh.
class UserValues {
public:
	UserValues(const std::string& name, std::type_index type) : _name(name), _type(type) {}
	virtual ~UserValues() {}
	const std::string& Name() const { return _name; }
	std::type_index    Type() const { return _type; }
	virtual int        SizeOfValue() const = 0;
	/// Copies the values to the first elements of data, of the same type.
	virtual void CopyTo(SimpleTempDataBase& data) const = 0;

private:
	std::string     _name;
	std::type_index _type;
};

template <class T>
class UserValuesOf : public UserValues {
public:
	explicit UserValuesOf(const std::string& name) : UserValues(name, typeid(T)) {}

	/// Reads values of vertices at surface points. corners: the corners of each surface point's
	/// face.
	void ReadCorners(const SimpleTempDataBase&                 data,
					 const std::vector<gpr::BarycentricPoint>& surfacePoints,
					 const std::vector<std::size_t>&           corners)
	{
		_values.reserve(surfacePoints.size());
		for (std::size_t i = 0; i < surfacePoints.size(); ++i) {
			const auto valueOf = [&](int k) -> const T& {
				return *static_cast<const T*>(data.At(corners[3 * i + std::size_t(k)]));
			};
			_values.push_back({ValueAt<T>(surfacePoints[i], valueOf)});
		}
	}
	void ReadElements(const SimpleTempDataBase& data, const std::vector<std::size_t>& elements)
	{
		_values.reserve(elements.size());
		for (std::size_t e : elements)
			_values.push_back({*static_cast<const T*>(data.At(e))});
	}

	int  SizeOfValue() const override { return int(sizeof(T)); }
	void CopyTo(SimpleTempDataBase& data) const override
	{
		for (std::size_t i = 0; i < _values.size(); ++i)
			*static_cast<T*>(data.At(i)) = _values[i].value;
	}

private:
	std::vector<Kept<T>> _values;
};

/// The values for the elements of a container, and a function for new data of such values.
template <class ContainerType>
struct UserColumn {
	std::unique_ptr<UserValues> values;
	SimpleTempDataBase* (*newData)(ContainerType&);
};

template <class ContainerType, class T>
SimpleTempDataBase* NewUserData(ContainerType& elements)
{
	return new SimpleTempData<ContainerType, T>(elements);
}

/** \brief Gives the first elements of a mesh the values of a column.

An attribute that the mesh lacks, or has with another type or layout, is made in the way of vcglib's
allocator. attributes: of the elements; attributeNum: the mesh's number of its last attribute.
*/
template <class ContainerType>
void WriteColumn(const UserColumn<ContainerType>& column, ContainerType& elements,
				 std::set<PointerToAttribute>& attributes, int& attributeNum)
{
	PointerToAttribute a;
	a._name    = column.values->Name();
	auto found = attributes.find(a);
	if (found != attributes.end() &&
		(found->_type != column.values->Type() || found->_padding != 0)) {
		delete found->_handle;
		attributes.erase(found);
		found = attributes.end();
	}
	if (found == attributes.end()) {
		std::unique_ptr<SimpleTempDataBase> data(column.newData(elements));
		a._sizeof  = column.values->SizeOfValue();
		a._padding = 0;
		a._handle  = data.get();
		a._type    = column.values->Type();
		a.n_attr   = ++attributeNum;
		found      = attributes.insert(a).first;
		data.release();
	}
	column.values->CopyTo(*found->_handle);
}

template <class... Ts>
struct TypeList {
};
typedef TypeList<float, double, Point2f, Point2d, Point3f, Point3d, Point4f, Point4d, Color4b,
				 Color4f, bool, char, signed char, unsigned char, short, unsigned short, int,
				 unsigned int, long, unsigned long, long long, unsigned long long, std::string>
	UserTypes;

/** \brief The named attributes of a mesh, read at surface points on its faces.

Vertex attributes: means of numbers, points and colours over the corners of the surface point's
face; for other types (UserTypes) the nearest corner's value. Face attributes: the value of the
input face below the middle of the result's face. `Lost()` names attributes of unknown types. All
attributes are read first and written later: both meshes may be the same. */
template <class MeshType>
class CarriedUserAttributes {
public:
	typedef std::vector<gpr::BarycentricPoint> PointVector;

	/// faceOf(i): face of `from` with number i in surface points.
	template <class FaceOfType>
	void ReadVertices(const MeshType& from, const PointVector& surfacePoints,
					  const FaceOfType& faceOf)
	{
		if (from.vert_attr.empty()) return;
		std::vector<std::size_t> corners;
		corners.reserve(3 * surfacePoints.size());
		for (const gpr::BarycentricPoint& at : surfacePoints)
			for (int k = 0; k < 3; ++k)
				corners.push_back(Index(from, faceOf(at.face)->cV(k)));
		for (const PointerToAttribute& a : from.vert_attr)
			if (!ReadVertexAttribute(a, surfacePoints, corners, UserTypes()))
				_lost.push_back(a._name);
	}
	template <class FaceOfType>
	void ReadFaces(const MeshType& from, const PointVector& facePoints, const FaceOfType& faceOf)
	{
		if (from.face_attr.empty()) return;
		std::vector<std::size_t> faces;
		faces.reserve(facePoints.size());
		for (const gpr::BarycentricPoint& at : facePoints)
			faces.push_back(Index(from, faceOf(at.face)));
		for (const PointerToAttribute& a : from.face_attr)
			if (!ReadFaceAttribute(a, faces, UserTypes())) _lost.push_back(a._name);
	}
	void Write(MeshType& m) const
	{
		for (const VertexColumn& column : _vertex)
			WriteColumn(column, m.vert, m.vert_attr, m.attrn);
		for (const FaceColumn& column : _face)
			WriteColumn(column, m.face, m.face_attr, m.attrn);
	}

	bool HasVertex(const std::string& name) const { return Has(_vertex, name); }
	bool HasFace(const std::string& name) const { return Has(_face, name); }
	const std::vector<std::string>& Lost() const { return _lost; }

private:
	typedef typename MeshType::VertContainer VertContainer;
	typedef typename MeshType::FaceContainer FaceContainer;
	typedef UserColumn<VertContainer>        VertexColumn;
	typedef UserColumn<FaceContainer>        FaceColumn;

	std::vector<VertexColumn> _vertex;
	std::vector<FaceColumn>   _face;
	std::vector<std::string>  _lost;

	template <class ColumnType>
	static bool Has(const std::vector<ColumnType>& columns, const std::string& name)
	{
		for (const ColumnType& column : columns)
			if (column.values->Name() == name) return true;
		return false;
	}

	/// False if the attribute has none of the types.
	template <class... Ts>
	bool ReadVertexAttribute(const PointerToAttribute& a, const PointVector& surfacePoints,
							 const std::vector<std::size_t>& corners, TypeList<Ts...>)
	{
		return (ReadVertexValues<Ts>(a, surfacePoints, corners) || ...);
	}
	template <class T>
	bool ReadVertexValues(const PointerToAttribute& a, const PointVector& surfacePoints,
						  const std::vector<std::size_t>& corners)
	{
		if (!IsOf<T>(a)) return false;
		auto values = std::make_unique<UserValuesOf<T>>(a._name);
		values->ReadCorners(*a._handle, surfacePoints, corners);
		_vertex.push_back({std::move(values), NewUserData<VertContainer, T>});
		return true;
	}

	template <class... Ts>
	bool ReadFaceAttribute(const PointerToAttribute& a, const std::vector<std::size_t>& faces,
						   TypeList<Ts...>)
	{
		return (ReadFaceValues<Ts>(a, faces) || ...);
	}
	template <class T>
	bool ReadFaceValues(const PointerToAttribute& a, const std::vector<std::size_t>& faces)
	{
		if (!IsOf<T>(a)) return false;
		auto values = std::make_unique<UserValuesOf<T>>(a._name);
		values->ReadElements(*a._handle, faces);
		_face.push_back({std::move(values), NewUserData<FaceContainer, T>});
		return true;
	}

	/// Nameless attributes are somebody's scratch space; padded attributes have another layout.
	template <class T>
	static bool IsOf(const PointerToAttribute& a)
	{
		return !a._name.empty() && a._padding == 0 && a._type == std::type_index(typeid(T));
	}
};

} // namespace gpr_detail
} // namespace tri
} // namespace vcg

#endif
