// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_GEODESIC_POISSON_BASE_H
#define VCG_EXTRAS_GEODESIC_POISSON_BASE_H

#include <vcg_extras/core/remesh.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vcg {
namespace tri {

/** \brief How a call ended: what all geodesic Poisson-disk algorithms return.

Everything but gpr::Status::Ok means that no mesh of the caller was touched, and message says why in
one sentence for the user.
*/
struct GeodesicPoissonResult {
	gpr::Status              status = gpr::Status::InternalError;
	std::string              message;   ///< empty when Ok
	std::vector<std::string> notes;     ///< sentences worth showing even when all went well
	std::int64_t smallestVertexNum = 0; ///< with CountTooSmall: the count to ask for instead

	bool IsOk() const { return status == gpr::Status::Ok; }
};

/** \brief The wanted size of the result, and what every run needs.

The ranges are those of gpr::RemeshOptions; a value out of range ends a call with BadOptions.
*/
struct GeodesicPoissonParams {
	gpr::TargetMode targetMode      = gpr::TargetMode::Percent;
	std::int64_t    targetVertexNum = 0;  ///< vertices, >= 1
	double          targetPerc      = 10; ///< percent of the input's vertices, > 0, <= 10000
	double          targetLen       = 0;  ///< mean edge length in mesh units, > 0
	std::uint32_t   seed            = 1;  ///< 0 = a fresh seed, told in Stat::seed
	int             threadNum       = 0;  ///< 0 = one per core; never changes the result
	double          lambda          = 0; ///< how much denser curved places are, eq. (4); 0 = evenly
	double          adapt           = 0; ///< sizes by the error to be expected, [0, 1]; 0 = evenly

	std::int64_t dropComponentsBelow = 0; ///< components with fewer faces are left out; 0 = none
	double       timeLimit           = 0; ///< seconds after which a run is given up; 0 = none

	void SetTargetVertexNum(std::int64_t num)
	{
		targetMode      = gpr::TargetMode::VertexNum;
		targetVertexNum = num;
	}
	void SetTargetPerc(double perc)
	{
		targetMode = gpr::TargetMode::Percent;
		targetPerc = perc;
	}
	void SetTargetLen(double len)
	{
		targetMode = gpr::TargetMode::EdgeLength;
		targetLen  = len;
	}

	/// The same choices as the engine takes them.
	gpr::RemeshOptions Options() const
	{
		gpr::RemeshOptions o;
		o.targetMode      = targetMode;
		o.targetVertexNum = targetVertexNum;
		o.targetPercent   = targetPerc;
		o.targetEdgeLen   = targetLen;
		o.seed            = seed;
		o.threads         = threadNum;
		o.lambda          = lambda;
		o.adapt           = adapt;

		o.dropComponentsBelow = dropComponentsBelow;
		o.timeLimitSeconds    = timeLimit;
		return o;
	}
};

} // namespace tri
} // namespace vcg

#endif
