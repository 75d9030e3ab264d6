// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_MESH_SPILL_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_MESH_SPILL_H

#include "ply_records.h"

#include <vcg_extras/io/base/output_file.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// A mesh of any size, read from text, on the disk until the types for writing are known.

namespace gpr::app {

/// Vertices and faces of a piece of a file, in their format on the disk.
class MeshPieceBytes {
public:
	using Colour = std::array<std::uint8_t, 3>;

	void addVertex(const std::array<double, 3>& position, const Colour* colour = nullptr);
	/// Leaves out and counts faces with fewer than three corners.
	void addFace(const std::int64_t* corners, std::size_t num);

private:
	friend class MeshSpill;
	std::string   vertices_, faces_;
	std::uint64_t vertexNum_ = 0, colourNum_ = 0, faceNum_ = 0, tooSmallNum_ = 0;
	std::uint64_t largestIndex_ = 0; ///< a number below 0 counts as huge
	std::uint64_t mostCorners_  = 0; ///< of a face
	double        largest_      = 0; ///< finite coordinate, without its sign
};

/// Collects a mesh in two files and makes a binary PLY file of the mesh. Polygons stay polygons.
/// Memory: some megabytes.
class MeshSpill {
public:
	/// folder: for the two files.
	MeshSpill(const std::string& folder, const RunLimit& limit);

	void          add(const MeshPieceBytes& piece);
	std::uint64_t vertexNum() const { return all_.vertexNum_; }

	/// Writes the whole mesh; nothing can be added afterwards. Returns sentences about faces that
	/// were left out. Coordinates are floats if floats
	/// resolve a thousandth of the mean edge (see settlePrecision); the mean edge is estimated from
	/// a sample of 10,000 faces. Writes colours if all vertices have a colour. Throws AppError
	/// (BadInput) for a vertex number out of range, and if there is no face.
	std::vector<std::string> writePly(const std::string& path);

private:
	std::string    verticesPath_, facesPath_;
	RunLimit       limit_;
	OutputFile     vertices_, faces_;
	MeshPieceBytes all_; ///< the counts of all pieces, without their bytes

	PlyRecordLayout layoutAside() const;
	bool            floatsWillDo() const;
	double          meanEdgeOfSample() const;
	std::string     header(bool asFloats) const;
	bool            isColoured() const { return all_.colourNum_ == all_.vertexNum_; }
	void            writeVertices(const PlyRecordLayout& layout, OutputFile& out) const;
	void            writeFaces(const PlyRecordLayout& layout, OutputFile& out) const;
};

} // namespace gpr::app

#endif
