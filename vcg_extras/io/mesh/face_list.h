// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_FACE_LIST_H
#define VCG_EXTRAS_IO_MESH_FACE_LIST_H

#include "mesh_data.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gpr::app {

/// For a face with a missing vertex. Throws AppError (BadInput).
[[noreturn]] void failNoSuchVertex(std::uint64_t vertexNum);

/// The note about faces left out.
std::string tooSmallFacesNote(std::uint64_t faceNum);

/// Collects the faces of a file. Triangles are stored at once; larger polygons wait until all
/// positions are known, since the best cuts depend on the shape.
class FaceList {
public:
	IndexArray triangles; ///< open to readers that copy whole blocks

	/// Adds a face with any number of corners; an index beyond 32 bits becomes -1, which finish()
	/// refuses. Faces with fewer than three corners are left out and counted.
	void add(const std::int64_t* corners, std::size_t cornerNum);

	/// Adds a strip: each index makes a triangle with the two indices before, every second triangle
	/// turned over; -1 ends the strip. Triangles with a repeated index only steer the strip and are
	/// left out.
	void addStrip(const std::vector<std::int64_t>& strip);

	/// Adds the faces of another list after the faces here.
	void append(const FaceList& other);

	/// Checks every index, cuts the polygons into triangles and moves all into the mesh.
	/// Throws AppError (BadInput) when an index names no vertex of the mesh.
	void finish(InputMesh& mesh);

private:
	std::vector<std::int32_t> polygonCorners_;
	std::vector<std::size_t>  polygonEnds_;
	std::size_t               tooSmallNum_ = 0;

	void cutPolygons(const InputMesh& mesh);
};

} // namespace gpr::app

#endif
