// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "guarded_relaxation.h"

#include "contact_guard.h"
#include "distance_guard.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/edit/acceptance.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>

namespace gpr {

namespace {

/// Rounds of flips and slides; more rounds gain little.
constexpr int roundNum = 12;
/// Most halvings of a slide before giving up.
constexpr int halvingNum = 3;
/// Weight of the barycentre relative to the planes.
constexpr double barycentreWeight = 0.1;
/// Cosine between two faces of a crease edge.
constexpr float sharpCosine = 0.766f;
/// Shape of needles.
constexpr float needleShape = 0.01f;
/// Least gain of a change in shape, so that no change is made and undone for ever.
constexpr float leastGain = 1.001f;

class Relaxation {
public:
	Relaxation(double idealEdge, GuardedMesh& guarded, Workers& workers) :
			farthest_(double(limits_.distance) * idealEdge), g_(guarded), m_(guarded.mesh),
			workers_(workers), guard_(m_, g_.hadContacts, workers),
			distances_(g_, farthest_, workers)
	{
	}

	void run(bool mayMove)
	{
		for (int round = 0; round < roundNum; ++round) {
			workers_.poll(double(round) / roundNum);
			for (int h = 0; h < m_.halfEdgeNum(); ++h) {
				if (h < m_.opposite[h]) tryToFlip(h);
			}
			for (int v = 0; v < m_.vertexNum; ++v) {
				if (mayMove && isFree(v)) slide(v);
			}
		}
	}

private:
	/// agreement: with the assigned normals. distance: most distance of a vertex from its assigned
	/// planes, unless the distance was larger before, and of a flipped edge from the old edge.
	const Acceptance           limits_ = acceptanceOf(Driver::GuardedRelaxation);
	double                     farthest_; ///< working units
	GuardedMesh&               g_;
	HalfEdgeMesh&              m_;
	Workers&                   workers_;
	ContactGuard               guard_;
	DistanceGuard              distances_;
	std::vector<int>           gone_;
	std::vector<NamedTriangle> made_;

	bool isFixed(int v) const { return g_.isFixed(v); }

	bool isFree(int v) const { return m_.outgoing[v] >= 0 && !isFixed(v) && !m_.isBorderVertex(v); }

	NamedTriangle triangleBetween(int a, int b, int c) const
	{
		return {{a, b, c}, {m_.position[a], m_.position[b], m_.position[c]}};
	}

	/// Whether the triangles of made_ may replace gone_.
	bool isAllowed() { return distances_.allows(made_, gone_) && guard_.allows(made_, gone_); }

	void follow()
	{
		guard_.follow(gone_);
		distances_.follow(gone_);
	}

	// ---- flips

	void tryToFlip(int h)
	{
		const int g = m_.opposite[h];
		if (g_.isFixedFace(h / 3) || g_.isFixedFace(g / 3) || !canFlip(m_, h)) return;
		const int           a = m_.origin[h], b = m_.target(h), c = m_.apex(h), d = m_.apex(g);
		const NamedTriangle old[2] = {triangleBetween(a, b, c), triangleBetween(b, a, d)};
		made_                      = {triangleBetween(a, d, c), triangleBetween(b, c, d)};
		gone_                      = {h / 3, g / 3};
		if (!isFlipBetter(old) || !isAllowed()) return;
		flip(m_, h);
		follow();
	}

	bool isFlipBetter(const NamedTriangle* old) const
	{
		const float before = std::min(old[0].shape(), old[1].shape());
		const float after  = std::min(made_[0].shape(), made_[1].shape());
		if (!(after > leastGain * before)) return false;
		const Vec3f o[2] = {old[0].cross(), old[1].cross()};
		const Vec3f n[2] = {made_[0].cross(), made_[1].cross()};
		const Vec3d a(old[0].at[0]), b(old[0].at[1]), c(old[0].at[2]), d(old[1].at[2]);
		if (lineDistance(a, b, c, d) > farthest_) return false;
		const float bend = agreement(o[0], o[1]), newBend = agreement(n[0], n[1]);
		// The normal of a needle says nothing.
		const bool isNeedle = before < needleShape;
		if (newBend < sharpCosine && newBend < bend && !isNeedle) return false;
		if (bend < sharpCosine && newBend < limits_.turn && !isNeedle) return false;
		const Vec3f mean = o[0] + o[1];
		return agreement(n[0], mean) > limits_.turn && agreement(n[1], mean) > limits_.turn &&
			   g_.agrees(made_[0].vertex, n[0], limits_.agreement) &&
			   g_.agrees(made_[1].vertex, n[1], limits_.agreement);
	}

	// ---- slides

	void slide(int v)
	{
		gone_.clear();
		forEachOutgoing(m_, v, [&](int h) { gone_.push_back(h / 3); });
		const Vec3d from(m_.position[v]), to = m_.keptOnMirror(v, goalOf(v));
		made_.clear();
		for (int f : gone_)
			made_.push_back(triangleOf(m_, f));
		const float before = energyOfMade();
		double      share  = 1;
		for (int i = 0; i <= halvingNum; ++i, share /= 2) {
			const Vec3f place(from + (to - from) * share);
			if (isFarther(v, Vec3d(place)) || !makeTriangles(v, place) ||
				!(leastGain * energyOfMade() < before))
				continue;
			if (!isAllowed()) continue;
			m_.position[v] = place;
			follow();
			return;
		}
	}

	/// Whether a place is farther off by the quadrics, which are weighted by area.
	bool isFarther(int v, const Vec3d& place) const
	{
		const GuardedVertex& vertex = g_.vertex[v];
		const double         there  = vertex.quadric.at(place);
		return there > farthest_ * farthest_ * double(vertex.area) &&
			   there > vertex.quadric.at(Vec3d(m_.position[v]));
	}

	Vec3d goalOf(int v) const
	{
		Vec3d  sum;
		double area = 0;
		for (int f : gone_) {
			const double here = double(length(m_.faceCross(f)));
			sum += Vec3d(m_.faceCentre(f)) * here;
			area += here;
		}
		const Vec3d barycentre = area > 0 ? sum * (1 / area) : Vec3d(m_.position[v]);
		Quadric     q          = g_.vertex[v].quadric;
		q.addPoint(barycentre, barycentreWeight * q.trace());
		return q.lowest(Vec3d(m_.position[v]));
	}

	/// The conformal energy of a triangle: least for equilateral triangles.
	static float energyOf(const NamedTriangle& t) { return 1 / (t.shape() + 1e-6f); }

	float energyOfMade() const
	{
		float sum = 0;
		for (const NamedTriangle& t : made_)
			sum += energyOf(t);
		return sum;
	}

	bool makeTriangles(int v, const Vec3f& place)
	{
		made_.clear();
		for (int f : gone_) {
			NamedTriangle t   = triangleOf(m_, f);
			const Vec3f   old = t.cross();
			for (int k = 0; k < 3; ++k) {
				if (t.vertex[k] == v) t.at[k] = place;
			}
			const Vec3f normal = t.cross();
			if (t.isLine()) return false;
			if (agreement(normal, old) < limits_.turn) return false;
			if (!g_.agrees(t.vertex, normal, limits_.agreement) &&
				g_.agrees(t.vertex, old, limits_.agreement))
				return false;
			made_.push_back(t);
		}
		return true;
	}
};

} // namespace

void relaxGuarded(double idealEdge, bool mayMove, GuardedMesh& guarded, Workers& workers)
{
	Relaxation(idealEdge, guarded, workers).run(mayMove);
}

} // namespace gpr
