// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The count that is aimed at.

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/run/target.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

RemeshOptions keepingBorder(TargetMode mode)
{
	RemeshOptions options;
	options.targetMode = mode;
	options.boundary   = BoundaryMode::Keep;
	return options;
}

/// The status of the failure that body throws; Ok where it throws none.
template <class Body>
Status statusOf(const Body& body)
{
	try {
		body();
	}
	catch (const Failure& failure) {
		EXPECT_FALSE(failure.message.empty());
		return failure.status;
	}
	return Status::Ok;
}

TEST(Target, StaysWhereTheKeptVerticesFit)
{
	for (TargetMode mode : {TargetMode::VertexNum, TargetMode::Percent}) {
		const Target target = targetWithRoom(keepingBorder(mode), 100, 100);
		EXPECT_EQ(target.vertexNum, 100);
		EXPECT_EQ(target.note, "");
	}
}

TEST(Target, IsRaisedForABorderThatIsKeptWhereItIsAWish)
{
	const Target target = targetWithRoom(keepingBorder(TargetMode::Percent), 30, 100);
	EXPECT_EQ(target.vertexNum, 180) << "the border, half as many, and those asked for";
	EXPECT_NE(target.note.find("180"), std::string::npos) << target.note;
	EXPECT_NE(target.note.find("instead of 30"), std::string::npos) << target.note;

	RemeshOptions nearest = keepingBorder(TargetMode::VertexNum);
	nearest.allowNearest  = true;
	EXPECT_EQ(targetWithRoom(nearest, 30, 100).vertexNum, 180);
}

TEST(Target, IsRefusedWhereItIsNoWish)
{
	const RemeshOptions options = keepingBorder(TargetMode::VertexNum);
	EXPECT_EQ(statusOf([&] { targetWithRoom(options, 99, 100); }), Status::BadOptions);
	EXPECT_EQ(statusOf([&] { requireRoomForKept(options, 99, 100); }), Status::BadOptions);
	EXPECT_EQ(statusOf([&] { requireRoomForKept(options, 100, 100); }), Status::Ok);
}

TEST(Target, IsRefusedForARegionThatDoesNotFit)
{
	RemeshOptions options; // of a percentage: a wish
	options.preset = Preset::Paper;
	EXPECT_EQ(statusOf([&] { targetWithRoom(options, 99, 100); }), Status::BadOptions);
}

TEST(Target, OfTooManyVerticesIsRefused)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 200000001;
	const MeshView input;
	EXPECT_EQ(statusOf([&] { resolveTarget(input, options, 1, 1); }), Status::OutOfMemory);
	options.targetVertexNum = 200000000;
	EXPECT_EQ(resolveTarget(input, options, 1, 1), 200000000);
}

} // namespace

} // namespace gpr::test
