// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "guarded_decimation.h"

#include "contact_guard.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/space_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace gpr {

namespace {

/// Limits on the faces that a collapse makes.
struct Bounds {
	float shape;     ///< triangleShape, or as before
	float turn;      ///< cosine between the normals before and after
	float agreement; ///< cosine between a face and the normals assigned to its vertices
	float distance;  ///< root mean square distance from the planes assigned to a vertex, in edges
};

/// From strict to loose; each next row applies when the row before allows no more collapses.
constexpr std::array<Bounds, 8> boundsOfRounds = {{{0.35f, 0.5f, 0.2f, 0.02f},
												   {0.2f, 0.5f, 0.2f, 0.05f},
												   {0.05f, 0.1f, 0.2f, 0.05f},
												   {0.2f, 0.5f, 0.2f, 0.15f},
												   {0.05f, 0.1f, 0.1f, 0.15f},
												   {0.1f, 0.5f, 0.2f, 0.4f},
												   {0.03f, 0.1f, 0.05f, 0.4f},
												   {0.01f, 0.02f, 0, HUGE_VALF}}};

/// The rows of collapseStrictly.
constexpr std::size_t strictRounds = 2;

/// So few vertices hardly ever make a shape close to the surface: at last only topology and
/// contacts count.
constexpr std::int64_t mostOfAnyShape = 64;
constexpr Bounds       anyShape       = {0, -2, -2, HUGE_VALF};

/// Normals that cancel out to less than this share say nothing: normals round a thin rim.
constexpr float leastSpread = 0.25f;
/// Weight of the middle of an edge, for planes that leave a choice.
constexpr double middleWeight = 1e-3;
/// A pass is the last with its bounds if it collapses less than a share 1/leastShare of the
/// vertices.
constexpr std::int64_t leastShare = 30;

/// An edge that may be collapsed: the cost, and the state of its ends at that time.
struct Candidate {
	float    cost;
	int      a, b;
	unsigned stampA, stampB;

	/// The queue has the largest element first.
	bool operator<(const Candidate& o) const
	{
		if (cost != o.cost) return cost > o.cost;
		return a != o.a ? a > o.a : b > o.b;
	}
};

/// The ends of a collapse: `from` goes, `to` stays.
struct Merge {
	int  from = -1, to = -1;
	bool isAlongBorder = false;
	bool mayMove       = false; ///< `to` may move
	bool endsFlat      = false; ///< the collapse removes a degenerate face
};

/// The possible places of a merged vertex, the best first.
struct Places {
	std::array<std::pair<double, Vec3f>, 4> at;
	int                                     num = 0;

	void add(const Quadric& q, const Vec3d& p)
	{
		const Vec3f rounded(p);
		at[num++] = {q.at(Vec3d(rounded)), rounded};
	}
	void sort()
	{
		std::stable_sort(at.begin(), at.begin() + num,
						 [](const auto& a, const auto& b) { return a.first < b.first; });
	}
};

class Decimation {
public:
	Decimation(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers) :
			settings_(settings), g_(guarded), m_(guarded.mesh), workers_(workers),
			guard_(m_, g_.hadContacts, workers), livingNum_(m_.vertexNum), firstNum_(livingNum_),
			hasFlat_(zeroAreaFaceNum(m_, workers) > 0), stamp_(std::size_t(m_.vertexNum), 0)
	{
	}

	bool run()
	{
		borderNum_ = numberToGo();
		runRounds(boundsOfRounds.size());
		while (collapseAll() > 0) {}
		if (settings_.targetNum <= mostOfAnyShape) {
			bounds_ = anyShape;
			while (collapseAll() > 0) {}
		}
		removeFromBorder();
		return livingNum_ <= settings_.targetNum;
	}

	void runRounds(std::size_t num)
	{
		for (std::size_t round = 0; round < num; ++round) {
			bounds_ = boundsOfRounds[round];
			while (collapseAll() > livingNum_ / leastShare) {}
		}
	}

private:
	const GuardedSettings& settings_;
	GuardedMesh&           g_;
	HalfEdgeMesh&          m_;
	Workers&               workers_;
	ContactGuard           guard_;
	std::int64_t           livingNum_; ///< vertices now
	std::int64_t           firstNum_;
	std::int64_t           borderNum_ = 0;     ///< vertices to remove from a kept border
	bool                   isForced_  = false; ///< remove only these vertices, even with contacts
	/// The first mesh had degenerate faces. A result must not have such faces, so these go first.
	bool                           hasFlat_;
	std::vector<unsigned>          stamp_; ///< per vertex: number of its changes
	std::priority_queue<Candidate> queue_;
	Bounds                         bounds_{};
	EditScratch                    scratch_;
	std::vector<int>               gone_;
	float                          leastShape_ = 0; ///< least shape of the new faces
	std::vector<NamedTriangle>     made_;

	// ---- the queue

	/// One pass over all edges. Returns the number of collapses.
	std::int64_t collapseAll()
	{
		const std::int64_t before = livingNum_;
		if (!mayGoOn()) return 0;
		queueAll();
		for (int calls = 0; !queue_.empty() && mayGoOn();) {
			const Candidate c = queue_.top();
			queue_.pop();
			if (stamp_[c.a] != c.stampA || stamp_[c.b] != c.stampB) continue;
			// A collapse is slow in a large patch, where a vertex has many points.
			if (++calls % 64 == 0) workers_.poll(share());
			tryToCollapse(c.a, c.b);
		}
		queue_ = {};
		return before - livingNum_;
	}

	/// Each vertex to remove from the border counts as removed: its turn comes at last.
	bool mayGoOn() const { return livingNum_ > settings_.targetNum + (isForced_ ? 0 : borderNum_); }

	std::int64_t numberToGo() const
	{
		std::int64_t num = 0;
		for (int v = 0; settings_.keepsBorder && v < m_.vertexNum; ++v)
			num += m_.outgoing[v] >= 0 && !isFixed(v) && m_.isBorderVertex(v);
		return num;
	}

	/// A kept border counts more than contacts.
	void removeFromBorder()
	{
		isForced_ = true;
		bounds_   = anyShape;
		while (borderNum_ > 0 && collapseAll() > 0) {}
	}

	double share() const
	{
		return double(firstNum_ - livingNum_) / double(firstNum_ - settings_.targetNum);
	}

	void queueAll()
	{
		std::vector<Candidate> all =
			workers_.collectEach<Candidate>(std::size_t(m_.halfEdgeNum()), [&](int h, auto& out) {
				if (isDeadFace(m_, h / 3) || m_.opposite[h] > h) return;
				Candidate c;
				if (isWorthTrying(m_.origin[h], m_.target(h), c)) out.push_back(c);
			});
		queue_ = std::priority_queue<Candidate>(std::less<Candidate>(), std::move(all));
	}

	void queueRound(int v)
	{
		forEachNeighbour(m_, v, [&](int w) {
			Candidate c;
			if (isWorthTrying(v, w, c)) queue_.push(c);
		});
	}

	bool isWorthTrying(int v, int w, Candidate& c) const
	{
		const Merge merge = mergeOf(v, w);
		if (merge.from < 0 || (isForced_ && !hasToGo(merge))) return false;
		const double squared = squaredLength(Vec3d(m_.position[v]) - Vec3d(m_.position[w]));
		if (squared > settings_.longestEdge * settings_.longestEdge) return false;
		const Places places = placesOf(merge);
		c.cost = float(places.at[0].first + settings_.lengthWeight * squared * squared);
		if (merge.endsFlat) c.cost = -1 / (1 + c.cost); // before all edges, the cheapest first
		if (hasToGo(merge)) c.cost = -1;
		c.a      = std::min(v, w);
		c.b      = std::max(v, w);
		c.stampA = stamp_[c.a];
		c.stampB = stamp_[c.b];
		return true;
	}

	// ---- how an edge is collapsed

	bool isFixed(int v) const { return g_.isFixed(v); }

	bool isBesideFlat(int v, int w) const
	{
		return anyOutgoing(m_, v, [&](int h) {
			return (m_.target(h) == w || m_.apex(h) == w) && hasZeroArea(m_.faceCross(h / 3));
		});
	}

	Merge mergeOf(int v, int w) const
	{
		Merge merge    = wayOf(v, w);
		merge.endsFlat = hasFlat_ && merge.from >= 0 && isBesideFlat(v, w);
		return merge;
	}

	Merge wayOf(int v, int w) const
	{
		const bool isBorderV = m_.isBorderVertex(v), isBorderW = m_.isBorderVertex(w);
		if (isBorderV && isBorderW) return isFixed(v) ? alongBorder(w, v) : alongBorder(v, w);
		if (isFixed(v) || isBorderV) return inside(w, v);
		return inside(v, w);
	}

	Merge inside(int from, int to) const
	{
		if (isFixed(from)) return {};
		return {from, to, false, !isFixed(to) && !m_.isBorderVertex(to), false};
	}

	Merge alongBorder(int from, int to) const
	{
		if (isFixed(from) || !areBorderNeighbours(from, to)) return {};
		return {from, to, true, !isFixed(to), false};
	}

	bool areBorderNeighbours(int v, int w) const
	{
		return borderNeighbour(m_, v, true) == w || borderNeighbour(m_, v, false) == w;
	}

	/// Whether the merge removes a vertex from a kept border.
	bool hasToGo(const Merge& merge) const { return settings_.keepsBorder && merge.isAlongBorder; }

	const Bounds& boundsOf(const Merge& merge) const
	{
		const bool isFirst = hasToGo(merge) || merge.endsFlat;
		return isFirst && !isForced_ ? boundsOfRounds.back() : bounds_;
	}

	Places placesOf(const Merge& merge) const
	{
		Places  places;
		Quadric q = g_.vertex[merge.from].quadric;
		q += g_.vertex[merge.to].quadric;
		const Vec3d to(m_.position[merge.to]);
		if (!merge.mayMove) {
			places.add(q, to);
			return places;
		}
		const auto  kept = [&](const Vec3d& p) { return m_.keptOnMirror(merge.to, p); };
		const Vec3d from = kept(Vec3d(m_.position[merge.from])), middle = (from + to) * 0.5;
		Quadric     drawn = q;
		drawn.addPoint(middle, middleWeight * q.trace());
		const Vec3d lowest = kept(drawn.lowest(middle));
		if (settings_.mayLeaveVertices &&
			squaredLength(lowest - middle) <= squaredLength(to - from))
			places.add(q, lowest);
		if (settings_.mayLeaveVertices) places.add(q, middle);
		places.add(q, from);
		places.add(q, to);
		places.sort();
		return places;
	}

	// ---- collapsing

	void tryToCollapse(int a, int b)
	{
		const Merge merge = mergeOf(a, b);
		if (merge.from < 0 || !topologyAllows(merge)) return;
		collectFaces(merge);
		const Places places = placesOf(merge);
		for (int i = 0; i < places.num; ++i) {
			const auto& [squaredByArea, place] = places.at[i];
			if (isTooFar(merge, squaredByArea)) return;
			if (!isInCube(place)) continue;
			if (!makeTriangles(merge, place)) continue;
			const bool isTested = !isForced_ && !isUntested(merge, squaredByArea);
			if (isTested && !guard_.allows(made_, gone_)) continue;
			collapseTo(merge, place);
			return;
		}
	}

	bool topologyAllows(const Merge& merge)
	{
		if (merge.isAlongBorder)
			return canCollapseAlongBorder(m_, merge.from, isForward(merge), scratch_);
		const int h = m_.findHalfEdge(merge.from, merge.to);
		return h >= 0 && canCollapse(m_, h, scratch_);
	}

	bool isForward(const Merge& merge) const
	{
		return borderNeighbour(m_, merge.from, true) == merge.to;
	}

	bool isTooFar(const Merge& merge, double squaredByArea) const
	{
		return isBeyond(double(boundsOf(merge).distance), merge, squaredByArea);
	}

	bool isInCube(const Vec3f& place) const
	{
		return settings_.grid == nullptr || settings_.grid->cubeOf(place) == settings_.cube;
	}

	bool isUntested(const Merge& merge, double squaredByArea) const
	{
		return settings_.untested > 0 && !isBeyond(settings_.untested, merge, squaredByArea);
	}

	/// Whether a place is farther than a distance, in edges, by the quadrics, which are weighted by
	/// area.
	bool isBeyond(double distance, const Merge& merge, double squaredByArea) const
	{
		const double most = distance * settings_.idealEdge;
		const float  area = g_.vertex[merge.from].area + g_.vertex[merge.to].area;
		return squaredByArea > most * most * double(area);
	}

	/// Collects all faces at the two vertices.
	void collectFaces(const Merge& merge)
	{
		gone_.clear();
		forEachOutgoing(m_, merge.from, [&](int h) { gone_.push_back(h / 3); });
		forEachOutgoing(m_, merge.to, [&](int h) {
			if (m_.target(h) != merge.from && m_.apex(h) != merge.from) gone_.push_back(h / 3);
		});
		leastShape_ = boundsOf(merge).shape;
		for (int f : gone_)
			leastShape_ = std::min(leastShape_, triangleOf(m_, f).shape());
	}

	/// Makes the remaining faces with the merged vertex at `place`. False if a face is not sound.
	bool makeTriangles(const Merge& merge, const Vec3f& place)
	{
		made_.clear();
		for (int f : gone_) {
			const NamedTriangle before = triangleOf(m_, f);
			NamedTriangle       after  = before;
			int                 num    = 0;
			for (int k = 0; k < 3; ++k) {
				if (before.vertex[k] != merge.from && before.vertex[k] != merge.to) continue;
				after.vertex[k] = merge.to;
				after.at[k]     = place;
				++num;
			}
			if (num > 1) continue;
			if (!isSound(merge, before, after)) return false;
			made_.push_back(after);
		}
		return true;
	}

	bool isSound(const Merge& merge, const NamedTriangle& before, const NamedTriangle& after) const
	{
		const Vec3f   normal = after.cross(), old = before.cross();
		const Bounds& bounds = boundsOf(merge);
		if (after.isLine()) return hasZeroArea(old);
		if (hasZeroArea(old)) return g_.agrees(after.vertex, normal, bounds.agreement, merge.from);
		if (after.shape() < leastShape_) return false;
		if (dot(normal, old) < bounds.turn * length(normal) * length(old)) return false;
		return g_.agrees(after.vertex, normal, bounds.agreement, merge.from) ||
			   !g_.agrees(after.vertex, old, bounds.agreement, merge.from);
	}

	void collapseTo(const Merge& merge, const Vec3f& place)
	{
		takeOver(merge, place);
		if (merge.isAlongBorder)
			collapseAlongBorder(m_, merge.from, isForward(merge));
		else
			collapse(m_, m_.findHalfEdge(merge.from, merge.to));
		m_.position[merge.to] = place;
		--livingNum_;
		if (hasToGo(merge)) --borderNum_;
		++stamp_[merge.from];
		++stamp_[merge.to];
		guard_.follow(facesRound(m_, {merge.to}));
		queueRound(merge.to);
	}

	void takeOver(const Merge& merge, const Vec3f& place)
	{
		GuardedVertex& from = g_.vertex[merge.from];
		GuardedVertex& to   = g_.vertex[merge.to];
		to.quadric += from.quadric;
		to.normal += from.normal;
		to.area += from.area;
		to.points.insert(to.points.end(), from.points.begin(), from.points.end());
		from.points = std::vector<Vec3f>(); // frees its memory
		if (squaredLength(place - from.anchorPlace) < squaredLength(place - to.anchorPlace)) {
			to.anchor      = from.anchor;
			to.anchorPlace = from.anchorPlace;
		}
	}
};

/// name: per vertex of m, its vertex in g or -1.
void addFace(const HalfEdgeMesh& m, int f, const std::vector<int>& name, GuardedMesh& g)
{
	const Vec3d  o(m.position[m.origin[3 * f]]);
	const Vec3d  n       = cross(Vec3d(m.position[m.origin[3 * f + 1]]) - o,
								 Vec3d(m.position[m.origin[3 * f + 2]]) - o);
	const double doubled = length(n);
	if (!(doubled > 0)) return;
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		const int own = name[m.origin[h]];
		if (own < 0) continue;
		GuardedVertex& v = g.vertex[own];
		v.quadric.addPlane(o, n * (1 / doubled), doubled / 6);
		v.normal += Vec3f(n * (1.0 / 6));
		v.area += float(doubled / 6);
	}
}

/// Adds a plane through the border edge, perpendicular to the face: it holds the border in place.
void addBorder(const HalfEdgeMesh& m, int h, const std::vector<int>& name, GuardedMesh& g)
{
	const int   a = m.origin[h], b     = m.target(h);
	const Vec3d o(m.position[a]), edge = Vec3d(m.position[b]) - o;
	const Vec3d across = cross(edge, Vec3d(m.faceCross(h / 3)));
	const Vec3d normal = normalized(across);
	for (int v : {name[a], name[b]}) {
		if (v >= 0) g.vertex[v].quadric.addPlane(o, normal, squaredLength(edge));
	}
}

} // namespace

GuardedMesh::GuardedMesh(HalfEdgeMesh from, bool hasContacts, Workers* asked) :
		mesh(std::move(from)), vertex(std::size_t(mesh.vertexNum)), hadContacts(hasContacts)
{
	mesh.crease.reset(std::size_t(mesh.halfEdgeNum()));
	for (int h = 0; h < mesh.halfEdgeNum(); ++h)
		mesh.crease[h] = char(mesh.isBorderEdge(h));
	assign(mesh, numbersBelow(vertex.size()), asked);
	mesh.crease.release();
	for (int v = 0; v < mesh.vertexNum; ++v) {
		vertex[v].anchor      = v;
		vertex[v].anchorPlace = mesh.position[v];
	}
}

void GuardedMesh::assign(const HalfEdgeMesh& other, const std::vector<int>& name, Workers* asked)
{
	for (int v : name) {
		if (v < 0) continue;
		GuardedVertex& to = vertex[v];
		to.quadric        = Quadric();
		to.normal         = Vec3f();
		to.area           = 0;
		to.points.clear();
	}
	for (std::size_t v = 0; v < name.size(); ++v) {
		if (name[v] >= 0) vertex[name[v]].points.push_back(other.position[v]);
	}
	for (int f = 0; f < other.faceNum; ++f) {
		if (f % 65536 == 0 && asked != nullptr) asked->poll();
		addFace(other, f, name, *this);
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			if (other.isBorderEdge(h) && other.isCreaseEdge(h)) addBorder(other, h, name, *this);
		}
	}
}

bool GuardedMesh::agrees(const int* v, const Vec3f& n, float cosine, int another) const
{
	Vec3f wanted;
	float sum = 0;
	for (int w : {v[0], v[1], v[2], another}) {
		if (w < 0) continue;
		wanted += vertex[w].normal;
		sum += vertex[w].area;
	}
	const float size = length(wanted);
	return size < leastSpread * sum || dot(n, wanted) > cosine * length(n) * size;
}

void GuardedMesh::compact(Workers& workers)
{
	Buffer<int> newIndex;
	gpr::compact(mesh, workers, newIndex);
	std::vector<GuardedVertex> living;
	living.reserve(std::size_t(mesh.vertexNum));
	for (std::size_t v = 0; v < vertex.size(); ++v) {
		if (newIndex[v] >= 0) living.push_back(std::move(vertex[v]));
	}
	vertex = std::move(living);
}

bool collapseGuarded(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers)
{
	return Decimation(settings, guarded, workers).run();
}

void collapseStrictly(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers)
{
	Decimation(settings, guarded, workers).runRounds(strictRounds);
}

} // namespace gpr
