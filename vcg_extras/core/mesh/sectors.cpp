// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sectors.h"

#include <vcg_extras/core/base/angle.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Calls visit(first, faceNum) for every sector of v: faceNum faces, counter-clockwise from the
/// face of half-edge `first`. The whole star is one sector if no feature line meets v.
template <class Visit>
void forEachSector(const HalfEdgeMesh& m, int v, const Visit& visit)
{
	int start = m.outgoing[v];
	if (!m.isBorderVertex(v)) {
		forEachOutgoing(m, v, [&](int h) {
			if (m.isCreaseEdge(h)) start = h;
		});
	}
	int first = start, num = 0, h = start;
	do {
		if (num > 0 && m.isCreaseEdge(h)) {
			visit(first, num);
			first = h;
			num   = 0;
		}
		++num;
		h = m.opposite[prevInFace(h)];
	} while (h >= 0 && h != start);
	visit(first, num);
}

/// Calls visit(h) for the half-edges of a sector.
template <class Visit>
void forEachInSector(const HalfEdgeMesh& m, int first, int faceNum, const Visit& visit)
{
	int h = first;
	for (int i = 0; i < faceNum; ++i) {
		visit(h);
		h = m.opposite[prevInFace(h)];
	}
}

Vec3f crossAt(const HalfEdgeMesh& m, int h)
{
	const Vec3f p = m.position[m.origin[h]];
	return cross(m.position[m.target(h)] - p, m.position[m.apex(h)] - p);
}

bool isFlatSector(const HalfEdgeMesh& m, int first, int faceNum)
{
	Vec3f sum;
	forEachInSector(m, first, faceNum, [&](int h) { sum += crossAt(m, h); });
	const float limit = flatCosine * flatCosine * squaredLength(sum);
	bool        flat  = squaredLength(sum) > 0;
	forEachInSector(m, first, faceNum, [&](int h) {
		const Vec3f n = crossAt(m, h);
		const float d = dot(n, sum);
		flat          = flat && d > 0 && d * d >= limit * squaredLength(n);
	});
	return flat;
}

/// isFlatSector for the whole star, which is read once unless it is very large.
bool isFlatRing(const HalfEdgeMesh& m, int v)
{
	constexpr int maxKept = 12; // nearly all vertices have fewer faces; larger stars are read twice
	Float4        kept[maxKept];
	Float4        sum;
	int           num = 0;
	forEachFaceRound(m, v, [&](int, const Float4& a, const Float4& b) {
		const Float4 n = cross(a, b);
		if (num < maxKept) kept[num] = n;
		++num;
		sum += n;
	});
	if (num > maxKept) return isFlatSector(m, m.outgoing[v], num);
	const float limit = flatCosine * flatCosine * dot(sum, sum);
	bool        flat  = dot(sum, sum) > 0;
	for (int i = 0; i < num; ++i) {
		const float d = dot(kept[i], sum);
		flat          = flat && d > 0 && d * d >= limit * dot(kept[i], kept[i]);
	}
	return flat;
}

int wantedFaces(const HalfEdgeMesh& m, int first, int faceNum)
{
	float angle = 0;
	forEachInSector(m, first, faceNum, [&](int h) {
		const Vec3f a = m.edgeVector(h);
		const Vec3f b = m.position[m.apex(h)] - m.position[m.origin[h]];
		angle += angleBetween(a, b);
	});
	return std::max(1, int(std::lround(angle / (60 * radians))));
}

} // namespace

int correctedValence(const HalfEdgeMesh& m, int v)
{
	if (m.outgoing[v] < 0) return 6;
	if (!m.isCurveVertex(v)) return m.valence(v);
	int n = 6;
	forEachSector(m, v,
				  [&](int first, int faceNum) { n += faceNum - wantedFaces(m, first, faceNum); });
	return n;
}

bool isFlat(const HalfEdgeMesh& m, int v)
{
	if (!m.isCreaseVertex(v)) return isFlatRing(m, v);
	bool flat = true;
	forEachSector(m, v,
				  [&](int first, int faceNum) { flat = flat && isFlatSector(m, first, faceNum); });
	return flat;
}

Buffer<char> findFlatVertices(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<char> flat(m.vertexNum);
	workers.forEach(flat.size(), [&](int v) { flat[v] = isFlat(m, v); });
	return flat;
}

Buffer<int> correctedValences(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<int> valence(m.vertexNum);
	workers.forEach(valence.size(), [&](int v) { valence[v] = correctedValence(m, v); });
	return valence;
}

int flipEnergy(const HalfEdgeMesh& m, const Buffer<int>& valence, int h)
{
	// A face less changes the energy by (n - 1 - 6)² - (n - 6)² = 13 - 2n, a face more by 2n - 11.
	const int losing  = valence[m.origin[h]] + valence[m.target(h)];
	const int gaining = valence[m.apex(h)] + valence[m.apex(m.opposite[h])];
	return 26 - 2 * losing + 2 * gaining - 22;
}

} // namespace gpr
