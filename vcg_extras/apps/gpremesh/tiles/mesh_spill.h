// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_MESH_SPILL_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_MESH_SPILL_H

#include "ply_records.h"

#include <vcg_extras/io/base/output_file.h>

#include <array>
#include <cstdint>
#include <string>

// A mesh of any size that is read from text, until it is known how it shall be written.

namespace gpr::app {

/// Vertices and faces of one piece of a file, as they lie on the disk.
class MeshPieceBytes {
public:
	using Colour = std::array<std::uint8_t, 3>;

	void addVertex(const std::array<double, 3>& position, const Colour* colour = nullptr);
	/// Faces with fewer than three corners are left out and counted.
	void addFace(const std::int64_t* corners, std::size_t num);

private:
	friend class MeshSpill;
	std::string   vertices_, faces_;
	std::uint64_t vertexNum_ = 0, colourNum_ = 0, faceNum_ = 0, tooSmallNum_ = 0;
	std::uint64_t largestIndex_ = 0; ///< one below 0 counts as huge
	std::uint64_t mostCorners_  = 0; ///< of a face
	double        largest_      = 0; ///< finite coordinate, without its sign
};

/// Puts a mesh aside in two files and makes a binary PLY file of it. Polygons stay as they are.
/// Memory: some megabytes.
class MeshSpill {
public:
	/// folder: where the two files are.
	MeshSpill(const std::string& folder, const RunLimit& limit);

	void          add(const MeshPieceBytes& piece);
	std::uint64_t vertexNum() const { return all_.vertexNum_; }
	std::uint64_t tooSmallFaceNum() const { return all_.tooSmallNum_; }

	/// Writes all that was added; nothing can be added afterwards. Coordinates are floats where
	/// these resolve a thousandth of the mean edge (see settlePrecision), which is that of a sample
	/// of 10,000 faces. Colours are written where all vertices have one. Throws AppError
	/// (BadInput) where a face names a vertex that is not there, or there is no face.
	void writePly(const std::string& path);

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
