// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_conversion.h"

#include "conversion.h"
#include "ply_records.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/stl_facets.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <filesystem>

namespace gpr::app {

namespace {

namespace fs = std::filesystem;

std::uint64_t sizeOf(const std::string& path)
{
	std::error_code error;
	const auto      bytes = fs::file_size(path, error);
	if (error) failInput("cannot read '" + path + "'");
	return bytes;
}

bool isBinaryStlFile(const std::string& path)
{
	constexpr std::size_t enough = 4096;
	return isBinaryStl(beginOfFile(path, enough), sizeOf(path));
}

std::string absolutePath(const std::string& path)
{
	return fs::absolute(path).lexically_normal().string();
}

/// Disk space for a conversion and the split: temporary files, the PLY file, and the split of the
/// PLY file. Text has two to four characters for each byte of a binary file. A facet of 50 bytes
/// takes 48 bytes of temporary files and 19 bytes of the PLY file.
double diskBytesFor(const std::string& path)
{
	const double bytes = double(sizeOf(path));
	if (tileInputOf(path) != TileInput::Converted) return splitBytesPerInputByte * bytes;
	constexpr double plyPerText = 0.75, aside = 1.5;
	if (formatOfPath(path) == MeshFormat::Stl) return aside * bytes;
	return (1 + splitBytesPerInputByte) * plyPerText * bytes;
}

void requireRoomFor(const std::vector<std::string>& inputs, const RunFolder& folder)
{
	double bytes = 0;
	for (const std::string& path : inputs)
		bytes += diskBytesFor(path);
	requireRoom(folder.path(), bytes);
}

void requireSource(const std::string& path, const Json& record, const std::string& recordPath)
{
	const Json& source = record.at("source");
	if (source.at("file") != absolutePath(path)) failOtherPlan(recordPath);
	if (stampOf(path) == stampOf(source.at("stamp"))) return;
	failInput("'" + path +
			  "' has changed since its conversion. Remove the "
			  "folder of the run or name another folder.");
}

std::vector<std::string> convert(const Conversion& job)
{
	switch (formatOfPath(job.source)) {
	case MeshFormat::Obj:
		return convertObj(job);
	case MeshFormat::Off:
		return convertOff(job);
	case MeshFormat::Stl:
		return convertBinaryStl(job);
	default:
		return convertTextPly(job);
	}
}

/// Converts, and names the input in sentences about the input.
std::vector<std::string> convertNamed(const Conversion& job)
{
	try {
		return convert(job);
	}
	catch (const AppError& error) {
		if (error.code != ExitCode::BadInput) throw;
		throw AppError(error.code, "cannot read '" + job.source + "': " + error.what() + ".");
	}
}

/// Converts an input, unless done before.
void convertInput(const std::string& path, std::size_t i, double memoryBytes,
				  const RunFolder& folder, const RunLimit& limit, const ProgressCallback& progress)
{
	if (const std::optional<Json> record = readJson(folder.inputRecord(i))) {
		requireSource(path, *record, folder.inputRecord(i));
		requireStamp(folder.input(i), stampOf(record->at("mesh")));
		return;
	}
	const FileStamp     stamp = stampOf(path); // before reading, so that a later change is detected
	const ScratchFolder scratch(folder);
	const auto          notes =
		convertNamed({path, folder.input(i), scratch.path(), memoryBytes, limit, progress});
	writeJson(folder.inputRecord(i),
			  {{"source", {{"file", absolutePath(path)}, {"stamp", jsonOf(stamp)}}},
			   {"mesh", jsonOf(stampOf(folder.input(i)))},
			   {"notes", notes}});
}

} // namespace

TileInput tileInputOf(const std::string& path)
{
	switch (formatOfPath(path)) {
	case MeshFormat::Ply:
		return readPlyLayout(path).isText() ? TileInput::Converted : TileInput::Directly;
	case MeshFormat::Obj:
	case MeshFormat::Off:
		return TileInput::Converted;
	case MeshFormat::Stl:
		return isBinaryStlFile(path) ? TileInput::Converted : TileInput::NotAtAll;
	default:
		return TileInput::NotAtAll;
	}
}

MeshSize estimatedSize(const std::string& path)
{
	const MeshFormat format = formatOfPath(path);
	if (format == MeshFormat::Ply) {
		const PlyRecordLayout layout = readPlyLayout(path);
		return {double(layout.vertices().count), double(layout.faces().count)};
	}
	constexpr double leastBytesPerFace = 35; // of text
	const bool       isBinary          = format == MeshFormat::Stl && isBinaryStlFile(path);
	const double     faceNum =
		double(sizeOf(path)) / (isBinary ? double(stlFacetBytes) : leastBytesPerFace);
	return {faceNum / 2, faceNum};
}

std::vector<std::string> convertInputs(const std::vector<std::string>& inputs, double memoryBytes,
									   const RunFolder& folder, const RunLimit& limit,
									   const ProgressCallback& progress)
{
	constexpr double         usualMemory = 256e6;
	std::vector<std::string> files       = inputs;
	bool                     isRoomAsked = false;
	for (std::size_t i = 0; i < inputs.size(); ++i) {
		const TileInput kind = tileInputOf(inputs[i]);
		if (kind == TileInput::NotAtAll)
			failInput("'" + inputs[i] + "' cannot be read in tiles. Convert the file to PLY.");
		if (kind == TileInput::Directly) continue;
		makeFolder(folder.path());
		files[i] = folder.input(i);
		if (!isRoomAsked && !readJson(folder.inputRecord(i))) requireRoomFor(inputs, folder);
		isRoomAsked = true;
		convertInput(inputs[i], i, memoryBytes > 0 ? memoryBytes : usualMemory, folder, limit,
					 progress);
	}
	return files;
}

void requireSameInputs(const std::vector<std::string>& inputs, const RunFolder& folder)
{
	for (std::size_t i = 0; i < inputs.size(); ++i) {
		const std::optional<Json> record = readJson(folder.inputRecord(i));
		if (record) requireSource(inputs[i], *record, folder.inputRecord(i));
	}
}

std::vector<std::string> conversionNotes(std::size_t inputNum, const RunFolder& folder)
{
	std::vector<std::string> notes;
	for (std::size_t i = 0; i < inputNum; ++i) {
		const std::optional<Json> record = readJson(folder.inputRecord(i));
		if (!record) continue;
		for (const Json& note : record->at("notes"))
			notes.push_back(note.get<std::string>());
	}
	return notes;
}

} // namespace gpr::app
