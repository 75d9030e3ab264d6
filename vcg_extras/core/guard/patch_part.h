// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_PART_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_PART_H

#include "patch_filling.h"

#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// Rings of faces round marked faces that may change too: vertices of two rings move.
constexpr int ringsChanged = 3;

/// A patch of a result with rings of faces round the patch, as a result of its own.
struct PatchPart {
	ResultMesh        result;
	std::vector<int>  vertex; ///< per vertex: vertex of the whole
	std::vector<int>  face;   ///< per face: face of the whole
	std::vector<char> isRim;  ///< per face: in the outermost ring

	/// Whether the marks are so far from the rim that no change comes near the rim.
	bool hasRoomFor(const std::vector<char>& marked) const;
	/// The marked faces of the whole, ascending.
	std::vector<int> inWhole(const std::vector<char>& marked) const;
};

/// Cuts out the faces of a patch with some rings round the faces. Faces of the whole that are near
/// only in space are added unconnected, so that new faces do not touch them. tree: of the whole.
/// triesBefore: of the patch, each of which adds rings, since a patch that did not fit has to grow.
/// Cost: linear in the part.
PatchPart cutPart(const ResultMesh& whole, const FaceBoxes& tree, const std::vector<int>& faces,
				  int triesBefore, Workers& workers);

/// A filled patch, and the faces of the whole to replace.
struct FilledPart {
	PatchPart        part;
	Filled           filled;
	std::vector<int> replaced; ///< faces of the whole, ascending
};

/// Puts filled patches into the whole. No two patches may replace the same face. newIndex: new
/// names of the vertices, -1 for removed vertices. Cost: a pass over the whole.
void putBack(const std::vector<FilledPart>& parts, ResultMesh& whole, std::vector<int>& newIndex);

} // namespace gpr

#endif
