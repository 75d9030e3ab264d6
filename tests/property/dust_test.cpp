// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Components of a scan's dust that become tetrahedra do not turn inside out.

#include <tests/support/mesh_builders.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr int blobNum = 100;

/// Thin discs far from each other, each turned another way.
TriangleMesh flatBlobs()
{
	TriangleMesh all;
	for (int i = 0; i < blobNum; ++i) {
		TriangleMesh blob = icosphere(1);
		const double turn = 0.7 * i, tilt = 0.37 * i;
		for (Vec3d& p : blob.positions) {
			const Vec3d flat(p.x, p.y, 0.03 * p.z);
			const Vec3d q(flat.x * std::cos(turn) - flat.y * std::sin(turn),
						  flat.x * std::sin(turn) + flat.y * std::cos(turn), flat.z);
			p = {q.x + 4.0 * (i % 10), q.y * std::cos(tilt) - q.z * std::sin(tilt) + 4.0 * (i / 10),
				 q.y * std::sin(tilt) + q.z * std::cos(tilt)};
		}
		all = i == 0 ? blob : joined(all, blob);
	}
	return all;
}

/// The number of tetrahedra with a negative volume; the place of a vertex tells its blob.
int insideOutNum(const TriangleMesh& mesh)
{
	double volume[blobNum] = {};
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const auto at = [&](std::size_t k) {
			return mesh.positions[std::size_t(mesh.triangles[3 * f + k])];
		};
		const int   column = int(std::lround(at(0).x / 4)), row = int(std::lround(at(0).y / 4));
		const Vec3d centre(4.0 * column, 4.0 * row, 0);
		volume[10 * row + column] += dot(at(0) - centre, cross(at(1) - centre, at(2) - centre));
	}
	int num = 0;
	for (const double v : volume)
		num += v < 0;
	return num;
}

} // namespace

TEST(Dust, NoTetrahedronIsInsideOut)
{
	const TriangleMesh mesh = flatBlobs();
	ASSERT_EQ(insideOutNum(mesh), 0);
	for (const Preset preset : {Preset::Default, Preset::Fast}) {
		RemeshOptions options;
		options.preset          = preset;
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = 4 * blobNum;
		const RemeshResult r    = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(int(r.mesh.vertexNum()), 4 * blobNum);
		EXPECT_EQ(insideOutNum(r.mesh), 0);
	}
}

} // namespace gpr::test
