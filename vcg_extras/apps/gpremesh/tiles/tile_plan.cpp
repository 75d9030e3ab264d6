// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tile_plan.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/options/given_options.h>
#include <vcg_extras/io/report/formatted_text.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace gpr::app {

namespace {

namespace fs = std::filesystem;

/// Bytes per face of a tile while condensing; at the end bytes per face of the condensed surface,
/// with two faces per vertex, and per vertex of the result: measured, see docs/scale.md.
constexpr double bytesPerTileFace      = 450;
constexpr double bytesPerCondensedFace = 57, bytesPerResultVertex = 400;
constexpr double bytesAtLeast = 3e7;

/// Vertices of the condensed surface per vertex of the result. With fewer vertices the result is
/// farther from the input: see docs/scale.md.
constexpr double usualDensity = 4, leastDensity = 2;

constexpr std::uint64_t sampleNum = 100000;
/// Numbers of vertices in PLY files have 32 bits.
constexpr std::uint64_t mostVertices = 0xfffffffeu;
constexpr int           mostTiles    = 10000;
/// Number of tiles if neither memory nor a number is given.
constexpr int usualTileNum = 8;

void checkOptions(const RemeshOptions& options)
{
	if (options.targetMode == TargetMode::MaxError)
		failUsage("--max-error is proven against the whole input, which tiles do not hold. Give "
				  "--vertices, --percent or --edge-length.");
	if (options.targetMode == TargetMode::Detail)
		failUsage("--detail is forecast for the whole input, which tiles do not hold. Give "
				  "--vertices, --percent or --edge-length.");
	if (options.targetMode == TargetMode::Sizes)
		failUsage("--max-edge alone is not possible in tiles. Give --vertices, --percent or "
				  "--edge-length.");
	if (options.edgeLenIsPercent || options.minEdgeIsPercent || options.maxEdgeIsPercent)
		failUsage("Lengths in percent are of the diagonal of the whole input, which tiles do not "
				  "hold. Give all lengths in mesh units.");
	if (options.dropComponentsBelow > 0)
		failUsage("--drop-components-below counts the faces of the whole input, which tiles do not "
				  "hold.");
	if (options.selectedOnly || options.featureRegion == FeatureRegion::Selection)
		failUsage("Selections are not carried through tiles.");
	if (options.boundary == BoundaryMode::Keep)
		failUsage("--boundary keep is not possible in tiles, whose results are made of a condensed "
				  "mesh.");
}

void checkLayouts(const std::vector<std::string>&     paths,
				  const std::vector<PlyRecordLayout>& layouts)
{
	for (std::size_t i = 1; i < layouts.size(); ++i) {
		if (!haveSameProperties(layouts[i], layouts[0]))
			failInput("'" + paths[i] + "' has other properties than '" + paths[0] + "'.");
	}
}

/// Positions at regular intervals; always the same vertices.
std::vector<Vec3d> samplePositions(const std::vector<std::string>&     paths,
								   const std::vector<PlyRecordLayout>& layouts, std::uint64_t all)
{
	const std::uint64_t step = std::max<std::uint64_t>(1, all / sampleNum);
	std::vector<Vec3d>  points;
	for (std::size_t i = 0; i < paths.size(); ++i) {
		constexpr std::size_t onePage = 4096;
		PlyRecordReader       reader(paths[i], layouts[i], step > 1 ? onePage : usualBufferBytes);
		const std::uint64_t   num = layouts[i].vertices().count;
		if (step == 1 && num > 0) reader.toVertices();
		for (std::uint64_t v = 0; v < num; v += step) {
			if (step > 1) reader.toVertices(v);
			points.push_back(positionIn(reader.nextVertex(), layouts[i]));
		}
	}
	return points;
}

int tilesFor(double faceNum, double memoryBytes)
{
	if (!(memoryBytes > 0)) return usualTileNum;
	const double room = std::max(memoryBytes - bytesAtLeast, bytesAtLeast);
	return int(std::clamp(std::ceil(faceNum * bytesPerTileFace / room), 1.0, double(mostTiles)));
}

Json jsonOf(const CellTree& tree)
{
	Json nodes = Json::array();
	for (const CellTree::Node& n : tree.nodes())
		nodes.push_back({n.axis, n.value, n.below, n.above});
	return nodes;
}

CellTree treeOf(const Json& nodes, int cellNum)
{
	std::vector<CellTree::Node> all;
	for (const Json& n : nodes)
		all.push_back({n[0].get<int>(), n[1].get<double>(), n[2].get<int>(), n[3].get<int>()});
	return {std::move(all), cellNum};
}

Json inputJson(const TilePlan& plan, std::size_t i)
{
	return {{"file", plan.inputs[i]},
			{"bytes", fs::file_size(plan.inputs[i])},
			{"vertices", plan.vertexNum[i]},
			{"faces", plan.faceNum[i]}};
}

/// The plan as JSON, without its name.
Json jsonOf(const TilePlan& plan)
{
	Json inputs = Json::array();
	for (std::size_t i = 0; i < plan.inputs.size(); ++i)
		inputs.push_back(inputJson(plan, i));
	return {{"program", programJson()},    {"inputs", std::move(inputs)},
			{"options", plan.optionsText}, {"memoryBytes", plan.memoryBytes},
			{"tiles", plan.tileNum()},     {"cells", jsonOf(plan.cells)}};
}

std::string nameOf(const Json& json)
{
	return formatted("%016llx", static_cast<unsigned long long>(checksumOf(textOf(json))));
}

} // namespace

std::uint64_t TilePlan::allVertices() const
{
	return std::accumulate(vertexNum.begin(), vertexNum.end(), std::uint64_t(0));
}

std::uint64_t TilePlan::allFaces() const
{
	return std::accumulate(faceNum.begin(), faceNum.end(), std::uint64_t(0));
}

double bytesUntiled(double faceNum, double vertexNum)
{
	constexpr double bytesPerFace = 80, bytesPerVertex = 300; // the file in memory included
	return bytesAtLeast + bytesPerFace * faceNum + bytesPerVertex * vertexNum;
}

double resultVertexNum(const RemeshOptions& options, double inputVertexNum)
{
	if (options.targetMode == TargetMode::VertexNum) return double(options.targetVertexNum);
	if (options.targetMode == TargetMode::FaceNum) return 0.5 * double(options.targetFaceNum);
	if (options.targetMode == TargetMode::Percent)
		return std::round(options.targetPercent / 100 * inputVertexNum);
	return 0;
}

double condensedDensity(double vertexNum, double memoryBytes)
{
	if (!(memoryBytes > 0) || !(vertexNum > 0)) return usualDensity;
	const double room = (memoryBytes - bytesAtLeast) / vertexNum - bytesPerResultVertex;
	return std::clamp(room / (2 * bytesPerCondensedFace), leastDensity, usualDensity);
}

double diskBytesOf(const TilePlan& plan)
{
	double bytes = 0;
	for (const std::string& input : plan.inputs)
		bytes += splitBytesPerInputByte * double(fs::file_size(input));
	return bytes;
}

void requireMemoryFor(double vertexNum, double memoryBytes)
{
	constexpr double each   = bytesPerResultVertex + 2 * bytesPerCondensedFace * leastDensity;
	const double     needed = bytesAtLeast + each * vertexNum;
	if (!(memoryBytes > 0) || needed <= memoryBytes) return;
	const double most = (memoryBytes - bytesAtLeast) / each;
	if (most < 4) { // of a tetrahedron
		throw AppError(ExitCode::PromiseBroken,
					   formatted("A run in tiles needs at least %.3g GB of memory, and --memory "
								 "allows %.3g GB.",
								 bytesAtLeast * 1e-9, memoryBytes * 1e-9));
	}
	throw AppError(
		ExitCode::PromiseBroken,
		formatted("A result of %.0f vertices needs about %.3g GB of memory at the end, and "
				  "--memory allows %.3g GB. Ask for at most %.0f vertices.",
				  vertexNum, needed * 1e-9, memoryBytes * 1e-9, most));
}

void requireMemoryForFaces(double faceNum, double memoryBytes)
{
	const double needed = bytesAtLeast + bytesPerCondensedFace * faceNum;
	if (!(memoryBytes > 0) || needed <= memoryBytes) return;
	throw AppError(
		ExitCode::PromiseBroken,
		formatted("The condensed surface has %.0f faces, since parts of the input could not "
				  "be condensed. This surface needs about %.3g GB of memory, and --memory allows "
				  "%.3g GB.",
				  faceNum, needed * 1e-9, memoryBytes * 1e-9));
}

TilePlan makePlan(const RemeshOptions& options, const TileSettings& settings)
{
	checkOptions(options);
	TilePlan plan;
	plan.optionsText = settings.optionsText;
	plan.options     = options;
	plan.memoryBytes = double(settings.memoryBytes);
	std::vector<PlyRecordLayout> layouts;
	for (const std::string& path : settings.inputs) {
		layouts.push_back(readRecordLayout(path));
		plan.inputs.push_back(fs::absolute(path).lexically_normal().string());
		plan.vertexNum.push_back(layouts.back().vertices().count);
		plan.faceNum.push_back(layouts.back().faces().count);
	}
	checkLayouts(plan.inputs, layouts);
	const std::uint64_t all = plan.allVertices();
	if (all > mostVertices) failInput("the inputs have more than 4,294,967,294 vertices.");
	requireMemoryFor(resultVertexNum(plan.options, double(all)), plan.memoryBytes);
	const int          wanted = settings.tileNum > 0 ? settings.tileNum
													 : tilesFor(double(plan.allFaces()), plan.memoryBytes);
	std::vector<Vec3d> points = samplePositions(plan.inputs, layouts, all);
	if (points.empty()) failInput("the inputs have no vertices.");
	plan.cells = CellTree(points, wanted);
	plan.name  = nameOf(jsonOf(plan));
	return plan;
}

void writePlan(const TilePlan& plan, const RunFolder& folder)
{
	makeFolder(folder.path());
	if (readRecord(folder.plan(), plan.name)) return;
	Json json    = jsonOf(plan);
	json["plan"] = plan.name;
	writeJson(folder.plan(), json);
}

TilePlan readPlan(const RunFolder& folder)
{
	const std::optional<Json> json = readJson(folder.plan());
	if (!json) failUsage("'" + folder.path() + "' holds no plan. Run 'gpremesh tile plan'.");
	TilePlan plan;
	for (const Json& input : json->at("inputs")) {
		plan.inputs.push_back(input.at("file").get<std::string>());
		plan.vertexNum.push_back(input.at("vertices").get<std::uint64_t>());
		plan.faceNum.push_back(input.at("faces").get<std::uint64_t>());
	}
	plan.optionsText = json->at("options").get<std::string>();
	plan.options     = optionsOfText(plan.optionsText);
	plan.memoryBytes = json->at("memoryBytes").get<double>();
	plan.cells       = treeOf(json->at("cells"), json->at("tiles").get<int>());
	plan.name        = json->at("plan").get<std::string>();
	if (json->at("program") != programJson())
		failUsage("The plan was made by another version of gpremesh.");
	return plan;
}

} // namespace gpr::app
