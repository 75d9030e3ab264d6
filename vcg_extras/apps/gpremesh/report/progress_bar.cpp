// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_bar.h"

#include <algorithm>
#include <cstdio>

namespace gpr::app {

void ProgressBar::show(double share, const char* phrase)
{
	if (!shown_ || clock_.seconds() < nextDraw_) return;
	nextDraw_ = clock_.seconds() + 0.1;

	constexpr int     width = 30;
	const double      part  = share > 0 ? std::min(share, 1.0) : 0.0;
	const std::size_t full  = std::size_t(part * width);
	const std::string bar   = std::string(full, '#') + std::string(width - full, '.');
	const std::string line  = "[" + bar + "] " + std::to_string(int(100 * part)) + " % " + phrase;
	if (line != drawn_) draw(line);
}

void ProgressBar::tell(const std::string& words)
{
	if (!shown_) return;
	nextDraw_ = clock_.seconds() + 1.5;
	draw(words);
}

void ProgressBar::draw(const std::string& line)
{
	// "\033[K" removes the rest of a longer line.
	std::fprintf(stderr, "\r%s\033[K", line.c_str());
	std::fflush(stderr);
	drawn_ = line;
}

void ProgressBar::clear()
{
	if (drawn_.empty()) return;
	std::fputs("\r\033[K", stderr);
	std::fflush(stderr);
	drawn_.clear();
}

} // namespace gpr::app
