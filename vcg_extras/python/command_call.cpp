// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_call.h"

#include <vcg_extras/apps/gpremesh/commands/commands.h>
#include <vcg_extras/io/base/platform.h>

namespace nb = nanobind;

namespace gpr::python {

nb::dict remeshCommandTexts()
{
	app::RemeshWords words;
	nb::list         options;
	for (const app::CommandOption& row : words.options()) {
		nb::dict option;
		option["option"]   = row.option.c_str();
		option["argument"] = row.argument.c_str();
		option["help"]     = row.help.c_str();
		option["group"]    = row.group.c_str();
		options.append(option);
	}
	nb::dict texts;
	texts["description"] = app::remeshDescription;
	texts["in"]          = app::inHelp().c_str();
	texts["out"]         = app::outHelpOfRemesh().c_str();
	texts["options"]     = options;
	texts["everyday"]    = everydayGroup;
	return texts;
}

int runRemeshWords(const std::vector<std::string>&           files,
				   const std::map<std::string, std::string>& options)
{
	const app::Stopwatch         clock(app::processorSeconds());
	const nb::gil_scoped_release noLock;
	return app::exitCodeOfRun([&] {
		app::RemeshWords words;
		for (const app::CommandOption& row : words.options()) {
			const auto given = options.find(row.option);
			if (given != options.end()) row.take(given->second);
		}
		words.takeFiles(files);
		app::runRemeshCommand(words.line(), clock);
	});
}

} // namespace gpr::python
