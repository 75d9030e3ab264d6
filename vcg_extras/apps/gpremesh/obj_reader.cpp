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

/// Takes a line with those that it goes on with; `joined` holds it where there are some.
std::string_view takeWholeLine(std::string_view& text, std::string& joined)
{
	std::string_view line = takeLine(text);
	if (!goesOn(line)) return line;
	joined.clear();
	while (goesOn(line)) {
		joined.append(line.substr(0, line.rfind('\\')));
		joined += ' ';
		line = takeLine(text);
	}
	joined.append(line);
	return joined;
}

std::size_t countVertices(std::string_view piece)
{
	std::size_t num = 0;
	std::string joined;
	while (!piece.empty())
		num += Words(takeWholeLine(piece, joined)).next() == "v";
	return num;
}

/// What follows the first index of a corner: more of them, which are not looked at.
bool isRestOfCorner(std::string_view rest)
{
	return std::all_of(rest.begin(), rest.end(), [](char c) {
		return c == '/' || c == '-' || c == '+' || (c >= '0' && c <= '9');
	});
}

/// One piece of a file.
class ObjPiece {
public:
	std::vector<double> coordinates; ///< three a vertex
	FaceList            faces;
	bool                holdsMore = false;   ///< see readObj
	const char*         badPlace  = nullptr; ///< the line that cannot be read; null: there is none

	/// before: vertices of the pieces before.
	void read(std::string_view text, std::size_t before)
	{
		before_ = before;
		std::string joined;
		while (!text.empty()) {
			const char* const place = text.data();
			if (readLine(withoutComment(takeWholeLine(text, joined)))) continue;
			badPlace = place;
			return;
		}
	}

private:
	std::size_t               before_ = 0;
	std::vector<std::int64_t> corners_;

	bool readLine(std::string_view line)
	{
		Words                  words(line);
		const std::string_view keyword = words.next();
		if (keyword == "v") return readVertex(words);
		if (keyword == "f") return readFace(words);
		holdsMore |=
			keyword == "vt" || keyword == "vn" || keyword == "usemtl" || keyword == "mtllib";
		return true;
	}

	bool readVertex(Words& words)
	{
		for (int k = 0; k < 3; ++k) {
			double c = 0;
			if (!words.nextCoordinate(c)) return false;
			coordinates.push_back(c);
		}
		holdsMore = holdsMore || !words.isAtEnd();
		return true;
	}

	bool readFace(Words& words)
	{
		corners_.clear();
		for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
			const std::size_t slash = std::min(word.find('/'), word.size());
			std::int64_t      index = 0;
			if (!parseInteger(word.substr(0, slash), index)) return false;
			if (!isRestOfCorner(word.substr(slash))) return false;
			corners_.push_back(index > 0 ? index - 1 : fromEnd(index));
		}
		faces.add(corners_.data(), corners_.size());
		return true;
	}

	/// Below 0, which no vertex has, where there are not as many.
	std::int64_t fromEnd(std::int64_t index) const
	{
		return index < 0 ? std::int64_t(before_ + coordinates.size() / 3) + index : -1;
	}
};

[[noreturn]] void failAt(std::string_view file, const char* place)
{
	throw AppError(ExitCode::BadInput,
				   "line " + std::to_string(lineNumber(file, place)) + ": " + badNumber);
}

} // namespace

InputMesh readObj(std::string_view file)
{
	bool holdsMore = false;
	return readObj(file, holdsMore);
}

InputMesh readObj(std::string_view file, bool& holdsMore)
{
	const std::vector<std::string_view> text = linePieces(file, true);
	std::vector<ObjPiece>               pieces(text.size());
	Workers                             workers(0, nullptr);
	const std::vector<std::size_t>      before = recordsBefore(text, countVertices, workers);
	workers.forTasks(text.size(), [&](std::size_t i, int) { pieces[i].read(text[i], before[i]); });

	InputMesh mesh;
	FaceList  faces;
	holdsMore            = false;
	mesh.doublePrecision = true;
	mesh.doubles.reserve(3 * before.back());
	for (ObjPiece& piece : pieces) {
		if (piece.badPlace != nullptr) failAt(file, piece.badPlace);
		mesh.doubles.insert(mesh.doubles.end(), piece.coordinates.begin(), piece.coordinates.end());
		faces.append(piece.faces);
		holdsMore = holdsMore || piece.holdsMore;
		piece     = ObjPiece(); // gives its memory back
	}
	faces.finish(mesh);
	settlePrecision(mesh);
	return mesh;
}

} // namespace gpr::app
