// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SELECTED_PART_H
#define VCG_EXTRAS_CORE_INPUT_SELECTED_PART_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// The selected faces as a mesh of its own, and the way back to the input mesh.
struct SelectedPart : MarkedMesh {
	std::vector<std::int32_t> vertexOf; ///< per vertex: vertex of the input mesh
	std::vector<std::int32_t> faceOf;   ///< per face: face of the input mesh
	std::vector<std::uint8_t> isInPart; ///< per face of the input mesh
};

/// Copies the selected faces, with their vertices in the order of the faces' corners. Leaves out
/// thin faces at the edge of the selection (thin_border.h). Throws Failure if no face is selected,
/// and for a vertex number out of range. Cost: linear.
SelectedPart cutOutSelected(const MeshView& input);

} // namespace gpr

#endif
