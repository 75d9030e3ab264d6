// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Remeshing of meshes with optional components. The file is separate because each mesh type adds
// much to the memory of the compiler.
#include "remeshing_params.h"
#include "support.h"

using namespace gpr_test;
using namespace vcg::tri;

namespace {

template <class S>
class OptionalComponentsTest : public ::testing::Test {
};
TYPED_TEST_SUITE(OptionalComponentsTest, Scalars);

TYPED_TEST(OptionalComponentsTest, RespectsOptionalComponents)
{
	typedef OcfMesh<TypeParam> MeshType;
	for (const bool enabledFlag : {false, true}) {
		MeshType m;
		m.face.EnableFFAdjacency(); // for the builder
		MakeTorus(m);
		m.face.DisableFFAdjacency();
		if (enabledFlag) {
			m.vert.EnableQuality();
			m.vert.EnableColor();
			m.vert.EnableNormal();
			m.face.EnableFFAdjacency();
			for (auto& v : m.vert) {
				v.Q() = 3;
				v.C() = vcg::Color4b::Blue;
			}
		}
		const auto result = GeodesicPoissonRemeshing<MeshType>::Do(m, ParamsOf<MeshType>(500));
		ASSERT_TRUE(result.IsOk()) << result.message;
		EXPECT_EQ(m.VN(), 500);
		EXPECT_EQ(HasPerVertexQuality(m), enabledFlag);
		EXPECT_EQ(HasPerVertexColor(m), enabledFlag);
		EXPECT_EQ(HasFFAdjacency(m), enabledFlag);
		if (!enabledFlag) continue;
		EXPECT_TRUE(Clean<MeshType>::IsFFAdjacencyConsistent(m));
		for (const auto& v : m.vert) {
			EXPECT_NEAR(v.cQ(), 3, 1e-5);
			EXPECT_TRUE(v.cC() == vcg::Color4b(vcg::Color4b::Blue));
			EXPECT_NEAR(v.cN().Norm(), 1, 1e-5);
		}
	}
}

} // namespace
