// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_MEMORY_NEED_H
#define VCG_EXTRAS_CORE_INPUT_MEMORY_NEED_H

#include <vcg_extras/core/mesh/indexed_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Estimate, within a factor of two, of the number of faces after splitLongEdges. longFaces: the
/// faces with an edge longer than maxLength (see findLongFaces). Cost: a look at these faces.
double facesAfterSplitting(const IndexedMesh& mesh, const std::vector<int>& longFaces,
						   float maxLength);

/// Estimate of the engine's peak memory in bytes, for faceNum faces after splitting and
/// resultVertexNum vertices in the result; without the input mesh.
double bytesNeeded(double faceNum, double resultVertexNum);

/// Throws Failure{OutOfMemory} with both figures if needed exceeds available; available 0: unknown,
/// no refusal.
void requireMemory(double needed, std::int64_t available);

} // namespace gpr

#endif
