// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_OFF_LINES_H
#define VCG_EXTRAS_IO_FORMATS_OFF_LINES_H

#include <vcg_extras/io/text/text_lines.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

// The lines of OFF files, for readers of whole files and for readers of blocks.

namespace gpr::app {

/// The header before the records. The number of edges is unused, and often left out.
struct OffHeader {
	std::size_t vertexNum = 0, faceNum = 0;
	std::size_t byteNum = 0; ///< of the header

	std::size_t recordNum() const { return vertexNum + faceNum; }
};

/// begin: of the file, all of the text or much more than the header. Throws AppError (BadInput).
OffHeader readOffHeader(std::string_view begin, std::uint64_t fileBytes);

/// Throws AppError (BadInput) if a file has fewer records than its header says.
void requireAllOffRecords(const OffHeader& header, std::uint64_t recordNum);

/// Throws AppError (BadInput) with the number of an unreadable line. text: the text with the line,
/// after so many lines of the file. The last line of a file may lack its end.
[[noreturn]] void failAtOffLine(std::string_view text, const char* place, std::size_t linesBefore,
								bool textEndsFile);

/// The number of lines with records.
std::size_t countOffRecords(std::string_view text);

bool readOffVertex(Words& words, std::array<double, 3>& position);
/// The file's word for the number of corners is not trusted: no more are taken than there are.
bool readOffFace(Words& words, std::vector<std::int64_t>& corners);

/// Reads the lines of one piece of a file. The sink takes the records:
///   addVertex(std::size_t number, const std::array<double, 3>&)
///   addFace(const std::int64_t* corners, std::size_t num)
template <class Sink>
class OffPiece {
public:
	Sink        sink;
	const char* badPlace = nullptr; ///< the first unreadable line; null without such a line

	/// first: records of the pieces before.
	void read(std::string_view text, std::size_t first, const OffHeader& header)
	{
		std::size_t record = first;
		while (!text.empty() && record < header.recordNum()) {
			const char* const place = text.data();
			Words             words(withoutComment(takeLine(text)));
			if (words.isAtEnd()) continue;
			const bool isGood =
				record < header.vertexNum ? readVertex(record, words) : readFace(words);
			++record;
			if (isGood) continue;
			badPlace = place;
			return;
		}
	}

private:
	std::vector<std::int64_t> corners_;

	bool readVertex(std::size_t number, Words& words)
	{
		std::array<double, 3> position{};
		if (!readOffVertex(words, position)) return false;
		sink.addVertex(number, position);
		return true;
	}

	bool readFace(Words& words)
	{
		if (!readOffFace(words, corners_)) return false;
		sink.addFace(corners_.data(), corners_.size());
		return true;
	}
};

} // namespace gpr::app

#endif
