// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fused_mesh.h"

#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <numeric>
#include <unordered_set>

namespace gpr {

namespace {

/// A border sample closer to an end of its segment than this share of the segment becomes the end.
constexpr float sameAsEnd = 1e-5f;
/// Weights of a face's corners below this count as 0; so do shares of an edge this close to 0 or 1.
constexpr double onEdge = 1e-3;
/// Points nearer than this are the same: a few steps of a float of magnitude one.
constexpr float samePlace = 4e-6f;
/// The most parts of a surface face that the search for a sample crosses.
constexpr int maxFacesCrossedInFace = 1000;

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

/// Splits face f in three at a place inside. Returns the new vertex, the last of the mesh.
int splitFaceAt(FusedMesh& fused, int f, const Vec3f& place)
{
	const int v     = addVertex(fused, place);
	const int first = fused.mesh.faceNum;
	splitFace(fused.mesh, f, v);
	fused.parentFace[first] = fused.parentFace[first + 1] = fused.parentFace[f];
	return v;
}

/// Fuses samples anywhere on the surface, in turn.
class Fuser {
public:
	explicit Fuser(FusedMesh& fused) :
			fused_(fused), m_(fused.mesh), taken_(fused.mesh.position.size(), 0)
	{
		for (int v : fused.sampleVertex) {
			if (v >= 0) taken_[v] = 1;
		}
	}

	/// Fuses a sample. mayBeBorder: whether the sample may become a vertex of the border. If not, a
	/// sample on the border gets no vertex.
	void fuse(int sample, const SurfacePoint& at, bool mayBeBorder)
	{
		const Place place = locate(at);
		const auto  least = std::min_element(place.weight, place.weight + 3) - place.weight;
		const int   edge  = nextInFace(3 * place.face + int(least)); // opposite that corner
		for (int k = 0; k < 3; ++k) {
			const int v = m_.origin[3 * place.face + k];
			if (place.weight[(k + 1) % 3] >= onEdge || place.weight[(k + 2) % 3] >= onEdge)
				continue;
			if (!mayBeBorder && m_.isBorderVertex(v)) return;
			if (settleOn(sample, v, at.position)) return;
		}
		if (place.weight[least] >= onEdge)
			take(sample, splitFaceAt(fused_, place.face, at.position));
		else if (mayBeBorder || !m_.isBorderEdge(edge))
			take(sample, splitAt(fused_, edge, at.position));
	}

private:
	/// A face and the weights of its corners at a point.
	struct Place {
		int    face;
		double weight[3];
	};

	FusedMesh&        fused_;
	HalfEdgeMesh&     m_;
	std::vector<char> taken_; ///< per vertex: is a sample

	/// Makes v the vertex of the sample and returns true. Also true if v has another sample at the
	/// same place; then this sample gets no vertex. False: v is taken.
	bool settleOn(int sample, int v, const Vec3f& p)
	{
		if (taken_[v]) return length(m_.position[v] - p) < samePlace;
		take(sample, v);
		m_.position[v] = p;
		return true;
	}

	void take(int sample, int v)
	{
		taken_[v]                   = 1;
		fused_.sampleVertex[sample] = v;
	}

	/// Walks over the parts of the surface face of the point to the part that holds the point.
	Place locate(const SurfacePoint& at) const
	{
		Place place = weigh(at.face, at.position);
		for (int crossed = 0; crossed < maxFacesCrossedInFace; ++crossed) {
			const auto least = std::min_element(place.weight, place.weight + 3);
			if (*least >= 0) return place;
			const int beyond = m_.opposite[nextInFace(3 * place.face + int(least - place.weight))];
			if (beyond < 0 || fused_.parentFace[beyond / 3] != at.face) return place;
			place = weigh(beyond / 3, at.position);
		}
		return place;
	}

	/// Weights of the corners with sum 1; a degenerate face gives its nearest corner the whole
	/// weight.
	Place weigh(int face, const Vec3f& at) const
	{
		Place       place = {face, {0, 0, 0}};
		const Vec3d p(at);
		Vec3d       corner[3];
		for (int k = 0; k < 3; ++k)
			corner[k] = Vec3d(m_.position[m_.origin[3 * face + k]]);
		const Vec3d  normal  = cross(corner[1] - corner[0], corner[2] - corner[0]);
		const double squared = squaredLength(normal);
		if (!(squared > 0)) {
			const auto isNearer = [&](const Vec3d& a, const Vec3d& b) {
				return squaredLength(a - p) < squaredLength(b - p);
			};
			place.weight[std::min_element(corner, corner + 3, isNearer) - corner] = 1;
			return place;
		}
		for (int k = 0; k < 3; ++k) {
			const Vec3d& a  = corner[(k + 1) % 3];
			const Vec3d& b  = corner[(k + 2) % 3];
			place.weight[k] = dot(cross(b - a, p - a), normal) / squared;
		}
		return place;
	}
};

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

FusedMesh fuseSamples(const Surface& surface, const Sampling& sampling,
					  const BoundaryCurves& boundary, Workers& workers)
{
	FusedMesh fused     = beginFusion(surface, workers);
	const int sampleNum = int(sampling.samples.size());
	makeRoom(fused, sampleNum);
	fuseBoundary(boundary, fused);
	const int first = int(fused.sampleVertex.size());
	fused.sampleVertex.resize(sampleNum, -1);
	Fuser fuser(fused);
	for (int s = first; s < sampleNum; ++s) {
		if (s % 65536 == 0) workers.poll(double(s) / sampleNum);
		fuser.fuse(s, sampling.samples[s].point, boundary.samples.empty());
	}
	return fused;
}

} // namespace gpr
