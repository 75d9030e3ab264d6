// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "baseline_meshoptimizer.h"

#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/base/stopwatch.h>

#include <limits>
#include <meshoptimizer.h>

namespace gpr::bench {

namespace {

using Indices = std::vector<unsigned int>;

std::vector<float> floatPositions(const MeshView& mesh)
{
	std::vector<float> positions(3 * mesh.vertexNum);
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		const Vec3d p        = mesh.position(v);
		positions[3 * v]     = float(p.x);
		positions[3 * v + 1] = float(p.y);
		positions[3 * v + 2] = float(p.z);
	}
	return positions;
}

/// The triangles with their vertices only.
TriangleMesh compacted(const Indices& triangles, const std::vector<float>& positions)
{
	TriangleMesh              mesh;
	std::vector<std::int32_t> number(positions.size() / 3, -1);
	for (const unsigned int v : triangles) {
		if (number[v] < 0) {
			number[v] = std::int32_t(mesh.positions.size());
			mesh.positions.emplace_back(positions[3 * v], positions[3 * v + 1],
										positions[3 * v + 2]);
		}
		mesh.triangles.push_back(number[v]);
	}
	return mesh;
}

} // namespace

app::BaselineResult simplifyByMeshoptimizer(const app::InputMesh& mesh, std::int64_t faceNum)
{
	const std::vector<float> positions = floatPositions(mesh.view());
	const Indices            triangles(mesh.triangles.begin(), mesh.triangles.end());
	Indices                  simplified(triangles.size());

	app::BaselineResult  result;
	const double         processorBefore = app::processorSeconds();
	const app::Stopwatch clock;
	simplified.resize(meshopt_simplify(simplified.data(), triangles.data(), triangles.size(),
									   positions.data(), mesh.vertexNum(), 3 * sizeof(float),
									   3 * std::size_t(faceNum), std::numeric_limits<float>::max(),
									   0, nullptr));
	result.seconds          = clock.seconds();
	result.processorSeconds = app::processorSeconds() - processorBefore;
	result.mesh             = compacted(simplified, positions);
	if (simplified.empty()) result.failure = "meshoptimizer left no face.";
	return result;
}

} // namespace gpr::bench
