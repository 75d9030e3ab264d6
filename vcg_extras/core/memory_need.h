// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MEMORY_NEED_H
#define VCG_EXTRAS_CORE_MEMORY_NEED_H

#include "indexed_mesh.h"
#include "workers.h"

#include <cstdint>

namespace gpr {

/// About how many faces splitLongEdges leaves, within a factor of two. Cost: a parallel pass.
double facesAfterSplitting(const IndexedMesh& mesh, float maxLength, Workers& workers);

/// About how many bytes the engine holds at most for a mesh of so many faces, after splitting, and
/// a result of so many vertices; without the caller's mesh.
double bytesNeeded(double faceNum, double resultVertexNum);

/// Throws Failure{OutOfMemory} with both figures where more is needed than is available; available
/// 0: unknown, nothing is refused.
void requireMemory(double needed, std::int64_t available);

} // namespace gpr

#endif
