// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_spill.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/face_list.h>
#include <vcg_extras/io/mesh/polygon.h>
#include <vcg_extras/io/mesh/precision.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpr::app {

namespace {

constexpr std::size_t colourBytes = 3;

/// Types of the values of a file.
struct Types {
	PlyType coordinate, cornerNum, corner;
};

std::string headerText(const Types& types, bool isColoured, std::uint64_t vertexNum,
					   std::uint64_t faceNum)
{
	PlyElement vertex = elementWithPositions(types.coordinate, vertexNum);
	for (const char* name : {"red", "green", "blue"}) {
		if (isColoured) vertex.properties.push_back({name, PlyType::UInt8});
	}
	return plyHeaderText(
		ownHeader({vertex, elementOfFaces(types.cornerNum, types.corner, faceNum)}), "");
}

/// Adds the edges of a face's triangles to their sum and number, as settlePrecision counts edges.
void addEdges(const std::vector<Vec3d>& corners, double& sum, std::uint64_t& num)
{
	std::vector<std::size_t> triangles;
	cutPolygon(corners, triangles);
	for (std::size_t i = 0; i < triangles.size(); ++i) {
		const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
		const double      len  = length(corners[triangles[next]] - corners[triangles[i]]);
		if (!std::isfinite(len)) continue;
		sum += len;
		++num;
	}
}

} // namespace

void MeshPieceBytes::addVertex(const std::array<double, 3>& position, const Colour* colour)
{
	for (const double c : position) {
		appendValue(PlyType::Float64, c, vertices_);
		if (std::isfinite(c)) largest_ = std::max(largest_, std::abs(c));
	}
	for (std::size_t k = 0; k < colourBytes; ++k)
		vertices_ += colour != nullptr ? char((*colour)[k]) : char(0);
	colourNum_ += colour != nullptr;
	++vertexNum_;
}

void MeshPieceBytes::addFace(const std::int64_t* corners, std::size_t num)
{
	if (num < 3) {
		++tooSmallNum_;
		return;
	}
	appendValue(PlyType::UInt32, double(num), faces_);
	for (std::size_t k = 0; k < num; ++k) {
		appendValue(PlyType::UInt32, double(corners[k]), faces_);
		largestIndex_ = std::max(largestIndex_, std::uint64_t(corners[k]));
	}
	mostCorners_ = std::max<std::uint64_t>(mostCorners_, num);
	++faceNum_;
}

MeshSpill::MeshSpill(const std::string& folder, const RunLimit& limit) :
		verticesPath_(folder + "/vertices"), facesPath_(folder + "/faces"), limit_(limit),
		vertices_(verticesPath_, limit), faces_(facesPath_, limit)
{
}

void MeshSpill::add(const MeshPieceBytes& piece)
{
	vertices_.text(piece.vertices_);
	faces_.text(piece.faces_);
	all_.vertexNum_ += piece.vertexNum_;
	all_.colourNum_ += piece.colourNum_;
	all_.faceNum_ += piece.faceNum_;
	all_.tooSmallNum_ += piece.tooSmallNum_;
	all_.largestIndex_ = std::max(all_.largestIndex_, piece.largestIndex_);
	all_.mostCorners_  = std::max(all_.mostCorners_, piece.mostCorners_);
	all_.largest_      = std::max(all_.largest_, piece.largest_);
}

/// The layout of the two files, which have no header: each file is read as a PLY file without the
/// records of the other file.
PlyRecordLayout MeshSpill::layoutAside() const
{
	PlyRecordLayout layout =
		layoutOf(headerText({PlyType::Float64, PlyType::UInt32, PlyType::UInt32}, true,
							all_.vertexNum_, all_.faceNum_));
	layout.header.byteNum = 0;
	return layout;
}

double MeshSpill::meanEdgeOfSample() const
{
	constexpr std::uint64_t sampleNum = 10000;
	constexpr std::size_t   onePage   = 4096;
	const std::uint64_t     step      = std::max<std::uint64_t>(1, all_.faceNum_ / sampleNum);
	const PlyRecordLayout   layout    = layoutAside();
	PlyRecordReader         faces(facesPath_, layout), vertices(verticesPath_, layout, onePage);
	FaceRecord              face;
	std::vector<Vec3d>      corners;
	double                  sum = 0;
	std::uint64_t           num = 0;
	for (std::uint64_t f = 0; f < all_.faceNum_; ++f) {
		if ((f & pollMask) == 0) limit_.check();
		faces.nextFace(face);
		if (f % step != 0) continue;
		corners.clear();
		for (const std::int64_t v : face.corners) {
			vertices.toVertices(std::uint64_t(v));
			corners.push_back(positionIn(vertices.nextVertex(), layout));
		}
		addEdges(corners, sum, num);
	}
	return num > 0 ? sum / double(num) : 0;
}

bool MeshSpill::floatsWillDo() const
{
	return floatResolves(all_.largest_, meanEdgeOfSample());
}

std::string MeshSpill::header(bool asFloats) const
{
	constexpr std::uint64_t mostOfChar = 255, mostOfInt = std::numeric_limits<std::int32_t>::max();
	const Types             types = {asFloats ? PlyType::Float32 : PlyType::Float64,
                         all_.mostCorners_ <= mostOfChar ? PlyType::UInt8 : PlyType::UInt32,
						 all_.vertexNum_ <= mostOfInt ? PlyType::Int32 : PlyType::UInt32};
	return headerText(types, isColoured(), all_.vertexNum_, all_.faceNum_);
}

std::vector<std::string> MeshSpill::writePly(const std::string& path)
{
	vertices_.commit();
	faces_.commit();
	if (all_.faceNum_ == 0)
		failInput("the file has no faces (" + std::to_string(all_.vertexNum_) + " vertices)");
	if (all_.largestIndex_ >= all_.vertexNum_) failNoSuchVertex(all_.vertexNum_);
	const std::string     text   = header(floatsWillDo());
	const PlyRecordLayout layout = layoutOf(text);
	OutputFile            out(path, limit_);
	out.text(text);
	writeVertices(layout, out);
	writeFaces(layout, out);
	out.commit();
	if (all_.tooSmallNum_ == 0) return {};
	return {tooSmallFacesNote(all_.tooSmallNum_)};
}

void MeshSpill::writeVertices(const PlyRecordLayout& layout, OutputFile& out) const
{
	const PlyRecordLayout aside = layoutAside();
	PlyRecordReader       reader(verticesPath_, aside);
	std::string           bytes;
	for (std::uint64_t v = 0; v < all_.vertexNum_; ++v) {
		const char* const record   = reader.nextVertex();
		const Vec3d       position = positionIn(record, aside);
		bytes.clear();
		for (const double c : {position.x, position.y, position.z})
			appendValue(layout.coordinateType[0], c, bytes);
		if (isColoured()) bytes.append(record + aside.vertexBytes - colourBytes, colourBytes);
		out.text(bytes);
	}
}

void MeshSpill::writeFaces(const PlyRecordLayout& layout, OutputFile& out) const
{
	const PlyRecordLayout aside = layoutAside();
	PlyRecordReader       reader(facesPath_, aside);
	FaceRecord            face;
	std::string           bytes;
	for (std::uint64_t f = 0; f < all_.faceNum_; ++f) {
		reader.nextFace(face);
		bytes.clear();
		appendFace(face, layout, bytes);
		out.text(bytes);
	}
}

} // namespace gpr::app
