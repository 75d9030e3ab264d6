// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include <cmath>

namespace gpr {

namespace {

void checkTarget(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	switch (o.targetMode) {
	case TargetMode::VertexNum:
		if (o.targetVertexNum < 1 || o.targetVertexNum > 2147483647) {
			complaints.push_back("The number of vertices must be between 1 and 2147483647.");
		}
		break;
	case TargetMode::Percent:
		if (!(o.targetPercent > 0 && o.targetPercent <= 10000)) {
			complaints.push_back("The percentage must be above 0 and at most 10000.");
		}
		break;
	case TargetMode::EdgeLength:
		if (!(o.targetEdgeLen > 0 && std::isfinite(o.targetEdgeLen))) {
			complaints.push_back("The edge length must be a finite number above 0.");
		}
		break;
	}
}

} // namespace

std::vector<std::string> validate(const RemeshOptions& o)
{
	std::vector<std::string> complaints;
	checkTarget(o, complaints);
	if (o.relaxIterations < 0 || o.relaxIterations > 1000) {
		complaints.push_back("The number of relaxation steps must be between 0 and 1000.");
	}
	if (o.threads < 0 || o.threads > 1024) {
		complaints.push_back("The number of threads must be between 0 and 1024.");
	}
	return complaints;
}

} // namespace gpr
