// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIONS_H
#define VCG_EXTRAS_CORE_OPTIONS_H

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace gpr {

/// How the wanted size of the result is given.
enum class TargetMode {
	VertexNum,  ///< exactly targetVertexNum vertices; a count below what the topology needs is
				///< refused
	Percent,    ///< targetPercent of the input's vertices; raised where the topology needs more
	EdgeLength, ///< mean edge length targetEdgeLen; raised count where the topology needs more
};

/// Everything a caller can choose. Plain data; nothing here is working state.
struct RemeshOptions {
	TargetMode    targetMode      = TargetMode::Percent;
	std::int64_t  targetVertexNum = 0;     ///< vertices, >= 1; used with TargetMode::VertexNum
	double        targetPercent   = 10;    ///< percent of the input's vertices, > 0, <= 10000
	double        targetEdgeLen   = 0;     ///< mesh units, > 0; used with TargetMode::EdgeLength
	bool          exactCount      = true;  ///< split and collapse until the count is hit exactly
	bool          allowNearest    = false; ///< take the nearest reachable count instead of refusing
	int           relaxIterations = 5;     ///< relaxation steps, 0 to 1000
	std::uint32_t seed            = 1;     ///< 0 = a fresh seed, told in the report
	int           threads         = 0;     ///< 0 = one per core; never changes the result
};

/// Complaints about values out of range, one sentence each; empty when all is well.
std::vector<std::string> validate(const RemeshOptions& options);

/// Called from the thread that called the engine, at most about every 50 ms, with the share of the
/// work done in [0, 1] and a short verb phrase. Returning false cancels: the engine ends with
/// Status::Cancelled and hands out nothing.
using ProgressCallback = std::function<bool(double share, const char* phrase)>;

} // namespace gpr

#endif
