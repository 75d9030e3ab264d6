// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_components.h"

#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/mesh/components.h>

#include <algorithm>

namespace gpr {

SmallComponents findSmallComponents(const HalfEdgeMesh& mesh, std::int64_t minFaceNum,
									Workers& workers)
{
	const Components          found = findComponents(mesh, workers);
	std::vector<std::int64_t> faceNum(std::size_t(found.num), 0);
	Poller                    poller(workers);
	for (int component : found.ofFace) {
		poller.count();
		++faceNum[std::size_t(component)];
	}
	const auto      isSmall = [&](std::int64_t num) { return num < minFaceNum; };
	SmallComponents small;
	small.num   = std::count_if(faceNum.begin(), faceNum.end(), isSmall);
	small.faces = workers.collectIf(std::size_t(mesh.faceNum), [&](int f) {
		return isSmall(faceNum[std::size_t(found.ofFace[std::size_t(f)])]);
	});
	return small;
}

} // namespace gpr
