// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fused_mesh.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <numeric>
#include <unordered_set>

namespace gpr {

namespace {

/// A border sample closer to an end of its segment than this share of the segment becomes the end.
constexpr float sameAsEnd = 1e-5f;

/// Fuses the samples of a curve, in the order of their arcs.
class CurveFuser {
public:
	CurveFuser(const Curve& curve, std::unordered_set<int>& taken, FusedMesh& fused) :
			curve_(curve), taken_(taken), fused_(fused)
	{
	}

	int fuse(const CurveSample& sample)
	{
		const int segment = curve_.segmentAt(sample.arc);
		if (segment != segment_) behind_ = curve_.vertex[segment];
		segment_    = segment;
		const int v = vertexAt(sample.point.position);
		taken_.insert(v);
		return v;
	}

private:
	const Curve&             curve_;
	std::unordered_set<int>& taken_; ///< vertices of the samples of all curves
	FusedMesh&               fused_;
	int                      segment_ = -1;
	int                      behind_  = -1; ///< last vertex of the segment before the next sample

	int vertexAt(const Vec3f& place)
	{
		const HalfEdgeMesh& m     = fused_.mesh;
		const int           ahead = curve_.vertex[(segment_ + 1) % curve_.pointNum()];
		const Vec3f         a = m.position[behind_], b = m.position[ahead];
		const float         near = sameAsEnd * length(b - a);
		if (length(place - a) <= near && taken_.count(behind_) == 0) return behind_;
		if (length(place - b) <= near && taken_.count(ahead) == 0) return ahead;
		behind_ = splitAt(fused_, m.findHalfEdge(behind_, ahead), place);
		return behind_;
	}
};

/// Adds a vertex in no face yet, and reserves memory for its split.
int addVertex(FusedMesh& fused, const Vec3f& place)
{
	HalfEdgeMesh& m = fused.mesh;
	const bool    isFull =
		m.position.size() == std::size_t(m.vertexNum) ||
		std::min(m.origin.size() / 3, fused.parentFace.size()) < std::size_t(m.faceNum) + 2;
	if (isFull) makeRoom(fused, m.vertexNum / 4 + 64);
	m.position[m.vertexNum] = place;
	return m.vertexNum++;
}

} // namespace

FusedMesh beginFusion(const Surface& surface, Workers& workers)
{
	FusedMesh fused;
	fused.mesh = copyMesh(surface.mesh, workers);
	fused.parentFace.reset(surface.mesh.faceNum);
	std::iota(fused.parentFace.begin(), fused.parentFace.end(), 0);
	return fused;
}

void makeRoom(FusedMesh& fused, int moreVertices)
{
	HalfEdgeMesh& m        = fused.mesh;
	const int     faceRoom = m.faceNum + 2 * moreVertices;
	reserve(m, m.vertexNum + moreVertices, faceRoom);
	if (fused.parentFace.size() < std::size_t(faceRoom)) fused.parentFace.resize(faceRoom);
}

int splitAt(FusedMesh& fused, int h, const Vec3f& place)
{
	HalfEdgeMesh& m     = fused.mesh;
	const int     v     = addVertex(fused, place);
	const int     g     = m.opposite[h];
	const int     first = m.faceNum;
	if (g < 0) {
		splitBorderEdge(m, h, v);
	}
	else {
		splitEdge(m, h, v);
		fused.parentFace[first + 1] = fused.parentFace[g / 3];
	}
	fused.parentFace[first] = fused.parentFace[h / 3];
	return v;
}

int splitFaceAt(FusedMesh& fused, int f, const Vec3f& place)
{
	const int v     = addVertex(fused, place);
	const int first = fused.mesh.faceNum;
	splitFace(fused.mesh, f, v);
	fused.parentFace[first] = fused.parentFace[first + 1] = fused.parentFace[f];
	return v;
}

void fuseBoundary(const BoundaryCurves& boundary, FusedMesh& fused)
{
	std::unordered_set<int> taken;
	std::vector<CurveFuser> fusers;
	fusers.reserve(boundary.curves.size());
	for (const Curve& curve : boundary.curves)
		fusers.emplace_back(curve, taken, fused);
	for (const CurveSample& sample : boundary.samples) {
		const bool isConeApex = sample.curve < 0;
		fused.sampleVertex.push_back(isConeApex ? sample.vertex
												: fusers[sample.curve].fuse(sample));
	}
}

} // namespace gpr
