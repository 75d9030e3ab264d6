// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_TARGET_H
#define VCG_EXTRAS_CORE_SAMPLING_TARGET_H

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>

#include <cstdint>

namespace gpr {

/// The edge length, in error bounds, at which a search for the count begins: a trial with many
/// triangles costs more than an additional trial.
constexpr double edgePerError = 5;
/// The most vertices of a result; more are refused.
constexpr double maxResultVertices = 2e8;

/// Disk radius of vertexNum samples on an area, eq. (1).
double diskRadius(double area, double vertexNum, double constant);

/// The constant c of eq. (1) for the preset.
double radiusConstant(const RemeshOptions& options);

/// Edge length of vertexNum vertices in equilateral triangles of one size.
float evenEdge(double area, std::int64_t vertexNum);

/// The same options with all lengths in the units of the diagonal.
RemeshOptions withoutPercent(RemeshOptions options, double diagonal);

/// The error bound of the options, in the units of the diagonal, with TargetMode::MaxError or
/// Detail.
double largestError(const RemeshOptions& options, double diagonal);

/// Number of vertices of equilateral triangles with this edge length on the area.
double vertexNumForEdgeLength(double area, double edgeLength);

/// The wanted number of vertices, not rounded, for any target mode; area and scale as in
/// resolveTarget.
double wantedVertexNum(std::int64_t inputVertexNum, const RemeshOptions& options, double area,
					   double scale);

/// The wanted number of vertices; area in working units squared, scale from mesh to working units.
/// Throws Failure if the number is more than a mesh may have.
std::int64_t resolveTarget(std::int64_t inputVertexNum, const RemeshOptions& options, double area,
						   double scale);

/// Area and diagonal of a mesh, mesh units. Faces with indices out of range or with corners that
/// are not finite are left out.
struct MeshExtent {
	double area     = 0;
	double diagonal = 0;
};
MeshExtent extentOf(const MeshView& mesh);

/// The options with all lengths in mesh units. Cost: linear where a length is in percent.
RemeshOptions inMeshUnits(const MeshView& mesh, const RemeshOptions& options);

} // namespace gpr

#endif
