// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_source.h"

#include <vcg_extras/io/text/number_text.h>
#include <vcg_extras/io/text/text_lines.h>

#include <cmath>

namespace gpr::app {

bool TextSource::takeNextPiece()
{
	if (pieces_ == nullptr || pieces_->bytesLeft() == 0) return false;
	body_    = pieces_->next();
	at_      = body_.data();
	end_     = at_ + body_.size();
	word_    = nullptr;
	lineNum_ = pieces_->linesBefore();
	return true;
}

void TextSource::skipBlanks()
{
	while (at_ < end_ || takeNextPiece()) {
		if (isBlank(*at_))
			++at_;
		else if (*at_ == '#')
			at_ = std::find(at_, end_, '\n');
		else
			return;
	}
}

std::string_view TextSource::takeWord()
{
	const char* const begin = at_;
	while (at_ < end_ && !isBlank(*at_))
		++at_;
	return {begin, std::size_t(at_ - begin)};
}

double TextSource::real(PlyType)
{
	skipBlanks();
	word_        = at_;
	double value = 0;
	if (takePlainNumber(at_, end_, value)) return value;
	const std::string_view word = takeWord();
	if (isNonFinite(word)) return std::nan("");
	if (!parseNumber(word, value) || !std::isfinite(value)) fail(badNumber);
	return value;
}

double TextSource::coordinate(double value)
{
	return std::isfinite(value) ? value : std::nan("");
}

std::int64_t TextSource::whole(PlyType type)
{
	skipBlanks();
	word_              = at_;
	std::int64_t index = 0;
	if (takePlainNumber(at_, end_, index)) return index;
	constexpr double largest = 9e15; // whole numbers up to there are told apart
	const double     value   = real(type);
	if (!(std::abs(value) < largest) || value != std::floor(value)) fail(badNumber);
	return std::int64_t(value);
}

void TextSource::fail(const std::string& sentence) const
{
	const char* const place = word_ != nullptr ? word_ : body_.data();
	const std::size_t line  = lineNum_ + lineNumber(body_, place);
	failInput("line " + std::to_string(line) + ": " + sentence +
			  (bytesLeft() == 0 ? ", or the file ends too early" : ""));
}

} // namespace gpr::app
