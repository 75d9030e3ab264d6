// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_pieces.h"

#include "text_lines.h"

#include <vcg_extras/io/base/exit_code.h>

#include <algorithm>
#include <filesystem>

namespace gpr::app {

namespace {

/// The end of the last line that does not go on in the next line; 0 without such a line.
std::size_t endOfWholeLines(std::string_view text)
{
	std::size_t end = text.rfind('\n') + 1; // 0 without an end of a line
	while (end > 0) {
		const std::size_t begin = end > 1 ? text.rfind('\n', end - 2) + 1 : 0;
		if (!goesOn(text.substr(begin, end - begin))) return end;
		end = begin;
	}
	return 0;
}

} // namespace

std::string beginOfFile(const std::string& path, std::size_t most)
{
	std::ifstream file(path, std::ios::binary);
	if (!file) failInput("cannot read '" + path + "'");
	std::string begin(most, '\0');
	file.read(begin.data(), std::streamsize(most));
	begin.resize(std::size_t(file.gcount()));
	return begin;
}

TextPieces::TextPieces(const std::string& path, std::uint64_t from, std::size_t lineNum,
					   std::size_t pieceBytes) :
		file_(path, std::ios::binary),
		buffer_(pieceBytes), linesBefore_(lineNum)
{
	std::error_code     error;
	const std::uint64_t bytes = std::filesystem::file_size(path, error);
	if (!file_ || error) failInput("the file cannot be opened");
	file_.seekg(std::streamoff(from));
	unread_ = bytes - std::min(from, bytes);
}

void TextPieces::fill()
{
	const std::size_t wanted =
		std::size_t(std::min<std::uint64_t>(unread_, buffer_.size() - filled_));
	file_.read(buffer_.data() + filled_, std::streamsize(wanted));
	if (std::size_t(file_.gcount()) != wanted) failInput("the file cannot be read to its end");
	filled_ += wanted;
	unread_ -= wanted;
}

std::string_view TextPieces::next()
{
	if (bytesLeft() == 0) return {};
	linesBefore_ +=
		std::size_t(std::count(buffer_.begin(), buffer_.begin() + std::ptrdiff_t(pieceEnd_), '\n'));
	std::copy(buffer_.begin() + std::ptrdiff_t(pieceEnd_),
			  buffer_.begin() + std::ptrdiff_t(filled_), buffer_.begin());
	filled_ -= pieceEnd_;
	fill();
	pieceEnd_ = endOfWholeLines({buffer_.data(), filled_});
	while (pieceEnd_ == 0 && unread_ > 0) {
		if (buffer_.size() >= longestLineBytes)
			failInput("line " + std::to_string(linesBefore_ + 1) +
					  ": the line is longer than 64 MB");
		buffer_.resize(2 * buffer_.size());
		fill();
		pieceEnd_ = endOfWholeLines({buffer_.data(), filled_});
	}
	if (unread_ == 0) pieceEnd_ = filled_;
	return {buffer_.data(), pieceEnd_};
}

} // namespace gpr::app
