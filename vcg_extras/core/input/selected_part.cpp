// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "selected_part.h"

#include "load.h"
#include "thin_border.h"

#include <vcg_extras/core/base/failure.h>

namespace gpr {

namespace {

void addVertex(const MeshView& input, std::int32_t v, SelectedPart& part)
{
	part.vertexOf.push_back(v);
	part.positions.push_back(input.position(std::size_t(v)));
	if (input.selected != nullptr) part.selected.push_back(input.selected[v]);
}

} // namespace

SelectedPart cutOutSelected(const MeshView& input)
{
	Workers workers(1, nullptr);
	requireVertexNumbers(input, workers);
	SelectedPart part;
	part.isInPart.resize(input.faceNum);
	for (std::size_t f = 0; f < input.faceNum; ++f)
		part.isInPart[f] = input.selectedFace != nullptr && input.selectedFace[f] != 0;
	takeOutThinBorder(input, part.isInPart);
	std::vector<std::int32_t> newIndex(input.vertexNum, -1);
	for (std::size_t f = 0; f < input.faceNum; ++f) {
		if (!part.isInPart[f]) continue;
		part.faceOf.push_back(std::int32_t(f));
		if (input.region != nullptr) part.region.push_back(input.region[f]);
		for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
			std::int32_t& index = newIndex[input.vertexOf(c)];
			if (index < 0) {
				index = std::int32_t(part.vertexOf.size());
				addVertex(input, input.vertexOf(c), part);
			}
			part.triangles.push_back(index);
			if (input.line != nullptr) part.line.push_back(input.line[c]);
		}
	}
	if (part.faceOf.empty()) throw Failure(Status::BadOptions, "No face is selected.");
	return part;
}

} // namespace gpr
