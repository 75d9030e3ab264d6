// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tile_split.h"

#include "ranked_set.h"
#include "spill_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace gpr::app {

namespace {

/// Shares of the work, for even progress.
constexpr double shareOfVertices = 0.25, shareOfFaces = 0.45;
/// A vertex of a tile, lent to another tile.
struct Lent {
	std::uint32_t tile, number;

	bool operator<(const Lent& other) const
	{
		return number != other.number ? number < other.number : tile < other.tile;
	}
	bool operator==(const Lent& other) const
	{
		return number == other.number && tile == other.tile;
	}
};

/// The faces of a tile on the disk: numbers of vertices, and the other properties.
class FaceSpill {
public:
	static void put(const FaceRecord& face, std::string& out)
	{
		putNumber(std::uint32_t(face.corners.size()), out);
		putNumber(std::uint32_t(face.before.size()), out);
		putNumber(std::uint32_t(face.after.size()), out);
		for (std::int64_t corner : face.corners)
			putNumber(std::uint32_t(corner), out);
		out += face.before;
		out += face.after;
	}

	explicit FaceSpill(const std::vector<char>& bytes) : at_(bytes.data()), end_(at_ + bytes.size())
	{
	}

	bool next(FaceRecord& face)
	{
		if (at_ == end_) return false;
		const std::uint32_t cornerNum = number(), before = number(), after = number();
		face.corners.resize(cornerNum);
		for (std::int64_t& corner : face.corners)
			corner = number();
		face.before.assign(at_, before);
		face.after.assign(at_ + before, after);
		at_ += before + after;
		return true;
	}

private:
	const char* at_;
	const char* end_;

	static void putNumber(std::uint32_t value, std::string& out)
	{
		char bytes[4];
		std::memcpy(bytes, &value, 4);
		out.append(bytes, 4);
	}
	std::uint32_t number()
	{
		std::uint32_t value;
		std::memcpy(&value, at_, 4);
		at_ += 4;
		return value;
	}
};

/// The vertices of a cell, or the vertices lent to the cell, ascending by number.
struct VertexPool {
	/// vertexNum: of all inputs.
	explicit VertexPool(std::uint64_t vertexNum) : numbers(vertexNum) {}

	std::vector<std::uint32_t> number;
	std::vector<char>          records;
	std::vector<char>          isUsed, isShared;
	RankedSet                  numbers; ///< the same numbers; three times as fast as a binary
										///< search

	/// To be called with all numbers present.
	void indexNumbers()
	{
		for (const std::uint32_t n : number)
			numbers.insert(n);
		numbers.finish();
	}
	/// Index of a number, or -1.
	std::int64_t find(std::uint32_t wanted) const
	{
		return numbers.has(wanted) ? std::int64_t(numbers.rank(wanted)) : -1;
	}
	const char* record(std::size_t i, std::size_t bytes) const { return &records[i * bytes]; }
	SharedName  nameOf(std::size_t i) const
	{
		return isShared[i] ? SharedName{number[i], number[i], 0} : SharedName();
	}
};

class Splitter {
public:
	Splitter(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
			 const ProgressCallback& progress) :
			plan_(plan),
			folder_(folder), limit_(limit), progress_(progress), scratch_(folder),
			layouts_(layoutsOf(plan)), recordBytes_(layouts_.front().vertexBytes), facts_{}
	{
		facts_.tiles.resize(std::size_t(plan.tileNum()));
		for (const char* name : {"vertices", "numbers", "faces", "lent", "borrowed"})
			spills_.emplace_back(scratch_.path(), name, plan.tileNum());
	}

	SplitFacts run()
	{
		cell_.reserve(std::size_t(plan_.allVertices()));
		std::uint64_t              first = 0;
		std::vector<std::uint64_t> firstVertex;
		for (std::size_t i = 0; i < layouts_.size(); ++i) {
			firstVertex.push_back(first);
			first += plan_.vertexNum[i];
		}
		// The vertices of all files first: then finding a face's tile needs no position.
		for (std::size_t i = 0; i < layouts_.size(); ++i)
			readVertices(i, firstVertex[i]);
		for (std::size_t i = 0; i < layouts_.size(); ++i)
			readFaces(i, firstVertex[i]);
		cell_ = std::vector<std::uint16_t>();
		// A face belongs to the lowest cell of its corners, so tiles borrow vertices of higher
		// cells only: tiles are written from the highest to the lowest, each with all lent vertices
		// present.
		for (int tile = plan_.tileNum() - 1; tile >= 0; --tile)
			putTogether(tile);
		return std::move(facts_);
	}

private:
	enum Spill { Vertices, Numbers, Faces, LentOnes, Borrowed };

	const TilePlan&              plan_;
	const RunFolder&             folder_;
	const RunLimit&              limit_;
	const ProgressCallback&      progress_;
	ScratchFolder                scratch_;
	std::vector<PlyRecordLayout> layouts_;
	std::size_t                  recordBytes_;
	SplitFacts                   facts_;
	std::vector<SpillFiles>      spills_;
	std::vector<std::uint16_t>   cell_; ///< per vertex of all inputs
	std::uint64_t                doneNum_ = 0;

	static std::vector<PlyRecordLayout> layoutsOf(const TilePlan& plan)
	{
		std::vector<PlyRecordLayout> layouts;
		for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
			layouts.push_back(readRecordLayout(plan.inputs[i]));
			const PlyRecordLayout& layout = layouts.back();
			if (layout.vertices().count != plan.vertexNum[i] ||
				layout.faces().count != plan.faceNum[i] ||
				!haveSameProperties(layout, layouts.front()))
				failInput("'" + plan.inputs[i] + "' has changed since the plan was made.");
		}
		return layouts;
	}

	void tell(double share, const char* phrase) { limit_.tell(progress_, share, phrase); }

	void readVertices(std::size_t file, std::uint64_t first)
	{
		PlyRecordReader reader(plan_.inputs[file], layouts_[file]);
		reader.toVertices();
		const double all = double(std::max<std::uint64_t>(1, plan_.allVertices()));
		for (std::uint64_t v = 0; v < plan_.vertexNum[file]; ++v) {
			if ((v & pollMask) == 0)
				tell(shareOfVertices * double(first + v) / all, "Reading vertices");
			const char* const record = reader.nextVertex();
			const int         cell   = plan_.cells.cellOf(positionIn(record, layouts_[file]));
			cell_.push_back(std::uint16_t(cell));
			spills_[Vertices].add(cell, record, recordBytes_);
			spills_[Numbers].addValue(cell, std::uint32_t(first + v));
		}
	}

	void readFaces(std::size_t file, std::uint64_t firstVertex)
	{
		PlyRecordReader reader(plan_.inputs[file], layouts_[file]);
		reader.toFaces();
		const double all = double(std::max<std::uint64_t>(1, plan_.allFaces()));
		FaceRecord   face;
		std::string  bytes;
		for (std::uint64_t f = 0; f < plan_.faceNum[file]; ++f) {
			if ((f & pollMask) == 0)
				tell(shareOfVertices + shareOfFaces * double(doneNum_) / all, "Reading faces");
			++doneNum_;
			reader.nextFace(face);
			if (face.corners.size() < 3) continue;
			shiftCorners(file, firstVertex, face);
			const int tile = tileOf(face);
			for (std::int64_t v : face.corners) {
				const int cell = cell_[std::size_t(v)];
				if (cell != tile)
					spills_[LentOnes].addValue(cell, Lent{std::uint32_t(tile), std::uint32_t(v)});
			}
			bytes.clear();
			FaceSpill::put(face, bytes);
			spills_[Faces].add(tile, bytes.data(), bytes.size());
		}
	}

	void shiftCorners(std::size_t file, std::uint64_t firstVertex, FaceRecord& face) const
	{
		for (std::int64_t& v : face.corners) {
			if (v < 0 || std::uint64_t(v) >= plan_.vertexNum[file])
				failInput("'" + plan_.inputs[file] + "': a face names the missing vertex " +
						  std::to_string(v));
			v += std::int64_t(firstVertex);
		}
	}

	int tileOf(const FaceRecord& face) const
	{
		int lowest = cell_[std::size_t(face.corners.front())];
		for (std::int64_t v : face.corners)
			lowest = std::min(lowest, int(cell_[std::size_t(v)]));
		return lowest;
	}

	// ---- one tile

	void putTogether(int tile)
	{
		tell(shareOfVertices + shareOfFaces +
				 (1 - shareOfVertices - shareOfFaces) * double(plan_.tileNum() - tile) /
					 plan_.tileNum(),
			 "Writing tiles");
		VertexPool        own                   = ownVertices(tile);
		VertexPool        borrowed              = borrowedVertices(tile);
		std::vector<char> faces                 = spills_[Faces].take(tile);
		facts_.tiles[std::size_t(tile)].faceNum = markUsed(faces, own);
		lend(tile, own);
		write(tile, own, borrowed, faces);
	}

	VertexPool ownVertices(int tile)
	{
		VertexPool pool(plan_.allVertices());
		pool.number  = spills_[Numbers].takeValues<std::uint32_t>(tile);
		pool.records = spills_[Vertices].take(tile);
		pool.isUsed.assign(pool.number.size(), 0);
		pool.isShared.assign(pool.number.size(), 0);
		pool.indexNumbers();
		return pool;
	}

	/// On the disk each vertex is a number, a mark for shared vertices, and a record.
	VertexPool borrowedVertices(int tile)
	{
		const std::vector<char>  bytes = spills_[Borrowed].take(tile);
		const std::size_t        each  = 5 + recordBytes_;
		std::vector<const char*> at;
		for (std::size_t i = 0; i < bytes.size(); i += each)
			at.push_back(&bytes[i]);
		const auto numberAt = [](const char* p) {
			std::uint32_t number;
			std::memcpy(&number, p, 4);
			return number;
		};
		std::sort(at.begin(), at.end(),
				  [&](const char* a, const char* b) { return numberAt(a) < numberAt(b); });
		VertexPool pool(plan_.allVertices());
		for (const char* p : at) {
			pool.number.push_back(numberAt(p));
			pool.isShared.push_back(p[4]);
			pool.records.insert(pool.records.end(), p + 5, p + each);
		}
		pool.isUsed.assign(pool.number.size(), 1);
		pool.indexNumbers();
		return pool;
	}

	/// Returns the number of faces.
	static std::uint64_t markUsed(const std::vector<char>& faces, VertexPool& own)
	{
		FaceSpill     spill(faces);
		FaceRecord    face;
		std::uint64_t num = 0;
		for (; spill.next(face); ++num) {
			for (std::int64_t v : face.corners) {
				const std::int64_t i = own.find(std::uint32_t(v));
				if (i >= 0) own.isUsed[std::size_t(i)] = 1;
			}
		}
		return num;
	}

	/// Lends the tile's vertices to the tiles with faces at these vertices. A vertex is shared if
	/// two tiles use the vertex, and not shared if a single tile borrows the vertex unused by its
	/// own.
	void lend(int tile, VertexPool& own)
	{
		std::vector<Lent> lent = spills_[LentOnes].takeValues<Lent>(tile);
		std::sort(lent.begin(), lent.end());
		lent.erase(std::unique(lent.begin(), lent.end()), lent.end());
		for (std::size_t begin = 0; begin < lent.size();) {
			std::size_t end = begin;
			while (end < lent.size() && lent[end].number == lent[begin].number)
				++end;
			const std::size_t i        = std::size_t(own.find(lent[begin].number));
			const bool        isShared = end - begin > 1 || own.isUsed[i] != 0;
			own.isShared[i]            = isShared;
			for (std::size_t k = begin; k < end; ++k) {
				const int to = int(lent[k].tile);
				spills_[Borrowed].addValue(to, lent[k].number);
				spills_[Borrowed].addValue(to, char(isShared));
				spills_[Borrowed].add(to, own.record(i, recordBytes_), recordBytes_);
			}
			begin = end;
		}
	}

	void write(int tile, const VertexPool& own, const VertexPool& borrowed,
			   const std::vector<char>& faces)
	{
		SplitFacts::Tile&         facts = facts_.tiles[std::size_t(tile)];
		std::vector<std::int64_t> newIndex(own.number.size(), -1);
		std::vector<SharedName>   names;
		for (std::size_t i = 0; i < own.number.size(); ++i) {
			if (!own.isUsed[i]) continue;
			newIndex[i] = std::int64_t(names.size());
			names.push_back(own.nameOf(i));
		}
		const std::int64_t firstBorrowed = std::int64_t(names.size());
		for (std::size_t i = 0; i < borrowed.number.size(); ++i)
			names.push_back(borrowed.nameOf(i));
		facts.vertexNum    = names.size();
		const auto localOf = [&](std::int64_t v) {
			const std::int64_t i = own.find(std::uint32_t(v));
			return i >= 0 ? newIndex[std::size_t(i)]
						  : firstBorrowed + borrowed.find(std::uint32_t(v));
		};
		writeMesh(tile, own, borrowed, faces, localOf);
		facts.names = writeNames(names, folder_.tileNames(tile), limit_);
	}

	template <class LocalOf>
	void writeMesh(int tile, const VertexPool& own, const VertexPool& borrowed,
				   const std::vector<char>& faces, const LocalOf& localOf)
	{
		SplitFacts::Tile& facts = facts_.tiles[std::size_t(tile)];
		OutputFile        out(folder_.tile(tile), limit_);
		out.text(headerText(layouts_.front(), facts.vertexNum, facts.faceNum));
		std::vector<Vec3d> place;
		for (const VertexPool* pool : {&own, &borrowed}) {
			for (std::size_t i = 0; i < pool->number.size(); ++i) {
				if (!pool->isUsed[i]) continue;
				out.bytes(pool->record(i, recordBytes_), recordBytes_);
				place.push_back(positionIn(pool->record(i, recordBytes_), layouts_.front()));
			}
		}
		FaceSpill   spill(faces);
		FaceRecord  face;
		std::string bytes;
		while (spill.next(face)) {
			for (std::int64_t& v : face.corners)
				v = localOf(v);
			for (std::size_t k = 2; k < face.corners.size(); ++k)
				facts.area += areaOf(place, face.corners, k);
			bytes.clear();
			appendFace(face, layouts_.front(), bytes);
			out.bytes(bytes.data(), bytes.size());
		}
		out.commit();
		facts.mesh = stampOf(folder_.tile(tile));
	}

	/// Area of the triangle of a face's corners 0, k - 1 and k.
	static double areaOf(const std::vector<Vec3d>& place, const std::vector<std::int64_t>& corners,
						 std::size_t k)
	{
		const Vec3d  a = place[std::size_t(corners[0])], b = place[std::size_t(corners[k - 1])];
		const Vec3d  c    = place[std::size_t(corners[k])];
		const double area = 0.5 * length(cross(b - a, c - a));
		return std::isfinite(area) ? area : 0;
	}
};

Json jsonOf(const SplitFacts::Tile& tile)
{
	return {{"vertices", tile.vertexNum},
			{"faces", tile.faceNum},
			{"area", tile.area},
			{"mesh", jsonOf(tile.mesh)},
			{"names", jsonOf(tile.names)}};
}

SplitFacts factsOf(const Json& record)
{
	SplitFacts facts;
	for (const Json& json : record.at("tiles")) {
		SplitFacts::Tile tile;
		tile.vertexNum = json.at("vertices").get<std::uint64_t>();
		tile.faceNum   = json.at("faces").get<std::uint64_t>();
		tile.area      = json.at("area").get<double>();
		tile.mesh      = stampOf(json.at("mesh"));
		tile.names     = stampOf(json.at("names"));
		facts.tiles.push_back(tile);
	}
	return facts;
}

} // namespace

std::vector<SharedName> readNames(const std::string& path)
{
	std::ifstream file(path, std::ios::binary | std::ios::ate);
	if (!file) failInput("cannot read '" + path + "'");
	std::vector<SharedName> names(std::size_t(file.tellg()) / sizeof(SharedName));
	file.seekg(0);
	file.read(reinterpret_cast<char*>(names.data()),
			  std::streamsize(names.size() * sizeof(SharedName)));
	if (!file) failInput("cannot read '" + path + "'");
	return names;
}

FileStamp writeNames(const std::vector<SharedName>& names, const std::string& path,
					 const RunLimit& limit)
{
	OutputFile out(path, limit);
	out.bytes(reinterpret_cast<const char*>(names.data()), names.size() * sizeof(SharedName));
	out.commit();
	return stampOf(path);
}

double SplitFacts::area() const
{
	double sum = 0;
	for (const Tile& tile : tiles)
		sum += tile.area;
	return sum;
}

bool SplitFacts::isSoup() const
{
	std::uint64_t vertexNum = 0, faceNum = 0;
	for (const Tile& tile : tiles) {
		vertexNum += tile.vertexNum;
		faceNum += tile.faceNum;
	}
	return vertexNum == 3 * faceNum;
}

SplitFacts split(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
				 const ProgressCallback& progress)
{
	if (const auto record = readRecord(folder.splitRecord(), plan.name)) return factsOf(*record);
	requireRoom(folder.path(), diskBytesOf(plan));
	SplitFacts facts  = Splitter(plan, folder, limit, progress).run();
	Json       record = {{"plan", plan.name}, {"tiles", Json::array()}};
	for (const SplitFacts::Tile& tile : facts.tiles)
		record["tiles"].push_back(jsonOf(tile));
	writeJson(folder.splitRecord(), record);
	return facts;
}

SplitFacts readSplit(const TilePlan& plan, const RunFolder& folder)
{
	const auto record = readRecord(folder.splitRecord(), plan.name);
	if (!record) failUsage("The split was not done yet. Run 'gpremesh tile split'.");
	return factsOf(*record);
}

} // namespace gpr::app
