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

/// After join(g, h): the merged edge is on a feature line if g or h was.
void mergeMarks(HalfEdgeMesh& m, int g, int h)
{
	if (!m.hasCreases() || g < 0 || h < 0) return;
	m.crease[g] = m.crease[h] = char(m.crease[g] | m.crease[h]);
}

void joinMerged(HalfEdgeMesh& m, int g, int h)
{
	join(m, g, h);
	mergeMarks(m, g, h);
}

/// Copies the mark of half-edge `from` to `to`; no mark if from < 0.
void moveMark(HalfEdgeMesh& m, int to, int from)
{
	if (m.hasCreases()) m.crease[to] = from < 0 ? char(0) : m.crease[from];
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

/// Whether every edge of the patch's triangles is an edge of the ring, used once, or a diagonal of
/// two triangles. With two triangles fewer than places the patch is then a disk.
bool isTriangulation(const HolePatch& patch, int placeNum, EditScratch& scratch)
{
	if (patch.triangleNum() != placeNum - 2 || patch.across.size() != patch.corner.size())
		return false;
	scratch.count.assign(placeNum, 0);
	for (int x = 0; x < int(patch.corner.size()); ++x) {
		const int from = patch.corner[x], to = patch.corner[nextInFace(x)];
		const int y = patch.across[x];
		if (y >= int(patch.corner.size()) || y < -placeNum) return false;
		if (y < 0) {
			if (from != -1 - y || to != (from + 1) % placeNum) return false;
			if (++scratch.count[from] > 1) return false;
			continue;
		}
		if (patch.across[y] != x || patch.corner[y] != to || patch.corner[nextInFace(y)] != from)
			return false;
	}
	return true;
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
	const int first = m.outgoing[from];
	int       h     = first;
	do {
		const int next = m.opposite[prevInFace(h)];
		m.origin[h]    = to;
		h              = next;
	} while (h >= 0 && h != first);
}

} // namespace

namespace {

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
	const int a = m.origin[h], b = m.target(h), c = m.apex(h), d = m.apex(g);
	renameOrigin(m, a, b);
	const int t1 = m.opposite[nextInFace(h)], t2 = m.opposite[prevInFace(h)];
	const int t3 = m.opposite[nextInFace(g)], t4 = m.opposite[prevInFace(g)];
	joinMerged(m, t1, t2);
	joinMerged(m, t3, t4);
	// a was inside, so t2 and t3 exist; t1 or t4 is missing if b's border runs along the faces.
	const bool keepsBorder = t1 >= 0 && m.isBorderVertex(b);
	if (!keepsBorder) m.outgoing[b] = t2;
	if (m.outgoing[c] == prevInFace(h)) m.outgoing[c] = t1 >= 0 ? t1 : nextInFace(t2);
	if (m.outgoing[d] == prevInFace(g)) m.outgoing[d] = t3;
	m.outgoing[a] = -1;
	killFace(m, h / 3);
	killFace(m, g / 3);
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
	const int border = m.outgoing[v];
	const int h      = forward ? border : m.incomingBorder(v);
	const int b      = forward ? m.target(h) : m.origin[h];
	const int c      = m.apex(h);
	renameOrigin(m, v, b);
	const int inner1 = nextInFace(h), inner2 = prevInFace(h);
	const int t1 = m.opposite[inner1], t2 = m.opposite[inner2];
	joinMerged(m, t1, t2);
	if (forward) {
		// b keeps its border half-edge outside the dead face.
		if (m.outgoing[b] == inner1) m.outgoing[b] = t2;
	}
	else {
		// b takes the border half-edge of v outside the dead face.
		m.outgoing[b] = border == inner1 ? t2 : border;
	}
	if (m.outgoing[c] == inner2) m.outgoing[c] = t1 >= 0 ? t1 : nextInFace(t2);
	m.outgoing[v] = -1;
	killFace(m, h / 3);
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
	const int hn = nextInFace(h), hp = prevInFace(h), gn = nextInFace(g), gp = prevInFace(g);
	const int a = m.origin[h], b = m.origin[hn], c = m.origin[hp], d = m.origin[gp];
	const int acrossBC = m.opposite[hn], acrossAD = m.opposite[gn];
	// Faces (a, b, c), (b, a, d) become (a, d, c), (b, c, d).
	m.origin[hn] = d;
	m.origin[g]  = b;
	m.origin[gn] = c;
	m.origin[gp] = d;
	moveMark(m, h, gn);
	moveMark(m, g, hn);
	moveMark(m, hn, -1);
	moveMark(m, gn, -1);
	join(m, h, acrossAD);
	join(m, g, acrossBC);
	join(m, hn, gn);
	if (m.outgoing[a] == gn) m.outgoing[a] = h;
	if (m.outgoing[b] == hn) m.outgoing[b] = g;
}

void splitEdge(HalfEdgeMesh& m, int h, int v)
{
	const int g  = m.opposite[h];
	const int hn = nextInFace(h), hp = prevInFace(h), gp = prevInFace(g);
	const int b = m.origin[hn], c = m.origin[hp], d = m.origin[gp];
	const int acrossBC = m.opposite[hn], acrossDB = m.opposite[gp];
	const int e = 3 * m.faceNum, k = 3 * (m.faceNum + 1);
	m.faceNum += 2;
	m.opposite[e + 1] = m.opposite[k + 2] = -1;
	// (a, b, c), (b, a, d) become (a, v, c), (v, a, d); new are (v, b, c), (b, v, d).
	m.origin[hn]    = v;
	m.origin[g]     = v;
	m.origin[e]     = v;
	m.origin[e + 1] = b;
	m.origin[e + 2] = c;
	m.origin[k]     = b;
	m.origin[k + 1] = v;
	m.origin[k + 2] = d;
	moveMark(m, e, h);
	moveMark(m, e + 1, hn);
	moveMark(m, e + 2, -1);
	moveMark(m, k, h);
	moveMark(m, k + 1, -1);
	moveMark(m, k + 2, gp);
	moveMark(m, hn, -1);
	moveMark(m, gp, -1);
	join(m, hn, e + 2);
	join(m, e + 1, acrossBC);
	join(m, e, k);
	join(m, gp, k + 1);
	join(m, k + 2, acrossDB);
	m.outgoing[v] = hn;
	if (m.outgoing[b] == hn) m.outgoing[b] = e + 1;
	if (m.outgoing[b] == g) m.outgoing[b] = k;
	if (m.outgoing[d] == gp) m.outgoing[d] = k + 2;
}

void splitBorderEdge(HalfEdgeMesh& m, int h, int v)
{
	const int hn = nextInFace(h), hp = prevInFace(h);
	const int b = m.origin[hn], c = m.origin[hp];
	const int acrossBC = m.opposite[hn];
	const int e        = 3 * m.faceNum;
	m.faceNum += 1;
	// (a, b, c) becomes (a, v, c); new is (v, b, c).
	m.origin[hn]      = v;
	m.origin[e]       = v;
	m.origin[e + 1]   = b;
	m.origin[e + 2]   = c;
	m.opposite[e]     = -1;
	m.opposite[e + 1] = -1;
	moveMark(m, e, -1);
	moveMark(m, e + 1, hn);
	moveMark(m, e + 2, -1);
	moveMark(m, hn, -1);
	join(m, hn, e + 2);
	join(m, e + 1, acrossBC);
	m.outgoing[v] = e;
	if (m.outgoing[b] == hn) m.outgoing[b] = e + 1;
}

///        c                  c
///      /   \              / | \          (a, b, c) becomes (a, b, v);
///     /     \      =>    / .v. \         new are (b, c, v) and (c, a, v).
///    a-------b          a-------b
void splitFace(HalfEdgeMesh& m, int f, int v)
{
	const int ab = 3 * f, bc = ab + 1, ca = ab + 2;
	const int a = m.origin[ab], b = m.origin[bc], c = m.origin[ca];
	const int e = 3 * m.faceNum, k = 3 * (m.faceNum + 1);
	m.faceNum += 2;
	m.origin[ca]    = v;
	m.origin[e]     = b;
	m.origin[e + 1] = c;
	m.origin[e + 2] = v;
	m.origin[k]     = c;
	m.origin[k + 1] = a;
	m.origin[k + 2] = v;
	m.opposite[e] = m.opposite[k] = -1;
	moveMark(m, e, bc);
	moveMark(m, k, ca);
	for (int inner : {bc, ca, e + 1, e + 2, k + 1, k + 2})
		moveMark(m, inner, -1);
	join(m, e, m.opposite[bc]);
	join(m, k, m.opposite[ca]);
	join(m, bc, e + 2);
	join(m, e + 1, k + 2);
	join(m, k + 1, ca);
	m.outgoing[v] = ca;
	if (m.outgoing[b] == bc) m.outgoing[b] = e;
	if (m.outgoing[c] == ca) m.outgoing[c] = k;
}

void collectStar(const HalfEdgeMesh& m, int v, VertexStar& star)
{
	star.vertex   = v;
	star.isClosed = true;
	star.ring.clear();
	star.spoke.clear();
	const int first = m.outgoing[v];
	int       h     = first;
	do {
		star.spoke.push_back(h);
		star.ring.push_back(m.target(h));
		const int in = prevInFace(h);
		h            = m.opposite[in];
		if (h < 0) {
			star.isClosed = false;
			star.ring.push_back(m.origin[in]);
		}
	} while (h >= 0 && h != first);
}

namespace {

/// Whether a part of the border on the mirror plane keeps an edge without the star's vertex.
bool mirrorAllowsRemoval(const HalfEdgeMesh& m, const VertexStar& star)
{
	if (star.isClosed || !m.isOnMirror(star.vertex)) return true;
	const int  next = star.ring.front(), last = star.ring.back();
	const bool isNext = m.isOnMirror(next), isLast = m.isOnMirror(last);
	if (isNext == isLast) return true;
	return m.isOnMirror(isNext ? borderNeighbour(m, next, true) : borderNeighbour(m, last, false));
}

} // namespace

bool canRemoveVertex(const HalfEdgeMesh& m, const VertexStar& star, const HolePatch& patch,
					 EditScratch& scratch)
{
	const int n = star.placeNum();
	if (m.isCreaseVertex(star.vertex) || !mirrorAllowsRemoval(m, star)) return false;
	if (n < 3) {
		return !star.isClosed && patch.corner.empty() &&
			   !m.isCurveEdge(nextInFace(star.spoke[0])) && canLoseFace(m, star.ring[0]) &&
			   canLoseFace(m, star.ring[1]);
	}
	return isTriangulation(patch, n, scratch) && hasNewEdgesOnly(m, star, patch) &&
		   leavesEnoughFaces(m, star, patch, scratch);
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

PatchBackup::PatchBackup(const HalfEdgeMesh& m, const std::vector<int>& vertices) :
		PatchBackup(m, vertices, facesRound(m, vertices))
{
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

namespace {

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

/// Allocates room for exactly the vertices and faces of the mesh.
void reserveExactly(HalfEdgeMesh& m, bool withCreases)
{
	m.position.reset(m.vertexNum);
	m.outgoing.reset(m.vertexNum);
	m.origin.reset(m.halfEdgeNum());
	m.opposite.reset(m.halfEdgeNum());
	if (withCreases) m.crease.reset(m.halfEdgeNum());
}

} // namespace

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
	reserveExactly(to, m.hasCreases());
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
