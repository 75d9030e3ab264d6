// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Progress is reported as the work proceeds, and a callback with the answer false ends the run
// soon.

#include <tests/support/mesh_builders.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

namespace gpr::test {

namespace {

using Clock = std::chrono::steady_clock;

/// From the refusal to the end of the call; generous, for loaded machines.
constexpr double maxSecondsToCancel = 1.0;

RemeshOptions someOptions()
{
	RemeshOptions options;
	options.targetPercent = 60;
	options.threads       = 2;
	return options;
}

double secondsSince(Clock::time_point start)
{
	return std::chrono::duration<double>(Clock::now() - start).count();
}

/// With a pipeline of its own for the detection, and without.
class ProgressOf : public ::testing::TestWithParam<FeatureRegion> {};

TEST_P(ProgressOf, ARunRisesFromNothingToOneWithAPhrase)
{
	const TriangleMesh mesh    = torus(400, 200);
	RemeshOptions      options = someOptions();
	options.featureRegion      = GetParam();
	std::vector<double>      shares;
	std::vector<std::string> phrases;
	const auto               caller = std::this_thread::get_id();
	const RemeshResult r = remesh(mesh.view(), options, [&](double share, const char* phrase) {
		EXPECT_EQ(std::this_thread::get_id(), caller) << "from the thread that called";
		shares.push_back(share);
		phrases.push_back(phrase);
		return true;
	});
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	ASSERT_GE(shares.size(), 3u);
	for (std::size_t i = 0; i < shares.size(); ++i) {
		EXPECT_GE(shares[i], i > 0 ? shares[i - 1] : 0.0);
		EXPECT_LE(shares[i], 1.0);
		EXPECT_FALSE(phrases[i].empty());
	}
}

INSTANTIATE_TEST_SUITE_P(, ProgressOf,
						 ::testing::Values(FeatureRegion::None, FeatureRegion::Detected));

TEST(Progress, TheCallbackDoesNotChangeTheResult)
{
	const TriangleMesh mesh = torus(90, 46);
	const RemeshResult a    = remesh(mesh.view(), someOptions());
	const RemeshResult b =
		remesh(mesh.view(), someOptions(), [](double, const char*) { return true; });
	EXPECT_TRUE(a.mesh.positions == b.mesh.positions);
	EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

class CancelAfter : public ::testing::TestWithParam<std::uint32_t> {};

/// At a random moment of the run, on a clean mesh and on a mesh that needs a repair.
TEST_P(CancelAfter, ARandomTimeEndsSoonWithNothingHandedOut)
{
	Random random(GetParam());
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	const TriangleMesh clean = torus(400, 200);
	for (const TriangleMesh& mesh : {clean, damaged(clean, 20, random)}) {
		const double       moment  = random.between(0, 0.5);
		const auto         start   = Clock::now();
		bool               refused = false;
		Clock::time_point  refusedAt;
		const RemeshResult r = remesh(mesh.view(), someOptions(), [&](double, const char*) {
			EXPECT_FALSE(refused) << "not asked again";
			if (secondsSince(start) < moment) return true;
			refused   = true;
			refusedAt = Clock::now();
			return false;
		});
		if (!refused) continue; // done before the moment came
		EXPECT_LT(secondsSince(refusedAt), maxSecondsToCancel);
		EXPECT_EQ(r.status, Status::Cancelled);
		EXPECT_FALSE(r.message.empty());
		EXPECT_EQ(r.mesh.vertexNum(), 0u);
		EXPECT_TRUE(r.surfacePoints.empty());
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, CancelAfter, ::testing::ValuesIn(testSeeds(8)));

/// Processor time of a run, in seconds; other programs do not lengthen it.
struct ProcessorTime {
	double      whole   = 0;
	double      unasked = 0; ///< the longest time between two questions whether to go on
	std::string where;       ///< the phrase after this time
};

ProcessorTime processorTimeOf(const TriangleMesh& mesh, RemeshOptions options)
{
	options.threads = 1; // the clock counts all threads
	ProcessorTime      time;
	const std::clock_t start = std::clock();
	std::clock_t       last  = start;
	const auto         note  = [&](const char* phrase) {
        const std::clock_t now = std::clock();
        const double       own = double(now - last) / CLOCKS_PER_SEC;
        if (own > time.unasked) {
            time.unasked = own;
            time.where   = phrase;
        }
        last = now;
	};
	const RemeshResult r = remesh(mesh.view(), options, [&](double, const char* phrase) {
		note(phrase);
		return true;
	});
	note("the end");
	EXPECT_EQ(r.status, Status::Ok) << r.message;
	time.whole = double(last - start) / CLOCKS_PER_SEC;
	return time;
}

/// No stage works long without a question whether to go on. The share of the run is for builds
/// without optimization.
TEST(Cancel, IsAskedForInAllStages)
{
	constexpr double longest = 0.2, share = 0.02;
	Random           random(1);
	RemeshOptions    closer = someOptions();
	closer.targetMode       = TargetMode::MaxError;
	closer.targetMaxError   = 2e-3;
	RemeshOptions fewer     = someOptions();
	fewer.targetPercent     = 10;
	const auto isNoHole     = [](int i, int j) { return i % 3 != 1 || j % 3 != 1; };
	const struct {
		const char*          name;
		TriangleMesh         mesh;
		const RemeshOptions& options;
	} runs[] = {{"10,000 holes", gridWhere(300, 1, isNoHole), fewer},
				{"walls in contact", noisySphere(6, 0.03, random), fewer},
				{"a largest distance", icosphere(6), closer}};
	for (const auto& run : runs) {
		const ProcessorTime time = processorTimeOf(run.mesh, run.options);
		EXPECT_LE(time.unasked, std::max(longest, share * time.whole))
			<< run.name << ", before " << time.where << ", of " << time.whole;
	}
}

TEST(Cancel, StopsTheSamplingAndTheRetriangulationToo)
{
	const auto         never = [](double, const char*) { return false; };
	const TriangleMesh mesh  = torus(90, 46);
	EXPECT_EQ(samplePoissonDisks(mesh.view(), someOptions(), never).status, Status::Cancelled);
	EXPECT_EQ(retriangulate(mesh.view(), mesh.positions, someOptions(), never).status,
			  Status::Cancelled);
}

TEST(TimeLimit, EndsEveryToolWithoutAResult)
{
	const TriangleMesh mesh    = torus(400, 200);
	RemeshOptions      options = someOptions();
	options.timeLimitSeconds   = 1e-3;
	const auto         start   = Clock::now();
	const RemeshResult r       = remesh(mesh.view(), options);
	EXPECT_EQ(r.status, Status::OutOfTime);
	EXPECT_FALSE(r.message.empty());
	EXPECT_EQ(r.mesh.vertexNum(), 0u);
	EXPECT_EQ(samplePoissonDisks(mesh.view(), options).status, Status::OutOfTime);
	EXPECT_EQ(retriangulate(mesh.view(), mesh.positions, options).status, Status::OutOfTime);
	EXPECT_EQ(detectFeatures(mesh.view(), options).status, Status::OutOfTime);
	EXPECT_LT(secondsSince(start), 4 * maxSecondsToCancel);
}

TEST(TimeLimit, ThatIsLongEnoughChangesNothing)
{
	const TriangleMesh mesh    = torus(60, 30);
	const RemeshResult plain   = remesh(mesh.view(), someOptions());
	RemeshOptions      limited = someOptions();
	limited.timeLimitSeconds   = 1000;
	const RemeshResult r       = remesh(mesh.view(), limited);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(r.mesh.positions == plain.mesh.positions);
}

TEST(Cancel, AThrowingCallbackIsReported)
{
	const RemeshResult r =
		remesh(torus(90, 46).view(), someOptions(),
			   [](double, const char*) -> bool { throw std::runtime_error("host failed"); });
	EXPECT_EQ(r.status, Status::InternalError);
	EXPECT_NE(r.message.find("host failed"), std::string::npos);
}

} // namespace

} // namespace gpr::test
