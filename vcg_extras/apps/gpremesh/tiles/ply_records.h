// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_PLY_RECORDS_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_PLY_RECORDS_H

#include <vcg_extras/core/vec.h>
#include <vcg_extras/io/formats/ply_header.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

// Reads a binary PLY file of any size record by record, without holding the file in memory.

namespace gpr::app {

/// The content of a file, and its layout.
struct PlyRecordLayout {
	PlyHeader         header;
	const PlyElement& vertices() const { return header.elements[vertexElement]; }
	const PlyElement& faces() const { return header.elements[faceElement]; }

	std::size_t vertexElement = 0, faceElement = 0;
	std::size_t vertexBytes       = 0;  ///< of a record
	std::size_t coordinateAt[3]   = {}; ///< in a record of a vertex
	PlyType     coordinateType[3] = {};
	std::size_t indexList         = 0; ///< the property of the faces with their vertices
	std::string comments;              ///< lines of the header about textures
	bool        isSwapped = false;     ///< the byte order is not the machine's

	bool isText() const { return header.format == PlyFormat::Ascii; }
};

/// The layout of a header, or of a file's begin. Throws AppError (BadInput) for contents that
/// cannot be read record by record: triangle strips, vertices with lists, vertices behind faces.
PlyRecordLayout layoutOf(std::string_view header);

/// The layout of a binary or ASCII file. Sentences of errors name the file.
PlyRecordLayout readPlyLayout(const std::string& path);

/// As readPlyLayout, but throws AppError (BadInput) for text, too.
PlyRecordLayout readRecordLayout(const std::string& path);

/// Appends a value as in a file of the machine's byte order, see wholeOfRange.
void appendValue(PlyType type, double value, std::string& out);

/// Position in a vertex record of PlyRecordReader.
Vec3d positionIn(const char* vertexRecord, const PlyRecordLayout& layout);

/// The header of a binary file in the machine's byte order.
PlyHeader ownHeader(std::vector<PlyElement> elements);

/// The lines of a header for these elements, with the names and types of the file and the given
/// counts.
std::string headerText(const PlyRecordLayout& layout, std::uint64_t vertexNum,
					   std::uint64_t faceNum);

/// Whether vertices and faces have the same properties, in the same order.
bool haveSameProperties(PlyRecordLayout a, PlyRecordLayout b);

/// A face: its vertices, and the bytes of its other properties, in their order.
struct FaceRecord {
	std::vector<std::int64_t> corners;
	std::string               before, after; ///< the list of corners
};
/// Appends a face to `out` as in a file with the same properties.
void appendFace(const FaceRecord& face, const PlyRecordLayout& layout, std::string& out);

/// Records between two checks of the run limit.
constexpr std::uint64_t pollMask = 0xffff;

/// Bytes read at once.
constexpr std::size_t usualBufferBytes = std::size_t(1) << 22;

/// Reads the records of a file in their order, converted to the machine's byte order.
class PlyRecordReader {
public:
	PlyRecordReader(const std::string& path, const PlyRecordLayout& layout,
					std::size_t bufferBytes = usualBufferBytes);

	/// Moves to vertex number i.
	void toVertices(std::uint64_t i = 0) { toRecord(layout_.vertexElement, i); }
	/// Moves to the first face.
	void toFaces() { toRecord(layout_.faceElement, 0); }
	/// The next vertex; valid until the next call.
	const char* nextVertex();
	void        nextFace(FaceRecord& face);

private:
	std::string            path_;
	std::uint64_t          fileBytes_;
	const PlyRecordLayout& layout_;
	std::ifstream          file_;
	std::vector<char>      buffer_;
	std::size_t            at_ = 0, end_ = 0;

	/// Moves to record i of an element, which needs records of a known length before.
	void  toRecord(std::size_t element, std::uint64_t i);
	char* takeBytes(std::size_t num);
	/// Consecutive values.
	char*             takeValues(PlyType type, std::size_t num);
	std::size_t       listLength(const PlyProperty& list);
	void              copyList(const PlyProperty& list, std::string& to);
	[[noreturn]] void failCut() const;
};

} // namespace gpr::app

#endif
