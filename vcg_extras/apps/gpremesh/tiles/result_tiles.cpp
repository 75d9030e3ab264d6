// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_tiles.h"

#include "cell_tree.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/report/json_parts.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace gpr::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* indexName = "tiles.json";

[[noreturn]] void failToWrite(const fs::path& folder, const std::string& why)
{
	throw AppError(ExitCode::Failure, "cannot write '" + folder.string() + "': " + why);
}

std::string tileName(std::size_t tile)
{
	return "tile" + std::to_string(tile) + ".ply";
}

bool isTileName(const std::string& name)
{
	return name.rfind("tile", 0) == 0 && name == tileName(std::strtoull(&name[4], nullptr, 10));
}

/// Whether a folder may be replaced: it is empty, or an index and its tiles.
bool holdsTilesOnly(const fs::path& folder)
{
	if (!fs::exists(folder / indexName)) return fs::is_empty(folder);
	for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
		const std::string name = entry.path().filename().string();
		if (name != indexName && !isTileName(name)) return false;
	}
	return true;
}

/// A folder that appears whole or not at all, like the file of OutputFile.
class OutputFolder : public Output {
public:
	explicit OutputFolder(const std::string& path) : wanted_(path)
	{
		if (fs::exists(wanted_) && !(fs::is_directory(wanted_) && holdsTilesOnly(wanted_)))
			failToWrite(wanted_, "this path exists and holds something else than tiles");
		std::error_code error;
		temporary_ = makeOwnFolder(path + ".part", error);
		if (!error) return;
		temporary_.clear();
		failToWrite(wanted_, error.message());
	}
	~OutputFolder() override
	{
		std::error_code error;
		if (!temporary_.empty()) fs::remove_all(temporary_, error);
	}

	std::string file(const std::string& name) const { return (temporary_ / name).string(); }

	void commit() override
	{
		std::error_code error;
		fs::remove_all(wanted_, error);
		if (!error) fs::rename(temporary_, wanted_, error);
		if (error) failToWrite(wanted_, error.message());
		temporary_.clear();
	}

private:
	fs::path wanted_, temporary_;
};

/// The faces of each tile, ascending.
using FaceGroups = std::vector<std::vector<std::size_t>>;

FaceGroups groupsOf(const TriangleMesh& mesh, int tileNum)
{
	std::vector<Vec3d> middle;
	middle.reserve(mesh.faceNum());
	for (std::size_t c = 0; c < mesh.triangles.size(); c += 3) {
		Vec3d sum{0, 0, 0};
		for (std::size_t k = c; k < c + 3; ++k)
			sum = sum + mesh.positions[std::size_t(mesh.triangles[k])];
		middle.push_back(sum * (1.0 / 3));
	}
	std::vector<Vec3d> sorted = middle;
	const CellTree     cells(sorted, tileNum);
	FaceGroups         groups{std::size_t(tileNum)};
	for (std::size_t f = 0; f < middle.size(); ++f)
		groups[std::size_t(cells.cellOf(middle[f]))].push_back(f);
	const auto isEmpty = [](const std::vector<std::size_t>& faces) { return faces.empty(); };
	groups.erase(std::remove_if(groups.begin(), groups.end(), isEmpty), groups.end());
	return groups;
}

std::vector<ValueColumn> chosen(const std::vector<ValueColumn>& columns,
								const std::vector<std::size_t>& rows)
{
	std::vector<ValueColumn> result;
	for (const ValueColumn& column : columns) {
		result.push_back({column.name, column.type, {}, column.names});
		for (const std::size_t row : rows)
			result.back().values.push_back(column.values[row]);
	}
	return result;
}

CornerTexture chosen(const CornerTexture& texture, const std::vector<std::size_t>& faces)
{
	CornerTexture result;
	for (const std::size_t f : faces) {
		if (!texture.uv.empty()) {
			const auto first = texture.uv.begin() + std::ptrdiff_t(6 * f);
			result.uv.insert(result.uv.end(), first, first + 6);
		}
		if (!texture.image.empty()) result.image.push_back(texture.image[f]);
	}
	return result;
}

/// Paths of images beside a folder, seen from inside of the folder.
std::vector<std::string> seenFromInside(std::vector<std::string> images)
{
	for (std::string& image : images) {
		if (fs::path(image).is_relative()) image = "../" + image;
	}
	return images;
}

struct Tile {
	TriangleMesh   mesh;
	MeshAttributes attributes;
};

/// Cuts tiles out of a mesh, one after the other.
class TileCutter {
public:
	TileCutter(const TriangleMesh& mesh, const MeshAttributes& attributes) :
			mesh_(mesh), attributes_(attributes), localOf_(mesh.vertexNum(), -1)
	{
	}

	Tile cut(const std::vector<std::size_t>& faces)
	{
		Tile                     tile;
		std::vector<std::size_t> vertices;
		for (const std::size_t f : faces) {
			for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
				tile.mesh.triangles.push_back(numberOf(std::size_t(mesh_.triangles[c]), vertices));
		}
		for (const std::size_t v : vertices) {
			tile.mesh.positions.push_back(mesh_.positions[v]);
			localOf_[v] = -1; // for the next tile
		}
		tile.attributes.ofVertices = chosen(attributes_.ofVertices, vertices);
		tile.attributes.ofFaces    = chosen(attributes_.ofFaces, faces);
		tile.attributes.texture    = chosen(attributes_.texture, faces);
		tile.attributes.images     = seenFromInside(attributes_.images);
		tile.attributes.materials  = attributes_.materials;
		tile.attributes.gltf       = attributes_.gltf;
		tile.attributes.unit       = attributes_.unit;
		return tile;
	}

private:
	const TriangleMesh&       mesh_;
	const MeshAttributes&     attributes_;
	std::vector<std::int32_t> localOf_; ///< per vertex of the mesh: its number in the tile, or -1

	std::int32_t numberOf(std::size_t v, std::vector<std::size_t>& vertices)
	{
		if (localOf_[v] < 0) {
			localOf_[v] = std::int32_t(vertices.size());
			vertices.push_back(v);
		}
		return localOf_[v];
	}
};

Json tileJson(const std::string& name, const TriangleMesh& mesh)
{
	Box<double> box;
	for (const Vec3d& p : mesh.positions)
		box.add(p);
	return {{"file", name},
			{"vertices", mesh.vertexNum()},
			{"faces", mesh.faceNum()},
			{"low", {box.low.x, box.low.y, box.low.z}},
			{"high", {box.high.x, box.high.y, box.high.z}}};
}

} // namespace

void checkWritableFolder(const std::string& folder)
{
	const OutputFolder attempt(folder); // made and removed again
}

std::unique_ptr<Output> writeTiles(const TriangleMesh& mesh, bool doublePrecision,
								   MeshAttributes& attributes, int tileNum,
								   const std::string& folder, const RunLimit& limit)
{
	auto                     out    = std::make_unique<OutputFolder>(folder);
	const FaceGroups         groups = groupsOf(mesh, tileNum);
	TileCutter               cutter(mesh, attributes);
	std::vector<std::string> lost; // the same for each tile
	Json                     index = {{"program", programJson()},
									  {"vertices", mesh.vertexNum()},
									  {"faces", mesh.faceNum()},
									  {"tiles", Json::array()}};
	for (const std::vector<std::size_t>& faces : groups) {
		const std::string name = tileName(index["tiles"].size());
		Tile              tile = cutter.cut(faces);
		writeMesh(tile.mesh, doublePrecision, tile.attributes, out->file(name), limit);
		lost = tile.attributes.lost;
		index["tiles"].push_back(tileJson(name, tile.mesh));
	}
	attributes.lost.insert(attributes.lost.end(), lost.begin(), lost.end());
	writeText(out->file(indexName), textOf(index), limit);
	return out;
}

} // namespace gpr::app
