// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_REPORT_MESH_PARTS_H
#define VCG_EXTRAS_IO_REPORT_MESH_PARTS_H

#include <vcg_extras/io/mesh/mesh_data.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gpr::app {

/// The regions of a mesh, and its edges with more than two faces.
struct MeshParts {
	struct Region {
		std::int32_t label = 0;
		std::string  name;
		std::int64_t faces = 0, pieces = 0; ///< pieces: faces linked over edges
		double       area = 0;              ///< mesh units squared
	};
	std::vector<Region> regions; ///< by label; empty: the file tells none
	std::int64_t        junctionEdges  = 0;
	double              junctionLength = 0; ///< mesh units
};

/// Measures the regions and junctions of a mesh. Cost: O(F log F), serial.
MeshParts measureParts(const InputMesh& mesh);

} // namespace gpr::app

#endif
