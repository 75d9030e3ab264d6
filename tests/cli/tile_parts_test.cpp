// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of runs in tiles: cells, records of PLY files, borders that fit together.
#include "mesh_files.h"

#include <vcg_extras/apps/gpremesh/tiles/border_split.h>
#include <vcg_extras/apps/gpremesh/tiles/cell_tree.h>
#include <vcg_extras/apps/gpremesh/tiles/conversion.h>
#include <vcg_extras/apps/gpremesh/tiles/ply_records.h>
#include <vcg_extras/apps/gpremesh/tiles/ranked_set.h>
#include <vcg_extras/apps/gpremesh/tiles/run_folder.h>
#include <vcg_extras/apps/gpremesh/tiles/spill_files.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/formats/ply_source.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>

namespace gpr_test {

using namespace gpr::app;
using gpr::ProgressCallback;
using gpr::Vec3d;

namespace {

std::vector<Vec3d> randomPoints(std::size_t num)
{
	std::mt19937       random(7);
	const auto         next = [&] { return double(random()) / 4294967296.0; };
	std::vector<Vec3d> points;
	for (std::size_t i = 0; i < num; ++i)
		points.push_back({next(), next() * next(), 3 * next()});
	return points;
}

/// A folder, removed at the end.
class Folder {
public:
	Folder() : path_(::testing::TempDir() + "tile_parts" + std::to_string(processId()))
	{
		std::filesystem::remove_all(path_);
		std::filesystem::create_directories(path_);
	}
	~Folder() { std::filesystem::remove_all(path_); }

	std::string path(const std::string& name) const { return path_ + "/" + name; }
	std::string put(const std::string& name, const std::string& content) const
	{
		std::ofstream(path(name), std::ios::binary) << content;
		return path(name);
	}

private:
	std::string path_;
};

InputMesh inputMesh(const TestMesh& mesh)
{
	InputMesh input;
	for (const auto& p : mesh.points)
		for (double c : p)
			input.floats.push_back(float(c));
	for (const auto& f : mesh.faces)
		for (int v : f)
			input.triangles.push_back(v);
	return input;
}

double areaOf(const InputMesh& mesh)
{
	double area = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const auto  t = mesh.view().triangle(f);
		const Vec3d a = mesh.view().position(std::size_t(t[0]));
		area += 0.5 * length(cross(mesh.view().position(std::size_t(t[1])) - a,
								   mesh.view().position(std::size_t(t[2])) - a));
	}
	return area;
}

std::vector<double> borderLengths(const InputMesh& mesh)
{
	std::vector<double> lengths;
	for (const Edge& e : borderEdges(mesh.view()))
		lengths.push_back(length(mesh.view().position(std::size_t(e.second)) -
								 mesh.view().position(std::size_t(e.first))));
	return lengths;
}

} // namespace

TEST(CellTree, CellsHaveAboutAsManyPoints)
{
	for (int cellNum : {1, 2, 3, 7, 12}) {
		std::vector<Vec3d> points = randomPoints(12000);
		const CellTree     tree(points, cellNum);
		std::vector<int>   num(std::size_t(cellNum), 0);
		for (const Vec3d& p : points)
			++num.at(std::size_t(tree.cellOf(p)));
		for (int n : num)
			EXPECT_NEAR(n, 12000 / cellNum, 2 + 0.01 * 12000) << cellNum;
	}
}

TEST(CellTree, TakesPointsThatAreAllOneAndNumbersThatAreNone)
{
	std::vector<Vec3d> same(100, Vec3d{1, 2, 3});
	same.push_back({NAN, 0, 0});
	const CellTree tree(same, 5);
	EXPECT_EQ(tree.cellOf({1, 2, 3}), tree.cellOf({1, 2, 3}));
	EXPECT_LT(tree.cellOf({NAN, NAN, NAN}), 5);
	EXPECT_GE(tree.cellOf({NAN, NAN, NAN}), 0);
}

TEST(SpillFiles, GiveBackWhatWasAdded)
{
	const Folder folder;
	std::filesystem::create_directories(folder.path("spill"));
	SpillFiles files(folder.path("spill"), "number", 2);
	const int  num = 300000; // more than is held in memory
	for (int i = 0; i < num; ++i)
		files.addValue(i % 2, i);
	for (int tile : {1, 0}) {
		const std::vector<int> values = files.takeValues<int>(tile);
		ASSERT_EQ(values.size(), std::size_t(num) / 2);
		for (std::size_t i = 0; i < values.size(); ++i)
			ASSERT_EQ(values[i], int(2 * i) + tile);
	}
	EXPECT_TRUE(files.take(0).empty());
}

class PlyRecords : public ::testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(LittleEndian, PlyRecords, ::testing::Bool());

TEST_P(PlyRecords, AreThoseOfTheFile)
{
	const Folder          folder;
	const TestMesh        mesh   = torus(9);
	const std::string     path   = folder.put("torus.ply", binaryPly(mesh, GetParam(), true));
	const PlyRecordLayout layout = readRecordLayout(path);
	PlyRecordReader       reader(path, layout, 100); // a buffer of few records
	reader.toVertices();
	for (const auto& p : mesh.points) {
		const Vec3d read = positionIn(reader.nextVertex(), layout);
		EXPECT_EQ(std::vector<double>({read.x, read.y, read.z}),
				  std::vector<double>(p.begin(), p.end()));
	}
	reader.toFaces();
	FaceRecord  face;
	std::string bytes;
	for (const auto& f : mesh.faces) {
		reader.nextFace(face);
		EXPECT_EQ(face.corners, std::vector<std::int64_t>(f.begin(), f.end()));
		appendFace(face, layout, bytes);
	}
	const std::string file = binaryPly(mesh, true, true);
	EXPECT_EQ(bytes, file.substr(file.size() - bytes.size()));
	reader.toVertices(40);
	EXPECT_EQ(positionIn(reader.nextVertex(), layout).x, mesh.points[40][0]);
}

TEST(PlyRecordLayouts, RefuseWhatCannotBeReadInPieces)
{
	const Folder folder;
	EXPECT_THROW(readRecordLayout(folder.put("text.ply", asciiPly(torus(5)))), AppError);
	EXPECT_THROW(readRecordLayout(folder.path("absent.ply")), AppError);
	const std::string     whole  = binaryPly(torus(5), true, false);
	const std::string     path   = folder.put("cut.ply", whole.substr(0, whole.size() / 2));
	const PlyRecordLayout layout = readRecordLayout(path);
	PlyRecordReader       reader(path, layout);
	FaceRecord            face;
	const auto            readAll = [&] {
        reader.toFaces();
        for (int f = 0; f < 50; ++f)
            reader.nextFace(face);
	};
	EXPECT_THROW(readAll(), AppError);
}

TEST(TextPieces, EndAtLinesThatDoNotGoOnAndCountThem)
{
	const Folder folder;
	std::string  text, read;
	for (int i = 0; i < 500; ++i)
		text +=
			"v " + std::to_string(i) + (i % 3 ? "\n" : " \\\r\n") + std::string(i % 50, 'x') + "\n";
	text += std::string(3000, 'y') + "\nthe last one";
	const std::string path = folder.put("text", text);
	TextPieces        pieces(path, 0, 0, 100); // pieces of few lines, and a longer line
	int               num = 0;
	for (std::string_view piece = pieces.next(); !piece.empty(); piece = pieces.next()) {
		EXPECT_EQ(pieces.linesBefore(), std::size_t(std::count(read.begin(), read.end(), '\n')));
		read += piece;
		EXPECT_EQ(pieces.bytesLeft(), text.size() - read.size());
		EXPECT_TRUE(read.size() == text.size() || piece.back() == '\n');
		EXPECT_TRUE(piece.size() < 3 || piece.substr(piece.size() - 3) != "\\\r\n");
		++num;
	}
	EXPECT_EQ(read, text);
	EXPECT_GT(num, 20);
	EXPECT_EQ(TextPieces(path, text.size() - 4).next(), " one");
}

TEST(TextPieces, AreReadByTextSourceAsOneText)
{
	const Folder folder;
	std::string  text;
	for (int i = 0; i < 300; ++i)
		text += std::to_string(i) + (i % 7 ? " " : " # 5 6 7\n");
	text += "\nx";
	TextPieces pieces(folder.put("text", text), 0, 10, 64);
	TextSource source(pieces);
	for (int i = 0; i < 300; ++i)
		ASSERT_EQ(source.whole(PlyType::Int32), i);
	try {
		source.real(PlyType::Float32);
		FAIL() << "x is no number";
	}
	catch (const AppError& error) {
		const auto line = 11 + std::count(text.begin(), text.end(), '\n');
		EXPECT_EQ(std::string(error.what()).find("line " + std::to_string(line) + ":"), 0u)
			<< error.what();
	}
}

TEST(RankedSet, CountsWhatIsBelow)
{
	const std::uint64_t        limit = 5000;
	RankedSet                  set(limit);
	std::vector<std::uint64_t> rank;
	std::uint64_t              num = 0;
	for (std::uint64_t i = 0; i < limit; ++i) {
		rank.push_back(num);
		if (i * i % 7 != 1) continue;
		set.insert(i);
		++num;
	}
	set.finish();
	EXPECT_EQ(set.size(), num);
	for (std::uint64_t i = 0; i < limit; ++i) {
		ASSERT_EQ(set.rank(i), rank[std::size_t(i)]);
		ASSERT_EQ(set.has(i), i * i % 7 == 1);
	}
}

/// As a whole, and in some twenty shares.
TEST(ConvertBinaryStl, GivesTheSameForAnyMemory)
{
	const Folder           folder;
	const std::string      stl = folder.put("in.stl", binaryStl(torus(200)));
	const RunLimit         limit;
	const ProgressCallback progress;
	const auto             converted = [&](double memoryBytes) {
        std::filesystem::create_directories(folder.path("scratch"));
        const std::string out = folder.path("out.ply");
        convertBinaryStl({stl, out, folder.path("scratch"), memoryBytes, limit, progress});
        std::ifstream file(out, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
	};
	const std::string large = converted(1e9);
	EXPECT_EQ(large, converted(1e6));
	EXPECT_NE(large.find("element vertex 40000\n"), std::string::npos);
}

TEST(FileStamp, TellsAChangedByteAndAChangedLength)
{
	const Folder      folder;
	std::string       content(100000, 'a');
	const std::string path   = folder.put("file", content);
	const FileStamp   before = stampOf(path);
	EXPECT_NO_THROW(requireStamp(path, before));
	content[77777] = 'b';
	folder.put("file", content);
	EXPECT_THROW(requireStamp(path, before), AppError);
	content[77777] = 'a';
	folder.put("file", content + 'a');
	EXPECT_THROW(requireStamp(path, before), AppError);
}

TEST(SplitLongBorderEdges, LeavesNoneAndKeepsTheArea)
{
	InputMesh               mesh   = inputMesh(grid(3));
	const double            before = areaOf(mesh);
	std::vector<SharedName> names(mesh.vertexNum());
	splitLongBorderEdges(0.1, mesh, names);
	EXPECT_NEAR(areaOf(mesh), before, 1e-6);
	EXPECT_EQ(names.size(), mesh.vertexNum());
	const std::vector<double> lengths = borderLengths(mesh);
	EXPECT_EQ(lengths.size(), 12u * 4);
	for (double length : lengths)
		EXPECT_NEAR(length, 1.0 / 12, 1e-6);
}

/// The split leaves repeated faces repeated, whatever their first corner and their orientation.
TEST(SplitLongBorderEdges, RepeatedFacesStayRepeated)
{
	TestMesh square;
	square.points  = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
	square.faces   = {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {2, 1, 3}};
	InputMesh mesh = inputMesh(square);
	EXPECT_EQ(borderEdges(mesh.view()).size(), 4u);
	std::vector<SharedName> names(mesh.vertexNum());
	splitLongBorderEdges(0.3, mesh, names);
	std::map<std::array<int, 3>, int> num;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		std::array<int, 3> corner{};
		std::copy_n(&mesh.triangles[3 * f], 3, corner.begin());
		std::sort(corner.begin(), corner.end());
		++num[corner];
	}
	std::map<int, int> ofNum;
	for (const auto& face : num)
		++ofNum[face.second];
	EXPECT_EQ(ofNum, (std::map<int, int>{{1, 7}, {3, 7}}));
	EXPECT_EQ(borderEdges(mesh.view()).size(), 16u);
}

/// Edges at the same place, which the last step sews.
TEST(SplitLongBorderEdges, GivesBothSidesOfACrackTheSamePlaces)
{
	TestMesh two;
	two.points                   = {{0.1, 0.2, 0.3}, {1.7, 0.1, 0.2}, {1.3, 1.9, 0.1},
									{1.3, 1.9, 0.1}, {0.2, 1.1, 0.7}, {0.1, 0.2, 0.3}};
	two.faces                    = {{0, 1, 2}, {3, 4, 5}};
	InputMesh               mesh = inputMesh(two);
	std::vector<SharedName> names(mesh.vertexNum());
	splitLongBorderEdges(0.01, mesh, names);
	std::set<std::array<double, 3>> places;
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		const Vec3d p = mesh.view().position(v);
		places.insert({p.x, p.y, p.z});
	}
	const double crack = std::hypot(1.2, 1.7, 0.2);
	EXPECT_EQ(mesh.vertexNum() - places.size(), std::size_t(std::ceil(crack / 0.01)) + 1);
}

TEST(BorderEdges, AreThoseThatOneFaceHas)
{
	EXPECT_EQ(borderEdges(inputMesh(grid(7)).view()).size(), 4u * 7);
	EXPECT_TRUE(borderEdges(inputMesh(torus(7)).view()).empty());
	TestMesh two;
	two.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
	two.faces  = {{0, 1, 2}, {2, 1, 3}};
	EXPECT_EQ(borderEdges(inputMesh(two).view()),
			  (std::vector<Edge>{{0, 1}, {0, 2}, {1, 3}, {2, 3}}));
}

/// The two faces of a square, each in a tile of its own and with its own order of vertices.
TEST(SplitLongBorderEdges, GivesTwoTilesTheSameVertices)
{
	const std::vector<std::array<double, 3>> corner = {
		{0.1, 0.2, 0.3}, {1.7, 0.1, 0.2}, {1.3, 1.9, 0.1}, {0.2, 1.1, 0.7}};
	const auto tileOf = [&](const std::array<int, 3>& of, InputMesh& mesh) {
		TestMesh                tile;
		std::vector<SharedName> names;
		for (int v : of) {
			tile.points.push_back(corner[std::size_t(v)]);
			names.push_back(v == 0 || v == 2 ? SharedName{std::uint32_t(v), std::uint32_t(v), 0}
											 : SharedName());
		}
		tile.faces = {{0, 1, 2}};
		mesh       = inputMesh(tile);
		splitLongBorderEdges(0.15, mesh, names);
		std::map<std::array<std::uint32_t, 3>, std::array<double, 3>> shared;
		for (std::size_t v = 0; v < names.size(); ++v) {
			const Vec3d p = mesh.view().position(v);
			if (names[v].isShared())
				shared[{names[v].low, names[v].high, names[v].part}] = {p.x, p.y, p.z};
		}
		return shared;
	};
	InputMesh  one, other;
	const auto a = tileOf({0, 1, 2}, one), b = tileOf({2, 3, 0}, other);
	EXPECT_EQ(a, b);
	EXPECT_EQ(a.size(), 2 + std::size_t(std::ceil(std::hypot(1.2, 1.7, 0.2) / 0.15)) - 1);
}

TEST(SplitLongBorderEdges, CarriesTextureAndValues)
{
	InputMesh mesh = inputMesh(grid(1));
	for (std::size_t c = 0; c < 3 * mesh.faceNum(); ++c) {
		const Vec3d p = mesh.view().position(std::size_t(mesh.view().vertexOf(c)));
		mesh.attributes.texture.uv.push_back(float(p.x));
		mesh.attributes.texture.uv.push_back(float(p.y));
	}
	ValueColumn height{"height", PlyType::Float32, {}};
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
		height.values.push_back(mesh.view().position(v).x + 2 * mesh.view().position(v).y);
	mesh.attributes.ofVertices = {height};
	std::vector<SharedName> names(mesh.vertexNum());
	splitLongBorderEdges(0.3, mesh, names);
	ASSERT_GT(mesh.faceNum(), 10u);
	for (std::size_t c = 0; c < 3 * mesh.faceNum(); ++c) {
		const std::size_t v = std::size_t(mesh.view().vertexOf(c));
		const Vec3d       p = mesh.view().position(v);
		EXPECT_NEAR(mesh.attributes.texture.uv[2 * c], p.x, 1e-6);
		EXPECT_NEAR(mesh.attributes.texture.uv[2 * c + 1], p.y, 1e-6);
		EXPECT_NEAR(mesh.attributes.ofVertices[0].values[v], p.x + 2 * p.y, 1e-6);
	}
}

TEST(Record, TellsEveryDamage)
{
	const Folder folder;
	const Json   json = {
		  {"plan", "a name"}, {"area", 1.25}, {"bytes", 18446744073709551615u}, {"of", {1, 2}}};
	const std::string path = folder.path("record.json");
	writeJson(path, json);
	EXPECT_EQ(readJson(path), json);

	std::stringstream whole;
	whole << std::ifstream(path, std::ios::binary).rdbuf();
	for (std::size_t i = 0; i < whole.str().size(); ++i) {
		std::string damaged = whole.str();
		damaged[i]          = char(damaged[i] ^ (1 << i % 7));
		folder.put("record.json", damaged);
		try {
			EXPECT_EQ(readJson(path), json) << "a blank has changed at most, byte " << i;
		}
		catch (const AppError& error) {
			EXPECT_EQ(error.code, ExitCode::BadInput);
		}
	}
	EXPECT_EQ(readJson(folder.path("absent.json")), std::nullopt);
}

// A process of another machine, or a killed process, may have had our number.

TEST(SameProcessNumber, AFileOfAnotherProcessStaysWhereItIs)
{
	const Folder      folder;
	const std::string theirs =
		folder.put("out.txt.part" + std::to_string(processId()), "of another machine");
	OutputFile out(folder.path("out.txt"));
	out.text("ours");
	out.commit();
	EXPECT_EQ(checksumOf("ours"), stampOf(folder.path("out.txt")).checksum);
	EXPECT_EQ(checksumOf("of another machine"), stampOf(theirs).checksum);
}

TEST(SameProcessNumber, AFolderOfAnotherProcessStaysAsItIs)
{
	const Folder      folder;
	const RunFolder   run(folder.path("run"));
	const std::string theirs = run.scratch() + std::to_string(processId());
	std::filesystem::create_directory(run.path());
	std::filesystem::create_directory(theirs);
	std::ofstream(theirs + "/faces0") << "of another machine";
	std::string ours;
	{
		const ScratchFolder spill(run);
		ours = spill.path();
		EXPECT_TRUE(std::filesystem::is_empty(ours));
	}
	EXPECT_FALSE(std::filesystem::exists(ours));
	EXPECT_EQ(checksumOf("of another machine"), stampOf(theirs + "/faces0").checksum);
}

} // namespace gpr_test
