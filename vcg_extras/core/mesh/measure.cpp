// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/face_quality.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gpr {

namespace {

constexpr double degrees = 180 / pi;

/// Disjoint sets with path halving for several threads at once (Anderson and Woll 1991). A root is
/// only put below a smaller root, by compare and swap; paths are shortened by any value farther up.
/// The resulting sets do not depend on the order.
class DisjointSets {
public:
	DisjointSets(std::size_t n, Workers& workers) : parent_(n)
	{
		workers.forRange(n, [&](std::size_t begin, std::size_t end) {
			std::iota(parent_.begin() + begin, parent_.begin() + end, int(begin));
		});
	}

	int find(int x)
	{
		for (;;) {
			const int up = load(x);
			if (up == x) return x;
			const int farther = load(up);
			__atomic_store_n(&parent_[x], farther, __ATOMIC_RELAXED);
			x = farther;
		}
	}
	void unite(int a, int b)
	{
		if (load(a) == load(b)) return; // the case of nearly all faces
		for (;;) {
			a = find(a);
			b = find(b);
			if (a == b) return;
			if (a < b) std::swap(a, b);
			int root = a;
			if (__atomic_compare_exchange_n(&parent_[a], &root, b, false, __ATOMIC_RELAXED,
											__ATOMIC_RELAXED))
				return;
		}
	}
	bool isRoot(int x) const { return parent_[x] == x; }

private:
	Buffer<int> parent_;

	int load(int x) const { return __atomic_load_n(&parent_[x], __ATOMIC_RELAXED); }
};

/// The number of connected sets of some edges: the loops of a border. Counted by joined vertices,
/// as a border vertex of a faulty mesh may have several border edges.
std::int64_t loopNum(const std::vector<EdgeSide>& border, std::size_t vertexNum, Workers& workers)
{
	DisjointSets sets(vertexNum, workers);
	workers.forEach(border.size(), [&](int i) { sets.unite(border[i].low, border[i].high); });
	std::vector<int> roots;
	for (const EdgeSide& edge : border)
		roots.push_back(sets.find(edge.low));
	sortUniqueBelow(int(vertexNum), roots);
	return std::int64_t(roots.size());
}

/// Joins the corners of each face in `sets`. Returns the edges of the border.
std::vector<EdgeSide> joinCorners(const HalfEdgeMesh& m, DisjointSets& sets, Workers& workers)
{
	return workers.collectEach<EdgeSide>(m.faceNum, [&](int f, std::vector<EdgeSide>& border) {
		const int* v = &m.origin[3 * f];
		sets.unite(v[0], v[1]);
		sets.unite(v[0], v[2]);
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			if (m.opposite[h] < 0) border.push_back(edgeSide(m.origin[h], m.target(h), h));
		}
	});
}

/// Fills components, boundaryLoops and eulerCharacteristic.
void measureTopology(const MeshView& mesh, MeshFigures& figures)
{
	Workers                workers(1, nullptr);
	const Buffer<EdgeSide> edges = sortedSides(mesh, workers);
	DisjointSets           faces(mesh.faceNum, workers);
	std::vector<char>      isUsed(mesh.vertexNum, 0);
	std::vector<EdgeSide>  border;
	std::int64_t           edgeNum = 0;
	forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin + 1; i < end; ++i)
			faces.unite(edges[begin].halfEdge / 3, edges[i].halfEdge / 3);
		++edgeNum;
		isUsed[edges[begin].low] = isUsed[edges[begin].high] = 1;
		if (end - begin == 1) border.push_back(edges[begin]);
	});
	for (std::size_t f = 0; f < mesh.faceNum; ++f)
		figures.components += faces.isRoot(int(f));
	figures.boundaryLoops       = loopNum(border, mesh.vertexNum, workers);
	const std::int64_t usedNum  = std::count(isUsed.begin(), isUsed.end(), 1);
	figures.eulerCharacteristic = usedNum - edgeNum + std::int64_t(mesh.faceNum);
}

/// Sums and extremes of the shape measures of some faces.
struct ShapeSums {
	double       radiusRatio = 0, radiusRatioMin = 1;
	double       aspectRatio = 0, aspectRatioMin = 1;
	double       minAngle = 0, minAngleMin = 4, maxAngle = 0;
	double       edgeLen = 0;
	std::int64_t below30 = 0;

	ShapeSums& operator+=(const ShapeSums& o)
	{
		radiusRatio += o.radiusRatio;
		radiusRatioMin = std::min(radiusRatioMin, o.radiusRatioMin);
		aspectRatio += o.aspectRatio;
		aspectRatioMin = std::min(aspectRatioMin, o.aspectRatioMin);
		minAngle += o.minAngle;
		minAngleMin = std::min(minAngleMin, o.minAngleMin);
		maxAngle    = std::max(maxAngle, o.maxAngle);
		edgeLen += o.edgeLen;
		below30 += o.below30;
		return *this;
	}
};

/// The shape measures of a face.
ShapeSums shapeOf(const MeshView& mesh, int f)
{
	const auto   t = mesh.triangle(f);
	const Vec3d  p = mesh.position(t[0]), q = mesh.position(t[1]), s = mesh.position(t[2]);
	ShapeSums    face;
	const double a = length(s - q), b = length(s - p), c = length(q - p);
	const double doubled = length(cross(q - p, s - p)); // twice the area
	const double longest = std::max({a, b, c});
	if (std::isfinite(longest)) face.edgeLen = (a + b + c) / 3;
	if (!(doubled > 0) || !std::isfinite(doubled)) {
		face.radiusRatioMin = face.aspectRatioMin = face.minAngleMin = 0;
		face.below30                                                 = 1;
		return face;
	}
	const double angles[3] = {portable::angle(doubled, dot(q - p, s - p)),
							  portable::angle(doubled, dot(p - q, s - q)),
							  portable::angle(doubled, dot(p - s, q - s))};
	// Inradius = doubled / (a + b + c), circumradius = a b c / (2 doubled).
	face.radiusRatio = face.radiusRatioMin = 4 * doubled * doubled / ((a + b + c) * a * b * c);
	face.aspectRatio = face.aspectRatioMin = 2 * std::sqrt(3.0) * doubled / ((a + b + c) * longest);
	face.minAngle = face.minAngleMin = std::min({angles[0], angles[1], angles[2]});
	face.maxAngle                    = std::max({angles[0], angles[1], angles[2]});
	face.below30                     = face.minAngle * degrees < 30;
	return face;
}

/// Share of inner vertices with six faces, in percent.
double valence6Percent(const MeshView& mesh)
{
	// The outer edges of a star name every neighbour of an inner vertex twice, as start and as end.
	// Signed sums of hashes cancel exactly there, and at a border almost surely not.
	std::vector<int>           faces(mesh.vertexNum, 0);
	std::vector<std::uint64_t> balance(mesh.vertexNum, 0);
	const auto hash = [](std::int32_t v) { return (std::uint64_t(v) + 1) * 0x9e3779b97f4a7c15ull; };
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		const auto t = mesh.triangle(f);
		for (int k = 0; k < 3; ++k) {
			++faces[t[k]];
			balance[t[k]] += hash(t[(k + 1) % 3]) - hash(t[(k + 2) % 3]);
		}
	}
	std::int64_t inner = 0, six = 0;
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		if (faces[v] == 0 || balance[v] != 0) continue;
		++inner;
		six += faces[v] == 6;
	}
	return inner > 0 ? 100.0 * double(six) / double(inner) : 0;
}

} // namespace

MeshFigures measureMesh(const MeshView& mesh)
{
	MeshFigures figures;
	figures.vertices = std::int64_t(mesh.vertexNum);
	figures.faces    = std::int64_t(mesh.faceNum);
	measureTopology(mesh, figures);
	Box<double> box;
	for (std::size_t i = 0; i < 3 * mesh.faceNum; ++i)
		if (isFinite(mesh.position(mesh.vertexOf(i)))) box.add(mesh.position(mesh.vertexOf(i)));
	figures.diagonal = box.diagonal();
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		const double area = 0.5 * length(mesh.faceCross(f));
		if (std::isfinite(area)) figures.area += area;
	}
	return figures;
}

std::vector<float> radiusRatios(const MeshView& mesh, Workers& workers)
{
	std::vector<float> ratios(mesh.faceNum, 0);
	workers.forEach(mesh.faceNum, [&](int f) {
		const double ratio = shapeOf(mesh, f).radiusRatio;
		if (std::isfinite(ratio)) ratios[f] = float(ratio);
	});
	return ratios;
}

QualityFigures measureQuality(const MeshView& mesh, int threads)
{
	Workers workers(threads, nullptr);
	return measureQuality(mesh, workers);
}

QualityFigures measureQuality(const MeshView& mesh, Workers& workers)
{
	QualityFigures q;
	if (mesh.faceNum == 0) return q;
	const ShapeSums sums = workers.sumEach<ShapeSums>(
		mesh.faceNum, [&](int f, ShapeSums& part) { part += shapeOf(mesh, f); });
	const double n    = double(mesh.faceNum);
	q.radiusRatioMean = sums.radiusRatio / n;
	q.radiusRatioMin  = sums.radiusRatioMin;
	q.aspectRatioMean = sums.aspectRatio / n;
	q.aspectRatioMin  = sums.aspectRatioMin;
	q.minAngleDeg     = sums.minAngleMin * degrees;
	q.meanMinAngleDeg = sums.minAngle / n * degrees;
	q.maxAngleDeg     = sums.maxAngle * degrees;
	q.below30Percent  = 100 * double(sums.below30) / n;
	q.meanEdgeLen     = sums.edgeLen / n;
	q.valence6Percent = valence6Percent(mesh);
	return q;
}

MeshFigures figuresOf(const HalfEdgeMesh& m, double unit, Workers& workers)
{
	DisjointSets                sets(m.vertexNum, workers);
	const std::vector<EdgeSide> border = joinCorners(m, sets, workers);
	const Box<double>           box =
		workers.sumEach<Box<double>>(m.vertexNum, [&](int v, Box<double>& part) {
			if (isFinite(m.position[v])) part.add(Vec3d(m.position[v]));
		});
	MeshFigures figures;
	figures.vertices   = m.vertexNum;
	figures.faces      = m.faceNum;
	figures.components = workers.sumEach<std::int64_t>(
		m.vertexNum, [&](int v, std::int64_t& roots) { roots += sets.isRoot(v); });
	figures.boundaryLoops       = loopNum(border, m.vertexNum, workers);
	const std::int64_t edges    = (std::int64_t(m.halfEdgeNum()) + std::int64_t(border.size())) / 2;
	figures.eulerCharacteristic = std::int64_t(m.vertexNum) - edges + m.faceNum;
	figures.area                = unit * unit * surfaceArea(m, workers);
	figures.diagonal            = unit * box.diagonal();
	return figures;
}

double borderLength(const HalfEdgeMesh& m, const Buffer<float>& size)
{
	const auto sizeAt = [&](int v) { return size.empty() ? 1.0 : double(size[v]); };
	double     sum    = 0;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		const int a = m.origin[h], b = m.target(h);
		if (m.isBorderEdge(h) && !(m.isOnMirror(a) && m.isOnMirror(b)))
			sum += 2 * double(length(m.position[b] - m.position[a])) / (sizeAt(a) + sizeAt(b));
	}
	return sum * m.sideNum();
}

std::int64_t lineFaceNum(const HalfEdgeMesh& m, Workers& workers)
{
	return workers.sumEach<std::int64_t>(m.faceNum,
										 [&](int f, std::int64_t& num) { num += hasNoArea(m, f); });
}

std::int64_t zeroAreaFaceNum(const HalfEdgeMesh& m, Workers& workers)
{
	return workers.sumEach<std::int64_t>(
		m.faceNum, [&](int f, std::int64_t& num) { num += hasZeroArea(m.faceCross(f)); });
}

} // namespace gpr
