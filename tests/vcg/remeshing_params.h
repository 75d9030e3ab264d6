// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_VCG_REMESHING_PARAMS_H
#define GPR_TESTS_VCG_REMESHING_PARAMS_H

#include <vcg_extras/complex/algorithms/geodesic_poisson_remeshing.h>

#include <cstdint>

namespace gpr_test {

template <class MeshType>
typename vcg::tri::GeodesicPoissonRemeshing<MeshType>::Params ParamsOf(std::int64_t vertexNum)
{
	typename vcg::tri::GeodesicPoissonRemeshing<MeshType>::Params params;
	params.SetTargetVertexNum(vertexNum);
	return params;
}

} // namespace gpr_test

#endif
