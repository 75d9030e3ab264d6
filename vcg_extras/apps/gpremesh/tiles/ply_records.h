// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_PLY_RECORDS_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_PLY_RECORDS_H

#include <vcg_extras/core/vec.h>
#include <vcg_extras/io/formats/ply_header.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// Reading a binary PLY file of any size record by record, without holding it in memory.

namespace gpr::app {

/// What a file holds, and where.
struct PlyRecordLayout {
	PlyHeader         header;
	const PlyElement& vertices() const { return header.elements[vertexElement]; }
	const PlyElement& faces() const { return header.elements[faceElement]; }

	std::size_t vertexElement = 0, faceElement = 0;
	std::size_t vertexBytes       = 0;  ///< of one record
	std::size_t coordinateAt[3]   = {}; ///< in a record of a vertex
	PlyType     coordinateType[3] = {};
	std::size_t indexList         = 0; ///< the property of the faces that holds their vertices
	std::string comments;              ///< lines of the header that tell of textures
	bool        isSwapped = false;     ///< the byte order is not the machine's

	bool isText() const { return header.format == PlyFormat::Ascii; }
};

/// Of a header, or of a file that begins with it. Throws AppError (BadInput) where its order cannot
/// be followed record by record: triangle strips, vertices with lists, vertices behind faces.
PlyRecordLayout layoutOf(std::string_view header);

/// Of a binary or ASCII file. The sentences of errors name it.
PlyRecordLayout readPlyLayout(const std::string& path);

/// Throws AppError (BadInput) for text, too.
PlyRecordLayout readRecordLayout(const std::string& path);

/// Appends a value as a file in the machine's byte order holds it, see wholeOfRange.
void appendValue(PlyType type, double value, std::string& out);

/// Of a record that PlyRecordReader gives.
Vec3d positionIn(const char* vertexRecord, const PlyRecordLayout& layout);

/// Of a binary file in the machine's byte order.
PlyHeader ownHeader(std::vector<PlyElement> elements);

/// The lines of a header for these elements, in the file's names and types; counts as given.
std::string headerText(const PlyRecordLayout& layout, std::uint64_t vertexNum,
					   std::uint64_t faceNum);

/// One face: its vertices, and the bytes of what else it has, in the order of its properties.
struct FaceRecord {
	std::vector<std::int64_t> corners;
	std::string               before, after; ///< the list of corners
};
/// Appends a face to `out` as a file with the same properties holds it.
void appendFace(const FaceRecord& face, const PlyRecordLayout& layout, std::string& out);

/// As much is read at once.
constexpr std::size_t usualBufferBytes = std::size_t(1) << 22;

/// Goes through the records of a file in their order. They come in the machine's byte order.
class PlyRecordReader {
public:
	PlyRecordReader(const std::string& path, const PlyRecordLayout& layout,
					std::size_t bufferBytes = usualBufferBytes);
	~PlyRecordReader();
	PlyRecordReader(const PlyRecordReader&)            = delete;
	PlyRecordReader& operator=(const PlyRecordReader&) = delete;

	/// To the first vertex, from there to vertex number i.
	void toVertices(std::uint64_t i = 0);
	/// From the first vertex past the last one.
	void skipVertices() { skipElement(layout_.vertices()); }
	/// Behind the last vertex: to the first face. Reads what lies between.
	void toFaces();
	/// The next vertex; valid until the next call.
	const char* nextVertex();
	void        nextFace(FaceRecord& face);

private:
	std::string            path_;
	std::uint64_t          fileBytes_;
	const PlyRecordLayout& layout_;
	std::FILE*             file_ = nullptr;
	std::vector<char>      buffer_;
	std::size_t            at_ = 0, end_ = 0;

	const char* take(std::size_t num) { return takeBytes(num); }
	char*       takeBytes(std::size_t num);
	/// Values that lie one after the other.
	char*             takeValues(PlyType type, std::size_t num);
	std::size_t       listLength(const PlyProperty& list);
	void              copyList(const PlyProperty& list, std::string& to);
	void              skipElement(const PlyElement& element);
	void              seek(std::uint64_t offset);
	[[noreturn]] void failCut() const;
};

} // namespace gpr::app

#endif
