// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_MEMORY_NEED_H
#define VCG_EXTRAS_CORE_INPUT_MEMORY_NEED_H

#include <vcg_extras/core/mesh/indexed_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// About how many faces splitLongEdges leaves, within a factor of two, of a mesh whose faces with a
/// longer edge than maxLength are these (see findLongFaces). Cost: theirs alone.
double facesAfterSplitting(const IndexedMesh& mesh, const std::vector<int>& longFaces,
						   float maxLength);

/// About how many bytes the engine holds at most for a mesh of so many faces, after splitting, and
/// a result of so many vertices; without the caller's mesh.
double bytesNeeded(double faceNum, double resultVertexNum);

/// Throws Failure{OutOfMemory} with both figures where more is needed than is available; available
/// 0: unknown, nothing is refused.
void requireMemory(double needed, std::int64_t available);

} // namespace gpr

#endif
