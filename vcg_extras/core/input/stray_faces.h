// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_STRAY_FACES_H
#define VCG_EXTRAS_CORE_INPUT_STRAY_FACES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Few huge faces that reach far beyond all others, as broken scans have them.
struct StrayFaces {
	std::int64_t num       = 0;
	double       sizeRatio = 1; ///< diagonal of the whole mesh over that of the others
	double       areaShare = 0; ///< theirs of the whole
};

/// Looks for them among the long faces of a mesh (see findLongFaces): at most a hundredth of all
/// faces, without which the box of the mesh would be at most half as large; num is 0 where there
/// are none. A large face beside small ones, as flat parts of machines have it, is not stray as
/// long as small ones lie along all of its length. Cost: that of the long faces; a parallel pass
/// where some of them are nearly as long as the mesh.
StrayFaces findStrayFaces(const IndexedMesh& mesh, const std::vector<int>& longFaces,
						  Workers& workers);

} // namespace gpr

#endif
