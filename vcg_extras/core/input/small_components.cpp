// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_components.h"

#include <vcg_extras/core/mesh/components.h>

namespace gpr {

SmallComponents findSmallComponents(const HalfEdgeMesh& mesh, std::int64_t minFaceNum,
									Workers& workers)
{
	const Components          found = findComponents(mesh, workers);
	std::vector<std::int64_t> faceNum(std::size_t(found.num), 0);
	for (int component : found.ofFace)
		++faceNum[std::size_t(component)];
	const auto isSmall = [&](int component) {
		return faceNum[std::size_t(component)] < minFaceNum;
	};
	SmallComponents small;
	for (int component = 0; component < found.num; ++component)
		small.num += isSmall(component);
	for (int f = 0; f < mesh.faceNum; ++f) {
		if (isSmall(found.ofFace[std::size_t(f)])) small.faces.push_back(f);
	}
	return small;
}

} // namespace gpr
