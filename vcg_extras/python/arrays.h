// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_ARRAYS_H
#define VCG_EXTRAS_PYTHON_ARRAYS_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <optional>
#include <utility>
#include <vector>

// NumPy arrays, in and out without a copy. The Python part has checked and converted the arrays;
// the checks here keep a wrong call from reading beyond an array.

namespace gpr::python {

namespace nb = nanobind;

template <class T, class Shape>
using Input = nb::ndarray<const T, Shape, nb::c_contig, nb::device::cpu>;

/// Coordinates, float or double.
using Positions    = nb::ndarray<nb::ro, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Triangles    = Input<std::int32_t, nb::shape<-1, 3>>;
using Edges        = Input<std::int32_t, nb::shape<-1, 2>>;
using Indices      = Input<std::int32_t, nb::ndim<1>>;
using Sizes        = Input<float, nb::ndim<1>>;
using Marks        = Input<std::uint8_t, nb::ndim<1>>;
using CornerCoords = Input<float, nb::shape<-1, 3, 2>>;

/// The coordinates as a view without triangles. Throws TypeError for coordinates that are neither
/// float nor double.
inline MeshView viewOf(const Positions& positions)
{
	MeshView view;
	view.doublePrecision = positions.dtype() == nb::dtype<double>();
	if (!view.doublePrecision && positions.dtype() != nb::dtype<float>())
		throw nb::type_error("The coordinates must be float32 or float64.");
	view.positions           = positions.data();
	view.positionStrideBytes = 3 * (view.doublePrecision ? sizeof(double) : sizeof(float));
	view.vertexNum           = positions.shape(0);
	return view;
}

inline MeshView viewOf(const Positions& positions, const Triangles& triangles)
{
	MeshView view  = viewOf(positions);
	view.triangles = triangles.data();
	view.faceNum   = triangles.shape(0);
	return view;
}

/// The data of an array, which must have `length` rows; null if there is no array.
template <class Array>
auto dataOf(const std::optional<Array>& array, std::size_t length) -> decltype(array->data())
{
	if (!array) return nullptr;
	if (array->shape(0) != length) throw nb::value_error("An array has another number of rows.");
	return array->data();
}

/// Makes an array that owns the memory of the vector.
template <class T, class Element>
nb::object toNumpy(std::vector<Element>&& values, std::initializer_list<std::size_t> shape)
{
	auto* const       kept = new std::vector<Element>(std::move(values));
	const nb::capsule owner(kept,
							[](void* p) noexcept { delete static_cast<std::vector<Element>*>(p); });
	T* const          data = reinterpret_cast<T*>(kept->data());
	return nb::cast(nb::ndarray<nb::numpy, T>(data, shape, owner));
}

template <class T>
nb::object toNumpy(std::vector<T>&& values)
{
	const std::size_t length = values.size();
	return toNumpy<T>(std::move(values), {length});
}

inline nb::object toNumpy(std::vector<Vec3d>&& points)
{
	static_assert(sizeof(Vec3d) == 3 * sizeof(double), "three doubles a point");
	const std::size_t length = points.size();
	return toNumpy<double>(std::move(points), {length, 3});
}

/// The faces of points on a surface.
inline nb::object facesOf(const std::vector<BarycentricPoint>& points)
{
	std::vector<std::int32_t> faces;
	faces.reserve(points.size());
	for (const BarycentricPoint& p : points)
		faces.push_back(p.face);
	return toNumpy(std::move(faces));
}

/// The barycentric weights of points on a surface, three per point. Their sum is 1 as exactly as
/// doubles can, so that places far from the origin are right.
inline nb::object weightsOf(const std::vector<BarycentricPoint>& points)
{
	std::vector<double> weights;
	weights.reserve(3 * points.size());
	for (const BarycentricPoint& p : points) {
		const double sum = double(p.weight[0]) + double(p.weight[1]) + double(p.weight[2]);
		for (const float weight : p.weight)
			weights.push_back(double(weight) / sum);
	}
	return toNumpy<double>(std::move(weights), {points.size(), 3});
}

} // namespace gpr::python

#endif
