// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_header.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/text/number_text.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace gpr::app {

namespace {

constexpr std::size_t longestHeader = 1 << 20; // bytes; real headers have a few hundred

[[noreturn]] void fail(const std::string& sentence)
{
	failInput("bad PLY header: " + sentence);
}

std::vector<std::string> splitWords(std::string_view line)
{
	std::istringstream words{std::string(line)};
	return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
}

/// Returns the lines of the header. The first line decides how lines end: a binary file may go on
/// with a byte that looks like half a line break.
class HeaderLines {
public:
	explicit HeaderLines(std::string_view file) : text_(file.substr(0, longestHeader))
	{
		const std::size_t end = text_.find_first_of("\r\n");
		if (end == text_.npos) return;
		const bool pair = text_.substr(end, 2) == "\r\n";
		lineBreak_      = pair ? "\r\n" : std::string(1, text_[end]);
	}

	std::string_view next()
	{
		const std::size_t end = text_.find(lineBreak_, at_);
		if (end == text_.npos) fail("the header has no end");
		const std::string_view line = text_.substr(at_, end - at_);
		at_                         = end + lineBreak_.size();
		++lineNum_;
		return line;
	}

	std::size_t byteNum() const { return at_; }
	std::size_t lineNum() const { return lineNum_; }

private:
	std::string_view text_;
	std::string      lineBreak_ = "\n";
	std::size_t      at_        = 0;
	std::size_t      lineNum_   = 0;
};

/// By PlyFormat.
constexpr const char* formatWords[] = {"ascii", "binary_little_endian", "binary_big_endian"};

PlyFormat formatOf(const std::vector<std::string>& words)
{
	if (words.size() < 2) fail("the format line is incomplete");
	for (const PlyFormat format :
		 {PlyFormat::Ascii, PlyFormat::LittleEndian, PlyFormat::BigEndian}) {
		if (words[1] == formatWords[int(format)]) return format;
	}
	fail("unknown format");
}

struct TypeRow {
	const char *name, *newName;
	std::size_t bytes;
};

/// By PlyType.
constexpr TypeRow types[] = {
	{"char", "int8", 1}, {"uchar", "uint8", 1}, {"short", "int16", 2},   {"ushort", "uint16", 2},
	{"int", "int32", 4}, {"uint", "uint32", 4}, {"float", "float32", 4}, {"double", "float64", 8}};

PlyType typeOf(const std::string& word)
{
	for (const TypeRow& row : types) {
		if (word == row.name || word == row.newName) return PlyType(&row - types);
	}
	fail("unknown type of a property");
}

PlyElement elementOf(const std::vector<std::string>& words)
{
	std::int64_t count = 0;
	if (words.size() < 3 || !parseInteger(words[2], count) || count < 0) {
		fail("an element without a valid count");
	}
	PlyElement element;
	element.name  = words[1];
	element.count = std::uint64_t(count);
	return element;
}

PlyProperty propertyOf(const std::vector<std::string>& words)
{
	PlyProperty property;
	property.isList = words.size() >= 2 && words[1] == "list";
	if (words.size() < (property.isList ? 5u : 3u)) fail("an incomplete property");
	if (property.isList) {
		property.countType = typeOf(words[2]);
		property.type      = typeOf(words[3]);
		property.name      = words[4];
		if (!isInteger(property.countType)) fail("the length of a list must be a whole number");
	}
	else {
		property.type = typeOf(words[1]);
		property.name = words[2];
	}
	return property;
}

} // namespace

std::size_t plyTypeSize(PlyType type)
{
	return types[int(type)].bytes;
}

const char* plyTypeName(PlyType type)
{
	return types[int(type)].name;
}

bool isInteger(PlyType type)
{
	return type != PlyType::Float32 && type != PlyType::Float64;
}

bool PlyElement::hasList() const
{
	return std::any_of(properties.begin(), properties.end(),
					   [](const PlyProperty& p) { return p.isList; });
}

int PlyElement::find(std::string_view propertyName) const
{
	for (std::size_t i = 0; i < properties.size(); ++i) {
		if (properties[i].name == propertyName) return int(i);
	}
	return -1;
}

std::size_t PlyElement::smallestRecordBytes() const
{
	std::size_t bytes = 0;
	for (const PlyProperty& p : properties)
		bytes += plyTypeSize(p.isList ? p.countType : p.type);
	return bytes;
}

PlyHeader readPlyHeader(std::string_view file)
{
	HeaderLines lines(file);
	PlyHeader   header;
	bool        formatKnown = false;
	if (splitWords(lines.next()) != std::vector<std::string>{"ply"}) {
		fail("the first line is not 'ply'");
	}
	while (true) {
		const std::vector<std::string> words = splitWords(lines.next());
		if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
		if (words[0] == "end_header") break;
		if (words[0] == "format") {
			header.format = formatOf(words);
			formatKnown   = true;
		}
		else if (words[0] == "element") {
			header.elements.push_back(elementOf(words));
		}
		else if (words[0] == "property") {
			if (header.elements.empty()) fail("a property before the first element");
			header.elements.back().properties.push_back(propertyOf(words));
		}
		else {
			fail("an unknown line");
		}
	}
	if (!formatKnown) fail("there is no format line");
	header.byteNum = lines.byteNum();
	header.lineNum = lines.lineNum();
	return header;
}

PlyElement elementWithPositions(PlyType coordinate, std::uint64_t count)
{
	return {"vertex", count, {{"x", coordinate}, {"y", coordinate}, {"z", coordinate}}};
}

PlyElement elementOfFaces(PlyType cornerNum, PlyType corner, std::uint64_t count)
{
	return {"face", count, {{"vertex_indices", corner, true, cornerNum}}};
}

std::string plyHeaderText(const PlyHeader& header, const std::string& comments)
{
	std::string text =
		std::string("ply\nformat ") + formatWords[int(header.format)] + " 1.0\n" + comments;
	for (const PlyElement& element : header.elements) {
		text += "element " + element.name + " " + std::to_string(element.count) + "\n";
		for (const PlyProperty& p : element.properties) {
			text += "property ";
			if (p.isList) text += "list " + std::string(plyTypeName(p.countType)) + " ";
			text += std::string(plyTypeName(p.type)) + " " + p.name + "\n";
		}
	}
	return text + "end_header\n";
}

std::string nameComment(const std::string& property)
{
	return "comment name of " + property + " ";
}

void checkElements(const PlyHeader& header)
{
	for (const char* name : {"vertex", "face", "tristrips"}) {
		const auto num = std::count_if(header.elements.begin(), header.elements.end(),
									   [&](const PlyElement& e) { return e.name == name; });
		if (num > 1) failInput("its header has the element '" + std::string(name) + "' twice");
	}
}

std::size_t usefulElementNum(const PlyHeader& header)
{
	std::size_t num = 0;
	for (std::size_t i = 0; i < header.elements.size(); ++i) {
		const std::string& name = header.elements[i].name;
		if (name == "vertex" || name == "face" || name == "tristrips") num = i + 1;
	}
	return num;
}

CoordinateProperties findCoordinates(const PlyElement& e)
{
	const CoordinateProperties c{e.find("x"), e.find("y"), e.find("z")};
	for (const int i : {c.x, c.y, c.z}) {
		if (i < 0 || e.properties[i].isList) failInput("its vertices have no x, y and z");
	}
	return c;
}

bool needsDouble(const PlyElement& e, const CoordinateProperties& c)
{
	for (const int i : {c.x, c.y, c.z}) {
		const PlyType type = e.properties[i].type;
		if (type == PlyType::Float64 || type == PlyType::Int32 || type == PlyType::UInt32) {
			return true;
		}
	}
	return false;
}

int findIndexList(const PlyElement& e)
{
	for (const char* name : {"vertex_indices", "vertex_index"}) {
		const int i = e.find(name);
		if (i >= 0 && e.properties[i].isList && isInteger(e.properties[i].type)) return i;
	}
	failInput("its element '" + e.name + "' has no list of vertex indices");
}

void failTruncated(const PlyElement& e)
{
	failInput("the file ends too early: its header promises " + std::to_string(e.count) +
			  " records of '" + e.name + "'");
}

} // namespace gpr::app
