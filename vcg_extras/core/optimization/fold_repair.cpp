// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fold_repair.h"

#include "constraint.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gpr {

namespace {

constexpr int mostRounds = 12;
/// A face that agrees less with the surface than this costs.
constexpr float wantedAgreement = 0.3f;
/// A face that agrees less than this is mended.
constexpr float badAgreement = 0.05f;
/// Poor shapes cost a little, so that one fold is not bought with a needle.
constexpr float wantedShape = 0.35f;
/// Cost of a face without area: more than that of any two others, as no result may have one.
constexpr float noArea = 8;
/// A change must lower the cost by this.
constexpr float leastGain = 0.01f;

/// Faces that a trial move may cross; longer ways, among needles, are not worth their time.
constexpr int mostCrossings = 256;

constexpr float reaches[] = {0.6f, 0.3f, 0.1f}; ///< of the ideal edge

class FoldMender {
public:
	FoldMender(const Surface& surface, const BoundaryCurves& boundary, bool mayCollapse,
			   ResultMesh& result, Workers& workers) :
			surface_(surface),
			boundary_(boundary), mayCollapse_(mayCollapse), r_(result), m_(result.mesh),
			workers_(workers), normal_(smoothNormals(surface, result, workers))
	{
	}

	int run()
	{
		std::vector<int> bad = findBad(); // of all faces
		std::vector<int> due = bad;       // of those where something changed
		for (int round = 0; round < mostRounds && !due.empty(); ++round) {
			mayMove_ = bad.size() <= std::max<std::size_t>(500, std::size_t(m_.faceNum) / 50);
			touched_.clear();
			for (int f : due) {
				workers_.poll();
				if (isBad(f)) mend(f);
			}
			// What could not be mended is only tried again where something changed.
			due = badOnes(facesRound(m_, touched_));
			bad = badOnes(bad);
			bad.insert(bad.end(), due.begin(), due.end());
			sortUnique(bad);
		}
		if (mayCollapse_) compactResult(r_, workers_);
		return int(bad.size());
	}

private:
	/// One of the changes tried, and what it would do to the cost.
	struct Change {
		enum Kind { None, Flip, Move, Collapse } kind = None;
		float  gain                                   = leastGain;
		int    halfEdge                               = -1;
		int    vertex                                 = -1;
		Anchor place;
		float  arc = 0; ///< of a border vertex that moves
	};

	const Surface&        surface_;
	const BoundaryCurves& boundary_;
	bool                  mayCollapse_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	EditScratch           scratch_;
	/// Trial moves cost most. Where more than single faces look wrong the triangles are hopelessly
	/// large for the surface, and moving vertices one by one mends nothing.
	bool             mayMove_  = true;
	bool             mayCrowd_ = false; ///< on curves, to part what lies at one place
	Buffer<Vec3f>    normal_;           ///< smooth normals of the vertices
	std::vector<int> touched_;          ///< vertices whose ring a change of this round altered

	void touch(int v)
	{
		touched_.push_back(v);
		forEachNeighbour(m_, v, [&](int w) { touched_.push_back(w); });
	}

	bool isBad(int f) const
	{
		return !isDeadFace(m_, f) && (faceAgreement(m_, normal_, f) < badAgreement || hasNoArea(f));
	}

	bool hasNoArea(int f) const
	{
		const int* corner = &m_.origin[3 * f];
		return isLine(m_.position[corner[0]], m_.position[corner[1]], m_.position[corner[2]],
					  m_.faceCross(f));
	}

	std::vector<int> findBad()
	{
		return workers_.collect<int>(m_.faceNum,
									 [&](std::size_t begin, std::size_t end, auto& out) {
										 for (int f = int(begin); f < int(end); ++f) {
											 if (isBad(f)) out.push_back(f);
										 }
									 });
	}

	std::vector<int> badOnes(const std::vector<int>& faces) const
	{
		std::vector<int> bad;
		std::copy_if(faces.begin(), faces.end(), std::back_inserter(bad),
					 [&](int f) { return isBad(f); });
		return bad;
	}

	/// A corner of a face under consideration: where it is and what the surface looks like there.
	struct Corner {
		Vec3f place;
		Vec3f normal;
	};

	Corner cornerOf(int v) const { return {m_.position[v], normal_[v]}; }

	float costOf(const Corner& a, const Corner& b, const Corner& c) const
	{
		const Vec3f n = cross(b.place - a.place, c.place - a.place);
		if (isLine(a.place, b.place, c.place, n)) return noArea;
		const Vec3f wanted = a.normal + b.normal + c.normal;
		const float shape  = triangleShape(a.place, b.place, c.place);
		const float off    = std::max(0.0f, wantedAgreement - agreement(n, wanted));
		return off * off + 0.2f * std::max(0.0f, wantedShape - shape);
	}

	/// Cost of v's ring with v as given, leaving out faces with `other`.
	float ringCost(int v, const Corner& at, int other) const
	{
		float sum = 0;
		forEachOutgoing(m_, v, [&](int h) {
			const int a = m_.target(h), b = m_.apex(h);
			if (a != other && b != other) sum += costOf(at, cornerOf(a), cornerOf(b));
		});
		return sum;
	}

	void mend(int f)
	{
		Change best = bestChange(f);
		if (best.kind == Change::None && !mayCollapse_ && hasNoArea(f)) {
			forgetLinesAt(f);
			mayCrowd_ = true;
			best      = bestChange(f);
			mayCrowd_ = false;
		}
		apply(best);
	}

	Change bestChange(int f)
	{
		Change best;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			tryFlip(h, best);
			tryMove(m_.origin[h], best);
			if (!mayCollapse_) continue;
			tryCollapse(h, best);
			if (m_.opposite[h] >= 0) tryCollapse(m_.opposite[h], best);
		}
		return best;
	}

	/// Feature lines side by side on one straight line, as where a surface is folded flat, can hold
	/// all edges of a face without area. A gap in a line is better than such a face.
	void forgetLinesAt(int f)
	{
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			if (m_.isCreaseEdge(h)) m_.crease[h] = m_.crease[m_.opposite[h]] = 0;
		}
	}

	void tryFlip(int h, Change& best) const
	{
		const int g = m_.opposite[h];
		if (g < 0 || !canFlip(m_, h)) return;
		const Corner a = cornerOf(m_.origin[h]), b = cornerOf(m_.target(h));
		const Corner c = cornerOf(m_.apex(h)), d = cornerOf(m_.apex(g));
		const float  gain = costOf(a, b, c) + costOf(b, a, d) - costOf(a, d, c) - costOf(b, c, d);
		if (gain <= best.gain) return;
		best.kind     = Change::Flip;
		best.gain     = gain;
		best.halfEdge = h;
	}

	void tryMove(int v, Change& best) const
	{
		if (m_.isCurveVertex(v)) {
			trySlide(v, best);
			return;
		}
		if (!mayMove_ || r_.vertex[v].isCorner) return;
		const ResultVertex& here       = r_.vertex[v];
		const float         now        = ringCost(v, cornerOf(v), -1);
		const auto          directions = compassDirections(here.normal);
		for (float reach : reaches) {
			for (const Vec3f& direction : directions) {
				Anchor      at   = here.anchor;
				const Vec3f step = direction * (reach * r_.idealEdge);
				if (walk(surface_.mesh, at, step, mostCrossings) != WalkEnd::Arrived) continue;
				offerMove(v, now, at, here.arc, best);
			}
		}
	}

	/// Takes the move of v, whose ring costs `now`, as the best change if it gains more.
	void offerMove(int v, float now, const Anchor& at, float arc, Change& best) const
	{
		const float gain = now - ringCost(v, {at.position, smoothNormal(surface_, at)}, -1);
		if (gain <= best.gain) return;
		best.kind   = Change::Move;
		best.gain   = gain;
		best.vertex = v;
		best.place  = at;
		best.arc    = arc;
	}

	void trySlide(int v, Change& best) const
	{
		const ResultVertex& here = r_.vertex[v];
		if (here.curve < 0) return;
		const float     now  = ringCost(v, cornerOf(v), -1);
		const SlideRoom room = slideRoom(r_, boundary_, v);
		for (bool forward : {false, true}) {
			for (float share : {0.1f, 0.25f, 0.5f, 0.75f}) {
				const float step = (forward ? room.forward : -room.backward) * share;
				if (!mayCrowd_ && !slideKeepsSpacing(r_, boundary_, v, room, step)) continue;
				const ResultVertex to = slid(surface_, boundary_, here, step);
				offerMove(v, now, to.anchor, to.arc, best);
			}
		}
	}

	void tryCollapse(int h, Change& best)
	{
		const int a = m_.origin[h], b = m_.target(h);
		if (!isFree(r_, a) || !canCollapse(m_, h, scratch_)) return;
		const float gain = ringCost(a, cornerOf(a), -1) - ringCost(a, cornerOf(b), b);
		// A vertex less has to be worth it.
		if (gain - 2 * leastGain <= best.gain) return;
		best.kind     = Change::Collapse;
		best.gain     = gain - 2 * leastGain;
		best.halfEdge = h;
	}

	void apply(const Change& change)
	{
		switch (change.kind) {
		case Change::None:
			return;
		case Change::Flip:
			touch(m_.apex(change.halfEdge));
			touch(m_.apex(m_.opposite[change.halfEdge]));
			flip(m_, change.halfEdge);
			++r_.flipNum;
			return;
		case Change::Move:
			r_.vertex[change.vertex].anchor = change.place;
			r_.vertex[change.vertex].normal = surface_.mesh.faceNormal(change.place.face);
			r_.vertex[change.vertex].arc    = change.arc;
			m_.position[change.vertex]      = change.place.position;
			normal_[change.vertex]          = smoothNormal(surface_, change.place);
			touch(change.vertex);
			return;
		case Change::Collapse:
			touch(m_.origin[change.halfEdge]);
			collapse(m_, change.halfEdge);
			++r_.collapseNum;
			return;
		}
	}
};

} // namespace

int mendFolds(const Surface& surface, const BoundaryCurves& boundary, bool mayCollapse,
			  ResultMesh& result, Workers& workers)
{
	return FoldMender(surface, boundary, mayCollapse, result, workers).run();
}

} // namespace gpr
