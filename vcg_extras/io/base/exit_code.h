// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_BASE_EXIT_CODE_H
#define VCG_EXTRAS_IO_BASE_EXIT_CODE_H

#include <stdexcept>
#include <string>

namespace gpr::app {

/// The exit codes of the program; --help prints this list.
enum class ExitCode {
	Done          = 0,
	Failure       = 1, ///< anything not listed below: no memory, output not writable, ...
	Usage         = 2, ///< the command line is wrong
	BadInput      = 3, ///< IN cannot be read or holds no usable surface
	PromiseBroken = 4, ///< for instance fewer vertices asked than the topology needs
	Stopped       = 5, ///< cancelled by a signal, or out of time
};

/// A failure that ends the program: the exit code and the sentence for the user.
class AppError : public std::runtime_error {
public:
	AppError(ExitCode exitCode, const std::string& sentence) :
			std::runtime_error(sentence), code(exitCode)
	{
	}

	ExitCode code;
};

/// Ends the program for an input that cannot be read or used.
[[noreturn]] inline void failInput(const std::string& sentence)
{
	throw AppError(ExitCode::BadInput, sentence);
}

/// Ends the program for a wrong command line or option.
[[noreturn]] inline void failUsage(const std::string& sentence)
{
	throw AppError(ExitCode::Usage, sentence);
}

} // namespace gpr::app

#endif
