// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_FUZZ_CORPUS_H
#define GPR_TESTS_FUZZ_CORPUS_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gpr::test {

/// The files of a target's corpus, in the order of their names.
inline std::vector<std::filesystem::path> corpusFiles(const std::string& target)
{
	std::vector<std::filesystem::path> files;
	for (const auto& entry :
		 std::filesystem::directory_iterator(std::filesystem::path(GPR_CORPUS_DIR) / target))
		files.push_back(entry.path());
	std::sort(files.begin(), files.end());
	return files;
}

/// The bytes of a file of hexadecimal numbers; '#' begins a comment.
inline std::string bytesOf(const std::filesystem::path& file)
{
	std::ifstream stream(file);
	std::string   bytes;
	for (std::string line; std::getline(stream, line);) {
		const std::string hex = line.substr(0, line.find('#'));
		for (std::size_t i = 0; i + 1 < hex.size(); ++i) {
			if (!std::isxdigit(static_cast<unsigned char>(hex[i]))) continue;
			bytes += char(std::stoi(hex.substr(i, 2), nullptr, 16));
			++i;
		}
	}
	return bytes;
}

} // namespace gpr::test

#endif
