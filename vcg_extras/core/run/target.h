// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_TARGET_H
#define VCG_EXTRAS_CORE_RUN_TARGET_H

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>

#include <cstdint>
#include <string>

namespace gpr {

/// Edge length in largest errors that a search for the count of an error begins with: many
/// triangles a trial cost more than a trial.
constexpr double edgePerError = 5;
/// More vertices are refused.
constexpr double maxResultVertices = 2e8;

/// Vertices of about-equilateral triangles of this edge length that cover the area.
double vertexNumForEdgeLength(double area, double edgeLength);

/// The number of vertices that the options ask for, not rounded, whatever it is; area and scale as
/// below.
double wantedVertexNum(const MeshView& input, const RemeshOptions& options, double area,
					   double scale);

/// The number of vertices that the options ask for; area in working units squared, scale from mesh
/// to working units. Throws Failure where it is more than a mesh may have.
std::int64_t resolveTarget(const MeshView& input, const RemeshOptions& options, double area,
						   double scale);

/// Whether another count may be taken where the one asked for cannot be had.
bool isTargetWish(const RemeshOptions& options);

/// A count to aim at, and a sentence for the user where it is not the one asked for.
struct Target {
	std::int64_t vertexNum = 0;
	std::string  note;
};

/// Where the target is a wish, a border whose vertices are to be kept raises it to what these need
/// with some others between them. Throws Failure where they do not fit and it is not.
Target targetWithRoom(const RemeshOptions& options, std::int64_t vertexNum, std::int64_t keptNum);

/// Throws Failure where more vertices are to be kept than the result may have.
void requireRoomForKept(const RemeshOptions& options, std::int64_t vertexNum, std::int64_t keptNum);

} // namespace gpr

#endif
