// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tile_part.h"

#include <vcg_extras/core/input/thin_border.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/report/remesh_outcome.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gpr::app {

namespace {

/// Adaptivity of the condensed surface. By measurement, with a fit: with 0 the result is 3 %
/// farther from an input with ridges, by the root mean square; 0.5 takes more time and gains
/// little.
constexpr double condensedAdapt = 0.25;
/// Longest edge of a tile's border over the mean edge of the condensed surface: with sizes that
/// follow the error, most triangles are smaller than the mean.
constexpr double borderEdgeShare = 0.7;
/// A tile is taken unchanged if condensing would leave more than this share of its vertices.
constexpr double mostLeft = 0.7;

WantedAttributes carriedOnes()
{
	WantedAttributes wanted;
	wanted.carried = true;
	return wanted;
}

/// A part in the making: its mesh and the names of its vertices.
struct Part {
	TriangleMesh            mesh;
	MeshAttributes          attributes;
	std::vector<SharedName> names;
};

class TileCondenser {
public:
	TileCondenser(const TilePlan& plan, const SplitFacts& split, int tile, const RunFolder& folder,
				  const RunLimit& limit, const ProgressCallback& progress) :
			plan_(plan),
			split_(split), tile_(tile), folder_(folder), limit_(limit), progress_(progress),
			names_(readNames(folder.tileNames(tile)))
	{
		mesh_ = readMesh(folder.tile(tile), carriedOnes());
		// A matched border depends on the polyline of the input, to the last bit; a soup has border
		// edges only, and the engine joins its faces; and an edge of a junction that is kept may be
		// a border in one tile only.
		if (plan.options.junctions != JunctionMode::Keep)
			splitLongBorderEdges(borderEdgeShare * condensedEdge(), mesh_, names_,
								 split.isSoup() || plan.options.boundary == BoundaryMode::Match);
		border_  = borderEdges(mesh_.view());
		texture_ = takeTexture(mesh_.attributes, mesh_.view(), false);
	}

	PartFacts run()
	{
		PartFacts  facts;
		Part       part;
		const auto wanted = wantedVertexNum();
		facts.isCondensed = wanted < mostLeft * double(mesh_.vertexNum()) &&
							condense(std::int64_t(wanted), part, facts.note);
		if (!facts.isCondensed) takeAsItIs(part);
		facts.vertexNum = part.mesh.positions.size();
		facts.faceNum   = part.mesh.triangles.size() / 3;
		write(part, facts);
		return facts;
	}

private:
	const TilePlan&                plan_;
	const SplitFacts&              split_;
	int                            tile_;
	const RunFolder&               folder_;
	const RunLimit&                limit_;
	const ProgressCallback&        progress_;
	std::vector<SharedName>        names_; ///< per vertex of the tile
	InputMesh                      mesh_;
	std::vector<Edge>              border_; ///< of the tile
	std::unique_ptr<TextureSource> texture_;

	/// Mean edge of the condensed surface; 0 for a surface without area.
	double condensedEdge() const
	{
		// Equilateral triangles have the area √3/4 L², and there are two for each vertex.
		const double vertexNum = resultVertexNum(plan_, split_);
		const double condensed = condensedDensity(vertexNum, plan_.memoryBytes) * vertexNum;
		return std::sqrt(2 * split_.area() / (std::sqrt(3.0) * condensed));
	}

	/// Vertices for the tile's area, plus the additional vertices for its border.
	double wantedVertexNum() const
	{
		const double edge = condensedEdge();
		const double area = split_.tiles[std::size_t(tile_)].area;
		const double even = edge > 0 ? 2 * area / (std::sqrt(3.0) * edge * edge) : 0;
		return std::ceil(even + vertexNumForBorder(edge));
	}

	/// Additional vertices for the border: all border vertices stay, and the triangles grow slowly
	/// from there, which would leave too few vertices inside. Along a border with edges h sizes are
	/// h + g·d at the distance d, up to L: over this strip the density 2/(√3 s²) adds up to 2/(√3
	/// g)·(1 - h/L)² per edge more than with L everywhere.
	double vertexNumForBorder(double edge) const
	{
		if (border_.empty() || !(edge > 0)) return 0;
		double borderLength = 0;
		for (const Edge& e : border_)
			borderLength += length(mesh_.view().position(std::size_t(e.second)) -
								   mesh_.view().position(std::size_t(e.first)));
		constexpr double growth   = 0.15;
		const double     num      = double(border_.size());
		const double     shorter  = std::max(0.0, 1 - borderLength / num / edge);
		const double     ofStrip  = 2 / (std::sqrt(3.0) * growth) * shorter * shorter;
		constexpr double ofBorder = 0.5;
		return num * (ofBorder + ofStrip);
	}

	RemeshOptions optionsFor(std::int64_t vertexNum) const
	{
		RemeshOptions options;
		options.preset           = Preset::FastFitted; // halves the distance from the input
		options.targetMode       = TargetMode::VertexNum;
		options.targetVertexNum  = std::max<std::int64_t>(4, vertexNum);
		options.allowNearest     = true;
		options.adapt            = condensedAdapt;
		options.boundary         = BoundaryMode::Keep;
		options.seed             = plan_.options.seed;
		options.threads          = plan_.options.threads;
		options.sew              = plan_.options.sew;
		options.junctions        = plan_.options.junctions;
		options.featureAngleDeg  = plan_.options.featureAngleDeg;
		options.timeLimitSeconds = limit_.secondsLeft();
		return options;
	}

	/// Condenses the tile. False, with a sentence, if the tile is better taken unchanged.
	bool condense(std::int64_t vertexNum, Part& part, std::string& note)
	{
		MeshView view = mesh_.view();
		if (texture_ != nullptr && texture_->hasSeams()) view.line = texture_->seams().data();
		RemeshOptions options        = optionsFor(vertexNum);
		options.surfacePointsOfFaces = texture_ != nullptr || mesh_.attributes.ofFacesToo();
		std::vector<std::uint8_t> selected(view.faceNum, 1);
		takeOutThinBorder(view, selected);
		view.selectedFace    = selected.data();
		options.selectedOnly = std::count(selected.begin(), selected.end(), 0) > 0;
		if (condenseWith(view, options, part, note)) return true;
		if (options.selectedOnly || !options.sew) return false;
		options.sew = false; // borders of tiles may coincide away from borders of the input
		return condenseWith(view, options, part, note);
	}

	bool condenseWith(const MeshView& view, const RemeshOptions& options, Part& part,
					  std::string& note)
	{
		RemeshResult result = remesh(view, options, progress_);
		if (!isAboutTheTile(result.status)) {
			limit_.check();
			requireDone(result);
		}
		if (result.status != Status::Ok) {
			note = sentenceOf(result);
			return false;
		}
		if (!takeNames(result, part.names)) {
			note = "A vertex or edge at the border of the tile was not kept.";
			return false;
		}
		note.clear();
		carry(std::move(result), part);
		return true;
	}

	static bool isAboutTheTile(Status status)
	{
		return status == Status::Ok || status == Status::CountTooSmall ||
			   status == Status::UnusableInput || status == Status::PromiseBroken;
	}

	void carry(RemeshResult result, Part& part)
	{
		part.attributes = carryAttributes(mesh_.attributes, mesh_.view(), texture_.get(), result);
		part.mesh       = std::move(result.mesh);
	}

	/// False if a shared vertex, or an edge between two shared vertices, was lost: the tiles would
	/// no longer fit together.
	bool takeNames(const RemeshResult& result, std::vector<SharedName>& names) const
	{
		names.assign(result.mesh.positions.size(), SharedName());
		std::vector<char> isThere(names_.size(), 0);
		for (std::size_t v = 0; v < result.callersVertex.size(); ++v) {
			const std::int32_t old = result.callersVertex[v];
			if (old < 0) continue;
			names[v]                  = names_[std::size_t(old)];
			isThere[std::size_t(old)] = 1;
		}
		for (std::size_t v = 0; v < names_.size(); ++v) {
			if (names_[v].isShared() && isThere[v] == 0) return false;
		}
		return sharedEdges(border_, names_) == sharedEdges(borderEdges(result.mesh.view()), names);
	}

	/// Border edges between shared vertices, by names, sorted.
	static std::vector<std::pair<SharedName, SharedName>>
	sharedEdges(const std::vector<Edge>& border, const std::vector<SharedName>& names)
	{
		std::vector<std::pair<SharedName, SharedName>> shared;
		for (const Edge& e : border) {
			const SharedName a = names[std::size_t(e.first)], b = names[std::size_t(e.second)];
			if (a.isShared() && b.isShared()) shared.push_back(std::minmax(a, b));
		}
		std::sort(shared.begin(), shared.end());
		return shared;
	}

	/// Takes the tile as a result of itself, with the same attributes as condensed tiles.
	void takeAsItIs(Part& part)
	{
		const MeshView view = mesh_.view();
		RemeshResult   same;
		same.mesh = triangleMeshOf(view);
		same.surfacePoints.resize(view.vertexNum);
		for (std::size_t f = 0; f < view.faceNum; ++f) {
			same.facePoints.push_back(BarycentricPoint::ofMiddle(f));
			for (std::size_t k = 0; k < 3; ++k)
				same.surfacePoints[std::size_t(view.triangle(f)[k])] =
					BarycentricPoint::ofCorner(f, k);
		}
		part.names = names_;
		carry(std::move(same), part);
	}

	void write(Part& part, PartFacts& facts)
	{
		writeMesh(part.mesh, mesh_.doublePrecision, part.attributes, folder_.part(tile_), limit_);
		facts.mesh  = stampOf(folder_.part(tile_));
		facts.names = writeNames(part.names, folder_.partNames(tile_), limit_);
	}
};

PartFacts factsOf(const Json& record)
{
	PartFacts facts;
	facts.vertexNum   = record.at("vertices").get<std::uint64_t>();
	facts.faceNum     = record.at("faces").get<std::uint64_t>();
	facts.isCondensed = record.at("condensed").get<bool>();
	facts.note        = record.at("note").get<std::string>();
	facts.mesh        = stampOf(record.at("mesh"));
	facts.names       = stampOf(record.at("names"));
	return facts;
}

PartFacts makeAnew(const TilePlan& plan, const SplitFacts& split, int tile, const RunFolder& folder,
				   const RunLimit& limit, const ProgressCallback& progress)
{
	const SplitFacts::Tile& of = split.tiles[std::size_t(tile)];
	if (of.faceNum == 0) return {};
	requireStamp(folder.tile(tile), of.mesh);
	requireStamp(folder.tileNames(tile), of.names);
	return TileCondenser(plan, split, tile, folder, limit, progress).run();
}

} // namespace

double resultVertexNum(const TilePlan& plan, const SplitFacts& split)
{
	const double byCount = resultVertexNum(plan.options, double(plan.allVertices()));
	if (byCount > 0) return byCount;
	// Equilateral triangles have the area √3/4 L², and there are two for each vertex.
	const double edge = plan.options.targetEdgeLen;
	return 2 * split.area() / (std::sqrt(3.0) * edge * edge);
}

PartFacts makePart(const TilePlan& plan, const SplitFacts& split, int tile, const RunFolder& folder,
				   const RunLimit& limit, const ProgressCallback& progress)
{
	if (const auto done = readPart(plan, tile, folder)) return *done;
	PartFacts facts = makeAnew(plan, split, tile, folder, limit, progress);
	writeJson(folder.partRecord(tile), {{"plan", plan.name},
										{"vertices", facts.vertexNum},
										{"faces", facts.faceNum},
										{"condensed", facts.isCondensed},
										{"note", facts.note},
										{"mesh", jsonOf(facts.mesh)},
										{"names", jsonOf(facts.names)}});
	return facts;
}

std::optional<PartFacts> readPart(const TilePlan& plan, int tile, const RunFolder& folder)
{
	const auto record = readRecord(folder.partRecord(tile), plan.name);
	if (!record) return std::nullopt;
	return factsOf(*record);
}

} // namespace gpr::app
