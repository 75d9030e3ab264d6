// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_RUN_FOLDER_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_RUN_FOLDER_H

#include <vcg_extras/io/report/json_parts.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gpr::app {

/// The paths of all files of a run in tiles.
class RunFolder {
public:
	explicit RunFolder(std::string path) : path_(std::move(path)) {}

	const std::string& path() const { return path_; }
	std::string        plan() const { return path_ + "/plan.json"; }
	std::string        splitRecord() const { return path_ + "/split.json"; }
	/// A converted input, and the record of its conversion.
	std::string input(std::size_t i) const { return numbered("input", int(i), ".ply"); }
	std::string inputRecord(std::size_t i) const { return numbered("input", int(i), ".json"); }
	std::string scratch() const { return path_ + "/scratch"; }
	std::string tile(int k) const { return numbered("tile", k, ".ply"); }
	/// Per vertex of the tile: its number in the input, and whether other tiles have the vertex
	/// too.
	std::string tileNames(int k) const { return numbered("tile", k, ".names"); }
	std::string part(int k) const { return numbered("part", k, ".ply"); }
	/// Per vertex of the part: its SharedName.
	std::string partNames(int k) const { return numbered("part", k, ".names"); }
	std::string partRecord(int k) const { return numbered("part", k, ".json"); }
	std::string joined() const { return path_ + "/joined.ply"; }
	std::string joinRecord() const { return path_ + "/join.json"; }

	/// Throws AppError (Usage) if a file of the user has, or would get, a name of the run's own
	/// files in the folder.
	void requireForeign(const std::vector<std::string>& files) const;
	/// To be called before the plan. Throws AppError (Usage) if the folder holds files with such
	/// names, but no file that an interrupted run leaves.
	void requireUnused() const;
	/// Removes the run's own files, and the folder unless it holds other files.
	void remove() const;

private:
	std::string path_;

	std::string numbered(const char* name, int k, const char* ending) const
	{
		return path_ + "/" + name + std::to_string(k) + ending;
	}
};

/// Makes the folder unless it exists. Throws AppError (Failure).
void makeFolder(const std::string& path);

/// Disk space for the split, over the bytes of its PLY files.
constexpr double splitBytesPerInputByte = 2.5;

/// Throws AppError (Failure) if the disk of the folder has fewer free bytes than needed.
void requireRoom(const std::string& folder, double bytesNeeded);

/// A folder for temporary files of this process alone; removed at the end. Throws AppError
/// (Failure) if the folder cannot be made.
class ScratchFolder {
public:
	explicit ScratchFolder(const RunFolder& folder);
	~ScratchFolder();
	ScratchFolder(const ScratchFolder&)            = delete;
	ScratchFolder& operator=(const ScratchFolder&) = delete;

	const std::string& path() const { return path_; }

private:
	std::string path_;
};

/// The identity of a file's content.
struct FileStamp {
	std::uint64_t bytes    = 0;
	std::uint64_t checksum = 0; ///< FNV-1a over words of eight bytes

	bool operator==(const FileStamp& o) const { return bytes == o.bytes && checksum == o.checksum; }
};

/// The checksum of a text in memory.
std::uint64_t checksumOf(std::string_view text);
/// Throws AppError (BadInput) if the file cannot be read. Cost: one pass over the file.
FileStamp stampOf(const std::string& path);
Json      jsonOf(const FileStamp& stamp);
FileStamp stampOf(const Json& json);
/// Throws AppError (BadInput) with a sentence if the file has changed.
void requireStamp(const std::string& path, const FileStamp& stamp);

/// Writes a JSON text and its checksum, whole or not at all.
void writeJson(const std::string& path, const Json& json);
/// Null if there is no such file. Throws AppError (BadInput) if the content is not the content that
/// writeJson wrote.
std::optional<Json> readJson(const std::string& path);
/// Throws AppError (Usage): a file of the folder belongs to another run.
[[noreturn]] void failOtherPlan(const std::string& path);
/// The record of a step, or null if the step was not done. Throws AppError (Usage) for a record of
/// another plan.
std::optional<Json> readRecord(const std::string& path, const std::string& planName);

} // namespace gpr::app

#endif
