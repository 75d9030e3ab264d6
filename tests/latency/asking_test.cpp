// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The engine asks often enough whether to go on, counted by work: the engine of this test calls a
// function in each basic block, about once for five instructions, and each question reaches the
// callback. The count is the same on busy and on slow machines.

#include <tests/support/mesh_builders.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <string>

namespace {

std::uint64_t blockNum = 0;

} // namespace

/// Called by the engine in each basic block.
// NOLINTBEGIN(bugprone-reserved-identifier): the name is a convention of compilers
extern "C" void __sanitizer_cov_trace_pc();
extern "C" void __sanitizer_cov_trace_pc()
{
	++blockNum;
}
// NOLINTEND(bugprone-reserved-identifier)

namespace gpr::test {

namespace {

/// Blocks between two questions. A look at a face takes some 50 blocks, and a processor passes some
/// thousand million blocks in a second. Some steps of searches at faults are long, but no longer on
/// larger meshes.
constexpr std::uint64_t mostOnCleanMeshes = 100'000 * 50, mostAtFaults = 40'000'000;

struct AskingCase {
	const char*                         name;
	std::function<TriangleMesh()>       mesh;
	std::function<void(RemeshOptions&)> change;
	std::uint64_t                       most;
};

void keep(RemeshOptions&) {}

TriangleMesh tenThousandHoles()
{
	return gridWhere(300, 1, [](int i, int j) { return i % 3 != 1 || j % 3 != 1; });
}

TriangleMesh wallsInContact()
{
	Random random(1);
	return noisySphere(6, 0.03, random);
}

TriangleMesh damagedTorus()
{
	Random random(1);
	return damaged(torus(400, 200), 200, random);
}

TriangleMesh looseTriangles()
{
	Random random(1);
	return soupOf(icosphere(5), 1e-4, random);
}

void searchError(RemeshOptions& options)
{
	options.targetMode     = TargetMode::MaxError;
	options.targetMaxError = 2e-3;
}

const AskingCase cases[] = {
	{"Default", [] { return torus(400, 200); }, keep, mostOnCleanMeshes},
	{"Fast", [] { return torus(400, 200); }, [](RemeshOptions& o) { o.preset = Preset::Fast; },
	 mostOnCleanMeshes},
	{"LocalSizes", [] { return torus(400, 200); }, [](RemeshOptions& o) { o.adapt = 1; },
	 mostOnCleanMeshes},
	{"Paper", [] { return torus(400, 200); }, [](RemeshOptions& o) { o.preset = Preset::Paper; },
	 2 * mostOnCleanMeshes},
	{"FewVertices", [] { return torus(400, 200); }, [](RemeshOptions& o) { o.targetPercent = 1; },
	 mostOnCleanMeshes},
	{"DisksAsLargeAsTheSurface", [] { return icosphere(7); },
	 [](RemeshOptions& o) {
		 o.targetMode      = TargetMode::VertexNum;
		 o.targetVertexNum = 6;
	 },
	 2 * mostOnCleanMeshes},
	{"LargestError", [] { return icosphere(6); }, searchError, 2 * mostOnCleanMeshes},
	{"TenThousandHoles", tenThousandHoles, keep, mostAtFaults},
	{"WallsInContact", wallsInContact, keep, mostAtFaults},
	{"ThinPlate", [] { return thinPlate(200, 1e-3); }, keep, mostAtFaults},
	{"ThinPlateToFewVertices", [] { return thinPlate(250, 1e-3); },
	 [](RemeshOptions& o) { o.targetPercent = 0.5; }, mostAtFaults},
	{"DamagedMesh", damagedTorus, keep, mostAtFaults},
	{"LooseTriangles", looseTriangles, keep, mostAtFaults},
};

class Asking : public ::testing::TestWithParam<AskingCase> {};

TEST_P(Asking, IsNeverFarApartByWork)
{
	const AskingCase&  tested = GetParam();
	const TriangleMesh mesh   = tested.mesh();
	RemeshOptions      options;
	options.targetPercent = 10;
	options.threads       = 1; // all blocks are of the thread that asks
	tested.change(options);

	std::uint64_t last = blockNum, longest = 0, askNum = 0;
	std::string   where;
	const auto    note = [&](const char* phrase) {
        const std::uint64_t gap = blockNum - last;
        if (gap > longest) where = phrase;
        longest = std::max(longest, gap);
        last    = blockNum;
        ++askNum;
	};
	const RemeshResult r = remesh(mesh.view(), options, [&](double, const char* phrase) {
		note(phrase);
		return true;
	});
	note("the end");
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(last, askNum) << "blocks are counted";
	EXPECT_LE(longest, tested.most) << "before: " << where;
	RecordProperty("longest", std::to_string(longest));
}

INSTANTIATE_TEST_SUITE_P(, Asking, ::testing::ValuesIn(cases),
						 [](const auto& tested) { return std::string(tested.param.name); });

} // namespace

} // namespace gpr::test
