// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "table_options.h"

#include <sstream>

namespace gpr::app {

namespace {

/// Breaks a text into lines that fit beside the names of the options on 100 columns.
std::string wrapped(const std::string& text)
{
	constexpr std::size_t width = 68;
	std::string           lines;
	std::size_t           used = 0;
	std::istringstream    words(text);
	for (std::string word; words >> word; used += word.size()) {
		if (used > 0) {
			const bool full = used + 1 + word.size() > width;
			lines += full ? '\n' : ' ';
			used = full ? 0 : used + 1;
		}
		lines += word;
	}
	return lines;
}

std::string helpText(const Parameter& p)
{
	const std::string value = defaultText(p);
	return wrapped(commandHelp(p) + (value.empty() ? "" : " Default: " + value + "."));
}

} // namespace

void addTableOptions(CLI::App& command, Tool tool, GivenOptions& given,
					 bool (*isWanted)(const Parameter&))
{
	for (const Parameter& p : parametersOf(tool)) {
		if (std::string(p.option).empty() || (isWanted != nullptr && !isWanted(p))) continue;
		const Parameter* const row = &p;
		if (std::string(p.argument).empty()) {
			command.add_flag_callback(
				p.option, [row, &given] { given[row] = "on"; }, helpText(p));
			continue;
		}
		const auto keep = [row, &given](const std::string& word) { given[row] = word; };
		command.add_option_function<std::string>(p.option, keep, helpText(p))
			->type_name(p.argument);
	}
}

} // namespace gpr::app
