// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_HEADER_H
#define VCG_EXTRAS_IO_FORMATS_PLY_HEADER_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace gpr::app {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes of a value of this type in a binary file.
std::size_t plyTypeSize(PlyType type);
bool        isInteger(PlyType type);
/// The name in a header: "uchar", "int", "float".
const char* plyTypeName(PlyType type);

/// A value as a whole number of a type: without the digits after the point, cut to the range, 0 for
/// NaN.
template <class T>
T wholeOfRange(double value)
{
	const double least = double(std::numeric_limits<T>::min());
	const double most  = double(std::numeric_limits<T>::max());
	return value == value ? T(std::clamp(value, least, most)) : T(0);
}

/// Calls visit() with a value of a type.
template <class Visit>
auto withType(PlyType type, const Visit& visit)
{
	switch (type) {
	case PlyType::Int8:
		return visit(std::int8_t());
	case PlyType::UInt8:
		return visit(std::uint8_t());
	case PlyType::Int16:
		return visit(std::int16_t());
	case PlyType::UInt16:
		return visit(std::uint16_t());
	case PlyType::Int32:
		return visit(std::int32_t());
	case PlyType::UInt32:
		return visit(std::uint32_t());
	case PlyType::Float32:
		return visit(float());
	case PlyType::Float64:
		break;
	}
	return visit(double());
}

/// Gives a value to `put` in a type, see wholeOfRange.
template <class Put>
void putAs(PlyType type, double value, const Put& put)
{
	withType(type, [&](auto zero) {
		using T = decltype(zero);
		if constexpr (std::is_integral_v<T>)
			put(wholeOfRange<T>(value));
		else
			put(T(value));
	});
}

/// vcglib's bit of a selected vertex or face in the property "flags".
constexpr std::int64_t selectedPlyFlag = 0x20;

struct PlyProperty {
	std::string name;
	PlyType     type      = PlyType::Float32; ///< of the value, or of a list's values
	bool        isList    = false;
	PlyType     countType = PlyType::UInt8; ///< lists only
};

struct PlyElement {
	std::string              name;
	std::uint64_t            count = 0;
	std::vector<PlyProperty> properties;

	bool hasList() const;
	/// Index of the property with this name, or -1.
	int find(std::string_view propertyName) const;
	/// The least bytes of a record in a binary file: every list empty.
	std::size_t smallestRecordBytes() const;
};

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
	PlyFormat               format = PlyFormat::Ascii;
	std::vector<PlyElement> elements;
	std::size_t             byteNum = 0; ///< of the header, its last line break included
	std::size_t             lineNum = 0;
};

/// Reads the header of a PLY file. The length of a header is bounded, so a file without an end of
/// header ends soon. Throws AppError (BadInput) on anything unknown to the format.
PlyHeader readPlyHeader(std::string_view file);

/// Vertices with x, y and z; faces with their corners.
PlyElement elementWithPositions(PlyType coordinate, std::uint64_t count);
PlyElement elementOfFaces(PlyType cornerNum, PlyType corner, std::uint64_t count);

/// The text of a header; comments: whole lines to include.
std::string plyHeaderText(const PlyHeader& header, const std::string& comments);

/// The begin of a comment that names the value i of a property of faces.
std::string nameComment(const std::string& property);

// ---- the place of the mesh
//
// The mesh lies among any other content. All these functions throw AppError (BadInput) if the mesh
// cannot be found.

/// Refuses a header with a repeated element of vertices, faces or strips.
void checkElements(const PlyHeader& header);

/// Nothing after the last element of the three is read: files with damaged extras still serve.
std::size_t usefulElementNum(const PlyHeader& header);

/// Which of an element's properties are the coordinates.
struct CoordinateProperties {
	int x = -1, y = -1, z = -1;
};

CoordinateProperties findCoordinates(const PlyElement& e);

/// Whether x, y or z is stored as double or as a whole number of 32 bits.
bool needsDouble(const PlyElement& e, const CoordinateProperties& c);

/// The number of the property with the vertices of a face or strip.
int findIndexList(const PlyElement& e);

/// For an element with more records than the rest of the file can hold.
[[noreturn]] void failTruncated(const PlyElement& e);

} // namespace gpr::app

#endif
