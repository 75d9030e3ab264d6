// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "built_in_meshes.h"

#include "mesh_growth.h"

namespace gpr::bench {

namespace {

TriangleMesh octahedron()
{
	TriangleMesh mesh;
	mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
	mesh.triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
	return mesh;
}

TriangleMesh square()
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
	mesh.triangles = {0, 1, 2, 0, 2, 3};
	return mesh;
}

TriangleMesh block()
{
	TriangleMesh mesh;
	for (int v = 0; v < 8; ++v)
		mesh.positions.emplace_back(v & 1, 0.7 * (v >> 1 & 1), 0.4 * (v >> 2 & 1));
	mesh.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
					  2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
	return mesh;
}

} // namespace

TriangleMesh roughStone(std::int64_t faceNum)
{
	return growMesh(octahedron(), faceNum, MeshGrowth());
}

TriangleMesh roughLand(std::int64_t faceNum)
{
	return growMesh(square(), faceNum, MeshGrowth());
}

TriangleMesh sharpBox(std::int64_t faceNum)
{
	MeshGrowth flat;
	flat.roundness = 0;
	flat.roughness = 0;
	return growMesh(block(), faceNum, flat);
}

bool makeBuiltIn(const std::string& name, std::int64_t faceNum, TriangleMesh& mesh)
{
	if (name == "stone") {
		mesh = roughStone(faceNum);
	}
	else if (name == "land") {
		mesh = roughLand(faceNum);
	}
	else if (name == "box") {
		mesh = sharpBox(faceNum);
	}
	else {
		return false;
	}
	return true;
}

} // namespace gpr::bench
