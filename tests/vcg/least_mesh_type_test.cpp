// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Remeshing of meshes with the fewest components. The file is separate because each mesh type adds
// much to the memory of the compiler.
#include "remeshing_params.h"
#include "support.h"

using namespace gpr_test;
using namespace vcg::tri;

namespace {

template <class S>
class LeastMeshTypeTest : public ::testing::Test {
};
TYPED_TEST_SUITE(LeastMeshTypeTest, Scalars);

TYPED_TEST(LeastMeshTypeTest, TheLeastMeshTypeWillDo)
{
	using Full = FullMesh<TypeParam>;
	using Bare = BareMesh<TypeParam>;
	Full full;
	Bare bare;
	MakeTorus(full);
	Append<Bare, Full>::Mesh(bare, full);
	ASSERT_TRUE(GeodesicPoissonRemeshing<Full>::Do(full, ParamsOf<Full>(500)).IsOk());
	ASSERT_TRUE(GeodesicPoissonRemeshing<Bare>::Do(bare, ParamsOf<Bare>(500)).IsOk());
	ASSERT_EQ(bare.vert.size(), full.vert.size());
	for (std::size_t v = 0; v < bare.vert.size(); ++v)
		EXPECT_TRUE(bare.vert[v].cP() == full.vert[v].cP());
}

TYPED_TEST(LeastMeshTypeTest, AMissingComponentIsThrown)
{
	using MeshType = FlaglessMesh<TypeParam>;
	MeshType m;
	EXPECT_THROW(GeodesicPoissonRemeshing<MeshType>::Do(m), vcg::MissingComponentException);
}

} // namespace
