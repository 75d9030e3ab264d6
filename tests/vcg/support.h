// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_VCG_SUPPORT_H
#define GPR_TESTS_VCG_SUPPORT_H

// Meshes to test with and the checks of results, all by vcglib's own functions.

#include "mesh_types.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/create/platonic.h>
#include <vcg/complex/algorithms/stat.h>
#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>
#include <vcg/complex/algorithms/update/topology.h>
#include <vcg/space/triangle3.h>
#include <vector>

namespace gpr_test {

typedef ::testing::Types<float, double> Scalars;

/// A unit sphere of 10·4^subdivNum + 2 vertices.
template <class MeshType>
void MakeSphere(MeshType& m, int subdivNum)
{
	m.Clear();
	vcg::tri::Sphere(m, subdivNum);
	vcg::tri::Allocator<MeshType>::CompactEveryVector(m);
	vcg::tri::UpdateBounding<MeshType>::Box(m);
}

/// A torus of 96 by 48 vertices.
template <class MeshType>
void MakeTorus(MeshType& m)
{
	vcg::tri::Torus(m, 2.0f, 0.8f, 96, 48);
	vcg::tri::Allocator<MeshType>::CompactEveryVector(m);
	vcg::tri::UpdateBounding<MeshType>::Box(m);
}

/// A bent square sheet of 61 by 61 vertices: one border loop, four corners.
template <class MeshType>
void MakeSheet(MeshType& m)
{
	vcg::tri::Grid(m, 61, 61, 3.0f, 3.0f);
	typedef typename MeshType::ScalarType ScalarType;
	for (auto& v : m.vert)
		v.P()[2] = ScalarType(0.2 * std::sin(2.0 * v.P()[0]) * std::cos(1.5 * v.P()[1]));
	vcg::tri::Allocator<MeshType>::CompactEveryVector(m);
	vcg::tri::UpdateBounding<MeshType>::Box(m);
}

/// Adds vertices and faces and deletes these elements: gaps at both ends, with not-a-number inside.
template <class MeshType>
void AddGaps(MeshType& m)
{
	typedef typename MeshType::CoordType  CoordType;
	typedef vcg::tri::Allocator<MeshType> AllocatorType;
	const auto nan = std::numeric_limits<typename MeshType::ScalarType>::quiet_NaN();
	for (int i = 0; i < 5; ++i)
		AllocatorType::AddFace(m, CoordType(nan, 0, 0), CoordType(0, nan, 0), CoordType(0, 0, nan));
	// The gaps go to the front too: the first elements move to the end.
	const std::size_t lastVert = m.vert.size() - 1, lastFace = m.face.size() - 1;
	std::swap(m.vert[0].P(), m.vert[lastVert].P());
	for (auto& f : m.face)
		for (int k = 0; k < 3; ++k) {
			if (f.V(k) == &m.vert[0])
				f.V(k) = &m.vert[lastVert];
			else if (f.V(k) == &m.vert[lastVert])
				f.V(k) = &m.vert[0];
		}
	for (int k = 0; k < 3; ++k)
		std::swap(m.face[0].V(k), m.face[lastFace].V(k));
	AllocatorType::DeleteFace(m, m.face[0]);
	for (std::size_t f = lastFace - 4; f < lastFace; ++f)
		AllocatorType::DeleteFace(m, m.face[f]);
	AllocatorType::DeleteVertex(m, m.vert[0]);
	for (std::size_t v = lastVert - 14; v < lastVert; ++v)
		AllocatorType::DeleteVertex(m, m.vert[v]);
}

/// The bytes of all elements, and the counts: equal snapshots mean an untouched mesh.
template <class MeshType>
struct Snapshot {
	std::vector<char>          vert, face;
	int                        vn, fn;
	typename MeshType::BoxType bbox;
	const void *               vertAt, *faceAt;

	explicit Snapshot(const MeshType& m) :
			vert(BytesOf(m.vert)), face(BytesOf(m.face)), vn(m.vn), fn(m.fn), bbox(m.bbox),
			vertAt(m.vert.data()), faceAt(m.face.data())
	{
	}
	bool operator==(const Snapshot& b) const
	{
		return vert == b.vert && face == b.face && vn == b.vn && fn == b.fn && bbox == b.bbox &&
			   vertAt == b.vertAt && faceAt == b.faceAt;
	}

private:
	template <class ContainerType>
	static std::vector<char> BytesOf(const ContainerType& c)
	{
		std::vector<char> bytes(c.size() * sizeof(c[0]));
		if (!bytes.empty())
			std::memcpy(bytes.data(), static_cast<const void*>(c.data()), bytes.size());
		return bytes;
	}
};

template <class MeshType>
Snapshot<MeshType> SnapshotOf(const MeshType& m)
{
	return Snapshot<MeshType>(m);
}

/// The topology by vcglib's Clean, for a mesh with face-face adjacency.
struct Topology {
	int componentNum = 0, holeNum = 0, genus = 0;
	int nonManifoldEdgeNum = 0, nonManifoldVertexNum = 0;

	bool operator==(const Topology& b) const
	{
		return componentNum == b.componentNum && holeNum == b.holeNum && genus == b.genus &&
			   nonManifoldEdgeNum == b.nonManifoldEdgeNum &&
			   nonManifoldVertexNum == b.nonManifoldVertexNum;
	}
};
inline std::ostream& operator<<(std::ostream& to, const Topology& t)
{
	return to << t.componentNum << " components, " << t.holeNum << " holes, genus " << t.genus
			  << ", " << t.nonManifoldEdgeNum << " and " << t.nonManifoldVertexNum
			  << " non-manifold edges and vertices";
}
template <class MeshType>
Topology TopologyOf(MeshType& m)
{
	typedef vcg::tri::Clean<MeshType> CleanType;
	vcg::tri::UpdateTopology<MeshType>::FaceFace(m);
	Topology t;
	t.nonManifoldEdgeNum = CleanType::CountNonManifoldEdgeFF(m);
	if (t.nonManifoldEdgeNum > 0) return t; // the other counts walk over manifold edges
	t.nonManifoldVertexNum = CleanType::CountNonManifoldVertexFF(m, false);
	t.componentNum         = CleanType::CountConnectedComponents(m);
	t.holeNum              = CleanType::CountHoles(m);
	t.genus                = CleanType::MeshGenus(m);
	return t;
}

/// Expects a sound result: compact, 2-manifold, coherently oriented, without vertices outside of
/// faces and without degenerate faces.
template <class MeshType>
void ExpectSound(MeshType& m)
{
	typedef vcg::tri::Clean<MeshType> CleanType;
	EXPECT_EQ(m.VN(), int(m.vert.size()));
	EXPECT_EQ(m.FN(), int(m.face.size()));
	const Topology t = TopologyOf(m);
	ASSERT_EQ(t.nonManifoldEdgeNum, 0);
	EXPECT_EQ(t.nonManifoldVertexNum, 0);
	EXPECT_TRUE(CleanType::IsCoherentlyOrientedMesh(m));
	EXPECT_EQ(CleanType::CountUnreferencedVertex(m), 0);
	for (const auto& f : m.face)
		ASSERT_GT(vcg::DoubleArea(f), 0);
}

/// Mean of 2·inradius/circumradius, by vcglib's measure: 1 = all equilateral.
template <class MeshType>
double MeanRadiusRatio(const MeshType& m)
{
	double sum = 0;
	for (const auto& f : m.face)
		sum += vcg::QualityRadii(f.cP(0), f.cP(1), f.cP(2));
	return sum / double(m.face.size());
}

/// A callback with the answer 'cancel'.
inline bool CancelAtOnce(const int, const char*)
{
	return false;
}

} // namespace gpr_test

#endif
