// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_records.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/ply_source.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace gpr::app {

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why)
{
	failInput("'" + path + "' cannot be read in tiles: " + why);
}

std::uint64_t fileBytesOf(const std::string& path)
{
	std::error_code error;
	const auto      bytes = std::filesystem::file_size(path, error);
	return error ? 0 : bytes;
}

std::size_t elementNamed(const PlyHeader& header, const char* name)
{
	for (std::size_t i = 0; i < header.elements.size(); ++i) {
		if (header.elements[i].name == name) return i;
	}
	failInput("the file has no element '" + std::string(name) + "'.");
}

std::string textureComments(const std::string& header)
{
	std::istringstream lines(header);
	std::string        kept, line;
	while (std::getline(lines, line)) {
		if (!line.empty() && line.back() == '\r') line.pop_back();
		if (line.rfind("comment TextureFile", 0) == 0) kept += line + "\n";
	}
	return kept;
}

void findCoordinates(PlyRecordLayout& layout)
{
	const PlyElement&          e      = layout.vertices();
	const CoordinateProperties c      = findCoordinates(e);
	const int                  axes[] = {c.x, c.y, c.z};
	for (std::size_t i = 0; i < e.properties.size(); ++i) {
		for (int k = 0; k < 3; ++k) {
			if (axes[k] != int(i)) continue;
			layout.coordinateAt[k]   = layout.vertexBytes;
			layout.coordinateType[k] = e.properties[i].type;
		}
		layout.vertexBytes += plyTypeSize(e.properties[i].type);
	}
}

template <class T>
void append(T value, std::string& out)
{
	char bytes[sizeof(T)];
	std::memcpy(bytes, &value, sizeof(T));
	out.append(bytes, sizeof(T));
}

/// Reverses the bytes of each value.
void swapBytes(char* at, std::size_t each, std::size_t num)
{
	for (std::size_t i = 0; i < num; ++i, at += each)
		std::reverse(at, at + each);
}

void appendWhole(PlyType type, std::int64_t value, std::string& out)
{
	withType(type, [&](auto zero) { append(decltype(zero)(value), out); });
}

} // namespace

PlyRecordLayout layoutOf(std::string_view header)
{
	PlyRecordLayout layout;
	layout.header = readPlyHeader(header);
	checkElements(layout.header);
	layout.vertexElement = elementNamed(layout.header, "vertex");
	layout.faceElement   = elementNamed(layout.header, "face");
	if (layout.vertexElement > layout.faceElement) failInput("its faces come before its vertices.");
	if (layout.vertices().hasList()) failInput("its vertices have lists.");
	findCoordinates(layout);
	layout.indexList = std::size_t(findIndexList(layout.faces()));
	layout.comments  = textureComments(std::string(header.substr(0, layout.header.byteNum)));
	layout.isSwapped = !layout.isText() &&
					   (layout.header.format == PlyFormat::LittleEndian) != hostIsLittleEndian();
	return layout;
}

PlyRecordLayout readPlyLayout(const std::string& path)
{
	const std::string begin = beginOfFile(path);
	try {
		return layoutOf(begin);
	}
	catch (const AppError& error) {
		fail(path, error.what());
	}
}

PlyRecordLayout readRecordLayout(const std::string& path)
{
	PlyRecordLayout layout = readPlyLayout(path);
	if (layout.isText()) fail(path, "the file is a text. Convert the file to binary PLY.");
	return layout;
}

void appendValue(PlyType type, double value, std::string& out)
{
	putAs(type, value, [&](auto number) { append(number, out); });
}

Vec3d positionIn(const char* vertexRecord, const PlyRecordLayout& layout)
{
	double c[3];
	for (int k = 0; k < 3; ++k)
		c[k] = loadValue<double>(layout.coordinateType[k], vertexRecord + layout.coordinateAt[k],
								 false);
	return {c[0], c[1], c[2]};
}

PlyHeader ownHeader(std::vector<PlyElement> elements)
{
	return {hostIsLittleEndian() ? PlyFormat::LittleEndian : PlyFormat::BigEndian,
			std::move(elements)};
}

std::string headerText(const PlyRecordLayout& layout, std::uint64_t vertexNum,
					   std::uint64_t faceNum)
{
	PlyHeader header         = ownHeader({layout.vertices(), layout.faces()});
	header.elements[0].count = vertexNum;
	header.elements[1].count = faceNum;
	return plyHeaderText(header, layout.comments);
}

bool haveSameProperties(PlyRecordLayout a, PlyRecordLayout b)
{
	a.comments = b.comments = "";
	return headerText(a, 0, 0) == headerText(b, 0, 0);
}

void appendFace(const FaceRecord& face, const PlyRecordLayout& layout, std::string& out)
{
	const PlyProperty& list = layout.faces().properties[layout.indexList];
	out += face.before;
	appendWhole(list.countType, std::int64_t(face.corners.size()), out);
	for (std::int64_t corner : face.corners)
		appendWhole(list.type, corner, out);
	out += face.after;
}

PlyRecordReader::PlyRecordReader(const std::string& path, const PlyRecordLayout& layout,
								 std::size_t bufferBytes) :
		path_(path),
		fileBytes_(fileBytesOf(path)), layout_(layout), buffer_(bufferBytes)
{
	file_.rdbuf()->pubsetbuf(nullptr, 0); // buffered here
	file_.open(path, std::ios::binary);
	if (!file_) failInput("cannot read '" + path + "'");
}

void PlyRecordReader::toRecord(std::size_t element, std::uint64_t i)
{
	std::uint64_t offset = layout_.header.byteNum;
	for (std::size_t e = 0; e < element; ++e) {
		const PlyElement& before = layout_.header.elements[e];
		if (before.hasList()) fail(path_, "its element '" + before.name + "' has lists.");
		const std::uint64_t each = before.smallestRecordBytes();
		if (each > 0 && before.count > fileBytes_ / each) failCut();
		offset += before.count * each;
	}
	offset += i * layout_.header.elements[element].smallestRecordBytes();
	file_.clear(); // of the end of the file
	if (!file_.seekg(std::streamoff(offset))) fail(path_, "the file is a pipe or ends too early.");
	at_ = end_ = 0;
}

char* PlyRecordReader::takeBytes(std::size_t num)
{
	if (end_ - at_ < num) {
		if (num > fileBytes_) failCut();
		if (num > buffer_.size()) buffer_.resize(num);
		std::copy(buffer_.begin() + std::ptrdiff_t(at_), buffer_.begin() + std::ptrdiff_t(end_),
				  buffer_.begin());
		end_ -= at_;
		at_ = 0;
		file_.read(buffer_.data() + end_, std::streamsize(buffer_.size() - end_));
		end_ += std::size_t(file_.gcount());
		if (end_ < num) failCut();
	}
	char* const here = buffer_.data() + at_;
	at_ += num;
	return here;
}

void PlyRecordReader::failCut() const
{
	fail(path_, "the file ends too early and seems to be cut off.");
}

char* PlyRecordReader::takeValues(PlyType type, std::size_t num)
{
	const std::size_t each = plyTypeSize(type);
	char* const       at   = takeBytes(num * each);
	if (layout_.isSwapped) swapBytes(at, each, num);
	return at;
}

const char* PlyRecordReader::nextVertex()
{
	char* const record = takeBytes(layout_.vertexBytes);
	if (!layout_.isSwapped) return record;
	char* at = record;
	for (const PlyProperty& p : layout_.vertices().properties) {
		swapBytes(at, plyTypeSize(p.type), 1);
		at += plyTypeSize(p.type);
	}
	return record;
}

std::size_t PlyRecordReader::listLength(const PlyProperty& list)
{
	const auto num = loadValue<std::int64_t>(list.countType, takeValues(list.countType, 1), false);
	if (num < 0) fail(path_, "a list has a negative length.");
	return std::size_t(num);
}

void PlyRecordReader::copyList(const PlyProperty& list, std::string& to)
{
	const std::size_t num = listLength(list);
	appendWhole(list.countType, std::int64_t(num), to);
	to.append(takeValues(list.type, num), num * plyTypeSize(list.type));
}

void PlyRecordReader::nextFace(FaceRecord& face)
{
	face.corners.clear();
	face.before.clear();
	face.after.clear();
	const std::vector<PlyProperty>& properties = layout_.faces().properties;
	for (std::size_t i = 0; i < properties.size(); ++i) {
		const PlyProperty& p     = properties[i];
		std::string&       other = i < layout_.indexList ? face.before : face.after;
		if (!p.isList) {
			other.append(takeValues(p.type, 1), plyTypeSize(p.type));
		}
		else if (i != layout_.indexList) {
			copyList(p, other);
		}
		else {
			const std::size_t num  = listLength(p);
			const std::size_t each = plyTypeSize(p.type);
			const char* const at   = takeValues(p.type, num);
			for (std::size_t k = 0; k < num; ++k)
				face.corners.push_back(loadValue<std::int64_t>(p.type, at + k * each, false));
		}
	}
}

} // namespace gpr::app
