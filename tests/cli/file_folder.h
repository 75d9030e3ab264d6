// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_CLI_FILE_FOLDER_H
#define TESTS_CLI_FILE_FOLDER_H

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>

namespace gpr_test {

/// A test with a folder for its files, which goes with the test.
class FileFolder : public ::testing::Test {
protected:
	/// name: of the tests, for the folder.
	explicit FileFolder(const std::string& name) :
			folder_(std::filesystem::temp_directory_path() /
					("gpremesh_" + name + "_" + std::to_string(getpid())))
	{
		std::filesystem::create_directories(folder_);
	}
	~FileFolder() override { std::filesystem::remove_all(folder_); }

	/// Writes a file and returns its path.
	std::string put(const std::string& name, const std::string& content) const
	{
		std::ofstream(folder_ / name, std::ios::binary) << content;
		return path(name);
	}
	std::string        path(const std::string& name) const { return (folder_ / name).string(); }
	static std::string contentOf(const std::string& file)
	{
		std::stringstream text;
		text << std::ifstream(file, std::ios::binary).rdbuf();
		return text.str();
	}

private:
	std::filesystem::path folder_;
};

} // namespace gpr_test

#endif
