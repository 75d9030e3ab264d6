// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_TARGET_H
#define VCG_EXTRAS_CORE_SAMPLING_TARGET_H

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>

#include <cstdint>

namespace gpr {

/// Edge length in largest errors that a search for the count of an error begins with: many
/// triangles a trial cost more than a trial.
constexpr double edgePerError = 5;
/// More vertices are refused.
constexpr double maxResultVertices = 2e8;

/// Radius of the disks that so many samples on an area have, eq. (1).
double diskRadius(double area, double vertexNum, double constant);

/// c of eq. (1) for the preset chosen.
double radiusConstant(const RemeshOptions& options);

/// Edge length of so many vertices' equilateral triangles of one size.
float evenEdge(double area, std::int64_t vertexNum);

/// The largest error asked for, in the units of the diagonal, with TargetMode::MaxError or Detail.
double largestError(const RemeshOptions& options, double diagonal);

/// Vertices of about-equilateral triangles of this edge length that cover the area.
double vertexNumForEdgeLength(double area, double edgeLength);

/// The number of vertices that the options ask for, not rounded, whatever it is; area and scale as
/// below.
double wantedVertexNum(std::int64_t inputVertexNum, const RemeshOptions& options, double area,
					   double scale);

/// The number of vertices that the options ask for; area in working units squared, scale from mesh
/// to working units. Throws Failure where it is more than a mesh may have.
std::int64_t resolveTarget(std::int64_t inputVertexNum, const RemeshOptions& options, double area,
						   double scale);

/// Area and diagonal of a mesh as given, mesh units; faces with indices out of range or corners
/// that are not finite are left out.
struct MeshExtent {
	double area     = 0;
	double diagonal = 0;
};
MeshExtent extentOf(const MeshView& mesh);

} // namespace gpr

#endif
