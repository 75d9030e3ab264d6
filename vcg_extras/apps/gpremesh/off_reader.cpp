// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exit_code.h"
#include "face_list.h"
#include "number_text.h"
#include "precision.h"
#include "soup_io.h"
#include "text_lines.h"

#include <algorithm>

namespace gpr::app {

namespace {

[[noreturn]] void fail(const std::string& sentence)
{
	throw AppError(ExitCode::BadInput, sentence);
}

void checkKeyword(std::string_view keyword)
{
	const std::size_t off = keyword.find("OFF");
	if (off == keyword.npos || off + 3 != keyword.size())
		fail("an OFF file must begin with the word OFF");
	if (keyword.find_first_of("4n") != keyword.npos)
		fail("OFF files of other than three dimensions are not read");
}

std::size_t countOf(std::string_view word, std::size_t fileSize)
{
	std::int64_t count = 0;
	if (word == "BINARY") fail("binary OFF files are not read");
	if (!parseInteger(word, count))
		fail("bad OFF header: '" + std::string(word.substr(0, 30)) + "' is no count");
	if (count < 0) fail("bad OFF header: a negative count");
	// A record takes at least a digit and a line break.
	if (std::uint64_t(count) > (fileSize + 1) / 2)
		fail("the file ends too early: its header promises " + std::string(word) + " records");
	return std::size_t(count);
}

/// What comes before the records. The number of edges is of no use, and often left out.
struct Header {
	std::size_t      vertexNum = 0, faceNum = 0;
	std::string_view body;
};

Header readHeader(std::string_view file)
{
	Header                        header;
	std::vector<std::string_view> found;
	std::string_view              rest = file;
	while (found.size() < 3 && !rest.empty()) {
		Words words(withoutComment(takeLine(rest)));
		for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
			found.push_back(word);
			if (found.size() == 1) checkKeyword(word);
			if (found.size() == 2) header.vertexNum = countOf(word, file.size());
			if (found.size() == 3) header.faceNum = countOf(word, file.size());
		}
	}
	if (found.empty()) checkKeyword({});
	if (found.size() < 3) fail("the file ends too early; it seems to be cut off");
	header.body = rest;
	return header;
}

bool isRecord(std::string_view line)
{
	return !Words(withoutComment(line)).isAtEnd();
}

std::size_t countRecords(std::string_view piece)
{
	std::size_t num = 0;
	while (!piece.empty())
		num += isRecord(takeLine(piece));
	return num;
}

/// One piece of a file.
class OffPiece {
public:
	FaceList    faces;
	const char* badPlace = nullptr; ///< the line that cannot be read; null: there is none

	/// first: records of the pieces before.
	void read(std::string_view text, std::size_t first, const Header& header, double* coordinates)
	{
		std::size_t record = first;
		while (!text.empty() && record < header.vertexNum + header.faceNum) {
			const char* const      place = text.data();
			const std::string_view line  = withoutComment(takeLine(text));
			Words                  words(line);
			if (words.isAtEnd()) continue;
			const bool isGood = record < header.vertexNum
									? readVertex(words, coordinates + 3 * record)
									: readFace(words);
			++record;
			if (isGood) continue;
			badPlace = place;
			return;
		}
	}

private:
	std::vector<std::int64_t> corners_;

	static bool readVertex(Words& words, double* coordinates)
	{
		for (int k = 0; k < 3; ++k) {
			if (!words.nextCoordinate(coordinates[k])) return false;
		}
		return true;
	}

	/// The file's word for the number of corners is not trusted: no more are taken than there are.
	bool readFace(Words& words)
	{
		std::int64_t cornerNum = 0;
		if (!parseInteger(words.next(), cornerNum) || cornerNum < 0) return false;
		corners_.clear();
		for (std::int64_t k = 0; k < cornerNum; ++k) {
			std::int64_t index = 0;
			if (!parseInteger(words.next(), index)) return false;
			corners_.push_back(index);
		}
		faces.add(corners_.data(), corners_.size());
		return true;
	}
};

/// Names the line; the last one of a file may lack its end.
[[noreturn]] void failAt(std::string_view file, const char* place)
{
	const std::string_view from(place, std::size_t(file.data() + file.size() - place));
	std::string sentence = "line " + std::to_string(lineNumber(file, place)) + ": " + badNumber;
	if (from.find('\n') == from.npos) sentence += ", or the file ends too early";
	fail(sentence);
}

} // namespace

InputMesh readOff(std::string_view file)
{
	const Header                        header = readHeader(file);
	const std::vector<std::string_view> text   = linePieces(header.body);
	std::vector<OffPiece>               pieces(text.size());
	Workers                             workers(0, nullptr);
	const std::vector<std::size_t>      before = recordsBefore(text, countRecords, workers);

	InputMesh mesh;
	mesh.doublePrecision = true;
	mesh.doubles.resize(3 * std::min(header.vertexNum, before.back()));
	workers.forTasks(text.size(), [&](std::size_t i, int) {
		pieces[i].read(text[i], before[i], header, mesh.doubles.data());
	});
	FaceList faces;
	for (OffPiece& piece : pieces) {
		if (piece.badPlace != nullptr) failAt(file, piece.badPlace);
		faces.append(piece.faces);
		piece = OffPiece(); // gives its memory back
	}
	if (before.back() < header.vertexNum + header.faceNum) {
		fail("the file ends too early: its header promises " +
			 std::to_string(header.vertexNum + header.faceNum) + " records");
	}
	faces.finish(mesh);
	settlePrecision(mesh);
	return mesh;
}

} // namespace gpr::app
