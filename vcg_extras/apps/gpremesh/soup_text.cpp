// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "soup_text.h"

#include "exit_code.h"
#include "number_text.h"
#include "ply_layout.h"

#include <algorithm>
#include <boost/interprocess/streams/bufferstream.hpp>
#include <istream>

namespace gpr::app {

namespace {

using MemoryStream = boost::interprocess::ibufferstream;

constexpr const char* nonFiniteMarkText = "1.7976931348623157e308";

[[noreturn]] void fail(const std::string& sentence)
{
	throw AppError(ExitCode::BadInput, sentence);
}

char lower(char c)
{
	return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

bool isBlank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isNonFiniteWord(std::string_view word)
{
	if (word.size() < 3) return false;
	const char begin[] = {lower(word[0]), lower(word[1]), lower(word[2]), 0};
	return std::string_view(begin) == "nan" || std::string_view(begin) == "inf";
}

/// Appends text with the words nan, inf and the like replaced by the mark.
void appendFinite(std::string_view text, std::string& out)
{
	std::size_t done = 0;
	for (std::size_t i = 0; i < text.size(); ++i) {
		const bool letter = lower(text[i]) == 'n' || lower(text[i]) == 'i';
		if (!letter) continue;
		const bool        isSigned = i > 0 && (text[i - 1] == '-' || text[i - 1] == '+');
		const std::size_t begin    = isSigned ? i - 1 : i;
		if (begin > 0 && !isBlank(text[begin - 1])) continue;
		const std::size_t end = std::min(text.find_first_of(" \t\r\n", i), text.size());
		if (!isNonFiniteWord(text.substr(i, end - i))) continue;
		out.append(text, done, begin - done);
		out += nonFiniteMarkText;
		done = i = end;
	}
	out.append(text, done);
}

// ---- OBJ

/// Tabs and carriage returns as blanks, and a backslash at the end of a line joins the next one.
std::string joinedLines(std::string_view file)
{
	std::string text(file);
	std::replace_if(
		text.begin(), text.end(), [](char c) { return c != '\n' && isBlank(c); }, ' ');
	for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1)) {
		const std::size_t last = text.find_last_not_of(' ', end > 0 ? end - 1 : 0);
		if (end > 0 && last != text.npos && text[last] == '\\') text[last] = text[end] = ' ';
	}
	return text;
}

std::size_t wordNum(std::string_view line)
{
	std::size_t num = 0;
	for (std::size_t i = 0; i < line.size(); ++i) {
		if (!isBlank(line[i]) && (i == 0 || isBlank(line[i - 1]))) ++num;
	}
	return num;
}

void addObjLine(std::string_view line, SoupText& soup)
{
	line = line.substr(0, line.find('#'));
	line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
	const std::string_view keyword = line.substr(0, line.find(' '));
	if (keyword == "v") {
		++soup.vertexNum;
		appendFinite(line, soup.text);
	}
	else if (keyword == "f") {
		++soup.faceNum;
		soup.cornerNum += wordNum(line) - 1;
		soup.text.append(line);
	}
	soup.text += '\n';
}

// ---- OFF

std::string nextWord(std::istream& in)
{
	std::string word;
	while (in >> word && word[0] == '#')
		std::getline(in, word);
	return in ? word : "";
}

void checkOffKeyword(const std::string& keyword)
{
	const std::size_t off = keyword.find("OFF");
	if (off == keyword.npos || off + 3 != keyword.size()) {
		fail("an OFF file must begin with the word OFF");
	}
	if (keyword.find_first_of("4n") != keyword.npos) {
		fail("OFF files of other than three dimensions are not read");
	}
}

std::size_t offCount(const std::string& word, std::size_t fileSize)
{
	std::int64_t count = 0;
	if (word == "BINARY") fail("binary OFF files are not read");
	if (!parseInteger(word, count))
		fail("bad OFF header: '" + word.substr(0, 30) + "' is no count");
	if (count < 0) fail("bad OFF header: a negative count");
	// A record takes at least a digit and a line break.
	if (std::uint64_t(count) > (fileSize + 1) / 2) {
		fail("the file ends too early: its header promises " + word + " records");
	}
	return std::size_t(count);
}

// ---- STL

/// Blanks out what follows the word solid or endsolid on its line.
void dropSolidNames(std::string& text)
{
	constexpr std::size_t wordLen = 5;
	for (std::size_t at = text.find("solid"); at != text.npos; at = text.find("solid", at)) {
		const std::size_t end = std::min(text.find('\n', at), text.size());
		std::fill(text.begin() + long(at + wordLen), text.begin() + long(end), ' ');
		at = end;
	}
}

std::size_t occurrenceNum(std::string_view text, std::string_view word)
{
	std::size_t num = 0;
	for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
		++num;
	return num;
}

bool solidIsClosed(std::string_view text)
{
	const std::size_t end = text.rfind("endsolid"), facet = text.rfind("facet");
	return end != text.npos && (facet == text.npos || facet < end);
}

// ---- PLY

bool isOneOf(const std::string& name, std::initializer_list<const char*> names)
{
	return std::find(names.begin(), names.end(), name) != names.end();
}

std::string asciiVertexElement(const PlyElement& e)
{
	std::string lines = "element vertex " + std::to_string(e.count) + "\n";
	for (const PlyProperty& p : e.properties) {
		const bool coordinate = isOneOf(p.name, {"x", "y", "z"});
		lines += p.isList ? "property list short double " : "property double ";
		lines += (coordinate ? p.name : "unused") + "\n";
	}
	return lines;
}

/// The length of a face or of an unused list is taken as a short: a damaged one cannot ask for much
/// memory then. Strips may be as long as the file.
std::string asciiFaceElement(const PlyElement& e)
{
	const int   indexList = findIndexList(e);
	std::string lines     = "element face " + std::to_string(e.count) + "\n";
	for (int i = 0; i < int(e.properties.size()); ++i) {
		if (i == indexList) {
			lines += e.name == "face" ? "property list short" : "property list int";
			lines += " int vertex_indices\n";
		}
		else {
			lines += e.properties[i].isList ? "property list short double" : "property double";
			lines += " unused\n";
		}
	}
	return lines;
}

std::string asciiOtherElement(const PlyElement& e)
{
	std::string lines = "element unused " + std::to_string(e.count) + "\n";
	for (const PlyProperty& p : e.properties) {
		lines += p.isList ? "property list short double unused\n" : "property double unused\n";
	}
	return lines;
}

} // namespace

SoupText prepareObj(std::string_view file)
{
	SoupText          soup;
	const std::string text = joinedLines(file);
	soup.text.reserve(text.size() + 1);
	for (std::size_t begin = 0; begin < text.size();) {
		const std::size_t end = std::min(text.find('\n', begin), text.size());
		addObjLine(std::string_view(text).substr(begin, end - begin), soup);
		begin = end + 1;
	}
	return soup;
}

SoupText prepareOff(std::string_view file)
{
	SoupText     soup;
	MemoryStream in(file.data(), file.size());
	checkOffKeyword(nextWord(in));
	soup.vertexNum = offCount(nextWord(in), file.size());
	soup.faceNum   = offCount(nextWord(in), file.size());
	std::string edges; // of no use and often left out
	std::getline(in, edges);
	if (!in) fail("the file ends too early; it seems to be cut off");
	const std::size_t bodyBegin = in.eof() ? file.size() : std::size_t(in.tellg());
	const auto        lineNum   = std::count(file.begin(), file.begin() + long(bodyBegin), '\n');

	soup.text =
		"OFF " + std::to_string(soup.vertexNum) + " " + std::to_string(soup.faceNum) + " 0\n";
	soup.lineNumShift = std::size_t(lineNum) - 1;
	appendFinite(file.substr(bodyBegin), soup.text);
	return soup;
}

SoupText prepareAsciiStl(std::string_view file)
{
	SoupText soup;
	appendFinite(file, soup.text);
	std::transform(soup.text.begin(), soup.text.end(), soup.text.begin(), lower);
	dropSolidNames(soup.text);
	soup.faceNum = occurrenceNum(soup.text, "endloop");
	soup.ended   = solidIsClosed(soup.text);
	if (!soup.ended) soup.text += "\nendsolid\n";
	// CGAL tries the binary form on a text that it could not read: let the count there be absurd.
	soup.text.append(100, ' ');
	return soup;
}

SoupText prepareAsciiPly(const PlyHeader& header, std::string_view body)
{
	SoupText          soup;
	const std::size_t num = usefulElementNum(header);
	soup.text             = "ply\nformat ascii 1.0\n";
	for (std::size_t i = 0; i < num; ++i) {
		const PlyElement& e = header.elements[i];
		if (e.properties.empty() || e.count == 0) continue;
		// Each value takes a digit and a separator, the very last one no separator.
		if (e.count > (body.size() + 1) / (2 * e.properties.size())) failTruncated(e);
		const bool faces = isOneOf(e.name, {"face", "tristrips"});
		if (e.name == "vertex") {
			soup.vertexNum       = std::size_t(e.count);
			soup.doublePrecision = needsDouble(e, findCoordinates(e));
		}
		if (e.name == "tristrips") {
			soup.stripBegin = soup.faceNum;
			soup.stripNum   = std::size_t(e.count);
		}
		if (faces) soup.faceNum += std::size_t(e.count);
		soup.text += e.name == "vertex" ? asciiVertexElement(e)
					 : faces            ? asciiFaceElement(e)
										: asciiOtherElement(e);
	}
	soup.text += "end_header\n";
	soup.lineNumShift =
		header.lineNum - std::size_t(std::count(soup.text.begin(), soup.text.end(), '\n'));
	appendFinite(body, soup.text);
	return soup;
}

std::size_t lineAt(const SoupText& soup, std::size_t position)
{
	const std::size_t before = std::min(position, soup.text.size());
	const auto        end    = soup.text.begin() + long(before > 0 ? before - 1 : 0);
	return 1 + std::size_t(std::count(soup.text.begin(), end, '\n')) + soup.lineNumShift;
}

} // namespace gpr::app
