// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_files.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// The file of a gzip archive, written to the folder for temporary files without the end ".gz".
ModelFile unpacked(const std::filesystem::path& packed)
{
	const std::string to      = ::testing::TempDir() + packed.stem().string();
	const std::string command = "gzip -dc '" + packed.string() + "' > '" + to + "'";
	if (std::system(command.c_str()) == 0) return {to, ""};
	return {"", packed.filename().string() + " cannot be unpacked"};
}

ModelFile bunny()
{
	const char* path = "/usr/share/glmark2/models/bunny.obj";
	if (std::ifstream(path)) return {path, ""};
	return {"", "glmark2-data is not installed (scripts/setup)"};
}

} // namespace

ModelFile findModel(const std::string& name)
{
	if (name == "bunny.obj") return bunny();
	const char* folder = std::getenv("GPR_MODELS_DIR");
	if (folder == nullptr) return {"", "GPR_MODELS_DIR is not set"};
	const std::string path = std::string(folder) + "/" + name;
	if (!std::ifstream(path)) return {path, name + " is not there"};
	return std::filesystem::path(path).extension() == ".gz" ? unpacked(path) : ModelFile{path, ""};
}

std::string shortName(const std::string& file)
{
	return file.substr(0, file.find('_'));
}

} // namespace gpr::test
