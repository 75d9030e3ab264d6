// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_attributes.h"

#include "exit_code.h"
#include "number_text.h"
#include "ply_layout.h"
#include "ply_source.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace gpr::app {

namespace {

constexpr std::int64_t selectedFlag = 0x20; ///< vcglib's bit, of vertices and faces alike

[[noreturn]] void fail(const std::string& sentence)
{
	throw AppError(ExitCode::BadInput, sentence);
}

/// The words of an ASCII file one after the other, with the interface of BinarySource.
class TextSource {
public:
	explicit TextSource(std::string_view body) : left_(body) {}

	double real(PlyType)
	{
		double value = 0;
		if (!parseNumber(nextWord(), value)) fail("a number is malformed or missing");
		return value;
	}
	std::int64_t whole(PlyType type)
	{
		const double value = real(type);
		if (!(std::abs(value) < 9e15)) fail("a number is malformed or missing");
		return std::int64_t(value);
	}

private:
	std::string_view left_;

	std::string_view nextWord()
	{
		constexpr const char* blanks = " \t\r\n\v\f";
		left_.remove_prefix(std::min(left_.find_first_not_of(blanks), left_.size()));
		const std::size_t      end  = std::min(left_.find_first_of(blanks), left_.size());
		const std::string_view word = left_.substr(0, end);
		left_.remove_prefix(end);
		return word;
	}
};

/// The number of a scalar property, or -1.
int findScalar(const PlyElement& e, const char* name)
{
	const int i = e.find(name);
	return i >= 0 && !e.properties[std::size_t(i)].isList ? i : -1;
}

/// One record of an element: its scalars by property, and the values of one list.
struct Record {
	std::vector<double>       scalars;
	std::vector<std::int64_t> list;
};

template <class Source>
void readList(const PlyProperty& p, bool kept, Source& source, Record& record)
{
	const std::int64_t num = source.whole(p.countType);
	if (kept) record.list.clear();
	// Value by value: a count beyond the end of the file ends there, before memory does.
	for (std::int64_t i = 0; i < num; ++i) {
		if (kept) {
			record.list.push_back(source.whole(p.type));
		}
		else {
			source.real(p.type);
		}
	}
}

template <class Source>
void readRecord(const PlyElement& e, int keptList, Source& source, Record& record)
{
	record.scalars.resize(e.properties.size());
	for (std::size_t i = 0; i < e.properties.size(); ++i) {
		const PlyProperty& p = e.properties[i];
		if (p.isList) {
			readList(p, int(i) == keptList, source, record);
		}
		else {
			record.scalars[i] = source.real(p.type);
		}
	}
}

/// Where an element's records say that they are selected.
class SelectionColumns {
public:
	explicit SelectionColumns(const PlyElement& e) :
			flags_(findScalar(e, "flags")), selected_(findScalar(e, "selected"))
	{
	}

	bool exist() const { return flags_ >= 0 || selected_ >= 0; }
	bool isSelected(const Record& record) const
	{
		if (selected_ >= 0 && record.scalars[std::size_t(selected_)] != 0) return true;
		if (flags_ < 0) return false;
		const double flags = record.scalars[std::size_t(flags_)];
		return std::abs(flags) < 4294967296.0 && (std::int64_t(flags) & selectedFlag) != 0;
	}

private:
	int flags_, selected_;
};

void checkPresent(const PlyHeader& header, const WantedAttributes& wanted)
{
	bool quality = false, selection = false;
	for (const PlyElement& e : header.elements) {
		const bool isVertex = e.name == "vertex";
		quality             = quality || (isVertex && findScalar(e, "quality") >= 0);
		if (isVertex || e.name == "face") selection = selection || SelectionColumns(e).exist();
	}
	if (wanted.quality && !quality) fail("its vertices have no property 'quality'");
	if (wanted.selection && !selection) {
		fail("its vertices and faces have neither the property 'selected' nor 'flags'");
	}
}

template <class Source>
void readVertices(const PlyElement& e, const WantedAttributes& wanted, Source& source,
				  InputMesh& mesh)
{
	const int              quality = wanted.quality ? findScalar(e, "quality") : -1;
	const SelectionColumns selection(e);
	Record                 record;
	for (std::uint64_t v = 0; v < e.count; ++v) {
		readRecord(e, -1, source, record);
		if (quality >= 0) mesh.quality.push_back(float(record.scalars[std::size_t(quality)]));
		if (wanted.selection && selection.isSelected(record)) mesh.selected[v] = 1;
	}
}

template <class Source>
void readFaces(const PlyElement& e, Source& source, InputMesh& mesh)
{
	const SelectionColumns selection(e);
	const int              corners = findIndexList(e);
	Record                 record;
	for (std::uint64_t f = 0; f < e.count; ++f) {
		readRecord(e, corners, source, record);
		if (!selection.isSelected(record)) continue;
		for (const std::int64_t v : record.list) {
			if (v >= 0 && std::uint64_t(v) < mesh.vertexNum()) mesh.selected[std::size_t(v)] = 1;
		}
	}
}

bool anySelected(const InputMesh& mesh)
{
	return std::find(mesh.selected.begin(), mesh.selected.end(), 1) != mesh.selected.end();
}

template <class Source>
void readElements(const PlyHeader& header, const WantedAttributes& wanted, Source source,
				  InputMesh& mesh)
{
	const std::size_t num = usefulElementNum(header);
	for (std::size_t i = 0; i < num; ++i) {
		const PlyElement& e = header.elements[i];
		Record            record;
		if (e.name == "vertex") {
			readVertices(e, wanted, source, mesh);
		}
		else if (e.name == "face" && wanted.selection && !anySelected(mesh)) {
			readFaces(e, source, mesh);
		}
		else {
			for (std::uint64_t r = 0; !e.properties.empty() && r < e.count; ++r)
				readRecord(e, -1, source, record);
		}
	}
}

} // namespace

void readPlyAttributes(std::string_view file, const WantedAttributes& wanted, InputMesh& mesh)
{
	const PlyHeader header = readPlyHeader(file);
	checkPresent(header, wanted);
	if (wanted.quality) mesh.quality.reserve(mesh.vertexNum());
	if (wanted.selection) mesh.selected.assign(mesh.vertexNum(), 0);
	const std::string_view body = file.substr(header.byteNum);
	if (header.format == PlyFormat::Ascii) {
		readElements(header, wanted, TextSource(body), mesh);
	}
	else {
		readElements(header, wanted, BinarySource(body, header.format == PlyFormat::LittleEndian),
					 mesh);
	}
}

} // namespace gpr::app
