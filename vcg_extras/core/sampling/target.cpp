// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "target.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/surface/triangle_tree.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// c of eq. (1) as printed in the paper, from the sampler of Fu and Zhou.
constexpr double printedRadiusConstant = 0.844;
/// c of this sampling: the count lands at 98 to 99 % of the target, and the exact count adds the
/// rest. Placement by disk intersection packs tighter than random border edges.
constexpr double intersectionRadiusConstant = 0.962;

} // namespace

double diskRadius(double area, double vertexNum, double constant)
{
	return 2 * std::sqrt(area) * std::sqrt(1 / (2 * std::sqrt(3.0) * vertexNum)) * constant;
}

double radiusConstant(const RemeshOptions& options)
{
	return isPaper(options) ? printedRadiusConstant : intersectionRadiusConstant;
}

float evenEdge(double area, std::int64_t vertexNum)
{
	return float(diskRadius(area, double(vertexNum), 1));
}

RemeshOptions withoutPercent(RemeshOptions o, double diagonal)
{
	const auto resolve = [diagonal](double& length, bool& isPercent) {
		if (isPercent) length *= diagonal / 100;
		isPercent = false;
	};
	resolve(o.targetEdgeLen, o.edgeLenIsPercent);
	resolve(o.targetMaxError, o.maxErrorIsPercent);
	resolve(o.minEdge, o.minEdgeIsPercent);
	resolve(o.maxEdge, o.maxEdgeIsPercent);
	return o;
}

double largestError(const RemeshOptions& o, double diagonal)
{
	if (o.targetMode == TargetMode::Detail) return detailError(o.targetDetail) * diagonal;
	return withoutPercent(o, diagonal).targetMaxError;
}

double vertexNumForEdgeLength(double area, double edgeLength)
{
	return 2 * area / (std::sqrt(3.0) * edgeLength * edgeLength);
}

double wantedVertexNum(std::int64_t inputVertexNum, const RemeshOptions& o, double area,
					   double scale)
{
	switch (o.targetMode) {
	case TargetMode::VertexNum:
		return double(o.targetVertexNum);
	case TargetMode::FaceNum: // of a closed surface without handles
		return 0.5 * double(o.targetFaceNum) + 2;
	case TargetMode::Percent:
		return o.targetPercent / 100 * double(inputVertexNum);
	case TargetMode::EdgeLength:
		return vertexNumForEdgeLength(area, o.targetEdgeLen * scale);
	case TargetMode::Sizes: // until the sizes are known
		return o.maxEdge > 0 ? vertexNumForEdgeLength(area, o.maxEdge * scale)
							 : 0.1 * double(inputVertexNum);
	case TargetMode::Detail: // as MaxError, with the diagonal of a cube of this area
		return vertexNumForEdgeLength(area, edgePerError * detailError(o.targetDetail) *
												std::sqrt(0.5 * area));
	case TargetMode::MaxError: // a sampling alone measures no error
		return vertexNumForEdgeLength(area, edgePerError * o.targetMaxError * scale);
	}
	return 0;
}

std::int64_t resolveTarget(std::int64_t inputVertexNum, const RemeshOptions& o, double area,
						   double scale)
{
	const double n = std::round(wantedVertexNum(inputVertexNum, o, area, scale));
	if (n > maxResultVertices) {
		throw Failure(Status::OutOfMemory, "The result would have more than 200,000,000 vertices.");
	}
	return std::max<std::int64_t>(1, std::int64_t(n));
}

MeshExtent extentOf(const MeshView& mesh)
{
	MeshExtent  extent;
	Box<double> box;
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		if (!hasPlaces(mesh, f)) continue;
		extent.area += 0.5 * length(mesh.faceCross(f));
		for (const std::int32_t v : mesh.triangle(f))
			box.add(mesh.position(std::size_t(v)));
	}
	extent.diagonal = box.diagonal();
	return extent;
}

RemeshOptions inMeshUnits(const MeshView& mesh, const RemeshOptions& o)
{
	const bool hasPercent =
		o.edgeLenIsPercent || o.maxErrorIsPercent || o.minEdgeIsPercent || o.maxEdgeIsPercent;
	const double diagonal = hasPercent ? extentOf(mesh).diagonal : 0;
	return diagonal > 0 ? withoutPercent(o, diagonal) : o; // what has no extent is refused
}

} // namespace gpr
