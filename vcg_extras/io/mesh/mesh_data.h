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

/// Leaves new elements of a vector as they are: a reader writes every one of them anyway, and
/// zeroing a large array first costs as much as reading it.
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

/// What of a file is wanted beside the mesh.
struct WantedAttributes {
	bool        selection     = false; ///< of vertices and the corners of faces
	bool        ifSelected    = false; ///< of vertices, where the file marks any
	bool        faceSelection = false; ///< of the faces
	bool        carried       = false; ///< whatever there is, to be carried over to a result
	bool        mayStayInFile = false; ///< see InputMesh::inFile
	std::string regions       = {};    ///< of `carried`, which tells regions: see regionsOf

	/// Any that must be there.
	bool anyRequired() const { return selection || faceSelection; }
	bool ofSelectedVertices() const { return selection || ifSelected; }
};

class FileContent;

/// A mesh as its file holds it: nothing repaired, but every index is in range.
struct InputMesh {
	/// Positions and triangles where they lie in the file, if they can be used as they are there;
	/// the three arrays are empty then.
	MeshView                           inFile;
	std::shared_ptr<const FileContent> file;    ///< what inFile looks at
	CoordinateArray<float>             floats;  ///< 3 a vertex; empty when doublePrecision
	CoordinateArray<double>            doubles; ///< 3 a vertex; empty otherwise
	IndexArray                         triangles;
	bool                               doublePrecision = false;
	std::vector<std::uint8_t> selected;      ///< one a vertex, 1 = selected; empty where not wanted
	std::vector<std::uint8_t> selectedFaces; ///< one a triangle, likewise
	MeshAttributes            attributes;    ///< empty where not wanted
	FaceRegions               regions;       ///< that the attributes tell
	std::vector<std::string>  notes; ///< sentences about oddities that were no reason to refuse

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
