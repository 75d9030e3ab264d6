// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_folder.h"

#include <vcg_extras/io/base/checksum.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/platform.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>

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

/// The name of a run's file without its numbers, and without the ending of a file in the making.
std::string kindOf(std::string name)
{
	name.erase(std::remove_if(name.begin(), name.end(),
							  [](char c) { return c == '-' || (c >= '0' && c <= '9'); }),
			   name.end());
	const std::string partial = ".part";
	const std::size_t end     = name.size() - std::min(name.size(), partial.size());
	return name.compare(end, partial.size(), partial) == 0 ? name.substr(0, end) : name;
}

bool isOneOf(const std::string& kind, std::initializer_list<const char*> kinds)
{
	return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool isNameOfRun(const std::string& name)
{
	return isOneOf(kindOf(name), {"plan.json", "split.json", "input.ply", "input.json", "scratch",
								  "tile.ply", "tile.names", "part.ply", "part.names", "part.json",
								  "joined.ply", "join.json"});
}

/// The names in a folder.
std::vector<std::string> namesIn(const std::string& folder)
{
	std::error_code          error;
	std::vector<std::string> names;
	for (fs::directory_iterator at(folder, error), end; at != end; at.increment(error))
		names.push_back(at->path().filename().string());
	return names;
}

} // namespace

void RunFolder::requireForeign(const std::vector<std::string>& files) const
{
	for (const std::string& file : files) {
		std::error_code error;
		const fs::path  real = fs::weakly_canonical(file, error);
		if (real.parent_path() == fs::weakly_canonical(path_, error) &&
			isNameOfRun(real.filename().string()))
			failUsage("'" + file + "' has a name of the run's own files in '" + path_ +
					  "'. Choose another name or folder.");
	}
}

void RunFolder::requireUnused() const
{
	std::string own;
	for (const std::string& name : namesIn(path_)) {
		if (isOneOf(kindOf(name), {"plan.json", "input.json", "scratch"})) return;
		if (isNameOfRun(name)) own = name;
	}
	if (!own.empty())
		failUsage("'" + path_ + "' holds '" + own +
				  "', a file of no known run, which the run would replace. Name another folder.");
}

void RunFolder::remove() const
{
	std::error_code error;
	const auto      removeIf = [&](auto isWanted) {
        for (const std::string& name : namesIn(path_))
            if (isNameOfRun(name) && isWanted(name)) fs::remove_all(fs::path(path_) / name, error);
	};
	// A killed removal must leave no record without its files, and the plan tells whose folder it
	// is. The split's record goes first: its tiles were removed long before.
	fs::remove(splitRecord(), error);
	const auto isPlan   = [](const std::string& name) { return kindOf(name) == "plan.json"; };
	const auto isRecord = [](const std::string& name) {
		return fs::path(name).extension() == ".json";
	};
	removeIf([&](const std::string& name) { return isRecord(name) && !isPlan(name); });
	removeIf([&](const std::string& name) { return !isPlan(name); });
	removeIf(isPlan);
	fs::remove(path_, error);
}

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
