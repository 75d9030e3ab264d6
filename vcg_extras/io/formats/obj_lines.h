// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_OBJ_LINES_H
#define VCG_EXTRAS_IO_FORMATS_OBJ_LINES_H

#include <vcg_extras/io/text/text_lines.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// The lines of OBJ files, for readers of whole files and for readers of blocks.

namespace gpr::app {

/// Takes a line with its continuation lines; `joined` holds the joined text of several lines.
std::string_view takeWholeLine(std::string_view& text, std::string& joined);

/// The number of lines with vertices.
std::size_t countObjVertices(std::string_view text);

/// The first index of a face's corner, from the begin, or below 0 from the end. Text after a slash
/// is not read. False for a malformed word.
bool readObjCorner(std::string_view word, std::int64_t& index);

/// The colour after the coordinates of a vertex, each 0 to 255. False without a colour.
bool readObjColour(Words& behindCoordinates, std::array<std::uint8_t, 3>& colour);

/// Throws AppError (BadInput) with the number of a line that cannot be read.
[[noreturn]] void failAtObjLine(std::size_t number);

/// Reads the lines of one piece of a file. The sink takes the records:
///   addVertex(const std::array<double, 3>&, Words& behind)
///   addFace(const std::int64_t* corners, std::size_t num)   from 0; below 0 for a missing vertex
///   addOther(std::string_view keyword)
template <class Sink>
class ObjPiece {
public:
	Sink        sink;
	const char* badPlace = nullptr; ///< the first unreadable line; null without such a line

	/// before: vertices of the pieces before.
	void read(std::string_view text, std::uint64_t before)
	{
		vertexNum_ = std::int64_t(before);
		std::string joined;
		while (!text.empty()) {
			const char* const place = text.data();
			if (readLine(withoutComment(takeWholeLine(text, joined)))) continue;
			badPlace = place;
			return;
		}
	}

private:
	std::int64_t              vertexNum_ = 0; ///< so far, vertices of earlier pieces included
	std::vector<std::int64_t> corners_;

	bool readLine(std::string_view line)
	{
		Words                  words(line);
		const std::string_view keyword = words.next();
		if (keyword == "v") return readVertex(words);
		if (keyword == "f") return readFace(words);
		sink.addOther(keyword);
		return true;
	}

	bool readVertex(Words& words)
	{
		std::array<double, 3> position{};
		for (double& c : position) {
			if (!words.nextCoordinate(c)) return false;
		}
		++vertexNum_;
		sink.addVertex(position, words);
		return true;
	}

	bool readFace(Words& words)
	{
		corners_.clear();
		for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
			std::int64_t index = 0;
			if (!readObjCorner(word, index)) return false;
			corners_.push_back(index > 0 ? index - 1 : fromEnd(index));
		}
		sink.addFace(corners_.data(), corners_.size());
		return true;
	}

	/// Below 0, which no vertex has, for an index beyond the begin.
	std::int64_t fromEnd(std::int64_t index) const { return index < 0 ? vertexNum_ + index : -1; }
};

/// Reads a text of whole lines, by all threads. before: vertices in front of the text.
template <class Sink>
std::vector<ObjPiece<Sink>> readObjPieces(std::string_view text, std::uint64_t before,
										  Workers& workers)
{
	const std::vector<std::string_view> pieces = linePieces(text, true);
	const std::vector<std::size_t>      inPiecesBefore =
		recordsBefore(pieces, countObjVertices, workers);
	std::vector<ObjPiece<Sink>> read(pieces.size());
	workers.forTasks(pieces.size(), [&](std::size_t i, int) {
		read[i].read(pieces[i], before + inPiecesBefore[i]);
	});
	return read;
}

} // namespace gpr::app

#endif
