// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "target.h"

#include <vcg_extras/core/base/failure.h>

#include <algorithm>
#include <cmath>

namespace gpr {

double vertexNumForEdgeLength(double area, double edgeLength)
{
	return 2 * area / (std::sqrt(3.0) * edgeLength * edgeLength);
}

double wantedVertexNum(const MeshView& input, const RemeshOptions& o, double area, double scale)
{
	switch (o.targetMode) {
	case TargetMode::VertexNum:
		return double(o.targetVertexNum);
	case TargetMode::Percent:
		return o.targetPercent / 100 * double(input.vertexNum);
	case TargetMode::EdgeLength:
		return vertexNumForEdgeLength(area, o.targetEdgeLen * scale);
	case TargetMode::MaxError: // a sampling alone has no error to look at
		return vertexNumForEdgeLength(area, edgePerError * o.targetMaxError * scale);
	}
	return 0;
}

std::int64_t resolveTarget(const MeshView& input, const RemeshOptions& o, double area, double scale)
{
	const double n = std::round(wantedVertexNum(input, o, area, scale));
	if (n > maxResultVertices) {
		throw Failure(Status::OutOfMemory, "The result would have more than 200,000,000 vertices.");
	}
	return std::max<std::int64_t>(1, std::int64_t(n));
}

bool isTargetWish(const RemeshOptions& options)
{
	return options.allowNearest || options.targetMode != TargetMode::VertexNum;
}

Target targetWithRoom(const RemeshOptions& options, std::int64_t vertexNum, std::int64_t keptNum)
{
	const bool keepsBorder = options.boundary == BoundaryMode::Keep;
	if (keptNum > vertexNum && keepsBorder && isTargetWish(options)) {
		const std::int64_t raised = keptNum + keptNum / 2 + vertexNum;
		return {raised, "The border has " + std::to_string(keptNum) +
							" vertices to be kept, so that " + std::to_string(raised) +
							" vertices were aimed at instead of " + std::to_string(vertexNum) +
							"."};
	}
	requireRoomForKept(options, vertexNum, keptNum);
	return {vertexNum, ""};
}

void requireRoomForKept(const RemeshOptions& options, std::int64_t vertexNum, std::int64_t keptNum)
{
	if (keptNum <= vertexNum) return;
	const bool        keepsBorder = options.boundary == BoundaryMode::Keep;
	const std::string whatIsKept  = keepsBorder ? "border has " : "feature region has ";
	const std::string otherWay    = keepsBorder ? "" : ", or give a feature disk scale";
	throw Failure(Status::BadOptions, "The " + whatIsKept + std::to_string(keptNum) +
										  " vertices to be kept, more than the " +
										  std::to_string(vertexNum) +
										  " of the result; ask for more vertices" + otherWay + ".");
}

} // namespace gpr
