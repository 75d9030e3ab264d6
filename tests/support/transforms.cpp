// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transforms.h"

#include "mesh_builders.h"

#include <cmath>
#include <map>
#include <numeric>

namespace gpr::test {

TriangleMesh shifted(const TriangleMesh& mesh, const Vec3d& by)
{
	TriangleMesh result = mesh;
	for (Vec3d& p : result.positions)
		p += by;
	return result;
}

TriangleMesh scaled(const TriangleMesh& mesh, double factor)
{
	TriangleMesh result = mesh;
	for (Vec3d& p : result.positions)
		p = p * factor;
	return result;
}

TriangleMesh rotated(const TriangleMesh& mesh, const Vec3d& axis, double angleRad)
{
	const Vec3d  n = normalized(axis);
	const double c = std::cos(angleRad), s = std::sin(angleRad);
	TriangleMesh result = mesh;
	for (Vec3d& p : result.positions)
		p = p * c + cross(n, p) * s + n * (dot(n, p) * (1 - c));
	return result;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b)
{
	TriangleMesh result = a;
	result.positions.insert(result.positions.end(), b.positions.begin(), b.positions.end());
	for (std::int32_t v : b.triangles)
		result.triangles.push_back(v + std::int32_t(a.vertexNum()));
	return result;
}

TriangleMesh shuffled(const TriangleMesh& mesh, Random& random)
{
	std::vector<int> newVertex(mesh.vertexNum()), faces(mesh.faceNum());
	std::iota(newVertex.begin(), newVertex.end(), 0);
	std::iota(faces.begin(), faces.end(), 0);
	random.shuffle(newVertex);
	random.shuffle(faces);
	TriangleMesh result;
	result.positions.resize(mesh.vertexNum());
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
		result.positions[newVertex[v]] = mesh.positions[v];
	for (int f : faces) {
		const int turn = random.below(3);
		for (int k = 0; k < 3; ++k)
			result.triangles.push_back(newVertex[mesh.triangles[3 * f + (k + turn) % 3]]);
	}
	return result;
}

TriangleMesh insideOut(const TriangleMesh& mesh)
{
	TriangleMesh result = mesh;
	for (std::size_t f = 0; f < result.faceNum(); ++f)
		std::swap(result.triangles[3 * f + 1], result.triangles[3 * f + 2]);
	return result;
}

TriangleMesh cutApart(const TriangleMesh& mesh, const std::vector<int>& partOf)
{
	TriangleMesh                       cut;
	std::map<std::pair<int, int>, int> vertexOf; // part and vertex
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		const auto added = vertexOf.insert(
			{{partOf[i / 3], mesh.triangles[i]}, std::int32_t(cut.positions.size())});
		if (added.second) cut.positions.push_back(mesh.positions[std::size_t(mesh.triangles[i])]);
		cut.triangles.push_back(added.first->second);
	}
	return cut;
}

TriangleMesh cubeOfSides(int n)
{
	const TriangleMesh whole = cube(n);
	std::vector<int>   side;
	for (std::size_t f = 0; f < whole.faceNum(); ++f) {
		const auto at = [&](std::size_t k) {
			return whole.positions[std::size_t(whole.triangles[3 * f + k])];
		};
		const Vec3d normal = cross(at(1) - at(0), at(2) - at(0));
		const int   axis   = std::abs(normal.x) > 1e-9 ? 0 : std::abs(normal.y) > 1e-9 ? 1 : 2;
		side.push_back(2 * axis + int(normal.x + normal.y + normal.z > 0));
	}
	return cutApart(whole, side);
}

TriangleMesh page(int n, double angleRad)
{
	const double right = std::acos(0.0);
	return rotated(rotated(grid(n, n), {1, 0, 0}, right), {0, 0, 1}, angleRad);
}

TriangleMesh withSlit(const TriangleMesh& mesh, int v)
{
	std::map<int, std::size_t> cornerBefore; // per neighbour: v's corner in the face v, neighbour
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		if (mesh.triangles[i] == v) cornerBefore[mesh.triangles[i % 3 == 2 ? i - 2 : i + 1]] = i;
	}
	TriangleMesh slit = mesh;
	const int    w    = int(slit.positions.size());
	slit.positions.push_back(slit.positions[std::size_t(v)]);
	int neighbour = cornerBefore.begin()->first;
	for (std::size_t turned = 0; turned < cornerBefore.size() / 2; ++turned) {
		const std::size_t i = cornerBefore.at(neighbour);
		slit.triangles[i]   = w;
		neighbour           = mesh.triangles[i % 3 == 0 ? i + 2 : i - 1];
	}
	slit.triangles.insert(slit.triangles.end(), {w, neighbour, v});
	return slit;
}

TriangleMesh withFlatFace(const TriangleMesh& mesh, std::size_t at)
{
	const std::size_t first = at - at % 3;
	const int         a = mesh.triangles[at], b = mesh.triangles[first + (at + 1) % 3];
	const int         c      = mesh.triangles[first + (at + 2) % 3];
	TriangleMesh      result = mesh;
	const int         middle = int(result.positions.size());
	result.positions.push_back(
		(result.positions[std::size_t(a)] + result.positions[std::size_t(b)]) * 0.5);
	const int made[] = {a, middle, c, middle, b, c, a, b, middle};
	std::copy_n(made, 3, result.triangles.begin() + std::ptrdiff_t(first));
	result.triangles.insert(result.triangles.end(), made + 3, made + 9);
	return result;
}

TriangleMesh withoutUnused(const TriangleMesh& mesh)
{
	TriangleMesh     result;
	std::vector<int> newVertex(mesh.vertexNum(), -1);
	for (std::int32_t v : mesh.triangles) {
		if (newVertex[v] < 0) {
			newVertex[v] = int(result.positions.size());
			result.positions.push_back(mesh.positions[v]);
		}
		result.triangles.push_back(newVertex[v]);
	}
	return result;
}

FloatMesh::FloatMesh(const TriangleMesh& mesh) : triangles(mesh.triangles)
{
	for (const Vec3d& p : mesh.positions)
		positions.push_back(Vec3f(p));
}

} // namespace gpr::test
