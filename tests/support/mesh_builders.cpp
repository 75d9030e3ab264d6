// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_builders.h"

#include "transforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

void addFace(TriangleMesh& mesh, int a, int b, int c)
{
	mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

/// Squares between rows of points; index(i, j) names the point. Diagonals alternate.
template <class Index>
void addSquares(TriangleMesh& mesh, int nx, int ny, const Index& index)
{
	for (int j = 0; j < ny; ++j) {
		for (int i = 0; i < nx; ++i) {
			const int a = index(i, j), b = index(i + 1, j);
			const int c = index(i + 1, j + 1), d = index(i, j + 1);
			if ((i + j) % 2 == 0) {
				addFace(mesh, a, b, c);
				addFace(mesh, a, c, d);
			}
			else {
				addFace(mesh, a, b, d);
				addFace(mesh, b, c, d);
			}
		}
	}
}

Vec3d onCircle(double turn, double radius, double z)
{
	return {radius * std::cos(2 * pi * turn), radius * std::sin(2 * pi * turn), z};
}

/// Midpoints of edges, each made once.
class Midpoints {
public:
	explicit Midpoints(TriangleMesh& mesh) : mesh_(mesh) {}

	int between(int a, int b)
	{
		const auto key   = std::make_pair(std::min(a, b), std::max(a, b));
		const auto found = vertex_.find(key);
		if (found != vertex_.end()) return found->second;
		mesh_.positions.push_back((mesh_.positions[a] + mesh_.positions[b]) * 0.5);
		return vertex_[key] = int(mesh_.positions.size()) - 1;
	}

private:
	TriangleMesh&                      mesh_;
	std::map<std::pair<int, int>, int> vertex_;
};

TriangleMesh icosahedron()
{
	const double       g = (1 + std::sqrt(5.0)) / 2;
	const TriangleMesh mesh{{{-1, g, 0},
							 {1, g, 0},
							 {-1, -g, 0},
							 {1, -g, 0},
							 {0, -1, g},
							 {0, 1, g},
							 {0, -1, -g},
							 {0, 1, -g},
							 {g, 0, -1},
							 {g, 0, 1},
							 {-g, 0, -1},
							 {-g, 0, 1}},
							{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
							 4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
							 6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1}};
	return mesh;
}

} // namespace

TriangleMesh grid(int nx, int ny, double width, double height)
{
	TriangleMesh mesh;
	for (int j = 0; j <= ny; ++j) {
		for (int i = 0; i <= nx; ++i)
			mesh.positions.push_back({width * i / nx, height * j / ny, 0});
	}
	addSquares(mesh, nx, ny, [&](int i, int j) { return j * (nx + 1) + i; });
	return mesh;
}

TriangleMesh lattice(int nx, int ny)
{
	TriangleMesh mesh;
	const auto   index = [&](int i, int j) { return j * (nx + 1) + i; };
	for (int j = 0; j <= ny; ++j) {
		for (int i = 0; i <= nx; ++i)
			mesh.positions.push_back({i + 0.5 * j, std::sqrt(0.75) * j, 0});
	}
	for (int j = 0; j < ny; ++j) {
		for (int i = 0; i < nx; ++i) {
			const int a = index(i, j), b = index(i + 1, j);
			const int c = index(i, j + 1), d = index(i + 1, j + 1);
			mesh.triangles.insert(mesh.triangles.end(), {a, b, c, b, d, c});
		}
	}
	return mesh;
}

TriangleMesh jitteredGrid(int n, double jitter, Random& random)
{
	TriangleMesh mesh = grid(n, n);
	for (Vec3d& p : mesh.positions) {
		const bool inner = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
		if (!inner) continue;
		p.x += random.between(-jitter, jitter) / n;
		p.y += random.between(-jitter, jitter) / n;
	}
	return mesh;
}

TriangleMesh bentSheet(int n, double angleRad)
{
	TriangleMesh mesh = grid(n, n);
	for (Vec3d& p : mesh.positions) {
		const double beyond = p.x - 0.5;
		if (beyond <= 0) continue;
		p.x = 0.5 + beyond * std::cos(angleRad);
		p.z = beyond * std::sin(angleRad);
	}
	return mesh;
}

TriangleMesh crossedCreases(int n, double slope)
{
	TriangleMesh mesh = grid(n, n);
	for (Vec3d& p : mesh.positions)
		p.z = slope * (std::abs(p.x - 0.5) + std::abs(p.y - 0.5));
	return mesh;
}

TriangleMesh fadingCrease(int n, double angleRad)
{
	TriangleMesh mesh = grid(n, n);
	for (Vec3d& p : mesh.positions)
		p.z = std::abs(p.x - 0.5) * std::tan(0.5 * angleRad * (1 - p.y));
	return mesh;
}

TriangleMesh twoSheets(int n, double gap)
{
	return joined(grid(n, n), shifted(grid(n, n), {0, 0, gap}));
}

TriangleMesh gridWhere(int n, double side, const std::function<bool(int i, int j)>& keep)
{
	const TriangleMesh whole = grid(n, n, side, side);
	TriangleMesh       mesh;
	mesh.positions = whole.positions;
	for (int f = 0; f < int(whole.faceNum()); ++f) {
		if (!keep(f / 2 % n, f / 2 / n)) continue;
		const std::int32_t* t = &whole.triangles[3 * f];
		addFace(mesh, t[0], t[1], t[2]);
	}
	return withoutUnused(mesh);
}

TriangleMesh squareFrame(int n, int holeCells)
{
	const int low = (n - holeCells) / 2, high = low + holeCells;
	return gridWhere(n, 1,
					 [&](int i, int j) { return i < low || i >= high || j < low || j >= high; });
}

TriangleMesh openCylinder(int around, int along, double radius, double height)
{
	TriangleMesh mesh;
	for (int j = 0; j <= along; ++j) {
		for (int i = 0; i < around; ++i)
			mesh.positions.push_back(onCircle(double(i) / around, radius, height * j / along));
	}
	addSquares(mesh, around, along, [&](int i, int j) { return j * around + i % around; });
	return mesh;
}

TriangleMesh cone(int around, int along, double radius, double height)
{
	TriangleMesh mesh;
	mesh.positions.push_back({0, 0, 0});
	for (int j = 1; j <= along; ++j) {
		const double share = double(j) / along;
		for (int i = 0; i < around; ++i)
			mesh.positions.push_back(onCircle(double(i) / around, radius * share, height * share));
	}
	for (int i = 0; i < around; ++i)
		addFace(mesh, 0, 1 + (i + 1) % around, 1 + i);
	TriangleMesh side;
	addSquares(side, around, along - 1, [&](int i, int j) { return 1 + j * around + i % around; });
	mesh.triangles.insert(mesh.triangles.end(), side.triangles.begin(), side.triangles.end());
	return mesh;
}

TriangleMesh moebiusStrip(int around, int across)
{
	TriangleMesh mesh;
	for (int i = 0; i < around; ++i) {
		const double turn = double(i) / around;
		for (int j = 0; j <= across; ++j) {
			const double s = double(j) / across - 0.5;
			mesh.positions.push_back(
				onCircle(turn, 1 + s * std::cos(pi * turn), s * std::sin(pi * turn)));
		}
	}
	// The last column is the first column upside down.
	addSquares(mesh, around, across,
			   [&](int i, int j) { return i < around ? i * (across + 1) + j : across - j; });
	return mesh;
}

TriangleMesh icosphere(int level, double radius)
{
	TriangleMesh mesh = icosahedron();
	for (int i = 0; i < level; ++i)
		mesh = subdivided(mesh);
	for (Vec3d& p : mesh.positions)
		p = normalized(p) * radius;
	return mesh;
}

TriangleMesh uvSphere(int rings, int segments, double radius)
{
	TriangleMesh mesh;
	mesh.positions.push_back({0, 0, -radius});
	for (int j = 1; j < rings; ++j) {
		const double latitude = pi * (double(j) / rings - 0.5);
		for (int i = 0; i < segments; ++i)
			mesh.positions.push_back(onCircle(double(i) / segments, radius * std::cos(latitude),
											  radius * std::sin(latitude)));
	}
	mesh.positions.push_back({0, 0, radius});
	const auto index = [&](int i, int j) { return 1 + j * segments + i % segments; };
	const int  top   = int(mesh.positions.size()) - 1;
	for (int i = 0; i < segments; ++i) {
		addFace(mesh, 0, index(i + 1, 0), index(i, 0));
		addFace(mesh, top, index(i, rings - 2), index(i + 1, rings - 2));
	}
	addSquares(mesh, segments, rings - 2, index);
	return mesh;
}

TriangleMesh torus(int n, int m, double axisRadius, double tubeRadius)
{
	TriangleMesh mesh;
	for (int j = 0; j < m; ++j) {
		const double tube = 2 * pi * j / m;
		for (int i = 0; i < n; ++i)
			mesh.positions.push_back(onCircle(double(i) / n,
											  axisRadius + tubeRadius * std::cos(tube),
											  tubeRadius * std::sin(tube)));
	}
	addSquares(mesh, n, m, [&](int i, int j) { return j % m * n + i % n; });
	return mesh;
}

TriangleMesh box(int nx, int ny, int nz, const Vec3d& size)
{
	TriangleMesh                      mesh;
	std::map<std::array<int, 3>, int> vertexAt;
	const int                         cells[3] = {nx, ny, nz};
	const auto                        vertex   = [&](const std::array<int, 3>& at) {
        const auto found = vertexAt.emplace(at, int(mesh.positions.size()));
        if (found.second)
            mesh.positions.push_back(
										 {size.x * at[0] / nx, size.y * at[1] / ny, size.z * at[2] / nz});
        return found.first->second;
	};
	for (int axis = 0; axis < 3; ++axis) {
		const int u = (axis + 1) % 3, v = (axis + 2) % 3;
		for (bool far : {false, true}) {
			// Seen from outside, the near side runs through its axes the other way round.
			const auto index = [&](int i, int j) {
				std::array<int, 3> at{};
				at[axis]        = far ? cells[axis] : 0;
				at[far ? u : v] = i;
				at[far ? v : u] = j;
				return vertex(at);
			};
			addSquares(mesh, cells[far ? u : v], cells[far ? v : u], index);
		}
	}
	return mesh;
}

TriangleMesh cube(int n)
{
	return box(n, n, n, {1, 1, 1});
}

TriangleMesh lPrism(int n)
{
	using Place = std::array<int, 3>;
	TriangleMesh         mesh;
	std::map<Place, int> vertexAt;
	const auto           vertex = [&](const Place& at) {
        const auto found = vertexAt.emplace(at, int(mesh.positions.size()));
        if (found.second) mesh.positions.push_back(Vec3d(at[0], at[1], at[2]) * (1.0 / n));
        return found.first->second;
	};
	const auto isInside = [&](const Place& at) {
		const bool inBox =
			at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] < 2 * n && at[1] < 2 * n && at[2] < n;
		return inBox && (at[0] < n || at[1] < n);
	};
	/// The square between a cell and its neighbour before or behind the cell along an axis.
	const auto addSquare = [&](Place at, int axis, bool far) {
		const int u = (axis + 1) % 3, v = (axis + 2) % 3;
		at[axis] += far;
		addSquares(mesh, 1, 1, [&](int i, int j) {
			Place corner = at;
			corner[far ? u : v] += i;
			corner[far ? v : u] += j;
			return vertex(corner);
		});
	};
	for (int cell = 0; cell < 4 * n * n * n; ++cell) {
		const Place at = {cell % (2 * n), cell / (2 * n) % (2 * n), cell / (4 * n * n)};
		for (int side = 0; side < 6 && isInside(at); ++side) {
			Place beyond = at;
			beyond[side / 2] += side % 2 == 1 ? 1 : -1;
			if (!isInside(beyond)) addSquare(at, side / 2, side % 2 == 1);
		}
	}
	return mesh;
}

TriangleMesh arch()
{
	TriangleMesh bent = grid(6, 8, 1, 4);
	for (Vec3d& p : bent.positions)
		p = {-std::cos(pi * p.x), p.y, std::sin(pi * p.x)};
	return bent;
}

TriangleMesh archOverLeaf()
{
	TriangleMesh leaf = grid(2, 2, 0.04, 0.45);
	for (Vec3d& p : leaf.positions)
		p = {p.x - 0.02, 2, p.y + 0.5};
	return joined(arch(), leaf);
}

TriangleMesh thinPlate(int n, double thickness)
{
	return box(n, n, 1, {1, 1, thickness});
}

TriangleMesh closedCylinder(int around, int along, double radius, double height)
{
	TriangleMesh mesh   = openCylinder(around, along, radius, height);
	const int    bottom = int(mesh.positions.size()), top = bottom + 1;
	mesh.positions.push_back({0, 0, 0});
	mesh.positions.push_back({0, 0, height});
	for (int i = 0; i < around; ++i) {
		const int next = (i + 1) % around;
		addFace(mesh, bottom, next, i);
		addFace(mesh, top, along * around + i, along * around + next);
	}
	return mesh;
}

TriangleMesh ringPlate(int around, double innerRadius, double height)
{
	TriangleMesh mesh;
	const double profile[4][2] = {{1, 0}, {1, height}, {innerRadius, height}, {innerRadius, 0}};
	for (const auto& [radius, z] : profile) {
		for (int i = 0; i < around; ++i)
			mesh.positions.push_back(onCircle(double(i) / around, radius, z));
	}
	addSquares(mesh, around, 4, [&](int i, int k) { return k % 4 * around + i % around; });
	return mesh;
}

TriangleMesh noisySphere(int level, double amplitude, Random& random)
{
	TriangleMesh mesh = icosphere(level);
	for (Vec3d& p : mesh.positions)
		p = p * (1 + random.between(-amplitude, amplitude));
	return mesh;
}

TriangleMesh kleinBottle(int n, int m)
{
	TriangleMesh mesh;
	for (int i = 0; i < n; ++i) {
		const double u = 2 * pi * i / n;
		for (int j = 0; j < m; ++j) {
			const double v = 2 * pi * j / m;
			const double a = std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
			const double b = std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v);
			mesh.positions.push_back(onCircle(double(i) / n, 2 + a, b));
		}
	}
	// Once round, the tube's section (a figure of eight) comes back turned by half a turn.
	addSquares(mesh, n, m, [&](int i, int j) { return i < n ? i * m + j % m : (m - j % m) % m; });
	return mesh;
}

TriangleMesh fansSharingVertex(int fanNum)
{
	TriangleMesh mesh;
	mesh.positions.push_back({0, 0, 0});
	for (int fan = 0; fan < fanNum; ++fan) {
		const int first = int(mesh.positions.size());
		for (int k = 0; k < 4; ++k) {
			// Each fan takes a quarter of its share of the circle, and a height of its own.
			const double turn = (fan + 0.25 * k / 3) / fanNum;
			mesh.positions.push_back(onCircle(turn, 1, 0.1 * fan));
		}
		for (int k = 0; k < 3; ++k)
			addFace(mesh, 0, first + k, first + k + 1);
	}
	return mesh;
}

TriangleMesh finsOnEdge(int finNum)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {0, 0, 1}};
	for (int fin = 0; fin < finNum; ++fin) {
		mesh.positions.push_back(onCircle(double(fin) / finNum, 1, 0.5));
		addFace(mesh, 0, 1, 2 + fin);
	}
	return mesh;
}

TriangleMesh soupOf(const TriangleMesh& mesh, double noise, Random& random)
{
	TriangleMesh soup;
	for (std::int32_t v : mesh.triangles) {
		Vec3d p = mesh.positions[v];
		p += Vec3d(random.between(-noise, noise), random.between(-noise, noise),
				   random.between(-noise, noise));
		soup.triangles.push_back(int(soup.positions.size()));
		soup.positions.push_back(p);
	}
	return soup;
}

std::vector<int> randomParts(const TriangleMesh& mesh, int partNum, Random& random)
{
	std::map<std::pair<int, int>, std::vector<int>> facesAt; // an edge
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		const int a = mesh.triangles[i], b = mesh.triangles[i % 3 == 2 ? i - 2 : i + 1];
		facesAt[{std::min(a, b), std::max(a, b)}].push_back(int(i / 3));
	}
	std::vector<std::vector<int>> neighbours(mesh.faceNum());
	for (const auto& [edge, faces] : facesAt) {
		for (int f : faces)
			neighbours[std::size_t(f)].insert(neighbours[std::size_t(f)].end(), faces.begin(),
											  faces.end());
	}
	std::vector<int> part(mesh.faceNum(), -1), front;
	const auto       take = [&](int f, int number) {
        if (part[std::size_t(f)] >= 0) return;
        part[std::size_t(f)] = number;
        front.push_back(f);
	};
	for (int i = 0; i < partNum; ++i)
		take(random.below(int(mesh.faceNum())), i);
	for (int f = 0; f < int(mesh.faceNum()); ++f) {
		// Faces of components without a start become parts at the end.
		while (!front.empty()) {
			const std::size_t at = std::size_t(random.below(int(front.size())));
			const int         g  = front[at];
			front[at]            = front.back();
			front.pop_back();
			for (int n : neighbours[std::size_t(g)])
				take(n, part[std::size_t(g)]);
		}
		take(f, random.below(partNum));
	}
	return part;
}

TriangleMesh withHoles(const TriangleMesh& mesh, int holeNum, Random& random)
{
	std::vector<std::set<int>>         facesAt(mesh.vertexNum());
	std::map<std::pair<int, int>, int> uses;
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		const int a = mesh.triangles[i], b = mesh.triangles[i % 3 == 2 ? i - 2 : i + 1];
		facesAt[a].insert(int(i / 3));
		++uses[{std::min(a, b), std::max(a, b)}];
	}
	// Vertices whose surroundings are still whole; two rings round a hole or a border are not.
	std::set<int> taken;
	const auto    takeRing = [&](const std::set<int>& centres) {
        std::set<int> ring;
        for (int v : centres) {
            for (int f : facesAt[v])
                ring.insert(&mesh.triangles[3 * f], &mesh.triangles[3 * f] + 3);
        }
        taken.insert(ring.begin(), ring.end());
        return ring;
	};
	std::set<int> border;
	for (const auto& use : uses) {
		if (use.second != 1) continue;
		border.insert(use.first.first);
		border.insert(use.first.second);
	}
	takeRing(border);
	std::set<int> droppedFaces;
	for (int hole = 0, tries = 0; hole < holeNum && tries < 1000; ++tries) {
		const int v = random.below(int(mesh.vertexNum()));
		if (taken.count(v) || facesAt[v].empty()) continue;
		droppedFaces.insert(facesAt[v].begin(), facesAt[v].end());
		takeRing(takeRing(takeRing({v})));
		++hole;
	}
	TriangleMesh result;
	result.positions = mesh.positions;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		if (droppedFaces.count(int(f))) continue;
		const std::int32_t* t = &mesh.triangles[3 * f];
		addFace(result, t[0], t[1], t[2]);
	}
	return withoutUnused(result);
}

TriangleMesh damaged(const TriangleMesh& mesh, int editNum, Random& random)
{
	TriangleMesh result = mesh;
	for (int i = 0; i < editNum; ++i) {
		const int faceNum = int(result.faceNum());
		if (faceNum < 2) break;
		const auto t = result.triangles.begin() + 3 * random.below(faceNum);
		switch (random.below(5)) {
		case 0:
			result.triangles.erase(t, t + 3);
			break;
		case 1:
			addFace(result, t[0], t[1], t[2]);
			break;
		case 2:
			std::swap(t[1], t[2]);
			break;
		case 3:
			t[random.below(3)] = result.triangles[random.below(3 * faceNum)];
			break;
		default:
			addFace(result, t[0], t[1], random.below(int(result.vertexNum())));
			break;
		}
	}
	return result;
}

TriangleMesh randomSurface(Random& random)
{
	TriangleMesh mesh;
	switch (random.below(7)) {
	case 0:
		mesh = jitteredGrid(8 + random.below(25), random.between(0, 0.3), random);
		break;
	case 1:
		mesh = noisySphere(2 + random.below(2), random.between(0, 0.05), random);
		break;
	case 2:
		mesh = torus(12 + random.below(30), 8 + random.below(20));
		break;
	case 3:
		mesh = openCylinder(8 + random.below(20), 4 + random.below(20), 0.5, 1.5);
		break;
	case 4:
		mesh = cube(4 + random.below(8));
		break;
	case 5:
		mesh = uvSphere(6 + random.below(12), 8 + random.below(16));
		break;
	default:
		mesh = bentSheet(8 + random.below(20), random.between(0, 1.5));
		break;
	}
	if (random.chance(0.4)) mesh = withHoles(mesh, 1 + random.below(3), random);
	if (random.chance(0.2)) mesh = joined(mesh, shifted(icosphere(2, 0.5), {3, 0, 0}));
	return shuffled(mesh, random);
}

TriangleMesh subdivided(const TriangleMesh& mesh)
{
	TriangleMesh result;
	result.positions = mesh.positions;
	Midpoints midpoints(result);
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const std::int32_t* t  = &mesh.triangles[3 * f];
		const int           ab = midpoints.between(t[0], t[1]);
		const int           bc = midpoints.between(t[1], t[2]);
		const int           ca = midpoints.between(t[2], t[0]);
		addFace(result, t[0], ab, ca);
		addFace(result, t[1], bc, ab);
		addFace(result, t[2], ca, bc);
		addFace(result, ab, bc, ca);
	}
	return result;
}

} // namespace gpr::test
