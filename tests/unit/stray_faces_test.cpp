// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/input/stray_faces.h>
#include <vcg_extras/core/remesh.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// One triangle of this size, a corner at the origin.
TriangleMesh triangle(double size)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
	mesh.triangles = {0, 1, 2};
	return mesh;
}

StrayFaces strayOf(const TriangleMesh& shape)
{
	Workers           workers(2, nullptr);
	const IndexedMesh mesh = loaded(shape, workers);
	return findStrayFaces(mesh, findLongFaces(mesh, measureFaces(mesh, workers), 0.05f, workers),
						  workers);
}

TEST(StrayFaces, AFaceThatReachesFarBeyondTheOthersIsFound)
{
	const StrayFaces stray = strayOf(joined(icosphere(3), triangle(100)));
	EXPECT_EQ(stray.num, 1);
	EXPECT_GT(stray.sizeRatio, 30);
	EXPECT_LT(stray.sizeRatio, 60);
	EXPECT_GT(stray.areaShare, 0.99);
}

TEST(StrayFaces, AreThoseThatMakeTheMeshTwiceAsLarge)
{
	const StrayFaces stray = strayOf(joined(icosphere(3), triangle(5)));
	EXPECT_EQ(stray.num, 1);
	EXPECT_NEAR(stray.sizeRatio, 2.5, 0.1);
	EXPECT_EQ(strayOf(joined(icosphere(3), triangle(2.5))).num, 0) << "1.5 times";
}

TEST(StrayFaces, LargeFacesBesideSmallOnesAreNone)
{
	// A plate of one square of which one rim is cut into small triangles.
	TriangleMesh plate = joined(grid(100, 1, 1, 0.01), triangle(1));
	EXPECT_EQ(strayOf(plate).num, 0);
	EXPECT_EQ(strayOf(icosphere(1)).num, 0) << "all faces are long";
	EXPECT_EQ(strayOf(icosphere(4)).num, 0) << "none is";
}

TEST(StrayFaces, ANoteTellsOfThem)
{
	RemeshOptions options;
	const auto    notesOf = [&](const TriangleMesh& mesh) {
        const RemeshResult r = remesh(mesh.view(), options);
        EXPECT_EQ(r.status, Status::Ok) << r.message;
        std::string all;
        for (const std::string& note : r.notes)
            all += note + '\n';
        return all;
	};
	options.targetPercent   = 50;
	const std::string notes = notesOf(joined(icosphere(3), triangle(100)));
	EXPECT_NE(notes.find("1 of the faces reach"), std::string::npos) << notes;
	EXPECT_EQ(notesOf(icosphere(3)).find("stray"), std::string::npos);
}

} // namespace

} // namespace gpr::test
