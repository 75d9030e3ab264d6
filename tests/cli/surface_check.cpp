// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_check.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>

namespace gpr_test {

namespace {

/// How often each directed edge occurs.
std::map<std::pair<int, int>, int> directedEdges(const TestMesh& mesh)
{
	std::map<std::pair<int, int>, int> edges;
	for (const auto& f : mesh.faces) {
		for (int k = 0; k < 3; ++k)
			++edges[{f[k], f[(k + 1) % 3]}];
	}
	return edges;
}

} // namespace

void expectManifold(const TestMesh& mesh)
{
	long          badIndices = 0, repeated = 0, nonFinite = 0, crowdedEdges = 0;
	std::set<int> used;
	for (const auto& f : mesh.faces) {
		for (const int i : f)
			badIndices += i < 0 || i >= int(mesh.points.size()) ? 1 : 0;
		repeated += f[0] == f[1] || f[1] == f[2] || f[2] == f[0] ? 1 : 0;
		used.insert(f.begin(), f.end());
	}
	for (const auto& p : mesh.points) {
		for (const double c : p)
			nonFinite += std::isfinite(c) ? 0 : 1;
	}
	for (const auto& [edge, num] : directedEdges(mesh))
		crowdedEdges += num > 1 ? 1 : 0;
	EXPECT_GT(mesh.faces.size(), 0u);
	EXPECT_EQ(badIndices, 0);
	EXPECT_EQ(repeated, 0);
	EXPECT_EQ(nonFinite, 0);
	EXPECT_EQ(crowdedEdges, 0);
	EXPECT_EQ(used.size(), mesh.points.size());
}

long boundaryEdgeNum(const TestMesh& mesh)
{
	const auto edges = directedEdges(mesh);
	long       num   = 0;
	for (const auto& [edge, count] : edges)
		num += edges.count({edge.second, edge.first}) ? 0 : 1;
	return num;
}

long eulerCharacteristic(const TestMesh& mesh)
{
	// Every face has three directed edges; a border edge has no opposite directed edge.
	const long edgeNum = (long(directedEdges(mesh).size()) + boundaryEdgeNum(mesh)) / 2;
	return long(mesh.points.size()) - edgeNum + long(mesh.faces.size());
}

} // namespace gpr_test
