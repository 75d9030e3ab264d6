// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spill_files.h"

#include <vcg_extras/io/base/exit_code.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

namespace gpr::app {

namespace {

[[noreturn]] void fail(const char* what, const std::string& path)
{
	throw AppError(ExitCode::Failure,
				   std::string("cannot ") + what + " '" + path + "': " + std::strerror(errno));
}

} // namespace

SpillFiles::SpillFiles(const std::string& folder, const std::string& name, int tileNum,
					   std::size_t flushBytes) :
		stem_(folder + "/" + name),
		flushBytes_(flushBytes), buffer_(std::size_t(tileNum))
{
}

void SpillFiles::flush(int tile)
{
	std::vector<char>& buffer = buffer_[std::size_t(tile)];
	const std::string  path   = pathOf(tile);
	std::ofstream      file(path, std::ios::binary | std::ios::app);
	file.write(buffer.data(), std::streamsize(buffer.size()));
	file.close();
	if (!file) fail("write", path);
	buffer.clear();
}

std::vector<char> SpillFiles::take(int tile)
{
	const std::string path = pathOf(tile);
	std::error_code   error;
	const auto        onDisk = std::filesystem::file_size(path, error);
	std::vector<char> all(error ? 0 : std::size_t(onDisk));
	if (!all.empty()) {
		std::ifstream file(path, std::ios::binary);
		if (!file.read(all.data(), std::streamsize(all.size()))) fail("read", path);
	}
	std::vector<char>& buffer = buffer_[std::size_t(tile)];
	all.insert(all.end(), buffer.begin(), buffer.end());
	buffer = std::vector<char>();
	std::filesystem::remove(path, error);
	return all;
}

} // namespace gpr::app
