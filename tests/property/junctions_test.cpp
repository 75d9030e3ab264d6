// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets with junctions: results keep the junctions, and sheets share vertices there. All facts are
// computed from the list of triangles alone.
#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/run_options.h>
#include <vcg_extras/core/prepared_surface.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace gpr::test {

namespace {

using Edge = std::pair<int, int>;

struct Complex {
	TriangleMesh              mesh;
	std::vector<std::int32_t> region;
};

/// Facts about the junctions of a list of triangles.
struct JunctionFacts {
	int    sheets = 0, points = 0, lines = 0, openEdges = 0;
	double length = 0; ///< of the edges with more than two faces

	bool operator==(const JunctionFacts& o) const
	{
		return sheets == o.sheets && points == o.points && lines == o.lines;
	}
};

std::ostream& operator<<(std::ostream& out, const JunctionFacts& f)
{
	return out << f.sheets << " sheets, " << f.points << " points, " << f.lines << " lines";
}

std::map<Edge, std::vector<int>> facesOfEdges(const TriangleMesh& mesh)
{
	std::map<Edge, std::vector<int>> faces;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c)
		faces[std::minmax(mesh.triangles[c], mesh.triangles[c % 3 == 2 ? c - 2 : c + 1])].push_back(
			int(c / 3));
	return faces;
}

int root(std::vector<int>& parent, int i)
{
	while (parent[std::size_t(i)] != i)
		i = parent[std::size_t(i)] = parent[std::size_t(parent[std::size_t(i)])];
	return i;
}

int setNum(std::vector<int>& parent, const std::set<int>& of)
{
	std::set<int> roots;
	for (int i : of)
		roots.insert(root(parent, i));
	return int(roots.size());
}

/// The number of lines is half the number of line ends at points, and the number of loops.
JunctionFacts factsOfJunctions(const TriangleMesh& mesh)
{
	JunctionFacts                   facts;
	std::vector<int>                sheet(mesh.faceNum()), chain(mesh.vertexNum());
	std::map<int, std::vector<int>> next;
	std::iota(sheet.begin(), sheet.end(), 0);
	std::iota(chain.begin(), chain.end(), 0);
	for (const auto& [edge, faces] : facesOfEdges(mesh)) {
		facts.openEdges += faces.size() == 1;
		if (faces.size() == 2) sheet[std::size_t(root(sheet, faces[0]))] = root(sheet, faces[1]);
		if (faces.size() < 3) continue;
		next[edge.first].push_back(edge.second);
		next[edge.second].push_back(edge.first);
		chain[std::size_t(root(chain, edge.first))] = root(chain, edge.second);
		facts.length += length(mesh.positions[std::size_t(edge.first)] -
							   mesh.positions[std::size_t(edge.second)]);
	}
	std::set<int> all, withPoint;
	int           endNum = 0;
	for (std::size_t f = 0; f < sheet.size(); ++f)
		all.insert(int(f));
	facts.sheets = setNum(sheet, all);
	std::set<int> onLines;
	for (const auto& [v, others] : next) {
		onLines.insert(v);
		if (others.size() == 2) continue;
		++facts.points;
		endNum += int(others.size());
		withPoint.insert(v);
	}
	facts.lines = endNum / 2 + setNum(chain, onLines) - setNum(chain, withPoint);
	return facts;
}

/// The number of edges of the faces round a label without a matching edge in the other direction.
int openEdgesOf(const TriangleMesh& mesh, const std::vector<std::int32_t>& region, int label)
{
	std::map<Edge, int> balance;
	for (std::size_t f = 0; f < region.size(); ++f) {
		const int low = region[f] / 100, high = region[f] % 100;
		if (low != label && high != label) continue;
		for (std::size_t k = 0; k < 3; ++k) {
			const int a = mesh.triangles[3 * f + k], b = mesh.triangles[3 * f + (k + 1) % 3];
			const int sign = (a < b) == (low == label) ? 1 : -1;
			balance[std::minmax(a, b)] += sign;
		}
	}
	return int(
		std::count_if(balance.begin(), balance.end(), [](const auto& b) { return b.second != 0; }));
}

/// Walls between blocks of voxels with different labels, 0 outside. Each wall separates the lower
/// from the higher label, and has the region 100 lower + higher.
class Walls {
public:
	template <class LabelAt>
	Walls(int size, const LabelAt& labelAt)
	{
		for (int axis = 0; axis < 3; ++axis) {
			for (int i = 0; i < (size + 1) * size * size; ++i) {
				std::array<int, 3> cell{};
				cell[std::size_t(axis)]           = i / (size * size);
				cell[std::size_t((axis + 1) % 3)] = i / size % size;
				cell[std::size_t((axis + 2) % 3)] = i % size;
				std::array<int, 3> before         = cell;
				--before[std::size_t(axis)];
				const int a = before[std::size_t(axis)] < 0 ? 0 : labelAt(before);
				const int b = cell[std::size_t(axis)] == size ? 0 : labelAt(cell);
				if (a != b) addWall(axis, cell, a, b);
			}
		}
	}
	Complex take() { return std::move(out_); }

private:
	Complex                           out_;
	std::map<std::array<int, 3>, int> number_;

	int vertexAt(const std::array<int, 3>& at)
	{
		const auto [known, isNew] = number_.insert({at, int(number_.size())});
		if (isNew) out_.mesh.positions.push_back({double(at[0]), double(at[1]), double(at[2])});
		return known->second;
	}

	void addWall(int axis, const std::array<int, 3>& cell, int a, int b)
	{
		std::array<int, 4> corner{};
		for (int k = 0; k < 4; ++k) {
			std::array<int, 3> at = cell;
			at[std::size_t((axis + 1) % 3)] += k == 1 || k == 2;
			at[std::size_t((axis + 2) % 3)] += k >= 2;
			corner[std::size_t(k)] = vertexAt(at);
		}
		if (a > b) std::swap(corner[1], corner[3]);
		for (const auto& t : {std::array<int, 3>{0, 1, 2}, std::array<int, 3>{0, 2, 3}}) {
			for (int k : t)
				out_.mesh.triangles.push_back(corner[std::size_t(k)]);
			out_.region.push_back(100 * std::min(a, b) + std::max(a, b));
		}
	}
};

/// Blocks of size³ voxels, cut by planes at random: cells as large as these are worth keeping.
Complex randomCells(int size, Random& random)
{
	struct Seed {
		double at[3];
	};
	std::vector<Seed> seeds(3);
	for (Seed& s : seeds) {
		for (double& x : s.at)
			x = random.between(0.15, 0.85) * size;
	}
	return Walls(size,
				 [&](const std::array<int, 3>& cell) {
					 int    nearest = 0;
					 double least   = HUGE_VAL;
					 for (std::size_t i = 0; i < seeds.size(); ++i) {
						 double sum = 0;
						 for (std::size_t k = 0; k < 3; ++k)
							 sum += std::pow(cell[k] + 0.5 - seeds[i].at[k], 2);
						 if (sum >= least) continue;
						 least   = sum;
						 nearest = int(i) + 1;
					 }
					 return nearest;
				 })
		.take();
}

/// Two cubes with a common edge, or with a common corner if isCorner.
Complex touchingCubes(int size, bool isCorner)
{
	return Walls(2 * size,
				 [&](const std::array<int, 3>& cell) {
					 const bool x = cell[0] >= size, y = cell[1] >= size, z = cell[2] >= size;
					 if (x != y) return 0;
					 if (isCorner) return y == z ? 1 + x : 0;
					 return z ? 0 : 1 + x;
				 })
		.take();
}

RemeshResult remeshed(const Complex& complex, std::int64_t vertexNum, int threads = 2,
					  JunctionMode junctions = JunctionMode::Keep)
{
	RemeshOptions o;
	o.targetMode      = TargetMode::VertexNum;
	o.targetVertexNum = vertexNum;
	o.threads         = threads;
	o.junctions       = junctions;
	o.check           = true;
	MeshView view     = complex.mesh.view();
	view.region       = complex.region.data();
	return remesh(view, o);
}

void expectKept(const Complex& complex, const RemeshResult& result, std::int64_t vertexNum)
{
	ASSERT_EQ(result.status, Status::Ok) << result.message;
	EXPECT_EQ(std::int64_t(result.mesh.vertexNum()), vertexNum);
	EXPECT_TRUE(result.report.audit.junctionsKept);
	EXPECT_EQ(result.report.check.intersectingFaces, 0);
	const JunctionFacts before = factsOfJunctions(complex.mesh),
						after  = factsOfJunctions(result.mesh);
	EXPECT_EQ(before, after);
	EXPECT_EQ(after.openEdges, before.openEdges);
	EXPECT_NEAR(after.length, before.length, 0.1 * before.length); // stairs
	for (int label = 0; label <= 3; ++label)
		EXPECT_EQ(openEdgesOf(result.mesh, result.region, label), 0) << "label " << label;
}

TEST(Junctions, CubesThatShareAnEdge)
{
	const Complex      cubes  = touchingCubes(6, false);
	const RemeshResult result = remeshed(cubes, 200);
	expectKept(cubes, result, 200);
	const JunctionFacts facts = factsOfJunctions(result.mesh);
	EXPECT_EQ(facts.lines, 1);
	EXPECT_NEAR(facts.length, 6, 1e-6);
}

void expectSharedCorner(const RemeshResult& result)
{
	const auto isMiddle = [](const Vec3d& p) { return p == Vec3d(5, 5, 5); };
	EXPECT_EQ(std::count_if(result.mesh.positions.begin(), result.mesh.positions.end(), isMiddle),
			  1);
}

TEST(Junctions, CubesThatShareACorner)
{
	const Complex      cubes  = touchingCubes(5, true);
	const RemeshResult result = remeshed(cubes, 150);
	expectKept(cubes, result, 150);
	expectSharedCorner(result);
}

/// Small components are dropped after the sheets are separated; a prepared surface then copies the
/// separated mesh.
TEST(Junctions, StayInAPreparedSurface)
{
	const Complex cubes = touchingCubes(5, true);
	MeshView      view  = cubes.mesh.view();
	view.region         = cubes.region.data();
	PreparedSurface surface(view);
	RemeshOptions   o         = countOptions(150);
	o.junctions               = JunctionMode::Keep;
	o.dropComponentsBelow     = 10;
	o.check                   = true;
	const RemeshResult result = surface.remesh(o);
	expectKept(cubes, result, 150);
	expectSharedCorner(result);
}

TEST(Junctions, ASlitOfOneEdge)
{
	// A fin of one face stands on an edge inside of a sheet.
	Complex complex;
	complex.mesh      = bentSheet(12, 0.3);
	const auto  edges = facesOfEdges(complex.mesh);
	const auto  inner = std::find_if(edges.begin(), edges.end(), [&](const auto& e) {
        return e.first.first > int(complex.mesh.vertexNum() / 2) && e.second.size() == 2;
    });
	const Vec3d above(0, 0, 0.5);
	const Vec3d middle = (complex.mesh.positions[std::size_t(inner->first.first)] +
						  complex.mesh.positions[std::size_t(inner->first.second)]) *
						 0.5;
	complex.mesh.positions.push_back(middle + above);
	for (int v : {inner->first.first, inner->first.second, int(complex.mesh.vertexNum()) - 1})
		complex.mesh.triangles.push_back(v);
	complex.region.assign(complex.mesh.faceNum(), 1);
	const RemeshResult result = remeshed(complex, 120);
	ASSERT_EQ(result.status, Status::Ok) << result.message;
	EXPECT_EQ(factsOfJunctions(result.mesh), factsOfJunctions(complex.mesh));
}

/// Pages of a book: square sheets with the spine in common.
TriangleMesh book(int pageNum, int size)
{
	TriangleMesh mesh;
	for (int i = 0; i <= size; ++i)
		mesh.positions.push_back({double(i), 0, 0});
	for (int page = 0; page < pageNum; ++page) {
		const double       angle = 6.283185307179586 * page / pageNum;
		const std::int32_t first = std::int32_t(mesh.vertexNum());
		for (int j = 1; j <= size; ++j) {
			for (int i = 0; i <= size; ++i)
				mesh.positions.push_back({double(i), j * std::cos(angle), j * std::sin(angle)});
		}
		for (int j = 0; j < size; ++j) {
			for (int i = 0; i < size; ++i) {
				const std::int32_t a = (j == 0 ? 0 : first + (j - 1) * (size + 1)) + i,
								   b = first + j * (size + 1) + i;
				mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
			}
		}
	}
	return mesh;
}

TEST(Junctions, StayWithFewVertices)
{
	for (const int pageNum : {3, 6}) {
		const TriangleMesh mesh       = book(pageNum, 4);
		int                refusalNum = 0;
		for (std::int64_t num = 2 * pageNum + 2; num < 12 * pageNum; ++num) {
			SCOPED_TRACE(std::to_string(pageNum) + " pages, " + std::to_string(num) + " vertices");
			RemeshOptions o           = countOptions(num);
			o.junctions               = JunctionMode::Keep;
			const RemeshResult result = remesh(mesh.view(), o);
			if (result.status == Status::CountTooSmall) { // some triangles would be degenerate
				++refusalNum;
				continue;
			}
			ASSERT_EQ(result.status, Status::Ok) << result.message;
			EXPECT_EQ(std::int64_t(result.mesh.vertexNum()), num);
			EXPECT_EQ(factsOfJunctions(result.mesh), factsOfJunctions(mesh));
		}
		EXPECT_LT(refusalNum, 3 * pageNum) << pageNum << " pages";
	}
}

TEST(Junctions, RandomCellsStayClosed)
{
	for (std::uint32_t seed : testSeeds(6)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const Complex      cells = randomCells(9, random);
		const std::int64_t num   = std::int64_t(cells.mesh.vertexNum());
		expectKept(cells, remeshed(cells, num), num);
	}
}

TEST(Junctions, OfRandomCellsStayWithMatchedBorders)
{
	for (std::uint32_t seed : testSeeds(2)) {
		Random        random(seed);
		const Complex cells = randomCells(9, random);
		for (const double edge : {0.7, 1.2}) {
			SCOPED_TRACE("seed " + std::to_string(seed) + ", edge " + std::to_string(edge));
			RemeshOptions o;
			o.targetMode              = TargetMode::EdgeLength;
			o.targetEdgeLen           = edge;
			o.boundary                = BoundaryMode::Match;
			o.junctions               = JunctionMode::Keep;
			o.check                   = true;
			MeshView view             = cells.mesh.view();
			view.region               = cells.region.data();
			const RemeshResult result = remesh(view, o);
			ASSERT_EQ(result.status, Status::Ok) << result.message;
			expectKept(cells, result, std::int64_t(result.mesh.vertexNum()));
		}
	}
}

TEST(Junctions, AWishTakesMoreVerticesWhereSheetsWouldIntersect)
{
	// Two rooms of flat walls: the error alone would need fewer vertices than the sheets.
	const Complex rooms = Walls(2, [](const std::array<int, 3>& cell) {
							  return cell[1] == 0 && cell[2] == 0 ? 1 + cell[0] : 0;
						  }).take();
	RemeshOptions error, detail, length;
	error.targetMode     = TargetMode::MaxError;
	error.targetMaxError = 0.01;
	detail.targetMode    = TargetMode::Detail;
	detail.targetDetail  = Detail::Coarse;
	length.targetMode    = TargetMode::EdgeLength;
	length.targetEdgeLen = 2;
	for (RemeshOptions o : {error, detail, length}) {
		o.junctions               = JunctionMode::Keep;
		o.check                   = true;
		const RemeshResult result = remesh(rooms.mesh.view(), o);
		ASSERT_EQ(result.status, Status::Ok) << result.message;
		EXPECT_EQ(factsOfJunctions(result.mesh), factsOfJunctions(rooms.mesh));
		EXPECT_EQ(result.report.check.intersectingFaces, 0);
	}
}

/// The guard may make components anew, and refusals speak of no sheets.
TEST(Junctions, AreNoMatterOfASurfaceWithoutAny)
{
	const TriangleMesh slab = thinPlate(20, 0.01);
	for (const int vertexNum : {8, 40, 200}) {
		RemeshOptions keep    = countOptions(vertexNum);
		keep.junctions        = JunctionMode::Keep;
		const RemeshResult is = remesh(slab.view(), keep),
						   at = remesh(slab.view(), countOptions(vertexNum));
		EXPECT_EQ(is.status, at.status);
		EXPECT_EQ(is.message, at.message);
		EXPECT_EQ(is.mesh.positions, at.mesh.positions);
		EXPECT_EQ(is.mesh.triangles, at.mesh.triangles);
	}
}

TEST(Junctions, AreTheSameForAnyThreads)
{
	Random             random(3);
	const Complex      cells = randomCells(8, random);
	const RemeshResult one = remeshed(cells, 500, 1), two = remeshed(cells, 500, 2);
	ASSERT_EQ(one.status, Status::Ok) << one.message;
	EXPECT_EQ(one.mesh.positions, two.mesh.positions);
	EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
	EXPECT_EQ(one.region, two.region);
}

TEST(Junctions, ANoteTellsWhatKeepingWouldDo)
{
	const auto speaks = [](const RemeshResult& result) {
		return std::any_of(result.notes.begin(), result.notes.end(), [](const std::string& note) {
			return note.find("junctions with the value keep") != std::string::npos;
		});
	};
	const Complex cubes = touchingCubes(6, false);
	EXPECT_TRUE(speaks(remeshed(cubes, 200, 2, JunctionMode::Cut)));
	EXPECT_FALSE(speaks(remeshed(cubes, 200)));
}

} // namespace

} // namespace gpr::test
