// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_MESH_CONVERSION_H
#define VCG_EXTRAS_MESH_CONVERSION_H

// Internal: conversion between a vcg mesh and the flat arrays of the engine, without any decision
// about geometry. The engine repairs bad input, so that all hosts give the same bytes.

#include <vcg_extras/complex/algorithms/geodesic_poisson_base.h>

// vcglib's headers need complex.h first.
// clang-format off
#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>
#include <vcg/complex/algorithms/update/topology.h>
#include <wrap/callback.h>
// clang-format on

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <type_traits>
#include <vector>

namespace vcg {
namespace tri {
namespace gpr_detail {

/// Per element, without deleted elements: 1 if selected.
template <class ContainerType>
std::vector<std::uint8_t> SelectionOf(const ContainerType& elements)
{
	std::vector<std::uint8_t> selected;
	selected.reserve(elements.size());
	for (const auto& e : elements)
		if (!e.IsD()) selected.push_back(e.IsS());
	return selected;
}

/// Per vertex of a view of m: 1 if selected. Without selected vertices: 1 for the corners of
/// selected faces.
template <class MeshType>
std::vector<std::uint8_t> SelectedVertices(const MeshType& m, const gpr::MeshView& view)
{
	std::vector<std::uint8_t> selected = SelectionOf(m.vert);
	if (std::find(selected.begin(), selected.end(), 1) != selected.end()) return selected;
	const std::vector<std::uint8_t> selectedFace = SelectionOf(m.face);
	for (std::size_t f = 0; f < selectedFace.size(); ++f)
		for (const std::int32_t v : view.triangle(f))
			if (selectedFace[f] != 0 && v >= 0) selected[std::size_t(v)] = 1;
	return selected;
}

/// The selected edges as lines of the engine: a byte per corner of the faces, without deleted
/// faces; empty if no edge is selected. others: further lines to add, of the same size, or null.
template <class MeshType>
std::vector<std::uint8_t> SelectedEdges(const MeshType& m, const std::uint8_t* others)
{
	std::vector<std::uint8_t> line;
	bool                      anyFlag = false;
	for (const auto& f : m.face) {
		if (f.IsD()) continue;
		for (int k = 0; k < 3; ++k) {
			anyFlag = anyFlag || f.IsFaceEdgeS(k);
			line.push_back(f.IsFaceEdgeS(k) || (others != nullptr && others[line.size()] != 0));
		}
	}
	if (!anyFlag) line.clear();
	return line;
}

/** \brief The engine's view of a vcg mesh. The mesh must outlive the view, unchanged.

Deleted elements are left out. Without deleted vertices the positions are viewed in place; otherwise
the positions are copied without gaps, so that the engine does not count the gaps as vertices. A
corner that is null, deleted or outside of the mesh becomes index -1, which the engine refuses.
Cost: one pass over the mesh, 12 B per face (and 12 or 24 B per vertex when copied).
*/
template <class MeshType>
class FlatMesh {
public:
	typedef typename MeshType::ScalarType       ScalarType;
	typedef typename MeshType::VertexType       VertexType;
	typedef typename MeshType::FaceType         FaceType;
	typedef typename MeshType::ConstFacePointer ConstFacePointer;

	static_assert(std::is_same<ScalarType, float>::value || std::is_same<ScalarType, double>::value,
				  "coordinates are float or double");

	explicit FlatMesh(const MeshType& m) : _mesh(m)
	{
		CollectVertices();
		CollectFaces();
	}

	/// Reads the data that the options need beside positions and faces; later views have these
	/// data. seams: lines to follow in any case, three per face of the view, or null; must outlive
	/// the views.
	void ReadUsedBy(const gpr::RemeshOptions& options, const std::uint8_t* seams = nullptr)
	{
		_lines = seams;
		if (options.featureRegion == gpr::FeatureRegion::Selection)
			_selected = SelectedVertices(_mesh, View());
		else if (gpr::mayUseSelectedVertices(options))
			_selected = SelectionOf(_mesh.vert);
		if (options.selectedOnly) _selectedFace = SelectionOf(_mesh.face);
		if (options.featureMode == gpr::FeatureMode::Given) {
			_selectedEdge = SelectedEdges(_mesh, seams);
			_lines        = DataOrNull(_selectedEdge);
		}
	}

	gpr::MeshView View() const
	{
		gpr::MeshView view(_position, _triangle);
		view.selected     = DataOrNull(_selected);
		view.selectedFace = DataOrNull(_selectedFace);
		view.line         = _lines;
		if (_indexOf.empty() && !_mesh.vert.empty()) {
			view.positions           = _mesh.vert[0].P().V(); // cP() would copy
			view.positionStrideBytes = sizeof(VertexType);
			view.vertexNum           = _mesh.vert.size();
		}
		return view;
	}

	/// The mesh's face behind face f of the view.
	ConstFacePointer Face(std::int32_t f) const
	{
		return &_mesh.face[_faceOf.empty() ? std::size_t(f) : std::size_t(_faceOf[f])];
	}

private:
	template <class T>
	static const T* DataOrNull(const std::vector<T>& values)
	{
		return values.empty() ? nullptr : values.data();
	}

	void CollectVertices()
	{
		const auto& vert = _mesh.vert;
		if (std::none_of(vert.begin(), vert.end(), [](const VertexType& v) { return v.IsD(); }))
			return;
		_indexOf.assign(vert.size(), -1);
		for (std::size_t i = 0; i < vert.size(); ++i) {
			if (vert[i].IsD()) continue;
			_indexOf[i]   = std::int32_t(_position.size());
			const auto& p = vert[i].cP();
			_position.push_back(gpr::Vec3<ScalarType>(p[0], p[1], p[2]));
		}
	}

	void CollectFaces()
	{
		const auto& face = _mesh.face;
		const bool  compactFlag =
			std::none_of(face.begin(), face.end(), [](const FaceType& f) { return f.IsD(); });
		_triangle.reserve(3 * face.size());
		for (std::size_t i = 0; i < face.size(); ++i) {
			if (face[i].IsD()) continue;
			if (!compactFlag) _faceOf.push_back(std::int32_t(i));
			for (int k = 0; k < 3; ++k)
				_triangle.push_back(VertexIndex(face[i].cV(k)));
		}
	}

	std::int32_t VertexIndex(const VertexType* v) const
	{
		const std::less<const VertexType*> before;
		const VertexType*                  first = _mesh.vert.data();
		if (before(v, first) || !before(v, first + _mesh.vert.size())) return -1;
		return _indexOf.empty() ? std::int32_t(v - first) : _indexOf[v - first];
	}

	const MeshType&                    _mesh;
	std::vector<gpr::Vec3<ScalarType>> _position; ///< filled only with deleted vertices
	std::vector<std::int32_t>          _triangle;
	std::vector<std::int32_t>          _indexOf; ///< per mesh vertex: index in the view; or empty
	std::vector<std::int32_t> _faceOf; ///< per face of the view: index in the mesh; or empty

	// Data for the options; empty if not needed.
	std::vector<std::uint8_t> _selected, _selectedFace, _selectedEdge;
	const std::uint8_t*       _lines = nullptr;
};

/// Requires the components that every algorithm needs; throws vcglib's exceptions if any is
/// missing.
template <class MeshType>
void RequireReadableTriangles(const MeshType& m)
{
	RequireTriangularMesh(m);
	RequirePerVertexFlags(m);
	RequirePerFaceFlags(m);
}

/// The engine's progress as vcglib's callback, in percent. A false answer cancels. Null is allowed.
inline gpr::ProgressCallback ProgressOf(vcg::CallBackPos* cb)
{
	if (cb == nullptr) return nullptr;
	return [cb](double share, const char* phrase) {
		return cb(int(100 * std::min(1.0, std::max(0.0, share))), phrase);
	};
}

/// The outcome for the user of any of the engine's results.
template <class EngineResultType>
GeodesicPoissonResult ResultOf(const EngineResultType& r)
{
	GeodesicPoissonResult result;
	result.status  = r.status;
	result.message = r.message;
	result.notes   = r.notes;
	return result;
}

inline GeodesicPoissonResult OutOfMemoryResult()
{
	GeodesicPoissonResult result;
	result.status  = gpr::Status::OutOfMemory;
	result.message = "There is not enough memory for the mesh.";
	return result;
}

template <class CoordType>
CoordType ToCoord(const gpr::Vec3d& p)
{
	typedef typename CoordType::ScalarType ScalarType;
	return CoordType(ScalarType(p.x), ScalarType(p.y), ScalarType(p.z));
}

/// Makes room for vertNum vertices and faceNum faces; if memory runs out m is unchanged.
template <class MeshType>
void GrowContainers(MeshType& m, std::size_t vertNum, std::size_t faceNum)
{
	const std::size_t oldVertNum = m.vert.size(), oldFaceNum = m.face.size();
	const int         vn = m.vn, fn = m.fn;
	try {
		if (vertNum > oldVertNum) Allocator<MeshType>::AddVertices(m, vertNum - oldVertNum);
		if (faceNum > oldFaceNum) Allocator<MeshType>::AddFaces(m, faceNum - oldFaceNum);
	}
	catch (const std::bad_alloc&) {
		m.vert.resize(oldVertNum);
		m.face.resize(oldFaceNum);
		m.vn = vn;
		m.fn = fn;
		throw;
	}
}

/// Replaces all elements of m by fresh elements. Optional (ocf) components stay enabled and user
/// attributes stay attached, both with fresh values; the mesh's colour stays.
template <class MeshType>
void ReplaceElements(MeshType& m, std::size_t vertNum, std::size_t faceNum)
{
	GrowContainers(m, vertNum, faceNum);
	const Color4b meshColor = m.C();
	// Clear() alone would leave old values in optional components and attributes. Capacity survives
	// all of this, so no allocation follows.
	m.vert.resize(0);
	m.face.resize(0);
	ResizeAttribute(m.vert_attr, 0, m);
	ResizeAttribute(m.face_attr, 0, m);
	ResizeAttribute(m.edge_attr, 0, m);
	m.Clear();
	m.C() = meshColor;
	Allocator<MeshType>::AddVertices(m, vertNum);
	Allocator<MeshType>::AddFaces(m, faceNum);
}

/// Computes normals, bounding box and adjacency of m anew by vcglib, as far as m has such data.
template <class MeshType>
void RefreshDerived(MeshType& m)
{
	typedef typename MeshType::CoordType CoordType;
	UpdateBounding<MeshType>::Box(m);
	// vcglib's normals compile only if normals and coordinates have the same type.
	if constexpr (std::is_same<typename MeshType::FaceType::NormalType, CoordType>::value)
		if (HasPerFaceNormal(m)) UpdateNormal<MeshType>::PerFaceNormalized(m);
	if constexpr (std::is_same<typename MeshType::VertexType::NormalType, CoordType>::value)
		if (HasPerVertexNormal(m)) UpdateNormal<MeshType>::PerVertexNormalized(m);
	if (HasFFAdjacency(m)) UpdateTopology<MeshType>::FaceFace(m);
	if (HasVFAdjacency(m)) UpdateTopology<MeshType>::VertexFace(m);
}

/// Replaces the content of m by the engine's mesh, without derived data: see RefreshDerived.
template <class MeshType>
void WriteMesh(const gpr::TriangleMesh& from, MeshType& m)
{
	ReplaceElements(m, from.vertexNum(), from.faceNum());
	for (std::size_t v = 0; v < from.vertexNum(); ++v)
		m.vert[v].P() = ToCoord<typename MeshType::CoordType>(from.positions[v]);
	for (std::size_t f = 0; f < from.faceNum(); ++f)
		for (int k = 0; k < 3; ++k)
			m.face[f].V(k) = &m.vert[from.triangles[3 * f + k]];
}

} // namespace gpr_detail
} // namespace tri
} // namespace vcg

#endif
