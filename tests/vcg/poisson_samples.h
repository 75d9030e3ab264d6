// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_VCG_POISSON_SAMPLES_H
#define GPR_TESTS_VCG_POISSON_SAMPLES_H

#include <vcg_extras/complex/algorithms/geodesic_poisson_sampling.h>

#include <gtest/gtest.h>
#include <vector>

namespace gpr_test {

/// About vertexNum points of a mesh, placed by the sampling.
template <class MeshType>
std::vector<typename MeshType::CoordType> PoissonSamples(MeshType& m, int vertexNum)
{
	typedef vcg::tri::GeodesicPoissonSampling<MeshType> Sampling;
	typename Sampling::Params                           params;
	params.SetTargetVertexNum(vertexNum);
	std::vector<typename Sampling::SamplePoint> points;
	EXPECT_TRUE(Sampling::Sample(m, params, points).IsOk());
	std::vector<typename MeshType::CoordType> positions;
	for (const auto& p : points)
		positions.push_back(p.position);
	return positions;
}

} // namespace gpr_test

#endif
