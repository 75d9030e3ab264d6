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

// All that depends on the operating system.

namespace gpr::app {

/// The content of a file, mapped into memory where that is possible, else read.
class FileContent {
public:
	/// Throws AppError (BadInput) when the file cannot be read.
	explicit FileContent(const std::string& path);
	~FileContent();
	FileContent(const FileContent&)            = delete;
	FileContent& operator=(const FileContent&) = delete;

	std::string_view view() const { return {data_, size_}; }
	/// Takes a mapped file out of memory; what is looked at again comes back from the disk.
	void giveBackPages() const;

private:
	const char*       data_    = nullptr;
	std::size_t       size_    = 0;
	void*             mapping_ = nullptr;
	std::vector<char> copy_; ///< of what cannot be mapped, such as a pipe
};

/// True when standard error is a terminal that a person looks at.
bool errorIsTerminal();

/// The most memory that the process has held so far, bytes; 0 where that is unknown.
std::int64_t peakMemoryBytes();

/// Processor time that this process has used so far.
double processorSeconds();

/// A number that no other running process of this machine has.
long processId();

/// For the names of files and folders of this process: its number, and the attempt's behind the
/// first one. A process of another machine that shares the folder may have the same, and so may one
/// that was killed before: what exists already belongs to another.
inline std::string processName(int attempt)
{
	const std::string number = std::to_string(processId());
	return attempt == 0 ? number : number + "-" + std::to_string(attempt);
}

/// Makes a folder that is not there yet and whose name begins with the stem. Returns its path;
/// where it cannot be made `error` tells why.
inline std::string makeOwnFolder(const std::string& stem, std::error_code& error)
{
	std::string path;
	int         attempt = 0;
	do {
		path = stem + processName(attempt++);
	} while (!std::filesystem::create_directory(path, error) && !error);
	return path;
}

/// False when the file exists and its permissions forbid to write it.
bool mayOverwrite(const std::string& path);

/// Opens a file for writing that must not exist yet; null, with errno set, when that fails.
std::FILE* openNewFile(const std::string& path);

/// Whether a program of that name is found along PATH.
bool hasProgram(const std::string& name);

/// Runs a program found along PATH, its arguments as they are, with no input and its output thrown
/// away. Returns its exit code; -1 where it could not be started, was killed, or took longer than
/// allowed or until a stop was requested: then it and all it has started are ended.
int runProgram(const std::vector<std::string>& words, double secondsAllowed);

/// From now on an interrupt or termination signal only sets a flag; a second one ends the program.
void catchStopSignals();

/// Whether such a signal has come.
bool stopRequested();

} // namespace gpr::app

#endif
