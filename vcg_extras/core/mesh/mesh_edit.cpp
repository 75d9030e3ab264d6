// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_edit.h"

#include "indexed_mesh.h"

#include <algorithm>

namespace gpr {

namespace {

/// Makes g and h opposite; either may be -1, which makes the other half-edge a border.
void join(HalfEdgeMesh& m, int g, int h)
{
	if (g >= 0) m.opposite[g] = h;
	if (h >= 0) m.opposite[h] = g;
}

/// Copies the mark of half-edge `from` to `to`; no mark if from < 0.
void moveMark(HalfEdgeMesh& m, int to, int from)
{
	if (m.hasCreases()) m.crease[to] = from < 0 ? char(0) : m.crease[from];
}

/// Puts half-edge `to` in the place of `from`, which has the same origin: `to` gets the opposite
/// and the mark.
void takePlace(HalfEdgeMesh& m, int to, int from)
{
	join(m, to, m.opposite[from]);
	moveMark(m, to, from);
	moveMark(m, from, -1);
	const int v = m.origin[to];
	if (m.outgoing[v] == from) m.outgoing[v] = to;
}

/// Appends a face without opposites and marks. Returns its first half-edge.
int appendFace(HalfEdgeMesh& m, int a, int b, int c)
{
	const int h     = 3 * m.faceNum++;
	m.origin[h]     = a;
	m.origin[h + 1] = b;
	m.origin[h + 2] = c;
	for (int k = h; k < h + 3; ++k) {
		m.opposite[k] = -1;
		moveMark(m, k, -1);
	}
	return h;
}

/// Whether the two other edges in the face of h can merge: not if both are on curves.
bool sideCanClose(const HalfEdgeMesh& m, int h)
{
	return !(m.isCurveEdge(nextInFace(h)) && m.isCurveEdge(prevInFace(h)));
}

void collectNeighbours(const HalfEdgeMesh& m, int v, std::vector<int>& ring)
{
	ring.clear();
	forEachNeighbour(m, v, [&](int w) { ring.push_back(w); });
}

int commonNeighbourNum(const HalfEdgeMesh& m, const std::vector<int>& ring, int v)
{
	int n = 0;
	forEachNeighbour(m, v,
					 [&](int w) { n += std::find(ring.begin(), ring.end(), w) != ring.end(); });
	return n;
}

/// Whether v has enough faces left after losing a face: three inside, one at a border.
bool canLoseFace(const HalfEdgeMesh& m, int v)
{
	const int enough = m.isBorderVertex(v) ? 2 : 4;
	int       n      = 0;
	int       h      = m.outgoing[v];
	const int first  = h;
	do {
		if (++n == enough) return true;
		h = m.opposite[prevInFace(h)];
	} while (h >= 0 && h != first);
	return false;
}

void killFace(HalfEdgeMesh& m, int f)
{
	m.origin[3 * f] = m.origin[3 * f + 1] = m.origin[3 * f + 2] = -1;
}

/// Kills the face of h. Its two other edges become one edge, on a feature line if either was.
void closeFace(HalfEdgeMesh& m, int h)
{
	const int apex = m.apex(h);
	const int g = m.opposite[nextInFace(h)], k = m.opposite[prevInFace(h)];
	join(m, g, k);
	if (m.hasCreases() && g >= 0 && k >= 0)
		m.crease[g] = m.crease[k] = char(m.crease[g] | m.crease[k]);
	if (m.outgoing[apex] == prevInFace(h)) m.outgoing[apex] = g >= 0 ? g : nextInFace(k);
	killFace(m, h / 3);
}

/// Whether an inner edge between a and b would have a mirror image with the same ends.
bool isOwnImage(const HalfEdgeMesh& m, int a, int b)
{
	return m.isOnMirror(a) && m.isOnMirror(b);
}

bool hasNewEdgesOnly(const HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch)
{
	for (int x = 0; x < int(patch.corner.size()); ++x) {
		const bool isDiagonal = patch.across[x] > x;
		const bool isClosing  = !star.isClosed && patch.across[x] == -star.placeNum();
		if (!isDiagonal && !isClosing) continue;
		const int a = star.ring[patch.corner[x]], b = star.ring[patch.corner[nextInFace(x)]];
		if (m.areNeighbours(a, b)) return false;
		const bool runsAlongMirror = isClosing && m.isOnMirror(star.vertex);
		if (!runsAlongMirror && isOwnImage(m, a, b)) return false;
	}
	return true;
}

/// Whether each place of the ring keeps enough faces; a place with a single triangle loses a face.
bool leavesEnoughFaces(const HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
					   EditScratch& scratch)
{
	const int n = star.placeNum();
	scratch.count.assign(n, 0);
	for (int place : patch.corner)
		++scratch.count[place];
	for (int place = 0; place < n; ++place) {
		const bool isEnd  = !star.isClosed && (place == 0 || place == n - 1);
		const int  before = isEnd ? 1 : 2;
		if (scratch.count[place] < before && !canLoseFace(m, star.ring[place])) return false;
	}
	return true;
}

/// Removes the only face of a border vertex; the edge opposite the vertex becomes border.
void removeEar(HalfEdgeMesh& m, const VertexStar& star)
{
	const int beyond         = m.opposite[nextInFace(star.spoke[0])];
	m.opposite[beyond]       = -1;
	m.outgoing[star.ring[1]] = beyond;
	m.outgoing[star.vertex]  = -1;
	killFace(m, star.spoke[0] / 3);
}

void renameOrigin(HalfEdgeMesh& m, int from, int to)
{
	forEachOutgoing(m, from, [&](int h) { m.origin[h] = to; });
}

/// Whether merging inner vertex origin[h], with this ring, into target(h) makes no inner edge its
/// own mirror image. Edges from target(h) to the ring's c and d exist before.
bool mirrorAllowsCollapse(const HalfEdgeMesh& m, int h, const std::vector<int>& ring)
{
	const int b = m.target(h), c = m.apex(h), d = m.apex(m.opposite[h]);
	if (!m.isOnMirror(b)) return true;
	const bool areBothOnMirror = m.isOnMirror(c) && m.isOnMirror(d);
	if (areBothOnMirror && ring.size() == 3) return false;
	return std::all_of(ring.begin(), ring.end(),
					   [&](int w) { return w == b || w == c || w == d || !m.isOnMirror(w); });
}

/// Whether v may be merged into b, its neighbour on the border: vertices stay on the mirror plane,
/// a part of the border on the plane keeps its ends, and no inner edge becomes its own mirror
/// image. scratch.ringA: the neighbours of v.
bool mirrorAllowsCollapseAlongBorder(const HalfEdgeMesh& m, int v, int b, bool forward,
									 const EditScratch& scratch)
{
	if (m.mirrorAxis < 0) return true;
	if (m.isOnMirror(v)) return m.isOnMirror(b) && m.isOnMirror(borderNeighbour(m, v, !forward));
	return !m.isOnMirror(b) || std::none_of(scratch.ringA.begin(), scratch.ringA.end(),
											[&](int w) { return w != b && m.isOnMirror(w); });
}

/// The topological part of the test; origin[h] is an inner vertex.
bool linkAllowsCollapse(const HalfEdgeMesh& m, int h, EditScratch& scratch)
{
	const int g = m.opposite[h];
	const int a = m.origin[h], b = m.target(h);
	const int c = m.apex(h), d = m.apex(g);
	if (c == d) return false;
	collectNeighbours(m, a, scratch.ringA);
	if (commonNeighbourNum(m, scratch.ringA, b) != 2) return false;
	if (!mirrorAllowsCollapse(m, h, scratch.ringA)) return false;
	return canLoseFace(m, c) && canLoseFace(m, d);
}

/// Whether a part of the border on the mirror plane keeps an edge without the star's vertex.
bool mirrorAllowsRemoval(const HalfEdgeMesh& m, const VertexStar& star)
{
	if (star.isClosed || !m.isOnMirror(star.vertex)) return true;
	const int  next = star.ring.front(), last = star.ring.back();
	const bool isNext = m.isOnMirror(next), isLast = m.isOnMirror(last);
	if (isNext == isLast) return true;
	return m.isOnMirror(isNext ? borderNeighbour(m, next, true) : borderNeighbour(m, last, false));
}

/// Numbers the living items of 0 .. n-1 in order; other items get -1. Returns the number of living
/// items.
template <class IsAlive>
int numberLiving(int n, const IsAlive& isAlive, Workers& workers, Buffer<int>& number)
{
	number.reset(n);
	workers.forEach(n, [&](int i) { number[i] = isAlive(i); });
	const int livingNum = workers.sumUp(number.data(), n);
	workers.forEach(n, [&](int i) { number[i] = isAlive(i) ? number[i] - 1 : -1; });
	return livingNum;
}

bool hasRoom(const HalfEdgeMesh& m)
{
	return m.position.size() > std::size_t(m.vertexNum) ||
		   m.origin.size() > std::size_t(m.halfEdgeNum());
}

} // namespace

bool canCollapse(const HalfEdgeMesh& m, int h, EditScratch& scratch)
{
	const int a = m.origin[h];
	if (m.opposite[h] < 0 || m.isBorderVertex(a) || m.isCreaseVertex(a)) return false;
	return linkAllowsCollapse(m, h, scratch);
}

bool canCollapseAlongCrease(const HalfEdgeMesh& m, int h, EditScratch& scratch)
{
	const int a = m.origin[h];
	if (m.isBorderVertex(a) || !m.isCreaseEdge(h) || m.creaseNum(a) != 2) return false;
	if (!sideCanClose(m, h) || !sideCanClose(m, m.opposite[h])) return false;
	return linkAllowsCollapse(m, h, scratch);
}

///          c                       c
///     T2 / | \ T1                  |
///       /  |  \          T2 = T1   |
///      a --h-> b     =>            b
///       \  g  /          T3 = T4   |
///     T3 \ | / T4                  |
///          d                       d
void collapse(HalfEdgeMesh& m, int h)
{
	const int g = m.opposite[h];
	const int a = m.origin[h], b = m.target(h);
	const int t1 = m.opposite[nextInFace(h)], t2 = m.opposite[prevInFace(h)];
	renameOrigin(m, a, b);
	closeFace(m, h);
	closeFace(m, g);
	// a was inside, so t2 and t3 exist; t1 or t4 is missing if b's border runs along the faces.
	const bool keepsBorder = t1 >= 0 && m.isBorderVertex(b);
	if (!keepsBorder) m.outgoing[b] = t2;
	m.outgoing[a] = -1;
}

int borderNeighbour(const HalfEdgeMesh& m, int v, bool forward)
{
	return forward ? m.target(m.outgoing[v]) : m.origin[m.incomingBorder(v)];
}

bool canCollapseAlongBorder(const HalfEdgeMesh& m, int v, bool forward, EditScratch& scratch)
{
	const int h = forward ? m.outgoing[v] : m.incomingBorder(v);
	const int b = forward ? m.target(h) : m.origin[h];
	const int c = m.apex(h);
	if (m.isCreaseVertex(v) || !sideCanClose(m, h)) return false;
	collectNeighbours(m, v, scratch.ringA);
	// The third vertex of a loop has two common neighbours with the next, and stays.
	if (commonNeighbourNum(m, scratch.ringA, b) != 1) return false;
	return mirrorAllowsCollapseAlongBorder(m, v, b, forward, scratch) && canLoseFace(m, c);
}

///  forward:  v --h-> b (border), face (v, b, c)      backward:  b --h-> v (border), face (b, v, c)
void collapseAlongBorder(HalfEdgeMesh& m, int v, bool forward)
{
	const int h      = forward ? m.outgoing[v] : m.incomingBorder(v);
	const int b      = forward ? m.target(h) : m.origin[h];
	const int beyond = m.opposite[prevInFace(h)];
	// b keeps its border half-edge or takes the one of v, outside the dead face.
	const int border = m.outgoing[forward ? b : v];
	renameOrigin(m, v, b);
	closeFace(m, h);
	m.outgoing[b] = border == nextInFace(h) ? beyond : border;
	m.outgoing[v] = -1;
}

bool canFlip(const HalfEdgeMesh& m, int h)
{
	const int g = m.opposite[h];
	if (g < 0 || m.isCreaseEdge(h)) return false;
	const int c = m.apex(h), d = m.apex(g);
	return c != d && canLoseFace(m, m.origin[h]) && canLoseFace(m, m.target(h)) &&
		   !m.areNeighbours(c, d) && !isOwnImage(m, c, d);
}

void flip(HalfEdgeMesh& m, int h)
{
	const int g  = m.opposite[h];
	const int hn = nextInFace(h), gn = nextInFace(g);
	const int c = m.apex(h), d = m.apex(g);
	// Faces (a, b, c), (b, a, d) become (a, d, c), (b, c, d).
	takePlace(m, h, gn);
	takePlace(m, g, hn);
	m.origin[hn] = d;
	m.origin[gn] = c;
	join(m, hn, gn);
}

void splitEdge(HalfEdgeMesh& m, int h, int v)
{
	const int g  = m.opposite[h];
	const int hn = nextInFace(h), gp = prevInFace(g);
	const int b = m.target(h);
	// (a, b, c), (b, a, d) become (a, v, c), (v, a, d); new are (v, b, c), (b, v, d).
	const int e = appendFace(m, v, b, m.apex(h)), k = appendFace(m, b, v, m.apex(g));
	takePlace(m, e + 1, hn);
	takePlace(m, k + 2, gp);
	moveMark(m, e, h);
	moveMark(m, k, h);
	m.origin[hn] = v;
	m.origin[g]  = v;
	join(m, hn, e + 2);
	join(m, e, k);
	join(m, gp, k + 1);
	m.outgoing[v] = hn;
	if (m.outgoing[b] == g) m.outgoing[b] = k;
}

void splitBorderEdge(HalfEdgeMesh& m, int h, int v)
{
	const int hn = nextInFace(h);
	// (a, b, c) becomes (a, v, c); new is (v, b, c).
	const int e = appendFace(m, v, m.target(h), m.apex(h));
	takePlace(m, e + 1, hn);
	m.origin[hn] = v;
	join(m, hn, e + 2);
	m.outgoing[v] = e;
}

///        c                  c
///      /   \              / | \          (a, b, c) becomes (a, b, v);
///     /     \      =>    / .v. \         new are (b, c, v) and (c, a, v).
///    a-------b          a-------b
void splitFace(HalfEdgeMesh& m, int f, int v)
{
	const int ab = 3 * f, bc = ab + 1, ca = ab + 2;
	const int a = m.origin[ab], b = m.origin[bc], c = m.origin[ca];
	const int e = appendFace(m, b, c, v), k = appendFace(m, c, a, v);
	takePlace(m, e, bc);
	takePlace(m, k, ca);
	m.origin[ca] = v;
	join(m, bc, e + 2);
	join(m, e + 1, k + 2);
	join(m, k + 1, ca);
	m.outgoing[v] = ca;
}

void collectStar(const HalfEdgeMesh& m, int v, VertexStar& star)
{
	star.vertex   = v;
	star.isClosed = !m.isBorderVertex(v);
	collectNeighbours(m, v, star.ring);
	star.spoke.clear();
	forEachOutgoing(m, v, [&](int h) { star.spoke.push_back(h); });
}

bool canRemoveVertex(const HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
					 EditScratch& scratch)
{
	const int n = star.placeNum();
	if (m.isCreaseVertex(star.vertex) || !mirrorAllowsRemoval(m, star)) return false;
	if (n < 3) {
		return !star.isClosed && !m.isCurveEdge(nextInFace(star.spoke[0])) &&
			   canLoseFace(m, star.ring[0]) && canLoseFace(m, star.ring[1]);
	}
	return hasNewEdgesOnly(m, star, patch) && leavesEnoughFaces(m, star, patch, scratch);
}

void removeVertex(HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
				  EditScratch& scratch)
{
	if (star.placeNum() < 3) {
		removeEar(m, star);
		return;
	}
	// The half-edges beyond the ring; -1 beyond the last edge at a border.
	std::vector<int>& beyond = scratch.ringA;
	beyond.clear();
	for (int h : star.spoke)
		beyond.push_back(m.opposite[nextInFace(h)]);
	beyond.resize(star.placeNum(), -1);
	// An inner vertex may begin at any half-edge, a border vertex only at its border half-edge.
	std::vector<int>& onBorder = scratch.count;
	onBorder.clear();
	for (int w : star.ring)
		onBorder.push_back(m.isBorderVertex(w));

	const auto placed = [&](int x) { return 3 * (star.spoke[x / 3] / 3) + x % 3; };
	for (int x = 0; x < int(patch.corner.size()); ++x) {
		const int place = patch.corner[x], y = patch.across[x];
		const int h = placed(x), w = star.ring[place];
		m.origin[h]   = w;
		m.opposite[h] = -1;
		join(m, h, y >= 0 ? placed(y) : beyond[-1 - y]);
		moveMark(m, h, y >= 0 ? -1 : beyond[-1 - y]);
		if (!onBorder[place] || m.opposite[h] < 0) m.outgoing[w] = h;
	}
	for (std::size_t i = std::size_t(patch.triangleNum()); i < star.spoke.size(); ++i)
		killFace(m, star.spoke[i] / 3);
	m.outgoing[star.vertex] = -1;
}

PatchBackup::PatchBackup(const HalfEdgeMesh& m, std::vector<int> vertices, std::vector<int> faces) :
		vertexNum_(m.vertexNum), faceNum_(m.faceNum), vertex_(std::move(vertices)),
		face_(std::move(faces))
{
	for (int v : vertex_) {
		outgoing_.push_back(m.outgoing[v]);
		position_.push_back(m.position[v]);
	}
	for (int f : face_) {
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			corner_.push_back({m.origin[h], m.opposite[h], char(m.isCreaseEdge(h))});
	}
}

void PatchBackup::restore(HalfEdgeMesh& m) const
{
	// Restores at the same time write no shared number.
	if (m.vertexNum != vertexNum_) m.vertexNum = vertexNum_;
	if (m.faceNum != faceNum_) m.faceNum = faceNum_;
	for (std::size_t i = 0; i < vertex_.size(); ++i) {
		m.outgoing[vertex_[i]] = outgoing_[i];
		m.position[vertex_[i]] = position_[i];
	}
	for (std::size_t i = 0; i < corner_.size(); ++i) {
		const int h   = 3 * face_[i / 3] + int(i % 3);
		m.origin[h]   = corner_[i].origin;
		m.opposite[h] = corner_[i].opposite;
		if (m.hasCreases()) m.crease[h] = corner_[i].crease;
	}
}

void reserve(HalfEdgeMesh& m, int vertexRoom, int faceRoom)
{
	if (m.position.size() < std::size_t(vertexRoom)) {
		m.position.resize(vertexRoom);
		m.outgoing.resize(vertexRoom);
	}
	if (m.origin.size() < 3 * std::size_t(faceRoom)) {
		m.origin.resize(3 * std::size_t(faceRoom));
		m.opposite.resize(3 * std::size_t(faceRoom));
		if (m.hasCreases()) m.crease.resize(3 * std::size_t(faceRoom));
	}
}

void compact(HalfEdgeMesh& m, Workers& workers, Buffer<int>& newIndex)
{
	Buffer<int>  newFace;
	HalfEdgeMesh to;
	to.mirrorAxis = m.mirrorAxis;
	to.vertexNum  = numberLiving(
		 m.vertexNum, [&](int v) { return m.outgoing[v] >= 0; }, workers, newIndex);
	to.faceNum = numberLiving(
		m.faceNum, [&](int f) { return !isDeadFace(m, f); }, workers, newFace);
	if (to.vertexNum == m.vertexNum && to.faceNum == m.faceNum && !hasRoom(m)) return;
	to.meetsAtPlaces = m.meetsAtPlaces;
	reserve(to, to.vertexNum, to.faceNum);
	if (m.hasCreases()) to.crease.reset(to.halfEdgeNum());
	const auto renamed = [&](int h) { return h < 0 ? -1 : 3 * newFace[h / 3] + h % 3; };
	workers.forEach(m.vertexNum, [&](int v) {
		const int n = newIndex[v];
		if (n < 0) return;
		to.position[n] = m.position[v];
		to.outgoing[n] = renamed(m.outgoing[v]);
	});
	workers.forEach(m.faceNum, [&](int f) {
		if (newFace[f] < 0) return;
		for (int k = 0; k < 3; ++k) {
			const std::size_t from = 3 * f + k;
			const int         at   = 3 * newFace[f] + k;
			to.origin[at]          = newIndex[m.origin[from]];
			to.opposite[at]        = renamed(m.opposite[from]);
			if (m.hasCreases()) to.crease[at] = m.crease[from];
		}
	});
	m = std::move(to);
}

HalfEdgeMesh copyMesh(const HalfEdgeMesh& from, Workers& workers)
{
	HalfEdgeMesh to;
	to.vertexNum     = from.vertexNum;
	to.faceNum       = from.faceNum;
	to.mirrorAxis    = from.mirrorAxis;
	to.meetsAtPlaces = from.meetsAtPlaces;
	to.position      = copyOf(from.position, std::size_t(from.vertexNum), workers);
	to.outgoing      = copyOf(from.outgoing, std::size_t(from.vertexNum), workers);
	to.origin        = copyOf(from.origin, std::size_t(from.halfEdgeNum()), workers);
	to.opposite      = copyOf(from.opposite, std::size_t(from.halfEdgeNum()), workers);
	if (from.hasCreases())
		to.crease = copyOf(from.crease, std::size_t(from.halfEdgeNum()), workers);
	return to;
}

} // namespace gpr
