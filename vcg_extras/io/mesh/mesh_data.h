// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_MESH_DATA_H
#define VCG_EXTRAS_IO_MESH_MESH_DATA_H

#include "face_regions.h"
#include "mesh_attributes.h"

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gpr::app {

/// Leaves new elements of a vector uninitialized: a reader writes every element anyway, and zeroing
/// a large array costs as much as reading the file.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
	template <class U>
	struct rebind {
		using other = UninitializedAllocator<U>;
	};
	template <class U>
	void construct(U* at) noexcept
	{
		::new (static_cast<void*>(at)) U;
	}
	template <class U, class... Args>
	void construct(U* at, Args&&... args)
	{
		::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
	}
};

/// Vertex indices, three a triangle.
using IndexArray = std::vector<std::int32_t, UninitializedAllocator<std::int32_t>>;

/// Coordinates, three a vertex.
template <class S>
using CoordinateArray = std::vector<S, UninitializedAllocator<S>>;

/// The wanted parts of a file beside the mesh.
struct WantedAttributes {
	bool        selection     = false; ///< of vertices and the corners of faces
	bool        ifSelected    = false; ///< of vertices, if the file marks any
	bool        faceSelection = false; ///< of the faces
	bool        carried       = false; ///< whatever there is, to be carried over to a result
	bool        mayStayInFile = false; ///< see InputMesh::inFile
	std::string regions       = {};    ///< of `carried`, which tells regions: see regionsOf

	/// Any part that must be present.
	bool anyRequired() const { return selection || faceSelection; }
	bool ofSelectedVertices() const { return selection || ifSelected; }
};

class FileContent;

/// A mesh as in its file: nothing repaired, but every index is in range.
struct InputMesh {
	/// Positions and triangles at their places in the file, if usable there; then the three arrays
	/// are empty.
	MeshView                           inFile;
	std::shared_ptr<const FileContent> file;    ///< the file of inFile
	CoordinateArray<float>             floats;  ///< 3 a vertex; empty when doublePrecision
	CoordinateArray<double>            doubles; ///< 3 a vertex; empty otherwise
	IndexArray                         triangles;
	bool                               doublePrecision = false;
	std::vector<std::uint8_t> selected;      ///< one a vertex, 1 = selected; empty if not wanted
	std::vector<std::uint8_t> selectedFaces; ///< one a triangle, likewise
	MeshAttributes            attributes;    ///< empty if not wanted
	FaceRegions               regions;       ///< from the attributes
	std::vector<std::string>  notes; ///< sentences about oddities that are no reason to refuse

	bool        isInFile() const { return inFile.triangles != nullptr; }
	std::size_t vertexNum() const { return view().vertexNum; }
	std::size_t faceNum() const { return view().faceNum; }
	MeshView    view() const
	{
		MeshView v     = isInFile() ? inFile : viewOfArrays();
		v.selected     = selected.empty() ? nullptr : selected.data();
		v.selectedFace = selectedFaces.empty() ? nullptr : selectedFaces.data();
		v.region       = regions.label.empty() ? nullptr : regions.label.data();
		v.regionNames  = &regions.names;
		return v;
	}

private:
	MeshView viewOfArrays() const
	{
		MeshView v;
		v.positions = doublePrecision ? static_cast<const void*>(doubles.data()) : floats.data();
		v.doublePrecision     = doublePrecision;
		v.positionStrideBytes = 3 * (doublePrecision ? sizeof(double) : sizeof(float));
		v.vertexNum           = (doublePrecision ? doubles.size() : floats.size()) / 3;
		v.triangles           = triangles.data();
		v.faceNum             = triangles.size() / 3;
		return v;
	}
};

} // namespace gpr::app

#endif
