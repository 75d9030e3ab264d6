// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The wanted count.

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/sampling/target.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// The status of the failure that body throws; Ok without a failure.
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

TEST(Target, OfTooManyVerticesIsRefused)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 200000001;
	EXPECT_EQ(statusOf([&] { resolveTarget(0, options, 1, 1); }), Status::OutOfMemory);
	options.targetVertexNum = 200000000;
	EXPECT_EQ(resolveTarget(0, options, 1, 1), 200000000);
}

} // namespace

} // namespace gpr::test
