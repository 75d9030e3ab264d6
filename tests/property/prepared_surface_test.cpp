// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs on a prepared surface have the bytes of runs without preparation, and end soon after a stop
// request.

#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <vcg_extras/core/prepared_surface.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <gtest/gtest.h>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gpr::test {

namespace {

struct Shape {
	std::string               name;
	TriangleMesh              mesh;
	std::vector<std::uint8_t> selectedFace; ///< about half of the faces

	MeshView view() const
	{
		MeshView v     = mesh.view();
		v.selectedFace = selectedFace.data();
		return v;
	}
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

/// Small icospheres in a row.
TriangleMesh spheres(int num)
{
	const TriangleMesh one = icosphere(3);
	TriangleMesh       all;
	for (int i = 0; i < num; ++i) {
		const auto first = std::int32_t(all.positions.size());
		for (const Vec3d& p : one.positions)
			all.positions.push_back(p + Vec3d(2.5 * i, 0, 0));
		for (std::int32_t v : one.triangles)
			all.triangles.push_back(v + first);
	}
	return all;
}

Shape shape(std::string name, TriangleMesh mesh)
{
	Shape made{std::move(name), std::move(mesh), {}};
	for (std::size_t f = 0; f < made.mesh.faceNum(); ++f) {
		const Vec3d& corner = made.mesh.positions[std::size_t(made.mesh.triangles[3 * f])];
		made.selectedFace.push_back(corner.x > 0.05);
	}
	return made;
}

std::vector<Shape> shapes()
{
	Random random(5);
	return {shape("sphere", icosphere(4)),
			shape("noisySphere", noisySphere(4, 0.02, random)),
			shape("cubeWithSharpEdges", cube(20)),
			shape("borders", withHoles(jitteredGrid(50, 0.3, random), 4, random)),
			shape("spheres32", spheres(32)),
			shape("openCylinder", openCylinder(60, 40, 0.5, 1.5)),
			shape("soup", soupOf(icosphere(3), 0, random)),
			shape("damaged", damaged(icosphere(4), 40, random)),
			shape("coarseNeedles", uvSphere(12, 90))};
}

struct NamedRun {
	std::string   name;
	RemeshOptions options;
};

std::vector<NamedRun> runs()
{
	std::vector<NamedRun> all;
	const auto            add = [&](const std::string& name) -> RemeshOptions& {
        all.push_back({name, RemeshOptions()});
        all.back().options.targetPercent = 20;
        return all.back().options;
	};
	add("default");
	add("fast").preset                    = Preset::Fast;
	add("paper").preset                   = Preset::Paper;
	add("fewer").targetPercent            = 8;
	add("finerThanInput").targetPercent   = 150; // edges are split before the mesh is connected
	add("seed").seed                      = 7;
	add("adapt").adapt                    = 1;
	add("lambda").lambda                  = 2;
	add("border").boundary                = BoundaryMode::Smooth;
	add("unsewn").sew                     = false;
	add("largeParts").dropComponentsBelow = 30;
	add("part").selectedOnly              = true;
	RemeshOptions& region                 = add("region");
	region.featureRegion                  = FeatureRegion::Detected;
	region.featureDiskScale               = 0.6;
	add("regionAgain")                    = region;
	RemeshOptions& goal                   = add("maxError");
	goal.preset                           = Preset::Fast;
	goal.targetMode                       = TargetMode::MaxError;
	goal.targetMaxError                   = 2;
	goal.maxErrorIsPercent                = true;
	goal.allowNearest                     = true;
	add("defaultAgain");
	return all;
}

template <class T>
bool haveSameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
	return a.size() == b.size() &&
		   (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expectSame(const RemeshResult& a, const RemeshResult& b)
{
	EXPECT_EQ(a.status, b.status) << a.message << "; " << b.message;
	EXPECT_EQ(a.message, b.message);
	EXPECT_EQ(a.notes, b.notes);
	EXPECT_TRUE(haveSameBytes(a.mesh.positions, b.mesh.positions));
	EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
	EXPECT_TRUE(haveSameBytes(a.surfacePoints, b.surfacePoints));
	EXPECT_EQ(a.callersVertex, b.callersVertex);
	EXPECT_EQ(a.callersFace, b.callersFace);
	EXPECT_EQ(a.report.cleaned.sewnEdges, b.report.cleaned.sewnEdges);
	EXPECT_EQ(a.report.cleaned.longEdgesSplit, b.report.cleaned.longEdgesSplit);
	EXPECT_EQ(a.report.cleaned.droppedComponents, b.report.cleaned.droppedComponents);
	EXPECT_EQ(a.report.cleaned.weldedVertices, b.report.cleaned.weldedVertices);
	EXPECT_EQ(a.report.cleanedInput.faces, b.report.cleanedInput.faces);
	EXPECT_EQ(a.report.regionVertexNum, b.report.regionVertexNum);
	EXPECT_EQ(a.report.capsReached, b.report.capsReached);
}

class Prepared : public ::testing::TestWithParam<Shape> {};

/// One surface for all runs, in this order, each with another number of threads.
TEST_P(Prepared, RunsHaveTheBytesOfRunsFromNothing)
{
	const MeshView  view = GetParam().view();
	PreparedSurface surface(view);
	int             done = 0, threads = 1;
	for (NamedRun& run : runs()) {
		SCOPED_TRACE(run.name);
		run.options.threads      = 2;
		const RemeshResult fresh = remesh(view, run.options);
		run.options.threads      = threads;
		threads                  = threads % 4 + 1;
		expectSame(surface.remesh(run.options), fresh);
		done += fresh.status == Status::Ok;
	}
	EXPECT_GE(done, 8) << "most runs make a mesh";
}

INSTANTIATE_TEST_SUITE_P(, Prepared, ::testing::ValuesIn(shapes()),
						 [](const auto& made) { return made.param.name; });

TEST(PreparedSurface, WhatIsPreparedBeforehandIsNotMadeAgain)
{
	const TriangleMesh mesh = icosphere(6);
	PreparedSurface    surface(mesh.view());
	RemeshOptions      options;
	options.targetPercent       = 5;
	options.threads             = 2;
	const RemeshResult prepared = surface.prepare(options);
	ASSERT_EQ(prepared.status, Status::Ok) << prepared.message;
	EXPECT_EQ(prepared.mesh.vertexNum(), 0u);
	// The stages of a preparation are not among the stages of a later run.
	const auto secondsOf = [](const RemeshResult& r, const std::string& stage) {
		double seconds = -1;
		for (const StageTime& s : r.report.stages)
			if (s.stage == stage) seconds = s.seconds;
		return seconds;
	};
	const RemeshResult run = surface.remesh(options);
	ASSERT_EQ(run.status, Status::Ok);
	EXPECT_GE(secondsOf(prepared, "connect"), 0);
	EXPECT_EQ(secondsOf(run, "load"), -1) << "no mesh is taken over";
	EXPECT_EQ(secondsOf(run, "order"), -1);
	EXPECT_EQ(secondsOf(run, "connect"), -1);
}

TEST(PreparedSurface, TellsWhyThereIsNoSurface)
{
	const TriangleMesh nothing;
	PreparedSurface    surface(nothing.view());
	for (int i = 0; i < 2; ++i) {
		EXPECT_EQ(surface.prepare(RemeshOptions()).status, Status::UnusableInput);
		EXPECT_EQ(surface.remesh(RemeshOptions()).status, Status::UnusableInput);
	}
	RemeshOptions wrong;
	wrong.targetPercent = -1;
	EXPECT_EQ(surface.remesh(wrong).status, Status::BadOptions);
	const TriangleMesh mesh = icosphere(2);
	PreparedSurface    unselected(mesh.view());
	RemeshOptions      part;
	part.selectedOnly = true;
	EXPECT_EQ(unselected.remesh(part).status, Status::BadOptions);
	EXPECT_EQ(unselected.remesh(RemeshOptions()).status, Status::Ok);
}

TEST(PreparedSurface, TakesOtherMarksOfTheSameMesh)
{
	const TriangleMesh        mesh      = icosphere(4);
	const TriangleMesh        elsewhere = mesh;
	std::vector<std::uint8_t> vertices(mesh.vertexNum(), 0), faces(mesh.faceNum(), 0);
	std::fill(vertices.begin(), vertices.begin() + 200, std::uint8_t(1));
	std::fill(faces.begin(), faces.begin() + 500, std::uint8_t(1));
	MeshView marked     = elsewhere.view();
	marked.selected     = vertices.data();
	marked.selectedFace = faces.data();
	PreparedSurface surface(mesh.view());
	ASSERT_EQ(surface.remesh(countOptions(300)).status, Status::Ok);
	surface.setInput(marked);
	RemeshOptions region = countOptions(300);
	region.featureRegion = FeatureRegion::Selection;
	expectSame(surface.remesh(region), remesh(marked, region));
	RemeshOptions part = countOptions(100);
	part.selectedOnly  = true;
	expectSame(surface.remesh(part), remesh(marked, part));
	std::fill(faces.begin() + 500, faces.begin() + 900, std::uint8_t(1));
	surface.setInput(marked);
	expectSame(surface.remesh(part), remesh(marked, part));
}

TEST(PreparedSurface, CallsOfSeveralThreadsWaitForEachOther)
{
	const TriangleMesh        mesh = torus(90, 46);
	PreparedSurface           surface(mesh.view());
	const RemeshResult        alone = remesh(mesh.view(), countOptions(500));
	std::vector<RemeshResult> made(4);
	std::vector<std::thread>  threads;
	for (RemeshResult& result : made)
		threads.emplace_back([&] { result = surface.remesh(countOptions(500)); });
	for (std::thread& t : threads)
		t.join();
	for (const RemeshResult& result : made)
		expectSame(result, alone);
}

using Clock = std::chrono::steady_clock;

/// Seconds from the request to the return; below 0 after the end of the run.
double secondsToStop(PreparedSurface& surface, const RemeshOptions& options, double delay)
{
	StopRequest             stop{false};
	Clock::time_point       asked;
	std::thread             asking([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(delay));
        asked = Clock::now();
        stop  = true;
    });
	const RemeshResult      r        = surface.remesh(options, nullptr, &stop);
	const Clock::time_point returned = Clock::now();
	asking.join();
	if (r.status == Status::Ok) return -1;
	EXPECT_EQ(r.status, Status::Cancelled) << r.message;
	EXPECT_EQ(r.mesh.vertexNum(), 0u);
	return std::chrono::duration<double>(returned - asked).count();
}

/// The limit is generous, for loaded machines; the test prints the measured times.
TEST(PreparedSurface, ARunStopsSoonAndLeavesTheSurfaceAsItWas)
{
	constexpr double   maxSeconds = 1;
	const TriangleMesh mesh       = torus(400, 200); // 160,000 faces
	PreparedSurface    surface(mesh.view());
	RemeshOptions      options;
	options.targetPercent    = 20;
	options.threads          = 2;
	const RemeshResult whole = surface.remesh(options);
	ASSERT_EQ(whole.status, Status::Ok);
	std::vector<double> seconds;
	for (int i = 0; i < 24; ++i) {
		// At moments spread over the whole run; every fourth time with a fresh surface.
		PreparedSurface  fresh(mesh.view());
		PreparedSurface& of      = i % 4 == 0 ? fresh : surface;
		const double     delay   = whole.report.remeshSeconds * (i + 0.5) / 24;
		const double     stopped = secondsToStop(of, options, delay);
		if (stopped >= 0) seconds.push_back(stopped);
	}
	ASSERT_GE(seconds.size(), 12u) << "most runs were stopped";
	std::sort(seconds.begin(), seconds.end());
	std::cout << "From the request to the return: median " << 1e3 * seconds[seconds.size() / 2]
			  << " ms, longest " << 1e3 * seconds.back() << " ms\n";
	EXPECT_LT(seconds.back(), maxSeconds);
	expectSame(surface.remesh(options), whole);
}

} // namespace

} // namespace gpr::test
