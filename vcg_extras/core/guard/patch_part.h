// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_PART_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_PART_H

#include "patch_filling.h"

#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// Rings of faces round marked ones that may change with them: vertices of two rings move.
constexpr int ringsChanged = 3;

/// The faces at the vertices of some faces, so many times; ascending.
std::vector<int> widened(const HalfEdgeMesh& mesh, std::vector<int> faces, int rings);

/// A patch of a result and what lies round it, as a result of its own.
struct PatchPart {
	ResultMesh        result;
	std::vector<int>  vertex; ///< per vertex: of the whole
	std::vector<int>  face;   ///< per face: of the whole
	std::vector<char> isRim;  ///< per face: has a neighbour, or a corner's face, that is not here

	/// Whether marks are so far from the rim that nothing made there comes near it.
	bool hasRoomFor(std::vector<char> marked) const;
	/// The marked faces of the whole, ascending.
	std::vector<int> inWhole(const std::vector<char>& marked) const;
};

/// Cuts the faces of a patch out with some rings round them. Faces of the whole that lie near in
/// space only are there one by one, so that nothing that is made touches them. tree: of the whole.
/// Cost: that of the part.
PatchPart cutPart(const ResultMesh& whole, const FaceBoxes& tree, const std::vector<int>& faces);

/// A patch that was filled, and the faces of the whole in whose place it comes.
struct FilledPart {
	PatchPart        part;
	Filled           filled;
	std::vector<int> replaced; ///< faces of the whole, ascending
};

/// Puts filled patches into the whole; none replaces a face of another. newIndex gets the new names
/// of the vertices, -1 of those that have gone. Cost: a pass over the whole.
void putBack(const std::vector<FilledPart>& parts, ResultMesh& whole, std::vector<int>& newIndex);

} // namespace gpr

#endif
