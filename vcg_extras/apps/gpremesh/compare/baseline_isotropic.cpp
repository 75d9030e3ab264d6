// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Isotropic explicit remeshing as in MeshLab. Source of the parameters and of the order of the
// steps: MeshLab 2020.09, filter_meshing (FP_EXPLICIT_ISOTROPIC_REMESHING).
#include "baseline_remeshers.h"

#include <vcg_extras/complex/baselines/baseline_mesh.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/base/stopwatch.h>

// vcglib's headers need complex.h first.
// clang-format off
#include <vcg/complex/append.h>
#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>
#include <vcg/complex/algorithms/isotropic_remeshing.h>
// clang-format on

namespace gpr::app {

namespace {

class IsotropicVertex;
class IsotropicFace;
struct IsotropicTypes : public vcg::UsedTypes<vcg::Use<IsotropicVertex>::AsVertexType,
											  vcg::Use<IsotropicFace>::AsFaceType> {};
class IsotropicVertex
		: public vcg::Vertex<IsotropicTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
							 vcg::vertex::Qualityf, vcg::vertex::Color4b, vcg::vertex::VFAdj,
							 vcg::vertex::Mark, vcg::vertex::BitFlags> {};
class IsotropicFace : public vcg::Face<IsotropicTypes, vcg::face::VertexRef, vcg::face::Normal3f,
									   vcg::face::Qualityf, vcg::face::FFAdj, vcg::face::VFAdj,
									   vcg::face::Mark, vcg::face::BitFlags> {};
class IsotropicMesh
		: public vcg::tri::TriMesh<std::vector<IsotropicVertex>, std::vector<IsotropicFace>> {};

using Remeshing = vcg::tri::IsotropicRemeshing<IsotropicMesh>;

Remeshing::Params dialogDefaults(double edgeLen, double diagonal)
{
	Remeshing::Params p;
	p.SetTargetLen(float(edgeLen));
	p.SetFeatureAngleDeg(30);
	p.maxSurfDist   = float(0.01 * diagonal);
	p.iter          = 3;
	p.adapt         = false;
	p.selectedOnly  = false;
	p.surfDistCheck = true;
	return p;
}

void remeshBaseline(IsotropicMesh& mesh, double edgeLen)
{
	using Clean = vcg::tri::Clean<IsotropicMesh>;
	Clean::RemoveDuplicateVertex(mesh);
	Clean::RemoveUnreferencedVertex(mesh);
	vcg::tri::Allocator<IsotropicMesh>::CompactEveryVector(mesh);
	vcg::tri::UpdateBounding<IsotropicMesh>::Box(mesh);
	vcg::tri::UpdateNormal<IsotropicMesh>::PerVertexNormalizedPerFaceNormalized(mesh);

	IsotropicMesh surface;
	vcg::tri::Append<IsotropicMesh, IsotropicMesh>::MeshCopy(surface, mesh);
	Remeshing::Params parameters = dialogDefaults(edgeLen, double(mesh.bbox.Diag()));
	Remeshing::Do(mesh, surface, parameters);
	vcg::tri::Allocator<IsotropicMesh>::CompactEveryVector(mesh);
}

} // namespace

BaselineResult remeshIsotropically(const MeshView& mesh, double edgeLen)
{
	BaselineResult result;
	IsotropicMesh  work;
	baselines::fillBaselineMesh(mesh, work);
	const Stopwatch clock;
	const double    processorBefore = processorSeconds();
	try {
		remeshBaseline(work, edgeLen);
	}
	catch (const std::runtime_error& error) { // vcglib's exceptions for unsuitable meshes
		result.failure = std::string("Isotropic remeshing failed: ") + error.what();
		return result;
	}
	result.seconds          = clock.seconds();
	result.processorSeconds = processorSeconds() - processorBefore;
	result.mesh             = baselines::arraysOfBaselineMesh(work);
	if (work.face.empty()) result.failure = "Isotropic remeshing left no face.";
	return result;
}

} // namespace gpr::app
