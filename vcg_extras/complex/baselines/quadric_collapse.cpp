// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Quadric Edge Collapse as in MeshLab. Source of the parameters and of the order of the steps:
// MeshLab 2020.09, filter_meshing (FP_QUADRIC_SIMPLIFICATION and QuadricSimplification).
#include "quadric_collapse.h"

#include "baseline_mesh.h"

#include <new>

// vcglib's headers need complex.h first.
// clang-format off
#include <vcg/container/simple_temporary_data.h>
#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/update/flag.h>
#include <vcg/complex/algorithms/local_optimization.h>
#include <vcg/complex/algorithms/local_optimization/tri_edge_collapse_quadric.h>
// clang-format on

namespace gpr::baselines {

namespace {

class CollapseVertex;
class CollapseFace;
struct CollapseTypes : public vcg::UsedTypes<vcg::Use<CollapseVertex>::AsVertexType,
											 vcg::Use<CollapseFace>::AsFaceType> {};
class CollapseVertex
		: public vcg::Vertex<CollapseTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
							 vcg::vertex::VFAdj, vcg::vertex::Mark, vcg::vertex::BitFlags> {};
class CollapseFace : public vcg::Face<CollapseTypes, vcg::face::VertexRef, vcg::face::Normal3f,
									  vcg::face::VFAdj, vcg::face::BitFlags> {};
class CollapseMesh
		: public vcg::tri::TriMesh<std::vector<CollapseVertex>, std::vector<CollapseFace>> {};

using Quadrics = vcg::SimpleTempData<CollapseMesh::VertContainer, vcg::math::Quadric<double>>;

/// Finds the quadric of a vertex for vcglib, which wants a class of static functions.
class QuadricHelper {
public:
	static void                        Init() {}
	static vcg::math::Quadric<double>& Qd(CollapseVertex& v) { return (*quadrics())[v]; }
	static vcg::math::Quadric<double>& Qd(CollapseVertex* v) { return (*quadrics())[*v]; }
	static float                       W(CollapseVertex*) { return 1; }
	static float                       W(CollapseVertex&) { return 1; }
	static void                        Merge(CollapseVertex&, const CollapseVertex&) {}
	static Quadrics*&                  quadrics()
	{
		static Quadrics* current = nullptr;
		return current;
	}
};

using VertexPair = vcg::tri::BasicVertexPair<CollapseVertex>;

class Collapse : public vcg::tri::TriEdgeCollapseQuadric<CollapseMesh, VertexPair, Collapse,
														 QuadricHelper> {
public:
	using Base =
		vcg::tri::TriEdgeCollapseQuadric<CollapseMesh, VertexPair, Collapse, QuadricHelper>;
	Collapse(const VertexPair& pair, int mark, vcg::BaseParameterClass* parameters) :
			Base(pair, mark, parameters)
	{
	}
};

vcg::tri::TriEdgeCollapseQuadricParameter dialogDefaults()
{
	vcg::tri::TriEdgeCollapseQuadricParameter p;
	p.QualityThr       = 0.3;
	p.PreserveBoundary = false;
	p.PreserveTopology = false;
	p.NormalCheck      = false;
	p.OptimalPlacement = true;
	p.QualityQuadric   = false;
	p.QualityWeight    = false;
	return p;
}

/// False if stopped.
bool collapse(CollapseMesh& mesh, std::int64_t faceNum, const std::function<bool()>& shallStop)
{
	vcg::math::Quadric<double> zero;
	zero.SetZero();
	Quadrics quadrics(mesh.vert, zero);
	QuadricHelper::quadrics() = &quadrics;

	vcg::tri::TriEdgeCollapseQuadricParameter parameters = dialogDefaults();
	vcg::LocalOptimization<CollapseMesh>      session(mesh, &parameters);
	session.Init<Collapse>();
	session.SetTargetSimplices(int(faceNum));
	session.SetTimeBudget(0.1f);
	bool stopped = shallStop();
	while (!stopped && session.DoOptimization() && mesh.fn > faceNum)
		stopped = shallStop();
	session.Finalize<Collapse>();
	QuadricHelper::quadrics() = nullptr;
	return !stopped;
}

void cleanUp(CollapseMesh& mesh)
{
	using Clean     = vcg::tri::Clean<CollapseMesh>;
	using Allocator = vcg::tri::Allocator<CollapseMesh>;
	Clean::RemoveFaceOutOfRangeArea(mesh, 0);
	Clean::RemoveDuplicateVertex(mesh);
	Clean::RemoveUnreferencedVertex(mesh);
	Allocator::CompactVertexVector(mesh);
	Allocator::CompactFaceVector(mesh);
}

} // namespace

struct QuadricCollapse::Work {
	CollapseMesh mesh;
};

QuadricCollapse::QuadricCollapse(const MeshView& mesh) : work_(std::make_unique<Work>())
{
	fillBaselineMesh(mesh, work_->mesh);
}

QuadricCollapse::~QuadricCollapse() = default;

bool QuadricCollapse::run(std::int64_t faceNum, const std::function<bool()>& shallStop)
{
	CollapseMesh& mesh = work_->mesh;
	vcg::tri::UpdateTopology<CollapseMesh>::VertexFace(mesh);
	vcg::tri::UpdateFlags<CollapseMesh>::FaceBorderFromVF(mesh);
	if (!collapse(mesh, faceNum, shallStop)) return false;
	cleanUp(mesh);
	return true;
}

TriangleMesh QuadricCollapse::mesh() const
{
	return arraysOfBaselineMesh(work_->mesh);
}

} // namespace gpr::baselines
