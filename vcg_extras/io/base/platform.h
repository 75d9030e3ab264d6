// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_BASE_PLATFORM_H
#define VCG_EXTRAS_IO_BASE_PLATFORM_H

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// All code that depends on the operating system.

namespace gpr::app {

/// The content of a file, mapped into memory if possible, else read.
class FileContent {
public:
	/// Throws AppError (BadInput) when the file cannot be read.
	explicit FileContent(const std::string& path);
	~FileContent();
	FileContent(const FileContent&)            = delete;
	FileContent& operator=(const FileContent&) = delete;

	std::string_view view() const { return {data_, size_}; }
	/// Takes a mapped file out of memory; later reads bring the pages back from the disk.
	void giveBackPages() const;

private:
	const char*       data_    = nullptr;
	std::size_t       size_    = 0;
	void*             mapping_ = nullptr;
	std::vector<char> copy_; ///< of a file that cannot be mapped, such as a pipe
};

/// Whether standard error is a terminal.
bool errorIsTerminal();

/// The largest memory of the process so far, bytes; 0 if unknown.
std::int64_t peakMemoryBytes();

/// Processor time of this process so far.
double processorSeconds();

/// The number of this process, which no other running process of this machine has.
long processId();

/// A name for files and folders of this process: the number of the process, and after the first
/// attempt the number of the attempt. A process of another machine with the same folder may have
/// the same name, and so may an earlier killed process: an existing file belongs to another
/// process.
inline std::string processName(int attempt)
{
	const std::string number = std::to_string(processId());
	return attempt == 0 ? number : number + "-" + std::to_string(attempt);
}

/// Makes a new folder whose name begins with the stem. Returns the path; if the folder cannot be
/// made, `error` has the reason.
inline std::string makeOwnFolder(const std::string& stem, std::error_code& error)
{
	std::string path;
	int         attempt = 0;
	do {
		path = stem + processName(attempt++);
	} while (!std::filesystem::create_directory(path, error) && !error);
	return path;
}

/// False if the file exists and its permissions forbid writing.
bool mayOverwrite(const std::string& path);

/// Opens a file for writing that must not exist yet; null, with errno set, if opening fails.
std::FILE* openNewFile(const std::string& path);

/// Whether a program of this name is found along PATH.
bool hasProgram(const std::string& name);

/// Runs a program found along PATH, its arguments unchanged, without input; the output is thrown
/// away. Returns the exit code; -1 if the program could not be started, was killed, took longer
/// than allowed, or a stop was requested: then the program and all its children are ended.
int runProgram(const std::vector<std::string>& words, double secondsAllowed);

/// From now on an interrupt or termination signal only sets a flag; a second signal ends the
/// program.
void catchStopSignals();

/// Whether such a signal has come.
bool stopRequested();

} // namespace gpr::app

#endif
