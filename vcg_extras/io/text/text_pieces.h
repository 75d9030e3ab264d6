// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_TEXT_TEXT_PIECES_H
#define VCG_EXTRAS_IO_TEXT_TEXT_PIECES_H

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace gpr::app {

/// The first bytes of a file, or the whole shorter file. Throws AppError (BadInput) if the file
/// cannot be read.
std::string beginOfFile(const std::string& path, std::size_t most = std::size_t(1) << 20);

/// Reads a text file of any size once, from begin to end, by pieces of whole lines; no piece ends
/// at a line that goes on (see goesOn). Throws AppError (BadInput) if the file cannot be read or a
/// line is longer than 64 MB. Memory: one piece.
class TextPieces {
public:
	/// from: bytes to pass over, which have so many lines.
	explicit TextPieces(const std::string& path, std::uint64_t from = 0, std::size_t lineNum = 0,
						std::size_t pieceBytes = usualPieceBytes);

	/// The next piece; empty at the end of the file; the last piece then stays valid.
	std::string_view next();

	/// Lines of the file before the last returned piece.
	std::size_t linesBefore() const { return linesBefore_; }
	/// Bytes of the file after this piece.
	std::uint64_t bytesLeft() const { return unread_ + (filled_ - pieceEnd_); }

private:
	static constexpr std::size_t usualPieceBytes  = std::size_t(1) << 23;
	static constexpr std::size_t longestLineBytes = std::size_t(1) << 26;

	std::ifstream     file_;
	std::vector<char> buffer_;
	std::size_t       pieceEnd_ = 0, filled_ = 0; ///< of the buffer
	std::uint64_t     unread_      = 0;           ///< bytes of the file
	std::size_t       linesBefore_ = 0;

	void fill();
};

} // namespace gpr::app

#endif
