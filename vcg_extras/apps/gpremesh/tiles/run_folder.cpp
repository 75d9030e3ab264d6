// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_folder.h"

#include <vcg_extras/io/base/checksum.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/platform.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace gpr::app {

namespace fs = std::filesystem;

namespace {

/// Last key of a record: the checksum of the record's text without this key.
constexpr const char* checksumKey = "checksum";

[[noreturn]] void failRead(const std::string& path)
{
	failInput("cannot read '" + path + "'");
}

[[noreturn]] void failToMake(const std::string& path, const std::error_code& error)
{
	throw AppError(ExitCode::Failure, "cannot make the folder '" + path + "': " + error.message());
}

} // namespace

void makeFolder(const std::string& path)
{
	std::error_code error;
	fs::create_directories(path, error);
	if (error) failToMake(path, error);
}

void requireRoom(const std::string& folder, double bytesNeeded)
{
	std::error_code      error;
	const fs::space_info room = fs::space(folder, error);
	if (error || double(room.available) >= bytesNeeded) return;
	throw AppError(ExitCode::Failure,
				   "the tiles need about " + std::to_string(std::int64_t(bytesNeeded / 1e6) + 1) +
					   " MB in '" + folder + "', and " +
					   std::to_string(std::int64_t(double(room.available) / 1e6)) +
					   " MB are free.");
}

ScratchFolder::ScratchFolder(const RunFolder& folder)
{
	makeFolder(folder.path());
	std::error_code error;
	path_ = makeOwnFolder(folder.scratch(), error);
	if (error) failToMake(path_, error);
}

ScratchFolder::~ScratchFolder()
{
	std::error_code error;
	fs::remove_all(path_, error);
}

std::uint64_t checksumOf(std::string_view text)
{
	Checksum sum;
	sum.add(text.data(), text.size());
	return sum.value();
}

FileStamp stampOf(const std::string& path)
{
	std::ifstream file(path, std::ios::binary);
	if (!file) failRead(path);
	constexpr std::size_t block = 1 << 20; // a multiple of eight, so that words do not shift
	std::vector<char>     buffer(block);
	FileStamp             stamp;
	Checksum              sum;
	while (file) {
		file.read(buffer.data(), std::streamsize(block));
		const std::size_t num = std::size_t(file.gcount());
		sum.add(buffer.data(), num);
		stamp.bytes += num;
	}
	if (file.bad()) failRead(path);
	stamp.checksum = sum.value();
	return stamp;
}

Json jsonOf(const FileStamp& stamp)
{
	return {{"bytes", stamp.bytes}, {"checksum", stamp.checksum}};
}

FileStamp stampOf(const Json& json)
{
	return {json.at("bytes").get<std::uint64_t>(), json.at("checksum").get<std::uint64_t>()};
}

void requireStamp(const std::string& path, const FileStamp& stamp)
{
	if (stampOf(path) == stamp) return;
	failInput("'" + path +
			  "' differs from the written file. Remove the folder of "
			  "the run and begin anew.");
}

void writeJson(const std::string& path, const Json& json)
{
	Json whole         = json;
	whole[checksumKey] = checksumOf(textOf(json));
	writeText(path, textOf(whole));
}

std::optional<Json> readJson(const std::string& path)
{
	std::ifstream file(path, std::ios::binary);
	if (!file) return std::nullopt;
	try {
		Json       json    = Json::parse(file);
		const auto written = json.at(checksumKey).get<std::uint64_t>();
		json.erase(checksumKey);
		if (checksumOf(textOf(json)) == written) return json;
	}
	catch (const Json::exception&) {
		// as for a wrong checksum
	}
	failInput("'" + path +
			  "' is damaged. Remove the folder of the run and begin "
			  "anew.");
}

void failOtherPlan(const std::string& path)
{
	failUsage("'" + path +
			  "' belongs to another plan. Remove the folder of the run "
			  "or name another folder.");
}

std::optional<Json> readRecord(const std::string& path, const std::string& planName)
{
	std::optional<Json> record = readJson(path);
	if (record && record->value("plan", "") != planName) failOtherPlan(path);
	return record;
}

} // namespace gpr::app
